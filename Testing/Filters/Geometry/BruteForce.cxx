// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BruteForce.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace pemesh::test
{

namespace
{

using Rational = CGAL::Exact_rational;
using Real = long double;

struct ExactPoint
{
  Rational x;
  Rational y;
};

Rational Shoelace(const std::vector<ExactPoint>& polygon)
{
  Rational sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const ExactPoint& a = polygon[i];
    const ExactPoint& b = polygon[(i + 1) % polygon.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum / 2;
}

std::vector<ExactPoint> ToExact(PolygonView polygon)
{
  std::vector<ExactPoint> exact;
  for (const Point2& p : polygon)
  {
    exact.push_back({ Rational(p.x), Rational(p.y) });
  }
  return exact;
}

struct Vector
{
  Real x = 0;
  Real y = 0;
};

Real DistanceToSegment(const Vector& p, const Vector& a, const Vector& b)
{
  const Real dx = b.x - a.x;
  const Real dy = b.y - a.y;
  const Real t =
    std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), Real(0), Real(1));
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

bool IsInside(const Vector& p, const std::vector<Vector>& polygon)
{
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector& a = polygon[i];
    const Vector& b = polygon[(i + 1) % polygon.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y))
    {
      inside = !inside;
    }
  }
  return inside;
}

Real DistanceToBoundary(const Vector& p, const std::vector<Vector>& polygon)
{
  Real distance = INFINITY;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    distance =
      std::min(distance, DistanceToSegment(p, polygon[i], polygon[(i + 1) % polygon.size()]));
  }
  return distance;
}

/**
 * A line (left normal n, r = n.c - n.a) or a point (s = 2 p.c - |p|^2, s = |c|^2 - r^2) as one
 * linear equation in (x, y, r, s).
 */
using Equation = std::array<Real, 5>;

std::vector<Equation> Features(const std::vector<Vector>& polygon, bool withPoints)
{
  std::vector<Equation> features;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector& a = polygon[i];
    const Vector& b = polygon[(i + 1) % polygon.size()];
    const Real length = std::hypot(b.x - a.x, b.y - a.y);
    const Real nx = -(b.y - a.y) / length;
    const Real ny = (b.x - a.x) / length;
    if (!(length > 0))
    {
      continue;
    }
    features.push_back({ nx, ny, -1, 0, nx * a.x + ny * a.y });
    const Vector& c = polygon[(i + polygon.size() - 1) % polygon.size()];
    // A circle inside cannot touch a vertex that is not reflex, other than by its edges.
    if (withPoints && (a.x - c.x) * (b.y - a.y) - (a.y - c.y) * (b.x - a.x) <= 0)
    {
      features.push_back({ 2 * a.x, 2 * a.y, 0, -1, a.x * a.x + a.y * a.y });
    }
  }
  return features;
}

/** Reduces three equations; returns the free column, or -1 if they are dependent. */
int Eliminate(std::array<Equation, 3>& rows, std::array<int, 3>& pivots)
{
  std::array<bool, 4> used = {};
  for (std::size_t i = 0; i < 3; ++i)
  {
    int best = -1;
    std::size_t bestRow = i;
    for (std::size_t k = i; k < 3; ++k)
    {
      for (int j = 0; j < 4; ++j)
      {
        const auto column = static_cast<std::size_t>(j);
        if (!used[column] &&
          (best < 0 ||
            std::abs(rows[k][column]) > std::abs(rows[bestRow][static_cast<std::size_t>(best)])))
        {
          best = j;
          bestRow = k;
        }
      }
    }
    const auto pivot = static_cast<std::size_t>(best);
    if (std::abs(rows[bestRow][pivot]) < 1e-15L)
    {
      return -1;
    }
    std::swap(rows[i], rows[bestRow]);
    used[pivot] = true;
    pivots[i] = best;
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (k != i)
      {
        const Real factor = rows[k][pivot] / rows[i][pivot];
        for (std::size_t j = 0; j < 5; ++j)
        {
          rows[k][j] -= factor * rows[i][j];
        }
      }
    }
  }
  return static_cast<int>(std::find(used.begin(), used.end(), false) - used.begin());
}

