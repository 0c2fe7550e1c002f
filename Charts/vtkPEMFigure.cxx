// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMFigure.h"

#include "FontFiles.h"
#include "PanelPainter.h"
#include "TextFile.h"
#include "vtkPEMCairoContextDevice2D.h"
#include "vtkPEMPanel.h"

#include <vtkContext2D.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <stdexcept>

vtkStandardNewMacro(vtkPEMFigure);

namespace
{

constexpr double CentimetersPerInch = 2.54;
constexpr double PointsPerInch = 72.0;
constexpr double DefaultColumnWidth = 10.0; // cm
// Sizes of fonts are integers in VTK: fine units keep them apart.
constexpr double UnitsPerPoint = 20.0;
constexpr double Margin = 0.8;    // ems, around the figure
constexpr double PanelGap = 1.6;  // ems, between panels
constexpr double TitleSize = 1.3; // ems

int FormatOf(const std::string& path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (ending == ".png")
  {
    return vtkPEMCairoContextDevice2D::FORMAT_PNG;
  }
  if (ending == ".svg")
  {
    return vtkPEMCairoContextDevice2D::FORMAT_SVG;
  }
  if (ending == ".pdf")
  {
    return vtkPEMCairoContextDevice2D::FORMAT_PDF;
  }
  throw std::runtime_error(
    "The figure \"" + path + "\" must end in .png, .svg or .pdf: the ending says what is written.");
}

} // namespace

vtkPEMFigure::vtkPEMFigure() = default;
vtkPEMFigure::~vtkPEMFigure() = default;

void vtkPEMFigure::AddPanel(vtkPEMPanel* panel)
{
  if (panel)
  {
    this->Panels.emplace_back(panel);
    this->Modified();
  }
}

void vtkPEMFigure::RemoveAllPanels()
{
  if (!this->Panels.empty())
  {
    this->Panels.clear();
    this->Modified();
  }
}

int vtkPEMFigure::GetNumberOfPanels() const
{
  return static_cast<int>(this->Panels.size());
}

vtkPEMPanel* vtkPEMFigure::GetPanel(int index) const
{
  return index >= 0 && index < this->GetNumberOfPanels() ? this->Panels[index].Get() : nullptr;
}

void vtkPEMFigure::SetTitle(const std::string& title)
{
  if (this->Title != title)
  {
    this->Title = title;
    this->Modified();
  }
}

std::string vtkPEMFigure::GetTitle() const
{
  return this->Title;
}

void vtkPEMFigure::SetSizeInCentimeters(double width, double height)
{
  const auto valid = [](double length)
  { return std::isfinite(length) && length > 0.0 ? std::clamp(length, 1.0, 500.0) : 0.0; };
  if (this->Size[0] != valid(width) || this->Size[1] != valid(height))
  {
    this->Size[0] = valid(width);
    this->Size[1] = valid(height);
    this->Modified();
  }
}

void vtkPEMFigure::SetSizeInPixels(int width, int height)
{
  const double pixel = CentimetersPerInch / this->DPI;
  this->SetSizeInCentimeters(width * pixel, height * pixel);
}

void vtkPEMFigure::SetStyle(const pemesh::ChartStyle& style)
{
  this->SetDPI(style.Resolution);
  this->SetFontSize(style.FontSize);
  this->SetSizeInCentimeters(style.Width, style.Height);
  this->Style = std::make_unique<pemesh::ChartStyle>(style);
  this->Modified();
}

int vtkPEMFigure::GetWidthInPixels() const
{
  return static_cast<int>(std::lround(this->WidthInCentimeters() * this->DPI / CentimetersPerInch));
}

int vtkPEMFigure::GetHeightInPixels() const
{
  return static_cast<int>(
    std::lround(this->HeightInCentimeters() * this->DPI / CentimetersPerInch));
}

int vtkPEMFigure::GridColumns() const
{
  const int panels = std::max(1, this->GetNumberOfPanels());
  return this->Columns > 0 ? std::min(this->Columns, panels)
                           : static_cast<int>(std::ceil(std::sqrt(panels)));
}

int vtkPEMFigure::GridRows() const
{
  return (std::max(1, this->GetNumberOfPanels()) + this->GridColumns() - 1) / this->GridColumns();
}

double vtkPEMFigure::WidthInCentimeters() const
{
  return this->Size[0] > 0.0 ? this->Size[0] : DefaultColumnWidth * this->GridColumns();
}

