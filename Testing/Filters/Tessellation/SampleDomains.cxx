// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SampleDomains.h"

#include <cmath>
#include <numbers>

using pemesh::Domain;
using pemesh::Point2;

namespace
{

std::vector<Point2> Ring(double x, double y, double radius, int vertices, double turn)
{
  std::vector<Point2> ring;
  for (int i = 0; i < vertices; ++i)
  {
    const double angle = turn + 2.0 * std::numbers::pi * i / vertices;
    ring.push_back({ x + radius * std::cos(angle), y + radius * std::sin(angle) });
  }
  return ring;
}

Domain Comb(int teeth)
{
  Domain comb;
  comb.Outer = { { 0.0, 0.0 }, { 1.0, 0.0 } };
  for (int i = teeth; i > 0; --i)
  {
    const double tooth = 1.0 / (2 * teeth - 1);
    const double east = i == teeth ? 1.0 : (2 * i - 1) * tooth;
    const double west = (2 * i - 2) * tooth;
    comb.Outer.insert(comb.Outer.end(), { { east, 1.0 }, { west, 1.0 } });
    if (i > 1)
    {
      comb.Outer.insert(comb.Outer.end(), { { west, 0.1 }, { (2 * i - 3) * tooth, 0.1 } });
    }
  }
  return comb;
}

/** Many small holes, most of them inside one cell. */
Domain Sieve()
{
  Domain sieve = pemesh::UnitSquare();
  for (int i = 0; i < 5; ++i)
  {
    for (int j = 0; j < 5; ++j)
    {
      sieve.Holes.push_back(
        Ring(0.1 + 0.2 * i, 0.1 + 0.2 * j + 0.003 * i, 0.01 + 0.003 * j, 3 + (i + j) % 5, 0.3 * i));
    }
  }
  return sieve;
}

} // namespace

Domain RectangleDomain(double west, double south, double east, double north)
{
  return { { { west, south }, { east, south }, { east, north }, { west, north } }, {} };
}

Domain RegularDomain(double x, double y, double radius, int vertices, double turn)
{
  return { Ring(x, y, radius, vertices, turn), {} };
}

std::vector<SampleDomain> SampleDomains()
{
  std::vector<SampleDomain> samples;
  samples.push_back({ "unit square", pemesh::UnitSquare() });
  samples.push_back({ "rectangle", RectangleDomain(-3.1, 0.7, 4.3, 2.9) });
  samples.push_back({ "flat", RectangleDomain(0.0, 0.0, 1.0, 0.001) });
  samples.push_back({ "far away", RectangleDomain(1e5, -1e6, 1e5 + 1.0, -1e6 + 1.0) });
  samples.push_back({ "L",
    { { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 0.5 }, { 0.5, 0.5 }, { 0.5, 1.0 }, { 0.0, 1.0 } },
      {} } });
  samples.push_back({ "triangle", { { { 0.0, 0.0 }, { 1.0, 0.1 }, { 0.3, 0.9 } }, {} } });
  samples.push_back({ "turned square", RegularDomain(0.5, 0.5, 0.5, 4) });
  samples.push_back({ "disc", RegularDomain(1.0, 2.0, 0.7, 100) });
  samples.push_back({ "comb", Comb(6) });
  samples.push_back({ "sieve", Sieve() });
  Domain frame = pemesh::UnitSquare();
  frame.Holes = { { { 0.25, 0.25 }, { 0.75, 0.25 }, { 0.75, 0.75 }, { 0.25, 0.75 } } };
  samples.push_back({ "frame", frame });
  Domain ring = RegularDomain(0.0, 0.0, 1.0, 40);
  ring.Holes = { Ring(0.0, 0.0, 0.95, 37, 0.1) };
  samples.push_back({ "ring", ring });
  Domain nested = pemesh::UnitSquare();
  nested.Holes = { // a C, and holes in its bay
    { { 0.2, 0.2 }, { 0.8, 0.2 }, { 0.8, 0.3 }, { 0.3, 0.3 }, { 0.3, 0.7 }, { 0.8, 0.7 },
      { 0.8, 0.8 }, { 0.2, 0.8 } },
    Ring(0.5, 0.5, 0.05, 6, 0.0), Ring(0.6, 0.4, 0.02, 5, 0.0)
  };
  samples.push_back({ "nested holes", nested });
  return samples;
}
