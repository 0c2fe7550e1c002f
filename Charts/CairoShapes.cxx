// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CairoShapes.h"

#include <vtkImageData.h>
#include <vtkPen.h>
#include <vtkPointData.h>
#include <vtkRenderingCoreEnums.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace pemesh
{

ByteColor ArrayColor(const unsigned char* colors, int components, int i)
{
  const unsigned char* c = colors + static_cast<std::ptrdiff_t>(i) * components;
  switch (components)
  {
    case 1:
      return { c[0], c[0], c[0], 255 };
    case 2:
      return { c[0], c[0], c[0], c[1] };
    case 3:
      return { c[0], c[1], c[2], 255 };
    default:
      return { c[0], c[1], c[2], c[3] };
  }
}

void SetSource(cairo_t* cairo, const unsigned char* color)
{
  cairo_set_source_rgba(
    cairo, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0, color[3] / 255.0);
}

std::vector<double> DashPattern(int lineType, double width)
{
  const double on = 4.0 * width;
  const double gap = 2.5 * width;
  const double dot = width;
  switch (lineType)
  {
    case vtkPen::DASH_LINE:
      return { on, gap };
    case vtkPen::DOT_LINE:
      return { dot, gap };
    case vtkPen::DASH_DOT_LINE:
      return { on, gap, dot, gap };
    case vtkPen::DASH_DOT_DOT_LINE:
      return { on, gap, dot, gap, dot, gap };
    case vtkPen::DENSE_DOT_LINE:
      return { dot, dot };
    default:
      return {};
  }
}

cairo_surface_t* MakeImageSurface(vtkImageData* image)
{
  vtkUnsignedCharArray* scalars =
    image ? vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars()) : nullptr;
  if (!scalars || scalars->GetNumberOfComponents() > 4)
  {
    return nullptr;
  }
  const int* size = image->GetDimensions();
  cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, size[0], size[1]);
  unsigned char* data = cairo_image_surface_get_data(surface);
  if (!data)
  {
    cairo_surface_destroy(surface);
    return nullptr;
  }
  const int stride = cairo_image_surface_get_stride(surface);
  for (int row = 0; row < size[1]; ++row)
  {
    auto* line = reinterpret_cast<std::uint32_t*>(data + (size[1] - 1 - row) * stride);
    for (int column = 0; column < size[0]; ++column)
    {
      const ByteColor color = ArrayColor(
        scalars->GetPointer(0), scalars->GetNumberOfComponents(), row * size[0] + column);
      const std::uint32_t alpha = color[3];
      const auto channel = [&](int i) { return (color[i] * alpha + 127u) / 255u; };
      line[column] = alpha << 24 | channel(0) << 16 | channel(1) << 8 | channel(2);
    }
  }
  cairo_surface_mark_dirty(surface);
  return surface;
}

void AddMarkerPath(cairo_t* cairo, int shape, double x, double y, double size)
{
  const double half = 0.5 * size;
  cairo_new_sub_path(cairo);
  switch (shape)
  {
    case VTK_MARKER_SQUARE:
    {
      const double side = 0.88 * size; // the area looks like that of the circle
      cairo_rectangle(cairo, x - 0.5 * side, y - 0.5 * side, side, side);
      break;
    }
    case VTK_MARKER_DIAMOND:
    {
      const double reach = 1.2 * half;
      cairo_move_to(cairo, x - reach, y);
      cairo_line_to(cairo, x, y - reach);
      cairo_line_to(cairo, x + reach, y);
      cairo_line_to(cairo, x, y + reach);
      cairo_close_path(cairo);
      break;
    }
    case VTK_MARKER_PLUS:
    case VTK_MARKER_CROSS:
    {
      // Two bars as one outline, so that a marker is one filled shape whatever it is.
      const double turn = shape == VTK_MARKER_CROSS ? std::numbers::pi / 4.0 : 0.0;
      const double reach = 1.1 * half;
      const double bar = 0.3 * half;
      const double corners[12][2] = { { reach, -bar }, { reach, bar }, { bar, bar }, { bar, reach },
        { -bar, reach }, { -bar, bar }, { -reach, bar }, { -reach, -bar }, { -bar, -bar },
        { -bar, -reach }, { bar, -reach }, { bar, -bar } };
      for (const auto& corner : corners)
      {
        cairo_line_to(cairo, x + corner[0] * std::cos(turn) - corner[1] * std::sin(turn),
          y + corner[0] * std::sin(turn) + corner[1] * std::cos(turn));
      }
      cairo_close_path(cairo);
      break;
    }
    default:
      // A line of no length with round ends: in a file a sixth of what an outline takes.
      cairo_move_to(cairo, x, y);
      cairo_line_to(cairo, x, y);
  }
}

void DrawMarkerPath(cairo_t* cairo, int shape, double size)
{
  const bool isOutline = shape == VTK_MARKER_SQUARE || shape == VTK_MARKER_DIAMOND ||
    shape == VTK_MARKER_PLUS || shape == VTK_MARKER_CROSS;
  if (isOutline)
  {
    cairo_fill(cairo);
    return;
  }
  const cairo_line_cap_t before = cairo_get_line_cap(cairo);
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_width(cairo, size);
  cairo_set_dash(cairo, nullptr, 0, 0.0);
  cairo_stroke(cairo);
  cairo_set_line_cap(cairo, before);
}

} // namespace pemesh
