// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMCairoContextDevice2D.h"

#include "CairoCanvas.h"
#include "CairoShapes.h"

#include <vtkBrush.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <numbers>

vtkStandardNewMacro(vtkPEMCairoContextDevice2D);

namespace
{

using Color = pemesh::ByteColor;

Color PenColor(vtkPen* pen)
{
  Color color;
  pen->GetColor(color.data());
  color[3] = pen->GetOpacity();
  return color;
}

Color BrushColor(vtkBrush* brush)
{
  Color color;
  brush->GetColor(color.data());
  return color;
}

/** Whether a strip goes steadily to the right, with both its points at every place. */
bool IsBandOfX(const float* points, int n)
{
  bool isBand = n >= 4 && n % 2 == 0;
  for (int i = 0; isBand && i < n; i += 2)
  {
    const float x = points[2 * i];
    isBand = points[2 * i + 2] == x && (i == 0 || x > points[2 * i - 2]);
  }
  return isBand;
}

} // namespace

vtkPEMCairoContextDevice2D::vtkPEMCairoContextDevice2D() = default;

vtkPEMCairoContextDevice2D::~vtkPEMCairoContextDevice2D() = default;

void vtkPEMCairoContextDevice2D::SetPageSize(double width, double height)
{
  const auto clamp = [](double length) { return length >= 1.0 ? std::min(length, 14400.0) : 1.0; };
  if (this->PageSize[0] != clamp(width) || this->PageSize[1] != clamp(height))
  {
    this->PageSize[0] = clamp(width);
    this->PageSize[1] = clamp(height);
    this->Modified();
  }
}

void vtkPEMCairoContextDevice2D::SetDocumentTitle(const std::string& title)
{
  if (this->DocumentTitle != title)
  {
    this->DocumentTitle = title;
    this->Modified();
  }
}

std::string vtkPEMCairoContextDevice2D::GetDocumentTitle() const
{
  return this->DocumentTitle;
}

std::string vtkPEMCairoContextDevice2D::GetContents() const
{
  return this->Contents;
}

void vtkPEMCairoContextDevice2D::GetNumberOfPixels(int size[2]) const
{
  for (int axis = 0; axis < 2; ++axis)
  {
    size[axis] = pemesh::CairoCanvas::NumberOfPixels(this->PageSize[axis], this->DPI);
  }
}

std::string vtkPEMCairoContextDevice2D::GetErrorMessage() const
{
  return this->ErrorMessage;
}

void vtkPEMCairoContextDevice2D::Begin(vtkViewport*)
{
  this->Contents.clear();
  this->ErrorMessage.clear();
  this->Current = Identity;
  this->Below.clear();
  this->ClipIsEnabled = false;
  const double width = this->PageSize[0] * this->UnitsPerPoint;
  const double height = this->PageSize[1] * this->UnitsPerPoint;
  this->Geometry[0] = static_cast<int>(std::lround(width));
  this->Geometry[1] = static_cast<int>(std::lround(height));
  this->SetViewportSize(vtkVector2i(this->Geometry[0], this->Geometry[1]));
  this->SetViewportRect(vtkRecti(0, 0, this->Geometry[0], this->Geometry[1]));
  using Kind = pemesh::CairoCanvas::Format;
  constexpr Kind kinds[] = { Kind::Png, Kind::Svg, Kind::Pdf, Kind::Pixels };
  try
  {
    this->Canvas = std::make_unique<pemesh::CairoCanvas>(kinds[this->Format], this->PageSize[0],
      this->PageSize[1], this->DPI, this->UnitsPerPoint, this->DocumentTitle);
  }
  catch (const std::exception& error)
  {
    this->Canvas.reset();
    this->ErrorMessage = error.what();
  }
}

void vtkPEMCairoContextDevice2D::End()
{
  if (!this->Canvas)
  {
    return;
  }
  try
  {
    this->Contents = this->Canvas->Finish();
  }
  catch (const std::exception& error)
  {
    this->ErrorMessage = error.what();
  }
  this->Canvas.reset();
}

