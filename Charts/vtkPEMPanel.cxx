// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMPanel.h"

#include <vtkContextScene.h>

#include <algorithm>
#include <cmath>
#include <exception>

vtkPEMPanel::vtkPEMPanel()
  : Style(std::make_unique<pemesh::ChartStyle>())
{
}

vtkPEMPanel::~vtkPEMPanel() = default;

void vtkPEMPanel::ViewModified()
{
  this->vtkContextItem::Modified();
  if (this->Scene)
  {
    this->Scene->SetDirty(true);
  }
}

void vtkPEMPanel::SetTitle(const std::string& title)
{
  if (this->Title != title)
  {
    this->Title = title;
    this->ViewModified();
  }
}

std::string vtkPEMPanel::GetTitle() const
{
  return this->Title;
}

void vtkPEMPanel::SetRectangle(double x, double y, double width, double height)
{
  const double rectangle[4] = { x, y, width, height };
  if (!std::equal(rectangle, rectangle + 4, this->Rectangle))
  {
    std::copy_n(rectangle, 4, this->Rectangle);
    this->ViewModified();
  }
}

void vtkPEMPanel::SetFontSize(double size)
{
  const double clamped = size >= 1.0 ? std::min(size, 10000.0) : 1.0;
  if (this->FontSize != clamped)
  {
    this->FontSize = clamped;
    this->ViewModified();
  }
}

void vtkPEMPanel::SetStyle(const pemesh::ChartStyle& style)
{
  if (*this->Style != style)
  {
    *this->Style = style;
    this->ViewModified();
  }
}

const pemesh::ChartStyle& vtkPEMPanel::GetStyle() const
{
  return *this->Style;
}

std::string vtkPEMPanel::SetStyleByName(const std::string& name, const std::string& value)
{
  try
  {
    pemesh::ChartStyle style = *this->Style;
    pemesh::SetSetting(pemesh::ChartStyleFields(), style, name, value);
    this->SetStyle(style);
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return {};
}

void vtkPEMPanel::SetHighlightedRows(const std::vector<vtkIdType>& rows)
{
  std::vector<vtkIdType> sorted = rows;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if (this->HighlightedRows != sorted)
  {
    this->HighlightedRows = std::move(sorted);
    this->ViewModified();
  }
}

const std::vector<vtkIdType>& vtkPEMPanel::GetHighlightedRows() const
{
  return this->HighlightedRows;
}

pemesh::ChartPick vtkPEMPanel::Pick(double, double, double)
{
  return {};
}

std::vector<vtkIdType> vtkPEMPanel::SelectRectangle(double, double, double, double)
{
  return {};
}

bool vtkPEMPanel::Zoom(double, double, double, double)
{
  return false;
}

bool vtkPEMPanel::Pan(double, double, double, double)
{
  return false;
}

bool vtkPEMPanel::ZoomToRectangle(double, double, double, double)
{
  return false;
}

void vtkPEMPanel::ResetView() {}

bool vtkPEMPanel::GetVisibleRange(double, double, double[4])
{
  return false;
}

std::string vtkPEMPanel::DescribeVisibleRange(double, double)
{
  return {};
}

void vtkPEMPanel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Title: " << this->Title << "\n";
  os << indent << "Rectangle: " << this->Rectangle[0] << " " << this->Rectangle[1] << " "
     << this->Rectangle[2] << " " << this->Rectangle[3] << "\n";
  os << indent << "FontSize: " << this->FontSize << "\n";
  os << indent << "Style:\n";
  for (const auto& field : pemesh::ChartStyleFields())
  {
    os << indent.GetNextIndent() << field.Name << ": " << pemesh::GetSetting(field, *this->Style)
       << "\n";
  }
  os << indent << "HighlightedRows: " << this->HighlightedRows.size() << "\n";
}
