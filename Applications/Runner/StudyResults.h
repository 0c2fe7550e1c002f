// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The rows of a study, gathered from the workers in any order, and the tables made of them.
 */
#ifndef pemesh_StudyResults_h
#define pemesh_StudyResults_h

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include <vtkSmartPointer.h> // For the tables

class vtkPolyData;
class vtkTable;

namespace pemesh
{

class StudyJournal;
struct Study;
struct StudyCase;

struct StudyFailure
{
  int Index = 0;
  std::string Mesh;
  /** "mesh", "output" or the name of a solver's run. */
  std::string Stage;
  std::string Status;
  std::string Message;
};

/** "009: pemesh-vem: it took longer than its time limit." */
std::string SentenceOf(const StudyFailure& failure);

/** The mesh as it is saved: without what depends on the machine, so that every run gives the same.
 */
vtkSmartPointer<vtkPolyData> WithoutMeasured(vtkPolyData* mesh);

class StudyResults
{
public:
  /** The rows are kept in the journal, which must outlive the results. */
  StudyResults(const Study& study, const std::vector<StudyCase>& cases, StudyJournal& journal);
  ~StudyResults();

  /**
   * Keeps the row of a case. A later run takes it by its key, but not where something has failed
   * that may go well next time: a solver, or the writing of a file. Answers with what a log should
   * say of the case. May be called from any thread.
   */
  std::string AddRow(const StudyCase& studyCase, const std::string& key, vtkTable* row);

  /** A failure to write the files of a case, to be told before its row is added. From any thread.
   */
  void AddFailure(const StudyFailure& failure);

  /**
   * Makes the tables of the rows there are; cases without a row are left out. Called again when
   * there are more rows.
   */
  void Finish();

  ///@{
  /** After Finish(). */
  vtkTable* GetResults() const { return this->Results; }
  vtkTable* GetTimings() const { return this->Timings; }
  vtkTable* GetIndex() const { return this->Index; }
  const std::vector<StudyFailure>& GetFailures() const { return this->Failures; }
  ///@}

  /**
   * Writes results.csv, timings.csv, index.csv and, where something failed, failures.csv (an old
   * one goes otherwise); of these, with `indexOnly`, only the last two. Throws std::runtime_error.
   */
  void Write(const std::filesystem::path& folder, bool indexOnly) const;

  /**
   * Writes series.pvd over the meshes written as .vtp in the folder `meshes` below, by t where
   * nothing else is swept, else by index.
   */
  void WriteSeries(const std::filesystem::path& folder, const std::filesystem::path& meshes) const;

private:
  std::vector<StudyFailure> FailuresOf(const StudyCase& studyCase, vtkTable* row) const;
  vtkSmartPointer<vtkTable> FailureTable() const;

  std::vector<std::string> Runs;
  const std::vector<StudyCase>& Cases;
  StudyJournal& Journal;
  std::vector<StudyFailure> NotWritten;
  std::vector<StudyFailure> Failures;
  vtkSmartPointer<vtkTable> Results;
  vtkSmartPointer<vtkTable> Timings;
  vtkSmartPointer<vtkTable> Index;
  mutable std::mutex Mutex;
};

} // namespace pemesh

#endif
