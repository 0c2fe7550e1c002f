// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Numbers of a whole mesh: one entry of one table each (MeshMetrics.cxx), one column of a summary.
 */
#ifndef pemesh_MeshMetrics_h
#define pemesh_MeshMetrics_h

#include "pemeshFiltersMetricsModule.h" // For export macro

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <vtkType.h> // For vtkIdType

namespace pemesh
{

class MeshNeighbours;

/** What they are computed from. */
struct MeshMeasures
{
  vtkIdType Elements = 0;
  vtkIdType Vertices = 0;
  vtkIdType Triangles = 0;
  vtkIdType Undefined = 0;      ///< elements with an undefined value of a chosen metric
  std::span<const double> Base; ///< the base metric of each element, NaN where undefined
  const MeshNeighbours* Neighbours = nullptr; ///< null if not needed, or not to be had
};

struct MeshMetric
{
  const char* Name = "";
  const char* Label = "";
  const char* Formula = "";
  const char* Tex = "";
  const char* Description = "";
  int Good = 0;
  const char* Unit = "1";
  const char* Reference = "";
  const char* Base = ""; // the metric of elements it is made of, or empty
  bool NeedsNeighbours = false;
  bool IsCount = false;                              // always a whole number, never undefined
  double (*Function)(const MeshMeasures&) = nullptr; // NaN where undefined
};

/** All, in the order of columns. */
PEMESHFILTERSMETRICS_EXPORT std::span<const MeshMetric> MeshMetrics();

/** By its name; null if there is none. */
PEMESHFILTERSMETRICS_EXPORT const MeshMetric* FindMeshMetric(std::string_view name);

PEMESHFILTERSMETRICS_EXPORT std::vector<std::string> MeshMetricNames();

} // namespace pemesh

#endif
