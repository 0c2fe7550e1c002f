// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonCrossings.h"

#include "PlaneVectors.h"
#include "Predicates.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace pemesh
{

namespace
{

std::size_t NextIndex(std::size_t i, std::size_t size)
{
  return i + 1 == size ? 0 : i + 1;
}

struct EdgeBox
{
  double Left;
  double Right;
  double Bottom;
  double Top;
};

EdgeBox BoxOf(const Point2& a, const Point2& b)
{
  return { std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y), std::max(a.y, b.y) };
}

/** Without branches: most boxes are apart, but in which direction cannot be foreseen. */
bool DoBoxesMeet(const EdgeBox& a, const EdgeBox& b)
{
  return (static_cast<int>(a.Left <= b.Right) & static_cast<int>(b.Left <= a.Right) &
           static_cast<int>(a.Bottom <= b.Top) & static_cast<int>(b.Bottom <= a.Top)) != 0;
}

enum class Contact
{
  None,
  Touch, ///< perhaps: an end of one is on the line of the other
  Cross
};

/** Of two edges, by the index of the first vertex, that are not neighbours. */
Contact FindContact(PolygonView polygon, std::size_t i, std::size_t j)
{
  const std::size_t size = polygon.size();
  if (NextIndex(i, size) == j || NextIndex(j, size) == i)
  {
    return Contact::None;
  }
  const Point2& a = polygon[i];
  const Point2& b = polygon[NextIndex(i, size)];
  const Point2& c = polygon[j];
  const Point2& d = polygon[NextIndex(j, size)];
  const int ofSecond = Orientation(a, b, c) * Orientation(a, b, d);
  if (ofSecond > 0)
  {
    return Contact::None;
  }
  const int ofFirst = Orientation(c, d, a) * Orientation(c, d, b);
  return ofFirst > 0              ? Contact::None
    : ofFirst < 0 && ofSecond < 0 ? Contact::Cross
                                  : Contact::Touch;
}

constexpr std::size_t FewEdges = 48; // up to here comparing all pairs is faster than sorting

/** The strongest contact of two edges. */
Contact FindContactInPairs(PolygonView polygon)
{
  const std::size_t size = polygon.size();
  std::array<EdgeBox, FewEdges> boxes;
  Contact strongest = Contact::None;
  for (std::size_t i = 0; i < size; ++i)
  {
    boxes[i] = BoxOf(polygon[i], polygon[NextIndex(i, size)]);
    for (std::size_t j = 0; j + 1 < i; ++j)
    {
      if (DoBoxesMeet(boxes[i], boxes[j]))
      {
        strongest = std::max(strongest, FindContact(polygon, j, i));
      }
    }
    if (strongest == Contact::Cross)
    {
      break;
    }
  }
  return strongest;
}

/** The same; edges sorted by their left end are swept. */
Contact FindContactInSweep(PolygonView polygon)
{
  const std::size_t size = polygon.size();
  std::vector<EdgeBox> boxes(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    boxes[i] = BoxOf(polygon[i], polygon[NextIndex(i, size)]);
  }
  std::vector<std::size_t> order(size);
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::sort(order.begin(), order.end(),
    [&](std::size_t i, std::size_t j)
    { return boxes[i].Left < boxes[j].Left || (boxes[i].Left == boxes[j].Left && i < j); });
  Contact strongest = Contact::None;
  for (std::size_t k = 0; k < size && strongest != Contact::Cross; ++k)
  {
    const std::size_t i = order[k];
    for (std::size_t l = k + 1; l < size && boxes[order[l]].Left <= boxes[i].Right; ++l)
    {
      if (DoBoxesMeet(boxes[i], boxes[order[l]]))
      {
        strongest = std::max(strongest, FindContact(polygon, i, order[l]));
      }
    }
  }
  return strongest;
}

/** Whether the boundary turns back on itself at a vertex, or has a repeated one. */
bool HasTurnOrRepeat(PolygonView polygon)
{
  Point2 before = polygon.back();
  Point2 along = polygon.front() - before;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& next = polygon[NextIndex(i, polygon.size())];
    const Point2 onward = next - polygon[i];
    if (Dot(along, onward) <= 0.0 && Orientation(before, polygon[i], next) == 0)
    {
      return true;
    }
    before = polygon[i];
    along = onward;
  }
  return false;
}