double vtkPEMFigure::HeightInCentimeters() const
{
  if (this->Size[1] > 0.0)
  {
    return this->Size[1];
  }
  double aspect = 0.0;
  for (const auto& panel : this->Panels)
  {
    aspect = std::max(aspect, panel->GetPreferredAspect());
  }
  aspect = aspect > 0.0 ? aspect : 0.7;
  const double em = this->FontSize / PointsPerInch * CentimetersPerInch;
  const double title = this->Title.empty() ? 0.0 : 2.2 * em;
  const double panelWidth = this->WidthInCentimeters() / this->GridColumns();
  return std::min(500.0, panelWidth * aspect * this->GridRows() + title);
}

void vtkPEMFigure::Paint(vtkPEMCairoContextDevice2D* device)
{
  const double units = device->GetUnitsPerPoint();
  const double em = this->FontSize * units;
  const double* page = device->GetPageSize();
  pemesh::Box box = { Margin * em, Margin * em, page[0] * units - 2.0 * Margin * em,
    page[1] * units - 2.0 * Margin * em };
  vtkNew<vtkContext2D> context;
  context->Begin(device);
  const pemesh::ChartStyle style = this->Style ? *this->Style : pemesh::ChartStyle();
  pemesh::PanelPainter painter(context, TitleSize * em, style);
  painter.FillBackground({ 0.0, 0.0, page[0] * units, page[1] * units });
  painter.TakeTitle(box, this->Title);

  const int columns = this->GridColumns();
  const int rows = this->GridRows();
  const double gap = PanelGap * em;
  const double width = (box.Width - gap * (columns - 1)) / columns;
  const double height = (box.Height - gap * (rows - 1)) / rows;
  for (int i = 0; i < this->GetNumberOfPanels(); ++i)
  {
    vtkPEMPanel* panel = this->Panels[i];
    const double x = box.X + (i % columns) * (width + gap);
    const double y = box.Top() - (i / columns) * (height + gap) - height;
    panel->SetRectangle(x, y, std::max(width, em), std::max(height, em));
    panel->SetFontSize(em);
    if (this->Style)
    {
      panel->SetStyle(*this->Style);
    }
    panel->Paint(context);
  }
  context->End();
}

void vtkPEMFigure::WarnOfFonts()
{
  std::set<std::string> families;
  for (const auto& panel : this->Panels)
  {
    families.insert(panel->GetStyle().FontFamily);
  }
  for (const std::string& family : families)
  {
    if (const std::string reason = pemesh::WhyOtherFont(family); !reason.empty())
    {
      vtkWarningMacro(<< reason);
    }
  }
}

bool vtkPEMFigure::Write(const std::string& path)
{
  this->ErrorMessage.clear();
  try
  {
    vtkNew<vtkPEMCairoContextDevice2D> device;
    device->SetFormat(FormatOf(path));
    if (this->Panels.empty())
    {
      throw std::runtime_error("The figure \"" + path + "\" has no panels.");
    }
    for (const auto& panel : this->Panels)
    {
      const std::string reason = panel->WhyNotDrawable();
      if (!reason.empty())
      {
        throw std::runtime_error(reason);
      }
    }
    const double points = PointsPerInch / CentimetersPerInch;
    device->SetPageSize(this->WidthInCentimeters() * points, this->HeightInCentimeters() * points);
    device->SetDPI(this->DPI);
    device->SetUnitsPerPoint(UnitsPerPoint);
    device->SetDocumentTitle(this->Title.empty() ? this->Panels[0]->GetTitle() : this->Title);
    device->Begin(nullptr);
    if (device->GetErrorMessage().empty())
    {
      this->Paint(device);
    }
    device->End();
    if (!device->GetErrorMessage().empty())
    {
      throw std::runtime_error(device->GetErrorMessage());
    }
    pemesh::WriteTextFile(path, device->GetContents());
    this->WarnOfFonts();
  }
  catch (const std::exception& error)
  {
    this->ErrorMessage = error.what();
    vtkErrorMacro(<< error.what());
    return false;
  }
  return true;
}

std::string vtkPEMFigure::GetErrorMessage() const
{
  return this->ErrorMessage;
}

void vtkPEMFigure::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Panels: " << this->Panels.size() << "\n";
  os << indent << "Columns: " << this->Columns << "\n";
  os << indent << "Title: " << this->Title << "\n";
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
  os << indent << "DPI: " << this->DPI << "\n";
  os << indent << "FontSize: " << this->FontSize << "\n";
  os << indent << "Style: " << (this->Style ? "its own" : "that of the panels") << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
