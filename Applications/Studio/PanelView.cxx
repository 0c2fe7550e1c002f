// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PanelView.h"

#include "Appearance.h"
#include "LatestJob.h"
#include "PanelExport.h"
#include "PlotStyle.h"
#include "vtkPEMPanel.h"

#include <QContextMenuEvent>
#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>
#include <QPainter>
#include <QRubberBand>
#include <QToolTip>

#include <cmath>

namespace pemesh
{

namespace
{

constexpr double PickTolerance = 1.2; // font sizes
constexpr int DragDistance = 6;       // pixels
constexpr double KeyZoom = 1.25;

/** The style of the user in the colours of the window, where it is dark. */
ChartStyle ScreenStyle()
{
  ChartStyle style = LoadPlotStyle();
  if (CurrentTheme().IsDark)
  {
    style.Background = CurrentTheme().Panel.name().toStdString();
    style.Ink = CurrentTheme().Text.name().toStdString();
  }
  return style;
}

} // namespace

PanelView::PanelView(QWidget* parent)
  : QWidget(parent)
  , PaintJob(new LatestJob(this, 1000))
  , ExportJob(new LatestJob(this, 600000))
  , Band(new QRubberBand(QRubberBand::Rectangle, this))
{
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  this->setFocusPolicy(Qt::StrongFocus);
  this->setMouseTracking(true);
  this->setAccessibleName(tr("Charts"));
}

PanelView::~PanelView()
{
  delete this->PaintJob;
  delete this->ExportJob;
}

void PanelView::SetMaker(Maker maker, int columns)
{
  this->MakePanels = std::move(maker);
  this->Columns = columns;
  this->Scene = this->MakePanels ? std::make_shared<PanelScene>(this->MakePanels) : nullptr;
  if (!this->Highlighted.empty())
  {
    this->SetHighlightedRows(this->Highlighted);
    return;
  }
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

void PanelView::SetHighlightedRows(const std::vector<vtkIdType>& rows)
{
  this->Highlighted = rows;
  if (this->Scene)
  {
    this->Scene->Add(
      [rows](const PanelList& panels)
      {
        for (const auto& panel : panels)
        {
          panel->SetHighlightedRows(rows);
        }
      });
    this->Request();
  }
}

void PanelView::ResetView()
{
  if (this->Scene)
  {
    this->Scene->Add(
      [](const PanelList& panels)
      {
        for (const auto& panel : panels)
        {
          panel->ResetView();
        }
      });
    this->Request();
  }
}

bool PanelView::IsBusy() const
{
  return this->PaintJob->IsBusy();
}

void PanelView::Request()
{
  if (!this->Scene)
  {
    this->PaintJob->Cancel();
    this->Painted = {};
    this->update();
    return;
  }
  const PanelLayout layout{ this->size(), this->devicePixelRatioF(), TextScale() * this->FontSize,
    this->Columns, ScreenStyle() };
  this->PaintJob->Start(
    [this, scene = this->Scene, layout](const std::atomic<bool>&) -> LatestJob::Delivery
    {
      const auto painted = std::make_shared<PaintedPanels>(scene->Paint(layout));
      return [this, scene, painted]
      {
        if (this->Scene == scene)
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

void PanelView::Change(
  const QPointF& position, const std::function<void(vtkPEMPanel*, double, double)>& change)
{
  const int panel = this->FindPanel(position);
  if (panel < 0 || !this->Scene)
  {
    return;
  }
  const QRectF box = this->Painted.Boxes[static_cast<std::size_t>(panel)];
  this->Scene->Add(
    [change, panel, all = this->Linked, in = position - box.bottomLeft()](const PanelList& panels)
    {
      for (std::size_t i = 0; i < panels.size(); ++i)
      {
        double rectangle[4];
        panels[i]->GetRectangle(rectangle);
        if (all || static_cast<int>(i) == panel)
        {
          change(panels[i], rectangle[0] + in.x(), rectangle[1] - in.y());
        }
      }
    });
  this->Request();
}

std::function<QString()> PanelView::MakeExport(const QString& file, int panel) const
{
  return [make = this->MakePanels, file, panel, columns = panel < 0 ? this->Columns : 1,
           style = LoadPlotStyle()]
  {
    PanelList panels = make();
    if (panel >= 0 && panel < static_cast<int>(panels.size()))
    {
      panels = { panels[static_cast<std::size_t>(panel)] };
    }
    return WritePanels(panels, columns, style, file);
  };
}

QString PanelView::Export(const QString& file, int panel) const
{
  return this->MakePanels ? this->MakeExport(file, panel)() : tr("There is nothing to export.");
}

void PanelView::ExportAs(int panel)
{
  const QString file =
    QFileDialog::getSaveFileName(this, tr("Export figure"), QStringLiteral("figure.pdf"),
      tr("PDF (*.pdf);;SVG (*.svg);;PNG (*.png);;Numbers of the figure (*.csv)"));
  if (file.isEmpty() || !this->MakePanels)
  {
    return;
  }
  this->ExportJob->Start(
    [this, write = this->MakeExport(file, panel)](const std::atomic<bool>&) -> LatestJob::Delivery
    {
      const QString fault = write();
      return [this, fault]
      {
        if (!fault.isEmpty())
        {
          QMessageBox::warning(this, tr("Export figure"), fault);
        }
      };
    });
}

void PanelView::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.fillRect(this->rect(), CurrentTheme().Panel);
  if (this->Scene && !this->Painted.Image.isNull())
  {
    painter.drawImage(QPointF(), this->Painted.Image);
    return;
  }
  QFont font = painter.font();
  font.setPixelSize(14);
  painter.setFont(font);
  painter.setPen(CurrentTheme().Muted);
  painter.drawText(this->rect().adjusted(40, 20, -40, -20), Qt::AlignCenter | Qt::TextWordWrap,
    this->Scene ? this->Painted.Fault : this->Hint);
}

void PanelView::resizeEvent(QResizeEvent*)
{
  this->Request();
}

void PanelView::changeEvent(QEvent* event)
{
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange)
  {
    this->Request();
  }
}

void PanelView::wheelEvent(QWheelEvent* event)
{
  if (this->GetNumberOfPanels() > 4 && !(event->modifiers() & Qt::ControlModifier))
  {
    event->ignore(); // many small charts are scrolled
    return;
  }
  const double factor = std::pow(1.0015, event->angleDelta().y());
  this->Change(event->position(),
    [factor](vtkPEMPanel* panel, double x, double y) { panel->Zoom(x, y, factor); });
  event->accept();
}

void PanelView::mousePressEvent(QMouseEvent* event)
{
  this->PressedAt = this->LastAt = event->position();
  this->IsMoving = event->button() == Qt::MiddleButton ||
    (event->button() == Qt::LeftButton && (event->modifiers() & Qt::ShiftModifier));
  this->IsPressed = event->button() == Qt::LeftButton && !this->IsMoving;
}

void PanelView::mouseMoveEvent(QMouseEvent* event)
{
  if (this->IsMoving)
  {
    const QPointF moved = event->position() - this->LastAt;
    this->Change(this->LastAt,
      [moved](vtkPEMPanel* panel, double x, double y) { panel->Pan(x, y, moved.x(), -moved.y()); });
    this->LastAt = event->position();
    return;
  }
  if (this->IsPressed)
  {
    this->Band->setGeometry(QRectF(this->PressedAt, event->position()).normalized().toRect());
    this->Band->setVisible((event->position() - this->PressedAt).manhattanLength() > DragDistance);
    return;
  }
  if (event->buttons() == Qt::NoButton && this->Scene)
  {
    const ChartPick pick =
      this->Scene->Pick(this->FindPanel(event->position()), event->position(), PickTolerance);
    QToolTip::showText(event->globalPosition().toPoint(), QString::fromStdString(pick.Text), this);
  }
}

void PanelView::mouseReleaseEvent(QMouseEvent* event)
{
  const bool wasPressed = std::exchange(this->IsPressed, false);
  this->IsMoving = false;
  const QRectF dragged = QRectF(this->PressedAt, event->position()).normalized();
  const int panel = this->FindPanel(this->PressedAt);
  const bool isDrag = this->Band->isVisible();
  this->Band->hide();
  if (!wasPressed || panel < 0 || !this->Scene)
  {
    return;
  }
  if (isDrag)
  {
    emit this->RowsSelected(panel, this->Scene->SelectRectangle(panel, dragged));
    return;
  }
  emit this->Picked(panel, this->Scene->Pick(panel, event->position(), PickTolerance));
}

void PanelView::mouseDoubleClickEvent(QMouseEvent* event)
{
  const int panel = this->FindPanel(event->position());
  if (panel >= 0)
  {
    emit this->DoubleClicked(panel);
  }
}

void PanelView::keyPressEvent(QKeyEvent* event)
{
  const QPointF at = this->FindPanel(this->mapFromGlobal(QCursor::pos())) < 0
    ? (this->Painted.Boxes.empty() ? QPointF() : this->Painted.Boxes.front().center())
    : this->mapFromGlobal(QPointF(QCursor::pos()));
  switch (event->key())
  {
    case Qt::Key_Home:
      this->ResetView();
      break;
    case Qt::Key_Plus:
    case Qt::Key_Minus:
      this->Change(at,
        [factor = event->key() == Qt::Key_Plus ? KeyZoom : 1.0 / KeyZoom](
          vtkPEMPanel* panel, double x, double y) { panel->Zoom(x, y, factor); });
      break;
    case Qt::Key_Escape:
      emit this->EscapePressed();
      [[fallthrough]];
    default:
      QWidget::keyPressEvent(event);
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
  menu.addAction(tr("Show all"), this, &PanelView::ResetView);
  menu.addSeparator();
  menu.addAction(tr("Export all of it …"), this, [this] { this->ExportAs(-1); });
  if (panel >= 0 && this->GetNumberOfPanels() > 1)
  {
    menu.addAction(tr("Export this one …"), this, [this, panel] { this->ExportAs(panel); });
  }
  menu.exec(event->globalPos());
}

} // namespace pemesh