//----------------------------------------------------------------------------------------------
void vtkPEMCairoContextDevice2D::Transform(double& x, double& y) const
{
  const Matrix& m = this->Current;
  const double w = m[6] * x + m[7] * y + m[8];
  const double newX = (m[0] * x + m[1] * y + m[2]) / w;
  y = (m[3] * x + m[4] * y + m[5]) / w;
  x = newX;
}

void vtkPEMCairoContextDevice2D::AddPath(const float* points, int n, bool closed)
{
  cairo_t* cairo = this->Canvas->Context();
  cairo_new_sub_path(cairo);
  for (int i = 0; i < n; ++i)
  {
    double x = points[2 * i];
    double y = points[2 * i + 1];
    this->Transform(x, y);
    cairo_line_to(cairo, x, y);
  }
  if (closed)
  {
    cairo_close_path(cairo);
  }
}

void vtkPEMCairoContextDevice2D::Fill(const unsigned char* color)
{
  cairo_t* cairo = this->Canvas->Context();
  pemesh::SetSource(cairo, color);
  cairo_fill(cairo);
}

void vtkPEMCairoContextDevice2D::Stroke(const unsigned char* color)
{
  cairo_t* cairo = this->Canvas->Context();
  const int type = this->Pen->GetLineType();
  const double width = this->Pen->GetWidth();
  if (type == vtkPen::NO_PEN || width <= 0.0)
  {
    cairo_new_path(cairo);
    return;
  }
  const std::vector<double> dashes = pemesh::DashPattern(type, width);
  pemesh::SetSource(cairo, color);
  cairo_set_line_width(cairo, width);
  cairo_set_dash(cairo, dashes.data(), static_cast<int>(dashes.size()), 0.0);
  cairo_stroke(cairo);
}

void vtkPEMCairoContextDevice2D::DrawPoly(float* points, int n, unsigned char* colors, int nc_comps)
{
  if (!this->Canvas || n < 1)
  {
    return;
  }
  if (!colors)
  {
    // A path that ends where it began is closed, so that its corners are all joined alike.
    const bool closed = n > 2 && points[0] == points[2 * n - 2] && points[1] == points[2 * n - 1];
    this->AddPath(points, closed ? n - 1 : n, closed);
    this->Stroke(PenColor(this->Pen).data());
    return;
  }
  for (int i = 0; i + 1 < n; ++i)
  {
    this->AddPath(points + 2 * i, 2, false);
    this->Stroke(pemesh::ArrayColor(colors, nc_comps, i).data());
  }
}

void vtkPEMCairoContextDevice2D::DrawLines(
  float* points, int n, unsigned char* colors, int nc_comps)
{
  if (!this->Canvas)
  {
    return;
  }
  for (int i = 0; i + 1 < n; i += 2)
  {
    this->AddPath(points + 2 * i, 2, false);
    if (colors)
    {
      this->Stroke(pemesh::ArrayColor(colors, nc_comps, i).data());
    }
  }
  if (!colors)
  {
    this->Stroke(PenColor(this->Pen).data());
  }
}

void vtkPEMCairoContextDevice2D::DrawPoints(
  float* points, int n, unsigned char* colors, int nc_comps)
{
  this->DrawMarkers(VTK_MARKER_CIRCLE, false, points, n, colors, nc_comps);
}

void vtkPEMCairoContextDevice2D::DrawPointSprites(
  vtkImageData* sprite, float* points, int n, unsigned char* colors, int nc_comps)
{
  if (!sprite)
  {
    this->DrawMarkers(VTK_MARKER_SQUARE, false, points, n, colors, nc_comps);
    return;
  }
  const float size = this->Pen->GetWidth();
  for (int i = 0; i < n; ++i)
  {
    const float half = 0.5f * size;
    this->DrawImage(vtkRectf(points[2 * i] - half, points[2 * i + 1] - half, size, size), sprite);
  }
}

