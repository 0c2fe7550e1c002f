// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A page of Cairo in memory (PNG, SVG, PDF or plain pixels), and the text on it. Private to this
 * module.
 */
#ifndef pemesh_CairoCanvas_h
#define pemesh_CairoCanvas_h

#include <cairo.h>

#include <string>
#include <vector>

namespace pemesh
{

struct CanvasTextStyle
{
  double Size = 10.0; // of the em, in units
  std::string Family = "DejaVu Sans";
  bool Bold = false;
  double Angle = 0.0;  // degrees, anticlockwise
  int Horizontal = -1; // the anchor is at the left -1, centre 0, right 1 of the text
  int Vertical = -1;   // at its bottom -1, centre 0, top 1
  double Color[4] = { 0.0, 0.0, 0.0, 1.0 };
};

/** Sizes of a text that may have several lines. The box reaches from x, y = 0, 0 to the right, up.
 */
struct CanvasTextBox
{
  double Width = 0.0;
  double Height = 0.0;
};

class CairoCanvas
{
public:
  enum class Format
  {
    Png,
    Svg,
    Pdf,
    Pixels
  };

  /** Sizes in points; throws std::runtime_error where Cairo has no memory for it. */
  CairoCanvas(Format format, double width, double height, double dpi, double unitsPerPoint,
    const std::string& title);
  ~CairoCanvas();
  CairoCanvas(const CairoCanvas&) = delete;
  CairoCanvas& operator=(const CairoCanvas&) = delete;

  /** Units as given, y upwards. */
  cairo_t* Context() const { return this->Cairo; }

  void DrawText(double x, double y, const std::string& text, const CanvasTextStyle& style);

  /** Ends the page and returns the file, or its pixels row by row. */
  std::string Finish();

  /** That a length in points has. */
  static int NumberOfPixels(double length, double dpi);

  /** Does not need a page, and does not depend on it. */
  static CanvasTextBox MeasureText(const std::string& text, const CanvasTextStyle& style);

private:
  void DrawLineOfText(double x, double y, const std::string& line, const CanvasTextStyle& style);
  void RecordText(double x, double y, const std::string& line, const CanvasTextStyle& style);

  Format Kind;
  double Width;
  double Height;
  double Dpi;
  double Units;
  std::string Title;
  std::string Stream;
  std::string SvgText;
  cairo_surface_t* Surface = nullptr;
  cairo_t* Cairo = nullptr;
};

} // namespace pemesh

#endif
