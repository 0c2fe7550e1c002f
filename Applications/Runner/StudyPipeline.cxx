// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyPipeline.h"

#include "CaseStatus.h"
#include "ErrorText.h"
#include "MetricSettings.h"
#include "SolverDescription.h"
#include "SolverDescriptionFile.h"
#include "Study.h"
#include "StudyCases.h"
#include "StudyGeneration.h"
#include "StudyTargetSearch.h"
#include "vtkPEMCaseLabel.h"
#include "vtkPEMExternalSolver.h"
#include "vtkPEMMetricSummary.h"
#include "vtkPEMMetrics.h"

#include <cmath>
#include <optional>
#include <stdexcept>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>

namespace pemesh
{

namespace
{

void ConfigureSolver(
  vtkPEMExternalSolver* solver, const StudySolver& run, SolverDescription description)
{
  for (const SolverLimit& limit : SolverLimits())
  {
    description.*limit.OfDescription =
      (run.*limit.OfRun).value_or(description.*limit.OfDescription);
  }
  solver->SetDescription(description);
  for (const auto& [name, value] : run.Options)
  {
    solver->SetOption(name, FormatScalar(value));
  }
}

} // namespace

class StudyPipeline::Internals
{
public:
  explicit Internals(const std::atomic<bool>& stop)
    : Stop(stop)
  {
    this->ErrorObserver->SetClientData(this);
    this->ErrorObserver->SetCallback([](vtkObject*, unsigned long, void* self, void* text)
      { static_cast<Internals*>(self)->KeepError(static_cast<const char*>(text)); });
    this->StopObserver->SetClientData(this);
    this->StopObserver->SetCallback(
      [](vtkObject* filter, unsigned long, void* self, void*)
      {
        if (static_cast<Internals*>(self)->Stop)
        {
          static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1);
        }
      });
  }

  void Observe(vtkAlgorithm* filter)
  {
    filter->AddObserver(vtkCommand::ErrorEvent, this->ErrorObserver);
    // The executive repeats in many lines that the filter failed: kept out of the output.
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->ErrorObserver);
    filter->AddObserver(vtkCommand::ProgressEvent, this->StopObserver);
  }

  /** Puts a filter behind the last one. */
  void Append(vtkAlgorithm* filter)
  {
    this->Observe(filter);
    if (this->Last)
    {
      filter->SetInputConnection(this->Last->GetOutputPort());
    }
    this->First = this->First ? this->First : filter;
    this->Last = filter;
  }

  /** Sets what a case says; what it leaves as it was stays up to date. */
  void Configure(const Study& study)
  {
    this->Target = study.Mesh.Target;
    this->First->SetInputConnection(this->Generation.Configure(study)->GetOutputPort());
    for (std::size_t i = 0; i < this->Solvers.size(); ++i)
    {
      ConfigureSolver(this->Solvers[i], study.Solvers[i], this->Descriptions[i]);
    }
  }

  /**
   * The mesh of the last filter of the generation with that bound on the area; null if there is
   * none, or no need for one any more.
   */
  vtkPolyData* MakeMeshWithin(double bound, double time)
  {
    this->Generation.SetMaximumArea(bound);
    vtkAlgorithm* last = this->First->GetInputAlgorithm();
    last->UpdateTimeStep(time);
    this->ThrowError();
    auto* mesh = vtkPolyData::SafeDownCast(last->GetOutputDataObject(0));
    return this->Stop || IsCaseFailed(mesh) ? nullptr : mesh;
  }

  /** What keeps the case from having a mesh, as far as the filters cannot know. */
  void PrepareMesh(double time)
  {
    const std::string& fault = this->Generation.GetLayoutFault();
    std::string miss;
    if (fault.empty() && this->Target.Quantity != "none")
    {
      miss = SearchTarget(this->Target, this->Generation.GetDomainArea(),
        [this, time](double bound) { return this->MakeMeshWithin(bound, time); });
    }
    const char* status = !fault.empty() ? "invalid-layout" : "target-not-reached";
    const std::string& message = fault.empty() ? miss : fault;
    this->Label->SetFailure(message.empty() ? "" : status, message);
  }

  void ThrowError() const
  {
    if (!this->Error.empty())
    {
      throw std::runtime_error(this->Error);
    }
  }

  void KeepError(const char* text)
  {
    if (this->Error.empty()) // the first one is the cause
    {
      this->Error = SentenceOfError(text);
    }
  }

  const std::atomic<bool>& Stop;
  std::string Error;
  vtkNew<vtkCallbackCommand> ErrorObserver;
  vtkNew<vtkCallbackCommand> StopObserver;
  Study BaseStudy;
  std::optional<std::vector<SweptValue>> Configured; // the case that the pipeline is set to
  StudyTarget Target;
  StudyGeneration Generation;
  vtkNew<vtkPEMCaseLabel> Label;
  vtkNew<vtkPEMMetrics> Metrics;
  std::vector<SolverDescription> Descriptions;
  std::vector<vtkSmartPointer<vtkPEMExternalSolver>> Solvers;
  vtkNew<vtkPEMMetricSummary> Summary;
  vtkAlgorithm* First = nullptr; // behind the generation
  vtkAlgorithm* Last = nullptr;
};