void vtkPEMCairoContextDevice2D::DrawMarkers(
  int shape, bool highlight, float* points, int n, unsigned char* colors, int nc_comps)
{
  if (!this->Canvas || shape == VTK_MARKER_NONE)
  {
    return;
  }
  constexpr int most = 256; // markers of a path: the time of drawing one grows with its crossings
  const Color own = PenColor(this->Pen);
  const double size = this->Pen->GetWidth() * (highlight ? 1.4 : 1.0);
  cairo_t* cairo = this->Canvas->Context();
  int count = 0;
  Color current = own;
  const auto draw = [&]()
  {
    if (count > 0)
    {
      pemesh::SetSource(cairo, current.data());
      pemesh::DrawMarkerPath(cairo, shape, size);
    }
    count = 0;
  };
  for (int i = 0; i < n; ++i)
  {
    double x = points[2 * i];
    double y = points[2 * i + 1];
    this->Transform(x, y);
    if (!std::isfinite(x) || !std::isfinite(y))
    {
      continue;
    }
    const Color color = colors ? pemesh::ArrayColor(colors, nc_comps, i) : own;
    // In one path those that are not opaque would not add up where they overlap.
    if (color != current || color[3] < 255 || count == most)
    {
      draw();
    }
    current = color;
    pemesh::AddMarkerPath(cairo, shape, x, y, size);
    ++count;
  }
  draw();
}

void vtkPEMCairoContextDevice2D::DrawQuad(float* points, int n)
{
  for (int i = 0; i + 3 < n; i += 4)
  {
    this->DrawPolygon(points + 2 * i, 4);
  }
}

void vtkPEMCairoContextDevice2D::DrawQuadStrip(float* points, int n)
{
  if (!this->Canvas)
  {
    return;
  }
  if (IsBandOfX(points, n))
  {
    // From end to end along one side and back along the other: far fewer edges.
    std::vector<float> outline;
    for (int i = 0; i < n; ++i)
    {
      const int at = i < n / 2 ? 2 * i : 2 * (n - 1 - i) + 1;
      outline.insert(outline.end(), { points[2 * at], points[2 * at + 1] });
    }
    this->AddPath(outline.data(), n, true);
    this->Fill(BrushColor(this->Brush).data());
    return;
  }
  // Filled as one path, or the joints show wherever the brush is not opaque. All quadrangles are
  // turned the same way, because those of opposite turns cancel where they overlap.
  for (int i = 0; i + 3 < n; i += 2)
  {
    const float* p = points + 2 * i;
    float quad[8] = { p[0], p[1], p[2], p[3], p[6], p[7], p[4], p[5] };
    float twiceArea = 0.0f;
    for (int j = 0; j < 4; ++j)
    {
      const float* a = quad + 2 * j;
      const float* b = quad + 2 * ((j + 1) % 4);
      twiceArea += a[0] * b[1] - a[1] * b[0];
    }
    if (twiceArea < 0.0f)
    {
      std::swap(quad[2], quad[6]);
      std::swap(quad[3], quad[7]);
    }
    this->AddPath(quad, 4, true);
  }
  this->Fill(BrushColor(this->Brush).data());
}

void vtkPEMCairoContextDevice2D::DrawPolygon(float* points, int n)
{
  if (this->Canvas)
  {
    this->AddPath(points, n, true);
    this->Fill(BrushColor(this->Brush).data());
  }
}

void vtkPEMCairoContextDevice2D::DrawColoredPolygon(
  float* points, int n, unsigned char* colors, int nc_comps)
{
  if (!colors)
  {
    this->DrawPolygon(points, n);
    return;
  }
  if (!this->Canvas || n < 1)
  {
    return;
  }
  std::array<int, 4> sum = {};
  for (int i = 0; i < n; ++i)
  {
    const Color color = pemesh::ArrayColor(colors, nc_comps, i);
    for (int channel = 0; channel < 4; ++channel)
    {
      sum[channel] += color[channel];
    }
  }
  Color mean;
  std::transform(sum.begin(), sum.end(), mean.begin(),
    [n](int channel) { return static_cast<unsigned char>(channel / n); });
  this->AddPath(points, n, true);
  this->Fill(mean.data());
}

