// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyExecution.h"

#include "MemoryBudget.h"
#include "MeshFormats.h"
#include "SolverCommand.h"
#include "SolverDescription.h"
#include "SolverQueue.h"
#include "Study.h"
#include "StudyCaseKey.h"
#include "StudyCases.h"
#include "StudyFigures.h"
#include "StudyFolder.h"
#include "StudyJournal.h"
#include "StudyPipeline.h"
#include "StudyResults.h"

#include <algorithm>
#include <stdexcept>

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>
#include <vtkXMLPolyDataReader.h>

namespace fs = std::filesystem;

namespace pemesh
{

StudyExecution::StudyExecution(const Study& study, const std::vector<SolverDescription>& solvers,
  const std::vector<StudyCase>& cases, const Options& options, StudyJournal& journal,
  std::atomic<bool>& stop)
  : TheStudy(study)
  , Solvers(solvers)
  , Cases(cases)
  , Chosen(options)
  , Journal(journal)
  , Stop(stop)
{
  if (HasMeshFiles(study))
  {
    this->MeshFiles = FindStudyMeshes(study);
  }
  constexpr double mebiByte = 1024.0 * 1024.0;
  if (options.SolverMemory > 0.0)
  {
    this->Budget = std::make_unique<MemoryBudget>(mebiByte * options.SolverMemory);
  }
}

StudyExecution::~StudyExecution() = default;

void StudyExecution::WriteMeshes(const StudyCase& studyCase, vtkPolyData* mesh)
{
  const fs::path folder = this->Chosen.MeshFolder;
  if (mesh->GetNumberOfCells() == 0)
  {
    RemoveMeshFiles(folder, this->TheStudy, studyCase);
    return; // its status says why
  }
  const vtkSmartPointer<vtkPolyData> saved = WithoutMeasured(mesh);
  for (const std::string& name : this->TheStudy.Output.Formats)
  {
    const MeshFormat* format = FindMeshFormat(name);
    if (!format)
    {
      throw std::runtime_error("\"" + name + "\" is no mesh format.");
    }
    format->Write(folder / (studyCase.Name + format->Extensions.front()), saved);
  }
}

void StudyExecution::ExecuteCase(
  StudyPipeline& pipeline, const StudyCase& studyCase, const std::string& key)
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
  this->Figures->KeepMesh(studyCase, pipeline.GetMesh());
  try
  {
    const std::string line = this->Results->AddRow(studyCase, key, pipeline.GetRow());
    const std::scoped_lock lock(this->Mutex);
    this->Lines.push_back(line);
  }
  catch (const std::exception& error)
  {
    const std::scoped_lock lock(this->Mutex);
    this->Interruption = error.what();
    this->Stop = true;
  }
}

bool StudyExecution::ReuseCase(const StudyCase& studyCase, const std::string& key)
{
  const fs::path folder = this->Chosen.MeshFolder;
  const std::string file = (folder / (studyCase.Name + ".vtp")).string();
  const bool isShown = this->Figures->Shows(studyCase);
  if (!HasMeshFilesOf(folder, this->TheStudy, studyCase) || (isShown && !fs::exists(file)) ||
    !this->Journal.Adopt(studyCase.Index, key))
  {
    return false;
  }
  if (isShown)
  {
    vtkNew<vtkXMLPolyDataReader> reader; // keeps every array
    reader->SetFileName(file.c_str());
    reader->Update();
    this->Figures->KeepMesh(studyCase, reader->GetOutput());
  }
  ++this->CasesReused;
  return true;
}

void StudyExecution::DoCase(StudyPipeline& pipeline, const StudyCase& studyCase)
{
  const std::string key = StudyCaseKey(this->TheStudy, this->Solvers, this->MeshFiles, studyCase);
  if (!this->Chosen.Resume || !this->ReuseCase(studyCase, key))
  {
    this->ExecuteCase(pipeline, studyCase, key);
  }
}

