// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AgglomerationRules.h"

#include "NumberText.h"
#include "RuleFunctions.h"

#include <algorithm>
#include <vector>

namespace pemesh
{

namespace
{

constexpr Parameter RandomParameters[] = {
  { "seed", "another number, another choice of neighbours", 1.0, 0.0, 0x1p53, true },
};

constexpr AgglomerationRule Rules[] = {
  { "random", "At random",
    "An element chosen at random merges with a neighbour chosen at random, again and again.", "",
    RuleMetric::None, 20.0, RandomParameters, &MergeAtRandom },
};

} // namespace

std::span<const AgglomerationRule> AgglomerationRules()
{
  return Rules;
}

const AgglomerationRule* FindAgglomerationRule(std::string_view name)
{
  const auto found = std::find_if(std::begin(Rules), std::end(Rules),
    [name](const AgglomerationRule& rule) { return rule.Name == name; });
  return found == std::end(Rules) ? nullptr : &*found;
}

std::string DescribeUnknownAgglomerationRule(std::string_view name)
{
  std::vector<std::string> names;
  for (const AgglomerationRule& rule : Rules)
  {
    names.emplace_back(rule.Name);
  }
  return "There is no agglomeration rule \"" + std::string(name) + "\"; did you mean \"" +
    std::string(NearestWord(std::string(name), names)) + "\"?";
}

} // namespace pemesh
