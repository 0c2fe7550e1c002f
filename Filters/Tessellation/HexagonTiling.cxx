// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BoxTilings.h"

#include "TilingLattice.h"

#include <array>
#include <cmath>
#include <numbers>

namespace pemesh
{

namespace
{

/**
 * Regular hexagons with vertical sides that cover a rectangle: the left and right border run along
 * sides or through centres. Points lie on zigzag lines between the rows.
 */
class HexagonRows
{
public:
  HexagonRows(const Box& bounds, int columns)
    : Bounds(bounds)
    , Columns(columns)
    , Side(bounds.Width() / columns / std::numbers::sqrt3)
    , RowsToBorder(static_cast<int>(0.5 * bounds.Height() / (1.5 * this->Side)) + 2)
    , Shift(this->FindShift())
  {
  }

  double Count() const { return (this->Columns + 0.5) * (2.0 * this->RowsToBorder + 1.0); }

  PolygonMesh Make() const
  {
    PolygonMesh mesh;
    for (int row = -this->RowsToBorder; row <= this->RowsToBorder + 1; ++row)
    {
      for (int half = -1; half <= 2 * this->Columns + 1; ++half)
      {
        mesh.Points.push_back(this->PointOn(row, half));
      }
    }
    for (int row = -this->RowsToBorder; row <= this->RowsToBorder; ++row)
    {
      for (int half = IsOdd(row) ? 0 : 1; half <= 2 * this->Columns; half += 2)
      {
        mesh.AddElement(std::array{ this->Number(row, half - 1), this->Number(row, half),
          this->Number(row, half + 1), this->Number(row + 1, half + 1), this->Number(row + 1, half),
          this->Number(row + 1, half - 1) });
      }
    }
    return mesh;
  }

private:
  static bool IsOdd(int row) { return row % 2 != 0; }

  /**
   * Either a row or the gap between two is in the middle: the choice that leaves the higher tips
   * of hexagons at the upper and lower border, in units of a side.
   */
  double FindShift() const
  {
    const auto tipHeight = [this](double shift)
    {
      const double beyondRow = 0.5 * this->Bounds.Height() / this->Side - 1.5 * shift - 0.5;
      const double tip = beyondRow - 1.5 * std::floor(beyondRow / 1.5);
      return tip < 1e-9 ? 1.5 : tip; // no tips at all
    };
    return tipHeight(0.0) >= tipHeight(0.5) ? 0.0 : 0.5;
  }

  int Number(int row, int half) const
  {
    return (row + this->RowsToBorder) * (2 * this->Columns + 3) + half + 1;
  }

  /** On the line below a row, at a multiple of half a width: low below the centres of the row. */
  Point2 PointOn(int row, int half) const
  {
    const double share = half / (2.0 * this->Columns);
    const double x = half == 2 * this->Columns ? this->Bounds.High.x
                                               : this->Bounds.Low.x + share * this->Bounds.Width();
    const bool isBelowCenter = IsOdd(half) != IsOdd(row);
    const double center =
      0.5 * this->Bounds.Low.y + 0.5 * this->Bounds.High.y + 1.5 * this->Side * (row + this->Shift);
    return { x, center - (isBelowCenter ? 1.0 : 0.5) * this->Side };
  }

  Box Bounds;
  int Columns;
  double Side;
  int RowsToBorder;
  double Shift;
};

} // namespace

TessellationResult MakeHexagons(const TessellationInput& input)
{
  const Box bounds = BoxOf(input.Region);
  const double columns = input.Values.Get("cells");
  const double count =
    columns * columns * bounds.Height() / bounds.Width() * 2.0 / std::numbers::sqrt3;
  if (count > input.MaximumElements)
  {
    return TooManyElements(count, input.MaximumElements);
  }
  const HexagonRows rows(bounds, static_cast<int>(columns));
  return ClipToDomain(rows.Make(), input.Region, rows.Count(), false);
}

} // namespace pemesh
