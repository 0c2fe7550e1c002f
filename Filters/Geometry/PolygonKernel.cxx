// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonKernel.h"

#include "PlaneVectors.h"
#include "PolygonMeasures.h"
#include "Predicates.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

struct Segment
{
  Point2 From;
  Point2 To;
};

/** Whether one direction turns right to another, or both are parallel to an axis; no if unsure. */
bool IsSurelyNotLeft(const Point2& from, const Point2& to)
{
  const double left = from.x * to.y;
  const double right = from.y * to.x;
  constexpr double ErrorBound = 4.5e-16; // 4 u, for differences of coordinates; u = 2^-53
  return left - right <= -ErrorBound * (std::abs(left) + std::abs(right));
}

/**
 * Whether nothing is to the left of three lines: the first two make a wedge that lies to the right
 * of the third, its tip as all directions that go on forever. No if unsure.
 */
bool IsSurelyEmpty(const Segment& a, const Segment& b, const Segment& c)
{
  const Point2 alongA = a.To - a.From;
  const Point2 alongB = b.To - b.From;
  const Point2 alongC = c.To - c.From;
  return !IsSurelyNotLeft(alongA, alongB) && IsSurelyNotLeft(alongB, alongA) &&
    IsSurelyNotLeft(alongA, alongC) && IsSurelyNotLeft(alongC, alongB) &&
    OrientationOfIntersection(c.From, c.To, a.From, a.To, b.From, b.To) < 0;
}

} // namespace

const std::vector<PolygonKernelFinder::Side>& PolygonKernelFinder::Find(PolygonView polygon)
{
  return this->Find(polygon, IsConvex(polygon));
}

const std::vector<PolygonKernelFinder::Side>& PolygonKernelFinder::Find(
  PolygonView polygon, bool convex)
{
  this->Sides.clear();
  const std::size_t size = polygon.size();
  if (size < 3)
  {
    return this->Sides;
  }
  if (convex)
  {
    for (std::size_t i = 0; i < size; ++i)
    {
      const Point2 direction = polygon[i + 1 == size ? 0 : i + 1] - polygon[i];
      if (direction != Point2{})
      {
        this->Sides.push_back({ polygon[i] - polygon[0], direction });
      }
    }
    return this->Sides;
  }
  Point2 low = polygon[0];
  Point2 high = low;
  std::size_t first = 0;
  for (std::size_t i = 1; i < size; ++i)
  {
    const Point2& point = polygon[i];
    low = { std::min(low.x, point.x), std::min(low.y, point.y) };
    high = { std::max(high.x, point.x), std::max(high.y, point.y) };
    first = IsLexicographicallyLess(point, polygon[first]) ? i : first;
  }
  if (size <= FewVertices && this->Clip(polygon, low, high))
  {
    return this->Sides;
  }
  this->Sides.clear();
  if (low.x < high.x && low.y < high.y)
  {
    this->Start(polygon[first], size, low, high);
    if (this->CutAll(polygon, first))
    {
      this->Collect(polygon[0]);
    }
  }
  return this->Sides;
}

/** False if rounding may have decided whether there is a kernel. */
bool PolygonKernelFinder::Clip(PolygonView polygon, const Point2& low, const Point2& high)
{
  const std::size_t size = polygon.size();
  const Point2 origin = polygon[0];
  const Point2 from = low - origin;
  const Point2 to = high - origin;
  this->Corners = { from, { to.x, from.y }, to, { from.x, to.y } };
  this->SideOf = { size, size + 1, size + 2, size + 3 };
  const Segment box[] = { { low, { high.x, low.y } }, { { high.x, low.y }, high },
    { high, { low.x, high.y } }, { { low.x, high.y }, low } };
  const auto LineOf = [&](std::size_t side)
  {
    return side >= size ? box[side - size]
                        : Segment{ polygon[side], polygon[side + 1 == size ? 0 : side + 1] };
  };
  for (std::size_t i = 0; i < size; ++i)
  {
    // From the vertices as given: exact for edges short against the coordinates.
    const Segment edge = LineOf(i);
    if (!this->ClipHalfPlane(edge.From - origin, edge.To - edge.From, i))
    {
      const auto highest = static_cast<std::size_t>(
        std::max_element(this->Heights.begin(), this->Heights.end()) - this->Heights.begin());
      const std::size_t before = highest == 0 ? this->SideOf.size() - 1 : highest - 1;
      return IsSurelyEmpty(LineOf(this->SideOf[before]), LineOf(this->SideOf[highest]), edge);
    }
  }
  for (std::size_t i = 0; i < this->Corners.size(); ++i)
  {
    const Segment line = LineOf(this->SideOf[i]);
    this->Sides.push_back({ this->Corners[i], line.To - line.From });
  }
  // Rounding moves each line by parts in 10^15, so that what is wider than this is there.
  constexpr double SureArea = 1e-10;
  const double extent = std::max(high.x - low.x, high.y - low.y);
  return this->GetArea() > SureArea * extent * extent;
}

