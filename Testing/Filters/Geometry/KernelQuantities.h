// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What kernels measure, each beside the brute force that it must agree with.
 */
#ifndef KernelQuantities_h
#define KernelQuantities_h

#include "EnclosingCircle.h"
#include "InscribedCircle.h"
#include "PointDistances.h"
#include "PolygonKernel.h"
#include "PolygonMeasures.h"

#include "BruteForce.h"

#include <algorithm>
#include <cmath>

namespace pemesh::test
{

struct Quantity
{
  const char* Name;
  int Power; ///< of the diameter, its natural scale
  double (*Kernel)(PolygonView polygon);
  double (*Expected)(PolygonView polygon);
};

inline double ExpectedInscribedRadius(PolygonView polygon)
{
  // A circle that is proved to be inside, if it is larger than all that were tried.
  const Circle circle = LargestInscribedCircle(polygon);
  return std::max(BruteInscribedRadius(polygon), BruteDistanceInside(polygon, circle.Center));
}

inline const Quantity Quantities[] = {
  { "area", 2, SignedArea, ExactArea },
  { "perimeter", 1, Perimeter, [](PolygonView p) { return BruteMeasure(p).Perimeter; } },
  { "diameter", 1, Diameter, [](PolygonView p) { return BruteMeasure(p).Diameter; } },
  { "closest pair", 1, [](PolygonView p) { return ClosestPair(p).Distance; },
    [](PolygonView p) { return BruteMeasure(p).ClosestPair; } },
  { "smallest angle", 0, [](PolygonView p) { return MeasureAngles(p).Smallest; },
    [](PolygonView p) { return BruteMeasure(p).SmallestAngle; } },
  { "largest angle", 0, [](PolygonView p) { return MeasureAngles(p).Largest; },
    [](PolygonView p) { return BruteMeasure(p).LargestAngle; } },
  { "enclosing radius", 1, [](PolygonView p) { return SmallestEnclosingCircle(p).Radius; },
    BruteEnclosingRadius },
  { "kernel area", 2, [](PolygonView p) { return SignedArea(PolygonKernel(p)); }, ExactKernelArea },
  { "kernel radius", 1, [](PolygonView p) { return LargestCircleInKernel(p).Radius; },
    BruteKernelRadius },
  { "inscribed radius", 1, [](PolygonView p) { return LargestInscribedCircle(p).Radius; },
    ExpectedInscribedRadius },
};

/** 1e-9 of the natural scale; of the value where that exceeds 1e-4 of the scale. */
inline double Allowed(double expected, int power, double diameter)
{
  const double scale = std::pow(diameter, power);
  return 1e-9 * (std::abs(expected) > 1e-4 * scale ? std::abs(expected) : scale);
}

} // namespace pemesh::test

#endif
