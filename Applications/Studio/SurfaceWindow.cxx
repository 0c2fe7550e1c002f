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

#include <algorithm>
#include <cmath>
#include <utility>

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkLookupTable.h>
#include <vtkOutlineSource.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextProperty.h>

namespace pemesh
{

namespace
{

constexpr int ColorCount = 256;
constexpr std::size_t BlocksShownWhileMoving = 4; // more are an outline while they move
constexpr double TurnMilliseconds = 50.0;         // of painting between two turns of the event loop
constexpr int SideStretch = 44;                   // hundredths of the width
constexpr int LegendStretch = 12;

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
  , PaintTimer(new QTimer(this))
{
  this->setWindowTitle(tr("Solution and ground truth"));
  this->resize(1100, 620);
  this->View->setAccessibleName(tr("Solution and ground truth"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(this->MakeTitles());
  layout->addWidget(this->View, 1);
  layout->addLayout(this->MakeControls());
  this->Colors->SetNumberOfTableValues(ColorCount);
  for (int i = 0; i < ColorCount; ++i)
  {
    const ChartColor color = MapColor(*FindColorMap("viridis"), i / (ColorCount - 1.0));
    this->Colors->SetTableValue(i, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  }
  const double side = SideStretch / 100.0;
  this->MakeSide(0.0, side);
  this->MakeSide(side, 2.0 * side);
  this->MakeLegend(2.0 * side, 1.0);
  this->WatchMouse();
  this->PaintTimer->setSingleShot(true);
  this->PaintTimer->setInterval(0);
  connect(this->PaintTimer, &QTimer::timeout, this, &SurfaceWindow::PaintNext);
  connect(this->View, &QOpenGLWidget::resized, this, &SurfaceWindow::BeginFrame);
  connect(this->View, &RenderWidget::Rendered, this,
    [this]
    {
      if (this->IsPainting)
      {
        this->PaintTimer->start();
      }
    });
}

SurfaceWindow::~SurfaceWindow()
{
  delete this->Job;
}

QBoxLayout* SurfaceWindow::MakeTitles()
{
  auto* line = new QHBoxLayout;
  line->setContentsMargins(0, 8, 0, 4);
  for (const QString& title : { tr("Solution"), tr("Ground truth") })
  {
    auto* label = new QLabel(title, this);
    label->setObjectName(QStringLiteral("heading"));
    label->setAlignment(Qt::AlignCenter);
    line->addWidget(label, SideStretch);
  }
  line->addStretch(LegendStretch);
  return line;
}

QBoxLayout* SurfaceWindow::MakeControls()
{
  this->Height->setRange(0, 200);
  this->Height->setValue(50);
  this->Height->setFixedWidth(220);
  this->Height->setAccessibleName(tr("Height"));
  connect(this->Height, &QSlider::valueChanged, this, &SurfaceWindow::ApplyHeight);
  auto* line = new QHBoxLayout;
  line->setContentsMargins(12, 6, 12, 6);
  line->setSpacing(10);
  line->addWidget(new QLabel(tr("Height"), this));
  line->addWidget(this->Height);
  line->addWidget(this->Note, 1);
  return line;
}

void SurfaceWindow::MakeSide(double left, double right)
{
  Side side;
  side.Renderer = vtkSmartPointer<vtkRenderer>::New();
  side.Renderer->SetViewport(left, 0.0, right, 1.0);
  side.Renderer->SetActiveCamera(this->Camera);
  SetColor(side.Renderer, CurrentTheme().Canvas);
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

void SurfaceWindow::WatchMouse()
{
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  style->AutoAdjustCameraClippingRangeOff(); // it knows only the blocks of the last turn
  this->View->GetInteractor()->SetInteractorStyle(style);
  vtkNew<vtkCallbackCommand> moved;
  moved->SetClientData(this);
  moved->SetCallback(
    [](vtkObject*, unsigned long event, void* client, void*)
    {
      auto* self = static_cast<SurfaceWindow*>(client);
      self->IsMoving = event != vtkCommand::EndInteractionEvent;
      self->BeginFrame();
    });
  for (const unsigned long event : { vtkCommand::StartInteractionEvent,
         vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent })
  {
    style->AddObserver(event, moved);
  }
}

void SurfaceWindow::SetMesh(const MeshPicturePointer& picture, const QString& run)
{
  if (!picture)
  {
    return;
  }
  this->Job->Start(
    [this, picture, run = run.toStdString()](const std::atomic<bool>& stop) -> LatestJob::Delivery
    {
      const SurfaceMesh solution = MakeSurface(*picture, run + "_Solution", stop);
      const SurfaceMesh truth = MakeSurface(*picture, run + "_GroundTruth", stop);
      return [this, solution, truth, extent = picture->GetBounds()]
      {
        this->Extent = extent;
        this->Show(solution, truth);
      };
    });
}

void SurfaceWindow::Show(const SurfaceMesh& solution, const SurfaceMesh& truth)
{
  const bool hadMesh = !this->Sides[0].Actors.empty();
  const bool both = !truth.Blocks.empty();
  this->Range[0] = both ? std::min(solution.Range[0], truth.Range[0]) : solution.Range[0];
  this->Range[1] = both ? std::max(solution.Range[1], truth.Range[1]) : solution.Range[1];
  this->Colors->SetTableRange(this->Range);
  this->AddBlocks(this->Sides[0], solution);
  this->AddBlocks(this->Sides[1], truth);
  this->Note->setText(solution.Blocks.empty() ? tr("This mesh has no solution.")
      : both                                  ? QString()
                                              : tr("The solver gave no ground truth."));
  if (!hadMesh && !solution.Blocks.empty())
  {
    this->ResetCamera();
  }
  this->BlocksATurn = 1; // the first time they go to OpenGL as well
  this->ApplyHeight();
}

void SurfaceWindow::AddBlocks(Side& side, const SurfaceMesh& surface)
{
  for (const auto& actor : side.Actors)
  {
    side.Renderer->RemoveActor(actor);
  }
  side.Actors.clear();
  for (const auto& block : surface.Blocks)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(block);
    mapper->SetLookupTable(this->Colors);
    mapper->UseLookupTableScalarRangeOn();
    mapper->InterpolateScalarsBeforeMappingOn();
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetAmbient(0.35);
    actor->GetProperty()->SetDiffuse(0.7);
    actor->GetProperty()->SetInterpolationToFlat();
    actor->GetProperty()->SetEdgeVisibility(surface.Blocks.size() < 2);
    actor->GetProperty()->SetEdgeColor(0.2, 0.24, 0.28);
    side.Renderer->AddActor(actor);
    side.Actors.push_back(actor);
  }
}

std::size_t SurfaceWindow::GetNumberOfBlocks() const
{
  return std::max(this->Sides[0].Actors.size(), this->Sides[1].Actors.size());
}

bool SurfaceWindow::IsComplete() const
{
  return !this->Job->IsBusy() && !this->IsMoving && !this->IsPainting;
}

/** From an empty picture, or an outline. */
void SurfaceWindow::BeginFrame()
{
  this->FrameClock.start();
  this->TurnClock.invalidate();
  this->NextBlock = 0;
  this->IsPainting = true;
  double box[6];
  this->GetBox(box);
  for (Side& side : this->Sides)
  {
    side.Renderer->ResetCameraClippingRange(box);
    side.Renderer->SetPreserveColorBuffer(false);
    side.Renderer->SetPreserveDepthBuffer(false);
  }
  const bool isOutline = this->IsMoving && this->GetNumberOfBlocks() > BlocksShownWhileMoving;
  this->ShowOutlines(isOutline);
  if (isOutline)
  {
    this->IsPainting = false;
    this->PaintTimer->stop();
    this->ShowBlocks(0, 0);
    this->View->Render();
    return;
  }
  this->PaintTimer->start();
}

/** Some more blocks on top of those that are there; the window answers in between. */
void SurfaceWindow::PaintNext()
{
  const std::size_t count = this->GetNumberOfBlocks();
  if (this->TurnClock.isValid())
  {
    const double turn = std::max(1.0, static_cast<double>(this->TurnClock.nsecsElapsed()) / 1e6);
    const double wanted = static_cast<double>(this->BlocksATurn) * TurnMilliseconds / turn;
    this->BlocksATurn = static_cast<std::size_t>(
      std::clamp(wanted, 1.0, 2.0 * static_cast<double>(this->BlocksATurn)));
    for (Side& side : this->Sides)
    {
      side.Renderer->SetPreserveColorBuffer(true);
      side.Renderer->SetPreserveDepthBuffer(true);
    }
  }
  if (this->NextBlock >= count && this->TurnClock.isValid())
  {
    this->FrameTime = this->FrameClock.elapsed();
    this->IsPainting = false;
    return;
  }
  const std::size_t last = std::min(count, this->NextBlock + this->BlocksATurn);
  this->ShowBlocks(this->NextBlock, last);
  this->NextBlock = last;
  this->TurnClock.start();
  this->View->Render(); // which brings the next turn
}

/** Of both sides, from the first to before the last. */
void SurfaceWindow::ShowBlocks(std::size_t first, std::size_t last)
{
  for (Side& side : this->Sides)
  {
    for (std::size_t i = 0; i < side.Actors.size(); ++i)
    {
      side.Actors[i]->SetVisibility(i >= first && i < last);
    }
  }
}

void SurfaceWindow::ShowOutlines(bool moving)
{
  for (Side& side : this->Sides)
  {
    if (moving && !side.Outline && !side.Actors.empty())
    {
      double box[6];
      this->GetBox(box);
      vtkNew<vtkOutlineSource> outline;
      outline->SetBounds(box);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(outline->GetOutputPort());
      side.Outline = vtkSmartPointer<vtkActor>::New();
      side.Outline->SetMapper(mapper);
      side.Outline->GetProperty()->SetColor(0.12, 0.44, 0.7);
      side.Renderer->AddActor(side.Outline);
    }
    else if (!moving && side.Outline)
    {
      side.Renderer->RemoveActor(std::exchange(side.Outline, nullptr));
    }
  }
}

/** Of all of it as it is shown. */
void SurfaceWindow::GetBox(double bounds[6]) const
{
  const double values[6] = { this->Extent.left(), this->Extent.right(), this->Extent.top(),
    this->Extent.bottom(), this->GetZScale() * this->Range[0], this->GetZScale() * this->Range[1] };
  std::copy_n(values, 6, bounds);
}

double SurfaceWindow::GetZScale() const
{
  const double span = std::max(this->Range[1] - this->Range[0], 1e-300);
  const double extent = std::max({ this->Extent.width(), this->Extent.height(), 1e-12 });
  return std::max(this->Height->value() / 100.0 * extent / span, 1e-12);
}

void SurfaceWindow::ApplyHeight()
{
  for (Side& side : this->Sides)
  {
    for (const auto& actor : side.Actors)
    {
      actor->SetScale(1.0, 1.0, this->GetZScale());
    }
  }
  this->BeginFrame();
}

void SurfaceWindow::ResetCamera()
{
  double box[6];
  this->GetBox(box);
  this->Camera->SetFocalPoint(0.0, 0.0, 0.0);
  this->Camera->SetPosition(-0.6, -1.4, 1.1);
  this->Camera->SetViewUp(0.0, 0.0, 1.0);
  this->Sides[0].Renderer->ResetCamera(box);
}

} // namespace pemesh
