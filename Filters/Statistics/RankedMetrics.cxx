// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RankedMetrics.h"

#include "Correlation.h"
#include "RelationWords.h"
#include "RidgeRegression.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pemesh
{

namespace
{

constexpr double LogarithmFrom = 10.0; // largest over smallest value
constexpr std::size_t NamedWeights = 5;

/** Undefined counts as nothing. */
double SizeOf(double value)
{
  return std::isnan(value) ? 0.0 : std::fabs(value);
}

std::tuple<double, double, double> Quality(const RankedMetric& metric)
{
  // Coefficients that differ by rounding alone are equal, so that the form decides.
  return { std::round(SizeOf(metric.Tested) * 1e12), SizeOf(metric.Fit), SizeOf(metric.Distance) };
}

/** Logarithms of positive values that span orders of magnitude: what one plots them by. */
void TakeLogarithms(std::vector<double>& sample)
{
  const auto [least, greatest] = std::minmax_element(sample.begin(), sample.end());
  if (sample.empty() || *least <= 0.0 || *greatest / *least < LogarithmFrom)
  {
    return;
  }
  std::transform(
    sample.begin(), sample.end(), sample.begin(), [](double value) { return std::log(value); });
}

struct JointSample
{
  std::vector<std::size_t> Metrics; // that vary
  std::vector<std::vector<double>> Predictors;
  std::vector<double> Response;
  RowFamilies Families;
};

bool IsComplete(const std::vector<RankedMetric>& metrics,
  const std::vector<std::vector<double>>& values, std::span<const double> response, std::size_t row)
{
  for (std::size_t i = 0; i < metrics.size(); ++i)
  {
    if (metrics[i].Rank > 0 && !std::isfinite(values[i][row]))
    {
      return false;
    }
  }
  return std::isfinite(response[row]);
}

JointSample GatherSample(const std::vector<RankedMetric>& metrics,
  const std::vector<std::vector<double>>& values, std::span<const double> response,
  const RowFamilies& families)
{
  JointSample sample;
  std::vector<std::size_t> rows;
  for (const std::vector<std::size_t>& family : families)
  {
    std::vector<std::size_t> own;
    for (const std::size_t row : family)
    {
      if (IsComplete(metrics, values, response, row))
      {
        own.push_back(rows.size());
        rows.push_back(row);
      }
    }
    if (!own.empty())
    {
      sample.Families.push_back(std::move(own));
    }
  }
  for (const std::size_t row : rows)
  {
    sample.Response.push_back(response[row]);
  }
  for (std::size_t i = 0; i < metrics.size(); ++i)
  {
    std::vector<double> column;
    for (const std::size_t row : rows)
    {
      column.push_back(values[i][row]);
    }
    if (metrics[i].Rank > 0 && !IsConstant(column))
    {
      TakeLogarithms(column);
      sample.Metrics.push_back(i);
      sample.Predictors.push_back(std::move(column));
    }
  }
  TakeLogarithms(sample.Response);
  return sample;
}

} // namespace

void RankMetrics(std::vector<RankedMetric>& metrics)
{
  std::stable_sort(metrics.begin(), metrics.end(),
    [](const RankedMetric& a, const RankedMetric& b)
    {
      const bool isDefined = !std::isnan(a.Tested);
      return isDefined != !std::isnan(b.Tested) ? isDefined : Quality(a) > Quality(b);
    });
  for (std::size_t i = 0; i < metrics.size(); ++i)
  {
    metrics[i].Rank = std::isnan(metrics[i].Tested) ? 0 : static_cast<int>(i) + 1;
  }
}

std::size_t CountTiesAtTop(const std::vector<RankedMetric>& metrics)
{
  const auto differs = [&](const RankedMetric& metric)
  {
    return metric.Rank == 0 ||
      std::get<0>(Quality(metric)) != std::get<0>(Quality(metrics.front()));
  };
  return static_cast<std::size_t>(
    std::find_if(metrics.begin(), metrics.end(), differs) - metrics.begin());
}

std::string RankJointly(std::vector<RankedMetric>& metrics,
  const std::vector<std::vector<double>>& values, std::span<const double> response,
  const RowFamilies& families)
{
  const JointSample sample = GatherSample(metrics, values, response, families);
  const RidgeModel model = FitRidge(sample.Predictors, sample.Response, sample.Families);
  if (!model.Refusal.empty())
  {
    return "No joint model: " + model.Refusal;
  }
  std::vector<std::size_t> order(sample.Metrics.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = i;
    metrics[sample.Metrics[i]].JointWeight = model.Weights[i];
  }
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    { return std::fabs(model.Weights[a]) > std::fabs(model.Weights[b]); });
  std::string weights;
  for (std::size_t place = 0; place < order.size(); ++place)
  {
    RankedMetric& metric = metrics[sample.Metrics[order[place]]];
    metric.JointRank = static_cast<int>(place) + 1;
    if (place < NamedWeights)
    {
      weights += (place == 0 ? "" : ", ") + metric.Name + " " + RoundedNumber(metric.JointWeight);
    }
  }
  const std::string rest = model.PredictedShare > 0.0
    ? "predict " + RoundedNumber(100.0 * model.PredictedShare) +
      " % of the variance of families left out"
    : "predict families left out no better than the mean of the others";
  return "Jointly, " + std::to_string(order.size()) +
    (order.size() == 1 ? " metric " : " metrics ") + rest + " (" +
    std::to_string(sample.Families.size()) + " families, " + std::to_string(model.Rows) +
    " rows, ridge penalty " + RoundedNumber(model.Penalty) +
    "); largest standardised weights: " + weights + ".";
}

} // namespace pemesh
