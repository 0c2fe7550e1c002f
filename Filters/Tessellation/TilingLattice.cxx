// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TilingLattice.h"

#include "ClipMesh.h"
#include "NumberText.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pemesh
{

namespace
{

/** 100000 rather than 1e+05. */
std::string CountText(double count)
{
  return count < 1e15 ? std::to_string(std::llround(count)) : FormatNumber(count);
}

} // namespace

void TilingLattice::AddCorners(
  const std::function<Point2(int column, int row)>& displacement, PolygonMesh& mesh) const
{
  for (int row = 0; row <= this->Rows; ++row)
  {
    for (int column = 0; column <= this->Columns; ++column)
    {
      const Point2 moved = displacement(column, row);
      mesh.Points.push_back(this->At(column + moved.x, row + moved.y));
    }
  }
}

TessellationResult TileDomain(const TessellationInput& input, const TilingSize& size,
  const std::function<void(const TilingLattice&, PolygonMesh&)>& tile)
{
  const Box bounds = BoxOf(input.Region);
  const double columns = input.Values.Get("squares");
  const double rows = std::max(1.0, std::round(columns * bounds.Height() / bounds.Width()));
  const double elements = size.Elements * columns * rows;
  if (elements > input.MaximumElements)
  {
    return TooManyElements(elements, input.MaximumElements);
  }
  const double sides = size.Sides * columns * rows;
  const double mostSides =
    std::min(16.0 * input.MaximumElements, double(std::numeric_limits<int>::max()));
  if (sides > mostSides)
  {
    return { TessellationStatus::TooManyElements,
      "The mesh would have " + CountText(sides) + " sides, the limit is " + CountText(mostSides) +
        " (16 times that of the elements); refine less.",
      {} };
  }
  PolygonMesh mesh;
  tile({ bounds, static_cast<int>(columns), static_cast<int>(rows) }, mesh);
  return ClipToDomain(std::move(mesh), input.Region, elements, true);
}

TessellationResult ClipToDomain(
  PolygonMesh cells, const Domain& domain, double count, bool fillsRectangle)
{
  if (fillsRectangle && IsRectangle(domain))
  {
    return { TessellationStatus::Done, {}, std::move(cells) };
  }
  double tolerance = 0.0;
  std::string why = FindTolerance(domain, count, tolerance);
  ClippedMesh clipped;
  why = why.empty() ? ClipMesh(cells, domain, tolerance, clipped) : why;
  return { why.empty() ? TessellationStatus::Done : TessellationStatus::Failed, std::move(why),
    std::move(clipped.Mesh) };
}

std::string FindTolerance(const Domain& domain, double count, double& tolerance)
{
  const Box bounds = BoxOf(domain);
  const double farthest = std::max({ std::abs(bounds.Low.x), std::abs(bounds.Low.y),
    std::abs(bounds.High.x), std::abs(bounds.High.y) });
  const double cell = std::sqrt(DomainArea(domain) / count);
  tolerance = std::max(1e-9 * cell, 64.0 * std::numeric_limits<double>::epsilon() * farthest);
  return tolerance < 1e-3 * cell
    ? std::string()
    : "The elements would be too small for double precision this far from the origin; move the "
      "domain nearer to it or ask for fewer elements.";
}

TessellationResult TooManyElements(double count, double most)
{
  return { TessellationStatus::TooManyElements,
    "The mesh would have about " + CountText(count) + " elements, the limit is " + CountText(most) +
      "; ask for fewer or raise the limit.",
    {} };
}

} // namespace pemesh
