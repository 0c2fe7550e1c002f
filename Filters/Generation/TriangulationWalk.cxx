// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TriangulationWalk.h"

#include "Predicates.h"

namespace pemesh
{

int TriangulationWalk::EdgeTowards(
  const Point2& point, const RefinableTriangulation::Triangle& triangle)
{
  this->Random = this->Random * 1664525U + 1013904223U; // Numerical Recipes' quick generator
  const int first = static_cast<int>((this->Random >> 16) % 3);
  for (int i = 0; i < 3; ++i)
  {
    const int edge = (first + i) % 3;
    if (Orientation(this->Inside.GetPoint(triangle.Vertex[(edge + 1) % 3]),
          this->Inside.GetPoint(triangle.Vertex[(edge + 2) % 3]), point) < 0)
    {
      return edge;
    }
  }
  return -1;
}

int TriangulationWalk::Find(const Point2& point, int start)
{
  int current = start;
  bool isOutside = false;
  for (;;)
  {
    const RefinableTriangulation::Triangle& triangle =
      isOutside ? this->Outside.Triangles[current] : this->Inside.GetTriangle(current);
    const int edge = this->EdgeTowards(point, triangle);
    if (edge < 0)
    {
      return isOutside ? -1 : current;
    }
    const int neighbor = triangle.Neighbor[edge];
    if (neighbor < 0)
    {
      current =
        isOutside ? this->Inside.GetSegment(~neighbor).Triangle : this->Outside.Beyond[~neighbor];
      isOutside = !isOutside;
    }
    else
    {
      current = neighbor;
    }
    if (current == OutsideTriangles::OutsideHull)
    {
      return -1;
    }
  }
}

} // namespace pemesh
