// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BoundaryVertices.h"

#include "ElementAccess.h"

#include <algorithm>
#include <cstddef>

#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

/** Hands over the ends of each side of each element, the smaller number first. */
template <typename Use>
void ForEachSide(vtkPolyData* mesh, const Use& use)
{
  ElementAccess elements(mesh);
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < elements.GetNumberOfElements(); ++i)
  {
    elements.GetVertexIds(i, ids);
    vtkIdType before = ids.empty() ? 0 : ids.back();
    for (const vtkIdType id : ids)
    {
      const auto [low, high] = std::minmax(before, id);
      use(static_cast<std::size_t>(low), high);
      before = id;
    }
  }
}

} // namespace

std::vector<char> MarkBoundaryVertices(vtkPolyData* mesh)
{
  // The other ends of the sides at each vertex, one vertex after the other: no large sort.
  const auto vertices = static_cast<std::size_t>(mesh->GetNumberOfPoints());
  std::vector<std::size_t> begin(vertices + 1, 0);
  ForEachSide(mesh, [&](std::size_t low, vtkIdType) { ++begin[low]; });
  std::size_t sum = 0;
  for (std::size_t& first : begin)
  {
    sum += first;
    first = sum; // the end so far: filling moves it to the beginning
  }
  std::vector<vtkIdType> others(sum);
  ForEachSide(mesh, [&](std::size_t low, vtkIdType high) { others[--begin[low]] = high; });
  std::vector<char> markers(vertices, 0);
  for (std::size_t i = 0; i < vertices; ++i)
  {
    const auto first = others.begin() + static_cast<std::ptrdiff_t>(begin[i]);
    const auto last = others.begin() + static_cast<std::ptrdiff_t>(begin[i + 1]);
    std::sort(first, last); // few: the degree of a vertex
    for (auto other = first; other != last;)
    {
      const auto next = std::upper_bound(other, last, *other);
      if (next - other == 1)
      {
        markers[i] = 1;
        markers[static_cast<std::size_t>(*other)] = 1;
      }
      other = next;
    }
  }
  return markers;
}

} // namespace pemesh
