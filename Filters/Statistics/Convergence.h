// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Observed orders of convergence: how errors fall with the size of the mesh.
 */
#ifndef pemesh_Convergence_h
#define pemesh_Convergence_h

#include "pemeshFiltersStatisticsModule.h" // For export macro

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pemesh
{

/** Errors of meshes and the orders p in error = C size^p. Undefined is NaN. */
struct ConvergenceColumn
{
  std::string Name;
  std::vector<double> Errors;
  std::vector<double> Orders; ///< of a mesh and the one before it; of the first NaN
  double Order = 0.0;         ///< of all: the slope of least squares in logarithms
  double StandardError = 0.0; ///< of Order; NaN for fewer than three meshes
};

struct ConvergenceTable
{
  std::string SizeName;
  std::vector<double> Sizes; ///< from the coarsest mesh to the finest
  std::vector<ConvergenceColumn> Columns;
};

/** Errors by name, one a mesh, in the order of the sizes. */
struct ErrorColumn
{
  std::string Name;
  std::vector<double> Errors;
};

/**
 * Sorts the meshes from coarse to fine and finds the orders. Meshes whose size is not a positive
 * number are left out; errors that are not positive numbers have no order and do not enter the fit.
 */
PEMESHFILTERSSTATISTICS_EXPORT ConvergenceTable MakeConvergenceTable(const std::string& sizeName,
  std::span<const double> sizes, const std::vector<ErrorColumn>& errors);

/** A text that can be pasted: one entry of the table of formats is one. */
struct ConvergenceFormat
{
  const char* Name; ///< "csv", "markdown", "latex"
  const char* Description;
  std::string (*Format)(const ConvergenceTable& table);
};

PEMESHFILTERSSTATISTICS_EXPORT std::span<const ConvergenceFormat> ConvergenceFormats();

/** Null where there is none of this name. */
PEMESHFILTERSSTATISTICS_EXPORT const ConvergenceFormat* FindConvergenceFormat(
  std::string_view name);

} // namespace pemesh

#endif
