// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// The second half of MarkPainter: clouds of points too many to be drawn one by one, as densities.
// Classes are mixed as in J. A. Cottam, A. Lumsdaine, P. Wang, Overplotting: unified solutions
// under abstract rendering, IEEE Big Data 2013, 9-16, doi:10.1109/BigData.2013.6691712.
#include "MarkPainter.h"

#include "LineCells.h"

#include <vtkContext2D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRect.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pemesh
{

PointDensity CountPoints(const ChartSeries& series, const PlotPlacement& place, double cellSize)
{
  PointDensity density;
  density.Columns = std::max(1, static_cast<int>(place.Area.Width / cellSize));
  density.Rows = std::max(1, static_cast<int>(place.Area.Height / cellSize));
  density.Counts.resize(static_cast<std::size_t>(density.Columns) * density.Rows);
  const double scaleX = density.Columns / (place.X.High - place.X.Low);
  const double scaleY = density.Rows / (place.Y.High - place.Y.Low);
  const std::vector<double>& xs = series.PlacesX();
  const std::vector<double>& ys = series.PlacesY();
  for (std::size_t i = 0; i < xs.size(); ++i)
  {
    const double column = (xs[i] - place.X.Low) * scaleX;
    const double row = (ys[i] - place.Y.Low) * scaleY;
    if (column >= 0.0 && row >= 0.0 && column < density.Columns && row < density.Rows) // not NaN
    {
      ++density.Counts[static_cast<std::size_t>(row) * density.Columns +
        static_cast<std::size_t>(column)];
    }
  }
  density.Largest = *std::max_element(density.Counts.begin(), density.Counts.end());
  return density;
}

void MarkPainter::DrawImage(const std::vector<ChartColor>& dots, int columns, int rows)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(columns, rows, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (const ChartColor& dot : dots)
  {
    bytes = std::copy(dot.begin(), dot.end(), bytes);
  }
  const Box& area = this->Place.Area;
  this->Painter.Context()->DrawImage(
    vtkRectf(static_cast<float>(area.X), static_cast<float>(area.Y), static_cast<float>(area.Width),
      static_cast<float>(area.Height)),
    image);
}

void MarkPainter::DrawDensity(const ChartSeries& series)
{
  const PointDensity density = CountPoints(series, this->Place, DensityCell * this->Em);
  std::vector<ChartColor> dots(density.Counts.size(), ChartColor{ 255, 255, 255, 0 });
  for (std::size_t i = 0; i < dots.size(); ++i)
  {
    if (density.Counts[i] > 0)
    {
      dots[i] = this->Colors.ColorOf(density.Counts[i]);
    }
  }
  this->DrawImage(dots, density.Columns, density.Rows);
}

namespace
{

/** What lies in a cell of the grid: sums over its points. */
struct CellSums
{
  double Points = 0.0;
  double Coloured = 0.0;       // of these, the ones whose value has a place on the colour scale
  double Place = 0.0;          // on it
  std::array<double, 3> Mix{}; // of the colours of the classes
};

/** Cells of few points are paler, but never invisible. */
unsigned char OpacityOfCount(double points, double most)
{
  constexpr double least = 0.4;
  const double part = most > 1.0 ? std::log(points) / std::log(most) : 1.0;
  return static_cast<unsigned char>(std::lround(255.0 * (least + (1.0 - least) * part)));
}

ChartColor ColorOfValues(const CellSums& sums, const ColorScale& colors)
{
  return sums.Coloured > 0.0 ? MapColor(*colors.Map, sums.Place / sums.Coloured) : UndefinedColor;
}

ChartColor ColorOfClasses(const CellSums& sums)
{
  ChartColor mixed{ 0, 0, 0, 255 };
  for (std::size_t channel = 0; channel < 3; ++channel)
  {
    mixed[channel] = static_cast<unsigned char>(std::lround(sums.Mix[channel] / sums.Points));
  }
  return mixed;
}

} // namespace

void MarkPainter::DrawMixedDensity()
{
  const Box& area = this->Place.Area;
  const double cell = DensityCell * this->Em;
  const int columns = std::max(1, static_cast<int>(area.Width / cell));
  const int rows = std::max(1, static_cast<int>(area.Height / cell));
  std::vector<CellSums> cells(static_cast<std::size_t>(columns) * rows);
  const double scaleX = columns / (this->Place.X.High - this->Place.X.Low);
  const double scaleY = rows / (this->Place.Y.High - this->Place.Y.Low);
  double most = 0.0;
  for (const ChartSeries& series : this->Plot.AllSeries)
  {
    const std::vector<double>& xs = series.PlacesX();
    const std::vector<double>& ys = series.PlacesY();
    const ChartColor color = this->Painter.ColorOfSeries(series.Style);
    for (std::size_t i = 0; series.OfRows && i < ys.size(); ++i)
    {
      const double x = (xs[i] - this->Place.X.Low) * scaleX;
      const double y = (ys[i] - this->Place.Y.Low) * scaleY;
      if (!(x >= 0.0 && y >= 0.0 && x < columns && y < rows)) // also where it is NaN
      {
        continue;
      }
      CellSums& sums = cells[static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x)];
      sums.Points += 1.0;
      most = std::max(most, sums.Points);
      if (series.Values.empty())
      {
        for (std::size_t channel = 0; channel < 3; ++channel)
        {
          sums.Mix[channel] += color[channel];
        }
      }
      else if (const double place = this->Colors.PlaceOf(series.Values[i]); !std::isnan(place))
      {
        sums.Coloured += 1.0;
        sums.Place += place;
      }
    }
  }
  const bool byValue = std::any_of(this->Plot.AllSeries.begin(), this->Plot.AllSeries.end(),
    [](const ChartSeries& series) { return !series.Values.empty(); });
  std::vector<ChartColor> dots(cells.size(), ChartColor{ 255, 255, 255, 0 });
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const CellSums& sums = cells[i];
    if (sums.Points == 0.0)
    {
      continue;
    }
    dots[i] = byValue ? ColorOfValues(sums, this->Colors) : ColorOfClasses(sums);
    dots[i][3] = OpacityOfCount(sums.Points, most);
  }
  this->DrawImage(dots, columns, rows);
}

bool MarkPainter::DrawTangle(const std::vector<float>& run, double width, const ChartColor& color)
{
  constexpr std::size_t few = 10000; // points
  const std::size_t count = run.size() / 2;
  double ways = 0.0;
  for (std::size_t i = 1; i < count; ++i)
  {
    ways += std::fabs(run[2 * i] - run[2 * i - 2]);
  }
  const Box& area = this->Place.Area;
  if (count < few || ways < 10.0 * area.Width)
  {
    return false;
  }
  const double cell = std::max(0.7 * width, 1.0);
  const int columns = std::max(1, static_cast<int>(area.Width / cell));
  const int rows = std::max(1, static_cast<int>(area.Height / cell));
  std::vector<float> points(run.size());
  for (std::size_t i = 0; i < count; ++i)
  {
    points[2 * i] = static_cast<float>((run[2 * i] - area.X) * columns / area.Width);
    points[2 * i + 1] = static_cast<float>((run[2 * i + 1] - area.Y) * rows / area.Height);
  }
  const std::vector<unsigned char> marks = CellsOfLine(points, columns, rows);
  std::vector<ChartColor> dots(marks.size(), ChartColor{ 255, 255, 255, 0 });
  for (std::size_t i = 0; i < marks.size(); ++i)
  {
    dots[i] = marks[i] ? color : dots[i];
  }
  this->DrawImage(dots, columns, rows);
  return true;
}

} // namespace pemesh
