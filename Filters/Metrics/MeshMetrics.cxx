// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshMetrics.h"

#include "CompensatedSum.h"
#include "MeshSurroundings.h"
#include "MetricTables.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pemesh
{

namespace
{

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

struct ValueRange
{
  double Smallest = NotANumber;
  double Largest = NotANumber;
};

ValueRange RangeOf(std::span<const double> values)
{
  ValueRange range;
  for (const double given : values)
  {
    const double value = std::isfinite(given) ? given : NotANumber; // as in a summary
    range.Smallest = value < range.Smallest || std::isnan(range.Smallest) ? value : range.Smallest;
    range.Largest = value > range.Largest || std::isnan(range.Largest) ? value : range.Largest;
  }
  return range;
}

/** Over the defined values; their number is put into `count`. */
template <typename Map>
double SumOf(std::span<const double> values, vtkIdType& count, const Map& map)
{
  CompensatedSum sum;
  count = 0;
  for (const double value : values)
  {
    if (std::isfinite(value))
    {
      sum.Add(map(value));
      ++count;
    }
  }
  return count > 0 ? sum.Get() : NotANumber;
}

double MeshRho(const MeshMeasures& mesh)
{
  vtkIdType count = 0;
  const double sum = SumOf(mesh.Base, count, [](double value) { return value * value; });
  return std::sqrt(sum / static_cast<double>(count));
}

double TotalArea(const MeshMeasures& mesh)
{
  vtkIdType count = 0;
  return SumOf(mesh.Base, count, [](double value) { return value; });
}

constexpr MeshMetric Table[] = {
  { .Name = "Elements",
    .Label = "Number of elements",
    .Formula = "N",
    .Tex = "N",
    .Description = "Number of elements.",
    .IsCount = true,
    .Function = [](const MeshMeasures& mesh) { return static_cast<double>(mesh.Elements); } },
  { .Name = "Vertices",
    .Label = "Number of vertices",
    .Formula = "number of points",
    .Tex = "|V|",
    .Description = "Number of points.",
    .IsCount = true,
    .Function = [](const MeshMeasures& mesh) { return static_cast<double>(mesh.Vertices); } },
  { .Name = "Edges",
    .Label = "Number of edges",
    .Formula = "number of edges",
    .Tex = "|E|",
    .Description = "Number of edges; one of two elements counts once.",
    .NeedsNeighbours = true,
    .Function = [](const MeshMeasures& mesh)
    { return mesh.Neighbours ? static_cast<double>(mesh.Neighbours->CountEdges()) : NotANumber; } },
  { .Name = "Triangles",
    .Label = "Number of triangles",
    .Formula = "elements of three vertices",
    .Tex = R"(|\{E : n = 3\}|)",
    .Description = "Number of elements of three vertices.",
    .IsCount = true,
    .Function = [](const MeshMeasures& mesh) { return static_cast<double>(mesh.Triangles); } },
  { .Name = "Polygons",
    .Label = "Number of polygons",
    .Formula = "elements of more than three vertices",
    .Tex = R"(|\{E : n > 3\}|)",
    .Description = "Number of elements of more than three vertices.",
    .IsCount = true,
    .Function = [](const MeshMeasures& mesh)
    { return static_cast<double>(mesh.Elements - mesh.Triangles); } },
  { .Name = "MeshSize",
    .Label = "Mesh size h",
    .Formula = "max h",
    .Tex = R"(\max_E h_E)",
    .Description = "Largest diameter of an element.",
    .Unit = "length",
    .Base = "Diameter",
    .Function = [](const MeshMeasures& mesh) { return RangeOf(mesh.Base).Largest; } },
  { .Name = "MeshRho",
    .Label = "Mesh quality rho",
    .Formula = "sqrt(1/N sum rho_1 (rho_2 + rho_3 + rho_4) / 3)",
    .Tex = R"(\sqrt{\frac{1}{N} \sum_E \frac{\varrho_1 (\varrho_2 + \varrho_3 + \varrho_4)}{3}})",
    .Description = "Quality of a mesh for the virtual element method: the root of the mean square "
                   "of VEMIndicator.",
    .Good = 1,
    .Reference = Sorgente2022,
    .Base = "VEMIndicator",
    .Function = MeshRho },
  { .Name = "MinAreaRatio",
    .Label = "Smallest over largest area",
    .Formula = "min A / max A",
    .Tex = R"(\frac{\min_E A_E}{\max_E A_E})",
    .Description = "Smallest over largest area of an element.",
    .Good = 1,
    .Base = "Area",
    .Function =
      [](const MeshMeasures& mesh)
    {
      const ValueRange range = RangeOf(mesh.Base);
      return range.Smallest / range.Largest;
    } },
  { .Name = "TotalArea",
    .Label = "Total area",
    .Formula = "sum A",
    .Tex = R"(\sum_E A_E)",
    .Description = "Sum of the areas of the elements.",
    .Unit = "length^2",
    .Base = "Area",
    .Function = TotalArea },
  { .Name = "BoundaryLength",
    .Label = "Length of the boundary",
    .Formula = "length of all edges of one element",
    .Tex = R"(|\partial \Omega|)",
    .Description = "Length of the edges that belong to one element.",
    .Unit = "length",
    .NeedsNeighbours = true,
    .Function = [](const MeshMeasures& mesh)
    { return mesh.Neighbours ? mesh.Neighbours->GetBoundaryLength() : NotANumber; } },
  { .Name = "UndefinedElements",
    .Label = "Number of undefined elements",
    .Formula = "elements with NaN",
    .Tex = R"(|\{E : \text{a metric is undefined}\}|)",
    .Description = "Number of elements for which a metric of the summary is undefined.",
    .Good = -1,
    .IsCount = true,
    .Function = [](const MeshMeasures& mesh) { return static_cast<double>(mesh.Undefined); } },
};

} // namespace

std::span<const MeshMetric> MeshMetrics()
{
  return Table;
}

const MeshMetric* FindMeshMetric(std::string_view name)
{
  const auto found =
    std::ranges::find_if(Table, [name](const MeshMetric& metric) { return name == metric.Name; });
  return found == std::end(Table) ? nullptr : &*found;
}

std::vector<std::string> MeshMetricNames()
{
  std::vector<std::string> names;
  for (const MeshMetric& metric : Table)
  {
    names.emplace_back(metric.Name);
  }
  return names;
}

} // namespace pemesh
