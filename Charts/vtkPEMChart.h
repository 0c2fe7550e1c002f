// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMChart
 * @brief   A chart of columns of a vtkTable: lines, scatter, histograms and all other kinds.
 *
 * The kinds are those of the table pemesh::ChartKinds(). Most show one x column against any number
 * of y columns, or against bands (smallest, largest and mean value of one quantity). Colours are
 * those of Okabe and Ito that are legible on white, and every series has a marker shape of its own,
 * so that the chart reads in print and with any colour vision.
 *
 * - NaN is a gap in a line and no marker in a scatter chart.
 * - On a logarithmic axis values that are not positive cannot be drawn: a note below the chart says
 *   how many were left out. The ticks of that axis are powers of ten, with minor ticks between.
 * - Lines join the points in the order of the rows.
 * - A colour column of numbers colours the points by a map, with a colour bar; one of text gives
 *   every class a colour, a marker and an entry in the legend.
 *
 * The marks are made from the table once, and again when the table or a setting has changed (by
 * their modification times: a table that is edited in place needs a Modified()); painting, zooming
 * and picking use them. Points are picked exactly, however the drawing is thinned out.
 *
 * It is not a vtkChartXY because that class labels logarithmic axes with decimal fractions, has no
 * minor ticks, does not scale ticks, gaps and markers with the text, and puts its legend on top of
 * the data. The chart knows nothing of what it shows: titles and labels are given to it.
 *
 * Reference for the colours: M. Okabe and K. Ito, Color Universal Design, 2008,
 * https://jfly.uni-koeln.de/color/ (yellow is left out: it is too pale on white).
 */
#ifndef vtkPEMChart_h
#define vtkPEMChart_h

#include "pemeshChartsModule.h" // For export macro
#include "vtkPEMPanel.h"

#include <vtkSmartPointer.h> // For the table

#include <map>    // For titles
#include <memory> // For the marks
#include <string> // For names
#include <vector> // For lists of names

class vtkTable;

namespace pemesh
{
struct ChartOptions;
struct ChartPicture;
struct ChartRequest;
struct ChartViewState;
}

class PEMESHCHARTS_EXPORT vtkPEMChart : public vtkPEMPanel
{
public:
  static vtkPEMChart* New();
  vtkTypeMacro(vtkPEMChart, vtkPEMPanel);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum KindType
  {
    KIND_LINE = 0,
    KIND_SCATTER = 1
  };

  ///@{
  /** The data. No copy is made. */
  void SetTable(vtkTable* table);
  vtkTable* GetTable() const;
  ///@}

  ///@{
  /** Index of an entry of pemesh::ChartKinds(); the first two have names here. Default KIND_LINE.
   */
  void SetKind(int kind);
  vtkGetMacro(Kind, int);
  /** "line", "scatter", "histogram", … False, and nothing changed, for any other word. */
  bool SetKindByName(const std::string& name);
  std::string GetKindName() const;
  static std::vector<std::string> GetKindNames();
  ///@}

  ///@{
  /** Column of the abscissae. Empty (default): the row number. */
  void SetXColumn(const std::string& name);
  std::string GetXColumn() const;
  ///@}

  ///@{
  /** Columns of the ordinates, each with the label of its legend entry (default: its name). */
  void AddYColumn(const std::string& name, const std::string& label = std::string());
  void SetYColumns(const std::vector<std::string>& names);
  void SetYColumns(const std::vector<std::string>& names, const std::vector<std::string>& labels);
  /** A band from one column to another, with a line for a third one (empty: no line). */
  void AddBand(const std::string& lower, const std::string& upper, const std::string& middle,
    const std::string& label);
  /** Removes columns and bands. */
  void RemoveAllYColumns();
  int GetNumberOfSeries() const;
  ///@}

  ///@{
  /** Column that colours the points. Empty (default): none. */
  void SetColorColumn(const std::string& name);
  std::string GetColorColumn() const;
  /** Title of the colour bar. Empty (default): the name of the column. */
  void SetColorTitle(const std::string& title);
  std::string GetColorTitle() const;
  ///@}

  ///@{
  /** Titles of the axes with their units, UTF-8. Empty (default): the name of the column. */
  void SetXTitle(const std::string& title);
  std::string GetXTitle() const;
  void SetYTitle(const std::string& title);
  std::string GetYTitle() const;
  ///@}

