// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PanelPainter.h"

#include "FontFiles.h"
#include "vtkPEMCairoContextDevice2D.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkRenderingCoreEnums.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

constexpr double LegendRow = 1.44; // text sizes
constexpr double LegendGlyph = 1.9;
constexpr double LegendGap = 0.45;
constexpr double LegendSpace = 1.3;

PanelText TitleStyle(const ChartStyle& look)
{
  PanelText style;
  style.Size = look.TitleSize;
  style.Bold = true;
  style.Horizontal = 0;
  style.Vertical = 1;
  return style;
}

constexpr PanelText NoteStyle()
{
  PanelText style;
  style.Size = 0.82;
  style.Horizontal = -1;
  style.Vertical = -1;
  style.Ink = FaintInk;
  return style;
}

/** Squares and single markers need less room than lines. */
double GlyphWidth(const LegendEntry& entry)
{
  const bool line = entry.LineType != vtkPen::NO_PEN || entry.Band;
  return line ? LegendGlyph : 0.9;
}

PanelText LegendStyle(const ChartStyle& look)
{
  PanelText style;
  style.Size = look.LegendSize;
  return style;
}

/** Where the last character of UTF-8 text begins. */
std::size_t LastCharacter(const std::string& text)
{
  std::size_t start = text.size() - 1;
  while (start > 0 && (static_cast<unsigned char>(text[start]) & 0xC0) == 0x80)
  {
    --start;
  }
  return start;
}

} // namespace

int SeriesMarker(int i)
{
  constexpr int shapes[] = { VTK_MARKER_CIRCLE, VTK_MARKER_SQUARE, VTK_MARKER_DIAMOND,
    VTK_MARKER_CROSS, VTK_MARKER_PLUS };
  return shapes[i % std::size(shapes)];
}

int SeriesLineType(int i)
{
  constexpr int types[] = { vtkPen::SOLID_LINE, vtkPen::DASH_LINE, vtkPen::DASH_DOT_LINE,
    vtkPen::DOT_LINE };
  return types[i % std::size(types)];
}

PanelPainter::PanelPainter(vtkContext2D* context, double em, const ChartStyle& style)
  : Device(context)
  , EmSize(em)
  , Look(style)
{
}

double PanelPainter::LegendRowHeight() const
{
  return LegendRow * this->Look.LegendSize * this->EmSize;
}

ChartColor PanelPainter::ColorOfSeries(int i) const
{
  const ColorPalette* palette = FindColorPalette(this->Look.Palette);
  return palette ? SeriesColor(*palette, i) : SeriesColor(i);
}

ChartColor PanelPainter::Inked(const ChartColor& color) const
{
  static const ChartStyle standard;
  if (this->Look.Ink == standard.Ink && this->Look.Background == standard.Background)
  {
    return color;
  }
  // How far each of them is from the ink to the paper.
  const std::pair<ChartColor, double> places[] = { { TextInk, 0.0 }, { AxisInk, 0.25 },
    { FaintInk, 0.34 }, { GridInk, 0.88 }, { White, 1.0 } };
  for (const auto& [ink, part] : places)
  {
    if (ink == color)
    {
      return MixColors(ParseColor(this->Look.Ink), ParseColor(this->Look.Background), part);
    }
  }
  return color;
}

void PanelPainter::ApplyText(const PanelText& style)
{
  vtkNew<vtkTextProperty> property;
  property->SetFontFamilyAsString(this->Look.FontFamily.c_str());
  if (!vtkPEMCairoContextDevice2D::SafeDownCast(this->Device->GetDevice()))
  {
    // The fonts within VTK know no Greek letters, superscripts or arrows.
    property->SetFontFamily(VTK_FONT_FILE);
    property->SetFontFile(FindFontFile(this->Look.FontFamily, style.Bold).c_str());
  }
  property->SetFontSize(std::max(1, static_cast<int>(std::lround(style.Size * this->EmSize))));
  property->SetBold(style.Bold);
  property->SetJustification(VTK_TEXT_CENTERED + style.Horizontal);
  property->SetVerticalJustification(VTK_TEXT_CENTERED + style.Vertical);
  property->SetOrientation(style.Angle);
  const ChartColor ink = this->Inked(style.Ink);
  property->SetColor(ink[0] / 255.0, ink[1] / 255.0, ink[2] / 255.0);
  property->SetOpacity(ink[3] / 255.0);
  this->Device->ApplyTextProp(property);
}

