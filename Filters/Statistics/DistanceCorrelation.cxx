// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DistanceCorrelation.h"

#include "Correlation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace pemesh
{

namespace
{

/** Shifted and scaled into [-1, 1], which distances do not see but for a factor that cancels. */
std::vector<double> Scaled(std::span<const double> sample)
{
  const auto [least, greatest] = std::minmax_element(sample.begin(), sample.end());
  const double middle = *least / 2 + *greatest / 2;
  const double half = *greatest / 2 - *least / 2; // halves, because the difference may overflow
  std::vector<double> scaled(sample.size());
  std::transform(sample.begin(), sample.end(), scaled.begin(),
    [&](double value) { return (value - middle) / half; });
  return scaled;
}

std::vector<std::size_t> OrderOf(const std::vector<double>& sample)
{
  std::vector<std::size_t> order(sample.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    { return sample[a] != sample[b] ? sample[a] < sample[b] : a < b; });
  return order;
}

/** sum_j |x_i - x_j| for every i, from the sums of those before and behind in order. */
std::vector<double> DistanceSums(
  const std::vector<double>& sample, const std::vector<std::size_t>& order)
{
  const double total = std::accumulate(sample.begin(), sample.end(), 0.0);
  const auto n = static_cast<double>(sample.size());
  std::vector<double> sums(sample.size());
  double before = 0.0;
  double count = 0.0;
  for (const std::size_t i : order)
  {
    sums[i] = sample[i] * (2 * count - n) + total - 2 * before;
    before += sample[i];
    count += 1.0;
  }
  return sums;
}

/** Of the points met so far: their number, and the sums of x, y and x y. */
struct Moments
{
  double Count = 0.0;
  double X = 0.0;
  double Y = 0.0;
  double XY = 0.0;

  void Add(const Moments& other)
  {
    this->Count += other.Count;
    this->X += other.X;
    this->Y += other.Y;
    this->XY += other.XY;
  }
};

/** Sums over all ranks up to one, each found and changed in O(log n) (P. M. Fenwick, 1994). */
class MomentsByRank
{
public:
  explicit MomentsByRank(std::size_t n)
    : Nodes(n + 1)
  {
  }

  void Add(std::size_t rank, const Moments& moments)
  {
    for (std::size_t i = rank + 1; i < this->Nodes.size(); i += i & (~i + 1))
    {
      this->Nodes[i].Add(moments);
    }
  }

  Moments UpTo(std::size_t rank) const
  {
    Moments sum;
    for (std::size_t i = rank + 1; i > 0; i -= i & (~i + 1))
    {
      sum.Add(this->Nodes[i]);
    }
    return sum;
  }

private:
  std::vector<Moments> Nodes;
};

/** sum over all i, j of |x_i - x_j| |y_i - y_j|. */
double ProductSum(const std::vector<double>& x, const std::vector<double>& y,
  const std::vector<std::size_t>& orderX, const std::vector<std::size_t>& orderY)
{
  std::vector<std::size_t> rankY(y.size());
  for (std::size_t rank = 0; rank < orderY.size(); ++rank)
  {
    rankY[orderY[rank]] = rank;
  }
  MomentsByRank met(x.size());
  Moments all;
  double sum = 0.0;
  for (const std::size_t i : orderX)
  {
    // (x_i - x_j)(y_i - y_j) summed over those met, less twice over those above y_i.
    const auto product = [&](const Moments& m)
    { return x[i] * y[i] * m.Count - x[i] * m.Y - y[i] * m.X + m.XY; };
    sum += 2 * product(met.UpTo(rankY[i])) - product(all);
    const Moments own{ 1.0, x[i], y[i], x[i] * y[i] };
    met.Add(rankY[i], own);
    all.Add(own);
  }
  return 2 * sum;
}

/** What the formula needs of one sample. */
struct Distances
{
  std::vector<double> Values;
  std::vector<std::size_t> Order;
  std::vector<double> Sums;
  double Total;

  explicit Distances(std::span<const double> sample)
    : Values(Scaled(sample))
    , Order(OrderOf(Values))
    , Sums(DistanceSums(Values, Order))
    , Total(std::accumulate(Sums.begin(), Sums.end(), 0.0))
  {
  }
};

/** n^2 dCov^2 = S_1 + S_2 - 2 S_3 of the paper, with n^2 S_1 = `products`. */
double Covariance(const Distances& x, const Distances& y, double products)
{
  const auto n = static_cast<double>(x.Values.size());
  const double cross = std::inner_product(x.Sums.begin(), x.Sums.end(), y.Sums.begin(), 0.0);
  return products - 2 * cross / n + x.Total * y.Total / (n * n);
}

/** With itself: the sum of the squares of all differences needs no sweep. */
double Variance(const Distances& x)
{
  const auto n = static_cast<double>(x.Values.size());
  const double sum = std::accumulate(x.Values.begin(), x.Values.end(), 0.0);
  const double squares =
    std::inner_product(x.Values.begin(), x.Values.end(), x.Values.begin(), 0.0);
  return Covariance(x, x, 2 * (n * squares - sum * sum));
}

} // namespace

double DistanceCorrelation(std::span<const double> x, std::span<const double> y)
{
  const auto infinite = [](double value) { return !std::isfinite(value); };
  if (x.size() < 2 || IsConstant(x) || IsConstant(y) || std::any_of(x.begin(), x.end(), infinite) ||
    std::any_of(y.begin(), y.end(), infinite))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const Distances ofX(x);
  const Distances ofY(y);
  const double products = ProductSum(ofX.Values, ofY.Values, ofX.Order, ofY.Order);
  const double squared = Covariance(ofX, ofY, products) / std::sqrt(Variance(ofX) * Variance(ofY));
  return std::sqrt(std::clamp(squared, 0.0, 1.0));
}

} // namespace pemesh
