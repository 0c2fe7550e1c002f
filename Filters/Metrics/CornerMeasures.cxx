// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CornerMeasures.h"

#include "PlaneVectors.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

/** The vertex after (before) vertex i. */
const Point2& After(PolygonView polygon, std::size_t i)
{
  return polygon[i + 1 == polygon.size() ? 0 : i + 1];
}
const Point2& Before(PolygonView polygon, std::size_t i)
{
  return polygon[i == 0 ? polygon.size() - 1 : i - 1];
}

} // namespace

bool IsStraight(const Point2& a, const Point2& b, const Point2& c, double distance)
{
  const Point2 back = a - b;
  const Point2 out = c - b;
  if (Dot(back, out) >= 0.0)
  {
    return false;
  }
  const double cross = Cross(out, back); // twice the area of the triangle: chord times distance
  return cross * cross <= distance * distance * SquaredDistance(a, c);
}

CornerShapes MeasureCorners(PolygonView polygon)
{
  CornerShapes shapes;
  Point2 in = polygon.front() - polygon.back();
  double inSquare = Dot(in, in);
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2 out = After(polygon, i) - polygon[i];
    const double outSquare = Dot(out, out);
    const double cross = Cross(in, out);
    shapes.SmallestSine = std::min(shapes.SmallestSine, cross / std::sqrt(inSquare * outSquare));
    shapes.SmallestFrobeniusRatio =
      std::min(shapes.SmallestFrobeniusRatio, 2.0 * std::abs(cross) / (inSquare + outSquare));
    in = out;
    inSquare = outSquare;
  }
  return shapes;
}

double SmallestSideRatio(PolygonView polygon, double distance)
{
  const std::size_t size = polygon.size();
  const auto IsStraightAt = [&](std::size_t i)
  { return IsStraight(Before(polygon, i), polygon[i], After(polygon, i), distance); };
  bool isAnyStraight = false;
  Point2 in = polygon.front() - polygon.back();
  for (std::size_t i = 0; i < size && !isAnyStraight; ++i)
  {
    const Point2 out = After(polygon, i) - polygon[i];
    const double cross = Cross(in, out);
    // The square of the chord is at most twice the sum of those of the edges, and rounding.
    isAnyStraight =
      cross * cross <= 2.1 * distance * distance * (Dot(in, in) + Dot(out, out)) && IsStraightAt(i);
    in = out;
  }
  if (!isAnyStraight)
  {
    return 1.0;
  }
  std::size_t start = 0; // the first corner, so that no side goes on over the end of the list
  while (start < size && IsStraightAt(start))
  {
    ++start;
  }
  double ratio = 1.0;
  double shortest = 0.0;
  double longest = 0.0;
  for (std::size_t k = 0; k < size; ++k)
  {
    const std::size_t i = (start + k) % size;
    const double square = SquaredDistance(polygon[i], After(polygon, i));
    const bool goesOn = k > 0 && IsStraightAt(i);
    shortest = goesOn ? std::min(shortest, square) : square;
    longest = goesOn ? std::max(longest, square) : square;
    if (goesOn)
    {
      ratio = std::min(ratio, std::sqrt(shortest / longest));
    }
  }
  return ratio;
}

} // namespace pemesh
