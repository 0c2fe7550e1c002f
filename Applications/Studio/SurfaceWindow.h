// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   SurfaceWindow
 * @brief   Solution and ground truth of a mesh as surfaces side by side: one camera, one scale.
 *
 * A window of its own, so that the others need no OpenGL. A mesh is drawn in blocks, some in each
 * turn of the event loop on top of those before, so that the window answers however large it is;
 * while it is moved a large one is an outline.
 */
#ifndef pemesh_SurfaceWindow_h
#define pemesh_SurfaceWindow_h

#include "MeshPicture.h"
#include "SurfaceMesh.h"

#include <QElapsedTimer>
#include <QWidget>

#include <vector>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class QBoxLayout;
class QLabel;
class QSlider;
class QTimer;
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

private:
  struct Side
  {
    vtkSmartPointer<vtkRenderer> Renderer;
    vtkSmartPointer<vtkActor> Outline;
    std::vector<vtkSmartPointer<vtkActor>> Actors;
  };

  QBoxLayout* MakeTitles();
  QBoxLayout* MakeControls();
  void MakeSide(double left, double right);
  void MakeLegend(double left, double right);
  void WatchMouse();
  void Show(const SurfaceMesh& solution, const SurfaceMesh& truth);
  void AddBlocks(Side& side, const SurfaceMesh& surface);
  void PaintNext();
  void ShowBlocks(std::size_t first, std::size_t last);
  void ShowOutlines(bool moving);
  void ApplyHeight();
  void ResetCamera();
  void GetBox(double bounds[6]) const;
  double GetZScale() const;
  std::size_t GetNumberOfBlocks() const;

  RenderWidget* View;
  QSlider* Height;
  QLabel* Note;
  LatestJob* Job;
  QTimer* PaintTimer;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkLookupTable> Colors;
  std::vector<Side> Sides;
  QRectF Extent{ 0.0, 0.0, 1.0, 1.0 }; // of the mesh in the plane
  double Range[2] = { 0.0, 1.0 };
  bool IsMoving = false;
  bool IsPainting = false;     // a picture that is not whole yet
  std::size_t NextBlock = 0;   // of the picture that is being painted
  std::size_t BlocksATurn = 1; // as many as take little time
  QElapsedTimer TurnClock;
  QElapsedTimer FrameClock;
  qint64 FrameTime = 0;
};

} // namespace pemesh

#endif
