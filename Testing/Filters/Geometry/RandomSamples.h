// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Random polygons of 3 to 60 vertices of all kinds, at three scales and places, by number.
 */
#ifndef RandomSamples_h
#define RandomSamples_h

#include "RandomPolygon.h"

#include "PolygonSamples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>

namespace pemesh::test
{

/** Straight vertices moved off their lines by anything from 1e-16 to 1e-4. */
inline Polygon NearlyStraight(Random& random, int size)
{
  Polygon polygon = WithHangingVertices(random, Untangled(random, std::max(3, size / 2)));
  for (Point2& point : polygon)
  {
    const double offset = std::pow(10.0, random.Uniform(-16.0, -4.0));
    point.x += random.Uniform(-offset, offset);
    point.y += random.Uniform(-offset, offset);
  }
  return polygon;
}

struct PolygonSource
{
  const char* Name;
  Polygon (*Make)(Random& random, int size);
};

inline constexpr PolygonSource PolygonSources[] = {
  { "star-shaped",
    [](Random& random, int size)
    { return StarShaped(random, std::max(size, 4), random.Uniform(0.1, 0.95)); } },
  { "convex",
    [](Random& random, int size)
    { return ConvexPolygon(random, std::max(size, 4), random.Uniform(0.05, 1.0)); } },
  { "untangled", Untangled },
  { "straight vertices",
    [](Random& random, int size)
    { return WithHangingVertices(random, Untangled(random, std::max(3, size / 2))); } },
  { "convex with straight vertices",
    [](Random& random, int size)
    { return WithHangingVertices(random, ConvexPolygon(random, std::max(4, size / 2), 0.7)); } },
  { "nearly straight vertices", NearlyStraight },
  { "deformed",
    [](Random& random, int size)
    {
      RandomPolygonOptions options;
      options.Vertices = size;
      options.Irregularity = random.Uniform();
      options.Spikiness = random.Uniform();
      options.Tangle = random.Uniform();
      options.Seed = static_cast<std::uint64_t>(random.Integer(0, 1 << 30));
      return MakeRandomPolygon(options, random.Uniform());
    } },
};

/** At one of three scales, turned, at home or far off: all as rounded. */
inline Polygon Placed(Random& random, const Polygon& polygon)
{
  constexpr double Scales[] = { 1e-9, 1.0, 1e9 };
  constexpr double Shifts[] = { 0.0, 10.0, 1e4 };
  const double scale = Scales[random.Integer(0, 2)];
  const double shift = scale * Shifts[random.Integer(0, 2)];
  return Transformed(polygon, random.Uniform(0.0, 6.0), scale, { shift, -0.7 * shift });
}

struct Sample
{
  std::string Name;
  Polygon Vertices;
};

inline Sample MakeSample(int number)
{
  Random random(static_cast<std::uint64_t>(number) + 1000);
  const PolygonSource& source =
    PolygonSources[static_cast<std::size_t>(number) % std::size(PolygonSources)];
  const int size = random.Integer(3, 60);
  Sample sample;
  sample.Vertices = Placed(random, source.Make(random, size));
  sample.Name = std::string(source.Name) + " " + std::to_string(number) + " of " +
    std::to_string(sample.Vertices.size()) + " vertices";
  return sample;
}

} // namespace pemesh::test

#endif
