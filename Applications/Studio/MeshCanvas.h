// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   MeshCanvas
 * @brief   A mesh coloured by a metric, with its scale, its extreme elements and the selected one.
 */
#ifndef pemesh_MeshCanvas_h
#define pemesh_MeshCanvas_h

#include "PlaneView.h"

class QRubberBand;

namespace pemesh
{

class MeshCanvas : public PlaneView
{
  Q_OBJECT
public:
  explicit MeshCanvas(QWidget* parent = nullptr);

  /** The array to colour by, its title, and the ends of the scale (equal: those of the mesh). */
  void SetColors(
    const QString& array, const QString& title, const double range[2], bool logarithmic);
  void SetShowExtremes(bool show);
  void SetSelected(qint64 element);
  /** Elements that stand out, ascending; none: all alike. */
  void SetMarked(const std::vector<vtkIdType>& elements);
  void SetHint(const QString& hint);
  /** After SetPicture: what depends on the values of the mesh. */
  void Refresh();

signals:
  /** -1 beside the mesh. */
  void ElementClicked(qint64 element);
  /** Those with their middle in a rectangle that was dragged. */
  void ElementsMarked(const std::vector<vtkIdType>& elements);

protected:
  double GetLeftMargin() const override { return 110.0; }
  void PaintAbove(QPainter& painter) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

private:
  QPolygonF OnScreen(qint64 element) const;
  void PaintExtreme(QPainter& painter, int end) const;
  void PaintScale(QPainter& painter) const;

  QString Title;
  double Range[2] = { 0.0, 0.0 };
  bool ShowExtremes = true;
  qint64 Selected = -1;
  MeshPicture::Extremes Extremes;
  QString Hint;
  QRubberBand* Band;
  QPointF PressedAt;
  bool IsPressed = false;
};

} // namespace pemesh

#endif
