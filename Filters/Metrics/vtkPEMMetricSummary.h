// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMMetricSummary
 * @brief   One row that tells all about a mesh: parameters, size, metrics, performances, status.
 *
 * Input port 0 : vtkPolyData, a mesh, measured (vtkPEMMetrics) and perhaps solved.
 * Output port 0: vtkTable of one row, always, with the columns
 *   Mesh [text] its name; each parameter of the case (field list "Parameters");
 *   the numbers of the whole mesh (MeshMetrics.h);
 *   for each metric and each group of elements (ValueStatistics.h) the statistics
 *   `<Name>_<statistic><group>`, over the elements where the metric is finite, NaN where there
 *   are none, with `<Name>_min_element<group>` and `<Name>_max_element<group>`, the least id of an
 *   element that attains it, -1 where there are none; then quantiles `<Name>_q0.05<group>`, and the
 *   histogram, `<Name>_bin1<group>` and so on, numbers of elements in equal parts of the range from
 *   min to max, of which the last includes its end. Of all elements the group is empty, of others
 *   "_placed", "_filler", "_triangles", "_polygons", "_selected";
 *   every other field array of one number, and the texts named *_Status and *_StatusMessage;
 *   Status ("ok" or a word) and StatusMessage [text].
 *   Field data: the lists "Parameters" and "Measured" of the mesh.
 * A failed mesh, or one that was never measured, has the same columns, with NaN.
 * Means are summed in the order of the elements with compensation: the same bits every time, with
 * any number of threads.
 *
 * @sa vtkPEMMetrics vtkPEMSeriesTable
 */
#ifndef vtkPEMMetricSummary_h
#define vtkPEMMetricSummary_h

#include "pemeshFiltersMetricsModule.h" // For export macro
#include <vtkTableAlgorithm.h>

#include <string> // For arguments
#include <vector> // For arguments

namespace pemesh
{
struct NamesTaken;
}

class PEMESHFILTERSMETRICS_EXPORT vtkPEMMetricSummary : public vtkTableAlgorithm
{
public:
  static vtkPEMMetricSummary* New();
  vtkTypeMacro(vtkPEMMetricSummary, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The metrics that get columns, named as in vtkPEMMetrics. Default: "all". Columns are in the
   * order of the registry whatever the order here. Choose the same as in vtkPEMMetrics. A name that
   * is unknown is an error that tells the nearest known one, and changes nothing.
   */
  void SetMetrics(const std::vector<std::string>& names);
  void AddMetric(const std::string& name);
  void RemoveAllMetrics();
  void SelectAllMetrics();
  std::vector<std::string> GetMetrics() const;
  ///@}

  ///@{
  /**
   * The numbers of the whole mesh that get columns, by name, in the order given; "all" stands for
   * all of MeshMetrics.h, "usual" (the default) for all but those made of a metric that is neither
   * chosen nor cheap (MeshRho without VEMIndicator). Those made of a metric that was not measured
   * measure it. GetMeshMetrics tells what the words stand for.
   */
  void SetMeshMetrics(const std::vector<std::string>& names);
  std::vector<std::string> GetMeshMetrics() const;
  ///@}

  ///@{
  /**
   * The statistics of each metric: "min", "max", "mean" (the default), "standard-deviation",
   * "area-mean", "undefined". A name that is unknown is an error, and changes nothing.
   */
  void SetStatistics(const std::vector<std::string>& names);
  std::vector<std::string> GetStatistics() const { return this->Statistics; }
  ///@}

  ///@{
  /**
   * The groups of elements they are taken over: "all" (the default), "triangles", "polygons",
   * "placed", "filler", "selected". A name that is unknown is an error, and changes nothing.
   */
  void SetGroups(const std::vector<std::string>& names);
  std::vector<std::string> GetGroups() const { return this->Groups; }
  ///@}

  ///@{
  /** Quantiles of each metric, as fractions in [0, 1]; linear between values. Default: none. */
  void SetQuantiles(const std::vector<double>& fractions);
  std::vector<double> GetQuantiles() const { return this->Quantiles; }
  ///@}

  ///@{
  /** Bins of the histogram of each metric, clamped to [0, 10000]. Default: 0, no histogram. */
  void SetHistogramBins(int bins);
  vtkGetMacro(HistogramBins, int);
  ///@}

  ///@{
  /**
   * The elements of the group "selected": those where a metric or a cell array is in a range,
   * "MinAngle:0.1:0.5" (ElementSelection.h), or those where a cell array is not zero, by its name.
   * A metric that the mesh lacks is measured. A mesh that has no such array has the status
   * "no-such-array". Default: none. A text that is neither is an error, and changes nothing.
   */
  void SetSelection(const std::string& text);
  std::string GetSelection() const { return this->Selection; }
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

  void Report(const pemesh::NamesTaken& taken);
  std::vector<std::string> FindBaseMetrics(const std::string& selected) const;

  std::vector<std::string> Metrics;
  std::vector<std::string> MeshMetrics = { "usual" };
  std::vector<std::string> Statistics = { "min", "max", "mean" };
  std::vector<std::string> Groups = { "all" };
  std::vector<double> Quantiles;
  int HistogramBins = 0;
  std::string Selection;
};

#endif
