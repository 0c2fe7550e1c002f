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

// Edges count as one line, for bounds only, where their vertices are this close to it.
constexpr double ChainTolerance = 1e-12;
// A promise, not a limit: no polygon tried came near it. The best circle found is returned.
constexpr std::size_t MaximumCells = 1000000;
constexpr double Thin = 0.02;     // height over longest side
constexpr int MaximumBounds = 32; // in the linear program of a cell

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
  return convex ? this->FindInKernel(polygon) : this->FindByBranchAndBound(polygon);
}

Circle InscribedCircleFinder::FindInKernel(PolygonView polygon)
{
  this->SetEdges(polygon);
  Point2 low;
  Point2 high;
  for (const Edge& edge : this->Edges)
  {
    low = { std::min(low.x, edge.Start.x), std::min(low.y, edge.Start.y) };
    high = { std::max(high.x, edge.Start.x), std::max(high.y, edge.Start.y) };
  }
  const Point2 middle = { 0.5 * (low.x + high.x), 0.5 * (low.y + high.y) };
  this->Program.Clear();
  this->Program.AddSide({ 1.0, 0.0 }, high.x - middle.x);
  this->Program.AddSide({ 0.0, 1.0 }, high.y - middle.y);
  this->Program.AddSide({ -1.0, 0.0 }, middle.x - low.x);
  this->Program.AddSide({ 0.0, -1.0 }, middle.y - low.y);
  for (const Edge& edge : this->Edges)
  {
    const Point2 normal = LeftOf(edge.Direction);
    this->Program.AddBound(Dot(normal, middle - edge.Start), normal);
  }
  const Point2 center = middle + this->Program.Solve(1e-16 * this->Scale).Position;
  double radius = std::numeric_limits<double>::infinity();
  for (const Edge& edge : this->Edges)
  {
    radius = std::min(radius, Dot(LeftOf(edge.Direction), center - edge.Start));
  }
  return { center + polygon[0], std::max(0.0, radius) };
}

/** Points relative to the first vertex, directions from the vertices as given. */
void InscribedCircleFinder::SetEdges(PolygonView polygon)
{
  this->Edges.clear();
  this->Scale = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2 along = polygon[i + 1 == polygon.size() ? 0 : i + 1] - polygon[i];
    const double length = Length(along);
    if (length > 0.0)
    {
      this->Edges.push_back(
        { polygon[i] - polygon[0], { along.x / length, along.y / length }, length, -1 });
      this->Scale += 0.5 * length;
    }
  }
}

/**
 * Joins edges that lie on almost one line, hanging vertices say. Between two such sides all
 * centres are almost equally good, and bounds by single edges would tell them apart one by one.
 */
void InscribedCircleFinder::SetChains()
{
  this->Chains.clear();
  const std::size_t size = this->Edges.size();
  const auto first = std::min_element(this->Edges.begin(), this->Edges.end(),
    [](const Edge& a, const Edge& b)
    { return a.Start.x < b.Start.x || (a.Start.x == b.Start.x && a.Start.y < b.Start.y); });
  const auto start = static_cast<std::size_t>(first - this->Edges.begin());
  std::size_t begin = 0;
  while (begin < size)
  {
    std::size_t count = 1;
    while (begin + count < size)
    {
      const Edge& edge = this->Edges[(start + begin + count - 1) % size];
      const Edge& next = this->Edges[(start + begin + count) % size];
      const double bend = Dot(LeftOf(edge.Direction), next.Direction);
      if (Dot(edge.Direction, next.Direction) <= 0.0 ||
        std::abs(bend) * std::min(edge.Length, next.Length) > ChainTolerance * this->Scale)
      {
        break;
      }
      ++count;
    }
    if (count > 1)
    {
      this->AddChain((start + begin) % size, count);
    }
    begin += count;
  }
}

