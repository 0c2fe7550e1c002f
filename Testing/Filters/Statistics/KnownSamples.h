// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Samples of the literature whose statistics are published.
 */
#ifndef pemesh_KnownSamples_h
#define pemesh_KnownSamples_h

#include <vector>

namespace known
{

// B. Efron, R. J. Tibshirani, An Introduction to the Bootstrap, 1993, table 3.1: 15 law schools.
inline const std::vector<double> LawTests{ 576, 635, 558, 578, 666, 580, 555, 661, 651, 605, 653,
  575, 545, 572, 594 };
inline const std::vector<double> LawGrades{ 3.39, 3.30, 2.81, 3.03, 3.44, 3.07, 3.00, 3.43, 3.36,
  3.13, 3.12, 2.74, 2.76, 2.88, 2.96 };

// R's data set mtcars: miles a gallon, weight, power of 32 cars.
inline const std::vector<double> CarMiles{ 21, 21, 22.8, 21.4, 18.7, 18.1, 14.3, 24.4, 22.8, 19.2,
  17.8, 16.4, 17.3, 15.2, 10.4, 10.4, 14.7, 32.4, 30.4, 33.9, 21.5, 15.5, 15.2, 13.3, 19.2, 27.3,
  26, 30.4, 15.8, 19.7, 15, 21.4 };
inline const std::vector<double> CarWeights{ 2.62, 2.875, 2.32, 3.215, 3.44, 3.46, 3.57, 3.19, 3.15,
  3.44, 3.44, 4.07, 3.73, 3.78, 5.25, 5.424, 5.345, 2.2, 1.615, 1.835, 2.465, 3.52, 3.435, 3.84,
  3.845, 1.935, 2.14, 1.513, 3.17, 2.77, 3.57, 2.78 };
inline const std::vector<double> CarPowers{ 110, 110, 93, 110, 175, 105, 245, 62, 95, 123, 123, 180,
  180, 180, 205, 215, 230, 66, 52, 65, 97, 150, 150, 245, 175, 66, 91, 113, 264, 175, 335, 109 };

} // namespace known

#endif
