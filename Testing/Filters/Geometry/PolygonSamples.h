// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Polygons to test kernels with: seeded random ones of several kinds, the hard cases, and maps of
 * the plane. Everything is made from raw generator bits, so it is the same on every machine.
 */
#ifndef PolygonSamples_h
#define PolygonSamples_h

#include "PolygonMeasures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace pemesh::test
{

using Polygon = std::vector<Point2>;

class Random
{
public:
  explicit Random(std::uint64_t seed)
    : Bits(seed)
  {
  }

  double Uniform(double low = 0.0, double high = 1.0)
  {
    return low + (high - low) * 0x1.0p-53 * static_cast<double>(this->Bits() >> 11);
  }

  int Integer(int low, int high)
  {
    return low + static_cast<int>(this->Bits() % static_cast<std::uint64_t>(high - low + 1));
  }

private:
  std::mt19937_64 Bits;
};

/** Star-shaped about the origin, with radii that vary as much as `spread` in [0, 1). */
inline Polygon StarShaped(Random& random, int size, double spread)
{
  Polygon polygon;
  for (int i = 0; i < size; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * (i + random.Uniform(0.0, 0.9)) / size;
    const double radius = 1.0 - spread * random.Uniform();
    polygon.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
  }
  return polygon;
}

/** Vertices on an ellipse of axes 1 and `flatness`. */
inline Polygon ConvexPolygon(Random& random, int size, double flatness)
{
  Polygon polygon = StarShaped(random, size, 0.0);
  for (Point2& point : polygon)
  {
    point.y *= flatness;
  }
  return polygon;
}

/** Random points joined in random order, then untangled by reversing between crossing edges. */
inline Polygon Untangled(Random& random, int size)
{
  Polygon polygon;
  for (int i = 0; i < size; ++i)
  {
    polygon.push_back({ random.Uniform(), random.Uniform() });
  }
  const auto Distance = [](const Point2& a, const Point2& b)
  { return std::hypot(a.x - b.x, a.y - b.y); };
  for (bool changed = true; changed;)
  {
    changed = false;
    for (std::size_t i = 0; i + 1 < polygon.size(); ++i)
    {
      for (std::size_t j = i + 2; j < polygon.size(); ++j)
      {
        const Point2& a = polygon[i];
        const Point2& b = polygon[i + 1];
        const Point2& c = polygon[j];
        const Point2& d = polygon[(j + 1) % polygon.size()];
        if (a == d)
        {
          continue;
        }
        // Two edges that cross are longer than the two that replace them, so this ends.
        if (Distance(a, c) + Distance(b, d) < Distance(a, b) + Distance(c, d) - 1e-12)
        {
          std::reverse(polygon.begin() + static_cast<std::ptrdiff_t>(i) + 1,
            polygon.begin() + static_cast<std::ptrdiff_t>(j) + 1);
          changed = true;
        }
      }
    }
  }
  if (PolygonOrientation(polygon) < 0)
  {
    std::reverse(polygon.begin(), polygon.end());
  }
  return polygon;
}

/** Adds a point on some edges: on the line to rounding, as hanging vertices of meshes are. */
inline Polygon WithHangingVertices(Random& random, const Polygon& polygon)
{
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    result.push_back(a);
    if (random.Uniform() < 0.5)
    {
      const double fraction = random.Uniform(0.05, 0.95);
      result.push_back({ a.x + fraction * (b.x - a.x), a.y + fraction * (b.y - a.y) });
    }
  }
  return result;
}

/** Random simple polygons, counter-clockwise, of all kinds in turn. */
inline Polygon RandomPolygon(std::uint64_t seed, int minimumSize, int maximumSize)
{
  Random random(seed);
  const int size = random.Integer(minimumSize, maximumSize);
  switch (seed % 4)
  {
    case 0:
      return StarShaped(random, std::max(size, 4), random.Uniform(0.1, 0.95));
    case 1:
      return ConvexPolygon(random, std::max(size, 4), random.Uniform(0.05, 1.0));
    case 2:
      return Untangled(random, size);
    default:
      return WithHangingVertices(random, Untangled(random, std::max(3, size / 2)));
  }
}

inline Polygon RegularPolygon(int size, double radius = 1.0)
{
  Polygon polygon;
  for (int i = 0; i < size; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * i / size;
    polygon.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
  }
  return polygon;
}

inline Polygon UnitSquare()
{
  return { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };
}