void InscribedCircleFinder::AddChain(std::size_t first, std::size_t count)
{
  const std::size_t size = this->Edges.size();
  const Edge& head = this->Edges[first];
  const Edge& tail = this->Edges[(first + count - 1) % size];
  const Point2 end = { tail.Start.x + tail.Length * tail.Direction.x,
    tail.Start.y + tail.Length * tail.Direction.y };
  const Point2 along = end - head.Start;
  const double length = Length(along);
  Chain chain = { head.Start, { along.x / length, along.y / length }, length, 0.0 };
  for (std::size_t i = 0; i < count; ++i)
  {
    Edge& edge = this->Edges[(first + i) % size];
    const double height = Dot(LeftOf(chain.Direction), edge.Start - chain.Start);
    chain.Deviation = std::max(chain.Deviation, std::abs(height));
    // The chain must not fold back, else a point beside it need not have an edge beneath it.
    if (!(Dot(edge.Direction, chain.Direction) > 0.0))
    {
      return;
    }
  }
  if (!(chain.Deviation <= 10.0 * ChainTolerance * this->Scale))
  {
    return;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Edges[(first + i) % size].Chain = static_cast<int>(this->Chains.size());
  }
  this->Chains.push_back(chain);
}

double InscribedCircleFinder::Tolerance(double distance) const
{
  constexpr double RelativeTolerance = 1e-11;
  constexpr double RoundingTolerance = 4e-15; // of distances, relative to the perimeter
  return std::max(RelativeTolerance * distance, RoundingTolerance * this->Scale);
}

double InscribedCircleFinder::Threshold() const
{
  return this->Best.Radius + this->Tolerance(this->Best.Radius);
}

InscribedCircleFinder::Site InscribedCircleFinder::See(const Point2& point, int index) const
{
  const Edge& edge = this->Edges[static_cast<std::size_t>(index)];
  const Point2 offset = point - edge.Start;
  const double along = std::clamp(Dot(offset, edge.Direction), 0.0, edge.Length);
  const Point2 away = { offset.x - along * edge.Direction.x, offset.y - along * edge.Direction.y };
  return { Length(away), away, index };
}

/** All edges as seen from a point; returns the distance to the boundary. */
double InscribedCircleFinder::SeeAll(const Point2& point, std::vector<Site>& sites) const
{
  sites.clear();
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < this->Edges.size(); ++i)
  {
    sites.push_back(this->See(point, static_cast<int>(i)));
    distance = std::min(distance, sites.back().Distance);
  }
  return distance;
}

Circle InscribedCircleFinder::FindByBranchAndBound(PolygonView polygon)
{
  this->SetEdges(polygon);
  this->SetChains();
  this->Best = {};
  this->Discs.clear();
  this->AddTriangles(polygon);
  std::size_t cells = 0;
  while (
    !this->Cells.empty() && this->Cells.front().Bound > this->Threshold() && ++cells < MaximumCells)
  {
    std::pop_heap(this->Cells.begin(), this->Cells.end(), HasLowerBound);
    const Cell cell = this->Cells.back();
    this->Cells.pop_back();
    if (!cell.Examined)
    {
      this->Examine(cell);
    }
    else if (!this->IsInDisc(cell))
    {
      this->Split(cell);
    }
  }
  return { this->Best.Center + polygon[0], this->Best.Radius };
}

/** The triangles to start with, bounded by what their corners, which are vertices, allow. */
void InscribedCircleFinder::AddTriangles(PolygonView polygon)
{
  this->Cells.clear();
  this->Candidates.clear();
  for (std::size_t i = 0; i < this->Edges.size(); ++i)
  {
    this->Candidates.push_back(static_cast<int>(i));
  }
  for (const PolygonTriangle& triangle : this->Triangulator.Triangulate(polygon))
  {
    const auto Corner = [&](std::size_t i)
    { return polygon[static_cast<std::size_t>(triangle[i])] - polygon[0]; };
    Cell cell = { { Corner(0), Corner(1), Corner(2) }, 0.0, 0, this->Candidates.size(), false,
      false };
    double longest = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Point2 side = cell.Corners[(i + 1) % 3] - cell.Corners[i];
      longest = std::max(longest, Dot(side, side));
    }
    // The nearest corner is farthest at the circumcentre, or on the longest side if obtuse.
    cell.Bound = std::sqrt(longest / 3.0) * (1.0 + 1e-15);
    this->Push(cell);
  }
}

