// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RandomPolygon.h"

#include "RandomNumbers.h"
#include "VertexWalk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pemesh
{

namespace
{

constexpr double TriesPerVertex = 8.0;
constexpr double LargestGap = 0.45; ///< in turns, below the half turn of a star-shaped polygon

/** The sum of x^(first + 2k) (-1)^k / (first + 2k)!, to more than double precision for x < 0.8. */
double AlternatingSeries(double x, int first)
{
  double sum = 0.0;
  for (int power = first + 16; power > first; power -= 2)
  {
    sum = (1.0 - sum) * x * x / (power * (power - 1));
  }
  return (1.0 - sum) * (first == 0 ? 1.0 : x);
}

/** (cos, sin) of an angle in turns from [0, 1); unlike those of libraries, the same everywhere. */
Point2 Direction(double turns)
{
  const int eighth = std::min(static_cast<int>(turns * 8.0), 7);
  const bool isMirrored = eighth % 2 == 1; // measured from the other end of the quarter
  const double rest = isMirrored ? (eighth + 1) * 0.125 - turns : turns - eighth * 0.125;
  const double angle = 2.0 * std::numbers::pi * rest;
  double x = AlternatingSeries(angle, 0);
  double y = AlternatingSeries(angle, 1);
  if (isMirrored)
  {
    std::swap(x, y);
  }
  const Point2 quarters[] = { { x, y }, { -y, x }, { -x, -y }, { y, -x } };
  return quarters[eighth / 2];
}

/** The angles between consecutive vertices in turns, which add up to 1. */
std::vector<double> DrawGaps(const RandomPolygonOptions& options, RandomNumbers& random)
{
  std::vector<double> gaps(static_cast<std::size_t>(options.Vertices));
  double sum = 0.0;
  for (double& gap : gaps)
  {
    gap = 1.0 + 0.9 * options.Irregularity * random.Between(-1.0, 1.0);
    sum += gap;
  }
  double largest = 0.0;
  for (double& gap : gaps)
  {
    gap /= sum;
    largest = std::max(largest, gap);
  }
  const double mean = 1.0 / options.Vertices;
  const double share = largest > LargestGap ? (LargestGap - mean) / (largest - mean) : 1.0;
  for (double& gap : gaps)
  {
    gap = mean + share * (gap - mean);
  }
  return gaps;
}

std::vector<Point2> MakeStarShaped(
  const RandomPolygonOptions& options, double t, RandomNumbers& random)
{
  const std::vector<double> gaps = DrawGaps(options, random);
  const double mean = 1.0 / options.Vertices;
  std::vector<Point2> vertices;
  vertices.reserve(gaps.size());
  double angle = 0.25; // the first vertex of a regular polygon is above the middle
  for (const double gap : gaps)
  {
    const double radius = 1.0 - t * 0.9 * options.Spikiness * random.Uniform();
    const Point2 direction = Direction(angle - std::floor(angle));
    vertices.push_back({ radius * direction.x, radius * direction.y });
    angle += mean + t * (gap - mean);
  }
  return vertices;
}

} // namespace

std::vector<Point2> MakeRandomPolygon(const RandomPolygonOptions& options, double t)
{
  const double time = std::isnan(t) ? 0.0 : std::clamp(t, 0.0, 1.0);
  const double tangle = options.Vertices > 3 ? options.Tangle : 0.0;
  const double share = 1.0 / (1.0 + tangle);
  RandomNumbers random(options.Seed);
  std::vector<Point2> vertices = MakeStarShaped(options, std::min(time / share, 1.0), random);
  if (time <= share)
  {
    return vertices;
  }
  const double tries = TriesPerVertex * tangle * options.Vertices;
  VertexWalk walk(std::move(vertices), random);
  walk.Go(tries * (time - share) / (1.0 - share));
  return walk.GetVertices();
}

} // namespace pemesh
