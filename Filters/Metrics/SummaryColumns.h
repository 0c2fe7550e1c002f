// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The columns of the row that vtkPEMMetricSummary makes of a mesh.
 */
#ifndef pemesh_SummaryColumns_h
#define pemesh_SummaryColumns_h

#include "ValueStatistics.h"

#include <span>
#include <string>
#include <vector>

class vtkPolyData;
class vtkTable;

namespace pemesh
{

class MeshValues;
struct Metric;

/** What is told of the values of a metric. */
struct SummaryChoice
{
  std::vector<const Statistic*> Statistics;
  std::vector<const ElementGroup*> Groups;
  std::vector<std::vector<unsigned char>> Members; // a group each; empty for all elements
  std::vector<double> Quantiles;
  int Bins = 0;
  std::span<const double> Areas;
};

void AddText(vtkTable* table, const std::string& name, const std::string& value);

/** The parameters of the case: what it varies. */
void AddParameterColumns(vtkTable* table, vtkPolyData* mesh);

/** The numbers of the whole mesh of these names; `metrics` are those whose undefined values count.
 */
void AddMeshColumns(vtkTable* table, vtkPolyData* mesh, MeshValues& values,
  const std::vector<std::string>& names, const std::vector<const Metric*>& metrics);

/** Each metric by itself, so that threads change nothing. */
void AddMetricColumns(vtkTable* table, vtkPolyData* mesh, const MeshValues& values,
  const std::vector<const Metric*>& metrics, const SummaryChoice& choice);

/** Provenance and performances: numbers, and what the runs say of themselves. */
void AddOtherFieldColumns(vtkTable* table, vtkPolyData* mesh);

/** Keeps a list of names (see CaseStatus.h) with the row. */
void CopyList(vtkTable* table, vtkPolyData* mesh, const char* list);

} // namespace pemesh

#endif
