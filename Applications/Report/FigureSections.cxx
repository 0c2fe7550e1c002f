// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ReportSections.h"

#include "ColumnRoles.h"
#include "Correlation.h"
#include "NumberText.h"
#include "RelationWords.h"
#include "ReportContents.h"
#include "ReportFigures.h"
#include "ResultPanels.h"
#include "TrendForm.h"
#include "vtkPEMChart.h"
#include "vtkPEMMeshView.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <vtkCellData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkVariant.h>

namespace pemesh
{

namespace
{

using Names = std::vector<std::string>;

constexpr int MostSentences = 10;       // a performance; findings.csv has all
constexpr int MostScatters = 3;         // a performance
constexpr double LeastRefinement = 1.5; // largest over smallest mesh size, to speak of convergence
constexpr const char* SizeColumn = "MeshSize";

StudyPlot PlotOf(const std::string& kind, const std::string& x, const std::string& y)
{
  StudyPlot plot;
  plot.Kind = kind;
  plot.X = x;
  plot.Y = { y };
  return plot;
}

Html Grid(const Html& figures)
{
  return HtmlElement("div", { { "class", "figures" } }, figures);
}

std::string RangeOf(const std::vector<double>& values)
{
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  for (const double value : values)
  {
    least = std::isnan(value) ? least : std::min(least, value);
    greatest = std::isnan(value) ? greatest : std::max(greatest, value);
  }
  return least <= greatest ? "from " + RoundedNumber(least) + " to " + RoundedNumber(greatest)
                           : "undefined everywhere";
}

/** The metrics that have a band of min, mean and max in the results. */
Names BandedMetrics(vtkTable* results)
{
  Names metrics;
  for (const std::string& column : NumericColumns(results))
  {
    if (!column.ends_with("_min"))
    {
      continue;
    }
    const std::string name = column.substr(0, column.size() - 4);
    if (results->GetColumnByName((name + "_max").c_str()) &&
      results->GetColumnByName((name + "_mean").c_str()))
    {
      metrics.push_back(name);
    }
  }
  return metrics;
}

/** Whether a logarithmic axis says more: positive values over two orders of magnitude. */
bool SpansDecades(vtkTable* results, const std::string& column)
{
  double least = std::numeric_limits<double>::infinity();
  double greatest = 0.0;
  for (const double value : ColumnNumbers(results, column))
  {
    if (value <= 0.0)
    {
      return false;
    }
    least = std::isnan(value) ? least : std::min(least, value);
    greatest = std::isnan(value) ? greatest : std::max(greatest, value);
  }
  return greatest >= 100.0 * least;
}

std::string LogAxes(const ReportContents& contents, const std::string& x, const std::string& y)
{
  const bool logX = SpansDecades(contents.Results, x);
  const bool logY = contents.IsLogarithmic(y) || SpansDecades(contents.Results, y);
  return std::string(logX ? "x" : "") + (logY ? "y" : "");
}

std::string TextAt(vtkTable* table, vtkIdType row, const char* column)
{
  return table->GetColumnByName(column) ? table->GetValueByName(row, column).ToString()
                                        : std::string();
}

std::string SizeOf(vtkPolyData* mesh)
{
  return std::to_string(mesh->GetNumberOfCells()) + " elements, " +
    std::to_string(mesh->GetNumberOfPoints()) + " vertices";
}

Html ScatterOf(const ReportContents& contents, const FigureFolder& folder, const std::string& x,
  const std::string& y, const std::string& words)
{
  StudyPlot plot = PlotOf("scatter", x, y);
  plot.Log = LogAxes(contents, x, y);
  const std::string color = contents.ColorColumn();
  plot.ColorBy = color == x ? "" : color;
  const std::string titles = contents.Labels.Title(y) + " against " + contents.Labels.Title(x);
  const auto chart = MakeResultChart(plot, contents.Results, contents.Labels);
  chart->ShowLegendOn(); // of the classes, where the colours are classes
  return EmbedPanel(
    folder, chart, "Scatter chart: " + titles + ". " + words, titles + ": " + words);
}

/** The metric that goes best with a performance, or "". */
std::string BestMetric(const ReportContents& contents, const std::string& performance)
{
  for (vtkIdType row = 0; contents.Findings && row < contents.Findings->GetNumberOfRows(); ++row)
  {
    const std::string metric = TextAt(contents.Findings, row, "Metric");
    if (TextAt(contents.Findings, row, "Performance") == performance &&
      contents.Findings->GetValueByName(row, "Rank").ToInt() == 1 &&
      contents.Results->GetColumnByName(metric.c_str()))
    {
      return metric;
    }
  }
  return {};
}

std::string RangesOf(const ReportContents& contents, const ReportMeasure& measure)
{
  std::string text;
  for (std::size_t i = 0; i < measure.Columns.size(); ++i)
  {
    text += (text.empty() ? "" : "; ") +
      (measure.Columns.size() > 1 ? measure.Runs[i] + " " : std::string()) +
      RangeOf(ColumnNumbers(contents.Results, measure.Columns[i]));
  }
  return text;
}

/** A chart of one performance of all runs, each in a colour of its own. */
vtkSmartPointer<vtkPEMChart> ComparisonOf(
  const ReportContents& contents, const ReportMeasure& measure, const StudyPlot& plot)
{
  auto chart = MakeResultChart(plot, contents.Results, contents.Labels);
  if (measure.Columns.size() > 1)
  {
    chart->SetYColumns(measure.Columns, measure.Runs);
    chart->SetYTitle(measure.Title);
  }
  return chart;
}

/** The metrics that go best with any performance, best first, `most` of them. */
Names BestMetrics(const ReportContents& contents, std::size_t most)
{
  std::vector<std::pair<int, std::string>> ranked;
  for (vtkIdType row = 0; row < contents.Findings->GetNumberOfRows(); ++row)
  {
    const int rank = contents.Findings->GetValueByName(row, "Rank").ToInt();
    const std::string metric = TextAt(contents.Findings, row, "Metric");
    if (rank > 0 && contents.Results->GetColumnByName(metric.c_str()))
    {
      ranked.emplace_back(rank, metric);
    }
  }
  std::stable_sort(
    ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Names names;
  for (const auto& [rank, metric] : ranked)
  {
    if (names.size() < most && std::find(names.begin(), names.end(), metric) == names.end())
    {
      names.push_back(metric);
    }
  }
  return names;
}

/** All performances and the metrics that go best with them, each with each. */
Html HeatMap(const ReportContents& contents, const FigureFolder& folder)
{
  constexpr std::size_t most = 8; // of either; more cannot be read
  StudyPlot plot = PlotOf("correlation-matrix", "", "");
  plot.Y.clear();
  for (const ReportMeasure& measure : contents.Measures())
  {
    // Of every solver, before the next performance.
    plot.Y.insert(plot.Y.end(), measure.Columns.begin(), measure.Columns.end());
  }
  std::erase_if(plot.Y,
    [&](const std::string& name)
    {
      std::vector<double> values = ColumnNumbers(contents.Results, name);
      std::erase_if(values, [](double value) { return std::isnan(value); });
      return values.empty() || IsConstant(values); // nothing goes with what never changes
    });
  const bool isPart = plot.Y.size() > most;
  plot.Y.resize(std::min(plot.Y.size(), most));
  const Names metrics = BestMetrics(contents, most);
  plot.Y.insert(plot.Y.end(), metrics.begin(), metrics.end());
  if (metrics.empty() || plot.Y.size() < 3)
  {
    return {};
  }
  const std::string& asked = contents.TheStudy.Statistics.Coefficient;
  const std::string method = asked == "distance" ? "spearman" : asked;
  plot.Options["method"] = method;
  const std::string caption = "Coefficients (" + method + ") of " +
    (isPart ? "the first " + std::to_string(most) : "the") + " performances" + " and the " +
    std::to_string(metrics.size()) + " metrics that go best with any";
  return EmbedPanel(folder, MakeResultChart(plot, contents.Results, contents.Labels),
    "Heat map of a matrix of correlation. " + caption + ".", caption, { 18.0, 15.0 });
}

/** The performances that have findings, those of one kind together, with their first rows. */
std::vector<vtkIdType> RowsOfPerformances(const ReportContents& contents)
{
  std::vector<std::pair<std::string, vtkIdType>> found; // in the order of the findings
  for (vtkIdType row = 0; row < contents.Findings->GetNumberOfRows(); ++row)
  {
    const std::string performance = TextAt(contents.Findings, row, "Performance");
    const bool isNew = found.empty() || found.back().first != performance;
    if (isNew && contents.Results->GetColumnByName(performance.c_str()))
    {
      found.emplace_back(performance, row);
    }
  }
  Names order;
  for (const ReportMeasure& measure : contents.Measures())
  {
    order.insert(order.end(), measure.Columns.begin(), measure.Columns.end());
  }
  const auto place = [&order](const auto& entry)
  { return std::find(order.begin(), order.end(), entry.first) - order.begin(); };
  std::stable_sort(found.begin(), found.end(),
    [&place](const auto& a, const auto& b) { return place(a) < place(b); });
  std::vector<vtkIdType> rows;
  std::transform(found.begin(), found.end(), std::back_inserter(rows),
    [](const auto& entry) { return entry.second; });
  return rows;
}

/**
 * The ranked list of one performance, whose rows of the findings begin at `row`; what is said of
 * all metrics together is left out where it is what was said `before`.
 */
Html RankedList(
  const ReportContents& contents, const FigureFolder& folder, vtkIdType row, std::string& before)
{
  vtkTable* findings = contents.Findings;
  const std::string performance = TextAt(findings, row, "Performance");
  Html list;
  Html scatters;
  int more = 0;
  const std::string joint = TextAt(findings, row, "Joint");
  for (; row < findings->GetNumberOfRows() && TextAt(findings, row, "Performance") == performance;
       ++row)
  {
    const int rank = findings->GetValueByName(row, "Rank").ToInt();
    more += rank > MostSentences ? 1 : 0;
    if (rank == 0 || rank > MostSentences)
    {
      continue;
    }
    const std::string metric = TextAt(findings, row, "Metric");
    list += HtmlElement("li", {},
      HtmlElement("strong", contents.Labels.Title(metric)) + HtmlText(" – ") +
        HtmlText(TextAt(findings, row, "Sentence")));
    if (rank <= MostScatters && contents.Results->GetColumnByName(metric.c_str()))
    {
      scatters += ScatterOf(contents, folder, metric, performance, TextAt(findings, row, "Words"));
    }
  }
  Html section = HtmlElement("h3", contents.Labels.Title(performance));
  section += list.IsEmpty()
    ? HtmlParagraph("No metric has a coefficient with it: one of the two never changes, or fewer "
                    "than two meshes have both.")
    : HtmlElement("ol", {}, list);
  if (more > 0)
  {
    section += HtmlParagraph(std::to_string(more) + " more are in findings.csv.");
  }
  if (joint != before)
  {
    section += HtmlParagraph(joint);
  }
  before = joint;
  return section + Grid(scatters);
}

} // namespace

Html MakeMeshes(const ReportContents& contents, const FigureFolder& folder)
{
  Html figures;
  for (const ShownMesh& shown : contents.Meshes)
  {
    const bool generated = shown.Mesh->GetCellData()->GetArray("ElementFamily") != nullptr;
    auto view = MakeMeshView(shown.Mesh, generated ? "ElementFamily" : "", contents.Labels);
    view->SetColorTitle("");
    const std::string caption = shown.Place + " mesh, " + shown.Name + ": " + SizeOf(shown.Mesh);
    figures += EmbedPanel(folder, view, "Picture of the mesh. " + caption, caption);
  }
  return figures.IsEmpty() ? Html() : Grid(figures);
}

Html MakeMetrics(const ReportContents& contents, const FigureFolder& folder)
{
  Html figures;
  for (const std::string& metric : BandedMetrics(contents.Results))
  {
    StudyPlot plot = PlotOf("line", contents.Abscissa(), metric);
    plot.Log = SpansDecades(contents.Results, metric + "_min") ? "y" : "";
    const std::string title = contents.Labels.Title(metric);
    const std::string ranges = "smallest " +
      RangeOf(ColumnNumbers(contents.Results, metric + "_min")) + ", largest " +
      RangeOf(ColumnNumbers(contents.Results, metric + "_max"));
    figures += EmbedPanel(folder, MakeResultChart(plot, contents.Results, contents.Labels),
      "Line chart of the range and the mean of the metric " + title + "; " + ranges + ".",
      title + " (" + metric + "): " + ranges);
  }
  return figures.IsEmpty()
    ? Html()
    : HtmlParagraph("Over the elements of each mesh: the range from the smallest to the largest "
                    "value, and the mean.") +
      Grid(figures);
}

Html MakePerformances(const ReportContents& contents, const FigureFolder& folder)
{
  Html figures;
  for (const ReportMeasure& measure : contents.Measures())
  {
    StudyPlot plot = PlotOf("line", contents.Abscissa(), measure.Columns.front());
    plot.Y = measure.Columns;
    plot.Log = contents.IsLogarithmic(measure.Columns.front()) ? "y" : "";
    const std::string ranges = RangesOf(contents, measure);
    figures += EmbedPanel(folder, ComparisonOf(contents, measure, plot),
      "Line chart of " + measure.Title + "; " + ranges + ".", measure.Title + ": " + ranges);
    const std::string metric = BestMetric(contents, measure.Columns.front());
    if (measure.Columns.size() > 1 && !metric.empty())
    {
      StudyPlot scatter = plot;
      scatter.Kind = "scatter";
      scatter.X = metric;
      scatter.Log = LogAxes(contents, metric, measure.Columns.front());
      const std::string titles =
        measure.Title + " of every solver against " + contents.Labels.Title(metric);
      figures += EmbedPanel(folder, ComparisonOf(contents, measure, scatter),
        "Scatter chart coloured by solver: " + titles + ".", titles);
    }
  }
  return figures.IsEmpty() ? Html() : Grid(figures);
}

Html MakeFindings(const ReportContents& contents, const FigureFolder& folder)
{
  if (!contents.Findings || contents.Findings->GetNumberOfRows() == 0)
  {
    return {};
  }
  Html section;
  if (!contents.Note.empty())
  {
    section += HtmlElement("p", { { "class", "note" } }, HtmlText(contents.Note));
  }
  section += HeatMap(contents, folder);
  std::string joint;
  for (const vtkIdType row : RowsOfPerformances(contents))
  {
    section += RankedList(contents, folder, row, joint);
  }
  return section;
}

Html MakeConvergence(const ReportContents& contents, const FigureFolder& folder)
{
  if (!WhyNotNumeric(contents.Results, { SizeColumn }).empty())
  {
    return {};
  }
  const std::vector<double> sizes = ColumnNumbers(contents.Results, SizeColumn);
  std::vector<double> known; // of the meshes that could be made
  std::copy_if(sizes.begin(), sizes.end(), std::back_inserter(known),
    [](double size) { return std::isfinite(size); });
  const auto [least, greatest] = std::minmax_element(known.begin(), known.end());
  if (known.empty() || !(*least > 0.0) || *greatest < LeastRefinement * *least)
  {
    return {};
  }
  Html figures;
  HtmlTable table{ "Observed orders: the exponent p of the power law h^p that comes nearest",
    { "Performance", "Order", "Fit R²", "Meshes" }, {}, false };
  for (const std::string& performance : contents.Performances())
  {
    std::vector<double> h;
    std::vector<double> values;
    RemoveMissing(sizes, ColumnNumbers(contents.Results, performance), h, values);
    const TrendForm form = FindTrendForm(h, values);
    if (form.Name == "power-law")
    {
      table.Rows.push_back({ contents.Labels.Title(performance), RoundedNumber(form.Parameter),
        RoundedNumber(form.Fit), std::to_string(h.size()) });
    }
    if (!contents.IsLogarithmic(performance))
    {
      continue;
    }
    StudyPlot plot = PlotOf("scatter", SizeColumn, performance);
    plot.Log = "xy";
    const std::string title = contents.Labels.Title(performance) + " against the mesh size";
    figures += EmbedPanel(folder, MakeResultChart(plot, contents.Results, contents.Labels),
      "Scatter chart with logarithmic axes: " + title + ".", title);
  }
  Html section = HtmlParagraph("The mesh size varies from " + RoundedNumber(*least) + " to " +
    RoundedNumber(*greatest) +
    ". Where the geometry varies with it, an observed order mixes both.");
  section += table.Rows.empty()
    ? HtmlParagraph("No performance is close to a power of the mesh size.")
    : FormatTable(table);
  return section + Grid(figures);
}

} // namespace pemesh
