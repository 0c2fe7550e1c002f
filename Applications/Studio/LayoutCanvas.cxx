// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LayoutCanvas.h"

#include "PolylineSimplification.h"
#include "StudyModel.h"

#include <QKeyEvent>
#include <QMouseEvent>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pemesh
{

namespace
{

constexpr double StrokeTolerance = 2.5; // pixels that a drawn line may be simplified by
constexpr double StrokeLength = 12.0;   // pixels from where a press becomes a stroke
constexpr double StepOfTurn = 15.0;     // degrees

double Distance(const QPointF& a, const QPointF& b)
{
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

std::string PathOf(int polygon, const char* key)
{
  return "polygons[" + std::to_string(polygon) + "]." + key;
}

} // namespace

LayoutCanvas::LayoutCanvas(StudyModel* model, QWidget* parent)
  : PlaneView(parent)
  , Model(model)
{
  this->setAccessibleName(tr("Canvas of the polygons"));
}

void LayoutCanvas::SetOutlines(const StudyOutlines& outlines)
{
  this->Outlines = outlines;
  if (!outlines.Domain.empty())
  {
    QPolygonF loop;
    for (const Point2& point : outlines.Domain.front())
    {
      loop << QPointF(point.x, point.y);
    }
    this->SetHomeBox(loop.boundingRect());
  }
  // Not by the outlines: those of the study before the last edit may just be coming in.
  if (this->Selected >= this->NumberInStudy())
  {
    this->SetSelected(-1);
  }
  this->update();
}

int LayoutCanvas::NumberInStudy() const
{
  return static_cast<int>(this->Model->GetStudy().Polygons.size());
}

int LayoutCanvas::NumberOfPlaced() const
{
  return std::min(static_cast<int>(this->Outlines.Polygons.size()), this->NumberInStudy());
}

void LayoutCanvas::SetTool(Tool tool)
{
  if (this->CurrentTool != tool)
  {
    this->CurrentTool = tool;
    this->Line.clear();
    this->UpdateCursor(this->Pointer);
    this->update();
    emit this->ToolChanged(tool);
  }
}

void LayoutCanvas::SetSnapping(bool snapping)
{
  this->Snapping = snapping;
  this->update();
}

void LayoutCanvas::SetSelected(int polygon)
{
  if (this->Selected != polygon)
  {
    this->Selected = polygon;
    if (this->Current.What != LayoutGrip::Stroke)
    {
      this->Current = {}; // what was dragged is no longer what is selected
    }
    this->update();
    emit this->SelectionChanged(polygon);
  }
}

void LayoutCanvas::SetHint(const QString& hint)
{
  this->Hint = hint;
  this->update();
}

int LayoutCanvas::FindPolygon(const QPointF& position) const
{
  for (int i = this->NumberOfPlaced() - 1; i >= 0; --i)
  {
    const auto& points = this->Outlines.Polygons[static_cast<std::size_t>(i)].Points;
    if (OnScreen(points, this->GetTransform()).containsPoint(position, Qt::OddEvenFill))
    {
      return i;
    }
  }
  return -1;
}

QRectF LayoutCanvas::GetFrame() const
{
  if (this->Selected < 0 || this->Selected >= this->NumberOfPlaced())
  {
    return {};
  }
  const auto& points = this->Outlines.Polygons[static_cast<std::size_t>(this->Selected)].Points;
  return FrameAround(points, this->GetTransform());
}

LayoutGrip LayoutCanvas::FindGrip(const QPointF& position) const
{
  return pemesh::FindGrip(this->GetFrame(), position);
}

void LayoutCanvas::BeginDrag(LayoutGrip grip, const QPointF& position)
{
  const StudyPolygon& polygon =
    this->Model->GetStudy().Polygons[static_cast<std::size_t>(this->Selected)];
  this->Current = { grip, StudyModel::NewGesture(), position,
    { polygon.Center[0], polygon.Center[1] }, polygon.Scale, polygon.Rotation };
}

void LayoutCanvas::SetCenter(const Point2& center, int gesture)
{
  const auto place = [this](double value)
  {
    const double step = GridStepOf(this->GetTransform());
    return RoundToPixel(
      this->Snapping ? std::round(value / step) * step : value, this->GetTransform());
  };
  this->Model->SetValue(PathOf(this->Selected, "center"),
    { JsonValue::List{ JsonNumber(place(center.x)), JsonNumber(place(center.y)) } },
    tr("Move polygon"), gesture);
}

void LayoutCanvas::ContinueDrag(const QPointF& position, bool inSteps)
{
  const Drag& drag = this->Current;
  const QPointF center = this->GetTransform().ToScreen(drag.Center);
  if (drag.What == LayoutGrip::Move)
  {
    const QPointF moved = (position - drag.From) / this->GetTransform().Scale;
    this->SetCenter({ drag.Center.x + moved.x(), drag.Center.y - moved.y() }, drag.Gesture);
  }
  else if (drag.What == LayoutGrip::Scale)
  {
    const double factor = Distance(position, center) / std::max(1.0, Distance(drag.From, center));
    const double scale = std::round(drag.Scale * std::max(factor, 0.01) * 1000.0) / 1000.0;
    this->Model->SetValue(PathOf(this->Selected, "scale"), JsonNumber(std::max(scale, 0.001)),
      tr("Scale polygon"), drag.Gesture);
  }
  else if (drag.What == LayoutGrip::Turn)
  {
    const auto angle = [&center](const QPointF& at)
    { return std::atan2(center.y() - at.y(), at.x() - center.x()) * 180.0 / std::numbers::pi; };
    const double turned = std::remainder(drag.Rotation + angle(position) - angle(drag.From), 360.0);
    const double rotation =
      inSteps ? std::round(turned / StepOfTurn) * StepOfTurn : std::round(turned * 10.0) / 10.0;
    this->Model->SetValue(
      PathOf(this->Selected, "rotation"), JsonNumber(rotation), tr("Turn polygon"), drag.Gesture);
  }
}

void LayoutCanvas::FinishDrawing(bool isStroke)
{
  const std::vector<Point2> line = std::exchange(this->Line, {});
  this->update();
  if (line.size() < 3)
  {
    return;
  }
  const double tolerance = isStroke ? StrokeTolerance / this->GetTransform().Scale : 0.0;
  const DrawnPolygon drawn =
    PolygonOfStroke(line, tolerance, this->Snapping ? GridStepOf(this->GetTransform()) : 0.0);
  if (!drawn.Fault.empty())
  {
    emit this->Faulty(QString::fromStdString(drawn.Fault));
    return;
  }
  std::vector<Point2> points;
  for (const Point2& point : drawn.Points)
  {
    points.push_back(
      { RoundToPixel(point.x, this->GetTransform()), RoundToPixel(point.y, this->GetTransform()) });
  }
  this->SetTool(Tool::Select);
  emit this->Drawn(points);
}

void LayoutCanvas::mousePressEvent(QMouseEvent* event)
{
  this->Pointer = event->position();
  if (event->button() != Qt::LeftButton)
  {
    PlaneView::mousePressEvent(event);
    return;
  }
  const Point2 point = this->GetTransform().ToPlane(event->position());
  if (this->CurrentTool == Tool::Draw)
  {
    const bool closes = this->Line.size() > 2 &&
      Distance(this->GetTransform().ToScreen(this->Line.front()), event->position()) < GripSize;
    if (closes)
    {
      this->FinishDrawing(false);
      return;
    }
    this->Line.push_back(point);
    this->Current = { LayoutGrip::Stroke, 0, event->position(), {}, 1.0, 0.0 };
    this->update();
    return;
  }
  const LayoutGrip grip = this->FindGrip(event->position());
  if (grip != LayoutGrip::None)
  {
    this->BeginDrag(grip, event->position());
    return;
  }
  this->SetSelected(this->FindPolygon(event->position()));
  if (this->Selected >= 0)
  {
    this->BeginDrag(LayoutGrip::Move, event->position());
  }
}

void LayoutCanvas::mouseMoveEvent(QMouseEvent* event)
{
  this->Pointer = event->position();
  PlaneView::mouseMoveEvent(event);
  if (this->CurrentTool == Tool::Draw)
  {
    const bool isStroke = (event->buttons() & Qt::LeftButton) &&
      this->Current.What == LayoutGrip::Stroke &&
      (this->Line.size() > 1 || Distance(event->position(), this->Current.From) > StrokeLength / 3);
    if (isStroke && this->Current.Gesture >= 0)
    {
      this->Current.Gesture = 1; // the press has become a stroke
      this->Line.push_back(this->GetTransform().ToPlane(event->position()));
    }
    this->update();
  }
  else if (this->Current.What != LayoutGrip::None)
  {
    this->ContinueDrag(event->position(), event->modifiers() & Qt::ShiftModifier);
  }
  else
  {
    this->UpdateCursor(event->position());
  }
}

void LayoutCanvas::mouseReleaseEvent(QMouseEvent* event)
{
  PlaneView::mouseReleaseEvent(event);
  if (event->button() != Qt::LeftButton)
  {
    return;
  }
  const bool wasStroke = this->Current.What == LayoutGrip::Stroke && this->Current.Gesture > 0;
  this->Current = {};
  if (wasStroke)
  {
    this->FinishDrawing(true);
  }
}

void LayoutCanvas::mouseDoubleClickEvent(QMouseEvent* event)
{
  if (this->CurrentTool == Tool::Draw)
  {
    this->FinishDrawing(false);
    return;
  }
  PlaneView::mouseDoubleClickEvent(event);
}

void LayoutCanvas::keyPressEvent(QKeyEvent* event)
{
  const QPointF arrow(
    (event->key() == Qt::Key_Right ? 1.0 : 0.0) - (event->key() == Qt::Key_Left ? 1.0 : 0.0),
    (event->key() == Qt::Key_Up ? 1.0 : 0.0) - (event->key() == Qt::Key_Down ? 1.0 : 0.0));
  if (this->CurrentTool == Tool::Draw && event->key() == Qt::Key_Escape)
  {
    this->Line.empty() ? this->SetTool(Tool::Select) : this->Line.clear();
    this->update();
  }
  else if (this->CurrentTool == Tool::Draw &&
    (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter))
  {
    this->FinishDrawing(false);
  }
  else if (!arrow.isNull() && this->Selected >= 0 && this->Selected < this->NumberInStudy())
  {
    const auto& center =
      this->Model->GetStudy().Polygons[static_cast<std::size_t>(this->Selected)].Center;
    const double step =
      this->Snapping ? GridStepOf(this->GetTransform()) : 4.0 / this->GetTransform().Scale;
    this->SetCenter({ center[0] + arrow.x() * step, center[1] + arrow.y() * step }, 0);
  }
  else
  {
    PlaneView::keyPressEvent(event);
  }
}

void LayoutCanvas::PaintAbove(QPainter& painter)
{
  const PlaneTransform& transform = this->GetTransform();
  if (this->Snapping)
  {
    PaintGrid(painter, transform, this->size());
  }
  PaintOutlines(painter, transform, this->Outlines, this->Hovered);
  if (this->CurrentTool == Tool::Select)
  {
    PaintFrame(painter, this->GetFrame());
  }
  else if (!this->Line.empty())
  {
    const bool isStroke = this->Current.What == LayoutGrip::Stroke && this->Current.Gesture > 0;
    PaintDrawing(painter, OnScreen(this->Line, transform), isStroke, this->Pointer);
  }
  if (!this->Hint.isEmpty() && this->Line.empty())
  {
    PaintHint(painter, this->rect(), this->Hint);
  }
}

void LayoutCanvas::leaveEvent(QEvent*)
{
  this->Hovered = -1;
  this->update();
}

void LayoutCanvas::UpdateCursor(const QPointF& position)
{
  if (this->CurrentTool == Tool::Draw)
  {
    this->setCursor(Qt::CrossCursor);
    return;
  }
  const LayoutGrip grip = this->FindGrip(position);
  const int hovered = grip == LayoutGrip::None ? this->FindPolygon(position) : -1;
  if (this->Hovered != hovered)
  {
    this->Hovered = hovered;
    this->setToolTip(hovered < 0
        ? QString()
        : QString::fromStdString(this->Outlines.Polygons[static_cast<std::size_t>(hovered)].Name));
    this->update();
  }
  this->setCursor(grip == LayoutGrip::Scale ? Qt::SizeFDiagCursor
      : grip == LayoutGrip::Turn            ? Qt::PointingHandCursor
      : hovered >= 0                        ? Qt::SizeAllCursor
                                            : Qt::ArrowCursor);
}

} // namespace pemesh
