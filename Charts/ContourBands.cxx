// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ContourBands.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

void PolygonBatch::Add(std::span<const Point2> polygon)
{
  const auto isFinite = [](const Point2& point)
  { return std::isfinite(point.x) && std::isfinite(point.y); };
  if (!std::all_of(polygon.begin(), polygon.end(), isFinite))
  {
    return;
  }
  for (const Point2& point : polygon)
  {
    this->Points.push_back(point.x);
    this->Points.push_back(point.y);
  }
  this->Sizes.push_back(static_cast<int>(polygon.size()));
}

ContourBands::ContourBands(std::vector<double> levels)
  : Levels(std::move(levels))
{
}

int ContourBands::BandOf(double value) const
{
  const auto inner = std::span(this->Levels).subspan(1, this->Levels.size() - 2);
  return static_cast<int>(std::upper_bound(inner.begin(), inner.end(), value) - inner.begin());
}

namespace
{

/** The part of a convex polygon on one side of a level (Sutherland and Hodgman, 1974). */
void Clip(const std::vector<ValuedPoint>& polygon, double level, bool keepBelow,
  std::vector<ValuedPoint>& part)
{
  part.clear();
  const auto isIn = [=](const ValuedPoint& point)
  { return keepBelow ? point.Value <= level : point.Value >= level; };
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const ValuedPoint& a = polygon[i];
    const ValuedPoint& b = polygon[(i + 1) % polygon.size()];
    if (isIn(a))
    {
      part.push_back(a);
    }
    if (isIn(a) != isIn(b) && a.Value != level && b.Value != level)
    {
      const double share = (level - a.Value) / (b.Value - a.Value);
      const Point2 cut = { a.Position.x + share * (b.Position.x - a.Position.x),
        a.Position.y + share * (b.Position.y - a.Position.y) };
      part.push_back({ cut, level });
    }
  }
}

} // namespace

void ContourBands::Cut(const std::array<ValuedPoint, 3>& triangle, std::vector<PolygonBatch>& bands)
{
  const auto [low, high] = std::minmax_element(triangle.begin(), triangle.end(),
    [](const ValuedPoint& a, const ValuedPoint& b) { return a.Value < b.Value; });
  const int last = this->BandOf(high->Value);
  this->Rest.assign(triangle.begin(), triangle.end());
  for (int band = this->BandOf(low->Value); band <= last; ++band)
  {
    if (band + 1 < last)
    {
      Clip(this->Rest, this->Levels[band + 2], true, this->Part);
    }
    else
    {
      this->Part = this->Rest;
    }
    if (this->Part.size() >= 3)
    {
      this->Positions.clear();
      for (const ValuedPoint& point : this->Part)
      {
        this->Positions.push_back(point.Position);
      }
      bands[band].Add(this->Positions);
    }
    if (band < last)
    {
      Clip(this->Rest, this->Levels[band + 1], false, this->Part);
      this->Rest.swap(this->Part);
    }
  }
}

} // namespace pemesh
