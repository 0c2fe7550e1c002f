// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshPainter.h"

#include "AxisTicks.h"
#include "ColorBar.h"
#include "TriangulatePolygon.h"
#include "vtkPEMCairoContextDevice2D.h"

#include <vtkContext2D.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pemesh
{

namespace
{

constexpr ChartColor PlainColor = { 236, 240, 244, 255 };
constexpr ChartColor FillerColor = { 238, 238, 238, 255 };
constexpr ChartColor OutlineInk = { 40, 40, 40, 255 };
constexpr ChartColor SmallestInk = { 0, 0, 0, 255 };
constexpr ChartColor LargestInk = { 213, 94, 0, 255 };
constexpr ChartColor MarkedInk = { 220, 0, 130, 255 };
constexpr ChartColor MarkedColor = { 252, 212, 233, 255 };
constexpr int CellLevels = 256;
constexpr int PointLevels = 128;
constexpr double SeamWidth = 0.03; // ems

/** The middle of level i of n has this place. */
double LevelPlace(int i, int n)
{
  return (i + 0.5) / n;
}

} // namespace

MeshPainter::MeshPainter(vtkContext2D* context, double em, vtkPolyData* mesh,
  const MeshStyle& style, const ChartStyle& look)
  : Painter(context, em, look)
  , Mesh(mesh)
  , Style(style)
  , Em(em)
{
  this->ReadElements();
  this->ReadBounds();
  this->FindClasses();
  if (this->Classes.empty())
  {
    this->MakeColorScale();
  }
  this->FindExtremes();
}

ChartColor MeshPainter::ClassColor(int value) const
{
  const auto found = std::find(this->Classes.begin(), this->Classes.end(), value);
  return found == this->Classes.end()
    ? FillerColor
    : SeriesColor(static_cast<int>(found - this->Classes.begin()));
}

std::vector<LegendEntry> MeshPainter::MakeLegend() const
{
  std::vector<LegendEntry> entries;
  for (const int value : this->Classes)
  {
    LegendEntry entry;
    entry.Text = static_cast<std::size_t>(value) < this->Style.ClassLabels.size()
      ? this->Style.ClassLabels[value]
      : std::to_string(value);
    entry.Color = this->ClassColor(value);
    entry.Patch = true;
    entries.push_back(entry);
  }
  const auto addExtreme = [&](vtkIdType element, const std::string& word, const ChartColor& color)
  {
    if (element >= 0)
    {
      LegendEntry entry;
      entry.Text = word + " " + ReadableNumber(this->CellValue(element)) + " (element " +
        std::to_string(element) + ")";
      entry.Color = color;
      entry.Frame = true;
      entries.push_back(entry);
    }
  };
  addExtreme(this->Smallest, "min", SmallestInk);
  addExtreme(this->Largest, "max", LargestInk);
  return entries;
}

std::string MeshPainter::MakeNote() const
{
  if (this->NumberOfElements() == 0 || this->Uncoloured == 0)
  {
    return this->Style.MarkNote;
  }
  const bool logarithmic = this->Colors.Logarithmic;
  return this->Style.MarkNote + (this->Style.MarkNote.empty() ? "" : " ") +
    "Grey: " + std::to_string(this->Uncoloured) +
    (this->Style.CellValues ? (this->Uncoloured == 1 ? " element" : " elements")
                            : (this->Uncoloured == 1 ? " vertex" : " vertices")) +
    " undefined" + (logarithmic ? " or not positive (logarithmic colours)." : ".");
}

void MeshPainter::FitIntoBox(Box box)
{
  const double width = this->Bounds[1] - this->Bounds[0];
  const double height = this->Bounds[3] - this->Bounds[2];
  const double edge = 0.15 * this->Em; // outlines on the boundary are drawn whole
  double bar = 0.0;
  if (this->HasColorBar)
  {
    bar = ColorBarWidth(this->Painter, this->Colors, this->Style.ColorTitle, box.Height);
  }
  const double roomX = std::max(this->Em, box.Width - bar - 2.0 * edge);
  const double roomY = std::max(this->Em, box.Height - 2.0 * edge);
  this->ScaleFactor =
    std::min(width > 0.0 ? roomX / width : 1e300, height > 0.0 ? roomY / height : 1e300);
  if (!(this->ScaleFactor < 1e300))
  {
    this->ScaleFactor = 1.0;
  }
  this->Picture.Width = this->ScaleFactor * width;
  this->Picture.Height = this->ScaleFactor * height;
  // The mesh and its colour bar together stand in the middle.
  this->Picture.X = box.X + edge + 0.5 * (roomX - this->Picture.Width);
  this->Picture.Y = box.Y + edge + 0.5 * (roomY - this->Picture.Height);
  this->OffsetX = this->Picture.X - this->ScaleFactor * this->Bounds[0];
  this->OffsetY = this->Picture.Y - this->ScaleFactor * this->Bounds[2];
  this->Placed.resize(this->Vertices.size());
  std::transform(this->Vertices.begin(), this->Vertices.end(), this->Placed.begin(),
    [this](const Point2& vertex) { return this->ToDevice(vertex); });
  if (this->HasColorBar)
  {
    // As high as the mesh, and higher where the mesh is a narrow strip.
    const double barHeight = std::min(box.Height, std::max(this->Picture.Height, 9.0 * this->Em));
    const double barBox =
      ColorBarWidth(this->Painter, this->Colors, this->Style.ColorTitle, barHeight);
    DrawColorBar(this->Painter, this->Colors, this->Style.ColorTitle,
      { this->Picture.Right() + edge, this->Picture.MiddleY() - 0.5 * barHeight, barBox,
        barHeight });
  }
}

Point2 MeshPainter::ToDevice(const Point2& point) const
{
  return { this->OffsetX + this->ScaleFactor * point.x,
    this->OffsetY + this->ScaleFactor * point.y };
}

bool MeshPainter::IsElement(vtkIdType element) const
{
  return element >= 0 && element < this->NumberOfElements();
}

std::span<const Point2> MeshPainter::ElementInDevice(vtkIdType element) const
{
  const std::size_t first = this->FirstOf[element];
  return std::span(this->Placed).subspan(first, this->FirstOf[element + 1] - first);
}

void MeshPainter::FillBatch(const PolygonBatch& batch, const ChartColor& color, double seamWidth)
{
  if (batch.Sizes.empty())
  {
    return;
  }
  vtkContext2D* context = this->Painter.Context();
  if (auto* cairo = vtkPEMCairoContextDevice2D::SafeDownCast(context->GetDevice()))
  {
    cairo->DrawPolygons(batch.Points, batch.Sizes, color.data(), seamWidth * this->Em);
    return;
  }
  // Other devices fill concave polygons wrongly: triangles for them.
  this->Painter.SetPen(0.0, color, vtkPen::NO_PEN);
  this->Painter.SetBrush(color);
  PolygonTriangulator triangulator;
  std::vector<Point2> polygon;
  const double* point = batch.Points.data();
  for (const int size : batch.Sizes)
  {
    polygon.clear();
    for (int i = 0; i < size; ++i, point += 2)
    {
      polygon.push_back({ point[0], point[1] });
    }
    for (const PolygonTriangle& triangle : triangulator.Triangulate(polygon))
    {
      float corners[6];
      for (int i = 0; i < 3; ++i)
      {
        corners[2 * i] = static_cast<float>(polygon[triangle[i]].x);
        corners[2 * i + 1] = static_cast<float>(polygon[triangle[i]].y);
      }
      context->DrawPolygon(corners, 3);
    }
  }
}

void MeshPainter::FillBatches(
  const std::vector<PolygonBatch>& batches, const std::vector<ChartColor>& colors, double seamWidth)
{
  for (std::size_t i = 0; i < batches.size(); ++i)
  {
    this->FillBatch(batches[i], colors[i], seamWidth);
  }
}

void MeshPainter::FillPlain()
{
  PolygonBatch batch;
  for (vtkIdType element = 0; element < this->NumberOfElements(); ++element)
  {
    batch.Add(this->ElementInDevice(element));
  }
  this->FillBatch(batch, PlainColor, SeamWidth);
  PolygonBatch marked; // frames alone do not tell on which side of them the elements are
  for (const vtkIdType element : this->Style.Marked)
  {
    if (this->IsElement(element))
    {
      marked.Add(this->ElementInDevice(element));
    }
  }
  this->FillBatch(marked, MarkedColor, SeamWidth);
}

void MeshPainter::FillByCells()
{
  // Elements of one colour are one path: fewer and larger shapes, and no seams among them. The last
  // batch holds what has no colour: undefined values, or elements of no class.
  const int levels = this->Classes.empty() ? CellLevels : static_cast<int>(this->Classes.size());
  std::vector<PolygonBatch> batches(levels + 1);
  std::vector<ChartColor> colors(levels + 1);
  colors[levels] = this->Classes.empty() ? UndefinedColor : FillerColor;
  for (int level = 0; level < levels; ++level)
  {
    colors[level] = this->Classes.empty() ? MapColor(*this->Colors.Map, LevelPlace(level, levels))
                                          : SeriesColor(level);
  }
  for (vtkIdType element = 0; element < this->NumberOfElements(); ++element)
  {
    const double value = this->CellValue(element);
    int level = levels;
    if (!this->Classes.empty())
    {
      const auto found =
        std::find(this->Classes.begin(), this->Classes.end(), static_cast<int>(value));
      level = static_cast<int>(found - this->Classes.begin());
    }
    else if (const double place = this->Colors.PlaceOf(value); std::isfinite(place))
    {
      level = std::min(static_cast<int>(place * levels), levels - 1);
    }
    batches[level].Add(this->ElementInDevice(element));
  }
  this->FillBatches(batches, colors, SeamWidth);
}

void MeshPainter::FillByPoints()
{
  std::vector<double> levels;
  for (int i = 0; i <= PointLevels; ++i)
  {
    levels.push_back(this->Colors.ValueAt(static_cast<double>(i) / PointLevels));
  }
  std::vector<PolygonBatch> batches(PointLevels + 1);
  std::vector<ChartColor> colors(PointLevels + 1, UndefinedColor);
  for (int level = 0; level < PointLevels; ++level)
  {
    colors[level] = MapColor(*this->Colors.Map, LevelPlace(level, PointLevels));
  }
  ContourBands bands(levels);
  PolygonTriangulator triangulator;
  for (vtkIdType element = 0; element < this->NumberOfElements(); ++element)
  {
    const std::size_t first = this->FirstOf[element];
    const std::span<const Point2> polygon = this->ElementInDevice(element);
    const auto valueAt = [&](int vertex)
    { return this->Style.PointValues->GetComponent(this->PointIds[first + vertex], 0); };
    for (const PolygonTriangle& corners : triangulator.Triangulate(polygon))
    {
      std::array<ValuedPoint, 3> triangle;
      std::array<Point2, 3> positions;
      bool defined = true;
      for (int i = 0; i < 3; ++i)
      {
        positions[i] = polygon[corners[i]];
        triangle[i] = { positions[i], valueAt(corners[i]) };
        defined = defined && std::isfinite(this->Colors.PlaceOf(triangle[i].Value));
      }
      if (defined)
      {
        bands.Cut(triangle, batches);
      }
      else
      {
        batches[PointLevels].Add(positions);
      }
    }
  }
  this->FillBatches(batches, colors, 0.0); // bands overlap
}

void MeshPainter::DrawOutlines()
{
  const vtkIdType elements = this->NumberOfElements();
  const double area = this->Picture.Width * this->Picture.Height;
  const double size =
    elements > 0 ? std::sqrt(area / static_cast<double>(elements)) / this->Em : 0.0;
  constexpr double tooSmall = 0.22; // ems: below, outlines would hide the colours
  if (!this->Style.Outlines || elements == 0 ||
    (this->Style.OutlinesAreAutomatic && size < tooSmall))
  {
    return;
  }
  PolygonBatch batch;
  for (vtkIdType element = 0; element < elements; ++element)
  {
    batch.Add(this->ElementInDevice(element));
  }
  this->Painter.SetPen(std::clamp(0.045 * size, 0.012, 0.06), OutlineInk);
  vtkContext2D* context = this->Painter.Context();
  if (auto* cairo = vtkPEMCairoContextDevice2D::SafeDownCast(context->GetDevice()))
  {
    cairo->DrawOutlines(batch.Points, batch.Sizes);
    return;
  }
  for (vtkIdType element = 0; element < elements; ++element)
  {
    this->DrawElementOutline(element, std::clamp(0.045 * size, 0.012, 0.06), OutlineInk);
  }
}

void MeshPainter::DrawElementOutline(vtkIdType element, double ems, const ChartColor& color)
{
  const std::span<const Point2> polygon = this->ElementInDevice(element);
  std::vector<float> line;
  line.reserve(2 * polygon.size() + 2);
  for (const Point2& point : polygon)
  {
    line.push_back(static_cast<float>(point.x));
    line.push_back(static_cast<float>(point.y));
  }
  line.insert(line.end(), { line[0], line[1] });
  this->Painter.Poly(line, ems, color);
}

void MeshPainter::MarkElement(vtkIdType element, const ChartColor& color, bool mayHaveRing)
{
  if (!this->IsElement(element))
  {
    return;
  }
  this->DrawElementOutline(element, 0.3, White);
  this->DrawElementOutline(element, 0.17, color);
  const std::span<const Point2> polygon = this->ElementInDevice(element);
  double low[2] = { 1e300, 1e300 };
  double high[2] = { -1e300, -1e300 };
  for (const Point2& point : polygon)
  {
    low[0] = std::min(low[0], point.x);
    low[1] = std::min(low[1], point.y);
    high[0] = std::max(high[0], point.x);
    high[1] = std::max(high[1], point.y);
  }
  const double extent = std::max(high[0] - low[0], high[1] - low[1]);
  if (mayHaveRing && extent < 2.0 * this->Em)
  {
    const double radius = 0.5 * extent + 0.9 * this->Em;
    constexpr int steps = 72;
    std::vector<float> ring;
    for (int i = 0; i <= steps; ++i)
    {
      const double angle = 2.0 * std::numbers::pi * (i % steps) / steps;
      ring.push_back(static_cast<float>(0.5 * (low[0] + high[0]) + radius * std::cos(angle)));
      ring.push_back(static_cast<float>(0.5 * (low[1] + high[1]) + radius * std::sin(angle)));
    }
    this->Painter.Poly(ring, 0.3, White);
    this->Painter.Poly(ring, 0.17, color);
  }
}

void MeshPainter::PlaceLegend(const std::vector<LegendEntry>& legend, const Box& box, double top)
{
  // In line with the mesh, unless that costs a row that was not reckoned with.
  const double room = box.Right() - this->Picture.X;
  const bool inLine =
    this->Painter.LegendHeight(legend, room) <= this->Painter.LegendHeight(legend, box.Width);
  const double x = inLine ? this->Picture.X : box.X;
  this->Painter.DrawLegend({ x, 0.0, box.Right() - x, top }, legend);
}

void MeshPainter::Paint(const Box& whole)
{
  Box box = whole;
  this->Painter.TakeTitle(box, this->Style.Title);
  this->Painter.TakeNote(box, this->MakeNote());
  const std::vector<LegendEntry> legend = this->MakeLegend();
  // Rings around elements at the boundary reach beyond it, and must not reach any text.
  const bool hasRings = this->Smallest >= 0 || this->Largest >= 0 || !this->Style.Marked.empty();
  const double gap = (hasRings ? 1.0 : 0.3) * this->Em;
  if (!legend.empty())
  {
    box.Height -= this->Painter.LegendHeight(legend, box.Width) + gap;
  }
  const double legendTop = legend.empty() ? box.Top() : box.Top() + gap;
  if (hasRings && !this->MakeNote().empty())
  {
    box.Y += 0.7 * this->Em;
    box.Height -= 0.7 * this->Em;
  }
  this->FitIntoBox(box);
  this->PlaceLegend(legend, box, legendTop + this->Painter.LegendHeight(legend, box.Width));
  if (this->NumberOfElements() == 0)
  {
    PanelText style;
    style.Horizontal = 0;
    style.Ink = FaintInk;
    this->Painter.Text(box.MiddleX(), box.MiddleY(), "no elements to draw", style);
    return;
  }
  if (this->Style.CellValues && (this->HasColorBar || !this->Classes.empty()))
  {
    this->FillByCells();
  }
  else if (this->Style.PointValues && this->HasColorBar)
  {
    this->FillByPoints();
  }
  else
  {
    this->FillPlain();
  }
  this->DrawOutlines();
  constexpr std::size_t mostRings = 30; // more would hide what they are around
  const auto mark = [&](const std::vector<vtkIdType>& elements, const ChartColor& color)
  {
    for (const vtkIdType element : elements)
    {
      this->MarkElement(element, color, elements.size() <= mostRings);
    }
  };
  mark(this->Style.Marked, MarkedInk);
  this->MarkElement(this->Smallest, SmallestInk, true);
  this->MarkElement(this->Largest, LargestInk, true);
  mark(this->Style.Highlighted, TextInk);
}

} // namespace pemesh
