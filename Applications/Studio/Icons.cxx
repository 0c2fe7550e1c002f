// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Icons.h"

#include "Appearance.h"
#include "ColorMaps.h"
#include "PolygonFamilies.h"

#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

#include <algorithm>
#include <array>
#include <string_view>

namespace pemesh
{

namespace
{

/** Lines on a square of 24 by 24: M and L with coordinates, Z closes, C x y r is a circle. */
struct IconDrawing
{
  const char* Name;
  const char* Path;
};

constexpr IconDrawing Drawings[] = {
  { "mesh", "M 3 3 L 21 3 L 21 21 L 3 21 Z M 3 3 L 10 12 L 21 3 M 10 12 L 3 21 M 10 12 L 21 21" },
  { "geometry", "M 4 20 L 20 20 M 4 20 L 14 4 M 11 20 L 10 16 L 7.5 14 M 17 20 L 17 9" },
  { "solver", "M 3 17 L 6 17 L 9 6 L 13 20 L 16 10 L 18 14 L 21 14" },
  { "correlation",
    "M 4 3 L 4 20 L 21 20 C 8 15 1.2 C 11 13 1.2 C 13 9.5 1.2 C 17 8 1.2 C 18 5 1.2" },
  { "new", "M 6 3 L 14 3 L 19 8 L 19 21 L 6 21 Z M 14 3 L 14 8 L 19 8" },
  { "open", "M 3 6 L 9 6 L 11 8 L 20 8 L 20 11 M 3 6 L 3 19 L 18 19 L 21 11 L 6 11 L 3 19" },
  { "save",
    "M 4 4 L 17 4 L 20 7 L 20 20 L 4 20 Z M 8 4 L 8 9 L 15 9 L 15 4 M 7 20 L 7 13 L 17 13 L 17 "
    "20" },
  { "undo", "M 8 5 L 4 9 L 8 13 M 4 9 L 14 9 L 18 10.5 L 19.5 14 L 18 17.5 L 14 19 L 9 19" },
  { "redo", "M 16 5 L 20 9 L 16 13 M 20 9 L 10 9 L 6 10.5 L 4.5 14 L 6 17.5 L 10 19 L 15 19" },
  { "run", "M 7 4 L 20 12 L 7 20 Z" },
  { "stop", "M 6 6 L 18 6 L 18 18 L 6 18 Z" },
  { "cancel", "M 6 6 L 18 18 M 18 6 L 6 18" },
  { "play", "M 8 5 L 19 12 L 8 19 Z" },
  { "pause", "M 8 5 L 8 19 M 16 5 L 16 19" },
  { "select", "M 6 3 L 6 19 L 10.5 15 L 13.5 21 L 16 20 L 13 14 L 19 14 Z" },
  { "draw", "M 4 20 L 5 15 L 16 4 L 20 8 L 9 19 Z M 13.5 6.5 L 17.5 10.5" },
  { "snap",
    "M 4 4 L 4 20 M 12 4 L 12 20 M 20 4 L 20 20 M 4 4 L 20 4 M 4 12 L 20 12 M 4 20 L 20 20" },
  { "fit", "M 4 9 L 4 4 L 9 4 M 15 4 L 20 4 L 20 9 M 20 15 L 20 20 L 15 20 M 9 20 L 4 20 L 4 15" },
  { "duplicate", "M 8 8 L 20 8 L 20 20 L 8 20 Z M 8 16 L 4 16 L 4 4 L 16 4 L 16 8" },
  { "delete",
    "M 4 7 L 20 7 M 9 7 L 9 4 L 15 4 L 15 7 M 6 7 L 7 21 L 17 21 L 18 7 M 10 11 L 10 17 M 14 11 L "
    "14 17" },
  { "up", "M 12 20 L 12 5 M 6 11 L 12 5 L 18 11" },
  { "down", "M 12 4 L 12 19 M 6 13 L 12 19 L 18 13" },
  { "add", "M 12 5 L 12 19 M 5 12 L 19 12" },
  { "export", "M 12 15 L 12 4 M 8 8 L 12 4 L 16 8 M 4 14 L 4 20 L 20 20 L 20 14" },
  { "palette", "M 4 6 L 20 6 M 4 12 L 20 12 M 4 18 L 20 18 C 9 6 2 C 15 12 2 C 8 18 2" },
  { "reset",
    "M 6 6 L 6 11 L 11 11 M 6 11 L 9 7 L 13 5.5 L 17 7 L 19.5 11 L 19 15 L 16 18.5 L 12 19.5 L 8 "
    "18" },
  { "grid",
    "M 4 4 L 10 4 L 10 10 L 4 10 Z M 14 4 L 20 4 L 20 10 L 14 10 Z M 4 14 L 10 14 L 10 20 L 4 20 Z "
    "M 14 14 L 20 14 L 20 20 L 14 20 Z" },
  { "table", "M 3 5 L 21 5 L 21 19 L 3 19 Z M 3 10 L 21 10 M 3 14.5 L 21 14.5 M 10 5 L 10 19" },
  { "extremes", "M 4 18 L 9 8 L 14 15 L 20 5 C 9 8 2 C 20 5 2" },
};

QPainterPath PathOf(std::string_view text)
{
  QPainterPath path;
  const QStringList words =
    QString::fromLatin1(text.data(), static_cast<int>(text.size())).split(QLatin1Char(' '));
  for (int i = 0; i < words.size();)
  {
    const char command = words[i++][0].toLatin1();
    const auto number = [&words, &i] { return words[i++].toDouble(); };
    if (command == 'Z')
    {
      path.closeSubpath();
      continue;
    }
    const double x = number();
    const double y = number();
    if (command == 'M')
    {
      path.moveTo(x, y);
    }
    else if (command == 'L')
    {
      path.lineTo(x, y);
    }
    else
    {
      const double radius = number();
      path.addEllipse(QPointF(x, y), radius, radius);
    }
  }
  return path;
}

/** Paints a drawing anew at every size and in the colours of the theme in force. */
class DrawnIconEngine : public QIconEngine
{
public:
  explicit DrawnIconEngine(const IconDrawing& drawing)
    : Drawing(drawing)
  {
  }

