// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonMeasures.h"

#include "PlaneVectors.h"
#include "Predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
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

std::size_t PreviousIndex(std::size_t i, std::size_t size)
{
  return i == 0 ? size - 1 : i - 1;
}

/** The last vertex that is not a repeat of the first. */
std::size_t BeforeRepeats(PolygonView polygon)
{
  std::size_t previous = polygon.size() - 1;
  while (previous > 0 && polygon[previous] == polygon[0])
  {
    --previous;
  }
  return previous;
}

/** A sum that carries its rounding errors along: twice the precision of a double. */
class PreciseSum
{
public:
  void Add(double value)
  {
    const double sum = this->High + value;
    const double part = sum - this->High;
    this->Low += (this->High - (sum - part)) + (value - part);
    this->High = sum;
  }

  void AddProduct(double a, double b)
  {
    const double product = a * b;
    this->Add(product);
    this->Add(std::fma(a, b, -product));
  }

  double Get() const { return this->High + this->Low; }

private:
  double High = 0.0;
  double Low = 0.0;
};

/** The exact difference a - b as a rounded value and its error (D. E. Knuth's two-sum). */
struct Difference
{
  double Value;
  double Error;

  Difference(double a, double b)
    : Value(a - b)
  {
    const double virtualB = a - this->Value;
    const double virtualA = this->Value + virtualB;
    this->Error = (virtualB - b) + (a - virtualA);
  }
};

void AddProductOfDifferences(PreciseSum& sum, const Difference& a, const Difference& b, double sign)
{
  sum.AddProduct(sign * a.Value, b.Value);
  sum.AddProduct(sign * a.Value, b.Error);
  sum.AddProduct(sign * a.Error, b.Value);
}

/** Twice the area, for polygons so thin that the plain sum cancels. */
double PreciseDoubleArea(PolygonView polygon)
{
  PreciseSum sum;
  const Point2 origin = polygon[0];
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
  {
    const Difference ax(polygon[i].x, origin.x);
    const Difference ay(polygon[i].y, origin.y);
    const Difference bx(polygon[i + 1].x, origin.x);
    const Difference by(polygon[i + 1].y, origin.y);
    AddProductOfDifferences(sum, ax, by, 1.0);
    AddProductOfDifferences(sum, ay, bx, -1.0);
  }
  return sum.Get();
}

/** The cross product of (next - vertex) and (previous - vertex), its sign exact where it matters.
 */
Point2 CornerVector(const Point2& previous, const Point2& vertex, const Point2& next)
{
  const double outX = next.x - vertex.x;
  const double outY = next.y - vertex.y;
  const double backX = previous.x - vertex.x;
  const double backY = previous.y - vertex.y;
  const double left = outX * backY;
  const double right = outY * backX;
  const double dot = outX * backX + outY * backY;
  double cross = left - right;
  // Only in a needle (dot > 0) does a wrong sign change the angle, from almost 0 to almost 2 pi.
  if (dot > 0.0 && std::abs(cross) <= 1e-15 * (std::abs(left) + std::abs(right)))
  {
    // Twice the area of the corner triangle, which is exact to a rounding.
    const Point2 corner[3] = { vertex, next, previous };
    cross = PreciseDoubleArea(corner);
  }
  return { dot, cross };
}

double AngleOf(const Point2& corner)
{
  const double angle = std::atan2(corner.y, corner.x);
  return angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
}

/** Grows with the angle of a vector from 0 to 4, much cheaper than the angle itself. */
double PseudoAngle(const Point2& vector)
{
  const double sum = std::abs(vector.x) + std::abs(vector.y);
  if (!(sum > 0.0))
  {
    return 0.0;
  }
  const double fraction = vector.y / sum;
  if (vector.x < 0.0)
  {
    return 2.0 - fraction;
  }
  return fraction < 0.0 ? 4.0 + fraction : fraction;
}

} // namespace

double SignedArea(PolygonView polygon)
{
  if (polygon.size() < 3)
  {
    return 0.0;
  }
  const Point2 origin = polygon[0];
  double sum = 0.0;
  double magnitude = 0.0;
  double ax = polygon[1].x - origin.x;
  double ay = polygon[1].y - origin.y;
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    const double bx = polygon[i].x - origin.x;
    const double by = polygon[i].y - origin.y;
    const double left = ax * by;
    const double right = ay * bx;
    sum += left - right;
    magnitude += std::abs(left) + std::abs(right);
    ax = bx;
    ay = by;
  }
  return 0.5 * (std::abs(sum) > 1e-3 * magnitude ? sum : PreciseDoubleArea(polygon));
}