/** For a point on the line through two others: whether it is between them. */
bool IsBetween(const Point2& point, const Point2& a, const Point2& b)
{
  return IsLexicographicallyLess(a, point) != IsLexicographicallyLess(b, point) && point != a &&
    point != b;
}

/** Whether the rays from a point to two others are the same. */
bool IsSameRay(const Point2& point, const Point2& a, const Point2& b)
{
  return Orientation(point, a, b) == 0 &&
    IsLexicographicallyLess(point, a) == IsLexicographicallyLess(point, b);
}

/** Whether the ray from `point` to `to` is met when turning left from that to a until b. */
bool IsInWedge(const Point2& point, const Point2& a, const Point2& b, const Point2& to)
{
  const int turn = Orientation(point, a, b);
  if (turn == 0)
  {
    return Orientation(point, a, to) > 0;
  }
  const bool isLeftOfFirst = Orientation(point, a, to) > 0;
  const bool isRightOfSecond = Orientation(point, to, b) > 0;
  return turn > 0 ? isLeftOfFirst && isRightOfSecond : isLeftOfFirst || isRightOfSecond;
}

/** How the boundary passes through a point: it comes from one and leaves for the other. */
struct Passage
{
  Point2 From;
  Point2 To;
};

std::vector<Passage> FindPassages(PolygonView polygon, const Point2& point)
{
  std::vector<Passage> passages;
  const std::size_t size = polygon.size();
  for (std::size_t i = 0; i < size; ++i)
  {
    const Point2& next = polygon[NextIndex(i, size)];
    if (polygon[i] == point)
    {
      passages.push_back({ polygon[i == 0 ? size - 1 : i - 1], next });
    }
    else if (next != point && Orientation(polygon[i], next, point) == 0 &&
      IsBetween(point, polygon[i], next))
    {
      passages.push_back({ polygon[i], next });
    }
  }
  return passages;
}

/** Whether one passage goes to the other side of the other, or along it. */
bool DoCross(const Point2& point, const Passage& a, const Passage& b)
{
  for (const Point2& end : { b.From, b.To })
  {
    if (IsSameRay(point, a.From, end) || IsSameRay(point, a.To, end))
    {
      return true;
    }
  }
  return IsInWedge(point, a.From, a.To, b.From) != IsInWedge(point, a.From, a.To, b.To);
}

/** For a polygon without crossings between vertices: what goes on at them. */
bool HasCrossingAtVertex(PolygonView given)
{
  std::vector<Point2> polygon(given.begin(), given.end());
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while (polygon.size() > 1 && polygon.back() == polygon.front())
  {
    polygon.pop_back();
  }
  for (const Point2& point : polygon)
  {
    const std::vector<Passage> passages = FindPassages(polygon, point);
    for (std::size_t i = 0; i < passages.size(); ++i)
    {
      if (IsSameRay(point, passages[i].From, passages[i].To))
      {
        return true;
      }
      for (std::size_t j = 0; j < i; ++j)
      {
        if (DoCross(point, passages[i], passages[j]))
        {
          return true;
        }
      }
    }
  }
  return false;
}

} // namespace

bool HasCrossingEdges(PolygonView polygon)
{
  if (polygon.size() < 3)
  {
    return false;
  }
  const Contact contact =
    polygon.size() <= FewEdges ? FindContactInPairs(polygon) : FindContactInSweep(polygon);
  const bool mayCross = contact == Contact::Touch || HasTurnOrRepeat(polygon);
  return contact == Contact::Cross || (mayCross && HasCrossingAtVertex(polygon));
}

} // namespace pemesh
