// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AgglomerationRules.h"

#include "NumberText.h"
#include "RuleFunctions.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace pemesh
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

constexpr Parameter DiameterParameters[] = {
  { "max-diameter",
    "largest diameter of a merged element [length]; 0: the smallest placed polygon's", 0.0, 0.0,
    Infinity },
};
constexpr Parameter RandomParameters[] = {
  { "seed", "another number, another choice of neighbours", 1.0, 0.0, 0x1p53, true },
};
constexpr Parameter MetisParameters[] = {
  { "seed", "of the random choices of METIS", 1.0, 0.0, 2147483647.0, true },
};
constexpr Parameter RegularParameters[] = {
  { "elements-per-block", "elements merged into one, where no target is set", 10.0, 1.0,
    2147483647.0 },
};

constexpr const char* Cabiddu =
  "D. Cabiddu, G. Patane, M. Spagnuolo, A graphical framework to study the correlation between "
  "geometric design and simulation, arXiv 2102.11578 (2021)";
constexpr const char* Sorgente2024 =
  "T. Sorgente, S. Berrone, S. Biasotti, G. Manzini, M. Spagnuolo, F. Vicini, Mesh optimization "
  "for the virtual element method: how small can an agglomerated mesh become?, arXiv:2404.11484 "
  "(2024)";
constexpr const char* Karypis1998 =
  "G. Karypis, V. Kumar, Multilevel k-way partitioning scheme for irregular graphs, Journal of "
  "Parallel and Distributed Computing 48 (1998) 96-129, doi:10.1006/jpdc.1997.1404";
constexpr const char* Hilbert1891 =
  "D. Hilbert, Ueber die stetige Abbildung einer Linie auf ein Flaechenstueck, Mathematische "
  "Annalen 38 (1891) 459-460, doi:10.1007/BF01199431";

constexpr AgglomerationRule Rules[] = {
  { "diameter", "Up to a diameter",
    "Neighbours merge while the diameter of their union does not exceed that of the smallest "
    "placed polygon, or one that is given: the smallest elements first, each with the neighbour "
    "that makes the union of the smallest diameter.",
    Cabiddu, RuleMetric::None, "", 0.0, DiameterParameters, &MergeByDiameter },
  { "random", "At random",
    "An element chosen at random merges with a neighbour chosen at random, again and again.", "",
    RuleMetric::None, "", 20.0, RandomParameters, &MergeAtRandom },
  { "quality", "Worst shape first",
    "The element that is worst by a metric merges with the neighbour that makes the best union.",
    Sorgente2024, RuleMetric::WorstFirst, "ShapeRegularity", 20.0, {}, &MergeByQuality },
  { "metis", "Parts of equal weight",
    "Parts with few sides between them, made by METIS from the graph of neighbours; they hold "
    "about the same number of elements, or the same sum of a metric.",
    Karypis1998, RuleMetric::Weight, "", 20.0, MetisParameters, &MergeByMetis },
  { "regular", "Blocks along a curve",
    "Blocks of as many elements each, in the order in which a Hilbert curve meets their centroids.",
    Hilbert1891, RuleMetric::None, "", 0.0, RegularParameters, &MergeByCurve },
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
