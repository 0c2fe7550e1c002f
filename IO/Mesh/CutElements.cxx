// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CutElements.h"

#include "ElementAccess.h"
#include "TriangulatePolygon.h"

#include <array>
#include <vector>

namespace pemesh
{

void ForEachCutElement(vtkPolyData* mesh, int mostCorners,
  const std::function<void(vtkIdType, std::span<const vtkIdType>)>& use)
{
  ElementAccess elements(mesh);
  PolygonTriangulator triangulator;
  std::vector<Point2> vertices;
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < elements.GetNumberOfElements(); ++i)
  {
    elements.GetVertexIds(i, ids);
    if (ids.size() <= static_cast<std::size_t>(mostCorners))
    {
      use(i, ids);
      continue;
    }
    elements.GetVertices(i, vertices);
    for (const PolygonTriangle& triangle : triangulator.Triangulate(vertices))
    {
      std::array<vtkIdType, 3> corners;
      for (std::size_t j = 0; j < corners.size(); ++j)
      {
        corners[j] = ids[static_cast<std::size_t>(triangle[j])];
      }
      use(i, corners);
    }
  }
}

} // namespace pemesh
