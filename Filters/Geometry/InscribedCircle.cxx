// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "InscribedCircle.h"

#include "PlaneVectors.h"
#include "PolygonMeasures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pemesh
{

namespace
{

using Edge = BoundaryCover::Edge;

/** Twice the area over the perimeter; the rounding is that of the area alone. */
Circle InscribedCircleOfTriangle(PolygonView t)
{
  const double a = Length(t[2] - t[1]);
  const double b = Length(t[0] - t[2]);
  const double c = Length(t[1] - t[0]);
  const double perimeter = a + b + c;
  const Point2 toB = t[1] - t[0];
  const Point2 toC = t[2] - t[0];
  const Point2 center = { t[0].x + (b * toB.x + c * toC.x) / perimeter,
    t[0].y + (b * toB.y + c * toC.y) / perimeter };
  return { center, 2.0 * std::abs(SignedArea(t)) / perimeter };
}

/** Of the distance to a plane: below that, equal planes would take turns in the linear program. */
constexpr double RoundingOfPlanes = 1e-15;

struct AreaAndCentroid
{
  double Area = 0.0;
  Point2 Centroid;
};

AreaAndCentroid MeasureArea(const std::vector<Edge>& edges)
{
  double sum = 0.0;
  Point2 moment;
  for (std::size_t i = 1; i + 1 < edges.size(); ++i)
  {
    const Point2& a = edges[i].Start;
    const Point2& b = edges[i + 1].Start;
    const double cross = a.x * b.y - a.y * b.x;
    sum += cross;
    moment = { moment.x + cross * (a.x + b.x), moment.y + cross * (a.y + b.y) };
  }
  return { 0.5 * sum, { moment.x / (3.0 * sum), moment.y / (3.0 * sum) } };
}

} // namespace

Circle InscribedCircleFinder::Find(PolygonView polygon)
{
  return this->Find(polygon, IsConvex(polygon));
}

Circle InscribedCircleFinder::Find(PolygonView polygon, bool convex)
{
  if (polygon.size() < 3)
  {
    return { {}, std::numeric_limits<double>::quiet_NaN() };
  }
  if (polygon.size() == 3)
  {
    return InscribedCircleOfTriangle(polygon);
  }
  if (!convex)
  {
    return this->FindByClimbing(polygon);
  }
  const Circle circle = this->FindInKernel(this->KernelFinder.Find(polygon, true));
  return { circle.Center + polygon[0], circle.Radius };
}

/** The bounding box as the region of the linear program, relative to `middle`, as far as `reach`.
 */
void InscribedCircleFinder::AddBox(const Point2& middle, double reach)
{
  this->Program.Clear();
  this->Program.AddSide({ 1.0, 0.0 }, std::min(reach, this->High.x - middle.x));
  this->Program.AddSide({ 0.0, 1.0 }, std::min(reach, this->High.y - middle.y));
  this->Program.AddSide({ -1.0, 0.0 }, std::min(reach, middle.x - this->Low.x));
  this->Program.AddSide({ 0.0, -1.0 }, std::min(reach, middle.y - this->Low.y));
}

void InscribedCircleFinder::SetPolygon(PolygonView polygon)
{
  this->Boundary.SetPolygon(polygon);
  this->Low = {};
  this->High = {};
  for (const Edge& edge : this->Boundary.GetEdges())
  {
    this->Low = { std::min(this->Low.x, edge.Start.x), std::min(this->Low.y, edge.Start.y) };
    this->High = { std::max(this->High.x, edge.Start.x), std::max(this->High.y, edge.Start.y) };
  }
}

Circle InscribedCircleFinder::FindInKernel(PolygonView polygon)
{
  const Circle circle = this->FindInKernel(this->KernelFinder.Find(polygon));
  return { circle.Center + polygon[0], circle.Radius };
}

/** The sides go round a convex region, so that their bounds alone make a linear program. */
Circle InscribedCircleFinder::FindInKernel(const std::vector<PolygonKernelFinder::Side>& sides)
{
  if (sides.size() < 3)
  {
    return {};
  }
  Point2 middle;
  double size = 0.0;
  for (const PolygonKernelFinder::Side& side : sides)
  {
    middle = middle + side.Start;
    size = std::max({ size, std::abs(side.Start.x), std::abs(side.Start.y) });
  }
  const double share = 1.0 / static_cast<double>(sides.size());
  middle = { share * middle.x, share * middle.y };
  this->Program.ForgetBasis();
  this->Program.Clear();
  for (const PolygonKernelFinder::Side& side : sides)
  {
    const double inverse = 1.0 / Length(side.Direction);
    const Point2 normal = { -side.Direction.y * inverse, side.Direction.x * inverse };
    this->Program.AddBound(Dot(normal, middle - side.Start), normal);
  }
  const SmallLinearProgram::Solution solution = this->Program.Solve(RoundingOfPlanes * size, 0.0);
  // What is left of rounding makes the circle smaller, never larger than its place allows.
  const double height = this->Program.HeightAt(solution.Position);
  // The program that gave up still has an upper bound; what is not near it is not known.
  constexpr double Proved = 1e-12;
  const bool isKnown = solution.Optimal || solution.Height <= std::max(0.0, height) + Proved * size;
  return { middle + solution.Position,
    isKnown ? std::max(0.0, height) : std::numeric_limits<double>::quiet_NaN() };
}

/** What may be left unproved: more than rounding, far less than anyone can use. */
double InscribedCircleFinder::Tolerance() const
{
  constexpr double RelativeTolerance = 1e-11;
  constexpr double RoundingTolerance = 5e-16; // of distances, relative to the perimeter
  return std::max(
    RelativeTolerance * this->Best.Radius, RoundingTolerance * this->Boundary.GetScale());
}

Circle InscribedCircleFinder::FindByClimbing(PolygonView polygon)
{
  this->SetPolygon(polygon);
  this->Best = {};
  const AreaAndCentroid measure = MeasureArea(this->Boundary.GetEdges());
  Point2 point = measure.Centroid;
  if (this->Boundary.Contains(point))
  {
    this->Climb(point);
  }
  // The radius is more than the area over the perimeter: erosion by it leaves something.
  const double least = 0.49 * measure.Area / this->Boundary.GetScale();
  double tolerance = this->Tolerance();
  // Every climb goes up by half the tolerance at least, mostly to the next local maximum.
  while (this->Boundary.FindFarther(
    std::max(least, this->Best.Radius + tolerance), 0.5 * tolerance, this->Best.Center, point))
  {
    this->Climb(point);
    tolerance = this->Tolerance();
  }
  const Circle found = { this->Best.Center + polygon[0], this->Best.Radius };
  constexpr double Thin = 1e-10;
  if (found.Radius < Thin * this->Boundary.GetScale())
  {
    // Here rounding shows, and the circle must not be smaller than the one in the kernel.
    const Circle inKernel = this->FindInKernel(polygon);
    return inKernel.Radius > found.Radius ? inKernel : found;
  }
  return found;
}

/** All edges as seen from a point; returns the distance to the boundary. */
double InscribedCircleFinder::SeeAll(const Point2& point, std::vector<Site>& sites) const
{
  const std::vector<Edge>& edges = this->Boundary.GetEdges();
  sites.resize(edges.size());
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const Edge& edge = edges[i];
    const Point2 offset = point - edge.Start;
    const double along = std::clamp(Dot(offset, edge.Direction), 0.0, edge.Length);
    const Point2 away = { offset.x - along * edge.Direction.x,
      offset.y - along * edge.Direction.y };
    const double distance = Length(away);
    const double inverse = 1.0 / distance;
    sites[i] = { distance, { away.x * inverse, away.y * inverse } };
    least = std::min(least, distance);
  }
  return least;
}

