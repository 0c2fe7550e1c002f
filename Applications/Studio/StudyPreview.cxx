// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyPreview.h"

#include "CaseStatus.h"
#include "LatestJob.h"
#include "SolverDescription.h"
#include "Study.h"
#include "StudyCases.h"
#include "StudyModel.h"
#include "StudyPipeline.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <vtkNew.h>
#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

/** What makes the mesh, without what is done with it. */
Study StudyOfMesh(const Study& study, bool measured)
{
  Study mesh = study;
  mesh.Solvers.clear();
  mesh.Plots.clear();
  if (!measured)
  {
    mesh.Metrics.Names.clear();
  }
  return mesh;
}

} // namespace

/** Keeps the pipeline from mesh to mesh of one study, so that only what changed is made again. */
struct StudyPreview::Maker
{
  std::optional<Study> Of;
  std::unique_ptr<StudyPipeline> Pipeline;

  /** A sentence where there is no mesh. */
  QString Make(const Study& study, const StudyCase& studyCase, const std::atomic<bool>& stop,
    MeshPicturePointer& picture)
  {
    try
    {
      if (!this->Pipeline || this->Of != study)
      {
        this->Pipeline = std::make_unique<StudyPipeline>(
          study, std::vector<SolverDescription>(), StudyPipeline::Options(), stop);
        this->Of = study;
      }
      this->Pipeline->Execute(studyCase);
      vtkPolyData* made = this->Pipeline->GetMesh();
      vtkNew<vtkPolyData> mesh;
      mesh->ShallowCopy(made);
      picture = std::make_shared<MeshPicture>(mesh);
      return IsCaseFailed(mesh) ? QString::fromStdString(GetCaseStatusMessage(mesh)) : QString();
    }
    catch (const std::exception& error)
    {
      this->Pipeline.reset();
      return QString::fromUtf8(error.what());
    }
  }
};

StudyPreview::StudyPreview(StudyModel* model, QObject* parent)
  : QObject(parent)
  , Model(model)
  , MeshMaker(std::make_shared<Maker>())
  , OutlineJob(new LatestJob(this))
  , MeshJob(new LatestJob(this))
{
  connect(model, &StudyModel::Changed, this, &StudyPreview::Refresh);
  connect(this->MeshJob, &LatestJob::BusyChanged, this, &StudyPreview::BusyChanged);
  this->Refresh();
}

StudyPreview::~StudyPreview()
{
  delete this->MeshJob; // before what it works with
  delete this->OutlineJob;
}

bool StudyPreview::IsBusy() const
{
  return this->MeshJob->IsBusy();
}

bool StudyPreview::IsContinuous() const
{
  const Study& study = this->Model->GetStudy();
  return !HasMeshFiles(study) && IsTriangulated(study.Mesh) &&
    std::all_of(study.Sweep.begin(), study.Sweep.end(),
      [](const StudySweep& sweep) { return sweep.Parameter == DeformationParameter; });
}

int StudyPreview::GetNumberOfCases() const
{
  return static_cast<int>(this->Cases.size());
}

StudyCase StudyPreview::CaseOfPlace() const
{
  if (this->IsContinuous())
  {
    const double t = std::clamp(this->Place, 0.0, 1.0);
    return { 0, "preview", t, { { DeformationParameter, DeformationParameter, t } } };
  }
  if (this->Cases.empty())
  {
    return { 0, "preview", 0.0, {} };
  }
  const auto last = static_cast<double>(this->Cases.size() - 1);
  return this->Cases[static_cast<std::size_t>(std::clamp(this->Place, 0.0, last))];
}

QString StudyPreview::GetPlaceName() const
{
  return this->IsContinuous() ? QStringLiteral("t = %1").arg(this->Place, 0, 'f', 3)
                              : QString::fromStdString(this->CaseOfPlace().Name);
}

void StudyPreview::SetMeasured(bool measured)
{
  if (this->Measured != measured)
  {
    this->Measured = measured;
    this->MakePicture();
  }
}

void StudyPreview::SetPlace(double place)
{
  if (this->Place != place)
  {
    this->Place = place;
    this->MakeOutlines();
    this->MakePicture();
    emit this->PlaceChanged();
  }
}

void StudyPreview::Refresh()
{
  this->Cases.clear();
  if (!this->IsContinuous())
  {
    try
    {
      this->Cases = MakeStudyCases(this->Model->GetStudy());
    }
    catch (const std::exception&) // the mesh will say the same
    {
    }
    this->Place = std::clamp(
      std::floor(this->Place), 0.0, std::max(0.0, static_cast<double>(this->Cases.size()) - 1.0));
  }
  else
  {
    this->Place = std::clamp(this->Place, 0.0, 1.0);
  }
  emit this->PlaceChanged();
  this->MakeOutlines();
  this->MakePicture();
}

void StudyPreview::MakeOutlines()
{
  this->OutlineJob->Start(
    [this, study = this->Model->GetStudy(), studyCase = this->CaseOfPlace()](
      const std::atomic<bool>&) -> LatestJob::Delivery
    {
      StudyOutlines outlines;
      try
      {
        outlines = MakeStudyOutlines(MakeStudyOfCase(study, studyCase.Values), studyCase.Time);
      }
      catch (const std::exception& error)
      {
        outlines.Fault = error.what();
      }
      return [this, outlines]
      {
        this->Outlines = outlines;
        emit this->OutlinesChanged();
      };
    });
}

void StudyPreview::MakePicture()
{
  this->MeshJob->Start(
    [this, maker = this->MeshMaker, study = StudyOfMesh(this->Model->GetStudy(), this->Measured),
      studyCase = this->CaseOfPlace()](const std::atomic<bool>& stop) -> LatestJob::Delivery
    {
      MeshPicturePointer picture;
      const QString fault = maker->Make(study, studyCase, stop, picture);
      return [this, picture, fault] { this->SetPicture(picture, fault); };
    });
}

void StudyPreview::SetPicture(const MeshPicturePointer& picture, const QString& fault)
{
  this->Picture = picture;
  this->Fault = fault;
  emit this->PictureChanged();
}

} // namespace pemesh
