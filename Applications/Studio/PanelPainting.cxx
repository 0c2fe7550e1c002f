// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PanelPainting.h"

#include "vtkPEMCairoContextDevice2D.h"
#include "vtkPEMPanel.h"

#include <algorithm>
#include <cmath>

#include <vtkContext2D.h>
#include <vtkNew.h>

namespace pemesh
{

namespace
{
constexpr double Gap = 14.0;
constexpr double Margin = 10.0;
constexpr double PointsPerInch = 72.0;
}

PaintedPanels PaintPanels(
  const std::vector<vtkSmartPointer<vtkPEMPanel>>& panels, const PanelLayout& layout)
{
  PaintedPanels painted;
  for (const auto& panel : panels)
  {
    const std::string reason = panel->WhyNotDrawable();
    if (reason.empty())
    {
      painted.Panels.push_back(panel);
    }
    else if (painted.Fault.isEmpty())
    {
      painted.Fault = QString::fromStdString(reason);
    }
  }
  const int count = static_cast<int>(painted.Panels.size());
  if (count == 0 || layout.Size.width() < 40.0 || layout.Size.height() < 40.0)
  {
    return painted;
  }
  const int columns = layout.Columns > 0 ? std::min(layout.Columns, count)
                                         : static_cast<int>(std::ceil(std::sqrt(count)));
  const int rows = (count + columns - 1) / columns;
  const double width = (layout.Size.width() - 2.0 * Margin - Gap * (columns - 1)) / columns;
  const double height = (layout.Size.height() - 2.0 * Margin - Gap * (rows - 1)) / rows;
  vtkNew<vtkPEMCairoContextDevice2D> device;
  device->SetPageSize(layout.Size.width(), layout.Size.height());
  device->SetDPI(PointsPerInch * layout.PixelRatio);
  device->Begin(nullptr);
  if (!device->GetErrorMessage().empty())
  {
    painted.Fault = QString::fromStdString(device->GetErrorMessage());
    return painted;
  }
  vtkNew<vtkContext2D> context;
  context->Begin(device);
  for (int i = 0; i < count; ++i)
  {
    const QRectF box(Margin + (i % columns) * (width + Gap),
      Margin + (i / columns) * (height + Gap), std::max(width, 20.0), std::max(height, 20.0));
    painted.Boxes.push_back(box);
    vtkPEMPanel* panel = painted.Panels[static_cast<std::size_t>(i)];
    panel->SetRectangle(box.left(), layout.Size.height() - box.bottom(), box.width(), box.height());
    panel->SetFontSize(layout.FontSize);
    panel->Paint(context);
  }
  context->End();
  device->End();
  const std::string png = device->GetContents();
  painted.Image.loadFromData(
    reinterpret_cast<const uchar*>(png.data()), static_cast<int>(png.size()), "PNG");
  painted.Image.setDevicePixelRatio(layout.PixelRatio);
  return painted;
}

} // namespace pemesh
