// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What a chart shows, as plain data: the kinds of charts make it, one painter draws it, picking
 * searches it, and its numbers are what is written as the data behind the chart. Private to this
 * module.
 *
 * Values are those of the table. The place of a value on an axis is the value, or its decimal
 * logarithm on a logarithmic axis; NaN is no place.
 */
#ifndef pemesh_ChartPlot_h
#define pemesh_ChartPlot_h

#include "AxisTicks.h"

#include <vtkType.h> // For vtkIdType

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace pemesh
{

inline constexpr double NoValue = std::numeric_limits<double>::quiet_NaN();

struct ChartAxis
{
  std::string Title;
  bool Logarithmic = false;
  AxisRange Range;                     // of places
  std::vector<std::string> Categories; // names at 0, 1, …; empty for an axis of numbers
  int Group = 0;                       // axes of one group are zoomed together
  bool HasLabels = true;

  double PlaceOf(double value) const
  {
    return !this->Logarithmic ? value : value > 0.0 ? std::log10(value) : NoValue;
  }
  double ValueAt(double place) const { return this->Logarithmic ? std::pow(10.0, place) : place; }
};

/** Points, joined or not, and the band between two values at each. */
struct ChartSeries
{
  std::string Label;
  int Style = 0; // colour, marker and dashes
  bool Joined = false;
  bool Marked = true;
  bool InLegend = true;
  bool Edged = true;  // whether edges keep its markers apart
  bool OfRows = true; // false for a curve, whose points are no rows of the table
  std::vector<double> X;
  std::vector<double> Y; // empty for a band alone
  std::vector<double> Lower;
  std::vector<double> Upper;
  std::vector<double> Values;  // that colour the points; empty: the colour of the series
  std::vector<vtkIdType> Rows; // of the points; empty: point i is row i

  // Made by FinishPlot for logarithmic axes; the values are the places on others.
  std::vector<double> LogX;
  std::vector<double> LogY;
  std::vector<double> LogLower;
  std::vector<double> LogUpper;

  const std::vector<double>& PlacesX() const { return this->LogX.empty() ? this->X : this->LogX; }
  const std::vector<double>& PlacesY() const { return this->LogY.empty() ? this->Y : this->LogY; }
  const std::vector<double>& PlacesLower() const
  {
    return this->LogLower.empty() ? this->Lower : this->LogLower;
  }
  const std::vector<double>& PlacesUpper() const
  {
    return this->LogUpper.empty() ? this->Upper : this->LogUpper;
  }
  vtkIdType RowOf(std::size_t point) const
  {
    return !this->OfRows   ? -1
      : this->Rows.empty() ? static_cast<vtkIdType>(point)
                           : this->Rows[point];
  }
};

/** A rectangle: a bar of a histogram, the box of a box plot, a cell of a heat map. */
struct ChartBar
{
  double Low[2] = { 0.0, 0.0 };
  double High[2] = { 1.0, 1.0 };
  int Style = 0;
  bool HasValue = false; // coloured by Value, else by Style
  double Value = NoValue;
  bool Pale = false;           // filled lightly, with an outline
  std::string Text;            // written into it where it fits
  std::string Name;            // what a pick says of it
  std::vector<vtkIdType> Rows; // that it stands for
};

/** A filled polygon: a violin, a slope triangle. */
struct ChartShape
{
  std::vector<double> X;
  std::vector<double> Y;
  int Style = 0;
  bool Grey = false;    // an annotation rather than data
  bool IsStrip = false; // concave: vertex i and the i-th from the end are opposite each other
};

struct ChartText
{
  double X = 0.0;
  double Y = 0.0;
  std::string Text;
  int Horizontal = 0; // as PanelText
  int Vertical = 0;
};

/** Marks in one pair of axes. */
struct ChartPlot
{
  std::string Title;
  ChartAxis X;
  ChartAxis Y;
  std::vector<ChartSeries> AllSeries;
  std::vector<ChartBar> Bars;
  std::vector<ChartShape> Shapes;
  std::vector<ChartText> Texts;

  std::string ColorTitle;
  bool LogColor = false;
  bool HasColorBar = true; // where there are values to colour by
  std::string ColorMap;    // empty: that of the style
  double ColorRange[2] = { NoValue, NoValue };

  bool LegendIsNeeded = false; // even for a single series
  bool IsDensity = false;      // points are counted rather than drawn
  std::string Message;         // in place of the marks

  // Made by FinishPlot.
  bool IsEmpty = true;
  std::vector<std::string> Remarks;        // what is striking about the values
  AxisRange Values = { NoValue, NoValue }; // that colour the marks
  long NotPositive = 0;
  long Undefined = 0;
  long Infinite = 0;
};

struct ChartPicture
{
  std::vector<ChartPlot> Plots;
  int Columns = 1;
  bool IsMatrix = false; // labels only at the left and below
  std::vector<std::string> Notes;
};

/** Whether the points of a plot are too many to be drawn, and alike, so that they are counted. */
bool CountsPoints(const ChartPlot& plot);

/** Finds the places and ranges of all marks, and counts what has no place. */
void FinishPlot(ChartPlot& plot);

/** What is said below a chart; empty if there is nothing to say. */
std::string DescribePicture(const ChartPicture& picture);

} // namespace pemesh

#endif
