// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Statistics of the values of a metric, and the groups of elements they are taken over: one entry
 * of one table each.
 */
#ifndef pemesh_ValueStatistics_h
#define pemesh_ValueStatistics_h

#include "pemeshFiltersMetricsModule.h" // For export macro

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <vtkType.h> // For vtkIdType

class vtkPolyData;

namespace pemesh
{

/** Of the finite values of a group; NaN, and -1 for elements, where there are none. */
struct ValueSummary
{
  vtkIdType Count;
  vtkIdType Undefined; ///< values that are not finite
  double Minimum;
  double Maximum;
  double Mean;
  double StandardDeviation; ///< of these values as a whole (divided by their number)
  double AreaMean;          ///< mean with the areas of the elements as weights
  vtkIdType MinimumElement; ///< the first that attains it
  vtkIdType MaximumElement;
};

struct Statistic
{
  const char* Name;   // "standard-deviation"
  const char* Suffix; // of the column: "deviation"
  const char* Label;  // before the name of a metric: "standard deviation of"
  const char* Description;
  bool IsCount;     // a number of elements, whatever the unit of the metric
  bool NeedsSpread; // standard deviation and weighted mean, which need a second pass
  double (*Function)(const ValueSummary&);
  /** The element that attains it, for a column `<Suffix>_element`; null if there is no such. */
  vtkIdType (*Element)(const ValueSummary&);
};

PEMESHFILTERSMETRICS_EXPORT std::span<const Statistic> Statistics();
PEMESHFILTERSMETRICS_EXPORT const Statistic* FindStatistic(std::string_view name);
PEMESHFILTERSMETRICS_EXPORT const Statistic* FindStatisticBySuffix(std::string_view suffix);

/** Which elements a statistic is taken over. */
struct ElementGroup
{
  const char* Name;   // "placed"
  const char* Suffix; // of the column: "_placed"; empty for all elements
  const char* Label;  // behind the name of a metric: "placed polygons"; empty for all elements
  const char* Description;
  bool (*Contains)(int vertices, int polygon, bool selected);
};

PEMESHFILTERSMETRICS_EXPORT std::span<const ElementGroup> ElementGroups();
PEMESHFILTERSMETRICS_EXPORT const ElementGroup* FindElementGroup(std::string_view name);

/**
 * Whether each element of a mesh is in a group. `selected` says which ones the group "selected"
 * has: empty for none, or one entry an element.
 */
PEMESHFILTERSMETRICS_EXPORT std::vector<unsigned char> FindMembers(
  vtkPolyData* mesh, const ElementGroup& group, std::span<const unsigned char> selected);

/**
 * The summary of the values of the members; empty `members` for all. With `spread` the second pass
 * is made; without `areas` the weighted mean is NaN.
 */
PEMESHFILTERSMETRICS_EXPORT ValueSummary SummarizeValues(std::span<const double> values,
  std::span<const unsigned char> members, std::span<const double> areas, bool spread);

/** The finite values of the members, sorted. */
PEMESHFILTERSMETRICS_EXPORT std::vector<double> SortValues(
  std::span<const double> values, std::span<const unsigned char> members);

/**
 * The value below which `fraction` of sorted values lie, linear between them (definition 7 of R. J.
 * Hyndman, Y. Fan, Sample quantiles in statistical packages, Am. Stat. 50 (1996) 361-365).
 */
PEMESHFILTERSMETRICS_EXPORT double Quantile(std::span<const double> sorted, double fraction);

/** Bound on the bins of a histogram, to tell a slip from a wish. */
inline constexpr int MostHistogramBins = 10000;

/** How many sorted values are in each of equal parts of their range; the last includes its end. */
PEMESHFILTERSMETRICS_EXPORT std::vector<vtkIdType> Histogram(
  std::span<const double> sorted, int bins);

} // namespace pemesh

#endif
