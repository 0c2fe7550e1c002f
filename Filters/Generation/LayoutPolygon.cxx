// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LayoutPolygon.h"

#include "NumberText.h"
#include "PolygonMeasures.h"
#include "PolygonPlacement.h"
#include "PolygonValidity.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

std::string Sentence(
  const std::string& polygon, const std::string& what, double value, const std::string& expected)
{
  return "The " + what + " of " + polygon + " is " + FormatNumber(value) + ", expected " +
    expected + ".";
}

bool IsDeformation(double value)
{
  return value >= 0.0 && value <= 1.0; // false for NaN
}

} // namespace

std::vector<Point2> LayoutPolygon::VerticesAt(double time) const
{
  const double t = this->From + time * (this->To - this->From);
  return PlacePolygon(
    this->Family->IsFixed() ? this->Points : this->Family->Vertices(t, this->Parameters),
    this->Center, this->Scale, this->Rotation);
}

std::string LayoutPolygon::NameAt(int index) const
{
  return this->Name.empty()
    ? "polygon " + std::to_string(index + 1) + " (" + this->Family->Name + ")"
    : this->Name;
}

std::string LayoutPolygon::WhyInvalid(const std::string& name) const
{
  if (!std::isfinite(this->Center.x) || !std::isfinite(this->Center.y))
  {
    return "The center of " + name + " is not a pair of finite numbers.";
  }
  if (!(this->Scale > 0.0) || !std::isfinite(this->Scale))
  {
    return Sentence(name, "scale", this->Scale, "more than 0 and finite");
  }
  if (!std::isfinite(this->Rotation))
  {
    return Sentence(name, "rotation", this->Rotation, "a finite number of degrees");
  }
  if (!IsDeformation(this->From))
  {
    return Sentence(name, "first deformation", this->From, "0 to 1");
  }
  if (!IsDeformation(this->To))
  {
    return Sentence(name, "last deformation", this->To, "0 to 1");
  }
  return {};
}

std::string MakeFixedPolygon(std::vector<Point2>& points)
{
  if (points.size() > 1 && points.front() == points.back())
  {
    points.pop_back();
  }
  if (points.size() < 3)
  {
    return "has fewer than three points";
  }
  if (!AreFinite(points))
  {
    return "has coordinates that are not finite";
  }
  const double scale = PlaceOf(points).Scale;
  if (!(scale > 0.0) || !std::isfinite(scale))
  {
    return "is too small or too large to be scaled";
  }
  if (PolygonOrientation(points) < 0)
  {
    std::reverse(points.begin() + 1, points.end());
  }
  return {};
}

} // namespace pemesh
