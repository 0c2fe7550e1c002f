// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMMeshView.h"

#include "ElementAccess.h"
#include "MeshPainter.h"
#include "NumberText.h"

#include <vtkCellData.h>
#include <vtkContext2D.h>
#include <vtkDataArray.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

vtkStandardNewMacro(vtkPEMMeshView);

namespace
{

constexpr double Automatic = std::numeric_limits<double>::quiet_NaN();
constexpr const char* HighlightNames[] = { "none", "min", "max", "both" };

bool IsEmpty(vtkPolyData* mesh)
{
  return mesh->GetNumberOfCells() == 0;
}

std::vector<std::string> NamesOfArrays(vtkPolyData* mesh)
{
  std::vector<std::string> names;
  vtkDataSetAttributes* const attributes[] = { mesh->GetCellData(), mesh->GetPointData() };
  for (vtkDataSetAttributes* data : attributes)
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      if (data->GetArray(i) && data->GetArrayName(i))
      {
        names.push_back(data->GetArrayName(i));
      }
    }
  }
  return names;
}

} // namespace

vtkPEMMeshView::vtkPEMMeshView()
  : ColorRange{ Automatic, Automatic }
{
}

vtkPEMMeshView::~vtkPEMMeshView() = default;

void vtkPEMMeshView::SetText(std::string& member, const std::string& value)
{
  if (member != value)
  {
    member = value;
    this->Modified();
  }
}

void vtkPEMMeshView::SetMesh(vtkPolyData* mesh)
{
  if (this->Mesh != mesh)
  {
    this->Mesh = mesh;
    this->Modified();
  }
}

vtkPolyData* vtkPEMMeshView::GetMesh() const
{
  return this->Mesh;
}

void vtkPEMMeshView::SetColorArray(const std::string& name)
{
  this->SetText(this->ColorArray, name);
}

std::string vtkPEMMeshView::GetColorArray() const
{
  return this->ColorArray;
}

void vtkPEMMeshView::SetColorTitle(const std::string& title)
{
  this->SetText(this->ColorTitle, title);
}

std::string vtkPEMMeshView::GetColorTitle() const
{
  return this->ColorTitle;
}

bool vtkPEMMeshView::SetColorMap(const std::string& name)
{
  if (!pemesh::FindColorMap(name))
  {
    return false;
  }
  this->SetText(this->ColorMap, name);
  return true;
}

std::string vtkPEMMeshView::GetColorMap() const
{
  return this->ColorMap;
}

void vtkPEMMeshView::SetClassLabels(const std::vector<std::string>& labels)
{
  if (this->ClassLabels != labels)
  {
    this->ClassLabels = labels;
    this->Modified();
  }
}

std::vector<std::string> vtkPEMMeshView::GetClassLabels() const
{
  return this->ClassLabels;
}

bool vtkPEMMeshView::SetHighlightByName(const std::string& name)
{
  const auto* found = std::find(std::begin(HighlightNames), std::end(HighlightNames), name);
  if (found == std::end(HighlightNames))
  {
    return false;
  }
  this->SetHighlight(static_cast<int>(found - HighlightNames));
  return true;
}

void vtkPEMMeshView::SetMarkedElements(
  const std::vector<vtkIdType>& elements, const std::string& note)
{
  if (this->MarkedElements != elements)
  {
    this->MarkedElements = elements;
    this->Modified();
  }
  this->SetText(this->MarkNote, note);
}

std::string vtkPEMMeshView::WhyNotDrawable()
{
  if (!this->Mesh)
  {
    return "The mesh view has no mesh.";
  }
  if (IsEmpty(this->Mesh))
  {
    return {}; // drawn as such: its case failed
  }
  const std::string reason = pemesh::ElementAccess::WhyUnusable(this->Mesh);
  if (!reason.empty())
  {
    return "The mesh cannot be drawn: " + reason + ".";
  }
  if (this->ColorArray.empty() || this->Mesh->GetCellData()->GetArray(this->ColorArray.c_str()) ||
    this->Mesh->GetPointData()->GetArray(this->ColorArray.c_str()))
  {
    return {};
  }
  const std::string nearest = pemesh::NearestWord(this->ColorArray, NamesOfArrays(this->Mesh));
  return "The mesh has no array of numbers \"" + this->ColorArray + "\"" +
    (nearest.empty() ? ": it has none at all." : "; the nearest is \"" + nearest + "\".");
}

