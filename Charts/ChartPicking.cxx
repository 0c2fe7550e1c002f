// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartPicking.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

struct DevicePoint
{
  double X;
  double Y;
};

double SquaredDistance(const DevicePoint& a, const DevicePoint& b)
{
  return (a.X - b.X) * (a.X - b.X) + (a.Y - b.Y) * (a.Y - b.Y);
}

/** The nearest mark so far. */
class Search
{
public:
  Search(const ChartPlot& plot, const PlotPlacement& place, double x, double y, double tolerance)
    : Plot(plot)
    , Place(place)
    , At{ x, y }
    , Best(tolerance * tolerance)
  {
  }

  /** Which of the values of a series: its ordinates, or an end of its band. */
  using Values = std::vector<double> ChartSeries::*;

  void Points(const ChartSeries& series, const std::vector<double>& places, Values values)
  {
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const DevicePoint point = this->ToDevice(series.PlacesX()[i], places[i]);
      const double distance = SquaredDistance(point, this->At);
      if (distance < this->Best && this->IsSeen(point)) // not where it is NaN
      {
        this->Best = distance;
        this->Pick = {};
        this->Pick.What = ChartPick::Kind::Point;
        this->Pick.Series = series.Label;
        this->Pick.Row = series.RowOf(i);
        this->Pick.X = series.X[i];
        this->Pick.Y = (series.*values)[i];
        this->Pick.DeviceX = point.X;
        this->Pick.DeviceY = point.Y;
      }
    }
  }

  void Segments(const ChartSeries& series)
  {
    const std::vector<double>& ys = series.PlacesY();
    for (std::size_t i = 0; i + 1 < ys.size(); ++i)
    {
      const DevicePoint a = this->ToDevice(series.PlacesX()[i], ys[i]);
      const DevicePoint b = this->ToDevice(series.PlacesX()[i + 1], ys[i + 1]);
      const double length = SquaredDistance(a, b);
      const double along = length > 0.0
        ? ((this->At.X - a.X) * (b.X - a.X) + (this->At.Y - a.Y) * (b.Y - a.Y)) / length
        : 0.0;
      const double part = std::clamp(along, 0.0, 1.0);
      const DevicePoint foot = { a.X + part * (b.X - a.X), a.Y + part * (b.Y - a.Y) };
      const double distance = SquaredDistance(foot, this->At);
      if (distance < this->Best)
      {
        this->Best = distance;
        this->Pick = {};
        this->Pick.What = ChartPick::Kind::Line;
        this->Pick.Series = series.Label;
        this->Pick.Row = series.RowOf(part < 0.5 ? i : i + 1);
        this->Pick.X = this->Plot.X.ValueAt(this->Place.PlaceX(foot.X));
        this->Pick.Y = this->Plot.Y.ValueAt(this->Place.PlaceY(foot.Y));
        this->Pick.DeviceX = foot.X;
        this->Pick.DeviceY = foot.Y;
      }
    }
  }

  ChartPick Pick;

private:
  DevicePoint ToDevice(double x, double y) const
  {
    return { this->Place.DeviceX(x), this->Place.DeviceY(y) };
  }
  bool IsSeen(const DevicePoint& point) const
  {
    const double slack = 1e-6 * (this->Place.Area.Width + this->Place.Area.Height);
    const Box& area = this->Place.Area;
    return point.X >= area.X - slack && point.X <= area.Right() + slack &&
      point.Y >= area.Y - slack && point.Y <= area.Top() + slack;
  }

  const ChartPlot& Plot;
  const PlotPlacement& Place;
  DevicePoint At;
  double Best;
};

