// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Curves of two parameters through points, by least squares where the curve is a straight line:
 * y = a + b x as it is, y = a x^b between the logarithms of both, y = a e^(b x) between x and the
 * logarithm of y. So a power law counts relative errors, as a reader of a log-log plot does.
 *
 * Points with a value that has no place there (NaN, infinite, not positive under a logarithm) are
 * left out. Charts, trends in words and tables of convergence all use these fits.
 */
#ifndef pemesh_CurveFit_h
#define pemesh_CurveFit_h

#include "pemeshFiltersStatisticsModule.h" // For export macro

#include <optional>
#include <span>

namespace pemesh
{

enum class CurveForm
{
  Linear,     // a + b x
  Power,      // a x^b
  Exponential // a e^(b x)
};

/** What is said of a form. */
struct FormKind
{
  CurveForm Form;
  const char* Name;      // "power-law"
  const char* Label;     // "a power law"
  const char* Parameter; // what B is called: "exponent"
  bool LogX;             // where the curve is a straight line
  bool LogY;
};

/** All forms, the simplest first: where two fit alike it is taken. */
PEMESHFILTERSSTATISTICS_EXPORT std::span<const FormKind> FormKinds();

/** An interval of ordinates. */
struct CurveBand
{
  double Lower;
  double Upper;
};

struct PEMESHFILTERSSTATISTICS_EXPORT CurveFit
{
  CurveForm Form = CurveForm::Linear;
  double A = 0.0;
  double B = 0.0;
  double RSquared = 0.0; // part of the variance explained, where the curve is straight; NaN: none
  long Points = 0;       // that it goes through
  long LeftOut = 0;

  // Of the straight line: what the band is made of.
  double MeanX = 0.0;
  double SpreadX = 0.0;   // root of the sum of (x - mean)^2
  double Deviation = 0.0; // residual standard deviation, n - 2 degrees of freedom; 0 for two points
  /** Of y itself, up to a constant common to all forms; infinite where no residual is above the
   * rounding errors. */
  double LogLikelihood = 0.0;

  const FormKind& Kind() const;

  double ValueAt(double x) const;

  /** Standard error of B, Deviation / SpreadX; NaN for fewer than three points. */
  double StandardErrorOfB() const;

  /**
   * Where the mean of y at x is with this confidence (in (0, 1)): Student's t with n - 2 degrees of
   * freedom. NaN for fewer than three points.
   */
  CurveBand BandAt(double x, double confidence) const;
};

/** Nothing for fewer than two points or a single abscissa. */
PEMESHFILTERSSTATISTICS_EXPORT std::optional<CurveFit> FitCurve(
  CurveForm form, std::span<const double> x, std::span<const double> y);

/**
 * The form with the greatest likelihood of the same observations y, which makes errors of different
 * scales comparable; forms that would have to leave out more points than another do not count, nor
 * do those whose R^2 is below `leastRSquared` or, where that is positive, undefined.
 *
 * Reference: G. E. P. Box and D. R. Cox, An analysis of transformations, J. R. Stat. Soc. B 26
 * (1964) 211-252.
 */
PEMESHFILTERSSTATISTICS_EXPORT std::optional<CurveFit> FitBestCurve(
  std::span<const double> x, std::span<const double> y, double leastRSquared = 0.0);

} // namespace pemesh

#endif
