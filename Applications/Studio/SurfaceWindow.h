// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   SurfaceWindow
 * @brief   Solution and ground truth of a mesh as surfaces side by side: one camera, one scale.
 *
 * A window of its own, so that the others need no OpenGL. Large meshes are shown in blocks, one
 * uploaded in each turn of the event loop, and as an outline while they are moved.
 */
#ifndef pemesh_SurfaceWindow_h
#define pemesh_SurfaceWindow_h

#include "MeshPicture.h"
#include "SurfaceMesh.h"

#include <QWidget>

#include <vector>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

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
  /** Whether all of it is there. */
  bool IsComplete() const;
  RenderWidget* GetView() const { return this->View; }

private:
  struct Side
  {
    vtkSmartPointer<vtkRenderer> Renderer;
    vtkSmartPointer<vtkActor> Outline;
    std::vector<vtkSmartPointer<vtkActor>> Actors;
    SurfaceMesh Surface;
    std::size_t Uploaded = 0;
  };

  void MakeSide(double left, double right, const char* title);
  void MakeLegend(double left, double right);
  void Show(const SurfaceMesh& solution, const SurfaceMesh& truth);
  void UploadNext();
  void AddBlock(Side& side);
  void ShowOutlines(bool moving);
  void ApplyHeight();
  void ResetCamera();
  double GetZScale() const;

  RenderWidget* View;
  QSlider* Height;
  QLabel* Note;
  LatestJob* Job;
  QTimer* UploadTimer;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkLookupTable> Colors;
  std::vector<Side> Sides;
  double Extent = 1.0; // of the mesh in the plane
  double Range[2] = { 0.0, 1.0 };
};

} // namespace pemesh

#endif
