// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Rows that belong together, and how whole families of them change places.
 */
#ifndef pemesh_RowFamilies_h
#define pemesh_RowFamilies_h

#include "pemeshFiltersStatisticsModule.h" // For export macro

#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace pemesh
{

/** The rows of each family, in the order of the table. */
using RowFamilies = std::vector<std::vector<std::size_t>>;

/** Rows with the same label are a family; in the order of the first row of each. */
PEMESHFILTERSSTATISTICS_EXPORT RowFamilies GroupRows(std::span<const std::string> labels);

/** Every row a family of its own: rows that are independent of each other. */
PEMESHFILTERSSTATISTICS_EXPORT RowFamilies SingleRows(std::size_t rows);

/**
 * The arrangements of a permutation test that respects families: whole families change places, row
 * by row, and only with families of the same number of rows. If there are at most `most` + 1 of
 * them they are all walked, each once and the given one first; else `most` are drawn.
 *
 * Reference: A. M. Winkler, M. A. Webster, D. Vidaurre, T. E. Nichols, S. M. Smith, Multi-level
 * block permutation, NeuroImage 123 (2015) 253-268, doi:10.1016/j.neuroimage.2015.05.092.
 */
class PEMESHFILTERSSTATISTICS_EXPORT FamilyShuffle
{
public:
  FamilyShuffle(const RowFamilies& families, int most, std::uint64_t seed);

  /** How many arrangements there are besides the given one that Next() gives: 0 where none is. */
  int GetCount() const { return this->Count; }
  bool IsExact() const { return this->Exact; }

  /** rows[i] is the row whose value comes to row i. Rows of no family stay. False at the end. */
  bool Next(std::vector<std::size_t>& rows);

private:
  bool Advance();
  void Draw();

  const RowFamilies& Families;
  std::vector<std::vector<std::size_t>> Classes; // families of equal length
  std::vector<std::vector<std::size_t>> Places;  // which of the class comes to each of its places
  std::mt19937_64 Bits;
  int Count = 0;
  int Given = 0;
  bool Exact = false;
};

/** How often each row is in a sample drawn of whole families, with replacement. */
PEMESHFILTERSSTATISTICS_EXPORT std::vector<int> DrawFamilies(
  const RowFamilies& families, std::size_t rows, std::mt19937_64& bits);

} // namespace pemesh

#endif
