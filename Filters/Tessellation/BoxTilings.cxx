// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BoxTilings.h"

#include "RandomNumbers.h"
#include "TilingLattice.h"

#include <array>
#include <cmath>
#include <numbers>

namespace pemesh
{

namespace
{

void AddQuadrilaterals(const TilingLattice& lattice, PolygonMesh& mesh)
{
  for (int row = 0; row < lattice.Rows; ++row)
  {
    for (int column = 0; column < lattice.Columns; ++column)
    {
      mesh.AddElement(std::array{ lattice.Corner(column, row), lattice.Corner(column + 1, row),
        lattice.Corner(column + 1, row + 1), lattice.Corner(column, row + 1) });
    }
  }
}

/** Quadrilaterals whose corners are moved; on the border they are only moved along it. */
TessellationResult MoveCorners(const TessellationInput& input,
  const std::function<Point2(const TilingLattice&, int column, int row)>& displacement)
{
  return TileDomain(input, { 1.0, 4.0 },
    [&displacement](const TilingLattice& lattice, PolygonMesh& mesh)
    {
      lattice.AddCorners(
        [&](int column, int row)
        {
          Point2 moved = displacement(lattice, column, row);
          const bool isOnSide = column == 0 || column == lattice.Columns;
          const bool isOnEnd = row == 0 || row == lattice.Rows;
          return Point2{ isOnSide ? 0.0 : moved.x, isOnEnd ? 0.0 : moved.y };
        },
        mesh);
      AddQuadrilaterals(lattice, mesh);
    });
}

bool IsOnBorder(const TilingLattice& lattice, int column, int row)
{
  return column == 0 || column == lattice.Columns || row == 0 || row == lattice.Rows;
}

/** The points between two rows of bricks, from left to right: the joints of both rows. */
class BrickLine
{
public:
  BrickLine(const TilingLattice& lattice, int line, double offset, std::vector<Point2>& points)
    : First(static_cast<int>(points.size()))
    , Columns(lattice.Columns)
  {
    const bool isInside = line > 0 && line < lattice.Rows;
    const bool isLastMoved = line == lattice.Rows && line % 2 == 0;
    this->HasBoth = isInside && offset > 0.0;
    points.push_back(lattice.At(0, line));
    for (int column = 1; column < lattice.Columns; ++column)
    {
      if (this->HasBoth)
      {
        points.push_back(lattice.At(column, line));
      }
      points.push_back(lattice.At(column + (isInside || isLastMoved ? offset : 0.0), line));
    }
    points.push_back(lattice.At(lattice.Columns, line));
  }

  /** The point where brick `column` begins; the ends of the line are joints of both rows. */
  int Joint(int column, bool isMoved) const
  {
    const int perColumn = this->HasBoth ? 2 : 1;
    return column == 0 ? this->First
      : column == this->Columns
      ? this->First + (this->Columns - 1) * perColumn + 1
      : this->First + (column - 1) * perColumn + 1 + (this->HasBoth && isMoved ? 1 : 0);
  }

private:
  int First;
  int Columns;
  bool HasBoth = false;
};

/** Two points on each edge of a lattice, where the corners of its squares are cut off. */
class CutCorners
{
public:
  CutCorners(const TilingLattice& lattice, double cut, PolygonMesh& mesh)
    : Lattice(lattice)
    , Mesh(mesh)
  {
    for (int row = 0; row <= lattice.Rows; ++row)
    {
      for (int column = 0; column < lattice.Columns; ++column)
      {
        mesh.Points.push_back(lattice.At(column + cut, row));
        mesh.Points.push_back(lattice.At(column + 1.0 - cut, row));
      }
    }
    for (int row = 0; row < lattice.Rows; ++row)
    {
      for (int column = 0; column <= lattice.Columns; ++column)
      {
        mesh.Points.push_back(lattice.At(column, row + cut));
        mesh.Points.push_back(lattice.At(column, row + 1.0 - cut));
      }
    }
  }

  void AddOctagon(int column, int row)
  {
    this->Mesh.AddElement(
      std::array{ this->Horizontal(column, row, 0), this->Horizontal(column, row, 1),
        this->Vertical(column + 1, row, 0), this->Vertical(column + 1, row, 1),
        this->Horizontal(column, row + 1, 1), this->Horizontal(column, row + 1, 0),
        this->Vertical(column, row, 1), this->Vertical(column, row, 0) });
  }

  /** What the octagons leave around a corner of the lattice. */
  void AddSquare(int column, int row)
  {
    const bool isLeft = column == 0;
    const bool isRight = column == this->Lattice.Columns;
    const bool isBottom = row == 0;
    const bool isTop = row == this->Lattice.Rows;
    // East, north, west, south, and in a corner of the rectangle that corner where two are missing.
    std::vector<int> square;
    if (!isRight)
    {
      square.push_back(this->Horizontal(column, row, 0));
    }
    if (isLeft && isTop)
    {
      square.push_back(this->AddCorner(column, row));
    }
    if (!isTop)
    {
      square.push_back(this->Vertical(column, row, 0));
    }
    if (!isLeft)
    {
      square.push_back(this->Horizontal(column - 1, row, 1));
    }
    if (!isBottom)
    {
      square.push_back(this->Vertical(column, row - 1, 1));
    }
    if (square.size() == 2)
    {
      square.push_back(this->AddCorner(column, row));
    }
    this->Mesh.AddElement(square);
  }

private:
  int Horizontal(int column, int row, int which) const
  {
    return 2 * (row * this->Lattice.Columns + column) + which;
  }
  int Vertical(int column, int row, int which) const
  {
    return this->Horizontal(0, this->Lattice.Rows + 1, 0) +
      2 * (row * (this->Lattice.Columns + 1) + column) + which;
  }
  int AddCorner(int column, int row)
  {
    this->Mesh.Points.push_back(this->Lattice.At(column, row));
    return static_cast<int>(this->Mesh.Points.size()) - 1;
  }

