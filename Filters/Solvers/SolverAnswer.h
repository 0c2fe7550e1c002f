// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The files that a solver leaves, read and checked against the contract.
 */
#ifndef pemesh_SolverAnswer_h
#define pemesh_SolverAnswer_h

#include <filesystem>
#include <string>
#include <vector>

#include <vtkDoubleArray.h>  // For the arrays
#include <vtkSmartPointer.h> // For the arrays

namespace pemesh
{

struct SolverDescription;

struct SolverAnswer
{
  vtkSmartPointer<vtkDoubleArray> Solution;
  vtkSmartPointer<vtkDoubleArray> GroundTruth; // null where the solver does not know it
  std::vector<double> Performances;            // in the order of the description; NaN if missing
  std::vector<std::string> Faults;             // a sentence for every file that is no good
  /** In the order of the description; null where the solver has not written one. */
  std::vector<vtkSmartPointer<vtkDoubleArray>> Elements;
};

/** The files that the contract names for `stem`, whether they exist or not. */
std::vector<std::filesystem::path> SolverAnswerFiles(const SolverDescription& description,
  const std::filesystem::path& folder, const std::string& stem);

/** Takes all that is good and says in the faults what is not. */
SolverAnswer ReadSolverAnswer(const SolverDescription& description,
  const std::filesystem::path& folder, const std::string& stem, vtkIdType vertices,
  vtkIdType elements);

} // namespace pemesh

#endif
