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
  std::vector<double> Performances;            // in the order of the description
  /** In the order of the description; null where the solver has not written one. */
  std::vector<vtkSmartPointer<vtkDoubleArray>> Elements;
};

/** The files that the contract names for `stem`, whether they exist or not. */
std::vector<std::filesystem::path> SolverAnswerFiles(const SolverDescription& description,
  const std::filesystem::path& folder, const std::string& stem);

/** Throws std::runtime_error naming the file and what is wrong with it. */
SolverAnswer ReadSolverAnswer(const SolverDescription& description,
  const std::filesystem::path& folder, const std::string& stem, vtkIdType vertices,
  vtkIdType elements);

} // namespace pemesh

#endif
