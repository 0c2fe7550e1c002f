// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// How the canvas of the polygons is painted.
#include "LayoutCanvas.h"

#include "Appearance.h"
#include "ColorMaps.h"

#include <QPainter>

#include <cmath>

namespace pemesh
{

namespace
{

QColor FamilyColor(int family)
{
  const ChartColor color = SeriesColor(family);
  return { color[0], color[1], color[2] };
}

} // namespace

void LayoutCanvas::PaintGrid(QPainter& painter) const
{
  const double step = this->GetGridStep();
  QColor color = CurrentTheme().Border;
  color.setAlphaF(0.5F);
  painter.setPen(QPen(color, 1.0));
  const Point2 low = this->GetTransform().ToPlane({ 0.0, static_cast<double>(this->height()) });
  const Point2 high = this->GetTransform().ToPlane({ static_cast<double>(this->width()), 0.0 });
  for (double x = std::ceil(low.x / step) * step; x < high.x; x += step)
  {
    const double at = this->GetTransform().ToScreen({ x, 0.0 }).x();
    painter.drawLine(QPointF(at, 0.0), QPointF(at, this->height()));
  }
  for (double y = std::ceil(low.y / step) * step; y < high.y; y += step)
  {
    const double at = this->GetTransform().ToScreen({ 0.0, y }).y();
    painter.drawLine(QPointF(0.0, at), QPointF(this->width(), at));
  }
}

void LayoutCanvas::PaintPolygons(QPainter& painter) const
{
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(CurrentTheme().Text, 1.8));
  for (const auto& loop : this->Outlines.Domain)
  {
    painter.drawPolygon(this->OnScreen(loop));
  }
  for (std::size_t i = 0; i < this->Outlines.Polygons.size(); ++i)
  {
    const StudyOutlines::Polygon& polygon = this->Outlines.Polygons[i];
    const bool isHovered = static_cast<int>(i) == this->Hovered;
    QColor color = FamilyColor(polygon.Family);
    painter.setPen(QPen(color, isHovered ? 2.8 : 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    color.setAlphaF(isHovered ? 0.45F : 0.3F);
    painter.setBrush(color);
    painter.drawPolygon(this->OnScreen(polygon.Points), Qt::OddEvenFill);
  }
}

void LayoutCanvas::PaintFrame(QPainter& painter) const
{
  const QRectF frame = this->GetFrame();
  if (!frame.isValid() || this->CurrentTool != Tool::Select)
  {
    return;
  }
  const Theme& theme = CurrentTheme();
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme.Accent, 1.2, Qt::DashLine));
  painter.drawRect(frame);
  painter.setPen(QPen(theme.Accent, 1.5));
  painter.drawLine(QPointF(frame.center().x(), frame.top()), this->GetKnob());
  painter.setBrush(theme.Panel);
  painter.drawEllipse(this->GetKnob(), GripSize / 2.0, GripSize / 2.0);
  for (const QPointF& corner :
    { frame.topLeft(), frame.topRight(), frame.bottomLeft(), frame.bottomRight() })
  {
    painter.drawRect(
      QRectF(corner.x() - GripSize / 2.0, corner.y() - GripSize / 2.0, GripSize, GripSize));
  }
}

void LayoutCanvas::PaintDrawing(QPainter& painter) const
{
  if (this->CurrentTool != Tool::Draw || this->Line.empty())
  {
    return;
  }
  const Theme& theme = CurrentTheme();
  QPolygonF line = this->OnScreen(this->Line);
  const bool isStroke = this->Current.What == Grip::Stroke && this->Current.Gesture > 0;
  QColor fill = theme.Accent;
  fill.setAlphaF(0.15F);
  painter.setBrush(fill);
  painter.setPen(QPen(theme.Accent, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  if (isStroke)
  {
    painter.drawPolygon(line);
    return;
  }
  line << this->Pointer;
  painter.drawPolyline(line);
  painter.setBrush(theme.Panel);
  for (int i = 0; i + 1 < line.size(); ++i)
  {
    painter.drawEllipse(line[i], 4.0, 4.0);
  }
}

void LayoutCanvas::PaintAbove(QPainter& painter)
{
  if (this->Snapping)
  {
    this->PaintGrid(painter);
  }
  this->PaintPolygons(painter);
  this->PaintFrame(painter);
  this->PaintDrawing(painter);
  if (!this->Hint.isEmpty() && this->Line.empty())
  {
    QFont font = painter.font();
    font.setPixelSize(15);
    painter.setFont(font);
    const QRectF box = QRectF(this->rect()).adjusted(60, 60, -60, -60);
    const QRectF text = painter.boundingRect(box, Qt::AlignCenter | Qt::TextWordWrap, this->Hint);
    painter.setPen(Qt::NoPen);
    QColor back = CurrentTheme().Canvas;
    back.setAlphaF(0.85F);
    painter.setBrush(back);
    painter.drawRoundedRect(text.adjusted(-18, -12, 18, 12), 8, 8);
    painter.setPen(CurrentTheme().Muted);
    painter.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, this->Hint);
  }
}

} // namespace pemesh
