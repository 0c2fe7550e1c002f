// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AxisTicks.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

namespace pemesh
{

namespace
{

constexpr const char* Minus = "\u2212";
constexpr const char* Times = "\u00d7";

std::string WithTrueMinus(std::string text)
{
  if (!text.empty() && text[0] == '-')
  {
    text.replace(0, 1, Minus);
  }
  return text;
}

std::string Fixed(double value, int decimals)
{
  char buffer[400];
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value == 0.0 ? 0.0 : value,
    std::chars_format::fixed, std::clamp(decimals, 0, 20));
  return WithTrueMinus(std::string(buffer, end.ptr));
}

void DropTrailingZeros(std::string& text)
{
  if (text.find('.') != std::string::npos)
  {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.')
    {
      text.pop_back();
    }
  }
}

/** mantissa * 10^exponent, rounded once. */
double Scaled(double mantissa, int exponent)
{
  return exponent >= 0 ? mantissa * std::pow(10.0, exponent) : mantissa / std::pow(10.0, -exponent);
}

struct Step
{
  int Mantissa = 1; // 1, 2 or 5
  int Exponent = 0;
  double Value() const { return Scaled(this->Mantissa, this->Exponent); }
};

/** The smallest step of at most `maximum` ticks. */
Step ChooseStep(double low, double high, int maximum)
{
  const double rough = (high - low) / maximum;
  Step step;
  step.Exponent = static_cast<int>(std::floor(std::log10(rough)));
  for (;;)
  {
    for (const int mantissa : { 1, 2, 5 })
    {
      step.Mantissa = mantissa;
      const double value = step.Value();
      if (std::floor(high / value + 1e-9) - std::ceil(low / value - 1e-9) + 1.0 <= maximum)
      {
        return step;
      }
    }
    ++step.Exponent;
  }
}

/**
 * Which multiples of a power of ten get a label, from many to few, and the widest axis (in decades)
 * on which so many may: nine a decade crowd together at its end.
 */
struct LabelledMultiples
{
  std::string_view Digits;
  double WidestAxis;
};
constexpr LabelledMultiples MultipleTiers[] = { { "123456789", 0.7 }, { "12357", 1.0 },
  { "125", 1e300 } };

/** Labels at multiples of the powers, where there are hardly any powers. */
AxisTicks MakeMultipleTicks(double low, double high, int maximum)
{
  AxisTicks result;
  const int first = static_cast<int>(std::floor(low));
  const int last = static_cast<int>(std::floor(high));
  constexpr double tolerance = 1e-9;
  const bool plain = low > -3.0 - tolerance && high < 4.0;
  int labelled = 0;
  for (const LabelledMultiples& tier : MultipleTiers)
  {
    result.Ticks.clear();
    labelled = 0;
    for (int exponent = first; exponent <= last; ++exponent)
    {
      for (int multiple = 1; multiple <= 9; ++multiple)
      {
        AxisTick tick;
        tick.Position = exponent + std::log10(multiple);
        if (tick.Position < low - tolerance || tick.Position > high + tolerance)
        {
          continue;
        }
        tick.Major = tier.Digits.find(static_cast<char>('0' + multiple)) != std::string_view::npos;
        if (tick.Major)
        {
          const std::string times = multiple == 1 ? "" : std::to_string(multiple) + Times;
          tick.Label = plain ? Fixed(Scaled(multiple, exponent), std::max(0, -exponent))
                             : times + PowerOfTen(exponent);
          ++labelled;
        }
        result.Ticks.push_back(tick);
      }
    }
    if (labelled <= maximum && high - low < tier.WidestAxis)
    {
      break;
    }
  }
  if (labelled < 2)
  {
    result.Ticks.clear();
  }
  return result;
}

/** The ticks of a linear axis, at their places on a logarithmic one. */
AxisTicks MakeLinearTicksOnLog(double low, double high, int maximum)
{
  AxisTicks result = MakeLinearTicks(std::pow(10.0, low), std::pow(10.0, high), maximum);
  std::erase_if(result.Ticks, [](const AxisTick& tick) { return tick.Position <= 0.0; });
  for (AxisTick& tick : result.Ticks)
  {
    tick.Position = std::log10(tick.Position);
  }
  return result;
}

} // namespace

std::string PowerOfTen(int exponent)
{
  constexpr const char* digits[] = { "\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074", "\u2075",
    "\u2076", "\u2077", "\u2078", "\u2079" };
  std::string text = exponent < 0 ? "10\u207b" : "10";
  for (const char digit : std::to_string(std::abs(exponent)))
  {
    text += digits[digit - '0'];
  }
  return text;
}

