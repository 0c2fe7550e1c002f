// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "NarrowGaps.h"

#include "PlaneVectors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace pemesh
{

namespace
{

using Triangle = RefinableTriangulation::Triangle;

/** In degrees: what the estimate was compared with. */
constexpr double MeasuredAngle = 20.0;

struct Gap
{
  double Triangles = 0.0;
  double Width = 0.0;
};

/** The part of segment b that lies in front of segment a, whose left side it is on. */
Gap MeasureGap(const Point2& aFrom, const Point2& aTo, Point2 bFrom, Point2 bTo)
{
  const double length = std::sqrt(SquaredDistance(aFrom, aTo));
  const auto place = [&](const Point2& point) { return Dot(point - aFrom, aTo - aFrom) / length; };
  const auto height = [&](const Point2& point)
  { return Cross(aTo - aFrom, point - aFrom) / length; };
  double from = place(bFrom);
  double to = place(bTo);
  double fromHeight = height(bFrom);
  double toHeight = height(bTo);
  if (from > to)
  {
    std::swap(from, to);
    std::swap(fromHeight, toHeight);
  }
  const double start = std::max(from, 0.0);
  const double end = std::min(to, length);
  if (!(end > start) || !(fromHeight > 0.0 && toHeight > 0.0))
  {
    return {};
  }
  const double slope = (toHeight - fromHeight) / (to - from);
  const double startHeight = fromHeight + slope * (start - from);
  const double endHeight = fromHeight + slope * (end - from);
  const double ratio = endHeight / startHeight;
  // The integral of ds / h over a linear h.
  const double integral = std::abs(ratio - 1.0) < 1e-6
    ? (end - start) / startHeight
    : std::log(ratio) * (end - start) / (endHeight - startHeight);
  return { integral, std::min(startHeight, endHeight) };
}

class Search
{
public:
  Search(const RefinableTriangulation& triangulation, const std::vector<bool>& preserved)
    : Mesh(triangulation)
    , Preserved(preserved)
  {
  }

  NarrowGaps Run()
  {
    for (int i = 0; i < this->Mesh.NumberOfTriangles(); ++i)
    {
      for (const int neighbor : this->Mesh.GetTriangle(i).Neighbor)
      {
        if (neighbor > i) // each edge once
        {
          this->LookAcross(this->Mesh.GetTriangle(i), this->Mesh.GetTriangle(neighbor));
        }
      }
    }
    return this->Found;
  }

private:
  /** All pairs of a segment of one triangle and a segment of its neighbour. */
  void LookAcross(const Triangle& one, const Triangle& two)
  {
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        if (one.Neighbor[i] < 0 && two.Neighbor[j] < 0)
        {
          this->LookAt(one, i, two, j);
        }
      }
    }
  }

  void LookAt(const Triangle& one, int i, const Triangle& two, int j)
  {
    const int first[2] = { one.Vertex[(i + 1) % 3], one.Vertex[(i + 2) % 3] };
    const int second[2] = { two.Vertex[(j + 1) % 3], two.Vertex[(j + 2) % 3] };
    const bool isCorner = first[0] == second[1] || first[1] == second[0];
    const int segments[2] = { ~one.Neighbor[i], ~two.Neighbor[j] };
    if (isCorner || this->Preserved[segments[0]] || this->Preserved[segments[1]])
    {
      return;
    }
    const Gap gap = MeasureGap(this->Mesh.GetPoint(first[0]), this->Mesh.GetPoint(first[1]),
      this->Mesh.GetPoint(second[0]), this->Mesh.GetPoint(second[1]));
    this->Found.Triangles += gap.Triangles;
    if (gap.Triangles > this->Found.MostTriangles)
    {
      this->Found.MostTriangles = gap.Triangles;
      this->Found.Width = gap.Width;
      std::copy(segments, segments + 2, this->Found.Segments);
    }
  }

  const RefinableTriangulation& Mesh;
  const std::vector<bool>& Preserved;
  NarrowGaps Found;
};

} // namespace

NarrowGaps FindNarrowGaps(const RefinableTriangulation& triangulation,
  const std::vector<bool>& preserved, double minimumAngle)
{
  constexpr double Degree = std::numbers::pi / 180.0;
  const double share =
    std::min(1.0, std::tan(minimumAngle * Degree) / std::tan(MeasuredAngle * Degree));
  NarrowGaps gaps = Search(triangulation, preserved).Run();
  gaps.Triangles *= share;
  gaps.MostTriangles *= share;
  return gaps;
}

} // namespace pemesh