/** The circles (x, y, r) with three features, as up to two solutions. */
std::vector<std::array<Real, 3>> Touching(std::array<Equation, 3> rows)
{
  std::array<int, 3> pivots;
  const int free = Eliminate(rows, pivots);
  if (free < 0)
  {
    return {};
  }
  std::array<Real, 4> base = {};
  std::array<Real, 4> along = {};
  along[static_cast<std::size_t>(free)] = 1;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto pivot = static_cast<std::size_t>(pivots[i]);
    base[pivot] = rows[i][4] / rows[i][pivot];
    along[pivot] = -rows[i][static_cast<std::size_t>(free)] / rows[i][pivot];
  }
  // x^2 + y^2 - r^2 - s = 0 on the line base + t along.
  const Real a = along[0] * along[0] + along[1] * along[1] - along[2] * along[2];
  const Real b = 2 * (base[0] * along[0] + base[1] * along[1] - base[2] * along[2]) - along[3];
  const Real c = base[0] * base[0] + base[1] * base[1] - base[2] * base[2] - base[3];
  std::vector<Real> roots;
  const Real discriminant = std::max(Real(0), b * b - 4 * a * c);
  const Real q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
  if (a != 0)
  {
    roots.push_back(q / a);
  }
  if (q != 0)
  {
    roots.push_back(c / q);
  }
  std::vector<std::array<Real, 3>> circles;
  for (const Real t : roots)
  {
    circles.push_back({ base[0] + t * along[0], base[1] + t * along[1], base[2] + t * along[2] });
  }
  return circles;
}

/** The greatest `score` of a centre where three features are equally far. */
template <typename Score>
Real BestTouching(const std::vector<Equation>& features, Score&& score)
{
  Real best = 0;
  for (std::size_t i = 0; i < features.size(); ++i)
  {
    for (std::size_t j = i + 1; j < features.size(); ++j)
    {
      for (std::size_t k = j + 1; k < features.size(); ++k)
      {
        for (const auto& circle : Touching({ features[i], features[j], features[k] }))
        {
          if (std::abs(circle[2]) > best)
          {
            best = std::max(best, score({ circle[0], circle[1] }));
          }
        }
      }
    }
  }
  return best;
}

/** The polygon as extended numbers about its first vertex, times a power of two of size 1. */
struct RealPolygon
{
  std::vector<Vector> Vertices;
  Real Unit = 1;
};

RealPolygon ToReal(PolygonView polygon)
{
  RealPolygon result;
  Real largest = 0;
  for (const Point2& p : polygon)
  {
    result.Vertices.push_back({ Real(p.x) - polygon[0].x, Real(p.y) - polygon[0].y });
    const Vector& last = result.Vertices.back();
    largest = std::max({ largest, std::abs(last.x), std::abs(last.y) });
  }
  result.Unit = largest > 0 ? std::ldexp(Real(1), std::ilogb(largest)) : Real(1);
  for (Vector& p : result.Vertices)
  {
    p = { p.x / result.Unit, p.y / result.Unit };
  }
  return result;
}

Real Distance(const Vector& p, const Vector& q)
{
  return std::hypot(p.x - q.x, p.y - q.y);
}

/** Half the longest side of a triangle with no acute angle there, else the circumradius. */
Real EnclosingRadiusOfThree(const Vector& p, const Vector& q, const Vector& r)
{
  std::array<Real, 3> sides = { Distance(q, r), Distance(r, p), Distance(p, q) };
  std::sort(sides.begin(), sides.end());
  if (sides[0] * sides[0] + sides[1] * sides[1] <= sides[2] * sides[2])
  {
    return sides[2] / 2;
  }
  const Real cross = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  return sides[0] * sides[1] * sides[2] / (2 * std::abs(cross));
}

} // namespace

double ExactArea(PolygonView polygon)
{
  return CGAL::to_double(Shoelace(ToExact(polygon)));
}

double ExactKernelArea(PolygonView polygon)
{
  const std::vector<ExactPoint> vertices = ToExact(polygon);
  const auto [left, right] = std::minmax_element(
    vertices.begin(), vertices.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto [low, high] = std::minmax_element(
    vertices.begin(), vertices.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  std::vector<ExactPoint> kernel = { { left->x, low->y }, { right->x, low->y },
    { right->x, high->y }, { left->x, high->y } };
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const ExactPoint& a = vertices[i];
    const ExactPoint& b = vertices[(i + 1) % vertices.size()];
    const auto Side = [&](const ExactPoint& p) -> Rational
    { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); };
    std::vector<ExactPoint> clipped;
    for (std::size_t j = 0; j < kernel.size(); ++j)
    {
      const ExactPoint& p = kernel[j];
      const ExactPoint& q = kernel[(j + 1) % kernel.size()];
      const Rational from = Side(p);
      const Rational to = Side(q);
      if (from >= 0)
      {
        clipped.push_back(p);
      }
      if ((from > 0 && to < 0) || (from < 0 && to > 0))
      {
        const Rational t = from / (from - to);
        clipped.push_back({ p.x + t * (q.x - p.x), p.y + t * (q.y - p.y) });
      }
    }
    kernel = std::move(clipped);
  }
  return kernel.size() < 3 ? 0.0 : CGAL::to_double(Shoelace(kernel));
}

