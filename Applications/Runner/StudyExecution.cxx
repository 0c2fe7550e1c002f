// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyExecution.h"

#include "RankDesk.h"
#include "SolverDescription.h"
#include "Study.h"
#include "StudyCases.h"
#include "StudyFigures.h"
#include "StudyFolder.h"
#include "StudyJournal.h"
#include "StudyResults.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkXMLPolyDataReader.h>

namespace fs = std::filesystem;

namespace pemesh
{

StudyExecution::StudyExecution(const Study& study, const std::vector<SolverDescription>& solvers,
  const std::vector<StudyCase>& cases, const std::vector<int>& toDo,
  const CaseWorkers::Options& options, bool writesTables, StudyJournal& journal, RankDesk* desk,
  std::atomic<bool>& stop)
  : TheStudy(study)
  , Solvers(solvers)
  , Cases(cases)
  , ToDo(toDo)
  , Chosen(options)
  , WritesTables(writesTables)
  , Journal(journal)
  , Desk(desk)
  , Stop(stop)
{
}

StudyExecution::~StudyExecution() = default;

std::optional<int> StudyExecution::Take()
{
  const std::size_t next = this->Stop ? this->ToDo.size() : this->NextCase++;
  return next < this->ToDo.size() ? std::optional<int>(this->ToDo[next]) : std::nullopt;
}

bool StudyExecution::Reuse(int index, const std::string& key)
{
  const StudyCase& studyCase = this->Cases.at(static_cast<std::size_t>(index));
  const fs::path folder = this->Chosen.MeshFolder;
  const std::string file = (folder / (studyCase.Name + ".vtp")).string();
  const bool isShown = this->Figures->Shows(studyCase);
  if (!HasMeshFilesOf(folder, this->TheStudy, studyCase) || (isShown && !fs::exists(file)) ||
    !this->Journal.Adopt(index, key))
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
  this->CaseIsDone({});
  return true;
}

void StudyExecution::Bring(const CaseAnswer& answer)
{
  const StudyCase& studyCase = this->Cases.at(static_cast<std::size_t>(answer.Index));
  if (!answer.NotWritten.empty())
  {
    this->Results->AddFailure(
      { studyCase.Index, studyCase.Name, "output", "not-written", answer.NotWritten });
  }
  if (answer.Mesh)
  {
    this->Figures->KeepMesh(studyCase, answer.Mesh);
  }
  try
  {
    this->CaseIsDone(this->Results->AddRow(studyCase, answer.Key, answer.Row));
  }
  catch (const std::exception& error)
  {
    const std::scoped_lock lock(this->Mutex);
    this->Interruption = error.what();
    this->Stop = true;
  }
}

void StudyExecution::CaseIsDone(const std::string& line)
{
  const std::scoped_lock lock(this->Mutex);
  if (!line.empty())
  {
    this->Lines.push_back(line);
  }
  ++this->CasesDone;
  this->Changed.notify_one();
}

void StudyExecution::Refuse(const std::string& sentence)
{
  const std::scoped_lock lock(this->Mutex);
  this->WrongConfiguration = sentence;
  this->Stop = true;
}

void StudyExecution::Leave()
{
  const std::scoped_lock lock(this->Mutex);
  ++this->WorkersDone;
  this->Changed.notify_one();
}

void StudyExecution::ServeDesk()
{
  if (!this->Desk)
  {
    return;
  }
  if (this->Stop)
  {
    this->Desk->Stop();
  }
  if (this->Desk->Serve(*this))
  {
    this->Pace.SomethingCame();
  }
}

bool StudyExecution::IsOver(std::size_t workers) const
{
  return this->WorkersDone == workers && (!this->Desk || this->Desk->HaveAllLeft());
}

void StudyExecution::WaitForWorkers(std::size_t workers, const Report& report)
{
  std::size_t told = 0;
  std::unique_lock lock(this->Mutex);
  for (bool isOver = false; !isOver;)
  {
    lock.unlock();
    this->ServeDesk();
    lock.lock();
    const auto hasChanged = [&] { return this->CasesDone != told || this->IsOver(workers); };
    if (this->Desk)
    {
      this->Changed.wait_for(lock, this->Pace.Pause(), hasChanged);
    }
    else
    {
      this->Changed.wait(lock, hasChanged);
    }
    isOver = this->IsOver(workers);
    if (this->CasesDone == told)
    {
      continue;
    }
    told = this->CasesDone;
    std::vector<std::string> lines;
    lines.swap(this->Lines);
    lock.unlock();
    report(static_cast<double>(told) / static_cast<double>(this->ToDo.size()), lines);
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
    this->Journal.CheckPlace();
    this->Journal.Flush();
    this->Results->Finish();
    this->Results->Write(this->Chosen.Folder, !this->WritesTables);
  }
  catch (const std::exception&)
  {
    // A disk that is full now may have room at the end; the end will say so if not.
  }
  constexpr std::chrono::seconds least{ 2 };
  constexpr int rarity = 20;
  this->NextSave = Clock::now() + std::max<Clock::duration>(least, rarity * (Clock::now() - start));
}

std::string StudyExecution::Run(StudyResults& results, StudyFigures& figures, const Report& report)
{
  this->Results = &results;
  this->Figures = &figures;
  constexpr std::chrono::seconds firstSave{ 2 };
  this->NextSave = std::chrono::steady_clock::now() + firstSave;
  {
    CaseWorkers workers(
      this->TheStudy, this->Solvers, this->Cases, this->Chosen, *this, this->Stop);
    try
    {
      this->WaitForWorkers(workers.Start(this->ToDo.size()), report);
    }
    catch (...)
    {
      this->Stop = true; // the workers end with what they do, and are waited for
      throw;
    }
  }
  if (!this->WrongConfiguration.empty())
  {
    throw std::runtime_error(this->WrongConfiguration);
  }
  return this->Interruption;
}

} // namespace pemesh
