// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMSeriesTable
 * @brief   Gathers the row of every time step of its input into one table.
 *
 * Input port 0 : vtkTable of one row (of vtkPEMMetricSummary), with or without time steps.
 * Output port 0: vtkTable of one row a time step, in the order of the steps: `Index` (0, 1, …),
 * then the columns of the input. Rows whose columns differ give the union of them; what a row does
 * not have is NaN or the empty text. Field data: the lists `Parameters` and `Measured` of all rows.
 * Time: asks its input for one step after the other, so that memory holds the rows and one mesh;
 *   the output has no time.
 * Abort, and an error upstream at any step: the output is empty, and the next update after
 *   Modified() starts from the first step. After an error the update fails.
 *
 * @sa vtkPEMMetricSummary vtkPEMCorrelation
 */
#ifndef vtkPEMSeriesTable_h
#define vtkPEMSeriesTable_h

#include "pemeshFiltersStatisticsModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <vector> // For the time steps

class PEMESHFILTERSSTATISTICS_EXPORT vtkPEMSeriesTable : public vtkTableAlgorithm
{
public:
  static vtkPEMSeriesTable* New();
  vtkTypeMacro(vtkPEMSeriesTable, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkPEMSeriesTable();
  ~vtkPEMSeriesTable() override;

  vtkExecutive* CreateDefaultExecutive() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkPEMSeriesTable(const vtkPEMSeriesTable&) = delete;
  void operator=(const vtkPEMSeriesTable&) = delete;

  class WalkPipeline;
  friend class WalkPipeline;

  /** Forgets a walk, whether it is done or was given up. */
  void Reset(vtkInformation* request);

  std::vector<double> TimeSteps;
  std::size_t CurrentStep = 0;
  vtkTable* Rows; // of the steps so far
};

#endif
