// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ResampledColumns.h"

#include "CoefficientKinds.h"
#include "SumOfProducts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace pemesh
{

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

} // namespace

/** What a sample makes of the columns; only rows that were drawn. */
struct ResampledColumns::Drawn
{
  std::vector<std::size_t> Rows;          // numbers within ResampledColumns::Rows
  std::vector<int> TimesOf;               // of all of these
  std::vector<double> Times;              // of those drawn
  int Count = 0;                          // the sum of the times
  std::vector<double> Ranks;              // scratch: of all rows
  std::vector<double> Plain;              // column after column: centred, less what is given
  std::vector<double> Weighted;           // the same times how often each row was drawn
  std::vector<double> Squares;            // of each column; 0 where nothing is left
  std::vector<std::vector<double>> Basis; // orthonormal, of the given columns

  std::span<double> PlainOf(std::size_t column)
  {
    return std::span(this->Plain).subspan(column * this->Rows.size(), this->Rows.size());
  }
  std::span<double> WeightedOf(std::size_t column)
  {
    return std::span(this->Weighted).subspan(column * this->Rows.size(), this->Rows.size());
  }
  double Product(std::span<const double> u, std::span<const double> v) const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i)
    {
      sum += this->Times[i] * u[i] * v[i];
    }
    return sum;
  }
};

ResampledColumns::ResampledColumns(const PairsOfColumns& all, const CoefficientKind& kind,
  std::span<const std::size_t> rows, std::span<const std::size_t> pairs)
  : Kind(kind)
  , Rows(rows.begin(), rows.end())
{
  std::map<std::size_t, std::size_t> known;
  const auto indexOf = [&](std::size_t column)
  {
    const auto [place, isNew] = known.emplace(column, this->Columns.size());
    if (isNew)
    {
      this->AddColumn(all.Columns[column]);
    }
    return place->second;
  };
  for (const std::size_t column : all.Given)
  {
    this->Given.push_back(indexOf(column));
  }
  for (const std::size_t pair : pairs)
  {
    const std::size_t first = indexOf(all.Pairs[pair].first);
    this->Pairs.emplace_back(first, indexOf(all.Pairs[pair].second));
  }
}

std::size_t ResampledColumns::AddColumn(const std::vector<double>& column)
{
  Column& added = this->Columns.emplace_back();
  double largest = 0.0;
  for (const std::size_t row : this->Rows)
  {
    added.Values.push_back(column[row]);
    largest = std::max(largest, std::fabs(column[row]));
  }
  added.Order.resize(this->Rows.size());
  std::iota(added.Order.begin(), added.Order.end(), 0);
  std::sort(added.Order.begin(), added.Order.end(),
    [&](std::size_t a, std::size_t b)
    { return added.Values[a] != added.Values[b] ? added.Values[a] < added.Values[b] : a < b; });
  if (this->Kind.IsPearson && !this->Kind.OfRanks && largest > 0.0)
  {
    for (double& value : added.Values)
    {
      value /= largest; // squares must not overflow
    }
  }
  return this->Columns.size() - 1;
}

void ResampledColumns::Evaluate(const std::vector<int>& times, std::size_t sample,
  std::size_t samples, std::vector<double>& values) const
{
  this->Kind.IsPearson ? this->EvaluateProducts(times, sample, samples, values)
                       : this->EvaluateEach(times, sample, samples, values);
}

