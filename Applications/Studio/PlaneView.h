// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   PlaneView
 * @brief   A view of the plane with a mesh in it: moved and zoomed with the mouse.
 *
 * The mesh is painted in a worker; until its picture is there, the last one is shown, moved and
 * scaled to where it belongs, so that nothing waits however large the mesh is. What subclasses
 * paint above it is painted at once.
 *
 * Wheel: zoom about the pointer. Middle or right button: move. Home: all of it.
 */
#ifndef pemesh_PlaneView_h
#define pemesh_PlaneView_h

#include "MeshPicture.h"

#include <QImage>
#include <QWidget>

namespace pemesh
{

class LatestJob;

class PlaneView : public QWidget
{
  Q_OBJECT
public:
  explicit PlaneView(QWidget* parent = nullptr);
  ~PlaneView() override;

  /** Null for none. */
  void SetPicture(const MeshPicturePointer& picture);
  MeshPicturePointer GetPicture() const { return this->Picture; }
  void SetColoring(const MeshColoring& coloring);
  const MeshColoring& GetColoring() const { return this->Coloring; }

  /** The part of the plane that Fit() shows. */
  void SetHomeBox(const QRectF& box);
  QRectF GetHomeBox() const { return this->HomeBox; }
  void Fit();

  const PlaneTransform& GetTransform() const { return this->Transform; }
  void SetTransform(const PlaneTransform& transform);
  /** The whole view as a picture. */
  QImage MakeImage(double pixelRatio);

  QSize minimumSizeHint() const override { return { 200, 160 }; }
  QSize sizeHint() const override { return { 640, 560 }; }

signals:
  void TransformChanged();
  void PointerMoved(const pemesh::Point2& point);

protected:
  virtual void PaintAbove(QPainter& painter);
  /** Space that subclasses need at the left, in pixels. */
  virtual double GetLeftMargin() const { return 0.0; }
  /** Empty space around the home box, in pixels. */
  static constexpr int Margin = 36;

  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  void RequestImage();

  MeshPicturePointer Picture;
  MeshColoring Coloring;
  PlaneTransform Transform;
  QRectF HomeBox{ 0.0, 0.0, 1.0, 1.0 };
  bool IsHome = true; // follows the size of the widget until it is moved
  QImage Image;
  PlaneTransform ImageTransform;
  LatestJob* PaintJob;
  bool IsMoving = false;
  QPointF LastPosition;
};

} // namespace pemesh

#endif
