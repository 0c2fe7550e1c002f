// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMRunner.h"

#include "CsvTable.h"
#include "MeshFormats.h"
#include "SolverCommand.h"
#include "SolverDescription.h"
#include "SolverDescriptionFile.h"
#include "Study.h"
#include "StudyCases.h"
#include "StudyFigures.h"
#include "StudyFile.h"
#include "StudyPipeline.h"
#include "StudyResults.h"
#include "TextFile.h"
#include "vtkPEMCorrelation.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <stdexcept>
#include <thread>

#include <vtkCommand.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

namespace fs = std::filesystem;

vtkStandardNewMacro(vtkPEMRunner);

namespace
{

/** A folder that holds something else than the results of a study is not ours to write into. */
void CheckOutputFolder(const fs::path& folder)
{
  if (fs::exists(folder) && !fs::is_directory(folder))
  {
    throw std::runtime_error(
      "The output \"" + folder.string() + "\" is a file; name a folder with -o.");
  }
  if (fs::exists(folder) && !fs::is_empty(folder) && !fs::exists(folder / "study.json"))
  {
    throw std::runtime_error("The output folder \"" + folder.string() +
      "\" holds something else than the results of a study; name another one with -o.");
  }
}

} // namespace

class vtkPEMRunner::Internals
{
public:
  explicit Internals(vtkPEMRunner* self)
    : Self(self)
  {
  }

  void LoadStudy();
  void RunCases();
  void Work(int threads);
  void ExecuteCase(pemesh::StudyPipeline& pipeline, const pemesh::StudyCase& studyCase);
  void WriteMeshes(const pemesh::StudyCase& studyCase, vtkPolyData* mesh);
  void Log(const std::string& line);
  void WaitForWorkers(std::vector<std::thread>& workers);
  void SaveResults();
  void Correlate();

  vtkPEMRunner* Self;

  // What was set.
  fs::path StudyFile;
  std::string StudyText;
  fs::path StudyFolder;
  std::vector<std::string> Settings;
  fs::path OutputDirectory;
  int NumberOfWorkers = 0;
  bool MeshesOnly = false;
  std::vector<std::string> MeshFormats;

  // What follows from it.
  pemesh::Study Study;
  fs::path Output;
  std::vector<pemesh::SolverDescription> Solvers;
  std::vector<pemesh::StudyCase> Cases;
  std::unique_ptr<pemesh::StudyResults> Results;
  std::unique_ptr<pemesh::StudyFigures> Figures;
  vtkSmartPointer<vtkTable> Correlation;
  std::vector<std::string> Messages;
  std::vector<std::string> FigureFiles;
  bool Refused = false;

  // What the workers share.
  std::atomic<bool> Stop{ false };
  std::atomic<std::size_t> NextCase{ 0 };
  std::mutex Mutex;
  std::condition_variable Changed;
  std::size_t CasesDone = 0;
  std::size_t WorkersDone = 0;
  std::vector<std::string> Lines; // of the log, not yet told
  std::string WrongConfiguration;
};

vtkPEMRunner::vtkPEMRunner()
  : Implementation(std::make_unique<Internals>(this))
{
}

vtkPEMRunner::~vtkPEMRunner() = default;

void vtkPEMRunner::Internals::LoadStudy()
{
  std::string text = this->StudyText;
  fs::path source = this->StudyFolder / "study.json";
  if (!this->StudyFile.empty())
  {
    text = pemesh::ReadTextFile(this->StudyFile);
    source = this->StudyFile;
  }
  else if (text.empty())
  {
    throw std::runtime_error("No study is set: name a study file.");
  }
  for (const std::string& setting : this->Settings)
  {
    text = pemesh::ApplySetting(text, setting);
  }
  this->Study = pemesh::ParseStudy(text, source);
  this->Study.WrittenBy = "PEMesh " PEMESH_VERSION;
  if (this->MeshesOnly)
  {
    this->Study.Metrics = std::vector<std::string>();
    this->Study.Solvers.clear();
    this->Study.Plots.clear();
  }
  if (!this->MeshFormats.empty())
  {
    this->Study.Output.Formats = this->MeshFormats;
  }
  this->Solvers = pemesh::FindStudySolvers(this->Study);
  for (std::size_t i = 0; i < this->Solvers.size(); ++i)
  {
    this->Study.Solvers[i].Version = pemesh::AskSolverVersion(this->Solvers[i]);
  }
  this->Cases = pemesh::MakeStudyCases(this->Study);
  this->Output = this->OutputDirectory.empty() ? fs::path(this->Study.Name) : this->OutputDirectory;
  if (this->Output.empty())
  {
    throw std::runtime_error("The study has no name: name its output folder with -o.");
  }
  CheckOutputFolder(this->Output);
}

