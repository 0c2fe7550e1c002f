// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The strongest relations between a metric and a performance, as sentences.
 */
#ifndef pemesh_Findings_h
#define pemesh_Findings_h

#include <string>
#include <vector>

class vtkTable;

namespace pemesh
{

class ColumnLabels;

struct Finding
{
  std::string X;
  std::string Y;
  double Strength = 0.0; ///< the absolute value of Spearman's coefficient
  std::string Sentence;
};

/**
 * Of a table of vtkPEMCorrelation (or null), strongest first; those between a metric and a
 * performance of a solver before those between two metrics, of which there are many by nature.
 */
std::vector<Finding> RankFindings(vtkTable* correlation, const ColumnLabels& labels);

} // namespace pemesh

#endif
