// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementLoad.h"

#include <cmath>

namespace pemesh
{

namespace
{

// Of errors as they follow from differences (Quadrature.h), which is no proof: far below the 1e-10
// that is promised.
constexpr double LoadTolerance = 1.0e-13;
constexpr int ExtraFluxPoints = 8; // fluxes are no polynomials

// Relative to the integral of |f|, which also bounds the moments (the monomials are at most about
// one), and no closer than rounding allows; the last component is the bound of rounding.
bool LoadsAgree(
  const TriangleIntegrals& coarse, const TriangleIntegrals& fine, double, std::size_t step)
{
  static const auto differences = DifferencesAllowed(LoadTolerance, GeneralSteps());
  // That f is smooth on the scale of the triangle must show twice, because once may be chance.
  constexpr double smooth = 1.0e-3;
  const std::size_t moments = fine.Value.size() - 1;
  // Where all that is seen of f is zero, or it is not a number, there is nothing to compare.
  if (!(fine.Absolute[0] > 0.0))
  {
    return step + 1 == differences.size() || !std::isfinite(fine.Absolute[0]);
  }
  const double rounding = fine.Absolute[moments];
  if (step == 0 &&
    !(std::abs(coarse.FirstDegree[0] - fine.Value[0]) <= smooth * fine.Absolute[0] + rounding))
  {
    return false;
  }
  const double allowed = differences[step] * fine.Absolute[0] + rounding;
  for (std::size_t k = 0; k < moments; ++k)
  {
    if (!(std::abs(coarse.Value[k] - fine.Value[k]) <= allowed))
    {
      return false;
    }
  }
  return true;
}

std::size_t NumberOfLoadMoments(int degree)
{
  return static_cast<std::size_t>(PolynomialCount(degree));
}

} // namespace

ElementLoad::ElementLoad(const EllipticProblem& problem, const VirtualElementOptions& options)
  : Problem(problem)
  , Degree(options.Load == LoadProjection::LowerDegree ? options.Order - 1 : options.Order)
  , Order(options.Order)
  , Integrator(NumberOfLoadMoments(this->Degree) + 1, GeneralSteps(), problem.IsSmooth() ? 0 : 1)
  , Nodes(GaussLobatto(options.Order + 1))
  , FluxRule(GaussLegendre(options.Order + ExtraFluxPoints))
  , Moments(NumberOfLoadMoments(this->Degree) + 1)
{
}

void ElementLoad::Compute(const ElementMatrices& matrices)
{
  SourceBlock source;
  const auto integrand = [&](const PointBlock& points, IntegrandValues values)
  {
    this->Problem.EvaluateSource(points, source);
    values[0] = source.Source;
    values.back() = source.Uncertainty;
    if (values.size() > 2)
    {
      matrices.Basis().EvaluateMonomials(points, this->Degree, this->Monomials);
      for (std::size_t k = 1; k + 1 < values.size(); ++k)
      {
        const double* monomial = this->Monomials.col(static_cast<Eigen::Index>(k)).data();
        for (std::size_t i = 0; i < PointBlockSize; ++i)
        {
          values[k][i] = source.Source[i] * monomial[i];
        }
      }
    }
  };
  std::fill(this->Moments.begin(), this->Moments.end(), 0.0);
  for (const Triangle2& triangle : matrices.Triangles())
  {
    this->Integrator.Add(triangle, integrand, LoadsAgree, this->Moments);
  }
  const Eigen::Map<const Eigen::VectorXd> moments(
    this->Moments.data(), static_cast<Eigen::Index>(this->Moments.size()) - 1);
  this->Load.noalias() =
    matrices.Load().transpose() * matrices.Basis().FromMonomialIntegrals(moments);
}

void ElementLoad::AddFluxes(const std::vector<Point2>& vertices, const std::vector<char>& edges)
{
  const std::size_t n = vertices.size();
  for (std::size_t edge = 0; edge < n; ++edge)
  {
    if (!edges[edge])
    {
      continue;
    }
    const Point2& a = vertices[edge];
    const Point2& b = vertices[(edge + 1) % n];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const Point2 normal = { (b.y - a.y) / length, (a.x - b.x) / length };
    for (std::size_t q = 0; q < this->FluxRule.Points.size(); ++q)
    {
      const double t = this->FluxRule.Points[q];
      const double flux =
        this->Problem.Flux({ a.x + t * (b.x - a.x), a.y + t * (b.y - a.y) }, normal);
      const std::vector<double> shares = LagrangeValues(this->Nodes.Points, t);
      for (int node = 0; node <= this->Order; ++node)
      {
        const Eigen::Index dof =
          ElementEdgeDof(n, this->Order, static_cast<Eigen::Index>(edge), node);
        this->Load(dof) +=
          length * this->FluxRule.Weights[q] * flux * shares[static_cast<std::size_t>(node)];
      }
    }
  }
}

} // namespace pemesh
