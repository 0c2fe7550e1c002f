// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// The second half of vtkPEMCairoContextDevice2D: text, images and state.
#include "vtkPEMCairoContextDevice2D.h"

#include "CairoCanvas.h"
#include "CairoShapes.h"

#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <numbers>

//----------------------------------------------------------------------------------------------
pemesh::CanvasTextStyle vtkPEMCairoContextDevice2D::TextStyle() const
{
  pemesh::CanvasTextStyle style;
  style.Size = this->TextProp->GetFontSize();
  const std::string family = this->TextProp->GetFontFamilyAsString();
  // The names of the fonts within VTK stand for no choice.
  if (family != "Arial" && family != "Courier" && family != "Times" && family != "File")
  {
    style.Family = family;
  }
  style.Bold = this->TextProp->GetBold() != 0;
  style.Angle = this->TextProp->GetOrientation();
  style.Horizontal = this->TextProp->GetJustification() - VTK_TEXT_CENTERED;
  style.Vertical = this->TextProp->GetVerticalJustification() - VTK_TEXT_CENTERED;
  this->TextProp->GetColor(style.Color);
  style.Color[3] = this->TextProp->GetOpacity();
  return style;
}

void vtkPEMCairoContextDevice2D::DrawString(float* point, const vtkStdString& string)
{
  if (this->Canvas)
  {
    double x = point[0];
    double y = point[1];
    this->Transform(x, y);
    this->Canvas->DrawText(x, y, string, this->TextStyle());
  }
}

void vtkPEMCairoContextDevice2D::ComputeStringBounds(const vtkStdString& string, float bounds[4])
{
  const pemesh::CanvasTextBox box = pemesh::CairoCanvas::MeasureText(string, this->TextStyle());
  bounds[0] = 0.0f;
  bounds[1] = 0.0f;
  bounds[2] = static_cast<float>(box.Width);
  bounds[3] = static_cast<float>(box.Height);
}

void vtkPEMCairoContextDevice2D::DrawString(float* point, const vtkUnicodeString& string)
{
  this->DrawString(point, vtkStdString(string.utf8_str()));
}

void vtkPEMCairoContextDevice2D::ComputeStringBounds(
  const vtkUnicodeString& string, float bounds[4])
{
  this->ComputeStringBounds(vtkStdString(string.utf8_str()), bounds);
}

void vtkPEMCairoContextDevice2D::ComputeJustifiedStringBounds(const char* string, float bounds[4])
{
  const pemesh::CanvasTextStyle style = this->TextStyle();
  const pemesh::CanvasTextBox box = pemesh::CairoCanvas::MeasureText(string, style);
  const double left = -box.Width * (1 + style.Horizontal) / 2.0;
  const double bottom = -box.Height * (1 + style.Vertical) / 2.0;
  const double angle = style.Angle * std::numbers::pi / 180.0;
  double low[2] = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  double high[2] = { -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  for (int corner = 0; corner < 4; ++corner)
  {
    const double x = left + (corner % 2 == 0 ? 0.0 : box.Width);
    const double y = bottom + (corner / 2 == 0 ? 0.0 : box.Height);
    const double turned[2] = { x * std::cos(angle) - y * std::sin(angle),
      x * std::sin(angle) + y * std::cos(angle) };
    for (int axis = 0; axis < 2; ++axis)
    {
      low[axis] = std::min(low[axis], turned[axis]);
      high[axis] = std::max(high[axis], turned[axis]);
    }
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    bounds[axis] = static_cast<float>(low[axis]);
    bounds[2 + axis] = static_cast<float>(high[axis] - low[axis]);
  }
}

void vtkPEMCairoContextDevice2D::DrawMathTextString(float* point, const vtkStdString& string)
{
  this->DrawString(point, string);
}

//----------------------------------------------------------------------------------------------
void vtkPEMCairoContextDevice2D::DrawImage(float point[2], float scale, vtkImageData* image)
{
  if (image)
  {
    const int* size = image->GetDimensions();
    this->DrawImage(vtkRectf(point[0], point[1], scale * size[0], scale * size[1]), image);
  }
}

void vtkPEMCairoContextDevice2D::DrawImage(const vtkRectf& position, vtkImageData* image)
{
  cairo_surface_t* surface = this->Canvas ? pemesh::MakeImageSurface(image) : nullptr;
  if (!surface)
  {
    return;
  }
  const int* size = image->GetDimensions();
  const Matrix& m = this->Current;
  cairo_matrix_t matrix;
  cairo_matrix_init(&matrix, m[0], m[3], m[1], m[4], m[2], m[5]);
  cairo_t* cairo = this->Canvas->Context();
  cairo_save(cairo);
  cairo_transform(cairo, &matrix);
  cairo_translate(cairo, position.GetX(), position.GetY() + position.GetHeight());
  cairo_scale(cairo, position.GetWidth() / size[0], -position.GetHeight() / size[1]);
  cairo_set_source_surface(cairo, surface, 0.0, 0.0);
  cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_NEAREST);
  cairo_rectangle(cairo, 0.0, 0.0, size[0], size[1]);
  cairo_fill(cairo);
  cairo_restore(cairo);
  cairo_surface_destroy(surface);
}

