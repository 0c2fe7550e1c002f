// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BoundaryVertices.h"

#include "ElementAccess.h"

#include <algorithm>
#include <utility>

#include <vtkPolyData.h>

namespace pemesh
{

std::vector<char> MarkBoundaryVertices(vtkPolyData* mesh)
{
  std::vector<std::pair<vtkIdType, vtkIdType>> edges;
  ElementAccess elements(mesh);
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < elements.GetNumberOfElements(); ++i)
  {
    elements.GetVertexIds(i, ids);
    for (std::size_t j = 0; j < ids.size(); ++j)
    {
      edges.push_back(std::minmax({ ids[j], ids[(j + 1) % ids.size()] }));
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<char> markers(static_cast<std::size_t>(mesh->GetNumberOfPoints()), 0);
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const bool shared =
      (i > 0 && edges[i] == edges[i - 1]) || (i + 1 < edges.size() && edges[i] == edges[i + 1]);
    if (!shared)
    {
      markers[static_cast<std::size_t>(edges[i].first)] = 1;
      markers[static_cast<std::size_t>(edges[i].second)] = 1;
    }
  }
  return markers;
}

} // namespace pemesh
