// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The rules that say which elements are merged, one table (AgglomerationRules.cxx).
 *
 * Filter, study document, command line and documentation read this table; adding a rule is adding
 * an entry.
 */
#ifndef pemesh_AgglomerationRules_h
#define pemesh_AgglomerationRules_h

#include "Parameter.h"
#include "pemeshFiltersAgglomerationModule.h" // For export macro

#include <span>
#include <string>
#include <string_view>

namespace pemesh
{

struct AgglomerationState;

/** What a rule does with a metric of the registry. */
enum class RuleMetric
{
  None,      ///< it has no use for one
  Weight,    ///< optional: every group is to hold the same sum of it
  WorstFirst ///< required: the worst element is merged first; needs to know which end is good
};

struct AgglomerationRule
{
  const char* Name;        ///< "quality": the key of studies and of SetRuleByName
  const char* Label;       ///< for people
  const char* Description; ///< one or two sentences
  const char* Reference;
  RuleMetric Metric;
  const char* DefaultMetric; ///< empty for none
  double DefaultPercentage; ///< of the input elements, where no target is set; 0: as far as it goes
  std::span<const Parameter> Parameters;

  /** Merges; false if it was stopped. Puts a sentence into the state where it cannot work. */
  bool (*Apply)(AgglomerationState& state);
};

/** All rules, in the order of lists. */
PEMESHFILTERSAGGLOMERATION_EXPORT std::span<const AgglomerationRule> AgglomerationRules();

/** By its name; null if there is none. */
PEMESHFILTERSAGGLOMERATION_EXPORT const AgglomerationRule* FindAgglomerationRule(
  std::string_view name);

/** One sentence for a name that is not in the table, which tells the nearest one that is. */
PEMESHFILTERSAGGLOMERATION_EXPORT std::string DescribeUnknownAgglomerationRule(
  std::string_view name);

} // namespace pemesh

#endif
