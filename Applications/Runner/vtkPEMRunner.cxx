// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMRunner.h"

#include "CsvTable.h"
#include "RankDesk.h"
#include "SolverCommand.h"
#include "SolverDescription.h"
#include "Study.h"
#include "StudyCases.h"
#include "StudyExecution.h"
#include "StudyFigures.h"
#include "StudyFile.h"
#include "StudyFindings.h"
#include "StudyFolder.h"
#include "StudyJournal.h"
#include "StudyResults.h"
#include "StudyTask.h"
#include "TextFile.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <set>
#include <stdexcept>

#include <vtkCommand.h>
#include <vtkObjectFactory.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

namespace fs = std::filesystem;

vtkStandardNewMacro(vtkPEMRunner);

class vtkPEMRunner::Internals
{
public:
  explicit Internals(vtkPEMRunner* self)
    : Self(self)
  {
  }

  void Forget();
  void LoadStudy();
  void SelectCases();
  void RunCases();
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
  bool Resume = false;
  std::vector<int> SelectedCases;
  int Retries = 0;
  double SolverMemory = 0.0;
  std::vector<std::string> MeshFormats;
  pemesh::RankChannel* Channel = nullptr;

  // What follows from it.
  pemesh::Study Study;
  fs::path Output;
  std::vector<pemesh::SolverDescription> Solvers;
  std::vector<pemesh::StudyCase> Cases;
  std::vector<int> CasesToDo;
  pemesh::StudyTask Task;
  std::unique_ptr<pemesh::RankDesk> Desk; // where other processes take part
  std::unique_ptr<pemesh::StudyJournal> Journal;
  std::unique_ptr<pemesh::StudyResults> Results;
  std::unique_ptr<pemesh::StudyFigures> Figures;
  vtkSmartPointer<vtkTable> Correlation;
  std::vector<std::string> Messages;
  std::vector<std::string> FigureFiles;
  bool Refused = false;

  std::atomic<bool> Stop{ false };
  int CasesReused = 0;
};

vtkPEMRunner::vtkPEMRunner()
  : Implementation(std::make_unique<Internals>(this))
{
}

vtkPEMRunner::~vtkPEMRunner() = default;

/** The last run. */
void vtkPEMRunner::Internals::Forget()
{
  this->Messages.clear();
  this->FigureFiles.clear();
  this->Correlation = nullptr;
  this->Figures.reset();
  this->Results.reset();
  this->Desk.reset();
  this->Journal.reset();
  this->CasesReused = 0;
}

void vtkPEMRunner::Internals::LoadStudy()
{
  this->Task = {};
  this->Task.Text = this->StudyText;
  this->Task.Source = this->StudyFolder / "study.json";
  if (!this->StudyFile.empty())
  {
    this->Task.Text = pemesh::ReadTextFile(this->StudyFile);
    this->Task.Source = this->StudyFile;
  }
  else if (this->Task.Text.empty())
  {
    throw std::runtime_error("No study is set: name a study file.");
  }
  for (const std::string& setting : this->Settings)
  {
    this->Task.Text = pemesh::ApplySetting(this->Task.Text, setting);
  }
  this->Task.MeshesOnly = this->MeshesOnly;
  this->Task.Formats = this->MeshFormats;
  pemesh::LoadedStudy loaded = pemesh::LoadStudy(this->Task);
  this->Study = std::move(loaded.TheStudy);
  this->Solvers = std::move(loaded.Solvers);
  this->Cases = std::move(loaded.Cases);
  for (std::size_t i = 0; i < this->Solvers.size(); ++i)
  {
    this->Task.Versions.push_back(pemesh::AskSolverVersion(this->Solvers[i]));
    this->Study.Solvers[i].Version = this->Task.Versions[i];
  }
  this->Output = this->OutputDirectory.empty() ? fs::path(this->Study.Name) : this->OutputDirectory;
  if (this->Output.empty())
  {
    throw std::runtime_error("The study has no name: name its output folder with -o.");
  }
  pemesh::CheckStudyFolder(this->Output);
}

void vtkPEMRunner::Internals::SelectCases()
{
  const std::set<int> selected(this->SelectedCases.begin(), this->SelectedCases.end());
  this->CasesToDo.clear();
  for (const pemesh::StudyCase& studyCase : this->Cases)
  {
    if (selected.empty() || selected.count(studyCase.Index) > 0)
    {
      this->CasesToDo.push_back(studyCase.Index);
    }
  }
  if (!selected.empty() && this->CasesToDo.size() < selected.size())
  {
    throw std::runtime_error("There is no mesh " +
      std::to_string(*selected.begin() < 0 ? *selected.begin() : *selected.rbegin()) +
      ": the study has " + std::to_string(this->Cases.size()) + ", counted from 0.");
  }
}

