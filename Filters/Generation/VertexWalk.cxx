// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "VertexWalk.h"

#include "Predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace pemesh
{

namespace
{

/** Of the regular polygon's edge. */
constexpr double RelativeClearance = 0.05;
/** What a vertex keeps from edges while it moves, of the clearance it keeps where it arrives. */
constexpr double PassingClearance = 0.01;
constexpr int MostColumns = 256;

double Between(double from, double to, double share)
{
  return from + share * (to - from);
}

double Distance(const Point2& point, const Point2& from, const Point2& to)
{
  const Point2 along = { to.x - from.x, to.y - from.y };
  const Point2 offset = { point.x - from.x, point.y - from.y };
  const double square = along.x * along.x + along.y * along.y;
  const double dot = offset.x * along.x + offset.y * along.y;
  const double s = square > 0.0 ? std::clamp(dot / square, 0.0, 1.0) : 0.0;
  const Point2 rest = { offset.x - s * along.x, offset.y - s * along.y };
  return std::sqrt(rest.x * rest.x + rest.y * rest.y);
}

/** Of segments that do not cross. */
double Distance(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  return std::min({ Distance(a, c, d), Distance(b, c, d), Distance(c, a, b), Distance(d, a, b) });
}

/** Also for some segments on one line that do not meet: such a step is not worth a case more. */
bool MayMeet(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
  return Orientation(a, b, c) * Orientation(a, b, d) <= 0 &&
    Orientation(c, d, a) * Orientation(c, d, b) <= 0;
}

bool IsInTriangle(const Point2& point, const Point2& a, const Point2& b, const Point2& c)
{
  const int first = Orientation(a, b, point);
  const int second = Orientation(b, c, point);
  const int third = Orientation(c, a, point);
  return (first >= 0 && second >= 0 && third >= 0) || (first <= 0 && second <= 0 && third <= 0);
}

/** Whether the segment from `from` to `to` has a point in the closed triangle. */
bool MeetsTriangle(
  const Point2& from, const Point2& to, const Point2& a, const Point2& b, const Point2& c)
{
  return IsInTriangle(from, a, b, c) || MayMeet(from, to, a, b) || MayMeet(from, to, b, c) ||
    MayMeet(from, to, c, a);
}

} // namespace

VertexWalk::VertexWalk(std::vector<Point2> vertices, RandomNumbers& random)
  : Vertices(std::move(vertices))
  , Random(random)
{
  const double count = static_cast<double>(this->Vertices.size());
  const double edge = 2.0 * std::numbers::pi / count;
  this->Clearance = RelativeClearance * edge;
  for (double length = 1.0; length > edge; length *= 0.5)
  {
    ++this->Levels;
  }
  this->Columns = std::clamp(static_cast<int>(2.0 * std::sqrt(count)), 1, MostColumns);
  this->Cells.resize(static_cast<std::size_t>(this->Columns) * this->Columns);
  this->Visited.assign(this->Vertices.size(), 0);
  for (int i = 0; i < static_cast<int>(this->Vertices.size()); ++i)
  {
    this->InsertEdge(i);
  }
}

void VertexWalk::Go(double tries)
{
  const double whole = std::floor(tries);
  for (double done = 0.0; done < whole; done += 1.0)
  {
    const Step step = this->DrawStep();
    if (this->IsFree(step))
    {
      this->Take(step);
    }
  }
  Step step = this->DrawStep();
  if (tries > whole && this->IsFree(step))
  {
    const double part = tries - whole;
    step.End = { Between(step.Start.x, step.End.x, part), Between(step.Start.y, step.End.y, part) };
    this->Take(step);
  }
}

VertexWalk::Step VertexWalk::DrawStep()
{
  const int count = static_cast<int>(this->Vertices.size());
  Step step;
  step.Vertex = this->Random.Below(count);
  step.Previous = (step.Vertex + count - 1) % count;
  step.Next = (step.Vertex + 1) % count;
  step.Start = this->Vertices[step.Vertex];
  const double length = std::ldexp(1.0, -this->Random.Below(this->Levels));
  step.End.x = step.Start.x + length * this->Random.Between(-1.0, 1.0);
  step.End.y = step.Start.y + length * this->Random.Between(-1.0, 1.0);
  return step;
}

bool VertexWalk::IsFree(const Step& step)
{
  const Point2& end = step.End;
  if (end.x * end.x + end.y * end.y > 1.0 || this->FoldsNeighbours(step))
  {
    return false;
  }
  const Point2& previous = this->Vertices[step.Previous];
  const Point2& next = this->Vertices[step.Next];
  const std::array<Point2, 4> hull = { previous, next, step.Start, end };
  const auto [west, east] = std::minmax({ previous.x, next.x, step.Start.x, end.x });
  const CellRange columns = this->CellsOf(west - this->Clearance, east + this->Clearance);
  ++this->Query;
  for (int column = columns.Low; column <= columns.High; ++column)
  {
    const CellRange rows = this->RowsOf(hull, column);
    for (int row = rows.Low; row <= rows.High; ++row)
    {
      if (this->AnyBlocks(this->CellAt(column, row), step))
      {
        return false;
      }
    }
  }
  return true;
}

/** The rows in which the hull of four points comes near a column. */
VertexWalk::CellRange VertexWalk::RowsOf(const std::array<Point2, 4>& hull, int column) const
{
  const double west = this->LowOf(column) - this->Clearance;
  const double east = this->LowOf(column + 1) + this->Clearance;
  double south = 1.0;
  double north = -1.0;
  for (const Point2& from : hull)
  {
    for (const Point2& to : hull)
    {
      const double width = to.x - from.x;
      const double first = width > 0.0 ? std::clamp((west - from.x) / width, 0.0, 1.0) : 0.0;
      const double last = width > 0.0 ? std::clamp((east - from.x) / width, 0.0, 1.0) : 0.0;
      if (to.x >= west && from.x <= east && width >= 0.0)
      {
        south = std::min({ south, Between(from.y, to.y, first), Between(from.y, to.y, last) });
        north = std::max({ north, Between(from.y, to.y, first), Between(from.y, to.y, last) });
      }
    }
  }
  return this->CellsOf(south - this->Clearance, north + this->Clearance);
}

bool VertexWalk::AnyBlocks(const std::vector<int>& cell, const Step& step)
{
  return std::any_of(cell.begin(), cell.end(),
    [&](int edge)
    {
      return std::exchange(this->Visited[edge], this->Query) != this->Query &&
        this->Blocks(edge, step);
    });
}

/** Whether the two edges at the vertex would come to lie nearly on each other. The angle between
 * them is smallest at one of the ends of the way; to pass a neighbour on the line through both is
 * what Blocks finds, because the neighbour then is in the triangle that the other edge sweeps. */
bool VertexWalk::FoldsNeighbours(const Step& step) const
{
  const Point2& previous = this->Vertices[step.Previous];
  const Point2& next = this->Vertices[step.Next];
  const double passing = PassingClearance * this->Clearance;
  return Orientation(previous, step.End, next) == 0 ||
    Orientation(step.Start, step.End, previous) == 0 ||
    Orientation(step.Start, step.End, next) == 0 ||
    Distance(previous, step.End, next) < this->Clearance ||
    Distance(next, previous, step.End) < this->Clearance ||
    Distance(previous, step.Start, step.End) < passing ||
    Distance(next, step.Start, step.End) < passing;
}

bool VertexWalk::Blocks(int edge, const Step& step) const
{
  if (edge == step.Previous || edge == step.Vertex)
  {
    return false; // these move along
  }
  const Point2& from = this->Vertices[edge];
  const Point2& to = this->EndOf(edge);
  const Point2& previous = this->Vertices[step.Previous];
  const Point2& next = this->Vertices[step.Next];
  if (Distance(from, to, step.Start, step.End) < PassingClearance * this->Clearance)
  {
    return true;
  }
  if (edge == step.Next)
  {
    return this->BlocksAsNeighbour(next, to, previous, step);
  }
  if (&to == &previous)
  {
    return this->BlocksAsNeighbour(previous, from, next, step);
  }
  return MeetsTriangle(from, to, previous, step.Start, step.End) ||
    MeetsTriangle(from, to, next, step.Start, step.End) ||
    Distance(from, to, previous, step.End) < this->Clearance ||
    Distance(from, to, step.End, next) < this->Clearance;
}

/** The same of the edge from `joint`, a neighbour of the vertex, to `other`: it meets one of the
 * edges that move in the joint anyway. Where it lies between the old and the new direction of that
 * edge, it crosses the way or ends in the triangle swept, in which the edge behind it is found. */
bool VertexWalk::BlocksAsNeighbour(
  const Point2& joint, const Point2& other, const Point2& opposite, const Step& step) const
{
  return Distance(other, joint, step.End) < this->Clearance ||
    Distance(step.End, joint, other) < this->Clearance ||
    MeetsTriangle(joint, other, opposite, step.Start, step.End) ||
    Distance(joint, other, opposite, step.End) < this->Clearance;
}

void VertexWalk::Take(const Step& step)
{
  this->RemoveEdge(step.Previous);
  this->RemoveEdge(step.Vertex);
  this->Vertices[step.Vertex] = step.End;
  this->InsertEdge(step.Previous);
  this->InsertEdge(step.Vertex);
}

const Point2& VertexWalk::EndOf(int edge) const
{
  const std::size_t next = static_cast<std::size_t>(edge) + 1;
  return this->Vertices[next == this->Vertices.size() ? 0 : next];
}

VertexWalk::CellRange VertexWalk::CellsOf(double low, double high) const
{
  const auto cell = [this](double x)
  {
    const double place = 0.5 * (x + 1.0) * this->Columns;
    return static_cast<int>(std::clamp(place, 0.0, this->Columns - 1.0));
  };
  return { cell(low), cell(high) };
}

std::vector<int>& VertexWalk::CellAt(int column, int row)
{
  return this->Cells[static_cast<std::size_t>(row) * this->Columns + column];
}

/** The cells that the segment crosses, up to rounding, which the clearance of queries makes up for.
 */
template <typename Function>
void VertexWalk::ForCellsAlong(Point2 from, Point2 to, const Function& function)
{
  if (from.x > to.x)
  {
    std::swap(from, to);
  }
  const CellRange columns = this->CellsOf(from.x, to.x);
  const double slope = to.x > from.x ? (to.y - from.y) / (to.x - from.x) : 0.0;
  for (int column = columns.Low; column <= columns.High; ++column)
  {
    const double west = this->LowOf(column);
    const double east = this->LowOf(column + 1);
    const double first = column == columns.Low ? from.y : from.y + slope * (west - from.x);
    const double last = column == columns.High ? to.y : from.y + slope * (east - from.x);
    const CellRange rows = this->CellsOf(std::min(first, last), std::max(first, last));
    for (int row = rows.Low; row <= rows.High; ++row)
    {
      function(this->CellAt(column, row));
    }
  }
}

void VertexWalk::InsertEdge(int edge)
{
  this->ForCellsAlong(this->Vertices[edge], this->EndOf(edge),
    [edge](std::vector<int>& cell) { cell.push_back(edge); });
}

void VertexWalk::RemoveEdge(int edge)
{
  this->ForCellsAlong(this->Vertices[edge], this->EndOf(edge),
    [edge](std::vector<int>& cell)
    {
      const auto found = std::find(cell.begin(), cell.end(), edge);
      if (found != cell.end())
      {
        *found = cell.back();
        cell.pop_back();
      }
    });
}

} // namespace pemesh
