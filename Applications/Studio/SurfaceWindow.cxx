// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SurfaceWindow.h"

#include "Appearance.h"
#include "ColorMaps.h"
#include "LatestJob.h"
#include "RenderWidget.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QTimer>
#include <QToolBar>

#include <algorithm>
#include <cmath>

#include <vtkActor.h>
#include <vtkBoundingBox.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkLookupTable.h>
#include <vtkOutlineFilter.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

namespace pemesh
{

namespace
{

constexpr int ColorCount = 256;
constexpr std::size_t BlocksShownWhileMoving = 4; // more are an outline while they move

void SetColor(vtkRenderer* renderer, const QColor& color)
{
  renderer->SetBackground(color.redF(), color.greenF(), color.blueF());
}

void SetText(vtkTextProperty* property, int size)
{
  const QColor ink = CurrentTheme().Text;
  property->SetColor(ink.redF(), ink.greenF(), ink.blueF());
  property->SetFontFamilyToArial();
  property->SetFontSize(size);
  property->ItalicOff();
  property->ShadowOff();
}

} // namespace

SurfaceWindow::SurfaceWindow(QWidget* parent)
  : QWidget(parent, Qt::Window)
  , View(new RenderWidget(this))
  , Height(new QSlider(Qt::Horizontal, this))
  , Note(new QLabel(this))
  , Job(new LatestJob(this, 0))
  , UploadTimer(new QTimer(this))
{
  this->setWindowTitle(tr("Solution and ground truth"));
  this->resize(1100, 620);
  this->Height->setRange(0, 200);
  this->Height->setValue(50);
  this->Height->setFixedWidth(220);
  this->Height->setAccessibleName(tr("Height"));
  auto* line = new QHBoxLayout;
  line->setContentsMargins(12, 6, 12, 6);
  line->addWidget(new QLabel(tr("Height"), this));
  line->addWidget(this->Height);
  line->addWidget(this->Note, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(this->View, 1);
  layout->addLayout(line);
  this->Colors->SetNumberOfTableValues(ColorCount);
  for (int i = 0; i < ColorCount; ++i)
  {
    const ChartColor color = MapColor(*FindColorMap("viridis"), i / (ColorCount - 1.0));
    this->Colors->SetTableValue(i, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  }
  this->MakeSide(0.0, 0.44, "Solution");
  this->MakeSide(0.44, 0.88, "Ground truth");
  this->MakeLegend(0.88, 1.0);
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  this->View->GetInteractor()->SetInteractorStyle(style);
  vtkNew<vtkCallbackCommand> moved;
  moved->SetClientData(this);
  moved->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void*) {
      static_cast<SurfaceWindow*>(self)->ShowOutlines(event == vtkCommand::StartInteractionEvent);
    });
  style->AddObserver(vtkCommand::StartInteractionEvent, moved);
  style->AddObserver(vtkCommand::EndInteractionEvent, moved);
  this->UploadTimer->setInterval(0);
  connect(this->UploadTimer, &QTimer::timeout, this, &SurfaceWindow::UploadNext);
  connect(this->Height, &QSlider::valueChanged, this, &SurfaceWindow::ApplyHeight);
}

SurfaceWindow::~SurfaceWindow()
{
  delete this->Job;
}

void SurfaceWindow::MakeSide(double left, double right, const char* title)
{
  Side side;
  side.Renderer = vtkSmartPointer<vtkRenderer>::New();
  side.Renderer->SetViewport(left, 0.0, right, 1.0);
  side.Renderer->SetActiveCamera(this->Camera);
  SetColor(side.Renderer, CurrentTheme().Canvas);
  vtkNew<vtkTextActor> text;
  text->SetInput(title);
  text->SetPosition(16, 16);
  SetText(text->GetTextProperty(), 16);
  side.Renderer->AddViewProp(text);
  this->View->GetRenderWindow()->AddRenderer(side.Renderer);
  this->Sides.push_back(side);
}

/** The scale that both sides share, beside them so that it hides nothing. */
void SurfaceWindow::MakeLegend(double left, double right)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetViewport(left, 0.0, right, 1.0);
  renderer->InteractiveOff();
  SetColor(renderer, CurrentTheme().Canvas);
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(this->Colors);
  bar->SetNumberOfLabels(5);
  bar->UnconstrainedFontSizeOn();
  bar->SetPosition(0.1, 0.2);
  bar->SetPosition2(0.8, 0.6);
  bar->SetLabelFormat("%-.2g");
  SetText(bar->GetLabelTextProperty(), 12);
  renderer->AddViewProp(bar);
  this->View->GetRenderWindow()->AddRenderer(renderer);
}