  ///@{
  /** Logarithmic axes and colours. Default off. */
  vtkSetMacro(LogX, bool);
  vtkGetMacro(LogX, bool);
  vtkBooleanMacro(LogX, bool);
  vtkSetMacro(LogY, bool);
  vtkGetMacro(LogY, bool);
  vtkBooleanMacro(LogY, bool);
  vtkSetMacro(LogColor, bool);
  vtkGetMacro(LogColor, bool);
  vtkBooleanMacro(LogColor, bool);
  /** "", "x", "y" or "xy". False, and nothing changed, for any other word. */
  bool SetLogAxes(const std::string& axes);
  ///@}

  ///@{
  /** Ranges of the axes. Default NaN, NaN: that of the data and a little more. */
  vtkSetVector2Macro(XRange, double);
  vtkGetVector2Macro(XRange, double);
  vtkSetVector2Macro(YRange, double);
  vtkGetVector2Macro(YRange, double);
  ///@}

  ///@{
  /** Titles of columns, for kinds that name several. Default: the name of the column. */
  void SetColumnTitle(const std::string& column, const std::string& title);
  std::string GetColumnTitle(const std::string& column) const;
  ///@}

  ///@{
  /** What kinds can be asked beyond their columns: fits, bins, groups, limits, … */
  void SetOptions(const pemesh::ChartOptions& options);
  const pemesh::ChartOptions& GetOptions() const;
  /** Sets one by its name; answers with one sentence if that is not possible, else "". */
  std::string SetOption(const std::string& name, const std::string& value);
  std::string GetOption(const std::string& name) const;
  ///@}

  /** The numbers that are drawn: one row a point or bar, with its plot, series and row. */
  vtkSmartPointer<vtkTable> MakeDataTable();

  ///@{
  /** Whether there is a legend (never for a single unnamed series). Default true. */
  vtkSetMacro(ShowLegend, bool);
  vtkGetMacro(ShowLegend, bool);
  vtkBooleanMacro(ShowLegend, bool);
  ///@}

  std::string WhyNotDrawable() override;
  double GetPreferredAspect() override;

  /** What the note below the chart says: how many values cannot be drawn, and why. Often empty. */
  std::string GetNote();

  ///@{
  /**
   * Where a point of the first plot (in the units of its axes) is on the device, after it was
   * painted.
   */
  double GetDeviceX(double x) const;
  double GetDeviceY(double y) const;
  ///@}

  using vtkPEMPanel::Zoom;
  pemesh::ChartPick Pick(double deviceX, double deviceY, double tolerance = 0.8) override;
  std::vector<vtkIdType> SelectRectangle(double x0, double y0, double x1, double y1) override;
  bool Zoom(double deviceX, double deviceY, double factorX, double factorY) override;
  bool Pan(double deviceX, double deviceY, double dx, double dy) override;
  bool ZoomToRectangle(double x0, double y0, double x1, double y1) override;
  void ResetView() override;
  bool IsZoomed() const override;
  bool GetVisibleRange(double deviceX, double deviceY, double range[4]) override;
  std::string DescribeVisibleRange(double deviceX, double deviceY) override;

  bool Paint(vtkContext2D* painter) override;

  /** Of the data or of what is made of them, unlike the view. */
  void Modified() override;

protected:
  vtkPEMChart();
  ~vtkPEMChart() override;

private:
  vtkPEMChart(const vtkPEMChart&) = delete;
  void operator=(const vtkPEMChart&) = delete;

  struct Series
  {
    std::string Column; // the line; empty for a band alone
    std::string Lower;
    std::string Upper;
    std::string Label;
  };

  void SetText(std::string& member, const std::string& value);
  pemesh::ChartRequest GetRequest() const;
  /** Makes the marks if something has changed; throws std::runtime_error where it cannot. */
  const pemesh::ChartPicture& GetPicture();
  bool SetView(int plot, const double places[4]);
  void DescribePick(pemesh::ChartPick& pick);

  vtkSmartPointer<vtkTable> Table;
  int Kind = KIND_LINE;
  std::string XColumn;
  std::vector<Series> AllSeries;
  std::string ColorColumn;
  std::string ColorTitle;
  std::string XTitle;
  std::string YTitle;
  std::map<std::string, std::string> ColumnTitles;
  std::unique_ptr<pemesh::ChartOptions> Options;
  bool LogX = false;
  bool LogY = false;
  bool LogColor = false;
  bool ShowLegend = true;
  double XRange[2];
  double YRange[2];

  vtkTimeStamp DataTime;
  vtkTimeStamp PictureTime;
  std::unique_ptr<pemesh::ChartPicture> Picture;
  std::unique_ptr<pemesh::ChartViewState> View; // what is seen, and where it was painted
};

#endif