double BruteEnclosingRadius(PolygonView points)
{
  const RealPolygon real = ToReal(points);
  const std::vector<Vector>& p = real.Vertices;
  Real best = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    for (std::size_t j = i + 1; j < p.size(); ++j)
    {
      for (std::size_t k = j + 1; k < p.size(); ++k)
      {
        best = std::max(best, EnclosingRadiusOfThree(p[i], p[j], p[k]));
      }
    }
  }
  return static_cast<double>(best * real.Unit);
}

double BruteInscribedRadius(PolygonView polygon)
{
  const RealPolygon real = ToReal(polygon);
  // Any centre that is inside counts for what it is, so rounding can only lose a little.
  const Real best = BestTouching(Features(real.Vertices, true),
    [&](const Vector& center) {
      return IsInside(center, real.Vertices) ? DistanceToBoundary(center, real.Vertices) : Real(0);
    });
  return static_cast<double>(best * real.Unit);
}

double BruteDistanceInside(PolygonView polygon, const Point2& point)
{
  const RealPolygon real = ToReal(polygon);
  const Vector center = { (Real(point.x) - polygon[0].x) / real.Unit,
    (Real(point.y) - polygon[0].y) / real.Unit };
  const Real distance = DistanceToBoundary(center, real.Vertices);
  return static_cast<double>((IsInside(center, real.Vertices) ? distance : -distance) * real.Unit);
}

double BruteKernelRadius(PolygonView polygon)
{
  const RealPolygon real = ToReal(polygon);
  const std::vector<Equation> lines = Features(real.Vertices, false);
  const Real best = BestTouching(lines,
    [&](const Vector& center)
    {
      Real height = INFINITY;
      for (const Equation& line : lines)
      {
        height = std::min(height, line[0] * center.x + line[1] * center.y - line[4]);
      }
      return height;
    });
  return static_cast<double>(best * real.Unit);
}

BruteMeasures BruteMeasure(PolygonView polygon)
{
  const RealPolygon real = ToReal(polygon);
  const std::vector<Vector>& p = real.Vertices;
  Real largest = 0;
  Real least = INFINITY;
  Real perimeter = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    perimeter += Distance(p[i], p[(i + 1) % p.size()]);
    for (std::size_t j = i + 1; j < p.size(); ++j)
    {
      largest = std::max(largest, Distance(p[i], p[j]));
      least = std::min(least, Distance(p[i], p[j]));
    }
  }
  BruteMeasures result;
  result.Diameter = static_cast<double>(largest * real.Unit);
  result.ClosestPair = static_cast<double>(least * real.Unit);
  result.Perimeter = static_cast<double>(perimeter * real.Unit);
  result.SmallestAngle = INFINITY;
  const std::vector<ExactPoint> exact = ToExact(polygon);
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    const ExactPoint& a = exact[(i + exact.size() - 1) % exact.size()];
    const ExactPoint& b = exact[i];
    const ExactPoint& c = exact[(i + 1) % exact.size()];
    const Rational cross = (c.x - b.x) * (a.y - b.y) - (c.y - b.y) * (a.x - b.x);
    const Rational dot = (c.x - b.x) * (a.x - b.x) + (c.y - b.y) * (a.y - b.y);
    // The signs are exact, so that an angle of almost 0 cannot be taken for one of almost 2 pi.
    const double angle = std::atan2(CGAL::to_double(cross), CGAL::to_double(dot));
    const double positive = cross < 0 ? angle + 2.0 * std::numbers::pi : angle;
    result.SmallestAngle = std::min(result.SmallestAngle, positive);
    result.LargestAngle = std::max(result.LargestAngle, positive);
    result.Convex = result.Convex && cross >= 0;
  }
  return result;
}

} // namespace pemesh::test
