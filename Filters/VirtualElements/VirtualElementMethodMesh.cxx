// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "VirtualElementMethodMesh.h"

#include "ElementAccess.h"
#include "PolygonMeasures.h"
#include "VirtualElementMethodElement.h"

#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace pemesh
{

namespace
{

// One use of an edge by an element, kept in the list of the edge's lower end.
struct EdgeUse
{
  vtkIdType Higher;
  vtkIdType Element;
  vtkIdType Corner; // of the element, where the edge starts
  bool Forward;     // from the lower end to the higher
};

void CopyPoints(vtkPolyData* data, VirtualElementMesh& mesh)
{
  mesh.Points.resize(data->GetNumberOfPoints());
  for (vtkIdType id = 0; id < mesh.NumberOfPoints(); ++id)
  {
    double point[3];
    data->GetPoints()->GetPoint(id, point);
    if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
    {
      throw std::runtime_error(
        "Vertex " + std::to_string(id) + " of the mesh has a coordinate that is not a number.");
    }
    mesh.Points[id] = { point[0], point[1] };
  }
}

void CopyElements(vtkPolyData* data, VirtualElementMesh& mesh)
{
  ElementAccess access(data);
  const vtkIdType elements = access.GetNumberOfElements();
  mesh.Offsets.reserve(elements + 1);
  mesh.Offsets.push_back(0);
  std::vector<vtkIdType> ids;
  for (vtkIdType element = 0; element < elements; ++element)
  {
    access.GetVertexIds(element, ids);
    mesh.Corners.insert(mesh.Corners.end(), ids.begin(), ids.end());
    mesh.Offsets.push_back(static_cast<vtkIdType>(mesh.Corners.size()));
  }
}

void CheckElements(const VirtualElementMesh& mesh)
{
  std::vector<vtkIdType> sorted;
  std::vector<Point2> vertices;
  for (vtkIdType element = 0; element < mesh.NumberOfElements(); ++element)
  {
    const auto ids = mesh.Element(element);
    sorted.assign(ids.begin(), ids.end());
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end())
    {
      throw std::runtime_error("Element " + std::to_string(element) + " uses vertex " +
        std::to_string(*twice) + " more than once.");
    }
    mesh.GetVertices(element, vertices);
    if (!(SignedArea(vertices) > 0.0))
    {
      throw std::runtime_error("Element " + std::to_string(element) +
        " has no positive area: elements must be counter-clockwise and not flat.");
    }
  }
}

void FindUses(VirtualElementMesh& mesh)
{
  mesh.FirstUse.assign(mesh.Points.size() + 1, 0);
  for (const vtkIdType id : mesh.Corners)
  {
    ++mesh.FirstUse[id + 1];
  }
  for (std::size_t i = 1; i < mesh.FirstUse.size(); ++i)
  {
    mesh.FirstUse[i] += mesh.FirstUse[i - 1];
  }
  mesh.UseElement.resize(mesh.Corners.size());
  mesh.UsePlace.resize(mesh.Corners.size());
  std::vector<vtkIdType> next(mesh.FirstUse.begin(), mesh.FirstUse.end() - 1);
  for (vtkIdType element = 0; element < mesh.NumberOfElements(); ++element)
  {
    const auto ids = mesh.Element(element);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      const vtkIdType slot = next[ids[i]]++;
      mesh.UseElement[slot] = element;
      mesh.UsePlace[slot] = static_cast<vtkIdType>(i);
    }
  }
  mesh.Used.resize(mesh.Points.size());
  for (vtkIdType id = 0; id < mesh.NumberOfPoints(); ++id)
  {
    mesh.Used[id] = mesh.FirstUse[id + 1] > mesh.FirstUse[id];
  }
}

[[noreturn]] void ThrowBadEdge(vtkIdType lower, const std::vector<EdgeUse>& uses)
{
  std::string message = "The edge between the vertices " + std::to_string(lower) + " and " +
    std::to_string(uses.front().Higher) + " belongs to the elements";
  for (std::size_t i = 0; i < uses.size(); ++i)
  {
    message +=
      (i ? (i + 1 == uses.size() ? " and " : ", ") : " ") + std::to_string(uses[i].Element);
  }
  throw std::runtime_error(message + ", which therefore overlap.");
}

// Numbers the edges from `lower` and marks the ends of those that one element has; `uses` are all
// of them.
void NumberEdges(vtkIdType lower, std::vector<EdgeUse>& uses, VirtualElementMesh& mesh)
{
  std::stable_sort(uses.begin(), uses.end(),
    [](const EdgeUse& a, const EdgeUse& b) { return a.Higher < b.Higher; });
  for (std::size_t first = 0; first < uses.size();)
  {
    std::size_t last = first;
    while (last < uses.size() && uses[last].Higher == uses[first].Higher)
    {
      ++last;
    }
    if (last - first > 2 || (last - first == 2 && uses[first].Forward == uses[first + 1].Forward))
    {
      ThrowBadEdge(lower, { uses.begin() + first, uses.begin() + last });
    }
    for (std::size_t use = first; use < last; ++use)
    {
      mesh.EdgeOf[uses[use].Corner] = mesh.NumberOfEdges();
    }
    mesh.EdgeOnBoundary.push_back(last - first == 1);
    if (last - first == 1)
    {
      mesh.OnBoundary[lower] = 1;
      mesh.OnBoundary[uses[first].Higher] = 1;
    }
    first = last;
  }
}

// There always is a boundary: without one, the areas of the elements, all positive, would add up to
// zero. So the problem always has one solution. Each point looks at the edges to points of higher
// id, through the elements around it.
void FindBoundary(VirtualElementMesh& mesh)
{
  mesh.OnBoundary.assign(mesh.Points.size(), 0);
  mesh.EdgeOf.resize(mesh.Corners.size());
  mesh.EdgeOnBoundary.clear();
  std::vector<EdgeUse> uses;
  for (vtkIdType id = 0; id < mesh.NumberOfPoints(); ++id)
  {
    uses.clear();
    for (vtkIdType use = mesh.FirstUse[id]; use < mesh.FirstUse[id + 1]; ++use)
    {
      const vtkIdType element = mesh.UseElement[use];
      const auto ids = mesh.Element(element);
      const std::size_t place = static_cast<std::size_t>(mesh.UsePlace[use]);
      const std::size_t before = (place + ids.size() - 1) % ids.size();
      const vtkIdType next = ids[(place + 1) % ids.size()];
      const vtkIdType previous = ids[before];
      const vtkIdType first = mesh.Offsets[element];
      if (next > id)
      {
        uses.push_back({ next, element, first + static_cast<vtkIdType>(place), true });
      }
      if (previous > id)
      {
        uses.push_back({ previous, element, first + static_cast<vtkIdType>(before), false });
      }
    }
    NumberEdges(id, uses, mesh);
  }
}

} // namespace

void VirtualElementMesh::GetVertices(vtkIdType element, std::vector<Point2>& vertices) const
{
  const auto ids = this->Element(element);
  vertices.resize(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    vertices[i] = this->Points[ids[i]];
  }
}

VirtualElementMesh MakeVirtualElementMesh(vtkPolyData* data)
{
  const std::string reason = ElementAccess::WhyUnusable(data);
  if (!reason.empty())
  {
    throw std::runtime_error("The mesh cannot be solved on: " + reason + ".");
  }
  VirtualElementMesh mesh;
  CopyPoints(data, mesh);
  CopyElements(data, mesh);
  CheckElements(mesh);
  FindUses(mesh);
  FindBoundary(mesh);
  return mesh;
}

} // namespace pemesh
