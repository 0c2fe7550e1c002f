// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementGeometry.h"

#include "EnclosingCircle.h"
#include "PlaneVectors.h"
#include "PolygonCrossings.h"
#include "Predicates.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

constexpr int After[] = { 1, 2, 0 };

/** Nearer than 1e-162: the square of the distance is no number but zero. */
bool IsRepeat(const Point2& a, const Point2& b)
{
  return SquaredDistance(a, b) == 0.0;
}

bool IsFinite(const Point2& point)
{
  return std::isfinite(point.x) && std::isfinite(point.y);
}

} // namespace

bool ElementGeometry::SetVertices(PolygonView vertices)
{
  this->Computed = 0;
  this->HasSides = false;
  this->Kernel = nullptr;
  return vertices.size() == 3 ? this->SetTriangle(vertices) : this->SetPolygon(vertices);
}

bool ElementGeometry::SetTriangle(PolygonView vertices)
{
  const Point2& a = vertices[0];
  const Point2& b = vertices[1];
  const Point2& c = vertices[2];
  if (!IsFinite(a) || !IsFinite(b) || !IsFinite(c))
  {
    return false;
  }
  this->Repeated = IsRepeat(a, b) || IsRepeat(b, c) || IsRepeat(c, a);
  this->Convex = true;
  const int orientation = Orientation(a, b, c);
  this->Vertices.assign({ a, orientation < 0 ? c : b, orientation < 0 ? b : c });
  return orientation != 0 && !this->Repeated;
}

bool ElementGeometry::SetPolygon(PolygonView vertices)
{
  this->Vertices.clear();
  this->Repeated = false;
  for (const Point2& vertex : vertices)
  {
    if (!IsFinite(vertex))
    {
      return false;
    }
    if (this->Vertices.empty() || !IsRepeat(vertex, this->Vertices.back()))
    {
      this->Vertices.push_back(vertex);
    }
  }
  while (this->Vertices.size() > 1 && IsRepeat(this->Vertices.back(), this->Vertices.front()))
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

const ElementGeometry::TriangleSides& ElementGeometry::GetSides()
{
  TriangleSides& sides = this->Sides;
  if (this->HasSides)
  {
    return sides;
  }
  this->HasSides = true;
  for (int i = 0; i < 3; ++i)
  {
    const Point2 side = this->Vertices[After[After[i]]] - this->Vertices[After[i]];
    sides.Vector[i] = side;
    sides.Square[i] = Dot(side, side);
    sides.Length[i] = std::sqrt(sides.Square[i]);
    sides.Order[i] = i;
  }
  const auto Sort = [&sides](int& i, int& j)
  {
    if (sides.Square[j] < sides.Square[i])
    {
      std::swap(i, j);
    }
  };
  Sort(sides.Order[0], sides.Order[1]);
  Sort(sides.Order[1], sides.Order[2]);
  Sort(sides.Order[0], sides.Order[1]);
  return sides;
}

void ElementGeometry::ComputeArea()
{
  this->Area = std::abs(SignedArea(this->Vertices));
}

void ElementGeometry::ComputeEdges()
{
  if (!this->IsTriangle())
  {
    this->Edges = MeasureEdges(this->Vertices);
    return;
  }
  const TriangleSides& sides = this->GetSides();
  this->Edges = { sides.Length[sides.Order[0]], sides.Length[sides.Order[2]],
    sides.Length[0] + sides.Length[1] + sides.Length[2] };
}

/** The smallest angle of a triangle is opposite to its shortest side, and so on. */
void ElementGeometry::ComputeAngles()
{
  if (!this->IsTriangle())
  {
    this->Angles = MeasureAngles(this->Vertices);
    return;
  }
  const TriangleSides& sides = this->GetSides();
  const double cross = 2.0 * this->GetArea();
  const auto Angle = [&](int vertex)
  {
    const int next = After[vertex];
    return std::atan2(cross, -Dot(sides.Vector[next], sides.Vector[After[next]]));
  };
  this->Angles = { Angle(sides.Order[0]), Angle(sides.Order[2]) };
}

void ElementGeometry::ComputeDistances()
{
  if (this->IsTriangle())
  {
    const TriangleSides& sides = this->GetSides();
    this->Farthest.Distance = sides.Length[sides.Order[2]];
    this->ClosestPairDistance = sides.Length[sides.Order[0]];
    return;
  }
  const DistanceRange distances = MeasureDistances(this->Vertices);
  this->Farthest = distances.Farthest;
  this->ClosestPairDistance = distances.Least;
}

/** Of a triangle, half the longest side unless all angles are acute, else abc / 4A. */
void ElementGeometry::ComputeEnclosingRadius()
{
  if (!this->IsTriangle())
  {
    this->GetDiameter(); // and which vertices it connects
    this->EnclosingRadius = SmallestEnclosingCircle(this->Vertices, this->Farthest).Radius;
    return;
  }
  const TriangleSides& sides = this->GetSides();
  const auto [shortest, middle, longest] = sides.Order;
  const bool isAcute = sides.Square[longest] < sides.Square[shortest] + sides.Square[middle];
  const double half = 0.5 * sides.Length[longest];
  this->EnclosingRadius =
    isAcute ? sides.Length[shortest] * sides.Length[middle] * half / (2.0 * this->GetArea()) : half;
}

void ElementGeometry::ComputeInscribedRadius()
{
  this->InscribedRadius = this->IsTriangle()
    ? 2.0 * this->GetArea() / this->GetEdges().Perimeter
    : this->CircleFinder.Find(this->Vertices, this->Convex).Radius;
}

const std::vector<PolygonKernelFinder::Side>& ElementGeometry::GetKernel()
{
  if (!this->Kernel)
  {
    this->Kernel = &this->KernelFinder.Find(this->Vertices, this->Convex);
  }
  return *this->Kernel;
}

void ElementGeometry::ComputeKernelArea()
{
  // The kernel of a convex element is the element, and the ratio has to be one exactly.
  this->KernelArea = this->GetArea();
  if (!this->Convex)
  {
    this->GetKernel();
    this->KernelArea = std::min(this->KernelArea, this->KernelFinder.GetArea());
  }
}

void ElementGeometry::ComputeKernelRadius()
{
  this->KernelRadius = this->Convex ? this->GetInscribedRadius()
                                    : this->CircleFinder.FindInKernel(this->GetKernel()).Radius;
}

/** All corners of a triangle have the same cross product, so that the largest edges decide. */
void ElementGeometry::ComputeCorners()
{
  if (!this->IsTriangle())
  {
    this->Corners = MeasureCorners(this->Vertices);
    return;
  }
  const TriangleSides& sides = this->GetSides();
  const auto [shortest, middle, longest] = sides.Order;
  const double cross = 2.0 * this->GetArea();
  this->Corners = { std::min(1.0, cross / (sides.Length[middle] * sides.Length[longest])),
    std::min(1.0, 2.0 * cross / (sides.Square[middle] + sides.Square[longest])) };
}

void ElementGeometry::ComputeSideRatio()
{
  this->SideRatio = SmallestSideRatio(this->Vertices, StraightTolerance * this->GetDiameter());
}

void ElementGeometry::ComputeBoxArea()
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

void ElementGeometry::ComputeStiffness()
{
  this->Stiffness = MeasureStiffness(this->Vertices);
}

} // namespace pemesh
