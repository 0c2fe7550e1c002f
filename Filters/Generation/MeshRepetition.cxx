// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshRepetition.h"

#include "PolygonMeasures.h"
#include "PolygonValidity.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace pemesh
{

namespace
{

using Axis = double Point2::*;

Axis OtherAxis(Axis axis)
{
  return axis == &Point2::x ? &Point2::y : &Point2::x;
}

/** Where a coordinate of the box from `low` to `high` goes. Monotone, and exact at the ends. */
double Map(double value, double low, double high, const AxisCopy& copy, double divisor)
{
  if (value == low || value == high)
  {
    return (value == low) != copy.IsReflected ? copy.Low : copy.High;
  }
  const double length = (value - low) / divisor;
  return std::clamp(copy.IsReflected ? copy.High - length : copy.Low + length, copy.Low, copy.High);
}

/** The sides of elements on the line where a coordinate has a value, as intervals of the other. */
std::vector<std::pair<double, double>> SidesOn(const PolygonMesh& mesh, Axis axis, double value)
{
  std::vector<std::pair<double, double>> sides;
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    for (int side = mesh.Offsets[element]; side < mesh.Offsets[element + 1]; ++side)
    {
      const Point2& from = mesh.Points[mesh.Vertices[side]];
      const Point2& to = mesh.Points[mesh.Vertices[NextSide(mesh, element, side)]];
      if (from.*axis == value && to.*axis == value)
      {
        sides.push_back(std::minmax(from.*OtherAxis(axis), to.*OtherAxis(axis)));
      }
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/** Whether sides on two lines, laid upon each other, have a segment in common. */
bool ShareSegment(const PolygonMesh& mesh, Axis axis, double first, double second)
{
  const auto a = SidesOn(mesh, axis, first);
  const auto b = SidesOn(mesh, axis, second);
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();)
  {
    if (std::max(a[i].first, b[j].first) < std::min(a[i].second, b[j].second))
    {
      return true;
    }
    a[i].second < b[j].second ? ++i : ++j;
  }
  return false;
}

/** Empty, or a sentence on the seams of one axis that would hold nothing together. */
std::string FindSeamFault(const PolygonMesh& mesh, Axis axis, const std::vector<AxisCopy>& copies)
{
  const MeshBox box = BoxOfMesh(mesh);
  for (std::size_t i = 1; i < copies.size(); ++i)
  {
    const double first = copies[i - 1].IsReflected ? box.Low.*axis : box.High.*axis;
    const double second = copies[i].IsReflected ? box.High.*axis : box.Low.*axis;
    if (!ShareSegment(mesh, axis, first, second))
    {
      const bool isColumn = axis == &Point2::x;
      const bool isOneSide = first == second;
      return std::string("No segment of the border is common to the copies ") +
        (isColumn ? "side by side: " : "above each other: ") + "the domain has none on the " +
        (isColumn ? (isOneSide ? "east side" : "east and the west side")
                  : (isOneSide ? "north side" : "north and the south side")) +
        " of its bounding box; use a domain with straight sides there, such as a rectangle.";
    }
  }
  return {};
}

/** Puts the copies together. */
class Repeater
{
public:
  Repeater(const PolygonMesh& mesh, const MeshRepetition& repetition)
    : Mesh(mesh)
    , Repetition(repetition)
    , Box(BoxOfMesh(mesh))
    , NumberOfPoints(mesh.Points.size())
  {
  }

  RepeatedMesh Repeat()
  {
    this->MapPoints();
    this->WeldSeams();
    this->SortLines();
    for (int element = 0; element < this->Mesh.NumberOfElements(); ++element)
    {
      for (std::size_t row = 0; row < this->Repetition.Rows.size(); ++row)
      {
        for (std::size_t column = 0; column < this->Repetition.Columns.size(); ++column)
        {
          if (!this->AddCopy(element, column, row))
          {
            RepeatedMesh failed;
            failed.Message = "Element " + std::to_string(element) +
              " is too thin for its copies: rounding would spoil them; make it thicker, or repeat "
              "the mesh less often.";
            return failed;
          }
        }
      }
    }
    RemoveUnusedPoints(this->Result.Mesh); // those welded to others
    return std::move(this->Result);
  }

private:
  std::size_t PlaceOf(std::size_t column, std::size_t row) const
  {
    return (row * this->Repetition.Columns.size() + column) * this->NumberOfPoints;
  }

  void MapPoints()
  {
    const MeshRepetition& repetition = this->Repetition;
    std::vector<Point2>& points = this->Result.Mesh.Points;
    points.reserve(repetition.Columns.size() * repetition.Rows.size() * this->NumberOfPoints);
    for (const AxisCopy& row : repetition.Rows)
    {
      for (const AxisCopy& column : repetition.Columns)
      {
        for (const Point2& point : this->Mesh.Points)
        {
          points.push_back(
            { Map(point.x, this->Box.Low.x, this->Box.High.x, column, repetition.Divisor),
              Map(point.y, this->Box.Low.y, this->Box.High.y, row, repetition.Divisor) });
        }
      }
    }
    this->Number.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      this->Number[i] = static_cast<int>(i);
    }
  }

  static bool IsInnerEnd(const std::vector<AxisCopy>& copies, double value)
  {
    const auto beginsThere = [value](const AxisCopy& copy, double x) { return copy.Low < x; };
    const auto found = std::lower_bound(copies.begin() + 1, copies.end(), value, beginsThere);
    return found != copies.end() && found->Low == value;
  }

  /** One number for all points of seams with the same coordinates. */
  void WeldSeams()
  {
    const std::vector<Point2>& points = this->Result.Mesh.Points;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const Point2& source = this->Mesh.Points[i % this->NumberOfPoints];
      const bool isOnBox = source.x == this->Box.Low.x || source.x == this->Box.High.x ||
        source.y == this->Box.Low.y || source.y == this->Box.High.y;
      if (isOnBox &&
        (IsInnerEnd(this->Repetition.Columns, points[i].x) ||
          IsInnerEnd(this->Repetition.Rows, points[i].y)))
      {
        this->Columns.push_back(static_cast<int>(i));
      }
    }
    this->SortBy(&Point2::x, this->Columns);
    std::size_t kept = 0;
    for (const int point : this->Columns)
    {
      if (kept > 0 && points[this->Columns[kept - 1]] == points[point])
      {
        this->Number[point] = this->Columns[kept - 1];
      }
      else
      {
        this->Columns[kept++] = point;
      }
    }
    this->Columns.resize(kept);
  }

  void SortLines()
  {
    this->Rows = this->Columns;
    this->SortBy(&Point2::y, this->Rows);
  }

  /** By a coordinate, then the other, then the number. */
  void SortBy(Axis axis, std::vector<int>& numbers) const
  {
    const std::vector<Point2>& points = this->Result.Mesh.Points;
    std::sort(numbers.begin(), numbers.end(),
      [&](int a, int b)
      {
        const std::pair<double, double> left = { points[a].*axis, points[a].*OtherAxis(axis) };
        const std::pair<double, double> right = { points[b].*axis, points[b].*OtherAxis(axis) };
        return left != right ? left < right : a < b;
      });
  }

  bool AddCopy(int element, std::size_t column, std::size_t row)
  {
    const std::size_t place = this->PlaceOf(column, row);
    this->Corners.clear();
    for (const int vertex : this->Mesh.Element(element))
    {
      this->Corners.push_back(this->Number[place + vertex]);
    }
    if (this->Repetition.Columns[column].IsReflected != this->Repetition.Rows[row].IsReflected)
    {
      std::reverse(this->Corners.begin() + 1, this->Corners.end());
    }
    this->Vertices.clear();
    for (std::size_t i = 0; i < this->Corners.size(); ++i)
    {
      const int from = this->Corners[i];
      const int to = this->Corners[i + 1 == this->Corners.size() ? 0 : i + 1];
      this->Vertices.push_back(from);
      this->AddBetween(&Point2::x, this->Columns, from, to);
      this->AddBetween(&Point2::y, this->Rows, from, to);
    }
    this->Result.Mesh.AddElement(this->Vertices);
    this->Result.Sources.push_back(element);
    return this->IsLastSimple();
  }

  /** The welded points strictly between the ends of a side that lies on a seam; sorted lines hold
   * nothing of other lines between two points of one. */
  void AddBetween(Axis axis, const std::vector<int>& sorted, int from, int to)
  {
    const std::vector<Point2>& points = this->Result.Mesh.Points;
    const auto& copies = axis == &Point2::x ? this->Repetition.Columns : this->Repetition.Rows;
    if (points[from].*axis != points[to].*axis || !IsInnerEnd(copies, points[from].*axis))
    {
      return;
    }
    const Axis along = OtherAxis(axis);
    const auto comesBefore = [&](int a, int b)
    {
      return std::pair(points[a].*axis, points[a].*along) <
        std::pair(points[b].*axis, points[b].*along);
    };
    const bool isForward = points[from].*along < points[to].*along;
    const auto begin =
      std::upper_bound(sorted.begin(), sorted.end(), isForward ? from : to, comesBefore);
    const auto end = std::lower_bound(begin, sorted.end(), isForward ? to : from, comesBefore);
    const std::size_t first = this->Vertices.size();
    this->Vertices.insert(this->Vertices.end(), begin, end);
    if (!isForward)
    {
      std::reverse(
        this->Vertices.begin() + static_cast<std::ptrdiff_t>(first), this->Vertices.end());
    }
  }

  bool IsLastSimple()
  {
    const PolygonMesh& mesh = this->Result.Mesh;
    mesh.GetVertices(mesh.NumberOfElements() - 1, this->Polygon);
    return PolygonOrientation(this->Polygon) > 0 &&
      (this->Polygon.size() == 3 || IsSimple(this->Polygon));
  }

  const PolygonMesh& Mesh;
  const MeshRepetition& Repetition;
  MeshBox Box;
  std::size_t NumberOfPoints;
  RepeatedMesh Result;
  std::vector<int> Number;  ///< of each copy of each point: the one that stands for it
  std::vector<int> Columns; ///< the points of all seams, by x, then y
  std::vector<int> Rows;    ///< the same by y, then x
  std::vector<int> Corners;
  std::vector<int> Vertices;
  std::vector<Point2> Polygon;
};

} // namespace