void SurfaceWindow::SetMesh(const MeshPicturePointer& picture, const QString& run)
{
  if (!picture)
  {
    return;
  }
  const QRectF bounds = picture->GetBounds();
  this->Extent = std::max({ bounds.width(), bounds.height(), 1e-12 });
  this->Job->Start(
    [this, picture, run = run.toStdString()](const std::atomic<bool>& stop) -> LatestJob::Delivery
    {
      const SurfaceMesh solution = MakeSurface(*picture, run + "_Solution", stop);
      const SurfaceMesh truth = MakeSurface(*picture, run + "_GroundTruth", stop);
      return [this, solution, truth] { this->Show(solution, truth); };
    });
}

void SurfaceWindow::Show(const SurfaceMesh& solution, const SurfaceMesh& truth)
{
  const bool hadMesh = !this->Sides[0].Actors.empty();
  for (Side& side : this->Sides)
  {
    for (const auto& actor : side.Actors)
    {
      side.Renderer->RemoveActor(actor);
    }
    side.Actors.clear();
    side.Uploaded = 0;
  }
  this->Sides[0].Surface = solution;
  this->Sides[1].Surface = truth;
  const bool both = !truth.Blocks.empty();
  this->Range[0] = both ? std::min(solution.Range[0], truth.Range[0]) : solution.Range[0];
  this->Range[1] = both ? std::max(solution.Range[1], truth.Range[1]) : solution.Range[1];
  this->Colors->SetTableRange(this->Range);
  this->Note->setText(solution.Blocks.empty() ? tr("This mesh has no solution.")
      : both                                  ? QString()
                                              : tr("The solver gave no ground truth."));
  this->UploadTimer->start();
  if (!hadMesh && !solution.Blocks.empty())
  {
    this->ResetCamera();
  }
}

bool SurfaceWindow::IsComplete() const
{
  return !this->Job->IsBusy() && !this->UploadTimer->isActive();
}

/** One block a turn of the event loop: the window answers in between. */
void SurfaceWindow::UploadNext()
{
  for (Side& side : this->Sides)
  {
    if (side.Uploaded < side.Surface.Blocks.size())
    {
      this->AddBlock(side);
      this->ApplyHeight();
      return;
    }
  }
  this->UploadTimer->stop();
}

void SurfaceWindow::AddBlock(Side& side)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(side.Surface.Blocks[side.Uploaded++]);
  mapper->SetLookupTable(this->Colors);
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.35);
  actor->GetProperty()->SetDiffuse(0.7);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetEdgeVisibility(side.Surface.Blocks.size() < 2);
  actor->GetProperty()->SetEdgeColor(0.2, 0.24, 0.28);
  side.Renderer->AddActor(actor);
  side.Actors.push_back(actor);
}

void SurfaceWindow::ShowOutlines(bool moving)
{
  for (Side& side : this->Sides)
  {
    if (side.Actors.size() <= BlocksShownWhileMoving)
    {
      continue;
    }
    if (moving && !side.Outline)
    {
      double bounds[6];
      side.Renderer->ComputeVisiblePropBounds(bounds);
      vtkNew<vtkPolyData> box;
      vtkNew<vtkPoints> corners;
      corners->InsertNextPoint(bounds[0], bounds[2], bounds[4]);
      corners->InsertNextPoint(bounds[1], bounds[3], bounds[5]);
      box->SetPoints(corners);
      vtkNew<vtkOutlineFilter> outline;
      outline->SetInputData(box);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(outline->GetOutputPort());
      side.Outline = vtkSmartPointer<vtkActor>::New();
      side.Outline->SetMapper(mapper);
      side.Outline->GetProperty()->SetColor(0.12, 0.44, 0.7);
      side.Renderer->AddActor(side.Outline);
    }
    else if (!moving && side.Outline)
    {
      side.Renderer->RemoveActor(side.Outline);
      side.Outline = nullptr;
    }
    for (const auto& actor : side.Actors)
    {
      actor->SetVisibility(!moving);
    }
  }
  this->View->Render();
}

double SurfaceWindow::GetZScale() const
{
  const double span = std::max(this->Range[1] - this->Range[0], 1e-300);
  return std::max(this->Height->value() / 100.0 * this->Extent / span, 1e-12);
}

void SurfaceWindow::ApplyHeight()
{
  for (Side& side : this->Sides)
  {
    for (const auto& actor : side.Actors)
    {
      actor->SetScale(1.0, 1.0, this->GetZScale());
    }
    side.Renderer->ResetCameraClippingRange();
  }
  this->View->Render();
}

/** On all of the mesh, of which nothing needs to be there yet. */
void SurfaceWindow::ResetCamera()
{
  vtkBoundingBox box;
  for (const auto& block : this->Sides[0].Surface.Blocks)
  {
    box.AddBounds(block->GetBounds());
  }
  double bounds[6];
  box.GetBounds(bounds);
  bounds[4] *= this->GetZScale();
  bounds[5] *= this->GetZScale();
  this->Camera->SetFocalPoint(0.0, 0.0, 0.0);
  this->Camera->SetPosition(-0.6, -1.4, 1.1);
  this->Camera->SetViewUp(0.0, 0.0, 1.0);
  this->Sides[0].Renderer->ResetCamera(bounds);
  this->View->Render();
}

} // namespace pemesh
