// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyTargetSearch.h"

#include "CountSearch.h"
#include "ElementAccess.h"
#include "MeshConversion.h"
#include "NumberText.h"
#include "Study.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <vector>

namespace pemesh
{

namespace
{

double CountDegreesOfFreedom(vtkPolyData* input, double order)
{
  const PolygonMesh mesh = ToPolygonMesh(input);
  const MeshAdjacency adjacency = FindAdjacency(mesh);
  std::vector<bool> isBorder(mesh.Points.size(), false);
  double innerSides = 0.0; // two an edge
  for (int side = 0; side < mesh.NumberOfSides(); ++side)
  {
    if (adjacency.Twin[side] >= 0)
    {
      innerSides += 1.0;
      continue;
    }
    isBorder[mesh.Vertices[side]] = true;
    isBorder[mesh.Vertices[NextSide(mesh, adjacency.Element[side], side)]] = true;
  }
  const auto vertices = static_cast<double>(std::count(isBorder.begin(), isBorder.end(), false));
  return vertices + (order - 1.0) * innerSides / 2.0 +
    order * (order - 1.0) / 2.0 * mesh.NumberOfElements();
}

} // namespace

double CountOfTarget(vtkPolyData* mesh, const StudyTarget& target)
{
  if (target.Quantity == "dofs")
  {
    return ElementAccess::WhyUnusable(mesh).empty() ? CountDegreesOfFreedom(mesh, target.Order)
                                                    : 0.0;
  }
  return static_cast<double>(
    target.Quantity == "elements" ? mesh->GetNumberOfPolys() : mesh->GetNumberOfPoints());
}

std::string SearchTarget(
  const StudyTarget& target, double area, const std::function<vtkPolyData*(double)>& makeMesh)
{
  CountSearch search(target.Value, TargetTolerance, area / target.Value, area);
  double made = 0.0; // the bound of the last mesh
  while (search.IsSearching())
  {
    made = search.GetBound();
    vtkPolyData* mesh = makeMesh(made);
    if (!mesh)
    {
      return {};
    }
    // A mesh without unknowns is far below every target, but the search goes by ratios.
    search.Report(std::max(CountOfTarget(mesh, target), 1.0));
  }
  if (made != search.GetBound())
  {
    makeMesh(search.GetBound());
  }
  return search.IsReached()
    ? std::string()
    : "The mesh cannot have " + std::to_string(target.Value) + " " + target.Quantity +
      " within 2 %; " + (search.IsTargetTooSmall() ? "the least" : "the nearest") + " is " +
      FormatNumber(search.GetNearestCount()) + ". Choose that as mesh.target.value.";
}

} // namespace pemesh
