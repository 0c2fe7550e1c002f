// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMMetricSummary
 * @brief   One row that tells all about a mesh: parameters, size, metrics, performances, status.
 *
 * Input port 0 : vtkPolyData, a mesh, measured (vtkPEMMetrics) and perhaps solved.
 * Output port 0: vtkTable of one row, always, with the columns
 *   Mesh [text] its name; each parameter of the case (field list "Parameters");
 *   Elements, Vertices [ids]; MeshSize [length] the largest diameter;
 *   for each metric <Name>_min, <Name>_max, <Name>_mean over the elements where it is finite, NaN
 *   where there are none, and <Name>_min_element, <Name>_max_element, the smallest id of an
 *   element that attains it, -1 where there are none;
 *   every other field array of one number, and the texts named *_Status and *_StatusMessage;
 *   Status ("ok" or a word) and StatusMessage [text].
 *   Field data: the lists "Parameters" and "Measured" of the mesh.
 * A failed mesh, or one that was never measured, has the same columns, with NaN.
 * The mean is summed in the order of the elements with compensation: the same bits every time.
 *
 * @sa vtkPEMMetrics vtkPEMSeriesTable
 */
#ifndef vtkPEMMetricSummary_h
#define vtkPEMMetricSummary_h

#include "pemeshFiltersMetricsModule.h" // For export macro
#include <vtkTableAlgorithm.h>

#include <string> // For arguments
#include <vector> // For arguments

class PEMESHFILTERSMETRICS_EXPORT vtkPEMMetricSummary : public vtkTableAlgorithm
{
public:
  static vtkPEMMetricSummary* New();
  vtkTypeMacro(vtkPEMMetricSummary, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The metrics that get columns, by name. Default: all of the registry. Columns are in the order
   * of the registry whatever the order here. Choose the same as in vtkPEMMetrics. A name that is
   * unknown is an error that tells the nearest known one, and changes nothing.
   */
  void SetMetrics(const std::vector<std::string>& names);
  void AddMetric(const std::string& name);
  void RemoveAllMetrics();
  void SelectAllMetrics();
  std::vector<std::string> GetMetrics() const;
  ///@}

protected:
  vtkPEMMetricSummary();
  ~vtkPEMMetricSummary() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPEMMetricSummary(const vtkPEMMetricSummary&) = delete;
  void operator=(const vtkPEMMetricSummary&) = delete;

  std::vector<std::string> Metrics;
};

#endif
