// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BoxTilings.h"

#include "TilingLattice.h"

#include <cmath>
#include <numbers>

namespace pemesh
{

namespace
{

/**
 * Squares whose inner edges are polylines, all of the same shape: horizontal ones are bent upwards,
 * vertical ones (if at all) to the right.
 */
class BentEdges
{
public:
  /** `shape` are the inner points of an edge from (0, 0) to (1, 0). */
  BentEdges(const TilingLattice& lattice, std::vector<Point2> shape, PolygonMesh& mesh)
    : Lattice(lattice)
    , Shape(std::move(shape))
    , Mesh(mesh)
  {
  }

  void Tile(bool areVerticalsBent)
  {
    const int columns = this->Lattice.Columns;
    const int rows = this->Lattice.Rows;
    this->Lattice.AddCorners([](int, int) { return Point2{}; }, this->Mesh);
    this->FirstHorizontal = static_cast<int>(this->Mesh.Points.size());
    for (int row = 1; row < rows; ++row)
    {
      for (int column = 0; column < columns; ++column)
      {
        for (const Point2& point : this->Shape)
        {
          this->Mesh.Points.push_back(this->Lattice.At(column + point.x, row + point.y));
        }
      }
    }
    this->FirstVertical = static_cast<int>(this->Mesh.Points.size());
    for (int row = 0; row < rows && areVerticalsBent; ++row)
    {
      for (int column = 1; column < columns; ++column)
      {
        for (const Point2& point : this->Shape)
        {
          this->Mesh.Points.push_back(this->Lattice.At(column + point.y, row + point.x));
        }
      }
    }
    for (int row = 0; row < rows; ++row)
    {
      for (int column = 0; column < columns; ++column)
      {
        this->AddCell(column, row, areVerticalsBent);
      }
    }
  }

private:
  void AddCell(int column, int row, bool areVerticalsBent)
  {
    const int columns = this->Lattice.Columns;
    const int length = static_cast<int>(this->Shape.size());
    this->Cell.assign(1, this->Lattice.Corner(column, row));
    if (row > 0)
    {
      this->AddEdge(this->FirstHorizontal + ((row - 1) * columns + column) * length, false);
    }
    this->Cell.push_back(this->Lattice.Corner(column + 1, row));
    const auto firstOfVertical = [&](int edge)
    { return this->FirstVertical + (row * (columns - 1) + edge - 1) * length; };
    if (areVerticalsBent && column + 1 < columns)
    {
      this->AddEdge(firstOfVertical(column + 1), false);
    }
    this->Cell.push_back(this->Lattice.Corner(column + 1, row + 1));
    if (row + 1 < this->Lattice.Rows)
    {
      this->AddEdge(this->FirstHorizontal + (row * columns + column) * length, true);
    }
    this->Cell.push_back(this->Lattice.Corner(column, row + 1));
    if (areVerticalsBent && column > 0)
    {
      this->AddEdge(firstOfVertical(column), true);
    }
    this->Mesh.AddElement(this->Cell);
  }

  void AddEdge(int first, bool isReversed)
  {
    const int length = static_cast<int>(this->Shape.size());
    for (int i = 0; i < length; ++i)
    {
      this->Cell.push_back(isReversed ? first + length - 1 - i : first + i);
    }
  }

  const TilingLattice& Lattice;
  std::vector<Point2> Shape;
  PolygonMesh& Mesh;
  int FirstHorizontal = 0;
  int FirstVertical = 0;
  std::vector<int> Cell;
};

/** Koch's curve from one point to another, without its ends: its peaks are to the left. */
void AddKochCurve(
  const Point2& from, const Point2& to, int depth, double amplitude, std::vector<Point2>& points)
{
  if (depth == 0)
  {
    return;
  }
  const Point2 third = { (to.x - from.x) / 3.0, (to.y - from.y) / 3.0 };
  const double height = amplitude * std::numbers::sqrt3 / 2.0;
  const Point2 first = { from.x + third.x, from.y + third.y };
  const Point2 second = { to.x - third.x, to.y - third.y };
  const Point2 peak = { 0.5 * (from.x + to.x) - height * third.y,
    0.5 * (from.y + to.y) + height * third.x };
  AddKochCurve(from, first, depth - 1, amplitude, points);
  points.push_back(first);
  AddKochCurve(first, peak, depth - 1, amplitude, points);
  points.push_back(peak);
  AddKochCurve(peak, second, depth - 1, amplitude, points);
  points.push_back(second);
  AddKochCurve(second, to, depth - 1, amplitude, points);
}

} // namespace

TessellationResult MakeZigzag(const TessellationInput& input)
{
  const int teeth = input.Values.GetInteger("teeth");
  const double amplitude = input.Values.Get("amplitude");
  std::vector<Point2> shape;
  for (int tooth = 0; tooth < teeth; ++tooth)
  {
    shape.push_back({ (tooth + 0.25) / teeth, amplitude });
    shape.push_back({ (tooth + 0.75) / teeth, -amplitude });
  }
  return TileDomain(input, { 1.0, 4.0 + 4.0 * teeth },
    [&shape](const TilingLattice& lattice, PolygonMesh& mesh)
    { BentEdges(lattice, shape, mesh).Tile(false); });
}

TessellationResult MakeKoch(const TessellationInput& input)
{
  // The curve over an edge stays in the triangle over it with the angles 30, 120 and 30 degrees;
  // so do its parts, which is why neither the curve nor the edges of a square can meet.
  const int depth = input.Values.GetInteger("depth");
  std::vector<Point2> shape;
  return TileDomain(input, { 1.0, std::pow(4.0, depth + 1) },
    [&](const TilingLattice& lattice, PolygonMesh& mesh)
    {
      AddKochCurve({ 0.0, 0.0 }, { 1.0, 0.0 }, depth, input.Values.Get("amplitude"), shape);
      BentEdges(lattice, shape, mesh).Tile(true);
    });
}

} // namespace pemesh