void StudyExecution::Work(int threads)
{
  try
  {
    const std::unique_ptr<SolverQueue::Worker> worker =
      this->Queue ? std::make_unique<SolverQueue::Worker>(*this->Queue) : nullptr;
    StudyPipeline pipeline(this->TheStudy, this->Solvers,
      { this->Chosen.Folder / "solvers", threads, this->Chosen.Resume, this->Chosen.Retries,
        this->Budget.get(), this->Queue.get() },
      this->Stop);
    while (!this->Stop)
    {
      const std::size_t next = this->NextCase++;
      if (next >= this->Cases.size())
      {
        break;
      }
      this->DoCase(pipeline, this->Cases[next]);
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

void StudyExecution::WaitForWorkers(std::size_t workers, const Report& report)
{
  std::size_t told = 0;
  std::unique_lock lock(this->Mutex);
  for (bool isOver = false; !isOver;)
  {
    this->Changed.wait(
      lock, [&] { return this->CasesDone != told || this->WorkersDone == workers; });
    isOver = this->WorkersDone == workers;
    if (this->CasesDone == told)
    {
      continue;
    }
    told = this->CasesDone;
    std::vector<std::string> lines;
    lines.swap(this->Lines);
    lock.unlock();
    report(static_cast<double>(told) / static_cast<double>(this->Cases.size()), lines);
    if (!isOver)
    {
      this->SaveProgress();
    }
    lock.lock();
  }
}

/** The tables as far as they go; rarely enough to cost a twentieth of the time. */
void StudyExecution::SaveProgress()
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  if (start < this->NextSave)
  {
    return;
  }
  try
  {
    this->Journal.Flush();
    this->Results->Finish();
    this->Results->Write(this->Chosen.Folder, !this->Chosen.WritesTables);
  }
  catch (const std::exception&)
  {
    // A disk that is full now may have room at the end; the end will say so if not.
  }
  constexpr std::chrono::seconds least{ 2 };
  constexpr int rarity = 20;
  this->NextSave = Clock::now() + std::max<Clock::duration>(least, rarity * (Clock::now() - start));
}

/** A list is made of meshes that are all there: each waits in a worker of its own. */
int StudyExecution::MeshesAtOnce(int atWork) const
{
  int longest = 1;
  for (const SolverDescription& solver : this->Solvers)
  {
    longest = std::max(longest, TakesList(solver) ? solver.MeshesPerCall : 1);
  }
  const auto cases = static_cast<std::int64_t>(this->Cases.size());
  return static_cast<int>(std::min(cases, std::int64_t{ atWork } * longest));
}

std::string StudyExecution::Run(StudyResults& results, StudyFigures& figures, const Report& report)
{
  this->Results = &results;
  this->Figures = &figures;
  constexpr std::chrono::seconds firstSave{ 2 };
  this->NextSave = std::chrono::steady_clock::now() + firstSave;
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int wanted = this->Chosen.Workers > 0 ? this->Chosen.Workers : cores;
  const int atWork = std::min(wanted, static_cast<int>(this->Cases.size()));
  const int count = this->MeshesAtOnce(atWork);
  const int threads = std::max(1, cores / atWork);
  this->Queue = count > atWork ? std::make_unique<SolverQueue>(count, atWork) : nullptr;
  std::vector<std::jthread> workers;
  try
  {
    for (int i = 0; i < count; ++i)
    {
      workers.emplace_back([this, threads] { this->Work(threads); });
    }
    this->WaitForWorkers(workers.size(), report);
  }
  catch (...)
  {
    this->Stop = true; // the workers end with what they do, and are waited for
    for (auto i = static_cast<int>(workers.size()); this->Queue && i < count; ++i)
    {
      this->Queue->Leave();
    }
    throw;
  }
  workers.clear();
  if (!this->WrongConfiguration.empty())
  {
    throw std::runtime_error(this->WrongConfiguration);
  }
  return this->Interruption;
}

} // namespace pemesh
