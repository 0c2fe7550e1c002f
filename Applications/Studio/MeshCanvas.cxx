// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshCanvas.h"

#include "Appearance.h"
#include "ColorMaps.h"

#include <QMouseEvent>
#include <QPainter>
#include <QRubberBand>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace pemesh
{

namespace
{

constexpr int DragDistance = 6; // pixels
constexpr double BarWidth = 16.0;
constexpr double BarHeight = 220.0;
constexpr const char* ExtremeColors[2] = { "#d55e00", "#cc2f8e" };

QString ShowNumber(double value)
{
  return QString::number(value, 'g', 4);
}

} // namespace

MeshCanvas::MeshCanvas(QWidget* parent)
  : PlaneView(parent)
  , Band(new QRubberBand(QRubberBand::Rectangle, this))
{
  this->setAccessibleName(tr("Mesh"));
}

void MeshCanvas::SetColors(
  const QString& array, const QString& title, const double range[2], bool logarithmic)
{
  this->Title = title;
  this->Range[0] = range[0];
  this->Range[1] = range[1];
  MeshColoring coloring = this->GetColoring();
  coloring.Array = array.toStdString();
  coloring.Range[0] = range[0];
  coloring.Range[1] = range[1];
  coloring.Logarithmic = logarithmic;
  coloring.Line = qRgb(60, 70, 80);
  coloring.Plain = CurrentTheme().Canvas.rgb();
  this->SetColoring(coloring);
  this->Refresh();
}

void MeshCanvas::Refresh()
{
  this->Extremes = this->GetPicture() ? this->GetPicture()->FindExtremes(this->GetColoring().Array)
                                      : MeshPicture::Extremes();
  this->update();
}

void MeshCanvas::SetShowExtremes(bool show)
{
  this->ShowExtremes = show;
  this->update();
}

void MeshCanvas::SetSelected(qint64 element)
{
  this->Selected = element;
  this->update();
}

void MeshCanvas::SetHint(const QString& hint)
{
  this->Hint = hint;
  this->update();
}

QPolygonF MeshCanvas::OnScreen(qint64 element) const
{
  QPolygonF polygon;
  const MeshPicturePointer picture = this->GetPicture();
  if (picture && element >= 0 && element < picture->GetNumberOfElements())
  {
    for (const Point2& point : picture->GetElement(element))
    {
      polygon << this->GetTransform().ToScreen(point);
    }
  }
  return polygon;
}

void MeshCanvas::SetMarked(const std::vector<vtkIdType>& elements)
{
  MeshColoring coloring = this->GetColoring();
  const bool one = elements.size() < 2; // the one that is selected has a frame
  coloring.Marked = one ? nullptr : std::make_shared<const std::vector<vtkIdType>>(elements);
  this->SetColoring(coloring);
}

void MeshCanvas::mousePressEvent(QMouseEvent* event)
{
  PlaneView::mousePressEvent(event);
  this->PressedAt = event->position();
  this->IsPressed = event->button() == Qt::LeftButton;
}

void MeshCanvas::mouseReleaseEvent(QMouseEvent* event)
{
  PlaneView::mouseReleaseEvent(event);
  const bool isDrag = this->Band->isVisible();
  this->Band->hide();
  const MeshPicturePointer picture = this->GetPicture();
  if (!std::exchange(this->IsPressed, false) || !picture)
  {
    return;
  }
  const Point2 from = this->GetTransform().ToPlane(this->PressedAt);
  const Point2 to = this->GetTransform().ToPlane(event->position());
  if (isDrag)
  {
    emit this->ElementsMarked(picture->FindElements(from, to));
    return;
  }
  emit this->ElementClicked(picture->FindElement(to));
}

void MeshCanvas::mouseMoveEvent(QMouseEvent* event)
{
  PlaneView::mouseMoveEvent(event);
  const MeshPicturePointer picture = this->GetPicture();
  if (this->IsPressed)
  {
    this->Band->setGeometry(QRectF(this->PressedAt, event->position()).normalized().toRect());
    this->Band->setVisible((event->position() - this->PressedAt).manhattanLength() > DragDistance);
  }
  if (!picture || event->buttons() != Qt::NoButton)
  {
    return;
  }
  const vtkIdType element = picture->FindElement(this->GetTransform().ToPlane(event->position()));
  const QString text = element < 0
    ? QString()
    : tr("Element %1: %2")
        .arg(element)
        .arg(ShowNumber(picture->GetValue(this->GetColoring().Array, element)));
  QToolTip::showText(event->globalPosition().toPoint(), text, this);
}

void MeshCanvas::PaintExtreme(QPainter& painter, int end) const
{
  const QPolygonF polygon = this->OnScreen(this->Extremes.Elements[end]);
  if (polygon.isEmpty())
  {
    return;
  }
  const QColor color(ExtremeColors[end]);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(color, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolygon(polygon);
  const QString text =
    (end == 0 ? tr("min %1") : tr("max %1")).arg(ShowNumber(this->Extremes.Values[end]));
  const QRectF bounds = polygon.boundingRect();
  QRectF label = painter.fontMetrics().boundingRect(text).adjusted(-6, -3, 6, 3);
  label.moveCenter({ bounds.center().x(), bounds.top() - label.height() / 2.0 - 4.0 });
  label.moveLeft(std::clamp(label.left(), 4.0, std::max(4.0, this->width() - label.width() - 4.0)));
  label.moveTop(std::max(4.0, label.top()));
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawRoundedRect(label, 4, 4);
  painter.setPen(Qt::white);
  painter.drawText(label, Qt::AlignCenter, text);
}

void MeshCanvas::PaintScale(QPainter& painter) const
{
  ColorScale scale{ FindColorMap("viridis"), this->Range[0], this->Range[1],
    this->GetColoring().Logarithmic };
  if (scale.Low == scale.High)
  {
    scale.Low = this->Extremes.Values[0];
    scale.High = this->Extremes.Values[1];
  }
  const double height = std::min(BarHeight, this->height() - 90.0);
  if (height < 40.0 || this->Extremes.Elements[0] < 0)
  {
    return;
  }
  const Theme& theme = CurrentTheme();
  const QRectF bar(18.0, 40.0, BarWidth, height);
  QColor back = theme.Canvas;
  back.setAlphaF(0.85F);
  const double titleWidth = painter.fontMetrics().horizontalAdvance(this->Title);
  painter.setPen(Qt::NoPen);
  painter.setBrush(back);
  painter.drawRoundedRect(
    QRectF(8.0, 8.0, std::max(110.0, titleWidth + 24.0), height + 50.0), 6, 6);
  QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
  for (int i = 0; i <= 16; ++i)
  {
    const ChartColor color = MapColor(*scale.Map, i / 16.0);
    gradient.setColorAt(i / 16.0, QColor(color[0], color[1], color[2]));
  }
  painter.setBrush(gradient);
  painter.drawRect(bar);
  painter.setPen(theme.Text);
  painter.drawText(QPointF(18.0, 28.0), this->Title);
  for (int i = 0; i <= 4; ++i)
  {
    const double y = bar.bottom() - i / 4.0 * bar.height();
    painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 4.0, y));
    painter.drawText(QPointF(bar.right() + 8.0, y + 4.0), ShowNumber(scale.ValueAt(i / 4.0)));
  }
}

void MeshCanvas::PaintAbove(QPainter& painter)
{
  const Theme& theme = CurrentTheme();
  if (!this->GetPicture() || this->GetPicture()->GetNumberOfElements() == 0)
  {
    painter.setPen(theme.Muted);
    painter.drawText(
      this->rect().adjusted(40, 40, -40, -40), Qt::AlignCenter | Qt::TextWordWrap, this->Hint);
    return;
  }
  if (this->ShowExtremes && !this->GetColoring().Array.empty())
  {
    this->PaintExtreme(painter, 0);
    this->PaintExtreme(painter, 1);
  }
  const QPolygonF selected = this->OnScreen(this->Selected);
  if (!selected.isEmpty())
  {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::white, 6.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolygon(selected);
    painter.setPen(QPen(theme.Accent, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolygon(selected);
  }
  if (!this->GetColoring().Array.empty())
  {
    this->PaintScale(painter);
  }
}

} // namespace pemesh
