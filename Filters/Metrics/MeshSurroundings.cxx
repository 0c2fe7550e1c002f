// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshSurroundings.h"

#include "CompensatedSum.h"
#include "CornerMeasures.h"
#include "PolygonMeasures.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

/**
 * Turns all elements counter-clockwise and leaves out repeats of a vertex in a row. Who has fewer
 * than three vertices then has no side, and is nobody's neighbour.
 */
void Normalize(PolygonMesh& mesh)
{
  std::vector<Point2> points;
  int first = 0;
  int kept = 0;
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    const int last = mesh.Offsets[element + 1];
    const int begin = kept;
    for (int i = first; i < last; ++i)
    {
      const int vertex = mesh.Vertices[i];
      if (kept == begin || mesh.Vertices[kept - 1] != vertex)
      {
        mesh.Vertices[kept++] = vertex;
      }
    }
    while (kept - begin > 1 && mesh.Vertices[kept - 1] == mesh.Vertices[begin])
    {
      --kept;
    }
    kept = kept - begin < 3 ? begin : kept;
    first = last;
    mesh.Offsets[element + 1] = kept;
    mesh.GetVertices(element, points);
    if (!points.empty() && PolygonOrientation(points) < 0)
    {
      std::reverse(mesh.Vertices.begin() + begin, mesh.Vertices.begin() + kept);
    }
  }
  mesh.Vertices.resize(static_cast<std::size_t>(kept));
}

} // namespace

MeshNeighbours::MeshNeighbours(PolygonMesh mesh)
  : Mesh(std::move(mesh))
{
  Normalize(this->Mesh);
  MeshAdjacency adjacency = FindAdjacency(this->Mesh);
  for (int& twin : adjacency.Twin)
  {
    twin = twin < 0 ? twin : adjacency.Element[static_cast<std::size_t>(twin)];
  }
  this->Twins = std::move(adjacency.Twin);
}

double MeshNeighbours::SideLength(int element, std::size_t side) const
{
  const std::span<const int> vertices = this->Mesh.Element(element);
  const Point2& a = this->Mesh.Points[vertices[side]];
  const Point2& b = this->Mesh.Points[vertices[side + 1 == vertices.size() ? 0 : side + 1]];
  const double x = b.x - a.x;
  const double y = b.y - a.y;
  return std::sqrt(x * x + y * y);
}

std::span<const SharedLength> MeshNeighbours::GetShared(vtkIdType element) const
{
  thread_local std::vector<SharedLength> shared;
  shared.clear();
  const std::span<const int> twins = this->GetTwinElements(element);
  for (std::size_t side = 0; side < twins.size(); ++side)
  {
    if (twins[side] >= 0)
    {
      shared.push_back({ twins[side], this->SideLength(static_cast<int>(element), side) });
    }
  }
  // Equal neighbours by length too, so that the sum does not depend on where the list begins.
  std::ranges::sort(shared,
    [](const SharedLength& a, const SharedLength& b)
    { return a.Neighbour < b.Neighbour || (a.Neighbour == b.Neighbour && a.Length < b.Length); });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < shared.size(); ++i)
  {
    if (kept > 0 && shared[kept - 1].Neighbour == shared[i].Neighbour)
    {
      shared[kept - 1].Length += shared[i].Length;
    }
    else
    {
      shared[kept++] = shared[i];
    }
  }
  return { shared.data(), kept };
}

double MeshNeighbours::GetPerimeter(vtkIdType element) const
{
  double sum = 0.0;
  for (std::size_t side = 0; side < this->GetTwinElements(element).size(); ++side)
  {
    sum += this->SideLength(static_cast<int>(element), side);
  }
  return sum;
}

double MeshNeighbours::GetBorderLength(vtkIdType element) const
{
  const std::span<const int> twins = this->GetTwinElements(element);
  double sum = 0.0;
  for (std::size_t side = 0; side < twins.size(); ++side)
  {
    sum += twins[side] == MeshAdjacency::Border ? this->SideLength(static_cast<int>(element), side)
                                                : 0.0;
  }
  return sum;
}

int MeshNeighbours::CountHangingVertices(vtkIdType element, double distance) const
{
  const std::span<const int> twins = this->GetTwinElements(element);
  const std::span<const int> vertices = this->Mesh.Element(static_cast<int>(element));
  const std::size_t size = twins.size();
  int count = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::size_t before = i == 0 ? size - 1 : i - 1;
    const std::size_t after = i + 1 == size ? 0 : i + 1;
    if (twins[before] != twins[i] &&
      IsStraight(this->Mesh.Points[vertices[before]], this->Mesh.Points[vertices[i]],
        this->Mesh.Points[vertices[after]], distance))
    {
      ++count;
    }
  }
  return count;
}

double MeshNeighbours::GetBoundaryLength() const
{
  CompensatedSum sum;
  for (int element = 0; element < this->Mesh.NumberOfElements(); ++element)
  {
    sum.Add(this->GetBorderLength(element));
  }
  return sum.Get();
}

vtkIdType MeshNeighbours::CountEdges() const
{
  const auto unshared = std::ranges::count_if(this->Twins, [](int twin) { return twin < 0; });
  return (static_cast<vtkIdType>(this->Twins.size()) + unshared) / 2;
}

} // namespace pemesh
