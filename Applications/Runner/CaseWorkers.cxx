// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseWorkers.h"

#include "CaseBoard.h"
#include "CaseGate.h"
#include "MemoryBudget.h"
#include "MeshFormats.h"
#include "ParallelLoop.h"
#include "SolverCommand.h"
#include "SolverDescription.h"
#include "SolverQueue.h"
#include "Study.h"
#include "StudyCaseKey.h"
#include "StudyCases.h"
#include "StudyFolder.h"
#include "StudyPipeline.h"
#include "StudyResults.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include <sched.h>

#include <vtkPolyData.h>
#include <vtkTable.h>

namespace fs = std::filesystem;

namespace pemesh
{

int AvailableCores()
{
  cpu_set_t bound; // of mpiexec, Slurm, taskset, a container; the standard library does not look
  CPU_ZERO(&bound);
  const int cores = sched_getaffinity(0, sizeof(bound), &bound) == 0
    ? CPU_COUNT(&bound)
    : static_cast<int>(std::thread::hardware_concurrency());
  return std::max(1, cores);
}

CaseWorkers::CaseWorkers(const Study& study, const std::vector<SolverDescription>& solvers,
  const std::vector<StudyCase>& cases, const Options& options, CaseBoard& board,
  std::atomic<bool>& stop)
  : TheStudy(study)
  , Solvers(solvers)
  , Cases(cases)
  , Chosen(options)
  , Board(board)
  , Stop(stop)
{
  if (HasMeshFiles(study))
  {
    this->MeshFiles = FindStudyMeshes(study);
  }
  constexpr double mebiByte = 1024.0 * 1024.0;
  this->Gate = std::make_unique<CaseGate>(mebiByte * options.SolverMemory, PeakMemory);
  if (options.SolverMemory > 0.0)
  {
    this->Budget = std::make_unique<MemoryBudget>(mebiByte * options.SolverMemory);
  }
}

CaseWorkers::~CaseWorkers()
{
  this->Threads.clear(); // before what they use
}

void CaseWorkers::WriteMeshes(const StudyCase& studyCase, vtkPolyData* mesh) const
{
  const fs::path folder = this->Chosen.MeshFolder;
  if (mesh->GetNumberOfCells() == 0)
  {
    RemoveMeshFiles(folder, this->TheStudy, studyCase);
    return; // its status says why
  }
  if (!fs::exists(this->Chosen.Folder / "journal.tsv"))
  {
    throw std::runtime_error("The output folder has vanished."); // and is not made anew elsewhere
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

void CaseWorkers::DoCase(StudyPipeline& pipeline, const StudyCase& studyCase)
{
  CaseAnswer answer;
  answer.Index = studyCase.Index;
  answer.Key = StudyCaseKey(this->TheStudy, this->Solvers, this->MeshFiles, studyCase);
  if (this->Chosen.Resume && this->Board.Reuse(studyCase.Index, answer.Key))
  {
    return;
  }
  pipeline.Execute(studyCase);
  if (this->Stop)
  {
    return; // what an abort leaves is no result
  }
  answer.Mesh = pipeline.GetMesh();
  answer.Row = pipeline.GetRow();
  try
  {
    this->WriteMeshes(studyCase, answer.Mesh);
  }
  catch (const std::exception& error)
  {
    answer.NotWritten = error.what();
  }
  this->Board.Bring(answer);
}

bool CaseWorkers::DoNextCase(StudyPipeline& pipeline)
{
  // Workers that wait for a list to be full hold each other up, and must not hold the gate.
  CaseGate* gate = this->Queue ? nullptr : this->Gate.get();
  const CaseGate::Visit visit(gate);
  const std::optional<int> next = this->Board.Take();
  if (next)
  {
    ++this->Busy;
    this->DoCase(pipeline, this->Cases.at(static_cast<std::size_t>(*next)));
    --this->Busy;
  }
  return next.has_value();
}

void CaseWorkers::Work(int threads)
{
  try
  {
    const std::unique_ptr<SolverQueue::Worker> worker =
      this->Queue ? std::make_unique<SolverQueue::Worker>(*this->Queue) : nullptr;
    StudyPipeline pipeline(this->TheStudy, this->Solvers,
      { this->Chosen.Folder / "solvers", threads, this->Chosen.Resume, this->Chosen.Retries,
        this->Budget.get(), this->Queue.get() },
      this->Stop);
    const LoopShare share(this->Busy, AvailableCores());
    while (this->DoNextCase(pipeline))
    {
    }
  }
  catch (const std::exception& error)
  {
    this->Board.Refuse(error.what()); // wrong for one case, wrong for all
  }
  this->Board.Leave();
}

/** A list is made of meshes that are all there: each waits in a worker of its own. */
int CaseWorkers::MeshesAtOnce(int atWork, std::size_t casesToDo) const
{
  int longest = 1;
  for (const SolverDescription& solver : this->Solvers)
  {
    longest = std::max(longest, TakesList(solver) ? solver.MeshesPerCall : 1);
  }
  const auto cases = static_cast<std::int64_t>(casesToDo);
  return static_cast<int>(std::min(cases, std::int64_t{ atWork } * longest));
}

std::size_t CaseWorkers::Start(std::size_t casesToDo)
{
  const int cores = AvailableCores();
  const int wanted = this->Chosen.Workers > 0 ? this->Chosen.Workers : cores;
  const int atWork = std::clamp(static_cast<int>(casesToDo), 1, wanted);
  const int count = this->MeshesAtOnce(atWork, casesToDo);
  const int threads = std::max(1, cores / atWork);
  this->Queue = count > atWork ? std::make_unique<SolverQueue>(count, atWork) : nullptr;
  try
  {
    for (int i = 0; i < count; ++i)
    {
      this->Threads.emplace_back([this, threads] { this->Work(threads); });
    }
  }
  catch (...)
  {
    this->Stop = true; // the workers end with what they do, and are waited for
    for (auto i = static_cast<int>(this->Threads.size()); this->Queue && i < count; ++i)
    {
      this->Queue->Leave();
    }
    throw;
  }
  return this->Threads.size();
}

} // namespace pemesh
