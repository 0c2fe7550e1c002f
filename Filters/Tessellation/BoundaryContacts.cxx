// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BoundaryContacts.h"

#include "Predicates.h"
#include "SegmentGrid.h"
#include "VoronoiCells.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pemesh
{

namespace
{

/** The nearest point of a segment to a point. */
struct Foot
{
  double Position;
  double Distance;
};

Foot FindFoot(const Point2& point, const Point2& from, const Point2& to)
{
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double along = (point.x - from.x) * dx + (point.y - from.y) * dy;
  const double position = std::clamp(along / (dx * dx + dy * dy), 0.0, 1.0);
  return { position,
    std::hypot(point.x - (from.x + position * dx), point.y - (from.y + position * dy)) };
}

/** Exactly on an axis-parallel segment. */
Point2 PointAt(const Point2& from, const Point2& to, double position)
{
  return { from.x + position * (to.x - from.x), from.y + position * (to.y - from.y) };
}

bool DoCross(const Point2& a, const Point2& b, const Point2& p, const Point2& q)
{
  return std::max(a.x, b.x) >= std::min(p.x, q.x) && std::max(p.x, q.x) >= std::min(a.x, b.x) &&
    std::max(a.y, b.y) >= std::min(p.y, q.y) && std::max(p.y, q.y) >= std::min(a.y, b.y) &&
    Orientation(a, b, p) * Orientation(a, b, q) < 0 &&
    Orientation(p, q, a) * Orientation(p, q, b) < 0;
}

/** Exact but for the one rounding of each coordinate, so that both cells see the same point. */
Point2 CrossingOf(const Point2& a, const Point2& b, const Point2& p, const Point2& q)
{
  using Rational = CGAL::Exact_rational;
  const Rational ax(a.x), ay(a.y), px(p.x), py(p.y);
  const Rational abx = Rational(b.x) - ax, aby = Rational(b.y) - ay;
  const Rational pqx = Rational(q.x) - px, pqy = Rational(q.y) - py;
  const Rational position = ((px - ax) * pqy - (py - ay) * pqx) / (abx * pqy - aby * pqx);
  return { CGAL::to_double(Rational(ax + position * abx)),
    CGAL::to_double(Rational(ay + position * aby)) };
}

class ContactFinder
{
public:
  ContactFinder(const PolygonMesh& cells, const Domain& domain, double tolerance)
    : Tolerance(tolerance)
    , NumberOfCellPoints(static_cast<int>(cells.Points.size()))
    , Grid(this->AddDomain(cells, domain), tolerance,
        static_cast<double>(cells.NumberOfElements()) + static_cast<double>(domain.Outer.size()))
  {
  }

  BoundaryContacts Find()
  {
    this->SnapVertices();
    RemoveRepeatedVertices(this->Contacts.Cells);
    this->Contacts.Adjacency = FindAdjacency(this->Contacts.Cells);
    for (int side = 0; side < this->Contacts.Cells.NumberOfSides(); ++side)
    {
      if (this->Contacts.EdgeOf(side) == side)
      {
        this->FindContactsOf(side);
      }
    }
    this->Contacts.IsTouched.resize(this->Contacts.Cells.Points.size(), true);
    for (PointsOnEdges* points : { &this->Contacts.OnCellEdges, &this->Contacts.OnDomainEdges })
    {
      for (auto& [edge, onEdge] : *points)
      {
        std::stable_sort(onEdge.begin(), onEdge.end(),
          [](const PointOnEdge& a, const PointOnEdge& b) { return a.Position < b.Position; });
      }
    }
    return std::move(this->Contacts);
  }

private:
  /** Copies cells and domain into the contacts; the result are the segments of the domain. */
  const std::vector<Segment>& AddDomain(const PolygonMesh& cells, const Domain& domain);
  void SnapVertices();
  int SnapVertex(int vertex);
  void FindContactsOf(int side);

  const Point2& PointOf(int point) const { return this->Contacts.Cells.Points[point]; }
  bool IsDomainVertex(int point) const { return point >= this->NumberOfCellPoints; }
  int DomainVertex(int edge) const { return this->NumberOfCellPoints + edge; }

  double Tolerance;
  int NumberOfCellPoints;
  BoundaryContacts Contacts;
  std::vector<Segment> DomainSegments; ///< edge i starts at domain vertex i
  std::vector<int> EdgeOfVertex;       ///< a point of the cells each: the domain edge it is on
  SegmentGrid Grid;
};

const std::vector<Segment>& ContactFinder::AddDomain(const PolygonMesh& cells, const Domain& domain)
{
  this->Contacts.Cells = cells;
  std::vector<Point2>& points = this->Contacts.Cells.Points;
  int loops = 0;
  const auto addLoop = [&](std::vector<Point2> loop)
  {
    const int first = static_cast<int>(points.size());
    const int count = static_cast<int>(loop.size());
    points.insert(points.end(), loop.begin(), loop.end());
    for (int i = 0; i < count; ++i)
    {
      const int next = (i + 1) % count;
      this->Contacts.DomainEdges.push_back({ first + i, first + next, loops });
      this->DomainSegments.push_back({ loop[i], loop[next] });
    }
    ++loops;
  };
  addLoop(domain.Outer);
  for (const std::vector<Point2>& hole : domain.Holes)
  {
    addLoop({ hole.rbegin(), hole.rend() });
  }
  this->Contacts.HasContact.assign(this->DomainSegments.size(), false);
  this->EdgeOfVertex.assign(cells.Points.size(), -1);
  this->Contacts.IsTouched.assign(cells.Points.size(), false);
  return this->DomainSegments;
}

/** Puts a vertex near the boundary on it; returns the number that it has from now on. */
int ContactFinder::SnapVertex(int vertex)
{
  Point2& point = this->Contacts.Cells.Points[vertex];
  double least = this->Tolerance;
  int nearestVertex = -1;
  const std::vector<int>& near = this->Grid.FindNear({ point, point });
  for (const int edge : near)
  {
    for (const int end :
      { this->Contacts.DomainEdges[edge].From, this->Contacts.DomainEdges[edge].To })
    {
      const double distance =
        std::hypot(this->PointOf(end).x - point.x, this->PointOf(end).y - point.y);
      nearestVertex = distance < least ? end : nearestVertex;
      least = std::min(least, distance);
    }
  }
  if (nearestVertex >= 0)
  {
    this->Contacts.HasContact[nearestVertex - this->NumberOfCellPoints] = true;
    return nearestVertex;
  }
  Foot best = { 0.0, this->Tolerance };
  for (const int edge : near)
  {
    const Segment& segment = this->DomainSegments[edge];
    const Foot foot = FindFoot(point, segment.From, segment.To);
    if (foot.Distance < best.Distance)
    {
      best = foot;
      this->EdgeOfVertex[vertex] = edge;
    }
  }
  const int edge = this->EdgeOfVertex[vertex];
  if (edge >= 0)
  {
    const Segment& segment = this->DomainSegments[edge];
    point = PointAt(segment.From, segment.To, best.Position);
    this->Contacts.OnDomainEdges[edge].push_back({ best.Position, vertex });
    this->Contacts.IsTouched[vertex] = true;
  }
  return vertex;
}

void ContactFinder::SnapVertices()
{
  std::vector<int> number(static_cast<std::size_t>(this->NumberOfCellPoints), -1);
  for (int& vertex : this->Contacts.Cells.Vertices)
  {
    if (number[vertex] < 0)
    {
      number[vertex] = this->SnapVertex(vertex);
    }
    vertex = number[vertex];
  }
}

void ContactFinder::FindContactsOf(int side)
{
  const int from = this->Contacts.Cells.Vertices[side];
  const int to = this->Contacts.EndOf(side);
  const Point2 a = this->PointOf(from);
  const Point2 b = this->PointOf(to);
  const auto isOnCellEdge = [&](int vertex)
  {
    return vertex == from || vertex == to ||
      FindFoot(this->PointOf(vertex), a, b).Distance < this->Tolerance;
  };
  const auto isOnDomainEdge = [&](int vertex, int edge)
  { return !this->IsDomainVertex(vertex) && this->EdgeOfVertex[vertex] == edge; };
  for (const int edge : this->Grid.FindNear({ a, b }))
  {
    const DomainEdge& domainEdge = this->Contacts.DomainEdges[edge];
    const Point2 p = this->PointOf(domainEdge.From);
    const Point2 q = this->PointOf(domainEdge.To);
    const bool startsHere = isOnCellEdge(domainEdge.From);
    if (startsHere && domainEdge.From != from && domainEdge.From != to)
    {
      this->Contacts.OnCellEdges[side].push_back({ FindFoot(p, a, b).Position, domainEdge.From });
      this->Contacts.HasContact[edge] = true;
    }
    // Where they have a point in common already there is no second one to look for.
    if (startsHere || isOnCellEdge(domainEdge.To) || isOnDomainEdge(from, edge) ||
      isOnDomainEdge(to, edge) || !DoCross(a, b, p, q))
    {
      continue;
    }
    const int crossing = static_cast<int>(this->Contacts.Cells.Points.size());
    this->Contacts.Cells.Points.push_back(CrossingOf(a, b, p, q));
    const Point2& place = this->Contacts.Cells.Points.back();
    this->Contacts.OnCellEdges[side].push_back({ FindFoot(place, a, b).Position, crossing });
    this->Contacts.OnDomainEdges[edge].push_back({ FindFoot(place, p, q).Position, crossing });
  }
}

} // namespace

BoundaryContacts FindBoundaryContacts(
  const PolygonMesh& cells, const Domain& domain, double tolerance)
{
  return ContactFinder(cells, domain, tolerance).Find();
}

} // namespace pemesh