/** Goes up from a point of the polygon to a local maximum of the distance to the boundary. */
void InscribedCircleFinder::Climb(Point2 point)
{
  // Newton's method squares the error: after a smaller gain the rest is rounding, and where it is
  // not, the climb goes on from where the cover of the boundary has its gap.
  constexpr double LeastGain = 1e-7;
  double distance = this->SeeAll(point, this->Sites);
  this->Program.ForgetBasis();
  for (double before = 0.0; distance > before * (1.0 + LeastGain);)
  {
    before = distance;
    if (!this->ClimbStep(point, distance) || this->IsAtTop(distance))
    {
      break;
    }
  }
  if (distance > this->Best.Radius)
  {
    this->Best = { point, distance };
  }
}

/**
 * To the highest point below the tangent planes of all distances, which are convex functions: at
 * every point on the way the true distance is at least the height, so the way stays inside. False
 * if nothing was gained.
 */
bool InscribedCircleFinder::ClimbStep(Point2& point, double& distance)
{
  this->AddBox(point, distance); // farther than that the planes tell little
  for (const Site& site : this->Sites)
  {
    this->Program.AddBound(site.Distance, site.Away);
  }
  constexpr double LeastViolation = 1e-13; // the cover of the boundary asks for 1e-11
  const SmallLinearProgram::Solution solution = this->Program.Solve(
    std::max(LeastViolation * distance, RoundingOfPlanes * this->Boundary.GetScale()), distance);
  if (!solution.Optimal)
  {
    return false;
  }
  const Point2 next = point + solution.Position;
  const double nextDistance = this->SeeAll(next, this->NextSites);
  // In a polygon so thin that rounding counts, the step may end beyond its boundary.
  if (!(nextDistance > distance) || !this->Boundary.Contains(next))
  {
    return false;
  }
  point = next;
  distance = nextDistance;
  std::swap(this->Sites, this->NextSites);
  return true;
}

/**
 * Whether the planes that carry the last step touch the distances where it ended, as those of lines
 * do everywhere: then no further step gains more than the difference.
 */
bool InscribedCircleFinder::IsAtTop(double distance) const
{
  constexpr double LeastGain = 1e-12;
  return std::ranges::all_of(this->Program.GetActiveBounds(),
    [&](std::ptrdiff_t i)
    {
      return i >= 0 &&
        this->Sites[static_cast<std::size_t>(i)].Distance <= distance * (1.0 + LeastGain);
    });
}

Circle LargestInscribedCircle(PolygonView polygon)
{
  InscribedCircleFinder finder;
  return finder.Find(polygon);
}

Circle LargestCircleInKernel(PolygonView polygon)
{
  InscribedCircleFinder finder;
  return finder.FindInKernel(polygon);
}

} // namespace pemesh
