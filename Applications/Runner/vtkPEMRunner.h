// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMRunner
 * @brief   Runs a study: from its document to the tables, meshes and plots of its folder.
 *
 * The runner owns the list of cases of a study (one mesh each) and a number of workers. Each
 * worker is a thread with a pipeline of its own, to which it applies one case after the other; so
 * memory holds a constant number of meshes however many cases there are. What it leaves in the
 * output folder does not depend on the number of workers:
 *
 *   results.csv      one row a case, the same to the byte on every run
 *   timings.csv      what depends on the machine, one row a case
 *   correlation.csv  every metric against every other and every performance
 *   findings.csv     for each performance the metrics that go with it, best first
 *   findings.txt     the same in sentences
 *   failures.csv     what went wrong, one row a failure; only where something did
 *   index.csv        the name and the parameters of every case
 *   study.json       the study with every default written out
 *   meshes/          the meshes with all arrays, series.pvd beside the folder
 *   `solvers/<run>/`   the raw files and logs of every solver run
 *   journal.tsv      the rows as they come; what Resume goes on from
 *   plots/           the figures that the study asks for
 *
 * A case that fails is a row with its status; the others are done and saved. While the study runs
 * the tables hold what is done so far. What an earlier run has left in the folder for meshes that
 * the study does not have any more is removed.
 *
 * Events, in the thread that called Run(): ProgressEvent with the fraction done (const double*);
 * LogEvent with what a log should say of a case that is done (const char*).
 * @sa vtkPEMSeriesTable
 */
#ifndef vtkPEMRunner_h
#define vtkPEMRunner_h

#include "pemeshRunnerModule.h" // For export macro

#include <memory> // For the implementation
#include <string> // For arguments
#include <vector> // For arguments

#include <vtkCommand.h> // For the numbers of events
#include <vtkObject.h>

class vtkTable;

namespace pemesh
{
class RankChannel;
}

class PEMESHRUNNER_EXPORT vtkPEMRunner : public vtkObject
{
public:
  static vtkPEMRunner* New();
  vtkTypeMacro(vtkPEMRunner, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum EventType
  {
    LogEvent = vtkCommand::UserEvent + 1
  };

  ///@{
  /**
   * The study: a file, or a document given as JSON text whose relative paths are resolved against
   * `folder`. The last one set counts.
   */
  void SetStudyFile(const std::string& path);
  void SetStudyText(const std::string& json, const std::string& folder);
  ///@}

  /** Changes one value of the study, as in "mesh.min-angle=25". Applied in the order added. */
  void AddSetting(const std::string& setting);
  void RemoveAllSettings();

  ///@{
  /**
   * The folder for the results; made if missing, and never emptied. A folder that holds
   * something else than a study's results is refused. Default: the name of the study.
   */
  void SetOutputDirectory(const std::string& path);
  std::string GetOutputDirectory() const;
  ///@}

  ///@{
  /** Number of workers, 1 to 1024; 0 stands for one a core. Default 0. */
  void SetNumberOfWorkers(int workers);
  int GetNumberOfWorkers() const;
  ///@}

  ///@{
  /**
   * Whether only the meshes are made: neither metrics nor solvers nor plots, the files straight
   * into the output folder, in the formats given ("off", …; none leaves those of the study).
   * Default false.
   */
  void SetMeshesOnly(bool meshesOnly);
  bool GetMeshesOnly() const;
  void SetMeshFormats(const std::vector<std::string>& formats);
  ///@}

  ///@{
  /**
   * Whether the run goes on from what the folder holds: a case is taken as it is where all that it
   * follows from is as it was (the study, the bytes of mesh files, the solvers and their versions)
   * and its files are there; so is an answer of a solver. Cases in which a solver has failed are
   * done again. The results are those of an undisturbed run. Default false.
   */
  void SetResume(bool resume);
  bool GetResume() const;
  ///@}

  ///@{
  /**
   * The cases that are done, by their numbers from 0; the others are left out of the results. None
   * (default): all.
   */
  void SetSelectedCases(const std::vector<int>& cases);
  std::vector<int> GetSelectedCases() const;
  ///@}

  ///@{
  /** How often a solver is tried again on a mesh where it has failed. Default 0. */
  void SetRetries(int retries);
  int GetRetries() const;
  ///@}

  ///@{
  /**
   * MiB of memory that all solvers at work may take together: one waits where it would take too
   * much, whatever the number of workers. The meshes at work in this process keep within as much:
   * the first is alone, then there are as many as fit. Default 0: any.
   */
  void SetSolverMemory(double mebibytes);
  double GetSolverMemory() const;
  ///@}

  /**
   * Other processes that compute cases of the study: this one must be the first of the channel, and
   * the others call WorkForFirstRank (RankBoard.h). The number of workers is that of each process,
   * the memory of solvers that of each machine. Must outlive the run. Default null: none.
   */
  void SetRankChannel(pemesh::RankChannel* channel);

  /**
   * Runs the study. True only if every case was done without a failure; then, and when some cases
   * failed, the results are saved. GetMessages() says in sentences what went wrong.
   */
  bool Run();

  ///@{
  /** After Run(): whether the study itself was refused (nothing was run), and the counts. */
  bool GetRefused() const;
  int GetNumberOfCases() const;
  int GetNumberOfFailures() const;
  /** Cases that were taken from an earlier run. */
  int GetNumberOfReusedCases() const;
  ///@}

  /** After Run(): one sentence for every failure, in the order of the cases. */
  std::vector<std::string> GetMessages() const;

  /** After Run(): the files of the figures made. */
  std::vector<std::string> GetFigureFiles() const;

  ///@{
  /** After Run(): the tables as they were saved, or null. */
  vtkTable* GetResults();
  vtkTable* GetTimings();
  vtkTable* GetCorrelation();
  ///@}

  /**
   * Asks a run to end soon, keeping and saving the cases already done. May be called from any
   * thread and from a signal handler.
   */
  void RequestStop();

protected:
  vtkPEMRunner();
  ~vtkPEMRunner() override;

private:
  vtkPEMRunner(const vtkPEMRunner&) = delete;
  void operator=(const vtkPEMRunner&) = delete;

  class Internals;
  std::unique_ptr<Internals> Implementation;
};

#endif
