// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * One polygon of a layout: what it is and where it goes.
 */
#ifndef pemesh_LayoutPolygon_h
#define pemesh_LayoutPolygon_h

#include "PolygonFamilies.h"

#include <string>
#include <vector>

namespace pemesh
{

struct LayoutPolygon
{
  const PolygonFamily* Family = nullptr;
  ParameterValues Parameters;
  Point2 Center;
  double Scale = 1.0;
  double Rotation = 0.0; ///< degrees
  double From = 0.0;
  double To = 1.0;
  std::string Name;           ///< empty: called after its place in the layout
  std::string File;           ///< where the points of the family "file" come from
  std::vector<Point2> Points; ///< of fixed polygons

  LayoutPolygon(const PolygonFamily& family, const Point2& center)
    : Family(&family)
    , Parameters(family.Parameters)
    , Center(center)
  {
  }

  bool ChangesWithTime() const { return !this->Family->IsFixed() && this->From != this->To; }

  std::vector<Point2> VerticesAt(double time) const;

  /** Its name, or "polygon 1 (comb)" for index 0. */
  std::string NameAt(int index) const;

  /** Empty if everything is in its valid range, else one sentence, which calls it `name`. */
  std::string WhyInvalid(const std::string& name) const;

  friend bool operator==(const LayoutPolygon&, const LayoutPolygon&) = default;
};

/**
 * Makes `points` those of a fixed polygon: a last one that repeats the first is left out, and the
 * polygon is turned counter-clockwise. Empty if that went well, else the end of a sentence: "has
 * fewer than three points".
 */
std::string MakeFixedPolygon(std::vector<Point2>& points);

} // namespace pemesh

#endif
