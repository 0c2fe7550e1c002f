// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// The second half of MarkPainter: clouds of points too many to be drawn one by one, as images.
#include "MarkPainter.h"

#include <vtkContext2D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRect.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

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

void MarkPainter::DrawDots(const ChartSeries& series)
{
  // In a window, where a unit is a pixel, no finer than can be seen.
  const double cell = std::max(0.07 * this->Em, 1.5);
  const Box& area = this->Place.Area;
  const int columns = std::max(1, static_cast<int>(area.Width / cell));
  const int rows = std::max(1, static_cast<int>(area.Height / cell));
  constexpr ChartColor empty = { 255, 255, 255, 0 };
  std::vector<ChartColor> dots(static_cast<std::size_t>(columns) * rows, empty);
  std::vector<unsigned char> isMiddle(dots.size(), 0);
  const double scaleX = columns / (this->Place.X.High - this->Place.X.Low);
  const double scaleY = rows / (this->Place.Y.High - this->Place.Y.Low);
  const std::vector<double>& xs = series.PlacesX();
  const std::vector<double>& ys = series.PlacesY();
  // From the last point to the first, and only where there is none yet: later rows lie above, and
  // of many points in one place only one costs anything.
  for (std::size_t i = xs.size(); i-- > 0;)
  {
    const double x = (xs[i] - this->Place.X.Low) * scaleX;
    const double y = (ys[i] - this->Place.Y.Low) * scaleY;
    if (!(x >= 0.0 && y >= 0.0 && x < columns && y < rows)) // also where it is NaN
    {
      continue;
    }
    const auto column = static_cast<int>(x);
    const auto row = static_cast<int>(y);
    const std::size_t middle = static_cast<std::size_t>(row) * columns + column;
    if (isMiddle[middle] != 0)
    {
      continue;
    }
    isMiddle[middle] = 1;
    const ChartColor color = this->ColorOf(series, i);
    // Five by five cells without the corners: a round dot.
    for (int dy = std::max(-2, -row); dy <= std::min(2, rows - 1 - row); ++dy)
    {
      const int reach = std::abs(dy) == 2 ? 1 : 2;
      const int last = std::min(columns - 1, column + reach);
      for (int at = std::max(0, column - reach); at <= last; ++at)
      {
        ChartColor& dot = dots[static_cast<std::size_t>(row + dy) * columns + at];
        dot = dot[3] == 0 ? color : dot;
      }
    }
  }
  this->DrawImage(dots, columns, rows);
}

} // namespace pemesh
