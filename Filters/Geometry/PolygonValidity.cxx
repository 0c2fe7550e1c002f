// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonValidity.h"

#include "PlaneVectors.h"
#include "Predicates.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace pemesh
{

namespace
{

struct Edge
{
  Point2 From;
  Point2 To;
  std::size_t Index = 0;

  double West() const { return std::min(this->From.x, this->To.x); }
  double East() const { return std::max(this->From.x, this->To.x); }
  double South() const { return std::min(this->From.y, this->To.y); }
  double North() const { return std::max(this->From.y, this->To.y); }
};

/** For a point on the line of the edge: whether it is on the edge, ends included. Exact. */
bool IsBetween(const Point2& point, const Edge& edge)
{
  const auto [low, high] = std::minmax(edge.From, edge.To, IsLexicographicallyLess);
  return !IsLexicographicallyLess(point, low) && !IsLexicographicallyLess(high, point);
}

bool IsOnEdge(const Point2& point, const Edge& edge)
{
  return Orientation(edge.From, edge.To, point) == 0 && IsBetween(point, edge);
}

enum class Contact
{
  None,
  Touch, ///< an end of one is on the other, or they share a piece
  Cross  ///< interiors cross in one point
};

Contact FindContact(const Edge& a, const Edge& b)
{
  if (a.East() < b.West() || b.East() < a.West() || a.North() < b.South() || b.North() < a.South())
  {
    return Contact::None;
  }
  const int b1 = Orientation(a.From, a.To, b.From);
  const int b2 = Orientation(a.From, a.To, b.To);
  const int a1 = Orientation(b.From, b.To, a.From);
  const int a2 = Orientation(b.From, b.To, a.To);
  if (a1 * a2 < 0 && b1 * b2 < 0)
  {
    return Contact::Cross;
  }
  const bool touch = (b1 == 0 && IsBetween(b.From, a)) || (b2 == 0 && IsBetween(b.To, a)) ||
    (a1 == 0 && IsBetween(a.From, b)) || (a2 == 0 && IsBetween(a.To, b));
  return touch ? Contact::Touch : Contact::None;
}

std::vector<Edge> EdgesOf(PolygonView polygon)
{
  std::vector<Edge> edges(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    edges[i] = { polygon[i], polygon[(i + 1) % polygon.size()], i };
  }
  return edges;
}

void SortFromWestToEast(std::vector<Edge>& edges)
{
  std::sort(edges.begin(), edges.end(),
    [](const Edge& a, const Edge& b)
    { return a.West() < b.West() || (a.West() == b.West() && a.Index < b.Index); });
}

/** Whether edge b, which starts where a ends, meets a anywhere else. */
bool FoldsBack(const Edge& a, const Edge& b)
{
  if (a.From == a.To || b.From == b.To)
  {
    return true;
  }
  return Orientation(a.From, a.To, b.To) == 0 &&
    IsLexicographicallyLess(a.From, a.To) == IsLexicographicallyLess(b.To, b.From);
}

/** Whether two edges of one polygon of n edges meet where they must not. */
bool MeetWrongly(const Edge& a, const Edge& b, std::size_t n)
{
  const Edge& first = a.Index < b.Index ? a : b;
  const Edge& second = a.Index < b.Index ? b : a;
  const bool follows = second.Index == first.Index + 1;
  const bool closes = first.Index == 0 && second.Index == n - 1;
  if (!follows && !closes)
  {
    return FindContact(first, second) != Contact::None;
  }
  return (follows && FoldsBack(first, second)) || (closes && FoldsBack(second, first));
}

bool IsLess(const EdgePair& a, const EdgePair& b)
{
  return a.First < b.First || (a.First == b.First && a.Second < b.Second);
}

// --- Where a point lies in a polygon, exactly -----------------------------------

enum class Side
{
  Outside,
  Boundary,
  Inside
};

using Rational = CGAL::Exact_rational;

struct ExactPoint
{
  Rational x;
  Rational y;
};

/** Crossings of the ray from the point to the east, each decided by exact signs. */
Side FindSide(const ExactPoint& point, const std::vector<Edge>& edges)
{
  bool inside = false;
  for (const Edge& edge : edges)
  {
    const Rational fromX(edge.From.x), fromY(edge.From.y), toX(edge.To.x), toY(edge.To.y);
    const Rational turn = (toX - fromX) * (point.y - fromY) - (toY - fromY) * (point.x - fromX);
    if (turn == 0 && std::min(fromX, toX) <= point.x && point.x <= std::max(fromX, toX) &&
      std::min(fromY, toY) <= point.y && point.y <= std::max(fromY, toY))
    {
      return Side::Boundary;
    }
    const bool upward = fromY <= point.y && point.y < toY;
    const bool downward = toY <= point.y && point.y < fromY;
    if ((upward && turn > 0) || (downward && turn < 0))
    {
      inside = !inside;
    }
  }
  return inside ? Side::Inside : Side::Outside;
}

/** The same for a double point, with filtered predicates: fast. */
Side FindSide(const Point2& point, const std::vector<Edge>& edges)
{
  bool inside = false;
  for (const Edge& edge : edges)
  {
    if (IsOnEdge(point, edge))
    {
      return Side::Boundary;
    }
    const bool upward = edge.From.y <= point.y && point.y < edge.To.y;
    const bool downward = edge.To.y <= point.y && point.y < edge.From.y;
    if ((upward && Orientation(edge.From, edge.To, point) > 0) ||
      (downward && Orientation(edge.From, edge.To, point) < 0))
    {
      inside = !inside;
    }
  }
  return inside ? Side::Inside : Side::Outside;
}

/** Where the pieces of one polygon's boundary, cut at the contacts, lie in the other polygon. */
struct PieceCount
{
  int Inside = 0;
  int Outside = 0;
  int Shared = 0;
};

/**
 * Without proper crossings every contact is a vertex of one of the two polygons, so pieces end in
 * doubles; only the middle of a piece needs rational arithmetic.
 */
PieceCount CountPieces(const std::vector<Edge>& cut, const std::vector<Edge>& other)
{
  PieceCount count;
  for (const Edge& edge : cut)
  {
    std::vector<Point2> ends = { edge.From, edge.To };
    for (const Edge& candidate : other)
    {
      if (IsOnEdge(candidate.From, edge))
      {
        ends.push_back(candidate.From);
      }
    }
    std::sort(ends.begin(), ends.end(), IsLexicographicallyLess);
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    {
      const ExactPoint middle = { (Rational(ends[i].x) + Rational(ends[i + 1].x)) / 2,
        (Rational(ends[i].y) + Rational(ends[i + 1].y)) / 2 };
      const Side side = FindSide(middle, other);
      count.Inside += side == Side::Inside;
      count.Outside += side == Side::Outside;
      count.Shared += side == Side::Boundary;
    }
  }
  return count;
}

PolygonRelation RelateTouching(const std::vector<Edge>& first, const std::vector<Edge>& second)
{
  const PieceCount a = CountPieces(first, second);
  const PieceCount b = CountPieces(second, first);
  if (a.Outside == 0 && b.Outside == 0)
  {
    return PolygonRelation::Equal;
  }
  if (a.Inside == 0 && b.Inside == 0)
  {
    return PolygonRelation::Touching;
  }
  if (a.Outside == 0)
  {
    return PolygonRelation::FirstInsideSecond;
  }
  return b.Outside == 0 ? PolygonRelation::SecondInsideFirst : PolygonRelation::Overlapping;
}

/** Only the edges whose bounding boxes meet that of all the other edges: usually few. */
std::vector<Edge> EdgesNear(const std::vector<Edge>& edges, const std::vector<Edge>& others)
{
  Edge box = { { others[0].West(), others[0].South() }, { others[0].East(), others[0].North() } };
  for (const Edge& other : others)
  {
    box.From = { std::min(box.From.x, other.West()), std::min(box.From.y, other.South()) };
    box.To = { std::max(box.To.x, other.East()), std::max(box.To.y, other.North()) };
  }
  std::vector<Edge> near;
  std::copy_if(edges.begin(), edges.end(), std::back_inserter(near),
    [&box](const Edge& edge)
    {
      return edge.East() >= box.West() && edge.West() <= box.East() &&
        edge.North() >= box.South() && edge.South() <= box.North();
    });
  return near;
}

/** The strongest contact of any edge of one polygon with any edge of the other. */
Contact FindContact(const std::vector<Edge>& allFirst, const std::vector<Edge>& allSecond)
{
  const std::vector<Edge> first = EdgesNear(allFirst, allSecond);
  std::vector<Edge> second = EdgesNear(allSecond, allFirst);
  SortFromWestToEast(second);
  Contact strongest = Contact::None;
  for (const Edge& a : first)
  {
    for (std::size_t j = 0; j < second.size() && second[j].West() <= a.East(); ++j)
    {
      const Contact contact = FindContact(a, second[j]);
      if (contact == Contact::Cross)
      {
        return contact;
      }
      strongest = contact == Contact::Touch ? contact : strongest;
    }
  }
  return strongest;
}

} // namespace

bool AreFinite(PolygonView polygon)
{
  return std::all_of(polygon.begin(), polygon.end(),
    [](const Point2& point) { return std::isfinite(point.x) && std::isfinite(point.y); });
}

std::optional<EdgePair> FindSelfCrossing(PolygonView polygon)
{
  std::vector<Edge> edges = EdgesOf(polygon);
  SortFromWestToEast(edges);
  std::optional<EdgePair> found;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    for (std::size_t j = i + 1; j < edges.size() && edges[j].West() <= edges[i].East(); ++j)
    {
      const EdgePair pair = { std::min(edges[i].Index, edges[j].Index),
        std::max(edges[i].Index, edges[j].Index) };
      if ((!found || IsLess(pair, *found)) && MeetWrongly(edges[i], edges[j], edges.size()))
      {
        found = pair;
      }
    }
  }
  return found;
}