/** The family Convexity of M. Attene et al. (2021). */
inline Polygon ConvexityFamily(double t)
{
  return { { t, t }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };
}

/** The family Maze of M. Attene et al. (2021): 22 vertices, straight ones among them. */
inline Polygon MazeFamily(double t)
{
  const auto L = [t](double ax, double ay, double bx, double by) {
    return Point2{ ax * (1.0 - t) + bx * t, ay * (1.0 - t) + by * t };
  };
  return { { 0, 1 }, { 0, .75 }, { 0, .5 }, { 0, .25 }, { 0, 0 }, { .25, 0 }, { .5, 0 }, { .75, 0 },
    { 1, 0 }, { 1, .25 }, { 1, .5 }, { 1, .75 }, { .75, .75 }, { .5, .75 }, L(.5, .5, .5, .745),
    L(.75, .5, .995, .745), L(.75, .25, .995, .005), L(.5, .25, .5, .005), L(.25, .25, .005, .005),
    L(.25, .5, .005, .5), L(.25, .75, .005, .75), L(.25, 1, .005, 1) };
}

/** A star of `spikes` spikes, radii 1 and 1.8. */
inline Polygon StarFamily(int spikes)
{
  Polygon polygon = RegularPolygon(2 * spikes);
  for (std::size_t i = 0; i < polygon.size(); i += 2)
  {
    polygon[i] = { 1.8 * polygon[i].x, 1.8 * polygon[i].y };
  }
  return polygon;
}

struct NamedPolygon
{
  std::string Name;
  Polygon Vertices;
};

/** What a kernel must survive; all simple and counter-clockwise. */
inline std::vector<NamedPolygon> HardPolygons()
{
  std::vector<NamedPolygon> cases = {
    { "a vertex 1e-12 inside a straight line", { { 0, 0 }, { .5, 1e-12 }, { 1, 0 }, { .5, 1 } } },
    { "a vertex 1e-12 outside a straight line", { { 0, 0 }, { .5, -1e-12 }, { 1, 0 }, { .5, 1 } } },
    { "straight vertices", { { 0, 0 }, { .25, 0 }, { .5, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } },
    { "two edges on one line",
      { { 0, 0 }, { 1, 0 }, { 1, .5 }, { 2, .5 }, { 2, 0 }, { 3, 0 }, { 3, 1 }, { 0, 1 } } },
    { "a needle", { { 0, 0 }, { 1, 0 }, { 1, 1e-8 }, { 0, 1e-8 } } },
    { "a needle with a notch", { { 0, 0 }, { 1, 0 }, { 1, 1e-8 }, { .5, .5e-8 }, { 0, 1e-8 } } },
    { "a reflex spike that almost touches the opposite side",
      { { 0, 0 }, { 1, 0 }, { 1, 1 }, { .5 + 1e-3, 1 }, { .5, 1e-10 }, { .5 - 1e-3, 1 },
        { 0, 1 } } },
    { "vertices 1e-14 apart",
      { { 0, 0 }, { 1, 0 }, { 1, 1 }, { .5, .3 }, { .5 - 1e-14, .3 }, { 0, 1 } } },
    { "a 1e-12 thin zigzag",
      { { 0, 0 }, { 1, 1e-12 }, { 2, 0 }, { 2, 1e-12 }, { 1, 2e-12 }, { 0, 1e-12 } } },
    { "a maze at its end", MazeFamily(0.9) },
    { "a maze near the limit", MazeFamily(0.999) },
    { "a star", StarFamily(40) },
    { "a collapsing family", ConvexityFamily(0.99999) },
    { "corridors between hanging vertices",
      { { 0, 0 }, { .3, 0 }, { .7, 0 }, { 1, 0 }, { 1.1, 0 }, { 1.1, .7 }, { 1.1, 1.3 }, { 1.1, 2 },
        { 1, 2 }, { 1, 1.1 }, { 1, .6 }, { 1, .1 }, { .8, .1 }, { .2, .1 }, { 0, .1 } } },
  };
  return cases;
}

/** Rotated, then scaled, then moved. */
inline Polygon Transformed(const Polygon& polygon, double angle, double scale, const Point2& offset)
{
  Polygon result;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (const Point2& p : polygon)
  {
    result.push_back(
      { offset.x + scale * (c * p.x - s * p.y), offset.y + scale * (s * p.x + c * p.y) });
  }
  return result;
}

} // namespace pemesh::test

#endif
