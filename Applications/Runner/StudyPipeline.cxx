// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyPipeline.h"

#include "ErrorText.h"
#include "SolverDescription.h"
#include "Study.h"
#include "StudyCases.h"
#include "StudyLayout.h"
#include "vtkPEMCaseLabel.h"
#include "vtkPEMDomainMesher.h"
#include "vtkPEMExternalSolver.h"
#include "vtkPEMMeshReader.h"
#include "vtkPEMMetricSummary.h"
#include "vtkPEMMetrics.h"
#include "vtkPEMPolygonLayout.h"

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

vtkSmartPointer<vtkAlgorithm> MakeLayout(const Study& study)
{
  auto layout = vtkSmartPointer<vtkPEMPolygonLayout>::New();
  ConfigureLayout(study, layout);
  auto mesher = vtkSmartPointer<vtkPEMDomainMesher>::New();
  mesher->SetInputConnection(layout->GetOutputPort());
  mesher->SetAreaRuleByName(study.Mesh.MaximumArea.Rule);
  if (mesher->GetAreaRule() == vtkPEMDomainMesher::AREA_CONSTANT)
  {
    mesher->SetMaximumArea(study.Mesh.MaximumArea.Value);
  }
  mesher->SetMinimumAngle(study.Mesh.MinimumAngle);
  mesher->SetPreservePolygons(study.Mesh.PreservePolygons);
  return mesher;
}

vtkSmartPointer<vtkAlgorithm> MakeReader(const Study& study)
{
  auto reader = vtkSmartPointer<vtkPEMMeshReader>::New();
  for (const std::filesystem::path& path : FindStudyMeshes(study))
  {
    reader->AddFileName(path.string());
  }
  return reader;
}

vtkSmartPointer<vtkAlgorithm> MakeSolver(const StudySolver& run,
  const SolverDescription& description, const StudyPipeline::Options& options)
{
  auto solver = vtkSmartPointer<vtkPEMExternalSolver>::New();
  solver->SetDescription(description);
  solver->SetRunName(run.Name);
  solver->SetThreads(options.Threads);
  solver->SetWorkDirectory((options.SolverFolder / run.Name).string());
  for (const auto& [name, value] : run.Options)
  {
    solver->SetOption(name, FormatScalar(value));
  }
  if (run.TimeLimit)
  {
    solver->SetTimeLimit(*run.TimeLimit);
  }
  return solver;
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

  /** Puts a filter at the end of the pipeline. */
  void Append(vtkAlgorithm* filter)
  {
    filter->AddObserver(vtkCommand::ErrorEvent, this->ErrorObserver);
    // The executive repeats in many lines that the filter failed: kept out of the output.
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->ErrorObserver);
    filter->AddObserver(vtkCommand::ProgressEvent, this->StopObserver);
    if (!this->Filters.empty())
    {
      filter->SetInputConnection(this->Filters.back()->GetOutputPort());
    }
    this->Filters.emplace_back(filter);
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
  std::vector<vtkSmartPointer<vtkAlgorithm>> Filters;
  vtkNew<vtkPEMCaseLabel> Label;
  vtkNew<vtkPEMMetricSummary> Summary;
};

StudyPipeline::StudyPipeline(const Study& study, const std::vector<SolverDescription>& solvers,
  const Options& options, const std::atomic<bool>& stop)
  : Implementation(std::make_unique<Internals>(stop))
{
  Internals& pipeline = *this->Implementation;
  if (HasMeshFiles(study))
  {
    pipeline.Append(MakeReader(study));
  }
  else
  {
    vtkSmartPointer<vtkAlgorithm> mesher = MakeLayout(study);
    pipeline.Append(mesher->GetInputAlgorithm());
    pipeline.Append(mesher);
  }
  pipeline.Append(pipeline.Label);
  if (!study.Metrics || !study.Metrics->empty())
  {
    vtkNew<vtkPEMMetrics> metrics;
    if (study.Metrics)
    {
      metrics->SetMetrics(*study.Metrics);
    }
    pipeline.Append(metrics);
  }
  for (std::size_t i = 0; i < study.Solvers.size(); ++i)
  {
    pipeline.Append(MakeSolver(study.Solvers[i], solvers[i], options));
  }
  if (study.Metrics)
  {
    pipeline.Summary->SetMetrics(*study.Metrics);
  }
  pipeline.Append(pipeline.Summary);
}

StudyPipeline::~StudyPipeline() = default;

void StudyPipeline::Execute(const StudyCase& studyCase)
{
  Internals& pipeline = *this->Implementation;
  pipeline.Error.clear();
  pipeline.Label->SetMeshName(studyCase.Name);
  for (const auto& [name, value] : studyCase.Parameters)
  {
    pipeline.Label->SetParameter(name, value);
  }
  vtkAlgorithm* last = pipeline.Summary;
  last->UpdateInformation();
  vtkStreamingDemandDrivenPipeline::SafeDownCast(last->GetExecutive())
    ->GetOutputInformation(0)
    ->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), studyCase.Time);
  const bool done = last->GetExecutive()->Update() != 0;
  if (!done || !pipeline.Error.empty())
  {
    throw std::runtime_error(
      pipeline.Error.empty() ? "The pipeline failed without saying why." : pipeline.Error);
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
