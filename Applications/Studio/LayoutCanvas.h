// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   LayoutCanvas
 * @brief   The domain with its polygons and the mesh: where polygons are placed and drawn.
 *
 * Select: click a polygon, drag it, its corners to scale, the knob above it to turn (Shift: steps
 * of 15 degrees). Draw: drag a stroke around the polygon, or click its corners and end with Enter,
 * a double click or a click on the first one; Escape gives up. Arrow keys move what is selected.
 * Every change is one of the document.
 */
#ifndef pemesh_LayoutCanvas_h
#define pemesh_LayoutCanvas_h

#include "LayoutMarks.h"

#include <optional>
#include <vector>

namespace pemesh
{

class StudyModel;

class LayoutCanvas : public PlaneView
{
  Q_OBJECT
public:
  enum class Tool
  {
    Select,
    Draw
  };

  explicit LayoutCanvas(StudyModel* model, QWidget* parent = nullptr);

  void SetOutlines(const StudyOutlines& outlines);
  void SetTool(Tool tool);
  void SetSnapping(bool snapping);
  void SetSelected(int polygon);
  int GetSelected() const { return this->Selected; }
  /** Told where there is nothing to show. */
  void SetHint(const QString& hint);

signals:
  void SelectionChanged(int polygon);
  /** A polygon was drawn; its corners counter-clockwise. */
  void Drawn(const std::vector<pemesh::Point2>& points);
  void Faulty(const QString& sentence);
  void ToolChanged(pemesh::LayoutCanvas::Tool tool);

protected:
  void PaintAbove(QPainter& painter) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

private:
  /** What is dragged, and how it was when the drag began. */
  struct Drag
  {
    LayoutGrip What = LayoutGrip::None;
    int Gesture = 0;
    QPointF From;
    Point2 Center;
    double Scale = 1.0;
    double Rotation = 0.0;
  };

  int NumberInStudy() const;
  int NumberOfPlaced() const; // those that have an outline yet
  int FindPolygon(const QPointF& position) const;
  /** Around the selected polygon; empty if there is none. */
  QRectF GetFrame() const;
  LayoutGrip FindGrip(const QPointF& position) const;
  void BeginDrag(LayoutGrip grip, const QPointF& position);
  void ContinueDrag(const QPointF& position, bool inSteps);
  void SetCenter(const Point2& center, int gesture);
  void FinishDrawing(bool isStroke);
  void UpdateCursor(const QPointF& position);

  StudyModel* Model;
  StudyOutlines Outlines;
  Tool CurrentTool = Tool::Select;
  bool Snapping = false;
  int Selected = -1;
  int Hovered = -1;
  Drag Current;
  std::vector<Point2> Line; // what is being drawn
  QPointF Pointer;
  QString Hint;
};

} // namespace pemesh

#endif
