// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The form of the relation of two quantities: a straight line, a power law, an exponential, or
 * monotone without being one of these.
 */
#ifndef pemesh_TrendForm_h
#define pemesh_TrendForm_h

#include "pemeshFiltersStatisticsModule.h" // For export macro

#include <span>
#include <string>

namespace pemesh
{

struct TrendForm
{
  /** A name of FormKinds(), "monotone", "none", or "undefined". */
  std::string Name = "undefined";
  /** Of the kind: slope dy/dx, exponent p of x^p, or rate r of exp(r x); NaN without a kind. */
  double Parameter;
  /** R^2 in [0, 1] of the line in the scales of the kind; NaN without a kind. */
  double Fit;
};

/**
 * Of the forms whose logarithms exist (all values positive) and whose R^2 is at least 0.9, the one
 * that FitBestCurve takes. Where there is none the relation is
 * "monotone" if no two pairs contradict each other or |Spearman| >= 0.7, else "none". "undefined"
 * for fewer than three pairs, a constant sample and infinite values. Samples hold no NaN.
 */
PEMESHFILTERSSTATISTICS_EXPORT TrendForm FindTrendForm(
  std::span<const double> x, std::span<const double> y);

/** R^2 from which on a form is named, and from which on without "close to". */
inline constexpr double NamedFit = 0.9;
inline constexpr double ExactFit = 0.99;

} // namespace pemesh

#endif
