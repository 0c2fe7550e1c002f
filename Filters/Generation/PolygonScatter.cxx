// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonScatter.h"

#include "NumberText.h"
#include "PolygonValidity.h"
#include "RandomNumbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace pemesh
{

namespace
{

constexpr int TriesPerPolygon = 10000;
constexpr double MostSeeds = 0x1p31;
/** More than rounding moves the vertices of a placed polygon. */
constexpr double Slack = 1e-9;

/** Half the side of the square that a polygon never leaves. */
double HalfSide(double scale)
{
  return 0.5 * UnitPolygonDiagonal * scale * (1.0 + Slack);
}

std::string WhyInvalid(const ScatterOptions& options)
{
  if (options.Count < 1)
  {
    return "The number of polygons to scatter is " + std::to_string(options.Count) +
      ", expected 1 or more.";
  }
  if (!(options.SmallestScale > 0.0 && options.SmallestScale <= options.LargestScale) ||
    !std::isfinite(options.LargestScale))
  {
    return "The scales of the polygons to scatter are " + FormatNumber(options.SmallestScale) +
      " to " + FormatNumber(options.LargestScale) +
      ", expected positive numbers, the smallest first.";
  }
  if (!(options.Gap >= 0.0) || !std::isfinite(options.Gap))
  {
    return "The gap between the polygons to scatter is " + FormatNumber(options.Gap) +
      ", expected 0 or more.";
  }
  return std::isfinite(options.LargestRotation)
    ? std::string()
    : "The largest rotation of the polygons to scatter is not a finite number of degrees.";
}

/** Empty, or a sentence on a name that is no family to scatter. */
std::string FindFamilies(
  const std::vector<std::string>& names, std::vector<const PolygonFamily*>& families)
{
  std::vector<std::string> known;
  for (const PolygonFamily& family : PolygonFamilies())
  {
    if (!family.IsFixed())
    {
      known.emplace_back(family.Name);
    }
  }
  for (const std::string& name : names.empty() ? known : names)
  {
    const PolygonFamily* family = FindPolygonFamily(name);
    if (!family || family->IsFixed())
    {
      return "There is no polygon family \"" + name + "\" to scatter; did you mean \"" +
        NearestWord(name, known) + "\"?";
    }
    families.push_back(family);
  }
  return {};
}

/** Squares in the domain, by cells at least as wide as the largest of them and the gap. */
class Squares
{
public:
  Squares(
    const Domain& domain, const ScatterOptions& options, std::span<const PolygonPlace> occupied)
    : Region(domain)
    , Gap(options.Gap)
    , Occupied(occupied)
    , Low(domain.Outer[0])
    , High(domain.Outer[0])
  {
    for (const Point2& point : domain.Outer)
    {
      this->Low = { std::min(this->Low.x, point.x), std::min(this->Low.y, point.y) };
      this->High = { std::max(this->High.x, point.x), std::max(this->High.y, point.y) };
    }
    const double least = 2.0 * HalfSide(options.LargestScale) + this->Gap;
    const double most = std::ceil(std::sqrt(static_cast<double>(options.Count)));
    const auto count = [&](double width)
    { return static_cast<int>(std::clamp(std::floor(width / least), 1.0, most)); };
    this->Columns = count(this->High.x - this->Low.x);
    this->Rows = count(this->High.y - this->Low.y);
    this->Cells.resize(static_cast<std::size_t>(this->Columns) * this->Rows);
  }

  /** Draws a place for a polygon of that scale and takes it; false if none was found. */
  bool Place(double scale, RandomNumbers& random, Point2& center)
  {
    const double margin = HalfSide(scale) + this->Gap;
    for (int i = 0; i < TriesPerPolygon; ++i)
    {
      center.x = random.Between(this->Low.x + margin, this->High.x - margin);
      center.y = random.Between(this->Low.y + margin, this->High.y - margin);
      if (this->IsFree({ center, scale }))
      {
        this->CellAt(this->ColumnOf(center.x), this->RowOf(center.y)).push_back({ center, scale });
        return true;
      }
    }
    return false;
  }

private:
  bool AreApart(const PolygonPlace& a, const PolygonPlace& b) const
  {
    const double distance =
      std::max(std::abs(a.Center.x - b.Center.x), std::abs(a.Center.y - b.Center.y));
    return distance > HalfSide(a.Scale) + HalfSide(b.Scale) + this->Gap;
  }

  bool IsFree(const PolygonPlace& place)
  {
    const auto isApart = [&](const PolygonPlace& other) { return this->AreApart(place, other); };
    const int column = this->ColumnOf(place.Center.x);
    const int row = this->RowOf(place.Center.y);
    for (int i = std::max(column - 1, 0); i <= std::min(column + 1, this->Columns - 1); ++i)
    {
      for (int j = std::max(row - 1, 0); j <= std::min(row + 1, this->Rows - 1); ++j)
      {
        const std::vector<PolygonPlace>& cell = this->CellAt(i, j);
        if (!std::all_of(cell.begin(), cell.end(), isApart))
        {
          return false;
        }
      }
    }
    return std::all_of(this->Occupied.begin(), this->Occupied.end(), isApart) &&
      this->IsInside(place);
  }

  bool IsInside(const PolygonPlace& place) const
  {
    const double half = HalfSide(place.Scale) + this->Gap;
    const Point2 low = { place.Center.x - half, place.Center.y - half };
    const Point2 high = { place.Center.x + half, place.Center.y + half };
    const std::array<Point2, 4> square = { low, { high.x, low.y }, high, { low.x, high.y } };
    return RelatePolygons(square, this->Region.Outer) == PolygonRelation::FirstInsideSecond &&
      std::all_of(this->Region.Holes.begin(), this->Region.Holes.end(),
        [&](const std::vector<Point2>& hole)
        { return RelatePolygons(square, hole) == PolygonRelation::Apart; });
  }

  static int CellOf(double place, int count)
  {
    return static_cast<int>(std::clamp(std::floor(place * count), 0.0, count - 1.0));
  }
  int ColumnOf(double x) const
  {
    return CellOf((x - this->Low.x) / (this->High.x - this->Low.x), this->Columns);
  }
  int RowOf(double y) const
  {
    return CellOf((y - this->Low.y) / (this->High.y - this->Low.y), this->Rows);
  }
  std::vector<PolygonPlace>& CellAt(int column, int row)
  {
    return this->Cells[static_cast<std::size_t>(row) * this->Columns + column];
  }

  const Domain& Region;
  double Gap;
  std::span<const PolygonPlace> Occupied;
  Point2 Low;
  Point2 High;
  int Columns;
  int Rows;
  std::vector<std::vector<PolygonPlace>> Cells;
};

} // namespace

std::string ScatterPolygons(const ScatterOptions& options, const Domain& domain,
  std::span<const PolygonPlace> occupied, std::vector<ScatteredPolygon>& scattered)
{
  scattered.clear();
  std::string fault = WhyInvalid(options);
  std::vector<const PolygonFamily*> families;
  if (fault.empty())
  {
    fault = FindFamilies(options.Families, families);
  }
  if (!fault.empty())
  {
    return fault;
  }
  RandomNumbers random(options.Seed);
  const int kinds = static_cast<int>(families.size());
  for (int i = 0; i < options.Count; ++i)
  {
    ScatteredPolygon& polygon = scattered.emplace_back();
    const int drawn = random.Below(kinds);
    polygon.Family = families[options.DrawsFamilies ? drawn : i % kinds];
    polygon.Place.Scale = random.Between(options.SmallestScale, options.LargestScale);
    polygon.Rotation = random.Between(0.0, options.LargestRotation);
    polygon.Seed = static_cast<std::uint64_t>(random.Uniform() * MostSeeds);
  }
  std::vector<int> order(scattered.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](int a, int b) { return scattered[a].Place.Scale > scattered[b].Place.Scale; });
  Squares squares(domain, options, occupied);
  for (std::size_t placed = 0; placed < order.size(); ++placed)
  {
    PolygonPlace& place = scattered[order[placed]].Place;
    if (!squares.Place(place.Scale, random, place.Center))
    {
      scattered.clear();
      return "Only " + std::to_string(placed) + " of " + std::to_string(options.Count) +
        " scattered polygons found a place with scales from " +
        FormatNumber(options.SmallestScale) + " to " + FormatNumber(options.LargestScale) +
        " and a gap of " + FormatNumber(options.Gap) +
        "; scatter fewer, or make the scales or the gap smaller.";
    }
  }
  return {};
}

} // namespace pemesh
