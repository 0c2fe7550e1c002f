// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The coefficients there are to choose from: what p-values, intervals, ranks and words go by.
 */
#ifndef pemesh_CoefficientKinds_h
#define pemesh_CoefficientKinds_h

#include "Significance.h"
#include "pemeshFiltersStatisticsModule.h" // For export macro

#include <span>
#include <string>
#include <vector>

namespace pemesh
{

struct CoefficientKind
{
  const char* Name;  // "spearman"
  const char* Label; // "Spearman"
  const char* Description;
  /** Whether it sees the order of the values alone: it is `Compute` of their ranks. */
  bool OfRanks;
  /** False for one that tells strength, but no direction. */
  bool HasSign;
  /** Whether `Compute` is Pearson's: a sum of products of what it is given. */
  bool IsPearson;
  /** Of samples without NaN; see the headers of the coefficients. */
  double (*Compute)(std::span<const double> x, std::span<const double> y);
  /** Its p-value for independent rows, or null where only arrangements give one. */
  PValue (*IndependentPValue)(std::span<const double> x, std::span<const double> y);
  /** With other samples held fixed, of ranks where the kind is of ranks. */
  double (*Partial)(std::span<const double> x, std::span<const double> y,
    const std::vector<std::vector<double>>& given);
};

PEMESHFILTERSSTATISTICS_EXPORT std::span<const CoefficientKind> CoefficientKinds();

/** Null where there is none of that name. */
PEMESHFILTERSSTATISTICS_EXPORT const CoefficientKind* FindCoefficientKind(const std::string& name);

/** The coefficient of two samples without NaN, ranked first where the kind asks for it. */
PEMESHFILTERSSTATISTICS_EXPORT double ComputeCoefficient(
  const CoefficientKind& kind, std::span<const double> x, std::span<const double> y);

/** The values as `Compute` wants them, NaN where they are NaN. */
PEMESHFILTERSSTATISTICS_EXPORT std::vector<double> PrepareSample(
  const CoefficientKind& kind, std::span<const double> sample);

/**
 * The coefficient of the rows where no sample is NaN, with the samples `given` held fixed where
 * there are any (see PartialCorrelation.h; of ranks, where the kind is of ranks).
 */
PEMESHFILTERSSTATISTICS_EXPORT double CoefficientGiven(const CoefficientKind& kind,
  std::span<const double> x, std::span<const double> y,
  const std::vector<std::span<const double>>& given);

} // namespace pemesh

#endif