MeshBox BoxOfMesh(const PolygonMesh& mesh)
{
  MeshBox box = { mesh.Points[0], mesh.Points[0] };
  for (const Point2& point : mesh.Points)
  {
    box.Low = { std::min(box.Low.x, point.x), std::min(box.Low.y, point.y) };
    box.High = { std::max(box.High.x, point.x), std::max(box.High.y, point.y) };
  }
  return box;
}

MeshRepetition MirrorOnce(const MeshBox& box)
{
  const auto copies = [](double low, double high) -> std::vector<AxisCopy>
  {
    const double middle = low + (high - low) / 2.0;
    return { { low, middle, false }, { middle, high, true } };
  };
  return { copies(box.Low.x, box.High.x), copies(box.Low.y, box.High.y), 2.0 };
}

MeshRepetition TileBox(const MeshBox& box, int columns, int rows)
{
  const double divisor = std::max(columns, rows);
  const auto copies = [divisor](double low, double high, int count)
  {
    std::vector<AxisCopy> list;
    const auto end = [&](int i) { return i == divisor ? high : low + i * (high - low) / divisor; };
    for (int i = 0; i < count; ++i)
    {
      list.push_back({ end(i), end(i + 1), false });
    }
    return list;
  };
  return { copies(box.Low.x, box.High.x, columns), copies(box.Low.y, box.High.y, rows), divisor };
}

RepeatedMesh RepeatMesh(PolygonMesh mesh, const MeshRepetition& repetition)
{
  RemoveUnusedPoints(mesh);
  RepeatedMesh failed;
  if (mesh.Points.empty())
  {
    failed.Message = "The mesh has no elements.";
    return failed;
  }
  const double copies =
    static_cast<double>(repetition.Columns.size()) * static_cast<double>(repetition.Rows.size());
  if (copies * std::max<double>(mesh.NumberOfSides(), static_cast<double>(mesh.Points.size())) >
    std::numeric_limits<int>::max() / 2.0) // half of it is left for vertices that seams add
  {
    failed.Message = "The repeated mesh would have too many elements; repeat it less often.";
    return failed;
  }
  failed.Message = FindSeamFault(mesh, &Point2::x, repetition.Columns);
  if (failed.Message.empty())
  {
    failed.Message = FindSeamFault(mesh, &Point2::y, repetition.Rows);
  }
  return failed.Message.empty() ? Repeater(mesh, repetition).Repeat() : failed;
}

} // namespace pemesh
