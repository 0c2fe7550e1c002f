// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What the folder of a study's results holds, read back. What is missing is empty, and a sentence
 * says so.
 */
#ifndef pemesh_ReportContents_h
#define pemesh_ReportContents_h

#include "ChartStyle.h"
#include "ColumnLabels.h"
#include "SolverDescription.h"
#include "Study.h"

#include <filesystem>
#include <string>
#include <vector>

#include <vtkSmartPointer.h> // For the tables

class vtkPolyData;
class vtkTable;

namespace pemesh
{

struct ShownMesh
{
  std::string Name;
  std::string Place; // "First", "Middle", "Last"
  vtkSmartPointer<vtkPolyData> Mesh;
};

/** A performance, and the columns of all runs of solvers that have it. */
struct ReportMeasure
{
  std::string Title;
  std::vector<std::string> Columns;
  std::vector<std::string> Runs; // the name of the run of each; empty where it is none's
};

struct ReportContents
{
  std::filesystem::path Folder;
  Study TheStudy;
  std::string Document; // study.json as it is
  std::vector<SolverDescription> Solvers;
  ColumnLabels Labels;
  vtkSmartPointer<vtkTable> Results;
  vtkSmartPointer<vtkTable> Findings; // may be null
  vtkSmartPointer<vtkTable> Failures; // null where nothing failed
  std::string Note;                   // on what p-values and intervals mean; may be empty
  std::vector<ShownMesh> Meshes;
  ChartStyle Style;                 // of the figures, as the study asks
  std::vector<std::string> Remarks; // what could not be shown, and why

  /** The column that the meshes vary by, for abscissae. */
  std::string Abscissa() const;
  /** The column that colours points: the families, where the study tells them apart. */
  std::string ColorColumn() const;
  std::vector<std::string> Performances() const;
  /** The performances by what they measure, in the order of the columns. */
  std::vector<ReportMeasure> Measures() const;
  /** Whether the description of a solver says so. */
  bool IsLogarithmic(const std::string& performance) const;
};

/** Throws std::runtime_error with one sentence where the folder holds no results of a study. */
ReportContents ReadReportContents(const std::filesystem::path& folder);

} // namespace pemesh

#endif