bool IsSimple(PolygonView polygon)
{
  return polygon.size() >= 3 && AreFinite(polygon) && !FindSelfCrossing(polygon);
}

std::string WhyNotSimple(PolygonView polygon)
{
  if (polygon.size() < 3)
  {
    return "has fewer than three vertices";
  }
  if (!AreFinite(polygon))
  {
    return "has a coordinate that is not a finite number";
  }
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const std::size_t next = (i + 1) % polygon.size();
    if (polygon[i] == polygon[next])
    {
      return "has vertices " + std::to_string(i) + " and " + std::to_string(next) +
        " at the same place";
    }
  }
  const std::optional<EdgePair> crossing = FindSelfCrossing(polygon);
  return crossing ? "crosses or touches itself: edges " + std::to_string(crossing->First) +
      " and " + std::to_string(crossing->Second) + " meet"
                  : std::string();
}

PolygonRelation RelatePolygons(PolygonView first, PolygonView second)
{
  const std::vector<Edge> firstEdges = EdgesOf(first);
  const std::vector<Edge> secondEdges = EdgesOf(second);
  switch (FindContact(firstEdges, secondEdges))
  {
    case Contact::Cross:
      return PolygonRelation::Overlapping;
    case Contact::Touch:
      return RelateTouching(firstEdges, secondEdges);
    case Contact::None:
      break;
  }
  if (FindSide(first[0], secondEdges) == Side::Inside)
  {
    return PolygonRelation::FirstInsideSecond;
  }
  return FindSide(second[0], firstEdges) == Side::Inside ? PolygonRelation::SecondInsideFirst
                                                         : PolygonRelation::Apart;
}

bool DoBoundariesMeet(PolygonView first, PolygonView second)
{
  return FindContact(EdgesOf(first), EdgesOf(second)) != Contact::None;
}

RectangleRelation RelateToRectangle(PolygonView polygon, const Point2& low, const Point2& high)
{
  RectangleRelation relation = RectangleRelation::Inside;
  for (const Point2& point : polygon)
  {
    if (!(point.x >= low.x && point.x <= high.x && point.y >= low.y && point.y <= high.y))
    {
      return RectangleRelation::Outside;
    }
    if (point.x == low.x || point.x == high.x || point.y == low.y || point.y == high.y)
    {
      relation = RectangleRelation::Touching;
    }
  }
  return relation;
}

} // namespace pemesh