std::string ReadableNumber(double value, int digits)
{
  if (std::isnan(value))
  {
    return "undefined";
  }
  if (std::isinf(value))
  {
    return value > 0.0 ? "\u221e" : std::string(Minus) + "\u221e";
  }
  if (value == 0.0)
  {
    return "0";
  }
  // Rounding may carry into the next power, so that it decides the exponent.
  char buffer[64];
  const auto end = std::to_chars(
    buffer, buffer + sizeof(buffer), value, std::chars_format::scientific, digits - 1);
  const std::string text(buffer, end.ptr);
  const std::size_t split = text.find('e');
  int exponent = 0;
  const char* first = text.data() + split + (text[split + 1] == '+' ? 2 : 1);
  std::from_chars(first, text.data() + text.size(), exponent);
  std::string mantissa;
  if (exponent >= -4 && exponent < 6)
  {
    mantissa = Fixed(value, std::max(0, digits - 1 - exponent));
    DropTrailingZeros(mantissa);
    return mantissa;
  }
  mantissa = WithTrueMinus(text.substr(0, split));
  DropTrailingZeros(mantissa);
  return mantissa + Times + PowerOfTen(exponent);
}

std::string FixedNumber(double value, int decimals)
{
  return Fixed(value, decimals);
}

AxisTicks MakeLinearTicks(double low, double high, int maximum)
{
  AxisTicks result;
  if (!(high > low) || !std::isfinite(high - low))
  {
    return result;
  }
  const Step step = ChooseStep(low, high, std::max(2, maximum));
  const double largest = std::max(std::fabs(low), std::fabs(high));
  int shift = 0;
  if (largest >= 1e5 || largest < 1e-2)
  {
    shift = static_cast<int>(std::floor(std::log10(largest)));
    result.Multiplier = Times + PowerOfTen(shift);
  }
  const int minorParts = step.Mantissa == 2 ? 4 : 5;
  const auto decimals = std::max(0, shift - step.Exponent);
  const double value = step.Value() / minorParts;
  const double first = std::ceil(low / value - 1e-9);
  const double last = std::floor(high / value + 1e-9);
  for (double i = first; i <= last; i += 1.0)
  {
    AxisTick tick;
    tick.Major = std::fmod(i, minorParts) == 0.0;
    const double mantissa = i * step.Mantissa / minorParts;
    tick.Position = Scaled(mantissa, step.Exponent);
    if (tick.Major)
    {
      tick.Label = Fixed(Scaled(mantissa, step.Exponent - shift), decimals);
    }
    result.Ticks.push_back(tick);
  }
  return result;
}

AxisTicks MakeLogTicks(double lowLog, double highLog, int maximum)
{
  if (!(highLog > lowLog) || !std::isfinite(highLog - lowLog))
  {
    return {};
  }
  maximum = std::max(2, maximum);
  constexpr double tolerance = 1e-9;
  const int first = static_cast<int>(std::ceil(lowLog - tolerance));
  const int last = static_cast<int>(std::floor(highLog + tolerance));
  const int powers = last - first + 1;
  if (powers < 2 || (powers == 2 && highLog - lowLog < 1.3 && maximum >= 5))
  {
    AxisTicks result = MakeMultipleTicks(lowLog, highLog, maximum);
    return result.Ticks.empty() ? MakeLinearTicksOnLog(lowLog, highLog, maximum) : result;
  }
  int stride = 1000;
  for (const int candidate : { 200, 100, 50, 20, 10, 5, 3, 2, 1 })
  {
    stride = (powers - 1) / candidate + 1 <= maximum ? candidate : stride;
  }
  // Between labelled powers the minor ticks are the other powers, as long as they can be counted.
  const int minorStride = stride <= 5 ? 1 : stride <= 10 ? 5 : stride;
  AxisTicks result;
  for (int exponent = first - 1; exponent <= last; ++exponent)
  {
    AxisTick tick;
    tick.Position = exponent;
    tick.Major = exponent % stride == 0;
    tick.Label = tick.Major ? PowerOfTen(exponent) : std::string();
    if (exponent >= first && exponent % minorStride == 0)
    {
      result.Ticks.push_back(tick);
    }
    for (int multiple = 2; stride == 1 && multiple <= 9; ++multiple)
    {
      const double position = exponent + std::log10(multiple);
      if (position >= lowLog && position <= highLog)
      {
        result.Ticks.push_back({ position, "", false });
      }
    }
  }
  return result;
}

AxisRange PadLinearRange(double low, double high)
{
  if (!(low <= high))
  {
    return {};
  }
  constexpr double limit = 8e307; // so that differences are finite
  low = std::clamp(low, -limit, limit);
  high = std::clamp(high, -limit, limit);
  const double size = std::max(std::fabs(low), std::fabs(high));
  const double span = high - low;
  // Below this the ticks could not be told apart: the values count as one.
  if (span <= 1e-11 * size || span < 1e-304)
  {
    const double half = size < 1e-280 ? 1.0 : 0.1 * size;
    const double middle = 0.5 * low + 0.5 * high;
    return { middle - half, middle + half };
  }
  const double margin = 0.04 * span;
  return { low - margin, high + margin };
}

AxisRange PadLogRange(double lowLog, double highLog)
{
  if (!(lowLog <= highLog))
  {
    return {};
  }
  const double span = highLog - lowLog;
  if (span < 1e-9)
  {
    return { lowLog - 0.6, highLog + 0.6 };
  }
  const double margin = std::max(0.04 * span, 1e-3);
  return { lowLog - margin, highLog + margin };
}

} // namespace pemesh
