// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What all panels draw with: text that fits, lines, legends. Private to this module.
 *
 * All sizes are in ems, the font size of the panel; positions are in units of the device.
 */
#ifndef pemesh_PanelPainter_h
#define pemesh_PanelPainter_h

#include "ChartStyle.h"
#include "ColorMaps.h"

#include <vtkNew.h>
#include <vtkPen.h>

#include <string>
#include <vector>

class vtkContext2D;

namespace pemesh
{

struct Box
{
  double X = 0.0;
  double Y = 0.0;
  double Width = 0.0;
  double Height = 0.0;

  double Right() const { return this->X + this->Width; }
  double Top() const { return this->Y + this->Height; }
  double MiddleX() const { return this->X + 0.5 * this->Width; }
  double MiddleY() const { return this->Y + 0.5 * this->Height; }
};

// The inks of a white page. A style with other colours of paper and ink replaces them.
inline constexpr ChartColor TextInk = { 34, 34, 34, 255 };
inline constexpr ChartColor AxisInk = { 90, 90, 90, 255 };
inline constexpr ChartColor FaintInk = { 110, 110, 110, 255 };
inline constexpr ChartColor GridInk = { 228, 228, 228, 255 };
inline constexpr ChartColor White = { 255, 255, 255, 255 };

struct PanelText
{
  double Size = 1.0; // ems
  bool Bold = false;
  int Horizontal = -1; // where the anchor is: left -1, centre 0, right 1
  int Vertical = 0;    // bottom -1, centre 0, top 1
  double Angle = 0.0;
  ChartColor Ink = TextInk;
};

/** Height of a line of text over its size. */
inline constexpr double LineSpacing = 1.164;

/** What stands before the text of an entry of a legend. */
struct LegendEntry
{
  std::string Text;
  ChartColor Color = { 0, 0, 0, 255 };
  int Marker = 0;                // of VTK; 0: none
  int LineType = vtkPen::NO_PEN; // of a line through the marker
  bool Band = false;             // a pale band behind the line
  bool Patch = false;            // a filled square
  bool Frame = false;            // an outlined square
};

class PanelPainter
{
public:
  PanelPainter(vtkContext2D* context, double em, const ChartStyle& style = {});

  double Em() const { return this->EmSize; }
  const ChartStyle& Style() const { return this->Look; }
  /** A length in points of the figure, in ems. */
  double Points(double length) const { return length / this->Look.FontSize; }
  /** Color of series i. */
  ChartColor ColorOfSeries(int i) const;
  /** The color that stands for one of the inks above; others stay what they are. */
  ChartColor Inked(const ChartColor& color) const;
  vtkContext2D* Context() const { return this->Device; }

  double TextWidth(const std::string& text, const PanelText& style = {});
  void Text(double x, double y, const std::string& text, const PanelText& style = {});

  /** Breaks text at blanks into at most `lines` lines of this width; what is left over ends in "…".
   */
  std::string Fit(const std::string& text, double width, int lines, const PanelText& style = {});

  /** Height of text of several lines. */
  double TextHeight(const std::string& text, const PanelText& style = {}) const;

  void Line(double x1, double y1, double x2, double y2, double ems, const ChartColor& color);
  void Poly(std::vector<float>& points, double ems, const ChartColor& color,
    int lineType = vtkPen::SOLID_LINE);
  void FillRectangle(const Box& box, const ChartColor& color);
  /** Closed shapes get a thin white edge, which keeps neighbours apart. */
  void Marker(int shape, double x, double y, double ems, const ChartColor& color, bool edge = true);

  /** Many markers of one shape and size in one go; colors (4 a point) may be null. */
  void Markers(int shape, std::vector<float>& points, double ems, const ChartColor& color,
    std::vector<unsigned char>* colors = nullptr);

  /** Fills a box with the color of the background, if that is not white. */
  void FillBackground(const Box& box);
  /** Writes a title at the top of a box and takes its height off the box. */
  void TakeTitle(Box& box, const std::string& title);
  /** Writes a small note at the bottom of a box and takes its height off the box. */
  void TakeNote(Box& box, const std::string& note);

  ///@{
  /** Entries flow in rows from the left. Height of the rows, and drawing below the top of a box. */
  double LegendHeight(const std::vector<LegendEntry>& entries, double width);
  /** Of entries one below the other. */
  double LegendWidth(const std::vector<LegendEntry>& entries);
  void DrawLegend(const Box& box, const std::vector<LegendEntry>& entries);
  ///@}

  void SetPen(double ems, const ChartColor& color, int lineType = vtkPen::SOLID_LINE);
  void SetBrush(const ChartColor& color);

private:
  void ApplyText(const PanelText& style);
  double LegendRowHeight() const;
  void DrawLegendGlyph(double x, double y, const LegendEntry& entry);
  double EntryWidth(const LegendEntry& entry, double width, std::string& text);

  vtkContext2D* Device;
  double EmSize;
  ChartStyle Look;
};

/** Distinct shapes and dashes for series i, any i >= 0. */
int SeriesMarker(int i);
int SeriesLineType(int i);

} // namespace pemesh

#endif
