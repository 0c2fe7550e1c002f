// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// How values are distributed: histograms, boxes and violins, of columns or of classes of rows.
#include "ChartBuilders.h"
#include "Distribution.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace pemesh
{

namespace
{

/** Values of one column in one class of rows, as places on the axis of values, ascending. */
struct Batch
{
  std::string Class; // empty without classes
  int Category = 0;  // place on the axis of classes
  int Series = 0;    // of the columns
  std::vector<std::pair<double, vtkIdType>> Places;

  std::vector<double> Sorted() const
  {
    std::vector<double> values;
    for (const auto& [place, row] : this->Places)
    {
      values.push_back(place);
    }
    return values;
  }
};

std::vector<RowClass> ClassesOf(const ChartRequest& request)
{
  return request.Options.Group.empty()
    ? std::vector<RowClass>{ { std::string(), AllRows(request.Table) } }
    : ReadClasses(request.Table, request.Options.Group);
}

/** Counts what has no place in `plot`. */
std::vector<Batch> ReadBatches(const ChartRequest& request, const ChartAxis& axis, ChartPlot& plot)
{
  std::vector<Batch> batches;
  const std::vector<RowClass> classes = ClassesOf(request);
  for (std::size_t i = 0; i < request.AllSeries.size(); ++i)
  {
    if (request.AllSeries[i].Line.empty())
    {
      throw std::runtime_error("This kind of chart needs columns of single values.");
    }
    const std::vector<double> column = ReadNumbers(request.Table, request.AllSeries[i].Line);
    for (std::size_t j = 0; j < classes.size(); ++j)
    {
      Batch batch;
      batch.Class = classes[j].Name;
      batch.Series = static_cast<int>(i);
      batch.Category = static_cast<int>(classes.size() > 1 || !batch.Class.empty() ? j : i);
      for (const vtkIdType row : classes[j].Rows)
      {
        const double value = column[static_cast<std::size_t>(row)];
        const double place = axis.PlaceOf(value);
        plot.Undefined += std::isnan(value) ? 1 : 0;
        plot.Infinite += std::isinf(value) ? 1 : 0;
        plot.NotPositive += std::isfinite(value) && std::isnan(place) ? 1 : 0;
        if (std::isfinite(place))
        {
          batch.Places.emplace_back(place, row);
        }
      }
      std::sort(batch.Places.begin(), batch.Places.end());
      batches.push_back(std::move(batch));
    }
  }
  return batches;
}

/** An entry of the legend for bars and shapes of one style. */
ChartSeries LegendSeries(const std::string& label, int style)
{
  ChartSeries series;
  series.Label = label;
  series.Style = style;
  return series;
}

std::vector<std::string> CategoryNames(
  const ChartRequest& request, const std::vector<Batch>& batches)
{
  std::vector<std::string> names;
  for (const Batch& batch : batches)
  {
    names.resize(std::max(names.size(), static_cast<std::size_t>(batch.Category) + 1));
    names[static_cast<std::size_t>(batch.Category)] = batch.Class.empty()
      ? request.LabelOf(request.AllSeries[static_cast<std::size_t>(batch.Series)])
      : batch.Class;
  }
  return names;
}

/** Axes with classes along x and values along y. */
ChartPlot MakeCategoryAxes(const ChartRequest& request, std::vector<Batch>& batches)
{
  ChartPlot plot = MakeAxes(request);
  plot.X.Logarithmic = false;
  plot.X.Title = request.Options.Group.empty() ? "" : request.TitleOf(request.Options.Group);
  batches = ReadBatches(request, plot.Y, plot);
  plot.X.Categories = CategoryNames(request, batches);
  if (!request.Options.Group.empty() && request.AllSeries.size() > 1)
  {
    for (std::size_t i = 0; i < request.AllSeries.size(); ++i)
    {
      plot.AllSeries.push_back(
        LegendSeries(request.LabelOf(request.AllSeries[i]), static_cast<int>(i)));
    }
    plot.LegendIsNeeded = true;
  }
  return plot;
}

/** Where a batch stands among those of its class, and how wide it may be. */
struct Slot
{
  double Middle;
  double HalfWidth;
};

Slot SlotOf(const ChartRequest& request, const Batch& batch)
{
  const double share =
    request.Options.Group.empty() ? 1.0 : static_cast<double>(request.AllSeries.size());
  const double offset = request.Options.Group.empty() ? 0.0 : (batch.Series + 0.5) / share - 0.5;
  return { batch.Category + 0.8 * offset, 0.36 / share };
}

int StyleOf(const ChartRequest& request, const Batch& batch)
{
  return request.Options.Group.empty() || request.AllSeries.size() > 1 ? batch.Series : 0;
}

ChartSeries Line(
  const ChartAxis& axis, int style, double x0, double place0, double x1, double place1)
{
  ChartSeries line;
  line.Style = style;
  line.Joined = true;
  line.Marked = false;
  line.InLegend = false;
  line.OfRows = false;
  line.X = { x0, x1 };
  line.Y = { axis.ValueAt(place0), axis.ValueAt(place1) };
  return line;
}

void AddBox(const ChartRequest& request, const Batch& batch, double width, ChartPlot& plot)
{
  const std::vector<double> sorted = batch.Sorted();
  if (sorted.empty())
  {
    return;
  }
  const BoxStatistics box = DescribeBox(sorted);
  const Slot slot = SlotOf(request, batch);
  const int style = StyleOf(request, batch);
  const double half = width * slot.HalfWidth;
  const ChartAxis& axis = plot.Y;
  ChartBar bar;
  bar.Low[0] = slot.Middle - half;
  bar.High[0] = slot.Middle + half;
  bar.Low[1] = axis.ValueAt(box.LowerQuartile);
  bar.High[1] = axis.ValueAt(box.UpperQuartile);
  bar.Style = style;
  bar.Pale = true;
  bar.Name = (batch.Class.empty() ? plot.X.Categories[static_cast<std::size_t>(batch.Category)]
                                  : batch.Class) +
    ": median " + ReadableNumber(axis.ValueAt(box.Median)) + ", half of " +
    std::to_string(sorted.size()) + " values between " + ReadableNumber(bar.Low[1]) + " and " +
    ReadableNumber(bar.High[1]);
  ChartSeries outliers;
  outliers.Style = style;
  outliers.InLegend = false;
  outliers.Edged = false;
  outliers.Label = bar.Name;
  for (const auto& [place, row] : batch.Places)
  {
    const bool inside = place >= box.LowerWhisker && place <= box.UpperWhisker;
    bar.Rows.push_back(row);
    if (!inside)
    {
      outliers.X.push_back(slot.Middle);
      outliers.Y.push_back(axis.ValueAt(place));
      outliers.Rows.push_back(row);
    }
  }
  std::sort(bar.Rows.begin(), bar.Rows.end());
  plot.Bars.push_back(bar);
  const double x = slot.Middle;
  plot.AllSeries.push_back(Line(axis, style, x - half, box.Median, x + half, box.Median));
  plot.AllSeries.back().Label = bar.Name;
  for (const auto& [from, to] : { std::pair{ box.LowerQuartile, box.LowerWhisker },
         std::pair{ box.UpperQuartile, box.UpperWhisker } })
  {
    plot.AllSeries.push_back(Line(axis, style, x, from, x, to));
    plot.AllSeries.back().Label = bar.Name;
    plot.AllSeries.push_back(Line(axis, style, x - 0.5 * half, to, x + 0.5 * half, to));
    plot.AllSeries.back().Label = bar.Name;
  }
  plot.AllSeries.push_back(std::move(outliers));
}

void AddViolin(const ChartRequest& request, const Batch& batch, double most,
  const DensityCurve& density, ChartPlot& plot)
{
  const Slot slot = SlotOf(request, batch);
  ChartShape shape;
  shape.IsStrip = true;
  shape.Style = StyleOf(request, batch);
  const std::size_t n = density.X.size();
  for (std::size_t i = 0; i < 2 * n; ++i)
  {
    const std::size_t at = i < n ? i : 2 * n - 1 - i;
    const double half = slot.HalfWidth * density.Y[at] / most;
    shape.X.push_back(slot.Middle + (i < n ? half : -half));
    shape.Y.push_back(plot.Y.ValueAt(density.X[at]));
  }
  plot.Shapes.push_back(std::move(shape));
}

/** The only value of a column that has several of it; nothing for any other column. */
std::optional<double> OnlyValue(std::vector<double> column)
{
  std::erase_if(column, [](double value) { return !std::isfinite(value); });
  const bool isConstant = column.size() > 1 &&
    std::all_of(
      column.begin(), column.end(), [&](double value) { return value == column.front(); });
  return isConstant ? std::optional(column.front()) : std::nullopt;
}

void FinishDistribution(const ChartRequest& request, ChartPlot&& plot, ChartPicture& picture)
{
  // FinishPlot would count once more what was counted for the batches.
  const long counts[3] = { plot.Undefined, plot.Infinite, plot.NotPositive };
  picture.Plots.push_back(std::move(plot));
  FinishPicture(request, picture);
  ChartPlot& finished = picture.Plots.back();
  finished.Undefined = counts[0];
  finished.Infinite = counts[1];
  finished.NotPositive = counts[2];
  for (const ChartRequest::Series& series : request.AllSeries)
  {
    if (const auto value = OnlyValue(ReadNumbers(request.Table, series.Line)))
    {
      finished.Remarks.push_back(
        "All values of " + request.LabelOf(series) + " are " + ReadableNumber(*value) + ".");
    }
  }
}

/** A bar for every bin that has a value. */
void AddBins(
  const Batch& batch, const AxisRange& range, int bins, int style, bool isPale, ChartPlot& plot)
{
  std::vector<ChartBar> bars(static_cast<std::size_t>(bins));
  for (const auto& [place, row] : batch.Places)
  {
    bars[static_cast<std::size_t>(BinOf(place, range.Low, range.High, bins))].Rows.push_back(row);
  }
  for (std::size_t bin = 0; bin < bars.size(); ++bin)
  {
    ChartBar& bar = bars[bin];
    const auto number = static_cast<int>(bin);
    bar.Low[0] = plot.X.ValueAt(BinStart(number, range.Low, range.High, bins));
    bar.High[0] = plot.X.ValueAt(BinStart(number + 1, range.Low, range.High, bins));
    bar.Low[1] = 0.0;
    bar.High[1] = static_cast<double>(bar.Rows.size());
    bar.Style = style;
    bar.Pale = isPale;
    bar.Name = std::to_string(bar.Rows.size()) + " values from " + ReadableNumber(bar.Low[0]) +
      " to " + ReadableNumber(bar.High[0]);
    std::sort(bar.Rows.begin(), bar.Rows.end());
    if (!bar.Rows.empty())
    {
      plot.Bars.push_back(std::move(bar));
    }
  }
}

} // namespace

ChartPicture MakeBoxPlot(const ChartRequest& request)
{
  CheckRequest(request);
  std::vector<Batch> batches;
  ChartPlot plot = MakeCategoryAxes(request, batches);
  for (const Batch& batch : batches)
  {
    AddBox(request, batch, 1.0, plot);
  }
  ChartPicture picture;
  FinishDistribution(request, std::move(plot), picture);
  return picture;
}

ChartPicture MakeViolinPlot(const ChartRequest& request)
{
  CheckRequest(request);
  std::vector<Batch> batches;
  ChartPlot plot = MakeCategoryAxes(request, batches);
  std::vector<DensityCurve> densities;
  for (const Batch& batch : batches)
  {
    densities.push_back(EstimateDensity(batch.Sorted(), 160, true));
  }
  for (std::size_t i = 0; i < batches.size(); ++i)
  {
    const DensityCurve& density = densities[i];
    if (!density.X.empty())
    {
      // All violins are equally wide: their heights differ by orders of magnitude.
      const double most = *std::max_element(density.Y.begin(), density.Y.end());
      AddViolin(request, batches[i], most, density, plot);
    }
    AddBox(request, batches[i], density.X.empty() ? 1.0 : 0.22, plot);
    if (!density.X.empty())
    {
      plot.AllSeries.pop_back(); // the violin shows the outliers
    }
  }
  ChartPicture picture;
  FinishDistribution(request, std::move(plot), picture);
  return picture;
}

ChartPicture MakeHistogram(const ChartRequest& request)
{
  CheckRequest(request);
  ChartPlot plot = MakeAxes(request);
  const bool single = request.AllSeries.size() == 1;
  plot.X.Logarithmic = request.LogX;
  plot.X.Title = !request.XTitle.empty() ? request.XTitle
    : single                             ? request.LabelOf(request.AllSeries[0])
                                         : "";
  plot.Y.Title = request.YTitle.empty() ? "number of values" : request.YTitle;
  const std::vector<Batch> batches = ReadBatches(request, plot.X, plot);
  std::vector<double> all;
  for (const Batch& batch : batches)
  {
    const std::vector<double> sorted = batch.Sorted();
    all.insert(all.end(), sorted.begin(), sorted.end());
  }
  std::sort(all.begin(), all.end());
  const int bins = request.Options.Bins > 0 && !all.empty() && all.back() > all.front()
    ? request.Options.Bins
    : ChooseBins(all);
  const AxisRange range = all.empty() ? AxisRange{}
    : all.back() > all.front()        ? AxisRange{ all.front(), all.back() }
                                      : PadLinearRange(all.front(), all.back());
  for (std::size_t i = 0; i < batches.size(); ++i)
  {
    const Batch& batch = batches[i];
    const int style = static_cast<int>(i);
    AddBins(batch, range, bins, style, batches.size() > 1, plot);
    if (batches.size() > 1)
    {
      plot.AllSeries.push_back(LegendSeries(!batch.Class.empty()
          ? batch.Class
          : request.LabelOf(request.AllSeries[static_cast<std::size_t>(batch.Series)]),
        style));
    }
  }
  ChartPicture picture;
  FinishDistribution(request, std::move(plot), picture);
  AxisRange& counts = picture.Plots[0].Y.Range;
  counts.Low = picture.Plots[0].Y.Logarithmic ? counts.Low : 0.0;
  counts.High = counts.High > counts.Low ? counts.High : counts.Low + 1.0;
  return picture;
}

} // namespace pemesh
