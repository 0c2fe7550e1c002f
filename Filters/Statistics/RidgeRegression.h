// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Several quantities together as predictors of another one.
 */
#ifndef pemesh_RidgeRegression_h
#define pemesh_RidgeRegression_h

#include "RowFamilies.h"
#include "pemeshFiltersStatisticsModule.h" // For export macro

#include <span>
#include <string>
#include <vector>

namespace pemesh
{

struct RidgeModel
{
  /** Empty if there is a model, else one sentence that says why not and what to do. */
  std::string Refusal;
  /** The change of the response, in its standard deviations, for one of the predictor's. */
  std::vector<double> Weights;
  /** The penalty chosen, as a multiple of the number of rows. */
  double Penalty = 0.0;
  /**
   * 1 - (squared errors of rows predicted without their family) / (those of the mean of the other
   * families): 1 perfect, 0 no better than the mean, negative worse. At most 1.
   */
  double PredictedShare = 0.0;
  std::size_t Rows = 0;
};

/** Rows a predictor below which a model is refused. */
inline constexpr std::size_t RowsPerPredictor = 3;

/**
 * Ridge regression of `response` on `predictors`, all standardised, with a constant that is not
 * penalised. The penalty is that of a grid, from 1e-8 to 1e3 times the number of rows, which
 * predicts families best from the others (of equals the largest); the errors of left-out families
 * follow from the hat matrix without refitting. All values finite, no predictor constant.
 *
 * References: A. E. Hoerl, R. W. Kennard, Ridge regression: biased estimation for nonorthogonal
 * problems, Technometrics 12 (1970) 55-67; leaving out groups: R. D. Cook, S. Weisberg, Residuals
 * and Influence in Regression, Chapman and Hall 1982, section 3.6.
 */
PEMESHFILTERSSTATISTICS_EXPORT RidgeModel FitRidge(
  const std::vector<std::vector<double>>& predictors, std::span<const double> response,
  const RowFamilies& families);

} // namespace pemesh

#endif
