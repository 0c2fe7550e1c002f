// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LineCells.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

struct CellPoint
{
  float X;
  float Y;
};

CellPoint Between(const CellPoint& a, const CellPoint& b)
{
  return { 0.5F * (a.X + b.X), 0.5F * (a.Y + b.Y) };
}

class CellGrid
{
public:
  CellGrid(int columns, int rows)
    : Columns(columns)
    , Rows(rows)
    , Marks(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0)
  {
  }

  /** In halves, without those where nothing is to be marked: a long segment may be out of sight. */
  void AddSegment(const CellPoint& a, const CellPoint& b)
  {
    constexpr float shortest = 12.0F;
    if (!this->HasWork(a, b))
    {
      return;
    }
    const float length = std::max(std::fabs(b.X - a.X), std::fabs(b.Y - a.Y));
    const CellPoint middle = Between(a, b);
    const bool isAtLimit = (middle.X == a.X && middle.Y == a.Y) ||
      (middle.X == b.X && middle.Y == b.Y); // of what numbers tell apart
    if (length > shortest && !isAtLimit)
    {
      this->AddSegment(a, middle);
      this->AddSegment(middle, b);
      return;
    }
    const int steps = std::max(1, static_cast<int>(std::ceil(length)));
    for (int i = 0; i <= steps; ++i)
    {
      const float part = static_cast<float>(i) / static_cast<float>(steps);
      this->Mark(a.X + part * (b.X - a.X), a.Y + part * (b.Y - a.Y));
    }
  }

  /** What is left to mark, for HasWork. */
  void CountLeft()
  {
    const std::size_t width = static_cast<std::size_t>(this->Columns) + 1;
    this->Left.assign(width * (static_cast<std::size_t>(this->Rows) + 1), 0);
    for (std::size_t row = 0; row < static_cast<std::size_t>(this->Rows); ++row)
    {
      int sum = 0;
      for (std::size_t column = 0; column + 1 < width; ++column)
      {
        sum += 1 - this->Marks[row * (width - 1) + column];
        this->Left[(row + 1) * width + column + 1] = this->Left[row * width + column + 1] + sum;
      }
    }
  }

  std::vector<unsigned char> TakeMarks() { return std::move(this->Marks); }

private:
  void Mark(float x, float y)
  {
    if (x >= 0.0F && y >= 0.0F && x < static_cast<float>(this->Columns) &&
      y < static_cast<float>(this->Rows))
    {
      const auto row = static_cast<std::size_t>(y);
      this->Marks[row * static_cast<std::size_t>(this->Columns) + static_cast<std::size_t>(x)] = 1;
    }
  }

  /** Whether there may be a cell to mark in the rectangle of two points; NaN has none. */
  bool HasWork(const CellPoint& a, const CellPoint& b) const
  {
    const float low[2] = { std::max(std::min(a.X, b.X), 0.0F), std::max(std::min(a.Y, b.Y), 0.0F) };
    const float high[2] = { std::max(a.X, b.X), std::max(a.Y, b.Y) };
    if (!(low[0] < static_cast<float>(this->Columns) && low[1] < static_cast<float>(this->Rows) &&
          high[0] >= 0.0F && high[1] >= 0.0F))
    {
      return false;
    }
    if (this->Left.empty())
    {
      return true;
    }
    const auto left = static_cast<std::size_t>(low[0]);
    const auto bottom = static_cast<std::size_t>(low[1]);
    const auto end = [](float last, int count)
    { return static_cast<std::size_t>(std::min(last, static_cast<float>(count - 1))) + 1; };
    const std::size_t right = end(high[0], this->Columns);
    const std::size_t top = end(high[1], this->Rows);
    const std::size_t width = static_cast<std::size_t>(this->Columns) + 1;
    return this->Left[top * width + right] - this->Left[bottom * width + right] -
      this->Left[top * width + left] + this->Left[bottom * width + left] >
      0;
  }

  int Columns;
  int Rows;
  std::vector<unsigned char> Marks;
  std::vector<int> Left; // sums over all cells below and to the left; empty: not counted yet
};

} // namespace

std::vector<unsigned char> CellsOfLine(
  const std::vector<float>& points, int columns, int rows, double marks)
{
  CellGrid grid(std::max(columns, 1), std::max(rows, 1));
  const std::size_t count = points.size() / 2;
  const auto at = [&points](std::size_t i) {
    return CellPoint{ points[2 * i], points[2 * i + 1] };
  };
  double cells = 0.0;
  for (std::size_t i = 0; i + 1 < count; ++i)
  {
    const double way = std::max(std::fabs(at(i + 1).X - at(i).X), std::fabs(at(i + 1).Y - at(i).Y));
    cells += std::min(way, static_cast<double>(columns) + rows);
  }
  auto stride = static_cast<std::size_t>(std::clamp(std::ceil(cells / marks), 1.0, 1e9));
  for (std::size_t i = 0; i + 1 < count; i += stride)
  {
    grid.AddSegment(at(i), at(i + 1));
  }
  while (stride > 1) // the more is marked, the less is left for the others
  {
    stride = std::max<std::size_t>(stride / 4, 1);
    grid.CountLeft();
    for (std::size_t i = 0; i + 1 < count; i += stride)
    {
      grid.AddSegment(at(i), at(i + 1));
    }
  }
  return grid.TakeMarks();
}

} // namespace pemesh