//----------------------------------------------------------------------------------------------
void vtkPEMCairoContextDevice2D::SetColor4(unsigned char color[4])
{
  this->Pen->SetColor(color[0], color[1], color[2], color[3]);
}

void vtkPEMCairoContextDevice2D::SetTexture(vtkImageData*, int) {}

void vtkPEMCairoContextDevice2D::SetPointSize(float size)
{
  this->Pen->SetWidth(size);
}

void vtkPEMCairoContextDevice2D::SetLineWidth(float width)
{
  this->Pen->SetWidth(width);
}

void vtkPEMCairoContextDevice2D::SetLineType(int type)
{
  this->Pen->SetLineType(type);
}

void vtkPEMCairoContextDevice2D::SetMatrix(vtkMatrix3x3* matrix)
{
  std::copy_n(matrix->GetData(), 9, this->Current.begin());
}

void vtkPEMCairoContextDevice2D::GetMatrix(vtkMatrix3x3* matrix)
{
  matrix->DeepCopy(this->Current.data());
}

void vtkPEMCairoContextDevice2D::MultiplyMatrix(vtkMatrix3x3* matrix)
{
  const Matrix left = this->Current;
  vtkMatrix3x3::Multiply3x3(left.data(), matrix->GetData(), this->Current.data());
}

void vtkPEMCairoContextDevice2D::PushMatrix()
{
  this->Below.push_back(this->Current);
}

void vtkPEMCairoContextDevice2D::PopMatrix()
{
  if (!this->Below.empty())
  {
    this->Current = this->Below.back();
    this->Below.pop_back();
  }
}

void vtkPEMCairoContextDevice2D::SetClipping(int* rectangle)
{
  std::copy_n(rectangle, 4, this->Clip);
  this->ApplyClip();
}

void vtkPEMCairoContextDevice2D::EnableClipping(bool enable)
{
  this->ClipIsEnabled = enable;
  this->ApplyClip();
}

void vtkPEMCairoContextDevice2D::ApplyClip()
{
  if (!this->Canvas)
  {
    return;
  }
  cairo_t* cairo = this->Canvas->Context();
  cairo_reset_clip(cairo);
  if (this->ClipIsEnabled)
  {
    cairo_rectangle(cairo, this->Clip[0], this->Clip[1], this->Clip[2], this->Clip[3]);
    cairo_clip(cairo);
  }
}

void vtkPEMCairoContextDevice2D::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Format: " << this->Format << "\n";
  os << indent << "PageSize: " << this->PageSize[0] << " " << this->PageSize[1] << "\n";
  os << indent << "DPI: " << this->DPI << "\n";
  os << indent << "UnitsPerPoint: " << this->UnitsPerPoint << "\n";
  os << indent << "DocumentTitle: " << this->DocumentTitle << "\n";
  os << indent << "Contents: " << this->Contents.size() << " bytes\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
  os << indent << "Clip: " << this->Clip[0] << " " << this->Clip[1] << " " << this->Clip[2] << " "
     << this->Clip[3] << "\n";
  os << indent << "ClipIsEnabled: " << this->ClipIsEnabled << "\n";
}
