// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "GaussRules.h"

#include <cmath>
#include <numbers>

namespace pemesh
{

namespace
{

// P_n(t), its derivative and the one before it, P_(n-1)(t).
struct Legendre
{
  double Value = 1.0;
  double Previous = 0.0;
  double Derivative = 0.0;
};

Legendre EvaluateLegendre(int n, double t)
{
  Legendre p;
  for (int k = 1; k <= n; ++k)
  {
    const double next = ((2 * k - 1) * t * p.Value - (k - 1) * p.Previous) / k;
    p.Derivative = k * p.Value + t * p.Derivative; // P_k' = k P_(k-1) + t P_(k-1)'
    p.Previous = p.Value;
    p.Value = next;
  }
  return p;
}

// Puts a pair of points -t and t of [-1, 1] and their weight, which is given for an interval of
// length two.
void SetPair(GaussRule& rule, std::size_t i, double t, double weight)
{
  const std::size_t j = rule.Points.size() - 1 - i;
  rule.Points[i] = 0.5 * (1.0 - t);
  rule.Points[j] = 1.0 - rule.Points[i];
  rule.Weights[i] = rule.Weights[j] = 0.5 * weight;
}

GaussRule MakeRule(int n)
{
  const std::size_t size = static_cast<std::size_t>(n);
  return { std::vector<double>(size), std::vector<double>(size) };
}

constexpr int NewtonSteps = 12;

} // namespace

GaussRule GaussLegendre(int n)
{
  GaussRule rule = MakeRule(n);
  for (int i = 0; i < (n + 1) / 2; ++i)
  {
    double t = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    for (int step = 0; step < NewtonSteps; ++step)
    {
      const Legendre p = EvaluateLegendre(n, t);
      t -= p.Value / p.Derivative;
    }
    t = 2 * i + 1 == n ? 0.0 : t;
    const double slope = EvaluateLegendre(n, t).Derivative;
    SetPair(rule, static_cast<std::size_t>(i), t, 2.0 / ((1.0 - t * t) * slope * slope));
  }
  return rule;
}

GaussRule GaussLobatto(int n)
{
  GaussRule rule = MakeRule(n);
  const int m = n - 1;
  SetPair(rule, 0, 1.0, 2.0 / (n * m));
  for (int i = 1; i < (n + 1) / 2; ++i)
  {
    // The zeros of P_m'; its derivative is (2 t P_m' - m (m + 1) P_m) / (1 - t^2).
    double t = std::cos(std::numbers::pi * i / m);
    for (int step = 0; step < NewtonSteps; ++step)
    {
      const Legendre p = EvaluateLegendre(m, t);
      t -= p.Derivative * (1.0 - t * t) / (2.0 * t * p.Derivative - m * n * p.Value);
    }
    t = 2 * i + 1 == n ? 0.0 : t;
    const double value = EvaluateLegendre(m, t).Value;
    SetPair(rule, static_cast<std::size_t>(i), t, 2.0 / (n * m * value * value));
  }
  return rule;
}

std::vector<double> LagrangeValues(const std::vector<double>& nodes, double place)
{
  std::vector<double> values(nodes.size(), 1.0);
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    for (std::size_t j = 0; j < nodes.size(); ++j)
    {
      if (j != i)
      {
        values[i] *= (place - nodes[j]) / (nodes[i] - nodes[j]);
      }
    }
  }
  return values;
}

} // namespace pemesh