  void paint(
    QPainter* painter, const QRect& rectangle, QIcon::Mode mode, QIcon::State state) override
  {
    const Theme& theme = CurrentTheme();
    const QColor color = mode == QIcon::Disabled ? theme.Border
      : state == QIcon::On                       ? theme.Accent
                                                 : theme.Text;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(rectangle.topLeft());
    painter->scale(rectangle.width() / 24.0, rectangle.height() / 24.0);
    painter->setPen(QPen(color, 1.7, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter->drawPath(PathOf(this->Drawing.Path));
    painter->restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
  {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    this->paint(&painter, QRect(QPoint(), size), mode, state);
    return pixmap;
  }

  QIconEngine* clone() const override { return new DrawnIconEngine(this->Drawing); }

private:
  const IconDrawing& Drawing;
};

QPolygonF FitInto(const std::vector<Point2>& points, const QRectF& box)
{
  QPolygonF polygon;
  for (const Point2& point : points)
  {
    polygon << QPointF(point.x, -point.y);
  }
  const QRectF bounds = polygon.boundingRect();
  const double scale = std::min(
    box.width() / std::max(bounds.width(), 1e-9), box.height() / std::max(bounds.height(), 1e-9));
  for (QPointF& point : polygon)
  {
    point = box.center() + (point - bounds.center()) * scale;
  }
  return polygon;
}

} // namespace

QIcon MakeIcon(const char* name)
{
  for (const IconDrawing& drawing : Drawings)
  {
    if (std::string_view(drawing.Name) == name)
    {
      return QIcon(new DrawnIconEngine(drawing));
    }
  }
  return {};
}

QIcon MakeFamilyIcon(int family, double t, int size)
{
  constexpr int sharpness = 2; // pixels a point, for screens of high resolution
  QPixmap pixmap(size * sharpness, size * sharpness);
  pixmap.setDevicePixelRatio(sharpness);
  pixmap.fill(Qt::transparent);
  const PolygonFamily& entry = PolygonFamilies()[static_cast<std::size_t>(family)];
  if (entry.Vertices)
  {
    const ChartColor color = SeriesColor(family);
    QColor fill(color[0], color[1], color[2]);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(fill, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    fill.setAlphaF(0.35F);
    painter.setBrush(fill);
    painter.drawPolygon(FitInto(
      entry.Vertices(t, ParameterValues(entry.Parameters)), QRectF(3, 3, size - 6.0, size - 6.0)));
  }
  return QIcon(pixmap);
}

} // namespace pemesh
