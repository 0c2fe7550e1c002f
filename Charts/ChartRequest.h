// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What a chart is asked to show, and the columns of the table read for it. Private to this module.
 *
 * All functions throw std::runtime_error with one sentence: no table, no such column and the
 * nearest one, a column of text.
 */
#ifndef pemesh_ChartRequest_h
#define pemesh_ChartRequest_h

#include "ChartOptions.h"
#include "ChartPlot.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

class vtkStringArray;
class vtkTable;

namespace pemesh
{

struct ChartRequest
{
  struct Series
  {
    std::string Line; // empty for a band alone
    std::string Lower;
    std::string Upper;
    std::string Label; // empty: the title of the column
  };
  vtkTable* Table = nullptr;
  std::string X; // empty: the row number
  std::vector<Series> AllSeries;
  std::string Color;
  bool LogX = false;
  bool LogY = false;
  bool LogColor = false;
  std::string XTitle; // empty: the title of the column; so are the two below
  std::string YTitle;
  std::string ColorTitle;
  std::map<std::string, std::string> Titles; // of columns; their names by default
  ChartOptions Options;

  std::string TitleOf(const std::string& column) const;
  std::string TitleOfX() const;
  /** Of an axis with these series: the title asked for, or that of the only series. */
  std::string TitleOfY() const;
  std::string LabelOf(const Series& series) const;
};

/** Numbers of a column; row numbers for an empty name. */
std::vector<double> ReadNumbers(vtkTable* table, const std::string& name);

/** Whether a column holds text. */
bool IsTextColumn(vtkTable* table, const std::string& name);

/** Rows that belong together, by the value of a column, in the order of the values. */
struct RowClass
{
  std::string Name;
  std::vector<vtkIdType> Rows;
};
std::vector<RowClass> ReadClasses(vtkTable* table, const std::string& name);

/** The finite numbers among some rows of a column, and their rows. */
struct Sample
{
  std::vector<double> Values;
  std::vector<vtkIdType> Rows;
};
Sample ReadSample(const std::vector<double>& column, const std::vector<vtkIdType>& rows);

/** All rows of a table. */
std::vector<vtkIdType> AllRows(vtkTable* table);

/** Throws where there is no table or too few ordinates. */
void CheckRequest(const ChartRequest& request, std::size_t leastSeries = 1);

} // namespace pemesh

#endif
