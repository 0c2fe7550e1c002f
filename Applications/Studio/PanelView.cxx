// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PanelView.h"

#include "Appearance.h"
#include "LatestJob.h"
#include "PanelPainting.h"
#include "vtkPEMFigure.h"
#include "vtkPEMPanel.h"

#include <QContextMenuEvent>
#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPainter>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>

namespace pemesh
{

PanelView::PanelView(QWidget* parent)
  : QWidget(parent)
  , PaintJob(new LatestJob(this, 1000))
{
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  this->setFocusPolicy(Qt::StrongFocus);
}

PanelView::~PanelView()
{
  delete this->PaintJob;
}

void PanelView::SetMaker(Maker maker, int columns)
{
  this->MakePanels = std::move(maker);
  this->Columns = columns;
  this->Request();
}

void PanelView::SetHint(const QString& hint)
{
  this->Hint = hint;
  this->update();
}

void PanelView::SetFontSize(double size)
{
  this->FontSize = size;
  this->Request();
}

void PanelView::Request()
{
  if (!this->MakePanels)
  {
    this->PaintJob->Cancel();
    this->Painted = {};
    this->update();
    return;
  }
  const PanelLayout layout{ this->size(), this->devicePixelRatioF(), this->FontSize,
    this->Columns };
  this->PaintJob->Start(
    [this, make = this->MakePanels, layout](const std::atomic<bool>&) -> LatestJob::Delivery
    {
      auto painted = std::make_shared<PaintedPanels>(PaintPanels(make(), layout));
      return [this, painted]
      {
        if (this->MakePanels)
        {
          this->Painted = *painted;
          this->update();
          emit this->Repainted();
        }
      };
    });
}

int PanelView::FindPanel(const QPointF& position) const
{
  for (std::size_t i = 0; i < this->Painted.Boxes.size(); ++i)
  {
    if (this->Painted.Boxes[i].contains(position))
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

QString PanelView::Export(const QString& file, int panel) const
{
  if (!this->MakePanels)
  {
    return tr("There is nothing to export.");
  }
  vtkNew<vtkPEMFigure> figure;
  vtkNew<vtkCallbackCommand> quiet; // the sentence is in GetErrorMessage
  figure->AddObserver(vtkCommand::ErrorEvent, quiet);
  const auto panels = this->MakePanels();
  for (std::size_t i = 0; i < panels.size(); ++i)
  {
    if (panel < 0 || static_cast<int>(i) == panel)
    {
      figure->AddPanel(panels[i]);
    }
  }
  figure->SetColumns(panel < 0 ? this->Columns : 1);
  return figure->Write(file.toStdString()) ? QString()
                                           : QString::fromStdString(figure->GetErrorMessage());
}

void PanelView::ExportAs(int panel)
{
  const QString file = QFileDialog::getSaveFileName(this, tr("Export figure"),
    QStringLiteral("figure.pdf"), tr("PDF (*.pdf);;SVG (*.svg);;PNG (*.png)"));
  const QString fault = file.isEmpty() ? QString() : this->Export(file, panel);
  if (!fault.isEmpty())
  {
    QMessageBox::warning(this, tr("Export figure"), fault);
  }
}

void PanelView::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.fillRect(this->rect(), CurrentTheme().Panel);
  if (this->MakePanels && !this->Painted.Image.isNull())
  {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRectF(this->rect()), this->Painted.Image);
    return;
  }
  const QString text = this->MakePanels ? this->Painted.Fault : this->Hint;
  QFont font = painter.font();
  font.setPixelSize(14);
  painter.setFont(font);
  painter.setPen(CurrentTheme().Muted);
  painter.drawText(
    this->rect().adjusted(40, 20, -40, -20), Qt::AlignCenter | Qt::TextWordWrap, text);
}

void PanelView::resizeEvent(QResizeEvent*)
{
  this->Request();
}

void PanelView::mousePressEvent(QMouseEvent* event)
{
  const int panel = this->FindPanel(event->position());
  if (event->button() == Qt::LeftButton && panel >= 0)
  {
    emit this->Clicked(panel, event->position());
  }
}

void PanelView::mouseDoubleClickEvent(QMouseEvent* event)
{
  const int panel = this->FindPanel(event->position());
  if (panel >= 0)
  {
    emit this->DoubleClicked(panel);
  }
}

void PanelView::contextMenuEvent(QContextMenuEvent* event)
{
  if (!this->MakePanels)
  {
    return;
  }
  const int panel = this->FindPanel(event->pos());
  QMenu menu(this);
  menu.addAction(tr("Export all of it …"), this, [this] { this->ExportAs(-1); });
  if (panel >= 0 && this->Painted.Panels.size() > 1)
  {
    menu.addAction(tr("Export this one …"), this, [this, panel] { this->ExportAs(panel); });
  }
  menu.exec(event->globalPos());
}

} // namespace pemesh
