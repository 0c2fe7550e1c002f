// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMCorrelation
 * @brief   Correlates the columns of a table of meshes with each other.
 *
 * Input port 0 : vtkTable, one row a mesh (of vtkPEMSeriesTable, or a results table read back).
 * Output port 0: vtkTable, one row a pair of columns:
 *   `X`, `Y` names | `N` rows where neither is NaN | `Families` that these come from | `Pearson`,
 *   `Spearman`, `Kendall` (tau-b) in [-1, 1], `DistanceCorrelation` in [0, 1] | `Partial` in
 *   [-1, 1], given the columns named | `Coefficient` which of them is tested, `Tested` its value |
 *   `P` its two-sided p-value, `PHolm` and `PBenjaminiHochberg` corrected for all pairs of the
 *   table | `Low`, `High` its confidence interval | `Trend` | `Direction`, `Strength`, `Form`,
 *   `FormParameter` (slope, exponent or rate), `FormFit` (R^2) | `Words` all of these in words.
 *   Undefined is NaN (a constant column, fewer than two rows), and `Words` says why. Field data:
 *   the list `Performances` of the Y that are responses, not metrics; the texts `Rows` (one-family,
 *   families or independent), `FamilyColumn`, and `Note` on what p-values and intervals mean.
 *
 * Pairs: every X with every Y, a pair (a, b) once and never (a, a). By default X are the metrics,
 *   which are the numeric columns `<Metric>_<statistic>`, and Y the metrics and the performances,
 *   which are the other numeric columns of the form `<run>_<performance>` and those in the list
 *   `Performances` of the field data: each metric against each other, and each metric against each
 *   performance. Element ids (`_element`), histograms and the columns in the list `Measured` of the
 *   field data (seconds) take part only if named.
 *
 * Values: a column whose values differ by less than 1e-12 of their size has one value only; the
 * order of rounding errors says nothing.
 *
 * Rows: the meshes of one family deform one into the next. They are no sample, every pair of
 *   monotone quantities along it would be "significant", and there are neither p-values nor
 *   intervals. Where a column tells several families apart (FamilyColumn, or a column `Study`),
 *   whole families change places for p-values and are drawn for intervals. With IndependentRows
 *   p-values are those of independent rows: exact or from the limiting distribution where there is
 *   one, else by arrangements.
 *
 * `Trend` of Y as X grows, over the rows where both are defined:
 *   "undefined"   fewer than three rows
 *   "constant"    X or Y has one value only
 *   "increasing"  no two rows are ordered in opposite ways and some in the same way,
 *                 or tau-b >= TrendThreshold
 *   "decreasing"  the same with the order of Y reversed
 *   "mixed"       none of these
 *
 * Threads: the same bits for any number. Cost: O(n log n) a pair of columns with n rows, O(n) more
 * for each arrangement and sample.
 *
 * References: Correlation.h, DistanceCorrelation.h, PartialCorrelation.h, Significance.h,
 * FamilyTests.h, ManyTests.h, TrendForm.h.
 * @sa vtkPEMSeriesTable vtkPEMFindings
 */
#ifndef vtkPEMCorrelation_h
#define vtkPEMCorrelation_h

#include "pemeshFiltersStatisticsModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <string> // For column names
#include <vector> // For column names

namespace pemesh
{
struct PairOptions;
}

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
  /** Columns that are held fixed: the tested coefficient is partial. Default none. */
  void SetGivenColumns(const std::vector<std::string>& names);
  std::vector<std::string> GetGivenColumns() const;
  void AddGivenColumn(const std::string& name);
  void RemoveAllGivenColumns();
  ///@}

  ///@{
  /**
   * The coefficient that p-values, intervals, strength and words go by: "spearman" (default),
   * "pearson", "kendall" or "distance". Any other word is an error of the next update.
   */
  void SetCoefficient(const std::string& name);
  std::string GetCoefficient() const;
  ///@}

  ///@{
  /** Column whose values tell families of rows apart. Default empty: `Study`, if there is one. */
  void SetFamilyColumn(const std::string& name);
  std::string GetFamilyColumn() const;
  ///@}

  ///@{
  /** Whether rows are independent of each other, each a family of its own. Default off. */
  vtkSetMacro(IndependentRows, bool);
  vtkGetMacro(IndependentRows, bool);
  vtkBooleanMacro(IndependentRows, bool);
  ///@}

  ///@{
  /** Arrangements drawn where not all can be walked. Valid range [1, 10000000]. Default 999. */
  vtkSetClampMacro(Permutations, int, 1, 10000000);
  vtkGetMacro(Permutations, int);
  ///@}

  ///@{
  /** Samples drawn for confidence intervals; 0: none. Valid range [0, 10000000]. Default 0. */
  vtkSetClampMacro(Bootstrap, int, 0, 10000000);
  vtkGetMacro(Bootstrap, int);
  ///@}

  ///@{
  /** Confidence level of the intervals. Valid range [0.5, 0.9999]. Default 0.95. */
  vtkSetClampMacro(ConfidenceLevel, double, 0.5, 0.9999);
  vtkGetMacro(ConfidenceLevel, double);
  ///@}

  ///@{
  /** Seed of the arrangements and samples drawn. Valid range [0, 2147483647]. Default 1. */
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

  /** Empty if the options fit the table, else one sentence. */
  std::string WhyUnusable(vtkTable* table) const;
  std::string FamilyColumnOf(vtkTable* table) const;
  pemesh::PairOptions MakeOptions(vtkTable* table, const std::string& familyColumn) const;
  void SetNames(std::vector<std::string>& member, const std::vector<std::string>& names);

  std::vector<std::string> XColumns;
  std::vector<std::string> YColumns;
  std::vector<std::string> GivenColumns;
  std::string Coefficient = "spearman";
  std::string FamilyColumn;
  bool IndependentRows = false;
  int Permutations = 999;
  int Bootstrap = 0;
  double ConfidenceLevel = 0.95;
  int Seed = 1;
  double TrendThreshold = 0.7;
};

#endif
