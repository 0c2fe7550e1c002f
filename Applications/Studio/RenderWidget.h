// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   RenderWidget
 * @brief   A VTK render window in a Qt widget.
 *
 * Debian's VTK is built with Qt 5, so its own widget cannot be used with Qt 6. VTK draws into a
 * framebuffer of its own in the context of the widget, and the picture is copied into that of the
 * widget. Mouse and wheel go to the interactor, whose timers are served. Where the machine has no
 * OpenGL 3.2, isValid() is false after the widget was shown.
 */
#ifndef pemesh_RenderWidget_h
#define pemesh_RenderWidget_h

#include <QOpenGLWidget>

#include <map>

#include <vtkNew.h>

class QTimer;
class vtkCallbackCommand;
class vtkGenericOpenGLRenderWindow;
class vtkGenericRenderWindowInteractor;
class vtkObject;

namespace pemesh
{

class RenderWidget : public QOpenGLWidget
{
  Q_OBJECT
public:
  explicit RenderWidget(QWidget* parent = nullptr);
  ~RenderWidget() override;

  vtkGenericOpenGLRenderWindow* GetRenderWindow() const;
  vtkGenericRenderWindowInteractor* GetInteractor() const;
  /** Renders at the next paint. */
  void Render();

signals:
  /** VTK has rendered, and it is on its way to the screen. */
  void Rendered();

protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;
  bool event(QEvent* event) override;

private:
  static void Handle(vtkObject* caller, unsigned long event, void* self, void* data);
  void MakeCurrent();
  void StartTimer(int id);
  void CleanUp();
  void SendMouse(QEvent* event);

  vtkNew<vtkGenericOpenGLRenderWindow> Window;
  vtkNew<vtkGenericRenderWindowInteractor> Interactor;
  vtkNew<vtkCallbackCommand> Observer;
  std::map<int, QTimer*> Timers;
  bool IsReady = false;
  bool IsPainting = false;
  bool NeedsRender = true;
};

} // namespace pemesh

#endif
