// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A relation of two quantities in words: direction, form and strength.
 */
#ifndef pemesh_RelationWords_h
#define pemesh_RelationWords_h

#include "TrendForm.h"
#include "pemeshFiltersStatisticsModule.h" // For export macro

#include <string>

namespace pemesh
{

/** |coefficient| from which on a relation is called strong and moderate. */
inline constexpr double StrongFrom = 0.7;
inline constexpr double ModerateFrom = 0.4;

/** "strong", "moderate", "weak", or "undefined" for NaN. */
PEMESHFILTERSSTATISTICS_EXPORT std::string StrengthWord(double coefficient);

/** "positive", "negative", "none" for 0 (to 1e-12), or "undefined" for NaN. */
PEMESHFILTERSSTATISTICS_EXPORT std::string DirectionWord(double coefficient);

/** With two significant digits: "-1.9", "0.00032", "3.1e+06". */
PEMESHFILTERSSTATISTICS_EXPORT std::string RoundedNumber(double value);

/**
 * "strong negative, close to a power law with exponent -1.9". `strength` is the coefficient that
 * the strength goes by, `direction` one that has a sign.
 */
PEMESHFILTERSSTATISTICS_EXPORT std::string RelationWords(
  double strength, double direction, const TrendForm& form);

} // namespace pemesh

#endif