void InscribedCircleFinder::Push(const Cell& cell)
{
  this->Cells.push_back(cell);
  std::push_heap(this->Cells.begin(), this->Cells.end(), HasLowerBound);
}

/** Cuts a triangle in two through its longest side. */
void InscribedCircleFinder::Split(const Cell& cell)
{
  std::size_t longest = 0;
  double squared = -1.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Point2 side = cell.Corners[(i + 1) % 3] - cell.Corners[i];
    if (Dot(side, side) > squared)
    {
      squared = Dot(side, side);
      longest = i;
    }
  }
  const Point2& a = cell.Corners[longest];
  const Point2& b = cell.Corners[(longest + 1) % 3];
  const Point2& c = cell.Corners[(longest + 2) % 3];
  const double height = std::abs(Dot(LeftOf(b - a), c - a));
  Cell half = cell;
  half.Halved = cell.Halved || height > Thin * squared;
  const double fraction = half.Halved ? 0.5 : this->EndOfNearestEdge(cell, a, b);
  half.Halved = !half.Halved;
  const Point2 middle = { a.x + fraction * (b.x - a.x), a.y + fraction * (b.y - a.y) };
  half.Corners[(longest + 1) % 3] = middle;
  this->Examine(half);
  half.Corners[(longest + 1) % 3] = b;
  half.Corners[longest] = middle;
  this->Examine(half);
}

/**
 * Where the side from a to b passes the end of the nearest edge that ends beside it; one half if
 * there is none. In a thin cell the distance has a kink there that no plane follows, and halving
 * alone would take as many cells as the cell is thin.
 */
double InscribedCircleFinder::EndOfNearestEdge(
  const Cell& cell, const Point2& a, const Point2& b) const
{
  double best = 0.5;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cell.CandidateCount; ++i)
  {
    const int index = this->Candidates[cell.FirstCandidate + i];
    const Edge& edge = this->Edges[static_cast<std::size_t>(index)];
    const double from = Dot(a - edge.Start, edge.Direction);
    const double to = Dot(b - edge.Start, edge.Direction);
    for (const double end : { 0.0, edge.Length })
    {
      const double fraction = (end - from) / (to - from);
      if (!(fraction > 1e-3) || !(fraction < 1.0 - 1e-3))
      {
        continue;
      }
      const Point2 point = { a.x + fraction * (b.x - a.x), a.y + fraction * (b.y - a.y) };
      const double distance = this->See(point, index).Distance;
      if (distance < nearest)
      {
        nearest = distance;
        best = fraction;
      }
    }
  }
  return best;
}

/** Bounds a triangle, given the edges that count for it, and keeps it if it may hold the centre. */
void InscribedCircleFinder::Examine(Cell cell)
{
  const Point2& a = cell.Corners[0];
  const Point2& b = cell.Corners[1];
  const Point2& c = cell.Corners[2];
  const Point2 center = { (a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0 };
  const double radius = std::sqrt(std::max(
    { Dot(a - center, a - center), Dot(b - center, b - center), Dot(c - center, c - center) }));
  this->Sites.clear();
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cell.CandidateCount; ++i)
  {
    this->Sites.push_back(this->See(center, this->Candidates[cell.FirstCandidate + i]));
    distance = std::min(distance, this->Sites.back().Distance);
  }
  cell.Bound = std::min(cell.Bound, distance + radius);
  if (cell.Bound <= this->Threshold())
  {
    return;
  }
  this->ClimbIfPromising(center, radius, distance);
  if (this->IsInDisc(cell))
  {
    return;
  }
  // An edge can be nearest somewhere in the cell only if it is not farther than this.
  const double limit = (distance + 2.0 * radius) * (1.0 + 1e-12);
  std::erase_if(this->Sites, [limit](const Site& site) { return site.Distance > limit; });
  cell.FirstCandidate = this->Candidates.size();
  cell.CandidateCount = this->Sites.size();
  for (const Site& site : this->Sites)
  {
    this->Candidates.push_back(site.Edge);
  }
  cell.Bound = std::min(cell.Bound, this->BoundCell(cell, distance + radius));
  if (cell.Bound <= this->Threshold())
  {
    this->Candidates.resize(cell.FirstCandidate);
    return;
  }
  cell.Examined = true;
  this->Push(cell);
}

