// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * How a sample is distributed: quantiles, boxes, bins, densities. Samples hold finite values only.
 */
#ifndef pemesh_Distribution_h
#define pemesh_Distribution_h

#include "pemeshFiltersStatisticsModule.h" // For export macro

#include <span>
#include <vector>

namespace pemesh
{

/**
 * Quantile of a sorted sample for a probability in [0, 1], linear between the values at
 * (i - 1) / (n - 1): type 7 of Hyndman and Fan, the default of R and NumPy. NaN if empty.
 *
 * Reference: R. J. Hyndman and Y. Fan, Sample quantiles in statistical packages, Am. Stat. 50
 * (1996) 361-365, doi:10.1080/00031305.1996.10473566.
 */
PEMESHFILTERSSTATISTICS_EXPORT double SortedQuantile(
  std::span<const double> sorted, double probability);

/** The numbers of a box plot. */
struct BoxStatistics
{
  double LowerQuartile;
  double Median;
  double UpperQuartile;
  double LowerWhisker; // the least value not more than 1.5 boxes below the box
  double UpperWhisker;
};

/**
 * All NaN for an empty sample.
 *
 * Reference: J. W. Tukey, Exploratory Data Analysis, Addison-Wesley 1977.
 */
PEMESHFILTERSSTATISTICS_EXPORT BoxStatistics DescribeBox(std::span<const double> sorted);

/**
 * Number of bins of equal width for a sorted sample: the width is 2 IQR / n^(1/3), but never less
 * than 1 nor more than 200 bins; by Sturges's rule where the quartiles agree; 1 for a constant
 * sample.
 *
 * Reference: D. Freedman and P. Diaconis, On the histogram as a density estimator, Z.
 * Wahrscheinlichkeit 57 (1981) 453-476, doi:10.1007/BF01025868.
 */
PEMESHFILTERSSTATISTICS_EXPORT int ChooseBins(std::span<const double> sorted);

///@{
/** Of `bins` bins of equal width over [low, high]: where one begins, and which a value is in. The
 * last one has its upper end too. Any finite range will do, without overflow. */
PEMESHFILTERSSTATISTICS_EXPORT double BinStart(int bin, double low, double high, int bins);
PEMESHFILTERSSTATISTICS_EXPORT int BinOf(double value, double low, double high, int bins);
///@}

/** Values at equal distances of a density. */
struct DensityCurve
{
  std::vector<double> X;
  std::vector<double> Y;
  double Bandwidth = 0.0; // no curve for a constant sample, nor beyond 1e300
};

/**
 * Density by Gaussian kernels, at `points` (at least 2) places from three bandwidths below the
 * sample to three above; cut to the range of the sample if asked for. The bandwidth is Silverman's,
 * 0.9 min(s, IQR / 1.34) n^(-1/5). More than a thousand values are first shared out linearly to a
 * grid of a thousand.
 *
 * Reference: B. W. Silverman, Density Estimation for Statistics and Data Analysis, Chapman and Hall
 * 1986, equation (3.31).
 */
PEMESHFILTERSSTATISTICS_EXPORT DensityCurve EstimateDensity(
  std::span<const double> sorted, int points, bool cut);

} // namespace pemesh

#endif