  const TilingLattice& Lattice;
  PolygonMesh& Mesh;
};

} // namespace

TessellationResult MakeSquares(const TessellationInput& input)
{
  return MoveCorners(input, [](const TilingLattice&, int, int) { return Point2{}; });
}

TessellationResult MakeTriangles(const TessellationInput& input)
{
  return TileDomain(input, { 2.0, 6.0 },
    [](const TilingLattice& lattice, PolygonMesh& mesh)
    {
      lattice.AddCorners([](int, int) { return Point2{}; }, mesh);
      for (int row = 0; row < lattice.Rows; ++row)
      {
        for (int column = 0; column < lattice.Columns; ++column)
        {
          const int low = lattice.Corner(column, row);
          const int high = lattice.Corner(column + 1, row + 1);
          mesh.AddElement(std::array{ low, lattice.Corner(column + 1, row), high });
          mesh.AddElement(std::array{ low, high, lattice.Corner(column, row + 1) });
        }
      }
    });
}

TessellationResult MakeTrapezoids(const TessellationInput& input)
{
  const double slant = input.Values.Get("slant");
  return MoveCorners(input,
    [slant](const TilingLattice& lattice, int column, int row)
    {
      // Every second line is bent; so its trapezoids come in pairs, one upon the other.
      const bool isBent = row % 2 == 1 && row < lattice.Rows;
      return Point2{ 0.0, !isBent ? 0.0 : column % 2 == 0 ? 0.5 * slant : -0.5 * slant };
    });
}

TessellationResult MakeDistortedQuadrilaterals(const TessellationInput& input)
{
  // Corners stay in boxes that are apart, so that sides that face each other cannot meet and sides
  // that follow each other cannot fold back; up to 1/4, no box reaches the diagonal of the others.
  const double distortion = input.Values.Get("distortion");
  RandomNumbers random(static_cast<std::uint64_t>(input.Values.Get("seed")));
  return MoveCorners(input,
    [&](const TilingLattice&, int, int)
    {
      const double x = distortion * random.Signed();
      return Point2{ x, distortion * random.Signed() };
    });
}

TessellationResult MakeWavyQuadrilaterals(const TessellationInput& input)
{
  // x + a sin(2 pi x) sin(2 pi y) in both coordinates is one to one if 2 pi a < 1.
  const double amplitude = input.Values.Get("waviness") / (2.0 * std::numbers::pi);
  return MoveCorners(input,
    [amplitude](const TilingLattice& lattice, int column, int row)
    {
      const double wave = amplitude * std::sin(2.0 * std::numbers::pi * column / lattice.Columns) *
        std::sin(2.0 * std::numbers::pi * row / lattice.Rows);
      return Point2{ wave * lattice.Columns, wave * lattice.Rows };
    });
}

TessellationResult MakeDarts(const TessellationInput& input)
{
  const double amplitude = input.Values.Get("amplitude");
  return MoveCorners(input,
    [amplitude](const TilingLattice& lattice, int column, int row)
    {
      const bool isMoved = (column + row) % 2 == 0 && !IsOnBorder(lattice, column, row);
      return isMoved ? Point2{ amplitude, amplitude } : Point2{};
    });
}

TessellationResult MakeBricks(const TessellationInput& input)
{
  const double offset = input.Values.Get("offset");
  return TileDomain(input, { 1.0, 6.0 },
    [offset](const TilingLattice& lattice, PolygonMesh& mesh)
    {
      std::vector<BrickLine> lines;
      for (int line = 0; line <= lattice.Rows; ++line)
      {
        lines.emplace_back(lattice, line, offset, mesh.Points);
      }
      std::vector<int> brick;
      for (int row = 0; row < lattice.Rows; ++row)
      {
        for (int column = 0; column < lattice.Columns; ++column)
        {
          const bool isMoved = row % 2 == 1;
          brick.clear();
          for (int i = lines[row].Joint(column, isMoved);
               i <= lines[row].Joint(column + 1, isMoved); ++i)
          {
            brick.push_back(i);
          }
          for (int i = lines[row + 1].Joint(column + 1, isMoved);
               i >= lines[row + 1].Joint(column, isMoved); --i)
          {
            brick.push_back(i);
          }
          mesh.AddElement(brick);
        }
      }
    });
}

TessellationResult MakeOctagons(const TessellationInput& input)
{
  // Corners of squares are cut off where the octagon becomes regular.
  constexpr double Cut = 1.0 - std::numbers::sqrt2 / 2.0;
  return TileDomain(input, { 2.0, 12.0 },
    [](const TilingLattice& lattice, PolygonMesh& mesh)
    {
      CutCorners corners(lattice, Cut, mesh);
      for (int row = 0; row < lattice.Rows; ++row)
      {
        for (int column = 0; column < lattice.Columns; ++column)
        {
          corners.AddOctagon(column, row);
        }
      }
      for (int row = 0; row <= lattice.Rows; ++row)
      {
        for (int column = 0; column <= lattice.Columns; ++column)
        {
          corners.AddSquare(column, row);
        }
      }
    });
}

} // namespace pemesh
