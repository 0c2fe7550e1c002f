// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   SurfaceWindow
 * @brief   Solution and ground truth of a mesh as surfaces side by side: one camera, one scale.
 *
 * A window of its own, so that the others need no OpenGL. VTK draws what it can draw at once; a
 * large surface is an outline while it is moved, and its picture, of all its triangles, is painted
 * in a worker and laid above: the window answers however large it is.
 */
#ifndef pemesh_SurfaceWindow_h
#define pemesh_SurfaceWindow_h

#include "MeshPicture.h"
#include "SurfaceMesh.h"
#include "SurfacePicture.h"

#include <QElapsedTimer>
#include <QWidget>

#include <memory>
#include <vector>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class QBoxLayout;
class QLabel;
class QSlider;
class vtkActor;
class vtkCamera;
class vtkLookupTable;
class vtkRenderer;

namespace pemesh
{

class LatestJob;
class RenderWidget;

class SurfaceWindow : public QWidget
{
  Q_OBJECT
public:
  explicit SurfaceWindow(QWidget* parent = nullptr);
  ~SurfaceWindow() override;

  /** The arrays <run>_Solution and <run>_GroundTruth of a mesh. */
  void SetMesh(const MeshPicturePointer& picture, const QString& run);
  /** Whether all of it is there to be seen. */
  bool IsComplete() const;
  /** How long the last whole picture took, in milliseconds. */
  qint64 GetFrameTime() const { return this->FrameTime; }
  RenderWidget* GetView() const { return this->View; }
  /** Paints all of it anew. */
  void BeginFrame();
  /** With what is laid above. */
  QImage GrabView() const;

private:
  struct Side
  {
    vtkSmartPointer<vtkRenderer> Renderer;
    vtkSmartPointer<vtkActor> Outline;
    vtkSmartPointer<vtkActor> Surface;
  };

  QBoxLayout* MakeTitles();
  QBoxLayout* MakeControls();
  void MakeSide(double left, double right);
  void MakeLegend(double left, double right);
  void WatchMouse();
  void Show(const std::shared_ptr<const SurfacePair>& shown, const QRectF& extent);
  void ShowData(Side& side, vtkPolyData* surface);
  void ShowOutlines(bool visible);
  void PaintStill();
  void ShowStill(const QImage& still);
  SurfaceView MakeView(int side) const;
  bool IsLarge() const;
  void ApplyHeight();
  void ResetCamera();
  void GetBox(double bounds[6]) const;
  double GetZScale() const;

  RenderWidget* View;
  QLabel* Still; // laid above the view
  QSlider* Height;
  QLabel* Note;
  LatestJob* MeshJob;
  LatestJob* PaintJob;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkLookupTable> Colors;
  std::vector<Side> Sides;
  std::shared_ptr<const SurfacePair> Shown;
  QRectF Extent{ 0.0, 0.0, 1.0, 1.0 }; // of the mesh in the plane
  double Range[2] = { 0.0, 1.0 };
  bool IsMoving = false;
  bool IsPainting = false; // a picture that is not there yet
  QElapsedTimer FrameClock;
  qint64 FrameTime = 0;
};

} // namespace pemesh

#endif
