// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Domain.h"

#include "PolygonMeasures.h"
#include "PolygonValidity.h"

#include <algorithm>

namespace pemesh
{

namespace
{

std::string NameOf(std::size_t loop)
{
  return "loop " + std::to_string(loop + 1) + " of the domain";
}

std::string FindFault(const Domain& domain)
{
  for (std::size_t i = 0; i < domain.Holes.size(); ++i)
  {
    const std::string hole = "Hole " + std::to_string(i + 1) + " of the domain ";
    if (DoBoundariesMeet(domain.Holes[i], domain.Outer))
    {
      return hole + "touches or crosses its outer loop; move it inwards.";
    }
    if (RelatePolygons(domain.Holes[i], domain.Outer) != PolygonRelation::FirstInsideSecond)
    {
      return hole + "lies beside its outer loop; a domain is one piece.";
    }
    for (std::size_t j = 0; j < i; ++j)
    {
      if (RelatePolygons(domain.Holes[i], domain.Holes[j]) != PolygonRelation::Apart)
      {
        return "Holes " + std::to_string(j + 1) + " and " + std::to_string(i + 1) +
          " of the domain meet; move them apart.";
      }
    }
  }
  return {};
}

} // namespace

Domain UnitSquare()
{
  return { { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } }, {} };
}

std::string MakeDomain(std::vector<std::vector<Point2>> loops, Domain& domain)
{
  if (loops.empty())
  {
    return "The domain has no loop.";
  }
  std::size_t outer = 0;
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    const std::string why = WhyNotSimple(loops[i]);
    if (!why.empty())
    {
      return "The boundary of the domain cannot be used: " + NameOf(i) + " " + why + ".";
    }
    if (PolygonOrientation(loops[i]) < 0)
    {
      std::reverse(loops[i].begin() + 1, loops[i].end());
    }
    // Of loops that hold one another the outermost has the largest area.
    outer = SignedArea(loops[i]) > SignedArea(loops[outer]) ? i : outer;
  }
  domain.Outer = std::move(loops[outer]);
  loops.erase(loops.begin() + static_cast<std::ptrdiff_t>(outer));
  domain.Holes = std::move(loops);
  return FindFault(domain);
}

double DomainArea(const Domain& domain)
{
  double area = SignedArea(domain.Outer);
  for (const std::vector<Point2>& hole : domain.Holes)
  {
    area -= SignedArea(hole);
  }
  return area;
}

bool IsRectangle(const Domain& domain)
{
  const std::vector<Point2>& outer = domain.Outer;
  if (outer.size() != 4 || !domain.Holes.empty())
  {
    return false;
  }
  bool parallel = true;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const Point2& a = outer[i];
    const Point2& b = outer[(i + 1) % 4];
    const Point2& c = outer[(i + 2) % 4];
    parallel = parallel && ((a.x == b.x && b.y == c.y) || (a.y == b.y && b.x == c.x));
  }
  return parallel;
}

} // namespace pemesh
