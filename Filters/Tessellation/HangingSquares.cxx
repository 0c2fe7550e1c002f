// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BoxTilings.h"

#include "RandomNumbers.h"
#include "TilingLattice.h"

#include <cstdint>
#include <unordered_map>

namespace pemesh
{

namespace
{

/** A square, in units of the smallest one. */
struct Leaf
{
  std::int64_t Column;
  std::int64_t Row;
  std::int64_t Size;
};

class RandomRefinement
{
public:
  RandomRefinement(const TessellationInput& input, const TilingLattice& lattice, PolygonMesh& mesh)
    : Lattice(lattice)
    , Mesh(mesh)
    , Unit(std::int64_t(1) << input.Values.GetInteger("levels"))
    , Share(input.Values.Get("share"))
    , MostLeaves(input.MaximumElements)
    , Random(static_cast<std::uint64_t>(input.Values.Get("seed")))
  {
  }

  /** False if there would be too many elements. */
  bool Refine()
  {
    for (int row = 0; row < this->Lattice.Rows; ++row)
    {
      for (int column = 0; column < this->Lattice.Columns; ++column)
      {
        this->Split({ column * this->Unit, row * this->Unit, this->Unit });
        if (this->IsFull())
        {
          return false;
        }
      }
    }
    std::vector<int> element;
    for (const Leaf& leaf : this->Leaves)
    {
      element.clear();
      const std::int64_t size = leaf.Size;
      this->AddSide(leaf.Column, leaf.Row, size, 0, element);
      this->AddSide(leaf.Column + size, leaf.Row, 0, size, element);
      this->AddSide(leaf.Column + size, leaf.Row + size, -size, 0, element);
      this->AddSide(leaf.Column, leaf.Row + size, 0, -size, element);
      this->Mesh.AddElement(element);
    }
    return true;
  }

private:
  bool IsFull() const { return static_cast<double>(this->Leaves.size()) > this->MostLeaves; }

  void Split(const Leaf& leaf)
  {
    if (this->IsFull())
    {
      return;
    }
    if (leaf.Size == 1 || this->Random.Uniform() >= this->Share)
    {
      for (const std::int64_t row : { leaf.Row, leaf.Row + leaf.Size })
      {
        this->AddCorner(leaf.Column, row);
        this->AddCorner(leaf.Column + leaf.Size, row);
      }
      this->Leaves.push_back(leaf);
      return;
    }
    const std::int64_t half = leaf.Size / 2;
    for (const std::int64_t row : { leaf.Row, leaf.Row + half })
    {
      this->Split({ leaf.Column, row, half });
      this->Split({ leaf.Column + half, row, half });
    }
  }

  std::int64_t Key(std::int64_t column, std::int64_t row) const
  {
    return row * (this->Lattice.Columns * this->Unit + 1) + column;
  }

  void AddCorner(std::int64_t column, std::int64_t row)
  {
    const int number = static_cast<int>(this->Mesh.Points.size());
    if (this->Corners.emplace(this->Key(column, row), number).second)
    {
      const double unit = static_cast<double>(this->Unit);
      this->Mesh.Points.push_back(
        this->Lattice.At(static_cast<double>(column) / unit, static_cast<double>(row) / unit));
    }
  }

  /** The start of a side and all corners inside it: there are none if there is none at its middle.
   */
  void AddSide(std::int64_t column, std::int64_t row, std::int64_t dx, std::int64_t dy,
    std::vector<int>& element) const
  {
    element.push_back(this->Corners.at(this->Key(column, row)));
    this->AddInside(column, row, dx, dy, element);
  }
  void AddInside(std::int64_t column, std::int64_t row, std::int64_t dx, std::int64_t dy,
    std::vector<int>& element) const
  {
    const std::int64_t x = dx / 2;
    const std::int64_t y = dy / 2;
    if (x == 0 && y == 0)
    {
      return;
    }
    const auto middle = this->Corners.find(this->Key(column + x, row + y));
    if (middle != this->Corners.end())
    {
      this->AddInside(column, row, x, y, element);
      element.push_back(middle->second);
      this->AddInside(column + x, row + y, x, y, element);
    }
  }

  const TilingLattice& Lattice;
  PolygonMesh& Mesh;
  std::int64_t Unit;
  double Share;
  double MostLeaves;
  RandomNumbers Random;
  std::vector<Leaf> Leaves;
  std::unordered_map<std::int64_t, int>
    Corners; ///< only looked up, so that its order is of no account
};

} // namespace

TessellationResult MakeHangingSquares(const TessellationInput& input)
{
  bool isTooLarge = false;
  TessellationResult result = TileDomain(input, { 1.0, 4.0 },
    [&](const TilingLattice& lattice, PolygonMesh& mesh)
    { isTooLarge = !RandomRefinement(input, lattice, mesh).Refine(); });
  return isTooLarge ? TooManyElements(input.MaximumElements + 1.0, input.MaximumElements)
                    : std::move(result);
}

} // namespace pemesh
