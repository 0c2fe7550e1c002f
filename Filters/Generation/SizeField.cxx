// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SizeField.h"

#include "PlaneVectors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace pemesh
{

namespace
{

constexpr double PreservedSlope = 1.5;
constexpr int LeafSize = 4;

/** Side of the equilateral triangle of this area, and the reverse. */
double SideOfArea(double area)
{
  return 2.0 * std::sqrt(area / std::numbers::sqrt3);
}
double AreaOfSide(double side)
{
  return 0.25 * std::numbers::sqrt3 * side * side;
}

double DistanceToSegment(const Point2& point, const Point2& from, const Point2& to)
{
  const Point2 along = to - from;
  const double place = std::clamp(Dot(point - from, along) / Dot(along, along), 0.0, 1.0);
  return std::sqrt(SquaredDistance(point, { from.x + place * along.x, from.y + place * along.y }));
}

double DistanceToBox(const Point2& point, const Point2& low, const Point2& high)
{
  const double x = std::max({ 0.0, low.x - point.x, point.x - high.x });
  const double y = std::max({ 0.0, low.y - point.y, point.y - high.y });
  return std::sqrt(x * x + y * y);
}

double LengthOf(const DomainBoundary& boundary, const InputSegment& segment)
{
  return std::sqrt(SquaredDistance(boundary.Points[segment.From], boundary.Points[segment.To]));
}

} // namespace

ConeEnvelope::ConeEnvelope(std::vector<Cone> cones, double slope)
  : Cones(std::move(cones))
  , Slope(slope)
{
  if (!this->Cones.empty())
  {
    this->Build(0, static_cast<int>(this->Cones.size()));
  }
}

/** Appends the node of these cones and all below it, halved along the longer side of its box. */
void ConeEnvelope::Build(int first, int last)
{
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  Node node = { { Infinity, Infinity }, { -Infinity, -Infinity }, Infinity, first, last, -1 };
  for (int i = first; i < last; ++i)
  {
    const Cone& cone = this->Cones[i];
    node.Low = { std::min({ node.Low.x, cone.From.x, cone.To.x }),
      std::min({ node.Low.y, cone.From.y, cone.To.y }) };
    node.High = { std::max({ node.High.x, cone.From.x, cone.To.x }),
      std::max({ node.High.y, cone.From.y, cone.To.y }) };
    node.LeastValue = std::min(node.LeastValue, cone.Value);
  }
  const std::size_t place = this->Nodes.size();
  this->Nodes.push_back(node);
  if (last - first <= LeafSize)
  {
    return;
  }
  const bool alongX = node.High.x - node.Low.x > node.High.y - node.Low.y;
  const auto center = [alongX](const Cone& cone)
  { return alongX ? cone.From.x + cone.To.x : cone.From.y + cone.To.y; };
  std::stable_sort(this->Cones.begin() + first, this->Cones.begin() + last,
    [&center](const Cone& a, const Cone& b) { return center(a) < center(b); });
  const int middle = first + (last - first) / 2;
  this->Build(first, middle);
  this->Nodes[place].Second = static_cast<int>(this->Nodes.size());
  this->Build(middle, last);
}

/** What no cone of the node can be below. */
double ConeEnvelope::LowerBound(const Point2& point, const Node& node) const
{
  return node.LeastValue + this->Slope * DistanceToBox(point, node.Low, node.High);
}

double ConeEnvelope::At(const Point2& point, double cap) const
{
  struct Candidate
  {
    double LowerBound;
    int Node;
  };
  Candidate waiting[64]; // twice the depth of a tree of 2^31 cones
  int count = 0;
  if (!this->Nodes.empty())
  {
    waiting[count++] = { this->LowerBound(point, this->Nodes[0]), 0 };
  }
  double least = cap;
  while (count > 0)
  {
    const Candidate candidate = waiting[--count];
    if (!(candidate.LowerBound < least))
    {
      continue;
    }
    const Node& node = this->Nodes[candidate.Node];
    if (node.Second >= 0) // the more promising child is looked at first
    {
      Candidate first = { 0.0, candidate.Node + 1 };
      Candidate second = { 0.0, node.Second };
      first.LowerBound = this->LowerBound(point, this->Nodes[first.Node]);
      second.LowerBound = this->LowerBound(point, this->Nodes[second.Node]);
      const bool isFirstBetter = first.LowerBound <= second.LowerBound;
      waiting[count++] = isFirstBetter ? second : first;
      waiting[count++] = isFirstBetter ? first : second;
      continue;
    }
    for (int i = node.First; i < node.Last; ++i)
    {
      const Cone& cone = this->Cones[i];
      least =
        std::min(least, cone.Value + this->Slope * DistanceToSegment(point, cone.From, cone.To));
    }
  }
  return least;
}

SizeField::SizeField(const DomainBoundary& boundary, const Options& options)
  : MaximumArea(options.MaximumArea)
  , MaximumSide(SideOfArea(options.MaximumArea))
  , LeastBound(options.MaximumArea)
{
  std::vector<ConeEnvelope::Cone> wanted;
  std::vector<ConeEnvelope::Cone> preserved;
  for (std::size_t i = 0; i < boundary.Segments.size(); ++i)
  {
    const InputSegment& segment = boundary.Segments[i];
    const double length = LengthOf(boundary, segment);
    const Point2& from = boundary.Points[segment.From];
    const Point2& to = boundary.Points[segment.To];
    const bool isOfPolygon = static_cast<int>(i) < boundary.NumberOfPolygonSegments;
    if (options.Gradation > 0.0 && isOfPolygon)
    {
      wanted.push_back(
        { from, to, options.SizeAtPolygons > 0.0 ? options.SizeAtPolygons : length });
    }
    if (options.Preserved[i] && (options.Gradation > 0.0 || length > this->MaximumSide))
    {
      preserved.push_back({ from, to, -length });
    }
  }
  this->Wanted = ConeEnvelope(std::move(wanted), options.Gradation);
  this->Preserved = ConeEnvelope(std::move(preserved), PreservedSlope);
  if (!this->Wanted.IsEmpty())
  {
    this->LeastBound = std::min(this->MaximumArea, AreaOfSide(this->Wanted.GetLeastValue()));
  }
}

bool SizeField::IsTooLarge(double area, const Point2& centroid) const
{
  // Only cones below the side of the triangle matter: that ends most queries at once.
  const double side = SideOfArea(area);
  const bool isWantedSmaller = area > this->MaximumArea || this->Wanted.At(centroid, side) < side;
  return isWantedSmaller && !(this->Preserved.At(centroid, -side) < -side);
}

double SizeField::AreaBoundAt(const Point2& point) const
{
  const double wanted = this->Wanted.At(point, this->MaximumSide);
  const double side = -this->Preserved.At(point, -wanted);
  return side == this->MaximumSide ? this->MaximumArea : AreaOfSide(side);
}

} // namespace pemesh