void vtkPEMRunner::Internals::RunCases()
{
  this->Task.Options = { this->Output, this->MeshesOnly ? this->Output : this->Output / "meshes",
    this->NumberOfWorkers, this->Resume, this->Retries, this->SolverMemory };
  if (this->Desk)
  {
    this->Desk->Begin(this->Task);
  }
  pemesh::StudyExecution execution(this->Study, this->Solvers, this->Cases, this->CasesToDo,
    this->Task.Options, !this->MeshesOnly, *this->Journal, this->Desk.get(), this->Stop);
  const auto report = [this](double fraction, const std::vector<std::string>& lines)
  {
    for (std::string line : lines)
    {
      this->Self->InvokeEvent(vtkPEMRunner::LogEvent, line.data());
    }
    this->Self->InvokeEvent(vtkCommand::ProgressEvent, &fraction);
  };
  const std::string interruption = execution.Run(*this->Results, *this->Figures, report);
  this->CasesReused = execution.GetNumberOfReusedCases();
  if (!interruption.empty())
  {
    this->Messages.push_back(interruption);
  }
}

void vtkPEMRunner::Internals::Correlate()
{
  try
  {
    this->Correlation =
      pemesh::WriteFindings(this->Study.Statistics, this->Results->GetResults(), this->Output);
  }
  catch (const std::exception& error)
  {
    this->Messages.emplace_back(error.what());
  }
}

void vtkPEMRunner::Internals::SaveResults()
{
  this->Results->Finish();
  this->Journal->CheckPlace();
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
  run.Forget();
  run.Refused = false;
  run.Stop = false;
  try
  {
    run.Desk = run.Channel ? std::make_unique<pemesh::RankDesk>(*run.Channel) : nullptr;
    run.LoadStudy();
    run.SelectCases();
    run.Journal = std::make_unique<pemesh::StudyJournal>(
      run.Output / "journal.tsv", run.Resume, run.Cases.size());
    pemesh::RemoveStaleFiles(run.Output, run.Study, run.Cases, run.Resume);
    run.Results = std::make_unique<pemesh::StudyResults>(run.Study, run.Cases, *run.Journal);
    run.Figures = std::make_unique<pemesh::StudyFigures>(run.Study, run.Solvers, run.Cases);
    pemesh::WriteTextFile(
      run.Output / "study.json", pemesh::FormatStudy(pemesh::MoveStudy(run.Study, run.Output)));
    run.RunCases();
    run.Desk.reset(); // the others have left
  }
  catch (const std::exception& error)
  {
    run.Forget();
    run.Messages.emplace_back(error.what());
    run.Refused = true;
    return false;
  }
  try
  {
    run.SaveResults();
  }
  catch (const std::exception& error)
  {
    run.Messages.push_back(std::string(error.what()) +
      " Nothing that was computed is lost: make room, or mend what is wrong, and --resume writes "
      "the results.");
  }
  run.Journal.reset(); // others may go on from it
  const vtkIdType rows = run.Results->GetResults()->GetNumberOfRows();
  if (rows < static_cast<vtkIdType>(run.CasesToDo.size()))
  {
    run.Messages.push_back("Stopped after " + std::to_string(rows) + " of " +
      std::to_string(run.CasesToDo.size()) +
      " meshes; what was done is saved, and --resume goes on.");
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

void vtkPEMRunner::SetResume(bool resume)
{
  this->Implementation->Resume = resume;
  this->Modified();
}

bool vtkPEMRunner::GetResume() const
{
  return this->Implementation->Resume;
}

void vtkPEMRunner::SetSelectedCases(const std::vector<int>& cases)
{
  this->Implementation->SelectedCases = cases;
  this->Modified();
}

std::vector<int> vtkPEMRunner::GetSelectedCases() const
{
  return this->Implementation->SelectedCases;
}

void vtkPEMRunner::SetRetries(int retries)
{
  this->Implementation->Retries = std::max(0, retries);
  this->Modified();
}

int vtkPEMRunner::GetRetries() const
{
  return this->Implementation->Retries;
}

void vtkPEMRunner::SetSolverMemory(double mebibytes)
{
  this->Implementation->SolverMemory = mebibytes > 0.0 ? mebibytes : 0.0;
  this->Modified();
}

double vtkPEMRunner::GetSolverMemory() const
{
  return this->Implementation->SolverMemory;
}

void vtkPEMRunner::SetRankChannel(pemesh::RankChannel* channel)
{
  this->Implementation->Channel = channel;
  this->Modified();
}

int vtkPEMRunner::GetNumberOfReusedCases() const
{
  return this->Implementation->CasesReused;
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
  os << indent << "Resume: " << run.Resume << "\n";
  os << indent << "SelectedCases: " << run.SelectedCases.size() << "\n";
  os << indent << "SolverMemory: " << run.SolverMemory << "\n";
  os << indent << "Retries: " << run.Retries << "\n";
  os << indent << "RankChannel: " << (run.Channel ? "given" : "none") << "\n";
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
