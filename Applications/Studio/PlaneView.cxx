// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlaneView.h"

#include "Appearance.h"
#include "LatestJob.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace pemesh
{

PlaneView::PlaneView(QWidget* parent)
  : QWidget(parent)
  , PaintJob(new LatestJob(this, 1000))
{
  this->setMouseTracking(true);
  this->setFocusPolicy(Qt::StrongFocus);
  this->setContextMenuPolicy(Qt::PreventContextMenu);
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

PlaneView::~PlaneView()
{
  delete this->PaintJob;
}

void PlaneView::SetPicture(const MeshPicturePointer& picture)
{
  if (this->Picture != picture)
  {
    this->Picture = picture;
    this->RequestImage();
  }
}

void PlaneView::SetColoring(const MeshColoring& coloring)
{
  if (!(this->Coloring == coloring))
  {
    this->Coloring = coloring;
    this->RequestImage();
  }
}

void PlaneView::SetHomeBox(const QRectF& box)
{
  if (this->HomeBox != box && box.isValid())
  {
    this->HomeBox = box;
    if (this->IsHome)
    {
      this->Fit();
    }
  }
}

void PlaneView::Fit()
{
  const double left = this->GetLeftMargin();
  const double width = std::max(10.0, this->width() - left - 2.0 * Margin);
  const double height = std::max(10.0, this->height() - 2.0 * Margin);
  PlaneTransform transform;
  transform.Scale = std::min(width / this->HomeBox.width(), height / this->HomeBox.height());
  const QPointF center = this->HomeBox.center();
  transform.Origin = { (this->width() + left) / 2.0 - transform.Scale * center.x(),
    this->height() / 2.0 + transform.Scale * center.y() };
  this->SetTransform(transform);
  this->IsHome = true;
}

void PlaneView::SetTransform(const PlaneTransform& transform)
{
  if (this->Transform.Scale == transform.Scale && this->Transform.Origin == transform.Origin)
  {
    return;
  }
  this->Transform = transform;
  this->IsHome = false;
  this->RequestImage();
  emit this->TransformChanged();
}

void PlaneView::RequestImage()
{
  this->update();
  if (!this->Picture)
  {
    this->PaintJob->Cancel();
    this->Image = {};
    return;
  }
  this->PaintJob->Start(
    [this, picture = this->Picture, transform = this->Transform, size = QSizeF(this->size()),
      ratio = this->devicePixelRatioF(),
      coloring = this->Coloring](const std::atomic<bool>& stop) -> LatestJob::Delivery
    {
      const QImage image = picture->Paint(transform, size, ratio, coloring, stop);
      return [this, image, transform]
      {
        this->Image = this->Picture ? image : QImage();
        this->ImageTransform = transform;
        this->update();
      };
    });
}

QImage PlaneView::MakeImage(double pixelRatio)
{
  QImage image((QSizeF(this->size()) * pixelRatio).toSize(), QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(pixelRatio);
  image.fill(CurrentTheme().Canvas);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  if (this->Picture)
  {
    const std::atomic<bool> stop{ false };
    painter.drawImage(QPointF(),
      this->Picture->Paint(this->Transform, this->size(), pixelRatio, this->Coloring, stop));
  }
  this->PaintAbove(painter);
  return image;
}

void PlaneView::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.fillRect(this->rect(), CurrentTheme().Canvas);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!this->Image.isNull())
  {
    const double scale = this->Transform.Scale / this->ImageTransform.Scale;
    const QPointF corner =
      this->Transform.ToScreen(this->ImageTransform.ToPlane(QPointF(0.0, 0.0)));
    painter.save();
    painter.translate(corner);
    painter.scale(scale, scale);
    painter.drawImage(QPointF(), this->Image);
    painter.restore();
  }
  this->PaintAbove(painter);
}

void PlaneView::PaintAbove(QPainter&) {}

void PlaneView::resizeEvent(QResizeEvent*)
{
  if (this->IsHome)
  {
    this->Fit();
  }
  this->RequestImage();
}

void PlaneView::wheelEvent(QWheelEvent* event)
{
  const double factor = std::pow(1.0015, event->angleDelta().y());
  PlaneTransform transform = this->Transform;
  transform.Scale = std::clamp(transform.Scale * factor, 1e-6, 1e12);
  const double real = transform.Scale / this->Transform.Scale;
  transform.Origin = event->position() + (transform.Origin - event->position()) * real;
  this->SetTransform(transform);
  event->accept();
}

void PlaneView::mousePressEvent(QMouseEvent* event)
{
  if (event->button() == Qt::MiddleButton || event->button() == Qt::RightButton)
  {
    this->IsMoving = true;
    this->LastPosition = event->position();
    this->setCursor(Qt::ClosedHandCursor);
  }
}

void PlaneView::mouseMoveEvent(QMouseEvent* event)
{
  if (this->IsMoving)
  {
    PlaneTransform transform = this->Transform;
    transform.Origin += event->position() - this->LastPosition;
    this->LastPosition = event->position();
    this->SetTransform(transform);
  }
  emit this->PointerMoved(this->Transform.ToPlane(event->position()));
}

void PlaneView::mouseReleaseEvent(QMouseEvent*)
{
  if (this->IsMoving)
  {
    this->IsMoving = false;
    this->unsetCursor();
  }
}

void PlaneView::keyPressEvent(QKeyEvent* event)
{
  if (event->key() == Qt::Key_Home)
  {
    this->Fit();
    return;
  }
  QWidget::keyPressEvent(event);
}

} // namespace pemesh
