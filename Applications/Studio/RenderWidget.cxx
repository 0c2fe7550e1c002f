// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RenderWidget.h"

#include <QMouseEvent>
#include <QOpenGLContext>
#include <QTimer>
#include <QWheelEvent>

#include <utility>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkOpenGLState.h>

namespace pemesh
{

namespace
{
constexpr double PointsPerInch = 72.0;
}

RenderWidget::RenderWidget(QWidget* parent)
  : QOpenGLWidget(parent)
{
  QSurfaceFormat format;
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  this->setFormat(format);
  this->setFocusPolicy(Qt::StrongFocus);
  this->setMouseTracking(true);
  this->Window->SetReadyForRendering(false);
  this->Window->SetOwnContext(0);
  this->Window->SetFrameBlitModeToNoBlit();
  this->Window->SetMultiSamples(0); // software OpenGL has no time for more
  this->Interactor->SetRenderWindow(this->Window);
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(&RenderWidget::Handle);
  for (const unsigned long event : { vtkCommand::WindowMakeCurrentEvent,
         vtkCommand::WindowIsCurrentEvent, vtkCommand::WindowFrameEvent })
  {
    this->Window->AddObserver(event, this->Observer);
  }
  this->Interactor->AddObserver(vtkCommand::CreateTimerEvent, this->Observer);
  this->Interactor->AddObserver(vtkCommand::DestroyTimerEvent, this->Observer);
  this->Interactor->AddObserver(vtkCommand::RenderEvent, this->Observer);
  this->Interactor->EnableRenderOff(); // it asks, and the widget renders when it paints
  this->Interactor->Initialize();
}

RenderWidget::~RenderWidget()
{
  this->makeCurrent();
  this->CleanUp();
  this->Window->RemoveObserver(this->Observer);
  this->Interactor->RemoveObserver(this->Observer);
  this->doneCurrent();
}

vtkGenericOpenGLRenderWindow* RenderWidget::GetRenderWindow() const
{
  return this->Window;
}

vtkGenericRenderWindowInteractor* RenderWidget::GetInteractor() const
{
  return this->Interactor;
}

void RenderWidget::Render()
{
  this->NeedsRender = true;
  this->update();
}

/** Once for a context: before it is destroyed, or with the widget. */
void RenderWidget::CleanUp()
{
  if (this->IsReady)
  {
    this->IsReady = false;
    this->Window->Finalize();
    this->Window->SetReadyForRendering(false);
  }
}

void RenderWidget::initializeGL()
{
  connect(this->context(), &QOpenGLContext::aboutToBeDestroyed, this,
    [this]
    {
      this->makeCurrent();
      this->CleanUp();
      this->doneCurrent();
    });
  this->Window->SetReadyForRendering(true);
  this->Window->SetSupportsOpenGL(1);
  this->Window->SetIsDirect(1);
  this->Window->SetIsCurrent(true);
  this->Window->SetMapped(1);
  this->Window->InitializeFromCurrentContext();
  this->Window->GetState()->Reset();
  this->Window->GetState()->vtkglDepthFunc(GL_LEQUAL);
  this->IsReady = true;
  this->NeedsRender = true;
}

void RenderWidget::resizeGL(int width, int height)
{
  const double ratio = this->devicePixelRatioF();
  const int w = static_cast<int>(width * ratio);
  const int h = static_cast<int>(height * ratio);
  this->Window->SetSize(w, h);
  this->Window->SetDPI(static_cast<int>(PointsPerInch * ratio));
  this->Interactor->SetSize(w, h);
  this->NeedsRender = true;
}

void RenderWidget::paintGL()
{
  if (!this->IsReady)
  {
    return;
  }
  this->IsPainting = true;
  vtkOpenGLState* state = this->Window->GetState();
  state->Reset();
  state->Push();
  const bool renders = std::exchange(this->NeedsRender, false);
  if (renders)
  {
    this->Window->Render();
  }
  this->MakeCurrent(); // whoever was told of the rendering may have taken another context
  const int* size = this->Window->GetSize();
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->defaultFramebufferObject());
  state->vtkglDrawBuffer(GL_COLOR_ATTACHMENT0);
  state->vtkglDisable(GL_SCISSOR_TEST);
  this->Window->BlitDisplayFramebuffer(
    0, 0, 0, size[0], size[1], 0, 0, size[0], size[1], GL_COLOR_BUFFER_BIT, GL_NEAREST);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE); // nothing shines through
  state->vtkglClearColor(0.0, 0.0, 0.0, 1.0);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->Pop();
  this->IsPainting = false;
  if (renders)
  {
    emit this->Rendered();
  }
}

