// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyFindings.h"

#include "CsvTable.h"
#include "ErrorText.h"
#include "Study.h"
#include "TextFile.h"
#include "vtkPEMCorrelation.h"
#include "vtkPEMFindings.h"

#include <stdexcept>

#include <vtkNew.h>
#include <vtkTable.h>

namespace pemesh
{

vtkSmartPointer<vtkTable> WriteFindings(
  const StudyStatistics& statistics, vtkTable* results, const std::filesystem::path& folder)
{
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(results);
  correlation->SetCoefficient(statistics.Coefficient);
  correlation->SetGivenColumns(statistics.Given);
  correlation->SetFamilyColumn(statistics.Family);
  correlation->SetIndependentRows(statistics.IndependentRows);
  correlation->SetPermutations(statistics.Permutations);
  correlation->SetBootstrap(statistics.Bootstrap);
  correlation->SetConfidenceLevel(statistics.Level);
  correlation->SetSeed(statistics.Seed);
  vtkNew<vtkPEMFindings> findings;
  findings->SetInputConnection(0, correlation->GetOutputPort());
  findings->SetInputData(1, results);
  for (vtkAlgorithm* step :
    { static_cast<vtkAlgorithm*>(correlation.Get()), static_cast<vtkAlgorithm*>(findings.Get()) })
  {
    if (const std::string reason = UpdateExplaining(step); !reason.empty())
    {
      throw std::runtime_error("There is no correlation of the results: " + reason);
    }
  }
  const vtkSmartPointer<vtkTable> pairs = correlation->GetOutput();
  WriteCsvFile(folder / "correlation.csv", pairs);
  WriteCsvFile(folder / "findings.csv", findings->GetOutput());
  WriteTextFile(folder / "findings.txt", findings->GetText());
  return pairs;
}

} // namespace pemesh
