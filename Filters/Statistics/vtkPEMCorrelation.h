// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMCorrelation
 * @brief   Correlates the columns of a table of meshes with each other.
 *
 * Input port 0 : vtkTable, one row a mesh (of vtkPEMSeriesTable, or a results table read back).
 * Output port 0: vtkTable, one row a pair of columns:
 *   `X`, `Y` names | `N` rows where neither is NaN | `Pearson`, `Spearman`, `Kendall` (tau-b) in
 *   [-1, 1] | `PearsonP`, `SpearmanP`, `KendallP` two-sided p-values | `Trend` | `Note` on what the
 *   p-values assume. Undefined is NaN (a constant column, fewer than two rows).
 *
 * Pairs: every X with every Y, a pair (a, b) once and never (a, a). By default X are the metrics,
 *   which are the numeric columns whose name ends in _min, _max or _mean, and Y the metrics and the
 *   performances, which are the other numeric columns of the form <run>_<performance>: each metric
 *   against each other, and each metric against each performance. Element ids (`_element`) and the
 *   columns in the list `Measured` of the field data (seconds) take part only if named.
 *
 * p-values assume that rows are independent of each other, and are given only if IndependentRows is
 *   on. The meshes of one family deform one into the next, every pair of monotone quantities along
 *   it is "significant", and a p-value would mean nothing: there the trend alone may be claimed.
 *
 * `Trend` of Y as X grows, over the rows where both are defined:
 *   "undefined"   fewer than three rows
 *   "constant"    X or Y has one value only
 *   "increasing"  no two rows are ordered in opposite ways and some in the same way,
 *                 or tau-b >= TrendThreshold
 *   "decreasing"  the same with the order of Y reversed
 *   "mixed"       none of these
 *
 * Cost: O(n log n) a pair of columns with n rows.
 *
 * References: coefficients in Correlation.h, p-values in Significance.h.
 * @sa vtkPEMSeriesTable
 */
#ifndef vtkPEMCorrelation_h
#define vtkPEMCorrelation_h

#include "pemeshFiltersStatisticsModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <string> // For column names
#include <vector> // For column names

class PEMESHFILTERSSTATISTICS_EXPORT vtkPEMCorrelation : public vtkTableAlgorithm
{
public:
  static vtkPEMCorrelation* New();
  vtkTypeMacro(vtkPEMCorrelation, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Columns to correlate. Default none named: all metrics. */
  void SetXColumns(const std::vector<std::string>& names);
  std::vector<std::string> GetXColumns() const;
  void AddXColumn(const std::string& name);
  void RemoveAllXColumns();
  ///@}

  ///@{
  /** Columns to correlate them with. Default none named: all metrics and performances. */
  void SetYColumns(const std::vector<std::string>& names);
  std::vector<std::string> GetYColumns() const;
  void AddYColumn(const std::string& name);
  void RemoveAllYColumns();
  ///@}

  ///@{
  /** Whether rows are independent of each other, so that p-values mean something. Default off. */
  vtkSetMacro(IndependentRows, bool);
  vtkGetMacro(IndependentRows, bool);
  vtkBooleanMacro(IndependentRows, bool);
  ///@}

  ///@{
  /**
   * Arrangements drawn for the p-value of a rank coefficient where the exact one is out of reach;
   * 0 uses the limiting distribution. Valid range [0, 10000000]. Default 0.
   */
  vtkSetClampMacro(Permutations, int, 0, 10000000);
  vtkGetMacro(Permutations, int);
  ///@}

  ///@{
  /** Seed of the arrangements drawn. Valid range [0, 2147483647]. Default 1. */
  vtkSetClampMacro(Seed, int, 0, 2147483647);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * The tau-b from which on a trend is called increasing or decreasing. Without ties, 0.7 means
   * that 85 % of the pairs of meshes agree. Valid range [0, 1]. Default 0.7.
   */
  vtkSetClampMacro(TrendThreshold, double, 0.0, 1.0);
  vtkGetMacro(TrendThreshold, double);
  ///@}

protected:
  vtkPEMCorrelation() = default;
  ~vtkPEMCorrelation() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkPEMCorrelation(const vtkPEMCorrelation&) = delete;
  void operator=(const vtkPEMCorrelation&) = delete;

  /** Empty if all are numeric columns of the table, else one sentence. */
  static std::string WhyUnusable(vtkTable* table, const std::vector<std::string>& names);

  std::vector<std::string> XColumns;
  std::vector<std::string> YColumns;
  bool IndependentRows = false;
  int Permutations = 0;
  int Seed = 1;
  double TrendThreshold = 0.7;
};

#endif