int PolygonOrientation(PolygonView polygon)
{
  const std::size_t size = polygon.size();
  if (size < 3)
  {
    return 0;
  }
  const auto lowest = std::min_element(polygon.begin(), polygon.end(), IsLexicographicallyLess);
  const auto start = static_cast<std::size_t>(lowest - polygon.begin());
  std::size_t previous = PreviousIndex(start, size);
  while (previous != start && polygon[previous] == *lowest)
  {
    previous = PreviousIndex(previous, size);
  }
  std::size_t next = NextIndex(start, size);
  while (next != start && polygon[next] == *lowest)
  {
    next = NextIndex(next, size);
  }
  const int turn = Orientation(polygon[previous], *lowest, polygon[next]);
  if (turn != 0)
  {
    return turn;
  }
  // The boundary comes back on itself here (a needle of no width): the area decides.
  const double area = SignedArea(polygon);
  return area > 0.0 ? 1 : (area < 0.0 ? -1 : 0);
}

EdgeLengths MeasureEdges(PolygonView polygon)
{
  EdgeLengths edges;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& a = polygon[i];
    const Point2& b = polygon[NextIndex(i, polygon.size())];
    const double x = b.x - a.x;
    const double y = b.y - a.y;
    const double length = std::sqrt(x * x + y * y);
    edges.Shortest = i == 0 ? length : std::min(edges.Shortest, length);
    edges.Longest = std::max(edges.Longest, length);
    edges.Perimeter += length;
  }
  return edges;
}

double Perimeter(PolygonView polygon)
{
  return MeasureEdges(polygon).Perimeter;
}

Point2 Centroid(PolygonView polygon)
{
  if (polygon.empty())
  {
    return {};
  }
  const Point2 origin = polygon[0];
  const double doubleArea = 2.0 * SignedArea(polygon);
  Point2 moment;
  Point2 mean;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& p = polygon[i];
    const Point2& q = polygon[NextIndex(i, polygon.size())];
    const double ax = p.x - origin.x;
    const double ay = p.y - origin.y;
    const double bx = q.x - origin.x;
    const double by = q.y - origin.y;
    const double cross = ax * by - ay * bx;
    moment.x += cross * (ax + bx);
    moment.y += cross * (ay + by);
    mean.x += ax;
    mean.y += ay;
  }
  const auto count = static_cast<double>(polygon.size());
  Point2 offset = { mean.x / count, mean.y / count };
  if (doubleArea != 0.0)
  {
    offset = { moment.x / (3.0 * doubleArea), moment.y / (3.0 * doubleArea) };
  }
  return { origin.x + offset.x, origin.y + offset.y };
}

std::vector<double> InteriorAngles(PolygonView polygon)
{
  const std::size_t size = polygon.size();
  std::vector<double> angles(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    angles[i] = AngleOf(
      CornerVector(polygon[PreviousIndex(i, size)], polygon[i], polygon[NextIndex(i, size)]));
  }
  return angles;
}

AngleRange MeasureAngles(PolygonView polygon)
{
  const std::size_t size = polygon.size();
  if (size < 3)
  {
    return {};
  }
  Point2 smallest;
  Point2 largest;
  double least = 5.0;
  double greatest = -1.0;
  std::size_t previous = BeforeRepeats(polygon);
  for (std::size_t i = 0; i < size; ++i)
  {
    const Point2& next = polygon[NextIndex(i, size)];
    if (next == polygon[i])
    {
      continue; // the last of the repeats counts
    }
    const Point2 corner = CornerVector(polygon[previous], polygon[i], next);
    previous = i;
    const double pseudo = PseudoAngle(corner);
    if (pseudo < least)
    {
      least = pseudo;
      smallest = corner;
    }
    if (pseudo > greatest)
    {
      greatest = pseudo;
      largest = corner;
    }
  }
  return { AngleOf(smallest), AngleOf(largest) };
}

bool IsConvex(PolygonView polygon)
{
  const std::size_t size = polygon.size();
  if (size < 3)
  {
    return false;
  }
  int reversals = 0; // changes of the lexicographic direction: two in one round
  std::size_t previous = BeforeRepeats(polygon);
  bool wasForward = IsLexicographicallyLess(polygon[previous], polygon[0]);
  for (std::size_t i = 0; i < size; ++i)
  {
    const Point2& b = polygon[i];
    const Point2& c = polygon[NextIndex(i, size)];
    if (b == c)
    {
      continue; // the last of the repeats counts
    }
    const bool forward = IsLexicographicallyLess(b, c);
    reversals += forward != wasForward ? 1 : 0;
    wasForward = forward;
    if (reversals > 2 || Orientation(polygon[previous], b, c) < 0)
    {
      return false;
    }
    previous = i;
  }
  return true;
}

} // namespace pemesh