/** From a point better than all known, or deep in a part where no local maximum is known. */
void InscribedCircleFinder::ClimbIfPromising(const Point2& center, double radius, double distance)
{
  const auto IsNear = [&](const Disc& disc)
  { return Length(disc.Center - center) < disc.Radius + radius; };
  if (distance > this->Best.Radius ||
    (radius < 0.25 * distance && std::none_of(this->Discs.begin(), this->Discs.end(), IsNear)))
  {
    this->Climb(center);
  }
}

bool InscribedCircleFinder::IsInDisc(const Cell& cell) const
{
  return std::any_of(this->Discs.begin(), this->Discs.end(),
    [&cell](const Disc& disc)
    {
      const double squared = disc.Radius * disc.Radius;
      return std::all_of(std::begin(cell.Corners), std::end(cell.Corners),
        [&](const Point2& corner)
        { return Dot(corner - disc.Center, corner - disc.Center) <= squared; });
    });
}

/**
 * The highest point below the planes through the distances at the corners. The distance to an
 * edge is a convex function, so in the cell it is nowhere above its plane. The program is in
 * barycentric coordinates, in which a cell as thin as a needle is like any other.
 */
double InscribedCircleFinder::BoundCell(const Cell& cell, double unit)
{
  // Any of the edges give a bound, and the nearest the best.
  if (this->Sites.size() > MaximumBounds)
  {
    std::nth_element(this->Sites.begin(), this->Sites.begin() + MaximumBounds, this->Sites.end(),
      [](const Site& p, const Site& q) { return p.Distance < q.Distance; });
    this->Sites.resize(MaximumBounds);
  }
  const double diagonal = std::sqrt(0.5);
  this->Program.Clear();
  this->Program.AddSide({ 0.0, -1.0 }, 0.0);
  this->Program.AddSide({ diagonal, diagonal }, diagonal);
  this->Program.AddSide({ -1.0, 0.0 }, 0.0);
  double simple = std::numeric_limits<double>::infinity();
  for (const Site& site : this->Sites)
  {
    const std::array<double, 3> heights = this->CornerHeights(cell, site);
    this->Program.AddBound(
      heights[0] / unit, { (heights[1] - heights[0]) / unit, (heights[2] - heights[0]) / unit });
    simple = std::min(simple, std::max({ heights[0], heights[1], heights[2] }));
  }
  if (simple <= this->Threshold())
  {
    return simple;
  }
  return std::min(simple, unit * this->Program.Solve(0.1 * this->Tolerance(0.0) / unit).Height);
}

/** The distances of the corners to an edge, or to the line of its chain where that is closer. */
std::array<double, 3> InscribedCircleFinder::CornerHeights(const Cell& cell, const Site& site) const
{
  std::array<double, 3> heights;
  for (std::size_t i = 0; i < 3; ++i)
  {
    heights[i] = this->See(cell.Corners[i], site.Edge).Distance;
  }
  const int index = this->Edges[static_cast<std::size_t>(site.Edge)].Chain;
  if (index < 0)
  {
    return heights;
  }
  const Chain& chain = this->Chains[static_cast<std::size_t>(index)];
  std::array<double, 3> lineHeights;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Point2 offset = cell.Corners[i] - chain.Start;
    const double along = Dot(offset, chain.Direction);
    if (along < 0.0 || along > chain.Length)
    {
      return heights; // past its end the line says nothing of the distance to the chain
    }
    lineHeights[i] = std::abs(Dot(LeftOf(chain.Direction), offset)) + chain.Deviation;
  }
  const bool closer =
    lineHeights[0] + lineHeights[1] + lineHeights[2] < heights[0] + heights[1] + heights[2];
  return closer ? lineHeights : heights;
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
