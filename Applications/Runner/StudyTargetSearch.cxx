// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyTargetSearch.h"

#include "CaseStatus.h"
#include "CountSearch.h"
#include "ElementAccess.h"
#include "MeshConversion.h"
#include "NumberText.h"
#include "Study.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
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

/**
 * Notices where merging leaves the same number however fine the mesh is: the search would refine it
 * until memory ends.
 */
class MergingWatch
{
public:
  /** Whether four times as many elements before merging gave hardly more. */
  bool IsInVain(vtkPolyData* mesh, double count)
  {
    const double elements = GetFieldNumber(mesh, "ElementsBefore"); // NaN without merging
    const bool isFiner = elements >= 4.0 * this->Elements;
    const bool isInVain =
      isFiner && std::log(count / this->Count) < 0.1 * std::log(elements / this->Elements);
    this->Sentence = "merging leaves " + FormatNumber(count) + " where there are " +
      FormatNumber(elements) + " elements, and " + FormatNumber(this->Count) + " where there are " +
      FormatNumber(this->Elements) + ". Change mesh.agglomerate or mesh.target.value.";
    if (isFiner || !(elements >= this->Elements))
    {
      this->Elements = elements;
      this->Count = count;
    }
    return isInVain;
  }
  const std::string& GetSentence() const { return this->Sentence; }

private:
  double Elements = std::nan("");
  double Count = 0.0;
  std::string Sentence;
};

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
  const std::string wanted = "The mesh cannot have " + std::to_string(target.Value) + " " +
    target.Quantity + " within 2 %; ";
  CountSearch search(target.Value, TargetTolerance, area / target.Value, area);
  MergingWatch merging;
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
    const double count = std::max(CountOfTarget(mesh, target), 1.0);
    search.Report(count);
    if (merging.IsInVain(mesh, count) && search.IsSearching() && count < target.Value)
    {
      return wanted + merging.GetSentence();
    }
  }
  if (made != search.GetBound())
  {
    makeMesh(search.GetBound());
  }
  return search.IsReached() ? std::string()
                            : wanted + (search.IsTargetTooSmall() ? "the least" : "the nearest") +
      " is " + FormatNumber(search.GetNearestCount()) + ". Choose that as mesh.target.value.";
}

} // namespace pemesh