/**
 * Cuts off what is to the right of a line (I. E. Sutherland, G. W. Hodgman, Commun. ACM 17 (1974)
 * 32-42). False, and nothing is changed, if that is all.
 */
bool PolygonKernelFinder::ClipHalfPlane(
  const Point2& anchor, const Point2& direction, std::size_t edge)
{
  const std::size_t size = this->Corners.size();
  this->Heights.resize(size);
  double lowest = 0.0;
  for (std::size_t i = 0; i < size; ++i)
  {
    this->Heights[i] = Cross(direction, this->Corners[i] - anchor);
    lowest = std::min(lowest, this->Heights[i]);
  }
  if (!(lowest < 0.0))
  {
    return true;
  }
  // Every point is written and then kept or not: which it is cannot be foreseen, and a branch that
  // goes the other way costs more than the point.
  this->Clipped.resize(2 * size);
  this->ClippedSideOf.resize(2 * size);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::size_t j = i + 1 == size ? 0 : i + 1;
    const double from = this->Heights[i];
    const double to = this->Heights[j];
    const Point2 p = this->Corners[i];
    const Point2 q = this->Corners[j];
    const std::size_t side = to < 0.0 ? edge : this->SideOf[i]; // that starts where this one is met
    this->Clipped[kept] = p;
    this->ClippedSideOf[kept] = from > 0.0 ? this->SideOf[i] : side;
    kept += from >= 0.0 ? 1 : 0;
    const double fraction = from / (from - to);
    this->Clipped[kept] = { p.x + fraction * (q.x - p.x), p.y + fraction * (q.y - p.y) };
    this->ClippedSideOf[kept] = side;
    kept += std::min(from, to) < 0.0 && std::max(from, to) > 0.0 ? 1 : 0;
  }
  if (kept < 3)
  {
    return false;
  }
  this->Clipped.resize(kept);
  this->ClippedSideOf.resize(kept);
  std::swap(this->Corners, this->Clipped);
  std::swap(this->SideOf, this->ClippedSideOf);
  return true;
}

/**
 * A line through a leftmost vertex, and three far enough from the others that no vertex is on them:
 * three lines through one point take exact numbers to tell.
 */
void PolygonKernelFinder::Start(
  const Point2& leftmost, std::size_t size, const Point2& low, const Point2& high)
{
  const Point2 margin = high - low;
  const double right = high.x + margin.x;
  const Point2 corners[] = { { low.x, high.y + margin.y }, { low.x, low.y - margin.y },
    { right, low.y - margin.y }, { right, high.y + margin.y } };
  this->Lines.clear();
  for (std::size_t i = 0; i < 4; ++i)
  {
    const std::size_t next = (i + 1) % 4;
    this->Lines.push_back({ corners[i], corners[next], next, (i + 3) % 4, corners[next], true });
  }
  this->Lines[0].To = leftmost;
  this->First = 0;
  this->Last = 0;
  // Seen from a point of the kernel the boundary goes round once, and what a vertex sees less than
  // one and a half times: so no end of a line is passed more than twice
  // by either end of that, and once when it is cut off.
  this->Steps = 5 * (4 + 2 * size);
}

/** False if nothing is left. */
bool PolygonKernelFinder::CutAll(PolygonView polygon, std::size_t first)
{
  const std::size_t size = polygon.size();
  Point2 before = this->Lines[0].From;
  Point2 from = polygon[first];
  bool isFirst = true;
  for (std::size_t i = 0; i < size; ++i)
  {
    ++first;
    first = first == size ? 0 : first;
    const Point2 to = polygon[first];
    if (to == from)
    {
      continue;
    }
    const int turn = isFirst ? 1 : Orientation(before, from, to); // from the left side of the box
    if (turn == 0 ? Dot(from - before, to - from) < 0.0 : !this->Cut(from, to, turn > 0))
    {
      return false;
    }
    if (!this->Move(to))
    {
      return false;
    }
    isFirst = false;
    before = from;
    from = to;
  }
  return true;
}