StudyPipeline::StudyPipeline(const Study& study, const std::vector<SolverDescription>& solvers,
  const Options& options, const std::atomic<bool>& stop)
  : Implementation(std::make_unique<Internals>(stop))
{
  Internals& pipeline = *this->Implementation;
  pipeline.BaseStudy = study;
  pipeline.Descriptions = solvers;
  for (vtkAlgorithm* filter : pipeline.Generation.GetFilters())
  {
    pipeline.Observe(filter);
  }
  if (!study.Metrics.Names.empty())
  {
    pipeline.Append(pipeline.Metrics);
  }
  pipeline.Append(pipeline.Label); // behind the metrics: a new label does not measure again
  ConfigureMetrics(study.Metrics, pipeline.Metrics, pipeline.Summary);
  for (std::size_t i = 0; i < study.Solvers.size(); ++i)
  {
    auto solver = vtkSmartPointer<vtkPEMExternalSolver>::New();
    solver->SetRunName(study.Solvers[i].Name);
    solver->SetThreads(options.Threads);
    solver->SetVersion(study.Solvers[i].Version);
    solver->SetReuseAnswers(options.ReusesAnswers);
    solver->SetRetries(options.Retries);
    solver->SetMemoryBudget(options.Budget);
    solver->SetQueue(options.Queue);
    solver->SetWorkDirectory((options.SolverFolder / study.Solvers[i].Name).string());
    pipeline.Append(solver);
    pipeline.Solvers.push_back(solver);
  }
  pipeline.Append(pipeline.Summary);
}

StudyPipeline::~StudyPipeline() = default;

void StudyPipeline::Execute(const StudyCase& studyCase)
{
  Internals& pipeline = *this->Implementation;
  pipeline.Error.clear();
  if (pipeline.Configured != studyCase.Values)
  {
    pipeline.Configure(MakeStudyOfCase(pipeline.BaseStudy, studyCase.Values));
    pipeline.ThrowError();
    pipeline.Configured = studyCase.Values;
  }
  pipeline.Label->SetMeshName(studyCase.Name);
  for (const SweptValue& swept : studyCase.Values)
  {
    const double number = ScalarToNumber(swept.Value);
    std::isnan(number) ? pipeline.Label->SetTextParameter(swept.Name, FormatScalar(swept.Value))
                       : pipeline.Label->SetParameter(swept.Name, number);
  }
  pipeline.PrepareMesh(studyCase.Time);
  vtkAlgorithm* last = pipeline.Summary;
  last->UpdateInformation();
  vtkStreamingDemandDrivenPipeline::SafeDownCast(last->GetExecutive())
    ->GetOutputInformation(0)
    ->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), studyCase.Time);
  const bool done = last->GetExecutive()->Update() != 0;
  pipeline.ThrowError();
  if (!done)
  {
    throw std::runtime_error("The pipeline failed without saying why.");
  }
}

vtkPolyData* StudyPipeline::GetMesh()
{
  return vtkPolyData::SafeDownCast(this->Implementation->Summary->GetInputDataObject(0, 0));
}

vtkTable* StudyPipeline::GetRow()
{
  return this->Implementation->Summary->GetOutput();
}

} // namespace pemesh
