// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What the canvas of the polygons shows above the mesh, and where it can be gripped.
 */
#ifndef pemesh_LayoutMarks_h
#define pemesh_LayoutMarks_h

#include "PlaneView.h"
#include "StudyOutlines.h"

#include <QPolygonF>
#include <QRectF>

#include <vector>

class QPainter;

namespace pemesh
{

/** What a press takes hold of. */
enum class LayoutGrip
{
  None,
  Move,
  Scale,
  Turn,
  Stroke
};

inline constexpr double GripSize = 9.0; // pixels

QPolygonF OnScreen(const std::vector<Point2>& points, const PlaneTransform& transform);

///@{
/** The frame around a polygon: its corners scale, the knob above it turns. */
QRectF FrameAround(const std::vector<Point2>& points, const PlaneTransform& transform);
LayoutGrip FindGrip(const QRectF& frame, const QPointF& position);
///@}

/** Distance of the lines of the grid, a round number of some ten pixels. */
double GridStepOf(const PlaneTransform& transform);

/** To the decimal that is just finer than a pixel: numbers that a person can read. */
double RoundToPixel(double value, const PlaneTransform& transform);

///@{
void PaintGrid(QPainter& painter, const PlaneTransform& transform, const QSizeF& size);
/** The domain and the polygons, of which one is under the mouse (-1: none). */
void PaintOutlines(
  QPainter& painter, const PlaneTransform& transform, const StudyOutlines& outlines, int hovered);
void PaintFrame(QPainter& painter, const QRectF& frame);
/** A polygon that is being drawn, by a stroke or corner by corner up to the pointer. */
void PaintDrawing(QPainter& painter, QPolygonF line, bool isStroke, const QPointF& pointer);
void PaintHint(QPainter& painter, const QRectF& area, const QString& hint);
///@}

} // namespace pemesh

#endif
