// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What the columns of a table of results are called in figures: the words and units of the tables
 * of metrics, statistics and groups (SummaryTitles.h) and of the solver descriptions.
 */
#ifndef pemesh_ColumnLabels_h
#define pemesh_ColumnLabels_h

#include "pemeshRunnerModule.h" // For export macro

#include <map>
#include <string>
#include <vector>

namespace pemesh
{

struct SolverDescription;
struct Study;

class PEMESHRUNNER_EXPORT ColumnLabels
{
public:
  /** Knows t, and all columns of vtkPEMMetricSummary. */
  ColumnLabels();

  /** Knows the performances of the runs of a study too. */
  ColumnLabels(const Study& study, const std::vector<SolverDescription>& solvers);

  /**
   * The title of a column or of an array of a mesh, with its unit: "smallest minimum angle MA
   * (rad)" for MinAngle_min. A name that is not known is its own title.
   */
  std::string Title(const std::string& column) const;

private:
  std::map<std::string, std::string> Titles;
};

} // namespace pemesh

#endif