/** Corners of a bar in the device; a foot without a place is the end of the axis. */
Box DeviceBox(const ChartPlot& plot, const PlotPlacement& place, const ChartBar& bar)
{
  const auto orElse = [](double value, double otherwise)
  { return std::isfinite(value) ? value : otherwise; };
  Box box;
  box.X = place.DeviceX(orElse(plot.X.PlaceOf(bar.Low[0]), place.X.Low));
  box.Y = place.DeviceY(orElse(plot.Y.PlaceOf(bar.Low[1]), place.Y.Low));
  box.Width = place.DeviceX(orElse(plot.X.PlaceOf(bar.High[0]), place.X.High)) - box.X;
  box.Height = place.DeviceY(orElse(plot.Y.PlaceOf(bar.High[1]), place.Y.High)) - box.Y;
  return box;
}

ChartPick PickBar(const ChartPlot& plot, const PlotPlacement& place, double x, double y)
{
  for (auto bar = plot.Bars.rbegin(); bar != plot.Bars.rend(); ++bar)
  {
    const Box box = DeviceBox(plot, place, *bar);
    if (x >= box.X && x <= box.Right() && y >= box.Y && y <= box.Top())
    {
      ChartPick pick;
      pick.What = ChartPick::Kind::Area;
      pick.Series = bar->Name;
      pick.Row = bar->Rows.size() == 1 ? bar->Rows.front() : -1;
      pick.X = 0.5 * (bar->Low[0] + bar->High[0]);
      pick.Y = bar->HasValue ? bar->Value : bar->High[1];
      pick.DeviceX = box.MiddleX();
      pick.DeviceY = box.MiddleY();
      return pick;
    }
  }
  return {};
}

} // namespace

int FindPlot(const std::vector<PlotPlacement>& placements, double x, double y)
{
  const auto found = std::find_if(placements.begin(), placements.end(),
    [x, y](const PlotPlacement& place) { return place.Contains(x, y); });
  return found == placements.end() ? -1 : static_cast<int>(found - placements.begin());
}

ChartPick PickMark(
  const ChartPlot& plot, const PlotPlacement& place, double x, double y, double tolerance)
{
  Search search(plot, place, x, y, tolerance);
  for (const ChartSeries& series : plot.AllSeries)
  {
    if (series.OfRows)
    {
      search.Points(series, series.PlacesY(), &ChartSeries::Y);
      search.Points(series, series.PlacesLower(), &ChartSeries::Lower);
      search.Points(series, series.PlacesUpper(), &ChartSeries::Upper);
    }
  }
  if (!search.Pick)
  {
    for (const ChartSeries& series : plot.AllSeries)
    {
      if (series.Joined)
      {
        search.Segments(series);
      }
    }
  }
  return search.Pick ? search.Pick : PickBar(plot, place, x, y);
}

void SelectRows(const ChartPlot& plot, const PlotPlacement& place, const Box& rectangle,
  std::vector<vtkIdType>& rows)
{
  // In places rather than in units of the device: one comparison a coordinate.
  const double left = place.PlaceX(std::max(rectangle.X, place.Area.X));
  const double right = place.PlaceX(std::min(rectangle.Right(), place.Area.Right()));
  const double bottom = place.PlaceY(std::max(rectangle.Y, place.Area.Y));
  const double top = place.PlaceY(std::min(rectangle.Top(), place.Area.Top()));
  for (const ChartSeries& series : plot.AllSeries)
  {
    const std::vector<double>& xs = series.PlacesX();
    for (std::size_t i = 0; series.OfRows && i < xs.size(); ++i)
    {
      const auto isIn = [&](const std::vector<double>& ys)
      { return !ys.empty() && ys[i] >= bottom && ys[i] <= top; };
      if (xs[i] >= left && xs[i] <= right &&
        (isIn(series.PlacesY()) || isIn(series.PlacesLower()) || isIn(series.PlacesUpper())))
      {
        rows.push_back(series.RowOf(i));
      }
    }
  }
  for (const ChartBar& bar : plot.Bars)
  {
    const Box box = DeviceBox(plot, place, bar);
    if (box.X <= rectangle.Right() && box.Right() >= rectangle.X && box.Y <= rectangle.Top() &&
      box.Top() >= rectangle.Y)
    {
      rows.insert(rows.end(), bar.Rows.begin(), bar.Rows.end());
    }
  }
}

} // namespace pemesh