void ResampledColumns::PrepareColumn(std::size_t column, Drawn& drawn) const
{
  const std::span<double> plain = drawn.PlainOf(column);
  const Column& of = this->Columns[column];
  double& squares = drawn.Squares[column];
  if (this->Kind.OfRanks)
  {
    // Twice the mid-ranks less (n + 1): exact integers of mean zero.
    int below = 0;
    for (std::size_t first = 0; first < of.Order.size();)
    {
      std::size_t last = first;
      int here = 0;
      while (last < of.Order.size() && of.Values[of.Order[last]] == of.Values[of.Order[first]])
      {
        here += drawn.TimesOf[of.Order[last++]];
      }
      for (std::size_t i = first; i < last; ++i)
      {
        drawn.Ranks[of.Order[i]] = 2 * below + here - drawn.Count;
      }
      below += here;
      first = last;
    }
  }
  double sum = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    plain[i] = this->Kind.OfRanks ? drawn.Ranks[drawn.Rows[i]] : of.Values[drawn.Rows[i]];
    sum += drawn.Times[i] * plain[i];
    largest = std::max(largest, std::fabs(plain[i]));
  }
  const double mean = this->Kind.OfRanks ? 0.0 : sum / drawn.Count;
  std::for_each(plain.begin(), plain.end(), [mean](double& value) { value -= mean; });
  squares = drawn.Product(plain, plain);
  if (!(squares > 1e-28 * largest * largest * drawn.Count)) // rounding alone
  {
    squares = 0.0;
  }
  const double before = squares;
  for (int pass = 0; pass < 2; ++pass) // the second takes what rounding left of the first
  {
    for (const std::vector<double>& direction : drawn.Basis)
    {
      const double part = drawn.Product(plain, direction);
      std::transform(plain.begin(), plain.end(), direction.begin(), plain.begin(),
        [part](double value, double along) { return value - part * along; });
    }
  }
  if (!drawn.Basis.empty())
  {
    squares = drawn.Product(plain, plain);
    squares = squares >= 1e-20 * before ? squares : 0.0; // as RegressionResiduals
  }
  const std::span<double> weighted = drawn.WeightedOf(column);
  std::transform(
    plain.begin(), plain.end(), drawn.Times.begin(), weighted.begin(), std::multiplies<>());
}

void ResampledColumns::PrepareGiven(Drawn& drawn) const
{
  for (const std::size_t column : this->Given)
  {
    this->PrepareColumn(column, drawn);
    if (drawn.Squares[column] > 0.0)
    {
      const std::span<double> plain = drawn.PlainOf(column);
      std::vector<double>& direction = drawn.Basis.emplace_back(plain.begin(), plain.end());
      const double length = std::sqrt(drawn.Squares[column]);
      std::for_each(
        direction.begin(), direction.end(), [length](double& value) { value /= length; });
    }
  }
}

void ResampledColumns::EvaluateProducts(const std::vector<int>& times, std::size_t sample,
  std::size_t samples, std::vector<double>& values) const
{
  Drawn drawn;
  for (std::size_t i = 0; i < this->Rows.size(); ++i)
  {
    drawn.TimesOf.push_back(times[this->Rows[i]]);
    drawn.Count += drawn.TimesOf.back();
    if (drawn.TimesOf.back() > 0)
    {
      drawn.Rows.push_back(i);
      drawn.Times.push_back(drawn.TimesOf.back());
    }
  }
  if (!this->Given.empty() && drawn.Count < static_cast<int>(this->Given.size()) + 3)
  {
    return; // as PartialCorrelation
  }
  drawn.Ranks.resize(this->Rows.size());
  drawn.Plain.resize(this->Columns.size() * drawn.Rows.size());
  drawn.Weighted.resize(drawn.Plain.size());
  drawn.Squares.resize(this->Columns.size());
  this->PrepareGiven(drawn);
  for (std::size_t column = 0; column < this->Columns.size(); ++column)
  {
    this->PrepareColumn(column, drawn);
  }
  for (std::size_t pair = 0; pair < this->Pairs.size(); ++pair)
  {
    const auto [x, y] = this->Pairs[pair];
    const double squares = drawn.Squares[x] * drawn.Squares[y];
    if (squares > 0.0)
    {
      const double product = SumOfProducts(drawn.WeightedOf(x), drawn.PlainOf(y));
      values[pair * samples + sample] = std::clamp(product / std::sqrt(squares), -1.0, 1.0);
    }
  }
}

void ResampledColumns::EvaluateEach(const std::vector<int>& times, std::size_t sample,
  std::size_t samples, std::vector<double>& values) const
{
  const auto expand = [&](const Column& column)
  {
    std::vector<double> drawn;
    for (std::size_t i = 0; i < this->Rows.size(); ++i)
    {
      drawn.insert(drawn.end(), static_cast<std::size_t>(times[this->Rows[i]]), column.Values[i]);
    }
    return drawn;
  };
  std::vector<std::vector<double>> columns;
  std::transform(this->Columns.begin(), this->Columns.end(), std::back_inserter(columns), expand);
  std::vector<std::span<const double>> given;
  for (const std::size_t column : this->Given)
  {
    given.emplace_back(columns[column]);
  }
  for (std::size_t pair = 0; pair < this->Pairs.size(); ++pair)
  {
    const auto [x, y] = this->Pairs[pair];
    values[pair * samples + sample] = CoefficientGiven(this->Kind, columns[x], columns[y], given);
  }
}

} // namespace pemesh
