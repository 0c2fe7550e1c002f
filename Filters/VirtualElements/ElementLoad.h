// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The right-hand side of one element: f, and what is given of kappa du/dn, against the basis
 * functions. Private to the module (needs Eigen).
 */
#ifndef pemesh_ElementLoad_h
#define pemesh_ElementLoad_h

#include "ElementMatrices.h"
#include "EllipticProblem.h"

#include <vector>

namespace pemesh
{

class ElementLoad
{
public:
  ElementLoad(const EllipticProblem& problem, const VirtualElementOptions& options);

  /**
   * The integrals of f times the projections, to a relative 1e-10 of the integral of |f|, as far as
   * quadrature sees f (Quadrature.h).
   */
  void Compute(const ElementMatrices& matrices);

  /** Adds the integrals of kappa du/dn over the edges that are marked. */
  void AddFluxes(const std::vector<Point2>& vertices, const std::vector<char>& edges);

  const Eigen::VectorXd& Values() const { return this->Load; }

private:
  const EllipticProblem& Problem;
  int Degree; // of the projections
  int Order;
  TriangleIntegrator Integrator;
  GaussRule Nodes;
  GaussRule FluxRule;
  BlockValues Monomials;
  std::vector<double> Moments;
  Eigen::VectorXd Load;
};

} // namespace pemesh

#endif
