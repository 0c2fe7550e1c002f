// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What the results of a study have to say: correlation, and metrics ranked for each performance.
 */
#ifndef pemesh_StudyFindings_h
#define pemesh_StudyFindings_h

#include "pemeshRunnerModule.h" // For export macro

#include <filesystem>

#include <vtkSmartPointer.h> // For return type

class vtkTable;

namespace pemesh
{

struct StudyStatistics;

/**
 * Writes correlation.csv, findings.csv and findings.txt into the folder and returns the table of
 * pairs. Throws std::runtime_error with one sentence where the options do not fit the results.
 */
PEMESHRUNNER_EXPORT vtkSmartPointer<vtkTable> WriteFindings(
  const StudyStatistics& statistics, vtkTable* results, const std::filesystem::path& folder);

} // namespace pemesh

#endif
