// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PanelScene.h"

#include "vtkPEMCairoContextDevice2D.h"
#include "vtkPEMPanel.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

#include <vtkContext2D.h>
#include <vtkNew.h>

namespace pemesh
{

namespace
{
constexpr double Gap = 14.0;
constexpr double Margin = 10.0;
constexpr double PointsPerInch = 72.0;
constexpr double Smallest = 40.0; // pixels of a view worth painting

/** The page is white between the panels; the view is not. */
QImage OnBackground(const QImage& page, const std::vector<QRectF>& boxes, const PanelLayout& layout)
{
  QImage image(page.size(), QImage::Format_RGB32);
  image.fill(QColor(QString::fromStdString(layout.Style.Background)));
  QPainter painter(&image);
  for (const QRectF& box : boxes)
  {
    const QRectF pixels(box.topLeft() * layout.PixelRatio, box.size() * layout.PixelRatio);
    painter.drawImage(pixels, page, pixels);
  }
  painter.end();
  image.setDevicePixelRatio(layout.PixelRatio);
  return image;
}
}

PanelScene::PanelScene(Maker maker)
  : Make(std::move(maker))
{
}

PanelScene::~PanelScene() = default;

void PanelScene::Add(Change change)
{
  const std::scoped_lock lock(this->ChangesMutex);
  this->Changes.push_back(std::move(change));
}

PaintedPanels PanelScene::Paint(const PanelLayout& layout)
{
  const std::scoped_lock lock(this->PanelsMutex);
  if (!this->IsMade)
  {
    this->IsMade = true;
    for (const auto& panel : this->Make())
    {
      const std::string reason = panel->WhyNotDrawable();
      if (reason.empty())
      {
        this->Panels.push_back(panel);
      }
      else if (this->Fault.isEmpty())
      {
        this->Fault = QString::fromStdString(reason);
      }
    }
  }
  std::vector<Change> changes;
  {
    const std::scoped_lock changesLock(this->ChangesMutex);
    changes.swap(this->Changes);
  }
  for (const Change& change : changes)
  {
    change(this->Panels);
  }
  PaintedPanels painted;
  painted.Fault = this->Fault;
  if (this->Panels.empty() || layout.Size.width() < Smallest || layout.Size.height() < Smallest)
  {
    return painted;
  }
  PaintedPanels all = this->PaintAll(layout);
  all.Fault = all.Fault.isEmpty() ? this->Fault : all.Fault;
  return all;
}

PaintedPanels PanelScene::PaintAll(const PanelLayout& layout)
{
  PaintedPanels painted;
  const int count = static_cast<int>(this->Panels.size());
  const int columns = layout.Columns > 0 ? std::min(layout.Columns, count)
                                         : static_cast<int>(std::ceil(std::sqrt(count)));
  const int rows = (count + columns - 1) / columns;
  const double width = (layout.Size.width() - 2.0 * Margin - Gap * (columns - 1)) / columns;
  const double height = (layout.Size.height() - 2.0 * Margin - Gap * (rows - 1)) / rows;
  vtkNew<vtkPEMCairoContextDevice2D> device;
  device->SetPageSize(layout.Size.width(), layout.Size.height());
  device->SetDPI(PointsPerInch * layout.PixelRatio);
  device->SetFormat(vtkPEMCairoContextDevice2D::FORMAT_PIXELS);
  device->Begin(nullptr);
  if (!device->GetErrorMessage().empty())
  {
    painted.Fault = QString::fromStdString(device->GetErrorMessage());
    return painted;
  }
  this->Height = layout.Size.height();
  vtkNew<vtkContext2D> context;
  context->Begin(device);
  for (int i = 0; i < count; ++i)
  {
    const QRectF box(Margin + (i % columns) * (width + Gap),
      Margin + (i / columns) * (height + Gap), std::max(width, 20.0), std::max(height, 20.0));
    painted.Boxes.push_back(box);
    vtkPEMPanel* panel = this->Panels[static_cast<std::size_t>(i)];
    panel->SetStyle(layout.Style);
    panel->SetRectangle(box.left(), this->Height - box.bottom(), box.width(), box.height());
    panel->SetFontSize(layout.FontSize);
    panel->Paint(context);
  }
  context->End();
  device->End();
  const std::string pixels = device->GetContents();
  int size[2];
  device->GetNumberOfPixels(size);
  if (pixels.empty())
  {
    painted.Fault = QString::fromStdString(device->GetErrorMessage());
    return painted;
  }
  const QImage page(
    reinterpret_cast<const uchar*>(pixels.data()), size[0], size[1], QImage::Format_RGB32);
  painted.Image = OnBackground(page, painted.Boxes, layout);
  return painted;
}

ChartPick PanelScene::Pick(int panel, const QPointF& position, double tolerance)
{
  const std::unique_lock lock(this->PanelsMutex, std::try_to_lock);
  return lock && panel >= 0 && panel < static_cast<int>(this->Panels.size())
    ? this->Panels[static_cast<std::size_t>(panel)]->Pick(
        position.x(), this->Height - position.y(), tolerance)
    : ChartPick();
}

std::vector<vtkIdType> PanelScene::SelectRectangle(int panel, const QRectF& box)
{
  const std::unique_lock lock(this->PanelsMutex, std::try_to_lock);
  return lock && panel >= 0 && panel < static_cast<int>(this->Panels.size())
    ? this->Panels[static_cast<std::size_t>(panel)]->SelectRectangle(
        box.left(), this->Height - box.bottom(), box.right(), this->Height - box.top())
    : std::vector<vtkIdType>();
}

} // namespace pemesh
