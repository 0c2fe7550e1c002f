// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Choices by name: of metrics, numbers of a mesh, statistics and groups of elements. Filters,
 * studies and commands check and complete names here, and nowhere else.
 */
#ifndef pemesh_MetricSelection_h
#define pemesh_MetricSelection_h

#include "MetricRegistry.h"
#include "pemeshFiltersMetricsModule.h" // For export macro

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pemesh
{

/** The names that may be said where something is chosen. */
struct PEMESHFILTERSMETRICS_EXPORT NameChoices
{
  std::string What;               ///< "metric"
  std::vector<std::string> Known; ///< names, aliases, and words that stand for several
  /** Other things people write for them (symbols): a hint for messages, never accepted. */
  std::vector<std::pair<std::string, std::string>> Hints;

  bool Has(std::string_view name) const;
  /** The known name that is nearest, upper and lower case aside. */
  std::string Nearest(std::string_view name) const;
  /** Empty if all names are known, else one sentence about the first that is not. */
  std::string WhyUnknown(const std::vector<std::string>& names) const;
};

///@{
/** The names and aliases of all metrics. */
PEMESHFILTERSMETRICS_EXPORT const NameChoices& MetricNameChoices();
/** What may be chosen; of metrics also "all", "jumps", …, of numbers of a mesh "usual", "all". */
PEMESHFILTERSMETRICS_EXPORT const NameChoices& MetricChoices();
PEMESHFILTERSMETRICS_EXPORT const NameChoices& MeshMetricChoices();
PEMESHFILTERSMETRICS_EXPORT const NameChoices& StatisticChoices();
PEMESHFILTERSMETRICS_EXPORT const NameChoices& ElementGroupChoices();
///@}

/** The metrics named, also by alias or collection, each once, in the order of the registry. */
PEMESHFILTERSMETRICS_EXPORT std::vector<const Metric*> SelectMetrics(
  const std::vector<std::string>& names);

/**
 * The numbers of a mesh named, each once, in the order given. "all" stands for all of them, "usual"
 * for those that cost next to nothing and those made of one of `metrics`.
 */
PEMESHFILTERSMETRICS_EXPORT std::vector<std::string> SelectMeshMetrics(
  const std::vector<std::string>& names, const std::vector<std::string>& metrics);

/** What came of new names for a list of a filter. */
struct NamesTaken
{
  bool IsChange = false;
  std::string Fault; ///< one sentence; the list is as it was
};

/** Puts the metrics named into `own`, in the order of the registry. */
PEMESHFILTERSMETRICS_EXPORT NamesTaken TakeMetricNames(
  std::vector<std::string>& own, const std::vector<std::string>& names);

/** Puts names into `own`, each once, in the order given. */
PEMESHFILTERSMETRICS_EXPORT NamesTaken TakeNames(
  std::vector<std::string>& own, const std::vector<std::string>& names, const NameChoices& choices);

} // namespace pemesh

#endif