double PanelPainter::TextWidth(const std::string& text, const PanelText& style)
{
  PanelText flat = style;
  flat.Angle = 0.0;
  this->ApplyText(flat);
  float bounds[4] = {};
  this->Device->ComputeStringBounds(text.c_str(), bounds);
  return bounds[2];
}

double PanelPainter::TextHeight(const std::string& text, const PanelText& style) const
{
  const auto lines = 1 + std::count(text.begin(), text.end(), '\n');
  return text.empty() ? 0.0 : static_cast<double>(lines) * LineSpacing * style.Size * this->EmSize;
}

void PanelPainter::Text(double x, double y, const std::string& text, const PanelText& style)
{
  if (!text.empty())
  {
    this->ApplyText(style);
    this->Device->DrawString(static_cast<float>(x), static_cast<float>(y), text.c_str());
  }
}

std::string PanelPainter::Fit(
  const std::string& text, double width, int lines, const PanelText& style)
{
  std::string result;
  std::string line;
  std::size_t start = 0;
  int number = 1;
  while (start < text.size())
  {
    const std::size_t end = std::min(text.find_first_of(" \n", start), text.size());
    const std::string word = text.substr(start, end - start);
    const std::string longer = line.empty() ? word : line + " " + word;
    if (number < lines && !line.empty() && this->TextWidth(longer, style) > width)
    {
      result += line + "\n";
      line = word;
      ++number;
    }
    else
    {
      line = longer;
    }
    start = end + 1;
  }
  if (this->TextWidth(line, style) > width)
  {
    while (!line.empty() && this->TextWidth(line + "…", style) > width)
    {
      line.erase(LastCharacter(line));
    }
    line += "…";
  }
  return result + line;
}

void PanelPainter::SetPen(double ems, const ChartColor& color, int lineType)
{
  vtkNew<vtkPen> pen;
  const ChartColor ink = this->Inked(color);
  pen->SetColor(ink[0], ink[1], ink[2], ink[3]);
  pen->SetWidth(static_cast<float>(ems * this->EmSize));
  pen->SetLineType(lineType);
  this->Device->ApplyPen(pen);
}

void PanelPainter::SetBrush(const ChartColor& color)
{
  vtkNew<vtkBrush> brush;
  const ChartColor ink = this->Inked(color);
  brush->SetColor(ink[0], ink[1], ink[2], ink[3]);
  this->Device->ApplyBrush(brush);
}

void PanelPainter::Line(
  double x1, double y1, double x2, double y2, double ems, const ChartColor& color)
{
  this->SetPen(ems, color);
  this->Device->DrawLine(
    static_cast<float>(x1), static_cast<float>(y1), static_cast<float>(x2), static_cast<float>(y2));
}

void PanelPainter::Poly(
  std::vector<float>& points, double ems, const ChartColor& color, int lineType)
{
  if (points.size() >= 4)
  {
    this->SetPen(ems, color, lineType);
    this->Device->DrawPoly(points.data(), static_cast<int>(points.size() / 2));
  }
}

void PanelPainter::FillRectangle(const Box& box, const ChartColor& color)
{
  this->SetBrush(color);
  float corners[8] = { static_cast<float>(box.X), static_cast<float>(box.Y),
    static_cast<float>(box.Right()), static_cast<float>(box.Y), static_cast<float>(box.Right()),
    static_cast<float>(box.Top()), static_cast<float>(box.X), static_cast<float>(box.Top()) };
  this->SetPen(0.0, color, vtkPen::NO_PEN);
  this->Device->DrawPolygon(corners, 4);
}

void PanelPainter::Marker(
  int shape, double x, double y, double ems, const ChartColor& color, bool edge)
{
  float point[2] = { static_cast<float>(x), static_cast<float>(y) };
  if (edge && shape != VTK_MARKER_CROSS && shape != VTK_MARKER_PLUS)
  {
    this->SetPen(ems + 0.1, White);
    this->Device->DrawMarkers(shape, false, point, 1);
  }
  this->SetPen(ems, color);
  this->Device->DrawMarkers(shape, false, point, 1);
}

void PanelPainter::Markers(int shape, std::vector<float>& points, double ems,
  const ChartColor& color, std::vector<unsigned char>* colors)
{
  this->SetPen(ems, color);
  this->Device->DrawMarkers(shape, false, points.data(), static_cast<int>(points.size() / 2),
    colors ? colors->data() : nullptr, 4);
}

void PanelPainter::FillBackground(const Box& box)
{
  if (this->Inked(White) != White)
  {
    this->FillRectangle(box, White);
  }
}

