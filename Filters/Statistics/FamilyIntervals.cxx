// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CoefficientKinds.h"
#include "Correlation.h"
#include "FamilyTests.h"
#include "ParallelLoop.h"
#include "ResampledColumns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace pemesh
{

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

/** Pairs whose values are there in the same rows: one sample serves all of them. */
struct PairsOfRows
{
  std::vector<std::size_t> Rows;
  std::vector<std::size_t> Pairs;
};

std::vector<PairsOfRows> GroupPairs(const PairsOfColumns& all)
{
  std::map<std::vector<std::size_t>, std::vector<std::size_t>> byRows;
  const std::size_t rows = all.Columns.empty() ? 0 : all.Columns.front().size();
  for (std::size_t pair = 0; pair < all.Pairs.size(); ++pair)
  {
    std::vector<std::size_t> needed = all.Given;
    needed.insert(needed.end(), { all.Pairs[pair].first, all.Pairs[pair].second });
    std::vector<std::size_t> present;
    for (std::size_t row = 0; row < rows; ++row)
    {
      const bool isThere = std::none_of(needed.begin(), needed.end(),
        [&](std::size_t column) { return std::isnan(all.Columns[column][row]); });
      if (isThere)
      {
        present.push_back(row);
      }
    }
    byRows[present].push_back(pair);
  }
  std::vector<PairsOfRows> groups;
  for (auto& [present, pairs] : byRows)
  {
    groups.push_back({ present, std::move(pairs) });
  }
  return groups;
}

/** The quantile as R's type 7 and NumPy define it. */
double Quantile(const std::vector<double>& sorted, double share)
{
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/** All that the samples need to know, and how much of the work is done. */
class Bootstrap
{
public:
  Bootstrap(const PairsOfColumns& all, const CoefficientKind& kind, const RowFamilies& families,
    int samples, double level, std::uint64_t seed, const TestProgress& progress)
    : All(all)
    , Kind(kind)
    , Families(families)
    , Samples(static_cast<std::size_t>(samples))
    , Level(level)
    , Seed(seed)
    , Progress(progress)
    , Intervals(all.Pairs.size(), { Undefined, Undefined })
  {
  }

  /** Empty where it was told to stop. */
  std::vector<Interval> Run()
  {
    constexpr std::size_t mostValues = 16'000'000; // that are kept at a time, 8 bytes each
    for (const PairsOfRows& group : GroupPairs(this->All))
    {
      const std::size_t portion = std::max<std::size_t>(
        1, std::min(mostValues / this->Samples, Quick / this->CostOf(group.Rows)));
      for (std::size_t first = 0; first < group.Pairs.size(); first += portion)
      {
        const std::size_t count = std::min(portion, group.Pairs.size() - first);
        if (!this->RunPortion(group.Rows, std::span(group.Pairs).subspan(first, count)))
        {
          return {};
        }
      }
    }
    return this->Intervals;
  }

private:
  static constexpr std::size_t Quick = 200'000'000; // products, in a second or less

  /** Of one sample of a pair, in products. */
  std::size_t CostOf(const std::vector<std::size_t>& rows) const
  {
    return (rows.size() + 1) * (this->Kind.IsPearson ? 1 : 200);
  }

  bool RunPortion(const std::vector<std::size_t>& rows, std::span<const std::size_t> pairs)
  {
    const std::size_t block = // samples between two reports of progress
      std::clamp<std::size_t>(Quick / (pairs.size() * this->CostOf(rows)), 2, 64);
    const ResampledColumns columns(this->All, this->Kind, rows, pairs);
    this->Values.assign(pairs.size() * this->Samples, Undefined);
    std::mt19937_64 bits(this->Seed); // every pair sees the same samples
    const std::size_t allRows = this->All.Columns.front().size();
    std::vector<std::vector<int>> times;
    for (std::size_t first = 0; first < this->Samples; first += block)
    {
      const std::size_t last = std::min(first + block, this->Samples);
      times.clear();
      for (std::size_t sample = first; sample < last; ++sample)
      {
        times.push_back(DrawFamilies(this->Families, allRows, bits));
      }
      ParallelLoop(static_cast<vtkIdType>(first), static_cast<vtkIdType>(last), 1,
        [&](vtkIdType from, vtkIdType to)
        {
          for (auto sample = static_cast<std::size_t>(from); sample < static_cast<std::size_t>(to);
               ++sample)
          {
            columns.Evaluate(times[sample - first], sample, this->Samples, this->Values);
          }
        });
      this->Done += static_cast<double>(pairs.size() * (last - first));
      const double whole = static_cast<double>(this->All.Pairs.size() * this->Samples);
      if (this->Progress && !this->Progress(this->Done / whole))
      {
        return false;
      }
    }
    this->FindBounds(pairs);
    return true;
  }

  void FindBounds(std::span<const std::size_t> pairs)
  {
    ParallelLoop(0, static_cast<vtkIdType>(pairs.size()), 16,
      [&](vtkIdType from, vtkIdType to)
      {
        std::vector<double> values;
        for (auto i = static_cast<std::size_t>(from); i < static_cast<std::size_t>(to); ++i)
        {
          const auto all = std::span(this->Values).subspan(i * this->Samples, this->Samples);
          values.clear();
          std::copy_if(all.begin(), all.end(), std::back_inserter(values),
            [](double value) { return !std::isnan(value); });
          if (static_cast<double>(values.size()) >= 0.9 * static_cast<double>(this->Samples))
          {
            std::sort(values.begin(), values.end());
            this->Intervals[pairs[i]] = { Quantile(values, (1 - this->Level) / 2),
              Quantile(values, (1 + this->Level) / 2) };
          }
        }
      });
  }

  const PairsOfColumns& All;
  const CoefficientKind& Kind;
  const RowFamilies& Families;
  std::size_t Samples;
  double Level;
  std::uint64_t Seed;
  const TestProgress& Progress;
  std::vector<Interval> Intervals;
  std::vector<double> Values; // of the portion: all samples of one pair after the other
  double Done = 0.0;          // pairs times samples
};

} // namespace

std::vector<Interval> FamilyIntervals(const PairsOfColumns& pairs, const CoefficientKind& kind,
  const RowFamilies& families, int samples, double level, std::uint64_t seed,
  const TestProgress& progress)
{
  if (families.size() < FewestFamilies || samples < 1 || pairs.Columns.empty())
  {
    return std::vector<Interval>(pairs.Pairs.size(), { Undefined, Undefined });
  }
  return Bootstrap(pairs, kind, families, samples, level, seed, progress).Run();
}

} // namespace pemesh
