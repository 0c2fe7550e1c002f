// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementGeometry.h"

#include "EnclosingCircle.h"
#include "MetricRegistry.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

bool ElementGeometry::SetVertices(PolygonView vertices)
{
  this->Vertices.clear();
  this->Computed = 0;
  this->Repeated = false;
  for (const Point2& vertex : vertices)
  {
    if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y))
    {
      return false;
    }
    if (this->Vertices.empty() || vertex != this->Vertices.back())
    {
      this->Vertices.push_back(vertex);
    }
  }
  while (this->Vertices.size() > 1 && this->Vertices.back() == this->Vertices.front())
  {
    this->Vertices.pop_back();
  }
  this->Repeated = this->Vertices.size() != vertices.size();
  if (this->Vertices.size() < 3)
  {
    return false;
  }
  const int orientation = PolygonOrientation(this->Vertices);
  if (orientation < 0)
  {
    std::reverse(this->Vertices.begin(), this->Vertices.end());
  }
  this->Convex = this->IsTriangle() || pemesh::IsConvex(this->Vertices);
  return orientation != 0 && (this->Convex || !HasCrossingEdges(this->Vertices));
}

/** Whether a kernel is still to be computed; marks it as done. */
bool ElementGeometry::Want(unsigned int need)
{
  const bool wanted = (this->Computed & need) == 0;
  this->Computed |= need;
  return wanted;
}

double ElementGeometry::GetArea()
{
  if (this->Want(NeedsArea))
  {
    this->Area = std::abs(SignedArea(this->Vertices));
  }
  return this->Area;
}

const EdgeLengths& ElementGeometry::GetEdges()
{
  if (this->Want(NeedsEdges))
  {
    this->Edges = MeasureEdges(this->Vertices);
  }
  return this->Edges;
}

const AngleRange& ElementGeometry::GetAngles()
{
  if (this->Want(NeedsAngles))
  {
    this->Angles = MeasureAngles(this->Vertices);
  }
  return this->Angles;
}

void ElementGeometry::ComputeDistances()
{
  if (!this->Want(NeedsDistances))
  {
    return;
  }
  this->Farthest = FarthestPair(this->Vertices);
  this->ClosestPairDistance =
    this->IsTriangle() ? this->GetEdges().Shortest : ClosestPair(this->Vertices).Distance;
}

double ElementGeometry::GetDiameter()
{
  this->ComputeDistances();
  return this->Farthest.Distance;
}

double ElementGeometry::GetClosestPairDistance()
{
  this->ComputeDistances();
  return this->ClosestPairDistance;
}

/** Half the longest edge unless all angles are acute, else abc / 4A. */
double ElementGeometry::ComputeTriangleEnclosingRadius()
{
  double squares[3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Point2& a = this->Vertices[i];
    const Point2& b = this->Vertices[(i + 1) % 3];
    squares[i] = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
  }
  std::sort(std::begin(squares), std::end(squares));
  const double half = 0.5 * std::sqrt(squares[2]);
  if (squares[2] >= squares[0] + squares[1])
  {
    return half;
  }
  const double product = std::sqrt(squares[0]) * std::sqrt(squares[1]) * half;
  return product / (2.0 * this->GetArea());
}

double ElementGeometry::GetEnclosingRadius()
{
  if (this->Want(NeedsEnclosingCircle))
  {
    if (this->IsTriangle())
    {
      this->EnclosingRadius = this->ComputeTriangleEnclosingRadius();
    }
    else
    {
      this->ComputeDistances();
      this->EnclosingRadius = SmallestEnclosingCircle(this->Vertices, this->Farthest).Radius;
    }
  }
  return this->EnclosingRadius;
}

double ElementGeometry::GetInscribedRadius()
{
  if (this->Want(NeedsInscribedCircle))
  {
    this->InscribedRadius = this->IsTriangle()
      ? 2.0 * this->GetArea() / this->GetEdges().Perimeter
      : this->CircleFinder.Find(this->Vertices, this->Convex).Radius;
  }
  return this->InscribedRadius;
}

double ElementGeometry::GetKernelArea()
{
  if (this->Want(NeedsKernelArea))
  {
    // The kernel of a convex element is the element, and the ratio has to be one exactly.
    this->KernelArea = this->Convex
      ? this->GetArea()
      : std::clamp(SignedArea(this->KernelClipper.Clip(this->Vertices)), 0.0, this->GetArea());
  }
  return this->KernelArea;
}

double ElementGeometry::GetKernelRadius()
{
  if (this->Want(NeedsKernelRadius))
  {
    this->KernelRadius = this->Convex ? this->GetInscribedRadius()
                                      : this->CircleFinder.FindInKernel(this->Vertices).Radius;
  }
  return this->KernelRadius;
}

const CornerShapes& ElementGeometry::GetCorners()
{
  if (this->Want(NeedsCorners))
  {
    this->Corners = MeasureCorners(this->Vertices);
  }
  return this->Corners;
}

double ElementGeometry::GetSideRatio()
{
  if (this->Want(NeedsSides))
  {
    this->SideRatio = SmallestSideRatio(this->Vertices, StraightTolerance * this->GetDiameter());
  }
  return this->SideRatio;
}

double ElementGeometry::GetBoxArea()
{
  if (this->Want(NeedsBox))
  {
    Point2 low = this->Vertices.front();
    Point2 high = low;
    for (const Point2& vertex : this->Vertices)
    {
      low = { std::min(low.x, vertex.x), std::min(low.y, vertex.y) };
      high = { std::max(high.x, vertex.x), std::max(high.y, vertex.y) };
    }
    this->BoxArea = (high.x - low.x) * (high.y - low.y);
  }
  return this->BoxArea;
}

const StiffnessMeasures& ElementGeometry::GetStiffness()
{
  if (this->Want(NeedsStiffness))
  {
    this->Stiffness = MeasureStiffness(this->Vertices);
  }
  return this->Stiffness;
}

} // namespace pemesh
