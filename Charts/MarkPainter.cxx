// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MarkPainter.h"

#include "LineThinning.h"
#include "vtkPEMCairoContextDevice2D.h"

#include <vtkContext2D.h>
#include <vtkContextDevice2D.h>
#include <vtkRenderingCoreEnums.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace pemesh
{

namespace
{

constexpr std::array<std::pair<std::string_view, int>, 6> Markers{
  { { "circle", VTK_MARKER_CIRCLE }, { "square", VTK_MARKER_SQUARE },
    { "diamond", VTK_MARKER_DIAMOND }, { "cross", VTK_MARKER_CROSS }, { "plus", VTK_MARKER_PLUS },
    { "none", VTK_MARKER_NONE } }
};
constexpr std::array<std::pair<std::string_view, int>, 4> LineTypes{
  { { "solid", vtkPen::SOLID_LINE }, { "dash", vtkPen::DASH_LINE },
    { "dash-dot", vtkPen::DASH_DOT_LINE }, { "dot", vtkPen::DOT_LINE } }
};

template <typename Table>
int Find(const Table& table, std::string_view name, int otherwise)
{
  const auto found = std::find_if(
    table.begin(), table.end(), [name](const auto& entry) { return entry.first == name; });
  return found == table.end() ? otherwise : found->second;
}

unsigned char Opacity(double part)
{
  return static_cast<unsigned char>(std::lround(255.0 * std::clamp(part, 0.0, 1.0)));
}

bool IsPoint(const ChartSeries& series, std::size_t i)
{
  return std::isfinite(series.PlacesX()[i]) && std::isfinite(series.PlacesY()[i]);
}

} // namespace

MarkPainter::MarkPainter(PanelPainter& painter, const ChartPlot& plot, const PlotPlacement& place,
  const ColorScale& colors, const std::vector<vtkIdType>& highlighted)
  : Painter(painter)
  , Plot(plot)
  , Place(place)
  , Colors(colors)
  , Highlighted(highlighted)
  , Em(painter.Em())
{
}

int MarkPainter::MarkerOf(
  const PanelPainter& painter, const ChartPlot& plot, const ChartSeries& series)
{
  constexpr std::size_t many = 60; // of a line: where markers would hide it
  if (!series.Marked || series.Y.empty() || plot.IsDensity ||
    (series.Joined && series.Y.size() > many))
  {
    return VTK_MARKER_NONE;
  }
  return Find(Markers, painter.Style().Marker, SeriesMarker(series.Style));
}

int MarkPainter::LineTypeOf(
  const PanelPainter& painter, const ChartPlot& plot, const ChartSeries& series)
{
  if (!series.Joined || series.Y.empty())
  {
    return vtkPen::NO_PEN;
  }
  // Markers already tell series apart, and dashes between them are hard to follow.
  const bool marked = MarkerOf(painter, plot, series) != VTK_MARKER_NONE;
  const int automatic =
    marked || !series.OfRows ? int(vtkPen::SOLID_LINE) : SeriesLineType(series.Style);
  return Find(LineTypes, painter.Style().Dashes, automatic);
}

double MarkPainter::MarkerSize(const ChartSeries& series) const
{
  if (this->Painter.Style().MarkerSize > 0.0)
  {
    return this->Painter.Points(this->Painter.Style().MarkerSize);
  }
  std::size_t points = 1;
  for (const ChartSeries& each : this->Plot.AllSeries)
  {
    points = std::max(points, each.X.size());
  }
  const double size = !series.Edged ? 0.35 : series.Joined ? 0.55 : 0.7;
  const double shrunk = size * std::pow(50.0 / static_cast<double>(points), 0.25);
  // Where the plot is a small one of many, its marks are smaller too.
  const double room = std::min(this->Place.Area.Width, this->Place.Area.Height) / this->Em;
  return std::clamp(shrunk, 0.25, size) * std::clamp(room / 12.0, 0.6, 1.0);
}

ChartColor MarkPainter::ColorOf(const ChartSeries& series, std::size_t point) const
{
  ChartColor color = series.Values.empty() ? this->Painter.ColorOfSeries(series.Style)
                                           : this->Colors.ColorOf(series.Values[point]);
  color[3] = Opacity(this->Painter.Style().MarkerOpacity);
  return color;
}

bool MarkPainter::IsHighlighted(vtkIdType row) const
{
  return std::binary_search(this->Highlighted.begin(), this->Highlighted.end(), row);
}

Box MarkPainter::DeviceBox(const ChartBar& bar) const
{
  // The foot of a bar on a logarithmic axis is the end of the axis.
  const auto x = [this](double value, double otherwise)
  {
    const double place = this->Plot.X.PlaceOf(value);
    return this->Place.DeviceX(std::isfinite(place) ? place : otherwise);
  };
  const auto y = [this](double value, double otherwise)
  {
    const double place = this->Plot.Y.PlaceOf(value);
    return this->Place.DeviceY(std::isfinite(place) ? place : otherwise);
  };
  Box box = { x(bar.Low[0], this->Place.X.Low), y(bar.Low[1], this->Place.Y.Low), 0.0, 0.0 };
  box.Width = x(bar.High[0], this->Place.X.High) - box.X;
  box.Height = y(bar.High[1], this->Place.Y.High) - box.Y;
  return box;
}

void MarkPainter::DrawBar(const ChartBar& bar)
{
  const Box box = this->DeviceBox(bar);
  ChartColor color =
    bar.HasValue ? this->Colors.ColorOf(bar.Value) : this->Painter.ColorOfSeries(bar.Style);
  const bool highlighted = std::any_of(
    bar.Rows.begin(), bar.Rows.end(), [this](vtkIdType row) { return this->IsHighlighted(row); });
  const ChartColor line = highlighted ? TextInk : bar.Pale ? color : White;
  color[3] = bar.Pale ? Opacity(this->Painter.Style().BandOpacity) : color[3];
  this->Painter.FillRectangle(box, color);
  std::vector<float> outline;
  for (const auto& [x, y] : { std::pair{ box.X, box.Y }, { box.Right(), box.Y },
         { box.Right(), box.Top() }, { box.X, box.Top() }, { box.X, box.Y } })
  {
    outline.push_back(static_cast<float>(x));
    outline.push_back(static_cast<float>(y));
  }
  this->Painter.Poly(outline, highlighted ? 0.18 : bar.Pale ? 0.12 : 0.05, line);
  if (bar.Text.empty() || this->BarTextSize == 0.0)
  {
    return;
  }
  PanelText text;
  text.Horizontal = 0;
  text.Size = this->BarTextSize;
  const bool dark = 0.3 * color[0] + 0.59 * color[1] + 0.11 * color[2] < 140.0 && !bar.Pale;
  text.Ink = dark ? ChartColor{ 255, 255, 255, 254 } : ChartColor{ 34, 34, 34, 254 };
  this->Painter.Text(box.MiddleX(), box.MiddleY(), bar.Text, text);
}

double MarkPainter::FindBarTextSize() const
{
  constexpr double usual = 0.72;
  constexpr double least = 0.5; // smaller cannot be read
  PanelText text;
  text.Size = usual;
  double size = usual;
  for (const ChartBar& bar : this->Plot.Bars)
  {
    if (!bar.Text.empty())
    {
      const Box box = this->DeviceBox(bar);
      size = std::min({ size, usual * 0.9 * box.Width / this->Painter.TextWidth(bar.Text, text),
        box.Height / (LineSpacing * this->Em) });
    }
  }
  return size >= least ? size : 0.0;
}

void MarkPainter::DrawShape(const ChartShape& shape)
{
  std::vector<float> points;
  for (std::size_t i = 0; i < shape.X.size(); ++i)
  {
    const double x = this->Plot.X.PlaceOf(shape.X[i]);
    const double y = this->Plot.Y.PlaceOf(shape.Y[i]);
    if (std::isfinite(x) && std::isfinite(y))
    {
      points.push_back(static_cast<float>(this->Place.DeviceX(x)));
      points.push_back(static_cast<float>(this->Place.DeviceY(y)));
    }
  }
  if (points.size() < 6)
  {
    return;
  }
  const ChartColor line = shape.Grey ? FaintInk : this->Painter.ColorOfSeries(shape.Style);
  ChartColor fill = shape.Grey ? GridInk : line;
  fill[3] = shape.Grey ? fill[3] : Opacity(this->Painter.Style().BandOpacity);
  this->Painter.SetPen(0.0, fill, vtkPen::NO_PEN);
  this->Painter.SetBrush(fill);
  const std::size_t count = points.size() / 2;
  if (shape.IsStrip)
  {
    // OpenGL fills concave polygons wrongly, and strips right.
    std::vector<float> strip;
    for (std::size_t i = 0; i < count / 2; ++i)
    {
      for (const std::size_t at : { i, count - 1 - i })
      {
        strip.insert(strip.end(), { points[2 * at], points[2 * at + 1] });
      }
    }
    this->Painter.Context()->DrawQuadStrip(strip.data(), static_cast<int>(strip.size() / 2));
  }
  else
  {
    this->Painter.Context()->DrawPolygon(points.data(), static_cast<int>(count));
  }
  points.insert(points.end(), points.begin(), points.begin() + 2);
  this->Painter.Poly(points, 0.1, line);
}

void MarkPainter::DrawBand(const ChartSeries& series)
{
  ChartColor color = this->Painter.ColorOfSeries(series.Style);
  color[3] = Opacity(this->Painter.Style().BandOpacity);
  const std::vector<double>& lower = series.PlacesLower();
  const std::vector<double>& upper = series.PlacesUpper();
  // Quadrangles rather than one polygon, which not every device fills right where it is concave.
  std::vector<float> strip;
  const auto finish = [&]()
  {
    if (strip.size() >= 8)
    {
      this->Painter.SetPen(0.0, color, vtkPen::NO_PEN);
      this->Painter.SetBrush(color);
      this->Painter.Context()->DrawQuadStrip(strip.data(), static_cast<int>(strip.size() / 2));
    }
    strip.clear();
  };
  for (std::size_t i = 0; i < lower.size(); ++i)
  {
    const double x = series.PlacesX()[i];
    if (!std::isfinite(x) || !std::isfinite(lower[i]) || !std::isfinite(upper[i]))
    {
      finish();
      continue;
    }
    for (const double y : { lower[i], upper[i] })
    {
      strip.push_back(static_cast<float>(this->Place.DeviceX(x)));
      strip.push_back(static_cast<float>(this->Place.DeviceY(y)));
    }
  }
  finish();
}

/** In pieces where it is long: the time of stroking a path grows with its crossings. */
void MarkPainter::DrawRun(
  std::vector<float>& run, double width, const ChartColor& color, int lineType)
{
  constexpr std::size_t piece = 256; // points
  const std::size_t points = run.size() / 2;
  if (lineType != vtkPen::SOLID_LINE || points <= 2 * piece)
  {
    this->Painter.Poly(run, width, color, lineType);
    return;
  }
  for (std::size_t first = 0; first + 1 < points; first += piece - 1)
  {
    const std::size_t last = std::min(first + piece, points);
    std::vector<float> part(run.begin() + static_cast<std::ptrdiff_t>(2 * first),
      run.begin() + static_cast<std::ptrdiff_t>(2 * last));
    this->Painter.Poly(part, width, color, lineType);
  }
}

void MarkPainter::DrawLines(const ChartSeries& series)
{
  const ChartColor color = this->Painter.ColorOfSeries(series.Style);
  const int lineType = LineTypeOf(this->Painter, this->Plot, series);
  const bool marked = MarkerOf(this->Painter, this->Plot, series) != VTK_MARKER_NONE;
  const double width = this->Painter.Points(this->Painter.Style().LineWidth);
  std::vector<float> run;
  const auto finish = [&]()
  {
    if (run.size() == 2 && !marked && series.OfRows)
    {
      // A value between two gaps has no line to be seen by.
      this->Painter.Marker(
        SeriesMarker(series.Style), run[0], run[1], this->MarkerSize(series), color);
    }
    const double column = 0.06 * this->Em;
    std::vector<float> strip = StripOfLine(run, column, 0.5 * width * this->Em);
    if (!strip.empty())
    {
      this->Painter.SetPen(0.0, color, vtkPen::NO_PEN);
      this->Painter.SetBrush(color);
      this->Painter.Context()->DrawQuadStrip(strip.data(), static_cast<int>(strip.size() / 2));
    }
    else if (!this->DrawTangle(run, width * this->Em, color))
    {
      ThinLine(run, column);
      this->DrawRun(run, width, color, lineType);
    }
    run.clear();
  };
  const Box& area = this->Place.Area;
  const double perX = area.Width / (0.5 * (this->Place.X.High - this->Place.X.Low));
  const double perY = area.Height / (0.5 * (this->Place.Y.High - this->Place.Y.Low));
  run.reserve(2 * series.Y.size());
  for (std::size_t i = 0; i < series.Y.size(); ++i)
  {
    if (!IsPoint(series, i))
    {
      finish();
      continue;
    }
    // As PlotPlacement, without a division a point.
    const double x = 0.5 * series.PlacesX()[i] - 0.5 * this->Place.X.Low;
    const double y = 0.5 * series.PlacesY()[i] - 0.5 * this->Place.Y.Low;
    run.push_back(static_cast<float>(area.X + perX * x));
    run.push_back(static_cast<float>(area.Y + perY * y));
  }
  finish();
}

void MarkPainter::DrawMarkers(const ChartSeries& series)
{
  const double size = this->MarkerSize(series);
  const int shape = MarkerOf(this->Painter, this->Plot, series);
  constexpr std::size_t many = 300; // where edges would be most of what is seen
  std::size_t all = 0;
  for (const ChartSeries& each : this->Plot.AllSeries)
  {
    all += each.OfRows ? each.X.size() : 0;
  }
  const bool edges = series.Edged && this->Painter.Style().MarkerEdges && all <= many;
  // In a file every marker has its edge above its neighbours; in a window a call a marker is slow.
  vtkContextDevice2D* device = this->Painter.Context()->GetDevice();
  const bool oneByOne = vtkPEMCairoContextDevice2D::SafeDownCast(device) != nullptr;
  std::vector<float> points;
  std::vector<unsigned char> colors;
  for (std::size_t i = 0; i < series.Y.size(); ++i)
  {
    if (!IsPoint(series, i))
    {
      continue;
    }
    const ChartColor color = this->ColorOf(series, i);
    const double x = this->Place.DeviceX(series.PlacesX()[i]);
    const double y = this->Place.DeviceY(series.PlacesY()[i]);
    if (edges && oneByOne)
    {
      this->Painter.Marker(shape, x, y, size, color, true);
      continue;
    }
    points.push_back(static_cast<float>(x));
    points.push_back(static_cast<float>(y));
    colors.insert(colors.end(), color.begin(), color.end());
  }
  if (!points.empty())
  {
    if (edges && shape != VTK_MARKER_CROSS && shape != VTK_MARKER_PLUS)
    {
      this->Painter.Markers(shape, points, size + 0.1, White);
    }
    this->Painter.Markers(shape, points, size, this->Painter.ColorOfSeries(series.Style), &colors);
  }
}

void MarkPainter::DrawHighlights(const ChartSeries& series)
{
  if (this->Highlighted.empty() || !series.OfRows || series.Y.empty())
  {
    return;
  }
  const int shape = std::max(VTK_MARKER_NONE + 1, SeriesMarker(series.Style));
  const double size = std::max(this->MarkerSize(series), 0.5);
  for (std::size_t i = 0; i < series.Y.size(); ++i)
  {
    if (IsPoint(series, i) && this->IsHighlighted(series.RowOf(i)))
    {
      const double x = this->Place.DeviceX(series.PlacesX()[i]);
      const double y = this->Place.DeviceY(series.PlacesY()[i]);
      this->Painter.Marker(VTK_MARKER_CIRCLE, x, y, size + 0.7, TextInk, false);
      this->Painter.Marker(VTK_MARKER_CIRCLE, x, y, size + 0.4, White, false);
      this->Painter.Marker(shape, x, y, size, this->ColorOf(series, i), false);
    }
  }
}

void MarkPainter::DrawText(const ChartText& text)
{
  PanelText style;
  style.Size = this->Painter.Style().TickSize;
  style.Horizontal = text.Horizontal;
  style.Vertical = text.Vertical;
  const double x = this->Plot.X.PlaceOf(text.X);
  const double y = this->Plot.Y.PlaceOf(text.Y);
  if (std::isfinite(x) && std::isfinite(y))
  {
    const double gap = 0.3 * this->Em;
    this->Painter.Text(this->Place.DeviceX(x) - gap * text.Horizontal,
      this->Place.DeviceY(y) - 0.1 * gap * text.Vertical, text.Text, style);
  }
}

void MarkPainter::Draw()
{
  for (const ChartShape& shape : this->Plot.Shapes)
  {
    this->DrawShape(shape);
  }
  this->BarTextSize = this->FindBarTextSize();
  for (const ChartBar& bar : this->Plot.Bars)
  {
    this->DrawBar(bar);
  }
  for (const ChartSeries& series : this->Plot.AllSeries)
  {
    this->DrawBand(series);
  }
  if (this->Plot.IsDensity && !CountsPoints(this->Plot))
  {
    this->DrawMixedDensity();
  }
  for (const ChartSeries& series : this->Plot.AllSeries)
  {
    if (this->Plot.IsDensity && series.OfRows)
    {
      if (CountsPoints(this->Plot))
      {
        this->DrawDensity(series);
      }
      continue;
    }
    if (series.Joined)
    {
      this->DrawLines(series);
    }
    if (MarkerOf(this->Painter, this->Plot, series) != VTK_MARKER_NONE)
    {
      this->DrawMarkers(series);
    }
  }
  for (const ChartSeries& series : this->Plot.AllSeries)
  {
    this->DrawHighlights(series);
  }
  for (const ChartText& text : this->Plot.Texts)
  {
    this->DrawText(text);
  }
}

} // namespace pemesh
