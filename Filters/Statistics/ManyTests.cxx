// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ManyTests.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

/** The tests that have a p-value, smallest first. */
std::vector<std::size_t> OrderOfTests(std::span<const double> p)
{
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    if (!std::isnan(p[i]))
    {
      order.push_back(i);
    }
  }
  std::stable_sort(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  return order;
}

} // namespace

std::vector<double> HolmPValues(std::span<const double> p)
{
  std::vector<double> adjusted(p.begin(), p.end());
  const std::vector<std::size_t> order = OrderOfTests(p);
  double largest = 0.0;
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    largest = std::max(largest, static_cast<double>(order.size() - k) * p[order[k]]);
    adjusted[order[k]] = std::min(largest, 1.0);
  }
  return adjusted;
}

std::vector<double> BenjaminiHochbergPValues(std::span<const double> p)
{
  std::vector<double> adjusted(p.begin(), p.end());
  const std::vector<std::size_t> order = OrderOfTests(p);
  const auto count = static_cast<double>(order.size());
  double smallest = 1.0;
  for (std::size_t k = order.size(); k > 0; --k)
  {
    smallest = std::min(smallest, count / static_cast<double>(k) * p[order[k - 1]]);
    adjusted[order[k - 1]] = smallest;
  }
  return adjusted;
}

} // namespace pemesh
