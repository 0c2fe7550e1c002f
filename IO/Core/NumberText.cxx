// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "NumberText.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <vector>

namespace pemesh
{

namespace
{

std::string_view Trim(std::string_view text)
{
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos)
  {
    return {};
  }
  text = text.substr(first, text.find_last_not_of(blanks) - first + 1);
  // from_chars takes no plus sign, which files do contain.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-')
  {
    text.remove_prefix(1);
  }
  return text;
}

template <typename Number>
std::optional<Number> ParseWhole(std::string_view text)
{
  text = Trim(text);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
  {
    return std::nullopt;
  }
  return value;
}

template <typename Number>
void AppendShortest(std::string& text, Number value)
{
  char buffer[40];
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
  text.append(buffer, result.ptr);
}

} // namespace

std::string FormatNumber(double value)
{
  std::string text;
  AppendNumber(text, value);
  return text;
}

void AppendNumber(std::string& text, double value)
{
  if (std::isnan(value))
  {
    text += "nan"; // never "-nan"
    return;
  }
  AppendShortest(text, value);
}

void AppendNumber(std::string& text, long long value)
{
  AppendShortest(text, value);
}

std::optional<double> ParseNumber(std::string_view text)
{
  return ParseWhole<double>(text);
}

std::optional<long long> ParseInteger(std::string_view text)
{
  return ParseWhole<long long>(text);
}

std::string FormatCount(long long count, const char* one, const char* many)
{
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

int EditDistance(std::string_view a, std::string_view b)
{
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    int diagonal = row[0];
    row[0] = static_cast<int>(i) + 1;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const int substitute = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({ row[j] + 1, row[j + 1] + 1, substitute });
    }
  }
  return row.back();
}

} // namespace pemesh
