// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The keys of the study document. To add a key: a member in Study.h, and an entry in the table of
 * the object that it belongs to.
 */
#ifndef pemesh_StudyFields_h
#define pemesh_StudyFields_h

#include "DocumentFields.h"
#include "Study.h"

namespace pemesh
{

/** The version of the document that is read and written. */
inline constexpr int StudyVersion = 1;

/** Bound on the number of cases, to tell a slip from a study. */
inline constexpr int MostCases = 10'000'000;

/** The whole document. */
const FieldTable<Study>& StudyFields();

///@{
/** Its larger parts. */
const FieldTable<StudyPolygon>& PolygonFields();
Field<Study> PolygonsField();
Field<Study> ScatterField();
Field<Study> MetricsField();
FieldTable<StudyScatter> ScatterFields();
FieldTable<StudySweep> SweepFields();
FieldTable<StudyDomain> DomainFields();
FieldTable<StudyMesh> MeshFields();
FieldTable<StudySolver> SolverFields();
FieldTable<StudyStatistics> StatisticsFields();
FieldTable<StudyPlot> PlotFields();
Field<Study> StudyStyleField();
///@}

/**
 * A run without a name is called after its solver; a second one solver-k2, after its order; where
 * that is taken too or there is no order, solver-2, solver-3, …
 */
void NameRuns(const DocumentPlace& place, Study& study);

/** Stands for the sweep of a document that names none: FinishSweeps decides whether there is one.
 */
StudySweep UndecidedSweep();

/**
 * Names the columns of the sweeps, and refuses those that do not go together. By default t is
 * swept if a polygon changes with it.
 */
void FinishSweeps(const DocumentPlace& place, Study& study);

/** Fills in the x axes and the file names that are not given. */
void FinishPlots(const DocumentPlace& place, Study& study);

/** Fails unless the text can be the name of a file or folder inside another. */
void CheckFileName(const DocumentPlace& place, const std::string& name);

/** The names of a table of things. */
template <typename Table>
std::vector<std::string> NamesOf(const Table& table)
{
  std::vector<std::string> names;
  for (const auto& entry : table)
  {
    names.emplace_back(entry.Name);
  }
  return names;
}

} // namespace pemesh

#endif
