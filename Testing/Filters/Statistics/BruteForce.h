// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Coefficients by their definitions, pair by pair, to compare with; and samples to try.
 */
#ifndef pemesh_BruteForce_h
#define pemesh_BruteForce_h

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace brute
{

using Sample = std::vector<double>;

inline int Sign(double value)
{
  return (value > 0) - (value < 0);
}

/** Concordant less discordant pairs. */
inline double KendallScore(const Sample& x, const Sample& y)
{
  double score = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      score += Sign(x[i] - x[j]) * Sign(y[i] - y[j]);
    }
  }
  return score;
}

inline double KendallTauB(const Sample& x, const Sample& y)
{
  return KendallScore(x, y) / std::sqrt(KendallScore(x, x) * KendallScore(y, y));
}

/** One more than the number of smaller values, plus half the number of other equal ones. */
inline Sample Ranks(const Sample& sample)
{
  Sample ranks;
  for (const double value : sample)
  {
    double rank = 0.5;
    for (const double other : sample)
    {
      rank += other < value ? 1.0 : other == value ? 0.5 : 0.0;
    }
    ranks.push_back(rank);
  }
  return ranks;
}

/** From the differences of all pairs: no mean is ever formed. */
inline double Pearson(const Sample& x, const Sample& y)
{
  long double xy = 0;
  long double xx = 0;
  long double yy = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const long double dx = static_cast<long double>(x[i]) - x[j];
      const long double dy = static_cast<long double>(y[i]) - y[j];
      xy += dx * dy;
      xx += dx * dx;
      yy += dy * dy;
    }
  }
  return static_cast<double>(xy / std::sqrt(xx * yy));
}

/** Integers in [0, distinct): few distinct values make many ties. */
inline Sample RandomSample(std::mt19937_64& bits, std::size_t n, std::uint64_t distinct)
{
  Sample sample(n);
  for (double& value : sample)
  {
    value = static_cast<double>(bits() % distinct);
  }
  return sample;
}

} // namespace brute

#endif