/** The context, but not the framebuffer of the widget, in the middle of whose drawing VTK may be.
 */
void RenderWidget::MakeCurrent()
{
  if (QOpenGLContext* own = this->context())
  {
    own->makeCurrent(own->surface());
  }
}

void RenderWidget::StartTimer(int id)
{
  auto* timer = new QTimer(this);
  timer->setSingleShot(this->Interactor->IsOneShotTimer(id) != 0);
  connect(timer, &QTimer::timeout, this,
    [this, id]
    {
      int now = id;
      this->Interactor->InvokeEvent(vtkCommand::TimerEvent, &now);
    });
  this->Timers[id] = timer;
  timer->start(static_cast<int>(this->Interactor->GetTimerDuration(id)));
}

void RenderWidget::Handle(vtkObject*, unsigned long event, void* client, void* data)
{
  auto* self = static_cast<RenderWidget*>(client);
  switch (event)
  {
    case vtkCommand::WindowMakeCurrentEvent:
      self->MakeCurrent();
      break;
    case vtkCommand::WindowIsCurrentEvent:
      *static_cast<bool*>(data) = QOpenGLContext::currentContext() == self->context();
      break;
    case vtkCommand::CreateTimerEvent:
      self->StartTimer(*static_cast<int*>(data));
      break;
    case vtkCommand::DestroyTimerEvent:
      delete self->Timers[*static_cast<int*>(data)];
      self->Timers.erase(*static_cast<int*>(data));
      break;
    default: // a frame is wanted
      if (!self->IsPainting)
      {
        self->Render();
      }
  }
}

void RenderWidget::SendMouse(QEvent* event)
{
  const auto* mouse = static_cast<QSinglePointEvent*>(event);
  const double ratio = this->devicePixelRatioF();
  const QPointF at = mouse->position() * ratio;
  const bool isDouble = event->type() == QEvent::MouseButtonDblClick;
  this->Interactor->SetEventInformationFlipY(static_cast<int>(at.x()), static_cast<int>(at.y()),
    mouse->modifiers() & Qt::ControlModifier ? 1 : 0,
    mouse->modifiers() & Qt::ShiftModifier ? 1 : 0, 0, isDouble ? 1 : 0);
  const bool isPress = isDouble || event->type() == QEvent::MouseButtonPress;
  unsigned long sent = vtkCommand::MouseMoveEvent;
  if (isPress || event->type() == QEvent::MouseButtonRelease)
  {
    const Qt::MouseButton button = mouse->button();
    sent = button == Qt::LeftButton
      ? (isPress ? vtkCommand::LeftButtonPressEvent : vtkCommand::LeftButtonReleaseEvent)
      : button == Qt::RightButton
      ? (isPress ? vtkCommand::RightButtonPressEvent : vtkCommand::RightButtonReleaseEvent)
      : (isPress ? vtkCommand::MiddleButtonPressEvent : vtkCommand::MiddleButtonReleaseEvent);
  }
  else if (event->type() == QEvent::Wheel)
  {
    sent = static_cast<QWheelEvent*>(event)->angleDelta().y() > 0
      ? vtkCommand::MouseWheelForwardEvent
      : vtkCommand::MouseWheelBackwardEvent;
  }
  this->Interactor->InvokeEvent(sent);
  event->accept();
}

bool RenderWidget::event(QEvent* event)
{
  switch (event->type())
  {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::Wheel:
      this->SendMouse(event);
      return true;
    default:
      return QOpenGLWidget::event(event);
  }
}

} // namespace pemesh
