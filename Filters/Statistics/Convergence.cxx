// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Convergence.h"

#include "CurveFit.h"
#include "NumberText.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace pemesh
{

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

bool IsPositive(double value)
{
  return std::isfinite(value) && value > 0.0;
}

double OrderBetween(double coarseSize, double coarseError, double fineSize, double fineError)
{
  return IsPositive(coarseError) && IsPositive(fineError) && coarseSize > fineSize
    ? std::log(coarseError / fineError) / std::log(coarseSize / fineSize)
    : Undefined;
}

ConvergenceColumn MakeColumn(
  const ErrorColumn& errors, std::span<const std::size_t> order, std::span<const double> sizes)
{
  ConvergenceColumn column;
  column.Name = errors.Name;
  for (const std::size_t i : order)
  {
    column.Errors.push_back(errors.Errors[i]);
  }
  column.Orders.assign(order.size(), Undefined);
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    column.Orders[i] = OrderBetween(sizes[i - 1], column.Errors[i - 1], sizes[i], column.Errors[i]);
  }
  const std::optional<CurveFit> fit = FitCurve(CurveForm::Power, sizes, column.Errors);
  column.Order = fit ? fit->B : Undefined;
  column.StandardError = fit ? fit->StandardErrorOfB() : Undefined;
  return column;
}

// Some digits, never depending on the locale; a dash where undefined.
std::string Digits(double value, std::chars_format format, int digits)
{
  if (!std::isfinite(value))
  {
    return "-";
  }
  std::array<char, 64> buffer{};
  const auto end =
    std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, digits);
  return { buffer.data(), end.ptr };
}

std::string ShowSize(double value)
{
  return Digits(value, std::chars_format::scientific, 3);
}

std::string ShowOrder(double value)
{
  return Digits(value, std::chars_format::fixed, 2);
}

// 1.234e-05 as $1.234 \cdot 10^{-5}$.
std::string ShowInLatex(double value)
{
  const std::string text = ShowSize(value);
  const std::size_t e = text.find('e');
  if (e == std::string::npos)
  {
    return text;
  }
  const int exponent =
    static_cast<int>(ParseInteger(text.substr(text[e + 1] == '+' ? e + 2 : e + 1)).value_or(0));
  return "$" + text.substr(0, e) + " \\cdot 10^{" + std::to_string(exponent) + "}$";
}

std::string EscapeLatex(const std::string& name)
{
  std::string text;
  for (const char c : name)
  {
    text += std::string_view("_%&#$").find(c) == std::string_view::npos ? "" : "\\";
    text += c;
  }
  return text;
}

// The parts of a line: first, between, last; and how cells are shown.
struct TextStyle
{
  const char* Begin;
  const char* Between;
  const char* End;
  std::string (*Number)(double);
  std::string (*Order)(double);
  std::string (*Name)(const std::string&);
  const char* OrderName;
  const char* FitName;
};

std::string Join(const TextStyle& style, const std::vector<std::string>& cells)
{
  std::string line = style.Begin;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    line += (i == 0 ? "" : style.Between) + cells[i];
  }
  return line + style.End;
}

std::string HeaderLine(const ConvergenceTable& table, const TextStyle& style)
{
  std::vector<std::string> cells = { style.Name(table.SizeName) };
  for (const ConvergenceColumn& column : table.Columns)
  {
    cells.push_back(style.Name(column.Name));
    cells.push_back(
      style.OrderName[0] == '_' ? style.Name(column.Name + style.OrderName) : style.OrderName);
  }
  return Join(style, cells);
}

std::string BodyLines(const ConvergenceTable& table, const TextStyle& style)
{
  std::string text;
  for (std::size_t row = 0; row < table.Sizes.size(); ++row)
  {
    std::vector<std::string> cells = { style.Number(table.Sizes[row]) };
    for (const ConvergenceColumn& column : table.Columns)
    {
      cells.push_back(style.Number(column.Errors[row]));
      cells.push_back(style.Order(column.Orders[row]));
    }
    text += Join(style, cells);
  }
  return text;
}

std::string FitLine(const ConvergenceTable& table, const TextStyle& style)
{
  std::vector<std::string> cells = { style.FitName };
  for (const ConvergenceColumn& column : table.Columns)
  {
    cells.emplace_back("");
    cells.push_back(style.Order(column.Order));
  }
  return Join(style, cells);
}

std::string SameName(const std::string& name)
{
  return name;
}

std::string FormatAsCsv(const ConvergenceTable& table)
{
  const TextStyle style = { "", ",", "\n", FormatNumber, FormatNumber,
    [](const std::string& name)
    {
      std::string text;
      for (const char c : name)
      {
        text += c == '"' ? "\"\"" : std::string(1, c);
      }
      return name.find_first_of(",\"\n") == std::string::npos ? name : '"' + text + '"';
    },
    "_order", "fit" };
  return HeaderLine(table, style) + BodyLines(table, style) + FitLine(table, style);
}

std::string FormatAsMarkdown(const ConvergenceTable& table)
{
  const TextStyle style = { "| ", " | ", " |\n", ShowSize, ShowOrder, SameName, "order", "fit" };
  std::string rule = "|---:|";
  for (std::size_t i = 0; i < table.Columns.size(); ++i)
  {
    rule += "---:|---:|";
  }
  return HeaderLine(table, style) + rule + "\n" + BodyLines(table, style) + FitLine(table, style);
}

std::string FormatAsLatex(const ConvergenceTable& table)
{
  const TextStyle style = { "  ", " & ", " \\\\\n", ShowInLatex, ShowOrder, EscapeLatex, "order",
    "fit" };
  return "\\begin{tabular}{r" + std::string(2 * table.Columns.size(), 'r') + "}\n  \\hline\n" +
    HeaderLine(table, style) + "  \\hline\n" + BodyLines(table, style) + "  \\hline\n" +
    FitLine(table, style) + "  \\hline\n\\end{tabular}\n";
}

constexpr std::array Formats = {
  ConvergenceFormat{ "csv", "comma-separated, all digits", FormatAsCsv },
  ConvergenceFormat{ "markdown", "a Markdown table", FormatAsMarkdown },
  ConvergenceFormat{ "latex", "a LaTeX tabular", FormatAsLatex },
};

} // namespace

ConvergenceTable MakeConvergenceTable(const std::string& sizeName, std::span<const double> sizes,
  const std::vector<ErrorColumn>& errors)
{
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    if (IsPositive(sizes[i]))
    {
      order.push_back(i);
    }
  }
  std::stable_sort(order.begin(), order.end(),
    [&sizes](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  ConvergenceTable table;
  table.SizeName = sizeName;
  for (const std::size_t i : order)
  {
    table.Sizes.push_back(sizes[i]);
  }
  for (const ErrorColumn& column : errors)
  {
    table.Columns.push_back(MakeColumn(column, order, table.Sizes));
  }
  return table;
}

std::span<const ConvergenceFormat> ConvergenceFormats()
{
  return Formats;
}

const ConvergenceFormat* FindConvergenceFormat(std::string_view name)
{
  for (const ConvergenceFormat& format : Formats)
  {
    if (name == format.Name)
    {
      return &format;
    }
  }
  return nullptr;
}

} // namespace pemesh