void vtkPEMCairoContextDevice2D::AddPolygons(
  const std::vector<double>& points, const std::vector<int>& sizes)
{
  cairo_t* cairo = this->Canvas->Context();
  const double* point = points.data();
  for (const int size : sizes)
  {
    cairo_new_sub_path(cairo);
    for (int i = 0; i < size; ++i, point += 2)
    {
      double x = point[0];
      double y = point[1];
      this->Transform(x, y);
      cairo_line_to(cairo, x, y);
    }
    cairo_close_path(cairo);
  }
}

void vtkPEMCairoContextDevice2D::DrawPolygons(const std::vector<double>& points,
  const std::vector<int>& sizes, const unsigned char color[4], double seamWidth)
{
  if (!this->Canvas || sizes.empty())
  {
    return;
  }
  cairo_t* cairo = this->Canvas->Context();
  this->AddPolygons(points, sizes);
  pemesh::SetSource(cairo, color);
  if (seamWidth > 0.0)
  {
    cairo_fill_preserve(cairo);
    cairo_set_line_width(cairo, seamWidth);
    cairo_set_dash(cairo, nullptr, 0, 0.0);
    cairo_stroke(cairo);
  }
  else
  {
    cairo_fill(cairo);
  }
}

void vtkPEMCairoContextDevice2D::DrawOutlines(
  const std::vector<double>& points, const std::vector<int>& sizes)
{
  if (!this->Canvas || sizes.empty())
  {
    return;
  }
  this->AddPolygons(points, sizes);
  this->Stroke(PenColor(this->Pen).data());
}

void vtkPEMCairoContextDevice2D::DrawEllipseWedge(float x, float y, float outRx, float outRy,
  float inRx, float inRy, float startAngle, float stopAngle)
{
  if (!this->Canvas)
  {
    return;
  }
  // Both ways round, to either radius: a wedge, a disc or a ring, filled by even and odd.
  const bool whole = std::fabs(stopAngle - startAngle) >= 360.0f;
  std::vector<float> path;
  const auto addArc = [&path](float cx, float cy, float rx, float ry, float from, float to)
  {
    constexpr int steps = 180;
    for (int i = 0; i <= steps; ++i)
    {
      const double angle = (from + (to - from) * i / steps) * std::numbers::pi / 180.0;
      path.push_back(cx + rx * static_cast<float>(std::cos(angle)));
      path.push_back(cy + ry * static_cast<float>(std::sin(angle)));
    }
  };
  addArc(x, y, outRx, outRy, startAngle, stopAngle);
  if (inRx > 0.0f || inRy > 0.0f || !whole)
  {
    addArc(x, y, inRx, inRy, stopAngle, startAngle);
  }
  this->AddPath(path.data(), static_cast<int>(path.size() / 2), true);
  this->Fill(BrushColor(this->Brush).data());
}

void vtkPEMCairoContextDevice2D::DrawEllipticArc(
  float x, float y, float rX, float rY, float startAngle, float stopAngle)
{
  if (!this->Canvas)
  {
    return;
  }
  constexpr int steps = 180;
  const bool whole = std::fabs(stopAngle - startAngle) >= 360.0f;
  std::vector<float> path;
  for (int i = 0; i < (whole ? steps : steps + 1); ++i)
  {
    const double angle =
      (startAngle + (stopAngle - startAngle) * i / steps) * std::numbers::pi / 180.0;
    path.push_back(x + rX * static_cast<float>(std::cos(angle)));
    path.push_back(y + rY * static_cast<float>(std::sin(angle)));
  }
  // As all devices of VTK do: filled with the brush, then outlined with the pen.
  this->AddPath(path.data(), static_cast<int>(path.size() / 2), true);
  this->Fill(BrushColor(this->Brush).data());
  this->AddPath(path.data(), static_cast<int>(path.size() / 2), whole);
  this->Stroke(PenColor(this->Pen).data());
}
