// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The numbers of a chart, read from the table and brought to the coordinates of the axes (decimal
 * logarithms on logarithmic ones). Private to this module.
 */
#ifndef pemesh_ChartData_h
#define pemesh_ChartData_h

#include "AxisTicks.h"
#include "ColorMaps.h"

#include <string>
#include <vector>

class vtkTable;

namespace pemesh
{

/** What to read. */
struct ChartColumns
{
  struct Series
  {
    std::string Line; // empty for a band alone
    std::string Lower;
    std::string Upper;
    std::string Label;
  };
  std::string X; // empty: the row number
  std::vector<Series> AllSeries;
  std::string Color;
  bool LogX = false;
  bool LogY = false;
};

struct ChartSeries
{
  std::string Label;
  int Style = 0;         // colour, marker and dashes
  std::vector<double> X; // NaN where it cannot be drawn
  std::vector<double> Y; // empty for a band alone
  std::vector<double> Lower;
  std::vector<double> Upper;
};

struct ChartData
{
  std::vector<ChartSeries> AllSeries;
  std::vector<double> Colors; // by row; empty without a column of numbers to colour by
  bool HasClasses = false;    // one series a class, instead of a column
  AxisRange X;
  AxisRange Y;
  bool IsEmpty = true; // nothing can be drawn
  long NotPositive = 0;
  long Undefined = 0;
};

/** Throws std::runtime_error with one sentence: no table, no such column, a column of text. */
ChartData ReadChartData(vtkTable* table, const ChartColumns& columns);

/** What is said of values that cannot be drawn; empty if there are none. */
std::string DescribeMissing(const ChartData& data, const ChartColumns& columns);

} // namespace pemesh

#endif
