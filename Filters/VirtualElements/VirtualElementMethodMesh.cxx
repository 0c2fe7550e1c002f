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

// The vertices of the boundary in the squares of a grid, about one a square.
class BoundaryGrid
{
public:
  explicit BoundaryGrid(const VirtualElementMesh& mesh)
    : Mesh(mesh)
  {
    std::vector<vtkIdType> ids;
    for (vtkIdType id = 0; id < mesh.NumberOfPoints(); ++id)
    {
      if (mesh.OnBoundary[id])
      {
        const Point2& p = mesh.Points[id];
        this->Low = ids.empty() ? p : Point2{ std::min(Low.x, p.x), std::min(Low.y, p.y) };
        this->High = ids.empty() ? p : Point2{ std::max(High.x, p.x), std::max(High.y, p.y) };
        ids.push_back(id);
      }
    }
    this->Count = static_cast<vtkIdType>(std::sqrt(static_cast<double>(ids.size()))) + 1;
    this->Cells.resize(static_cast<std::size_t>(this->Count) * this->Count);
    for (const vtkIdType id : ids)
    {
      const Point2& p = mesh.Points[id];
      this->Cells[this->Row(p.y) * this->Count + this->Column(p.x)].push_back(id);
    }
  }

  /** A vertex near the inside of the segment, or -1. */
  vtkIdType FindOn(vtkIdType from, vtkIdType to) const
  {
    const Point2& a = this->Mesh.Points[std::min(from, to)];
    const Point2& b = this->Mesh.Points[std::max(from, to)];
    const auto [bottom, top] = std::minmax({ this->Row(a.y), this->Row(b.y) });
    const double height = (this->High.y - this->Low.y) / static_cast<double>(this->Count);
    for (vtkIdType row = bottom; row <= top; ++row)
    {
      // The part of the segment that is in this row, or next to it.
      const double y = this->Low.y + height * static_cast<double>(row);
      const auto place = [&](double level)
      { return a.y == b.y ? 0.5 : std::clamp((level - a.y) / (b.y - a.y), 0.0, 1.0); };
      const double s = a.y == b.y ? 0.0 : place(y - height);
      const double t = a.y == b.y ? 1.0 : place(y + 2.0 * height);
      const auto [left, right] =
        std::minmax({ this->Column(a.x + s * (b.x - a.x)), this->Column(a.x + t * (b.x - a.x)) });
      for (vtkIdType column = left; column <= right; ++column)
      {
        for (const vtkIdType id : this->Cells[row * this->Count + column])
        {
          if (id != from && id != to && IsInside(a, b, this->Mesh.Points[id]))
          {
            return id;
          }
        }
      }
    }
    return -1;
  }

private:
  static bool IsInside(const Point2& a, const Point2& b, const Point2& p)
  {
    constexpr double near = 1.0e-9; // of the length of the edge
    const Point2 along{ b.x - a.x, b.y - a.y };
    const double square = along.x * along.x + along.y * along.y;
    const double place = ((p.x - a.x) * along.x + (p.y - a.y) * along.y) / square;
    const double beside = ((p.x - a.x) * along.y - (p.y - a.y) * along.x) / square;
    return place > near && place < 1.0 - near && std::abs(beside) < near;
  }

  vtkIdType Slot(double value, double low, double high) const
  {
    const double part = high > low ? (value - low) / (high - low) : 0.0;
    return std::clamp<vtkIdType>(
      static_cast<vtkIdType>(part * static_cast<double>(this->Count)), 0, this->Count - 1);
  }
  vtkIdType Row(double y) const { return this->Slot(y, this->Low.y, this->High.y); }
  vtkIdType Column(double x) const { return this->Slot(x, this->Low.x, this->High.x); }

  const VirtualElementMesh& Mesh;
  Point2 Low;
  Point2 High;
  vtkIdType Count = 0;
  std::vector<std::vector<vtkIdType>> Cells;
};

void CheckConforming(const VirtualElementMesh& mesh)
{
  const BoundaryGrid grid(mesh);
  for (vtkIdType element = 0; element < mesh.NumberOfElements(); ++element)
  {
    const auto ids = mesh.Element(element);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      const vtkIdType to = ids[i + 1 == ids.size() ? 0 : i + 1];
      const bool isBoundary =
        mesh.EdgeOnBoundary[mesh.EdgeOf[mesh.Offsets[element] + static_cast<vtkIdType>(i)]] != 0;
      const vtkIdType vertex = isBoundary ? grid.FindOn(ids[i], to) : -1;
      if (vertex >= 0)
      {
        throw std::runtime_error("Vertex " + std::to_string(vertex) + " lies on the edge between " +
          std::to_string(ids[i]) + " and " + std::to_string(to) + " of element " +
          std::to_string(element) +
          ", which does not have it: elements must share whole edges, so "
          "make it a vertex of that element, too.");
      }
    }
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
  CheckConforming(mesh);
  return mesh;
}

} // namespace pemesh
