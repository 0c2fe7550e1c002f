// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The figures of a study: what its `plots` ask for, made from the table of results and the few
 * meshes that they show.
 */
#ifndef pemesh_StudyFigures_h
#define pemesh_StudyFigures_h

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <vtkSmartPointer.h> // For the meshes kept

class vtkPEMChart;
class vtkPEMFigure;
class vtkPolyData;
class vtkTable;

namespace pemesh
{

class ColumnLabels;
struct SolverDescription;
struct Study;
struct StudyCase;
struct StudyPlot;

class StudyFigures
{
public:
  StudyFigures(const Study& study, const std::vector<SolverDescription>& solvers,
    const std::vector<StudyCase>& cases);
  ~StudyFigures();

  /** Whether a figure will show the mesh of a case. */
  bool Shows(const StudyCase& studyCase) const;

  /** Keeps the mesh of a case if a figure will show it. May be called from any thread. */
  void KeepMesh(const StudyCase& studyCase, vtkPolyData* mesh);

  /**
   * Writes every figure into `folder`, and adds the files to `files`. Answers with a sentence for
   * every figure that could not be made; the others are.
   */
  std::vector<std::string> Write(
    const std::filesystem::path& folder, vtkTable* results, std::vector<std::string>& files);

private:
  void WriteOne(const StudyPlot& plot, const std::filesystem::path& file, vtkTable* results);
  /** Mesh, metric, solution and correlation on one page. */
  void AddOverview(
    const StudyPlot& plot, vtkPEMFigure* figure, vtkTable* results, const ColumnLabels& labels);
  vtkPolyData* FindMesh(int number) const;
  /** The elements of the meshes that a plot shows, as a table. */
  vtkSmartPointer<vtkTable> MakeElements(const StudyPlot& plot) const;
  vtkSmartPointer<vtkPEMChart> MakeChart(
    const StudyPlot& plot, vtkTable* results, const ColumnLabels& labels) const;

  const Study& TheStudy;
  const std::vector<SolverDescription>& Solvers;
  const std::vector<StudyCase>& Cases;
  std::map<int, vtkSmartPointer<vtkPolyData>> Meshes;
  std::mutex Mutex;
};

} // namespace pemesh

#endif
