// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * How fast columns are correlated: all pairs, p-values by families and intervals.
 *
 *   BenchmarkStatistics [columns = 200] [rows = 1000] [families = 20]
 *
 * One line a task: pairs, seconds by the clock and of all processors. The baseline is distance
 * correlation by its definition, in O(n^2).
 */
#include "CoefficientKinds.h"
#include "DistanceCorrelation.h"
#include "PairCorrelation.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <string>

namespace
{

/** All pairs of columns that hang together more or less, a few values missing in the last one. */
pemesh::PairsOfColumns MakePairs(std::size_t columns, std::size_t rows)
{
  std::mt19937_64 bits(1);
  const auto uniform = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  pemesh::PairsOfColumns pairs;
  pairs.Columns.resize(columns);
  for (std::size_t row = 0; row < rows; ++row)
  {
    const double common = uniform();
    for (std::size_t column = 0; column < columns; ++column)
    {
      pairs.Columns[column].push_back(0.1 + uniform() + static_cast<double>(column % 7) * common);
    }
  }
  for (std::size_t x = 0; x < columns; ++x)
  {
    for (std::size_t y = x + 1; y < columns; ++y)
    {
      pairs.Pairs.emplace_back(x, y);
    }
  }
  return pairs;
}

template <typename Task>
void Measure(const char* name, std::size_t pairs, Task task)
{
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t before = std::clock();
  task();
  const std::chrono::duration<double> clock = std::chrono::steady_clock::now() - start;
  std::printf("%-44s %8zu pairs %8.2f s %8.2f s of processors\n", name, pairs, clock.count(),
    static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
}

/** Sums of products of distances alone, pair by pair: less than the definition asks for. */
double PlainDistances(const std::vector<double>& x, const std::vector<double>& y)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      sum += std::fabs(x[i] - x[j]) * std::fabs(y[i] - y[j]);
    }
  }
  return sum;
}

std::size_t Argument(int argc, char** argv, int index, std::size_t fallback)
{
  return argc > index ? std::stoul(argv[index]) : fallback;
}

} // namespace

int main(int argc, char** argv)
{
  const std::size_t columns = Argument(argc, argv, 1, 200);
  const std::size_t rows = Argument(argc, argv, 2, 1000);
  const std::size_t families = Argument(argc, argv, 3, 20);
  const pemesh::PairsOfColumns pairs = MakePairs(columns, rows);
  const std::size_t count = pairs.Pairs.size();
  pemesh::PairOptions options;
  Measure("coefficients, trend, form", count, [&] { pemesh::CorrelatePairs(pairs, options); });
  double sum = 0.0;
  Measure("distance correlation", count,
    [&]
    {
      for (const auto& [x, y] : pairs.Pairs)
      {
        sum += pemesh::DistanceCorrelation(pairs.Columns[x], pairs.Columns[y]);
      }
    });
  Measure("baseline: products of all distances", count,
    [&]
    {
      for (const auto& [x, y] : pairs.Pairs)
      {
        sum += PlainDistances(pairs.Columns[x], pairs.Columns[y]);
      }
    });
  std::vector<std::string> labels;
  for (std::size_t row = 0; row < rows; ++row)
  {
    labels.push_back(std::to_string(row * families / rows));
  }
  const pemesh::RowFamilies rowFamilies = pemesh::GroupRows(labels);
  const auto& spearman = *pemesh::FindCoefficientKind("spearman");
  Measure("p-values, 999 arrangements", count,
    [&] { sum += pemesh::FamilyPValues(pairs, spearman, rowFamilies, 999, 1).front(); });
  Measure("intervals, 1000 samples", count,
    [&]
    { sum += pemesh::FamilyIntervals(pairs, spearman, rowFamilies, 1000, 0.95, 1).front().Low; });
  return std::isfinite(sum) ? EXIT_SUCCESS : EXIT_FAILURE;
}