/** Cuts off what is to the right of a line through the last vertex. False if nothing is left. */
bool PolygonKernelFinder::Cut(const Point2& from, const Point2& to, bool left)
{
  const Line cut = { from, to, 0, 0, {}, false };
  // What lies to the right begins at the end of what the vertex sees.
  const std::size_t start = left ? this->Last : this->Lines[this->First].Previous;
  if (this->SideOfEnd(start, cut) >= 0)
  {
    return true;
  }
  std::size_t before = start;
  while (this->SideOfEnd(this->Lines[before].Previous, cut) <= 0)
  {
    before = this->Lines[before].Previous;
    if (before == this->Lines[start].Next || this->Steps-- == 0)
    {
      return false;
    }
  }
  std::size_t after = this->Lines[start].Next;
  while (this->SideOfEnd(after, cut) <= 0)
  {
    after = this->Lines[after].Next;
    if (this->Steps-- == 0)
    {
      return false;
    }
  }
  const std::size_t added = this->Lines.size();
  this->Lines.push_back(cut);
  this->Join(before, added);
  this->Join(added, after);
  (left ? this->Last : this->First) = added;
  return true;
}

/** Puts one line after another, and their intersection where that is a point as given. */
void PolygonKernelFinder::Join(std::size_t before, std::size_t after)
{
  Line& a = this->Lines[before];
  Line& b = this->Lines[after];
  a.Next = after;
  b.Previous = before;
  a.IsEndExact = true;
  if (a.To == b.From)
  {
    a.End = a.To;
  }
  else if (a.From == b.To) // around a reflex vertex
  {
    a.End = a.From;
  }
  else if (a.From.x == a.To.x && b.From.y == b.To.y)
  {
    a.End = { a.From.x, b.From.y };
  }
  else if (a.From.y == a.To.y && b.From.x == b.To.x)
  {
    a.End = { b.From.x, a.From.y };
  }
  else
  {
    a.IsEndExact = false;
  }
}

/** On which side of a cut a line meets the next. */
int PolygonKernelFinder::SideOfEnd(std::size_t line, const Line& cut) const
{
  const Line& a = this->Lines[line];
  if (a.IsEndExact)
  {
    const bool isOn = a.End == cut.From || a.End == cut.To; // known without exact numbers
    return isOn ? 0 : Orientation(cut.From, cut.To, a.End);
  }
  const Line& b = this->Lines[a.Next];
  return OrientationOfIntersection(cut.From, cut.To, a.From, a.To, b.From, b.To);
}

/** Along the last line: what is seen of the rest goes round counter-clockwise. */
bool PolygonKernelFinder::Move(const Point2& vertex)
{
  const auto Place = [&](std::size_t index)
  {
    const Line& line = this->Lines[index];
    const bool isOn = vertex == line.From || vertex == line.To;
    return isOn ? 0 : Orientation(line.From, line.To, vertex);
  };
  while (Place(this->Lines[this->Last].Next) <= 0)
  {
    this->Last = this->Lines[this->Last].Next;
    if (this->Steps-- == 0)
    {
      return false;
    }
  }
  while (this->First != this->Last && Place(this->First) > 0)
  {
    this->First = this->Lines[this->First].Next;
    if (this->Steps-- == 0)
    {
      return false;
    }
  }
  return true;
}

/** The lines that are left as sides, less those that are parallel to the one before to rounding. */
void PolygonKernelFinder::Collect(const Point2& origin)
{
  constexpr double Rounding = 1e-15;
  std::size_t line = this->Last;
  do
  {
    const Line& a = this->Lines[line];
    const Line& b = this->Lines[a.Next];
    const Point2 along = a.To - a.From;
    const Point2 direction = b.To - b.From;
    const double left = along.x * direction.y;
    const double right = along.y * direction.x;
    if (a.IsEndExact)
    {
      this->Sides.push_back({ a.End - origin, direction });
    }
    else if (left - right > Rounding * (std::abs(left) + std::abs(right)))
    {
      const double fraction = Cross(b.From - a.From, direction) / (left - right);
      const Point2 from = a.From - origin;
      this->Sides.push_back(
        { { from.x + fraction * along.x, from.y + fraction * along.y }, direction });
    }
    line = a.Next;
  } while (line != this->Last);
}

double PolygonKernelFinder::GetArea() const
{
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < this->Sides.size(); ++i)
  {
    const Point2& origin = this->Sides[0].Start;
    sum += Cross(this->Sides[i].Start - origin, this->Sides[i + 1].Start - origin);
  }
  return std::max(0.0, 0.5 * sum);
}

std::vector<Point2> PolygonKernel(PolygonView polygon)
{
  if (polygon.size() >= 3 && IsConvex(polygon))
  {
    return { polygon.begin(), polygon.end() }; // to the bit
  }
  PolygonKernelFinder finder;
  std::vector<Point2> kernel;
  for (const PolygonKernelFinder::Side& side : finder.Find(polygon, false))
  {
    kernel.push_back(side.Start + polygon[0]);
  }
  return kernel;
}

} // namespace pemesh
