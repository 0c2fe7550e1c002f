// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What the columns of a table of results are called in figures: the labels and units of the metric
 * registry and of the solver descriptions.
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
  /** Knows the metrics, the sizes of a mesh and t. */
  ColumnLabels();

  /** Knows the performances of the runs of a study too. */
  ColumnLabels(const Study& study, const std::vector<SolverDescription>& solvers);

  /**
   * The title of a column or of an array of a mesh, with its unit: "smallest minimum angle (rad)"
   * for MinAngle_min. A name that is not known is its own title.
   */
  std::string Title(const std::string& column) const;

private:
  std::map<std::string, std::string> Titles;
};

} // namespace pemesh

#endif