void vtkPEMRunner::Internals::WriteMeshes(const pemesh::StudyCase& studyCase, vtkPolyData* mesh)
{
  if (mesh->GetNumberOfCells() == 0)
  {
    return; // its status says why
  }
  const fs::path folder = this->MeshesOnly ? this->Output : this->Output / "meshes";
  const vtkSmartPointer<vtkPolyData> saved = pemesh::WithoutMeasured(mesh);
  for (const std::string& name : this->Study.Output.Formats)
  {
    const pemesh::MeshFormat* format = pemesh::FindMeshFormat(name);
    if (!format)
    {
      throw std::runtime_error("\"" + name + "\" is no mesh format.");
    }
    format->Write(folder / (studyCase.Name + format->Extensions.front()), saved);
  }
}

void vtkPEMRunner::Internals::ExecuteCase(
  pemesh::StudyPipeline& pipeline, const pemesh::StudyCase& studyCase)
{
  pipeline.Execute(studyCase);
  if (this->Stop)
  {
    return; // what an abort leaves is no result
  }
  try
  {
    this->WriteMeshes(studyCase, pipeline.GetMesh());
  }
  catch (const std::exception& error)
  {
    this->Results->AddFailure(
      { studyCase.Index, studyCase.Name, "output", "not-written", error.what() });
  }
  this->Log(this->Results->AddRow(studyCase, pipeline.GetRow()));
  this->Figures->KeepMesh(studyCase, pipeline.GetMesh());
}

void vtkPEMRunner::Internals::Work(int threads)
{
  try
  {
    pemesh::StudyPipeline pipeline(
      this->Study, this->Solvers, { this->Output / "solvers", threads }, this->Stop);
    while (!this->Stop)
    {
      const std::size_t next = this->NextCase++;
      if (next >= this->Cases.size())
      {
        break;
      }
      this->ExecuteCase(pipeline, this->Cases[next]);
      const std::scoped_lock lock(this->Mutex);
      ++this->CasesDone;
      this->Changed.notify_one();
    }
  }
  catch (const std::exception& error)
  {
    // Wrong for one case, wrong for all: there is no point in going on.
    const std::scoped_lock lock(this->Mutex);
    this->WrongConfiguration = error.what();
    this->Stop = true;
  }
  const std::scoped_lock lock(this->Mutex);
  ++this->WorkersDone;
  this->Changed.notify_one();
}

void vtkPEMRunner::Internals::Log(const std::string& line)
{
  const std::scoped_lock lock(this->Mutex);
  this->Lines.push_back(line);
}

void vtkPEMRunner::Internals::WaitForWorkers(std::vector<std::thread>& workers)
{
  std::unique_lock lock(this->Mutex);
  while (this->WorkersDone < workers.size())
  {
    this->Changed.wait(lock);
    double fraction =
      static_cast<double>(this->CasesDone) / static_cast<double>(this->Cases.size());
    std::vector<std::string> lines;
    lines.swap(this->Lines);
    lock.unlock();
    for (std::string& line : lines)
    {
      this->Self->InvokeEvent(vtkPEMRunner::LogEvent, line.data());
    }
    this->Self->InvokeEvent(vtkCommand::ProgressEvent, &fraction);
    lock.lock();
  }
  lock.unlock();
  for (std::thread& worker : workers)
  {
    worker.join();
  }
}

void vtkPEMRunner::Internals::RunCases()
{
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int wanted = this->NumberOfWorkers > 0 ? this->NumberOfWorkers : cores;
  const int count = std::min(wanted, static_cast<int>(this->Cases.size()));
  const int threads = std::max(1, cores / count);
  this->NextCase = 0;
  this->CasesDone = 0;
  this->WorkersDone = 0;
  this->WrongConfiguration.clear();
  std::vector<std::thread> workers;
  for (int i = 0; i < count; ++i)
  {
    workers.emplace_back([this, threads] { this->Work(threads); });
  }
  this->WaitForWorkers(workers);
  if (!this->WrongConfiguration.empty())
  {
    throw std::runtime_error(this->WrongConfiguration);
  }
}

void vtkPEMRunner::Internals::Correlate()
{
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(this->Results->GetResults());
  correlation->Update();
  this->Correlation = correlation->GetOutput();
  pemesh::WriteCsvFile(this->Output / "correlation.csv", this->Correlation);
}

void vtkPEMRunner::Internals::SaveResults()
{
  this->Results->Finish();
  this->Results->Write(this->Output, this->MeshesOnly);
  const auto& formats = this->Study.Output.Formats;
  if (std::find(formats.begin(), formats.end(), "vtp") != formats.end())
  {
    this->Results->WriteSeries(this->Output, this->MeshesOnly ? "" : "meshes");
  }
  for (const pemesh::StudyFailure& failure : this->Results->GetFailures())
  {
    this->Messages.push_back(pemesh::SentenceOf(failure));
  }
  if (this->MeshesOnly || this->Results->GetResults()->GetNumberOfRows() == 0)
  {
    return;
  }
  this->Correlate();
  for (const std::string& problem :
    this->Figures->Write(this->Output / "plots", this->Results->GetResults(), this->FigureFiles))
  {
    this->Messages.push_back(problem);
  }
}

