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

#include <algorithm>
#include <array>
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
#include <vtkMatrix4x4.h>
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
constexpr std::size_t MostDrawnAtOnce = 40000; // triangles, that OpenGL in software has time for
constexpr int SideStretch = 44;                // hundredths of the width
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
  , Still(new QLabel(this->View))
  , Height(new QSlider(Qt::Horizontal, this))
  , Note(new QLabel(this))
  , MeshJob(new LatestJob(this, 0))
  , PaintJob(new LatestJob(this, 0))
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
  this->Still->setAttribute(Qt::WA_TransparentForMouseEvents);
  this->Still->hide();
  connect(this->View, &QOpenGLWidget::resized, this,
    [this]
    {
      this->Still->hide(); // of another size
      this->BeginFrame();
    });
  connect(this->View, &RenderWidget::Rendered, this,
    [this]
    {
      if (!this->IsLarge())
      {
        this->IsPainting = false;
        this->FrameTime = this->FrameClock.elapsed();
      }
    });
}

SurfaceWindow::~SurfaceWindow()
{
  delete this->MeshJob;
  delete this->PaintJob;
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
  style->AutoAdjustCameraClippingRangeOff(); // it knows only what VTK draws
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
  this->MeshJob->Start(
    [this, picture, run = run.toStdString()](const std::atomic<bool>& stop) -> LatestJob::Delivery
    {
      const auto made =
        std::make_shared<const SurfacePair>(MakeSurfacePair(*picture, run, MostDrawnAtOnce, stop));
      return [this, made, extent = picture->GetBounds()] { this->Show(made, extent); };
    });
}

void SurfaceWindow::Show(const std::shared_ptr<const SurfacePair>& shown, const QRectF& extent)
{
  const bool hadMesh = this->Shown != nullptr;
  this->Shown = shown;
  this->Extent = extent;
  const SurfaceField& solution = shown->Fields[0];
  const SurfaceField& truth = shown->Fields[1];
  const bool both = !truth.Values.empty();
  this->Range[0] = both ? std::min(solution.Range[0], truth.Range[0]) : solution.Range[0];
  this->Range[1] = both ? std::max(solution.Range[1], truth.Range[1]) : solution.Range[1];
  this->Colors->SetTableRange(this->Range);
  this->ShowData(this->Sides[0], shown->Data[0]);
  this->ShowData(this->Sides[1], shown->Data[1]);
  this->Note->setText(solution.Values.empty() ? tr("This mesh has no solution.")
      : !both                                 ? tr("The solver gave no ground truth.")
      : this->IsLarge()                       ? tr("A large mesh: an outline while it moves.")
                                              : QString());
  this->Still->hide();
  if (!hadMesh && !solution.Values.empty())
  {
    this->ResetCamera();
  }
  this->ApplyHeight();
}

void SurfaceWindow::ShowData(Side& side, vtkPolyData* surface)
{
  if (side.Surface)
  {
    side.Renderer->RemoveActor(std::exchange(side.Surface, nullptr));
  }
  if (!surface)
  {
    return;
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->SetLookupTable(this->Colors);
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
  side.Surface = vtkSmartPointer<vtkActor>::New();
  side.Surface->SetMapper(mapper);
  side.Surface->GetProperty()->SetAmbient(0.35);
  side.Surface->GetProperty()->SetDiffuse(0.7);
  side.Surface->GetProperty()->SetInterpolationToFlat();
  side.Surface->GetProperty()->EdgeVisibilityOn();
  side.Surface->GetProperty()->SetEdgeColor(0.2, 0.24, 0.28);
  side.Renderer->AddActor(side.Surface);
}

bool SurfaceWindow::IsLarge() const
{
  return this->Shown && this->Shown->Shape.Triangles.size() > MostDrawnAtOnce;
}

bool SurfaceWindow::IsComplete() const
{
  return !this->MeshJob->IsBusy() && !this->IsMoving && !this->IsPainting;
}

void SurfaceWindow::BeginFrame()
{
  this->FrameClock.start();
  double box[6];
  this->GetBox(box);
  for (Side& side : this->Sides)
  {
    side.Renderer->ResetCameraClippingRange(box);
  }
  this->IsPainting = !this->IsMoving;
  if (this->IsLarge() && this->IsMoving)
  {
    this->PaintJob->Cancel();
    this->Still->hide();
    this->ShowOutlines(true);
  }
  else if (this->IsLarge())
  {
    this->PaintStill();
  }
  this->View->Render();
}

void SurfaceWindow::PaintStill()
{
  const std::array views = { this->MakeView(0), this->MakeView(1) };
  this->PaintJob->Start(
    [this, shown = this->Shown, views](const std::atomic<bool>& stop) -> LatestJob::Delivery
    {
      const QImage still = PaintSurfacePair(*shown, views, stop);
      return [this, still] { this->ShowStill(still); };
    });
}

void SurfaceWindow::ShowStill(const QImage& still)
{
  QPixmap pixmap = QPixmap::fromImage(still);
  pixmap.setDevicePixelRatio(this->View->devicePixelRatioF());
  this->Still->setPixmap(pixmap);
  this->Still->adjustSize();
  this->Still->show();
  this->ShowOutlines(false);
  this->View->Render();
  this->IsPainting = false;
  this->FrameTime = this->FrameClock.elapsed();
}

QImage SurfaceWindow::GrabView() const
{
  return this->View->grab().toImage();
}

SurfaceView SurfaceWindow::MakeView(int side) const
{
  SurfaceView view;
  const int* size = this->View->GetRenderWindow()->GetSize();
  view.Left = size[0] * side * SideStretch / 100;
  view.Size = QSize(size[0] * (side + 1) * SideStretch / 100 - view.Left, size[1]);
  const double aspect = static_cast<double>(view.Size.width()) / std::max(1, view.Size.height());
  vtkMatrix4x4* matrix = this->Camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  std::copy_n(matrix->GetData(), view.Matrix.size(), view.Matrix.begin());
  const double* direction = this->Camera->GetDirectionOfProjection();
  std::transform(direction, direction + 3, view.Light.begin(), [](double value) { return -value; });
  view.ZScale = this->GetZScale();
  std::copy_n(this->Range, 2, view.Range);
  for (int i = 0; i < ColorCount; ++i)
  {
    double color[4];
    this->Colors->GetTableValue(i, color);
    view.Colors.push_back(QColor::fromRgbF(
      static_cast<float>(color[0]), static_cast<float>(color[1]), static_cast<float>(color[2]))
                            .rgb());
  }
  return view;
}

void SurfaceWindow::ShowOutlines(bool visible)
{
  for (std::size_t i = 0; i < this->Sides.size(); ++i)
  {
    Side& side = this->Sides[i];
    if (visible && !side.Outline && !this->Shown->Fields[i].Values.empty())
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
    else if (!visible && side.Outline)
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
    if (side.Surface)
    {
      side.Surface->SetScale(1.0, 1.0, this->GetZScale());
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
