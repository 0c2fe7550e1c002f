// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BruteForce.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
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
    features.push_back({ nx, ny, -1, 0, nx * a.x + ny * a.y });
    if (withPoints)
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

std::vector<Vector> ToReal(PolygonView polygon)
{
  std::vector<Vector> result;
  for (const Point2& p : polygon)
  {
    result.push_back({ Real(p.x) - polygon[0].x, Real(p.y) - polygon[0].y });
  }
  return result;
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
  const std::vector<Vector> p = ToReal(points);
  Real best = INFINITY;
  const auto Try = [&](const Vector& center, Real radius)
  {
    if (radius < best &&
      std::all_of(p.begin(), p.end(),
        [&](const Vector& q)
        { return std::hypot(q.x - center.x, q.y - center.y) <= radius * (1 + 1e-16L); }))
    {
      best = radius;
    }
  };
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    for (std::size_t j = i + 1; j < p.size(); ++j)
    {
      Try({ (p[i].x + p[j].x) / 2, (p[i].y + p[j].y) / 2 },
        std::hypot(p[i].x - p[j].x, p[i].y - p[j].y) / 2);
      for (std::size_t k = j + 1; k < p.size(); ++k)
      {
        const Real bx = p[j].x - p[i].x;
        const Real by = p[j].y - p[i].y;
        const Real cx = p[k].x - p[i].x;
        const Real cy = p[k].y - p[i].y;
        const Real cross = 2 * (bx * cy - by * cx);
        if (cross != 0)
        {
          const Real x = (cy * (bx * bx + by * by) - by * (cx * cx + cy * cy)) / cross;
          const Real y = (bx * (cx * cx + cy * cy) - cx * (bx * bx + by * by)) / cross;
          Try({ p[i].x + x, p[i].y + y }, std::hypot(x, y));
        }
      }
    }
  }
  return static_cast<double>(best);
}

double BruteInscribedRadius(PolygonView polygon)
{
  const std::vector<Vector> vertices = ToReal(polygon);
  // Any centre that is inside counts for what it is, so rounding can only lose a little.
  return static_cast<double>(BestTouching(Features(vertices, true),
    [&](const Vector& center)
    { return IsInside(center, vertices) ? DistanceToBoundary(center, vertices) : Real(0); }));
}

double BruteKernelRadius(PolygonView polygon)
{
  const std::vector<Equation> lines = Features(ToReal(polygon), false);
  return static_cast<double>(BestTouching(lines,
    [&](const Vector& center)
    {
      Real height = INFINITY;
      for (const Equation& line : lines)
      {
        height = std::min(height, line[0] * center.x + line[1] * center.y - line[4]);
      }
      return height;
    }));
}

} // namespace pemesh::test
