// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Where the ticks of an axis are, and what is written at them.
 *
 * Positions on a logarithmic axis are decimal logarithms. Labels are UTF-8, with a true minus sign
 * and superscripts, and do not depend on the locale.
 */
#ifndef pemesh_AxisTicks_h
#define pemesh_AxisTicks_h

#include "pemeshChartsModule.h" // For export macro

#include <string>
#include <vector>

namespace pemesh
{

struct AxisTick
{
  double Position = 0.0;
  std::string Label; // empty for a minor tick, and for a major one between labelled ones
  bool Major = true;
};

struct AxisTicks
{
  std::vector<AxisTick> Ticks;
  std::string Multiplier; // "×10⁻⁵" where it is taken out of all labels, else empty
};

/** Ticks at 1, 2 or 5 times a power of ten, at most `maximum` (at least 2) labelled ones. */
PEMESHCHARTS_EXPORT AxisTicks MakeLinearTicks(double low, double high, int maximum);

/**
 * Powers of ten, every one or every second, …; where the range holds fewer than two of them, their
 * multiples too; where it is too short even for these, the ticks of a linear axis.
 */
PEMESHCHARTS_EXPORT AxisTicks MakeLogTicks(double lowLog, double highLog, int maximum);

///@{
/**
 * The range of an axis for values from `low` to `high`: a little more on either side; never empty,
 * whatever the values are. [0, 1] if there are none (NaN). The second takes and gives logarithms.
 */
struct AxisRange
{
  double Low = 0.0;
  double High = 1.0;
};
PEMESHCHARTS_EXPORT AxisRange PadLinearRange(double low, double high);
PEMESHCHARTS_EXPORT AxisRange PadLogRange(double lowLog, double highLog);
///@}

/** "10⁻³" for -3. */
PEMESHCHARTS_EXPORT std::string PowerOfTen(int exponent);

/** A number for people: `digits` significant ones, "1.5×10⁻⁷" where it is very small or large. */
PEMESHCHARTS_EXPORT std::string ReadableNumber(double value, int digits = 4);

/** With this many decimals, "1.90". */
PEMESHCHARTS_EXPORT std::string FixedNumber(double value, int decimals);

} // namespace pemesh

#endif