double vtkPEMMeshView::GetPreferredAspect()
{
  if (!this->Mesh || IsEmpty(this->Mesh))
  {
    return this->Superclass::GetPreferredAspect();
  }
  double bounds[6];
  this->Mesh->GetBounds(bounds);
  const double width = bounds[1] - bounds[0];
  const double height = bounds[3] - bounds[2];
  if (!std::isfinite(height / width) || width <= 0.0)
  {
    return this->Superclass::GetPreferredAspect();
  }
  // The colour bar takes about a fifth of the width, title and legend a tenth in height.
  return std::clamp(0.8 * height / width + 0.1, 0.35, 1.5);
}

double vtkPEMMeshView::GetDeviceX(double x) const
{
  return this->ToDevice[0] + this->ToDevice[2] * x;
}

double vtkPEMMeshView::GetDeviceY(double y) const
{
  return this->ToDevice[1] + this->ToDevice[2] * y;
}

bool vtkPEMMeshView::Paint(vtkContext2D* context)
{
  const std::string reason = this->WhyNotDrawable();
  if (!reason.empty())
  {
    vtkErrorMacro(<< reason);
    return false;
  }
  pemesh::MeshStyle style;
  style.Title = this->GetTitle();
  style.ColorTitle = this->ColorTitle.empty() ? this->ColorArray : this->ColorTitle;
  if (!this->ColorArray.empty())
  {
    style.CellValues = this->Mesh->GetCellData()->GetArray(this->ColorArray.c_str());
    style.PointValues = this->Mesh->GetPointData()->GetArray(this->ColorArray.c_str());
  }
  style.MapName = this->ColorMap == "viridis" ? this->GetStyle().ColorMap : this->ColorMap;
  style.Logarithmic = this->LogColor;
  style.Diverging = this->Diverging;
  std::copy_n(this->ColorRange, 2, style.Range);
  style.ClassLabels = this->ClassLabels;
  style.Outlines = this->Outlines != OUTLINES_OFF;
  style.OutlinesAreAutomatic = this->Outlines == OUTLINES_AUTOMATIC;
  style.MarkSmallest = this->Highlight == HIGHLIGHT_MIN || this->Highlight == HIGHLIGHT_BOTH;
  style.Highlighted = this->GetHighlightedRows();
  style.MarkLargest = this->Highlight == HIGHLIGHT_MAX || this->Highlight == HIGHLIGHT_BOTH;
  std::ranges::copy_if(this->MarkedElements, std::back_inserter(style.Marked),
    [&](vtkIdType element) { return element >= 0 && element < this->Mesh->GetNumberOfCells(); });
  style.MarkNote = this->MarkNote;

  const double* rectangle = this->GetRectangle();
  pemesh::MeshPainter painter(context, this->GetFontSize(), this->Mesh, style, this->GetStyle());
  painter.Paint({ rectangle[0], rectangle[1], rectangle[2], rectangle[3] });
  this->ToDevice[0] = painter.Offset().x;
  this->ToDevice[1] = painter.Offset().y;
  this->ToDevice[2] = painter.Scale();
  return true;
}

void vtkPEMMeshView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mesh: " << this->Mesh.Get() << "\n";
  os << indent << "ColorArray: " << this->ColorArray << "\n";
  os << indent << "ColorTitle: " << this->ColorTitle << "\n";
  os << indent << "ColorMap: " << this->ColorMap << "\n";
  os << indent << "ClassLabels:";
  for (const std::string& label : this->ClassLabels)
  {
    os << " \"" << label << "\"";
  }
  os << "\n";
  os << indent << "LogColor: " << this->LogColor << "\n";
  os << indent << "Diverging: " << this->Diverging << "\n";
  os << indent << "ColorRange: " << this->ColorRange[0] << " " << this->ColorRange[1] << "\n";
  os << indent << "Outlines: " << this->Outlines << "\n";
  os << indent << "Highlight: " << HighlightNames[this->Highlight] << "\n";
  os << indent << "MarkedElements: " << this->MarkedElements.size() << "\n";
  os << indent << "MarkNote: " << this->MarkNote << "\n";
  os << indent << "ToDevice: " << this->ToDevice[0] << " " << this->ToDevice[1] << " "
     << this->ToDevice[2] << "\n";
}
