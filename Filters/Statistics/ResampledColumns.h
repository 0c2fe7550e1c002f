// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Coefficients of many pairs of columns in one sample of their rows after the other. Private to
 * this module.
 *
 * What a sample does to a column (its ranks, what regression leaves of it) is found once for all
 * pairs that the column is in; a pair then costs one sum of products.
 */
#ifndef pemesh_ResampledColumns_h
#define pemesh_ResampledColumns_h

#include "FamilyTests.h"

#include <span>
#include <vector>

namespace pemesh
{

class ResampledColumns
{
public:
  /** Of some of the pairs, in the rows where all their columns and the given ones have values. */
  ResampledColumns(const PairsOfColumns& all, const CoefficientKind& kind,
    std::span<const std::size_t> rows, std::span<const std::size_t> pairs);

  /**
   * The coefficients of a sample that holds row i of the table times[i] times: that of pair k goes
   * to values[k * samples + sample], NaN where it has none. May be called from several threads.
   */
  void Evaluate(const std::vector<int>& times, std::size_t sample, std::size_t samples,
    std::vector<double>& values) const;

private:
  struct Column
  {
    std::vector<double> Values;     // in the rows
    std::vector<std::size_t> Order; // of the rows by their values
  };
  struct Drawn;

  std::size_t AddColumn(const std::vector<double>& column);
  void EvaluateProducts(const std::vector<int>& times, std::size_t sample, std::size_t samples,
    std::vector<double>& values) const;
  void EvaluateEach(const std::vector<int>& times, std::size_t sample, std::size_t samples,
    std::vector<double>& values) const;
  void PrepareColumn(std::size_t column, Drawn& drawn) const;
  void PrepareGiven(Drawn& drawn) const;

  const CoefficientKind& Kind;
  std::vector<std::size_t> Rows; // of the table
  std::vector<Column> Columns;
  std::vector<std::pair<std::size_t, std::size_t>> Pairs; // of Columns
  std::vector<std::size_t> Given;                         // of Columns
};

} // namespace pemesh

#endif