bool vtkPEMRunner::Run()
{
  Internals& run = *this->Implementation;
  run.Messages.clear();
  run.FigureFiles.clear();
  run.Correlation = nullptr;
  run.Results.reset();
  run.Refused = false;
  run.Stop = false;
  try
  {
    run.LoadStudy();
    run.Results = std::make_unique<pemesh::StudyResults>(run.Study, run.Cases);
    run.Figures = std::make_unique<pemesh::StudyFigures>(run.Study, run.Solvers, run.Cases);
    pemesh::WriteTextFile(
      run.Output / "study.json", pemesh::FormatStudy(pemesh::MoveStudy(run.Study, run.Output)));
    run.RunCases();
    run.SaveResults();
  }
  catch (const std::exception& error)
  {
    run.Messages.emplace_back(error.what());
    run.Refused = true;
    return false;
  }
  const vtkIdType rows = run.Results->GetResults()->GetNumberOfRows();
  if (rows < static_cast<vtkIdType>(run.Cases.size()))
  {
    run.Messages.push_back("Stopped after " + std::to_string(rows) + " of " +
      std::to_string(run.Cases.size()) + " meshes; what was done is saved.");
  }
  return run.Messages.empty();
}

void vtkPEMRunner::RequestStop()
{
  this->Implementation->Stop = true;
}

void vtkPEMRunner::SetStudyFile(const std::string& path)
{
  this->Implementation->StudyFile = path;
  this->Implementation->StudyText.clear();
  this->Modified();
}

void vtkPEMRunner::SetStudyText(const std::string& json, const std::string& folder)
{
  this->Implementation->StudyFile.clear();
  this->Implementation->StudyText = json;
  this->Implementation->StudyFolder = folder;
  this->Modified();
}

void vtkPEMRunner::AddSetting(const std::string& setting)
{
  this->Implementation->Settings.push_back(setting);
  this->Modified();
}

void vtkPEMRunner::RemoveAllSettings()
{
  this->Implementation->Settings.clear();
  this->Modified();
}

void vtkPEMRunner::SetOutputDirectory(const std::string& path)
{
  this->Implementation->OutputDirectory = path;
  this->Modified();
}

std::string vtkPEMRunner::GetOutputDirectory() const
{
  const Internals& run = *this->Implementation;
  return (run.OutputDirectory.empty() ? run.Output : run.OutputDirectory).string();
}

void vtkPEMRunner::SetNumberOfWorkers(int workers)
{
  this->Implementation->NumberOfWorkers = std::clamp(workers, 0, 1024);
  this->Modified();
}

int vtkPEMRunner::GetNumberOfWorkers() const
{
  return this->Implementation->NumberOfWorkers;
}

void vtkPEMRunner::SetMeshesOnly(bool meshesOnly)
{
  this->Implementation->MeshesOnly = meshesOnly;
  this->Modified();
}

bool vtkPEMRunner::GetMeshesOnly() const
{
  return this->Implementation->MeshesOnly;
}

void vtkPEMRunner::SetMeshFormats(const std::vector<std::string>& formats)
{
  this->Implementation->MeshFormats = formats;
  this->Modified();
}

bool vtkPEMRunner::GetRefused() const
{
  return this->Implementation->Refused;
}

int vtkPEMRunner::GetNumberOfCases() const
{
  return static_cast<int>(this->Implementation->Cases.size());
}

int vtkPEMRunner::GetNumberOfFailures() const
{
  return static_cast<int>(this->Implementation->Messages.size());
}

std::vector<std::string> vtkPEMRunner::GetMessages() const
{
  return this->Implementation->Messages;
}

std::vector<std::string> vtkPEMRunner::GetFigureFiles() const
{
  return this->Implementation->FigureFiles;
}

vtkTable* vtkPEMRunner::GetResults()
{
  return this->Implementation->Results ? this->Implementation->Results->GetResults() : nullptr;
}

vtkTable* vtkPEMRunner::GetTimings()
{
  return this->Implementation->Results ? this->Implementation->Results->GetTimings() : nullptr;
}

vtkTable* vtkPEMRunner::GetCorrelation()
{
  return this->Implementation->Correlation;
}

void vtkPEMRunner::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const Internals& run = *this->Implementation;
  os << indent << "StudyFile: " << run.StudyFile.string() << "\n";
  os << indent << "OutputDirectory: " << this->GetOutputDirectory() << "\n";
  os << indent << "NumberOfWorkers: " << run.NumberOfWorkers << "\n";
  os << indent << "MeshesOnly: " << run.MeshesOnly << "\n";
  for (const std::string& format : run.MeshFormats)
  {
    os << indent << "MeshFormat: " << format << "\n";
  }
  for (const std::string& setting : run.Settings)
  {
    os << indent << "Setting: " << setting << "\n";
  }
}