void PanelPainter::TakeTitle(Box& box, const std::string& title)
{
  if (title.empty())
  {
    return;
  }
  const std::string fitted = this->Fit(title, box.Width, 2, TitleStyle(this->Look));
  this->Text(box.MiddleX(), box.Top(), fitted, TitleStyle(this->Look));
  box.Height -= this->TextHeight(fitted, TitleStyle(this->Look)) + 0.35 * this->EmSize;
}

void PanelPainter::TakeNote(Box& box, const std::string& note)
{
  if (note.empty())
  {
    return;
  }
  const std::string fitted = this->Fit(note, box.Width, 3, NoteStyle());
  this->Text(box.X, box.Y, fitted, NoteStyle());
  const double height = this->TextHeight(fitted, NoteStyle()) + 0.35 * this->EmSize;
  box.Y += height;
  box.Height -= height;
}

double PanelPainter::EntryWidth(const LegendEntry& entry, double width, std::string& text)
{
  const double head = (GlyphWidth(entry) + LegendGap) * this->EmSize;
  text = this->Fit(entry.Text, std::max(width - head, this->EmSize), 1, LegendStyle(this->Look));
  return head + this->TextWidth(text, LegendStyle(this->Look));
}

double PanelPainter::LegendHeight(const std::vector<LegendEntry>& entries, double width)
{
  if (entries.empty())
  {
    return 0.0;
  }
  int rows = 1;
  double x = 0.0;
  std::string text;
  for (const LegendEntry& entry : entries)
  {
    const double entryWidth = this->EntryWidth(entry, width, text);
    if (x > 0.0 && x + entryWidth > width)
    {
      ++rows;
      x = 0.0;
    }
    x += entryWidth + LegendSpace * this->EmSize;
  }
  return rows * this->LegendRowHeight();
}

double PanelPainter::LegendWidth(const std::vector<LegendEntry>& entries)
{
  double width = 0.0;
  std::string text;
  for (const LegendEntry& entry : entries)
  {
    width = std::max(width, this->EntryWidth(entry, 1e9, text));
  }
  return width;
}

void PanelPainter::DrawLegend(const Box& box, const std::vector<LegendEntry>& entries)
{
  double x = 0.0;
  double y = box.Top() - 0.5 * this->LegendRowHeight();
  std::string text;
  for (const LegendEntry& entry : entries)
  {
    const double entryWidth = this->EntryWidth(entry, box.Width, text);
    if (x > 0.0 && x + entryWidth > box.Width)
    {
      x = 0.0;
      y -= this->LegendRowHeight();
    }
    this->DrawLegendGlyph(box.X + x, y, entry);
    this->Text(
      box.X + x + (GlyphWidth(entry) + LegendGap) * this->EmSize, y, text, LegendStyle(this->Look));
    x += entryWidth + LegendSpace * this->EmSize;
  }
}

void PanelPainter::DrawLegendGlyph(double x, double y, const LegendEntry& entry)
{
  const double em = this->EmSize;
  const double width = GlyphWidth(entry) * em;
  const double middle = x + 0.5 * width;
  const Box square = { middle - 0.4 * em, y - 0.4 * em, 0.8 * em, 0.8 * em };
  if (entry.Band)
  {
    ChartColor pale = entry.Color;
    pale[3] = 60;
    this->FillRectangle({ x, y - 0.4 * em, width, 0.8 * em }, pale);
  }
  if (entry.Patch)
  {
    this->FillRectangle(square, entry.Color);
  }
  if (entry.Patch || entry.Frame)
  {
    std::vector<float> corners = { static_cast<float>(square.X), static_cast<float>(square.Y),
      static_cast<float>(square.Right()), static_cast<float>(square.Y),
      static_cast<float>(square.Right()), static_cast<float>(square.Top()),
      static_cast<float>(square.X), static_cast<float>(square.Top()), static_cast<float>(square.X),
      static_cast<float>(square.Y) };
    this->Poly(corners, entry.Frame ? 0.18 : 0.04, entry.Frame ? entry.Color : AxisInk);
  }
  if (entry.LineType != vtkPen::NO_PEN)
  {
    std::vector<float> line = { static_cast<float>(x), static_cast<float>(y),
      static_cast<float>(x + width), static_cast<float>(y) };
    this->Poly(line, 0.15, entry.Color, entry.LineType);
  }
  if (entry.Marker != VTK_MARKER_NONE)
  {
    this->Marker(entry.Marker, middle, y, 0.55, entry.Color);
  }
}

} // namespace pemesh
