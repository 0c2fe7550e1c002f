// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CairoCanvas.h"

#include "NumberText.h"
#include "SvgText.h"
#include "XmlText.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string_view>

namespace pemesh
{

namespace
{

constexpr const char* FontFamily = "DejaVu Sans";
// Of DejaVu Sans, in ems: a box around every letter with accents and descenders.
constexpr double Ascent = 0.928;
constexpr double Descent = 0.236;
constexpr double LineHeight = Ascent + Descent;

cairo_status_t Append(void* stream, const unsigned char* data, unsigned int length)
{
  static_cast<std::string*>(stream)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/** Without hinting, widths are proportional to the size and equal on all surfaces. */
cairo_font_options_t* MakeFontOptions()
{
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  return options;
}

double MeasureLine(const std::string& line, const CanvasTextStyle& style)
{
  constexpr double size = 1000.0; // any: the result is in ems
  cairo_matrix_t fontMatrix;
  cairo_matrix_t identity;
  cairo_matrix_init_scale(&fontMatrix, size, size);
  cairo_matrix_init_identity(&identity);
  cairo_font_options_t* options = MakeFontOptions();
  cairo_font_face_t* face = cairo_toy_font_face_create(style.Family.c_str(),
    CAIRO_FONT_SLANT_NORMAL, style.Bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_scaled_font_t* font = cairo_scaled_font_create(face, &fontMatrix, &identity, options);
  cairo_text_extents_t extents = {};
  cairo_scaled_font_text_extents(font, line.c_str(), &extents);
  cairo_scaled_font_destroy(font);
  cairo_font_face_destroy(face);
  cairo_font_options_destroy(options);
  return extents.x_advance / size;
}

std::vector<std::string> SplitLines(const std::string& text)
{
  std::vector<std::string> lines;
  std::size_t start = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', start))
  {
    lines.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  lines.push_back(text.substr(start));
  return lines;
}

std::string Rounded(double value)
{
  const double rounded = std::round(value * 1000.0) / 1000.0;
  return FormatNumber(rounded == 0.0 ? 0.0 : rounded);
}

std::string HexColor(const double color[3])
{
  constexpr const char* digits = "0123456789abcdef";
  std::string text = "#";
  for (int channel = 0; channel < 3; ++channel)
  {
    const long byte = std::lround(255.0 * std::clamp(color[channel], 0.0, 1.0));
    text += { digits[byte / 16], digits[byte % 16] };
  }
  return text;
}

std::uint32_t Crc32(std::string_view bytes)
{
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const char byte : bytes)
  {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit)
    {
      crc = (crc >> 1) ^ ((crc & 1u) ? 0xEDB88320u : 0u);
    }
  }
  return ~crc;
}

void AppendBigEndian(std::string& bytes, std::uint32_t value)
{
  for (int shift = 24; shift >= 0; shift -= 8)
  {
    bytes += static_cast<char>((value >> shift) & 0xFFu);
  }
}

/** Cairo does not write the resolution (chunk pHYs), which programs take the printed size from. */
void AddResolution(std::string& png, double dpi)
{
  constexpr std::size_t afterHeader = 8 + 25; // signature and IHDR
  if (png.size() < afterHeader)
  {
    return;
  }
  const auto pixelsPerMetre = static_cast<std::uint32_t>(std::lround(dpi / 0.0254));
  std::string body = "pHYs";
  AppendBigEndian(body, pixelsPerMetre);
  AppendBigEndian(body, pixelsPerMetre);
  body += '\1'; // the unit is the metre
  std::string chunk;
  AppendBigEndian(chunk, static_cast<std::uint32_t>(body.size() - 4));
  chunk += body;
  AppendBigEndian(chunk, Crc32(body));
  png.insert(afterHeader, chunk);
}

} // namespace

CairoCanvas::CairoCanvas(Format format, double width, double height, double dpi,
  double unitsPerPoint, const std::string& title)
  : Kind(format)
  , Width(width)
  , Height(height)
  , Dpi(dpi)
  , Units(unitsPerPoint)
  , Title(title)
{
  double scaleX = 1.0 / unitsPerPoint;
  double scaleY = scaleX;
  if (format == Format::Png || format == Format::Pixels)
  {
    const int columns = NumberOfPixels(width, dpi);
    const int rows = NumberOfPixels(height, dpi);
    this->Surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns, rows);
    scaleX *= columns / width;
    scaleY *= rows / height;
  }
  else if (format == Format::Svg)
  {
    this->Surface = cairo_svg_surface_create_for_stream(Append, &this->Stream, width, height);
  }
  else
  {
    this->Surface = cairo_pdf_surface_create_for_stream(Append, &this->Stream, width, height);
    // The date would make every file differ.
    cairo_pdf_surface_set_metadata(this->Surface, CAIRO_PDF_METADATA_CREATE_DATE, nullptr);
    cairo_pdf_surface_set_metadata(this->Surface, CAIRO_PDF_METADATA_TITLE, title.c_str());
    cairo_pdf_surface_set_metadata(this->Surface, CAIRO_PDF_METADATA_CREATOR, "PEMesh");
  }
  this->Cairo = cairo_create(this->Surface);
  if (cairo_status(this->Cairo) != CAIRO_STATUS_SUCCESS)
  {
    const std::string reason = cairo_status_to_string(cairo_status(this->Cairo));
    cairo_destroy(this->Cairo);
    cairo_surface_destroy(this->Surface);
    throw std::runtime_error("The figure cannot be made (" + reason + "): make it smaller.");
  }
  cairo_set_source_rgb(this->Cairo, 1.0, 1.0, 1.0);
  cairo_paint(this->Cairo);
  cairo_scale(this->Cairo, scaleX, -scaleY);
  cairo_translate(this->Cairo, 0.0, -height * unitsPerPoint);
  cairo_set_line_join(this->Cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_font_options_t* options = MakeFontOptions();
  cairo_set_font_options(this->Cairo, options);
  cairo_font_options_destroy(options);
}

int CairoCanvas::NumberOfPixels(double length, double dpi)
{
  return std::max(1, static_cast<int>(std::lround(length * dpi / 72.0)));
}

CairoCanvas::~CairoCanvas()
{
  cairo_destroy(this->Cairo);
  cairo_surface_destroy(this->Surface);
}

CanvasTextBox CairoCanvas::MeasureText(const std::string& text, const CanvasTextStyle& style)
{
  CanvasTextBox box;
  for (const std::string& line : SplitLines(text))
  {
    box.Width = std::max(box.Width, style.Size * MeasureLine(line, style));
    box.Height += style.Size * LineHeight;
  }
  return box;
}

void CairoCanvas::DrawText(
  double x, double y, const std::string& text, const CanvasTextStyle& style)
{
  const std::vector<std::string> lines = SplitLines(text);
  const double height = style.Size * LineHeight * static_cast<double>(lines.size());
  // Height of the first baseline over the anchor, before turning.
  double baseline = height * (1 - style.Vertical) / 2.0 - style.Size * Ascent;
  const double angle = style.Angle * std::numbers::pi / 180.0;
  for (const std::string& line : lines)
  {
    DrawLineOfText(x - baseline * std::sin(angle), y + baseline * std::cos(angle), line, style);
    baseline -= style.Size * LineHeight;
  }
}

void CairoCanvas::DrawLineOfText(
  double x, double y, const std::string& line, const CanvasTextStyle& style)
{
  if (line.empty())
  {
    return;
  }
  if (this->Kind == Format::Svg)
  {
    this->RecordText(x, y, line, style);
    return;
  }
  cairo_save(this->Cairo);
  cairo_translate(this->Cairo, x, y);
  cairo_rotate(this->Cairo, style.Angle * std::numbers::pi / 180.0);
  cairo_scale(this->Cairo, 1.0, -1.0);
  cairo_select_font_face(this->Cairo, style.Family.c_str(), CAIRO_FONT_SLANT_NORMAL,
    style.Bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(this->Cairo, style.Size);
  cairo_set_source_rgba(
    this->Cairo, style.Color[0], style.Color[1], style.Color[2], style.Color[3]);
  const double width = style.Size * MeasureLine(line, style);
  cairo_move_to(this->Cairo, -width * (1 + style.Horizontal) / 2.0, 0.0);
  cairo_show_text(this->Cairo, line.c_str());
  cairo_new_path(this->Cairo);
  cairo_restore(this->Cairo);
}

void CairoCanvas::RecordText(
  double x, double y, const std::string& line, const CanvasTextStyle& style)
{
  constexpr const char* anchors[] = { "start", "middle", "end" };
  const std::string left = Rounded(x / this->Units);
  const std::string top = Rounded(this->Height - y / this->Units);
  std::string& text = this->SvgText;
  text += style.Angle == 0.0 ? "<text x=\"" + left + "\" y=\"" + top + "\""
                             : "<text transform=\"translate(" + left + " " + top + ") rotate(" +
      Rounded(-style.Angle) + ")\"";
  text += " font-size=\"" + Rounded(style.Size / this->Units) + "\"";
  text += style.Family != FontFamily ? " font-family=\"" + EscapeXml(style.Family) + "\"" : "";
  text += style.Bold ? " font-weight=\"bold\"" : "";
  text += style.Horizontal < 0
    ? ""
    : std::string(" text-anchor=\"") + anchors[style.Horizontal + 1] + "\"";
  text += " fill=\"" + HexColor(style.Color) + "\"";
  text += style.Color[3] < 1.0 ? " fill-opacity=\"" + Rounded(style.Color[3]) + "\"" : "";
  text += ">" + EscapeXml(line) + "</text>\n";
}

std::string CairoCanvas::Finish()
{
  cairo_surface_flush(this->Surface);
  if (this->Kind == Format::Png)
  {
    cairo_surface_write_to_png_stream(this->Surface, Append, &this->Stream);
    AddResolution(this->Stream, this->Dpi);
  }
  else if (this->Kind == Format::Pixels)
  {
    const auto* data = reinterpret_cast<const char*>(cairo_image_surface_get_data(this->Surface));
    // Rows of pixels of four bytes need no padding.
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(this->Surface));
    const auto rows = static_cast<std::size_t>(cairo_image_surface_get_height(this->Surface));
    this->Stream.assign(data, data ? stride * rows : 0);
  }
  cairo_surface_finish(this->Surface);
  const cairo_status_t drawn = cairo_status(this->Cairo);
  const cairo_status_t status =
    drawn != CAIRO_STATUS_SUCCESS && drawn != CAIRO_STATUS_SURFACE_FINISHED
    ? drawn
    : cairo_surface_status(this->Surface);
  if (status != CAIRO_STATUS_SUCCESS)
  {
    throw std::runtime_error(
      std::string("The figure cannot be drawn: ") + cairo_status_to_string(status) + ".");
  }
  if (this->Kind == Format::Svg)
  {
    this->Stream = CompactSvg(this->Stream);
    const std::size_t head = this->Stream.find("<g ");
    const std::size_t end = this->Stream.rfind("</svg>");
    if (head != std::string::npos && end != std::string::npos)
    {
      const std::string group =
        "<g font-family=\"DejaVu Sans, Verdana, sans-serif\" xml:space=\"preserve\">\n" +
        this->SvgText + "</g>\n";
      this->Stream.insert(end, group);
      if (!this->Title.empty())
      {
        const std::size_t open = this->Stream.find('>', this->Stream.find("<svg")) + 1;
        this->Stream.insert(open, "\n<title>" + EscapeXml(this->Title) + "</title>");
      }
    }
    return RenumberIds(this->Stream);
  }
  return this->Stream;
}

} // namespace pemesh
