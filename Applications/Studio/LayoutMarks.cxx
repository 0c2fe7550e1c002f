// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LayoutMarks.h"

#include "Appearance.h"
#include "ColorMaps.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

constexpr double KnobDistance = 26.0; // pixels above the frame
constexpr double FrameMargin = 7.0;   // pixels
constexpr double GridPixels = 14.0;   // least distance of the lines of the grid

double Distance(const QPointF& a, const QPointF& b)
{
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

QColor FamilyColor(int family)
{
  const ChartColor color = SeriesColor(family);
  return { color[0], color[1], color[2] };
}

QPointF KnobOf(const QRectF& frame)
{
  return { frame.center().x(), frame.top() - KnobDistance };
}

} // namespace

QPolygonF OnScreen(const std::vector<Point2>& points, const PlaneTransform& transform)
{
  QPolygonF polygon;
  for (const Point2& point : points)
  {
    polygon << transform.ToScreen(point);
  }
  return polygon;
}

QRectF FrameAround(const std::vector<Point2>& points, const PlaneTransform& transform)
{
  return OnScreen(points, transform)
    .boundingRect()
    .adjusted(-FrameMargin, -FrameMargin, FrameMargin, FrameMargin);
}

LayoutGrip FindGrip(const QRectF& frame, const QPointF& position)
{
  if (!frame.isValid())
  {
    return LayoutGrip::None;
  }
  if (Distance(position, KnobOf(frame)) < GripSize)
  {
    return LayoutGrip::Turn;
  }
  for (const QPointF& corner :
    { frame.topLeft(), frame.topRight(), frame.bottomLeft(), frame.bottomRight() })
  {
    if (Distance(position, corner) < GripSize)
    {
      return LayoutGrip::Scale;
    }
  }
  return LayoutGrip::None;
}

double GridStepOf(const PlaneTransform& transform)
{
  const double least = GridPixels / transform.Scale;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : { 1.0, 2.0, 5.0 })
  {
    if (factor * power >= least)
    {
      return factor * power;
    }
  }
  return 10.0 * power;
}

double RoundToPixel(double value, const PlaneTransform& transform)
{
  const double decimals = std::clamp(std::ceil(std::log10(transform.Scale)), 0.0, 15.0);
  const double inverse = std::pow(10.0, decimals);
  return std::round(value * inverse) / inverse;
}

void PaintGrid(QPainter& painter, const PlaneTransform& transform, const QSizeF& size)
{
  const double step = GridStepOf(transform);
  QColor color = CurrentTheme().Border;
  color.setAlphaF(0.5F);
  painter.setPen(QPen(color, 1.0));
  const Point2 low = transform.ToPlane({ 0.0, size.height() });
  const Point2 high = transform.ToPlane({ size.width(), 0.0 });
  for (double x = std::ceil(low.x / step) * step; x < high.x; x += step)
  {
    const double at = transform.ToScreen({ x, 0.0 }).x();
    painter.drawLine(QPointF(at, 0.0), QPointF(at, size.height()));
  }
  for (double y = std::ceil(low.y / step) * step; y < high.y; y += step)
  {
    const double at = transform.ToScreen({ 0.0, y }).y();
    painter.drawLine(QPointF(0.0, at), QPointF(size.width(), at));
  }
}

void PaintOutlines(
  QPainter& painter, const PlaneTransform& transform, const StudyOutlines& outlines, int hovered)
{
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(CurrentTheme().Text, 1.8));
  for (const auto& loop : outlines.Domain)
  {
    painter.drawPolygon(OnScreen(loop, transform));
  }
  for (std::size_t i = 0; i < outlines.Polygons.size(); ++i)
  {
    const StudyOutlines::Polygon& polygon = outlines.Polygons[i];
    const bool isHovered = static_cast<int>(i) == hovered;
    QColor color = FamilyColor(polygon.Family);
    painter.setPen(QPen(color, isHovered ? 2.8 : 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    color.setAlphaF(isHovered ? 0.45F : 0.3F);
    painter.setBrush(color);
    painter.drawPolygon(OnScreen(polygon.Points, transform), Qt::OddEvenFill);
  }
}

void PaintFrame(QPainter& painter, const QRectF& frame)
{
  if (!frame.isValid())
  {
    return;
  }
  const Theme& theme = CurrentTheme();
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme.Accent, 1.2, Qt::DashLine));
  painter.drawRect(frame);
  painter.setPen(QPen(theme.Accent, 1.5));
  painter.drawLine(QPointF(frame.center().x(), frame.top()), KnobOf(frame));
  painter.setBrush(theme.Panel);
  painter.drawEllipse(KnobOf(frame), GripSize / 2.0, GripSize / 2.0);
  for (const QPointF& corner :
    { frame.topLeft(), frame.topRight(), frame.bottomLeft(), frame.bottomRight() })
  {
    painter.drawRect(
      QRectF(corner.x() - GripSize / 2.0, corner.y() - GripSize / 2.0, GripSize, GripSize));
  }
}

void PaintDrawing(QPainter& painter, QPolygonF line, bool isStroke, const QPointF& pointer)
{
  const Theme& theme = CurrentTheme();
  QColor fill = theme.Accent;
  fill.setAlphaF(0.15F);
  painter.setBrush(fill);
  painter.setPen(QPen(theme.Accent, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  if (isStroke)
  {
    painter.drawPolygon(line);
    return;
  }
  line << pointer;
  painter.drawPolyline(line);
  painter.setBrush(theme.Panel);
  for (int i = 0; i + 1 < line.size(); ++i)
  {
    painter.drawEllipse(line[i], 4.0, 4.0);
  }
}

void PaintHint(QPainter& painter, const QRectF& area, const QString& hint)
{
  QFont font = painter.font();
  font.setPixelSize(15);
  painter.setFont(font);
  const QRectF box = area.adjusted(60, 60, -60, -60);
  const QRectF text = painter.boundingRect(box, Qt::AlignCenter | Qt::TextWordWrap, hint);
  painter.setPen(Qt::NoPen);
  QColor back = CurrentTheme().Canvas;
  back.setAlphaF(0.85F);
  painter.setBrush(back);
  painter.drawRoundedRect(text.adjusted(-18, -12, 18, 12), 8, 8);
  painter.setPen(CurrentTheme().Muted);
  painter.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, hint);
}

} // namespace pemesh
