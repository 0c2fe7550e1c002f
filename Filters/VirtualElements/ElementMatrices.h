// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The matrices of one element, any order. Private to the module (needs Eigen).
 *
 * The degrees of freedom of the local space of order k: the values at the n vertices, at the k - 1
 * inner Gauss-Lobatto points of each edge, edge after edge, and the k (k - 1) / 2 moments (1/|E|)
 * integral of v p_i with the polynomials of degree k - 2 or less. The space is the enhanced one (B.
 * Ahmad, A. Alsaedi, F. Brezzi, L. D. Marini, A. Russo, Equivalent projectors for virtual element
 * methods, Comput. Math. Appl. 66 (2013) 376-391): higher moments are those of the gradient
 * projection Pi. With it the L2 projections P_k of values and G_l of gradients are known, and
 *   a(u, v) = (kappa G_l u, G_l v) + (beta . G_l u, P_k v) + (c P_k u, P_k v) + S(u - Pi u, v - Pi
 * v) (L. Beirao da Veiga, F. Brezzi, L. D. Marini, A. Russo, Virtual element method for general
 * second-order elliptic problems on polygonal meshes, Math. Models Methods Appl. Sci. 26 (2016)
 * 729-750), with l = k - 1, or as high as makes S unnecessary. P_k in place of their P_(k-1) keeps
 * the patch test where there is a reaction.
 */
#ifndef pemesh_ElementMatrices_h
#define pemesh_ElementMatrices_h

#include "ElementTriangles.h"
#include "GaussRules.h"
#include "PolynomialBasis.h"
#include "VirtualElementMethodElement.h"

#include <Eigen/Dense>

#include <vector>

namespace pemesh
{

class EllipticProblem;

/** What should vanish, relative to the largest entry compared, and a condition number. */
struct ElementChecks
{
  double GradientResidual = 0.0;      ///< G - B D: the gradient projection's matrix, two ways
  double ValueResidual = 0.0;         ///< H - C D: the L2 projection's matrix, two ways
  double StabilisationResidual = 0.0; ///< (I - Pi) of the polynomials of degree k
  double Condition = 0.0;             ///< of the gradient projection's matrix G, 2-norm
};

/** The degree of freedom at a node of an edge of n, counted from its start, 0 … order. */
inline Eigen::Index ElementEdgeDof(std::size_t n, int order, Eigen::Index edge, Eigen::Index node)
{
  const Eigen::Index edges = static_cast<Eigen::Index>(n);
  if (node == 0)
  {
    return edge;
  }
  return node == order ? (edge + 1) % edges : edges + edge * (order - 1) + node - 1;
}

class ElementMatrices
{
public:
  ElementMatrices(const EllipticProblem& problem, const VirtualElementOptions& options);

  /** Takes a counter-clockwise simple polygon. Keeps its memory from element to element. */
  void Set(PolygonView vertices) { this->Set(vertices, true); }

  /** The same without the matrix where that is known in closed form, which is kept elsewhere. */
  void SetForErrors(PolygonView vertices) { this->Set(vertices, false); }

  Eigen::Index NumberOfDofs() const { return this->Dofs; }
  Eigen::Index NumberOfMoments() const { return PolynomialCount(this->Order - 2); }

  /** Its lower triangle, row by row, where it is known in closed form; Matrix() is not set then. */
  std::span<const double> PackedMatrix() const { return this->Packed; }
  /** a(phi_j, phi_i) in row i, column j. */
  const Eigen::MatrixXd& Matrix() const { return this->Stiffness; }
  /** Column j: the coefficients of the gradient projection of phi_j in the basis. */
  const Eigen::MatrixXd& Projection() const { return this->Gradient; }
  /** The same of the projection that f is integrated against. */
  const Eigen::MatrixXd& Load() const { return this->LoadMatrix; }
  /** Integrals of the products of the polynomials of degree k, and of their gradients. */
  const Eigen::MatrixXd& GetMass();
  const Eigen::MatrixXd& GetGradientProducts();

  const PolynomialBasis& Basis() const { return this->Polynomials; }
  std::span<const Triangle2> Triangles() const { return this->Parts; }
  double Area() const { return this->ElementArea; }
  double Diameter() const { return this->ElementDiameter; }

  ElementChecks GetChecks();

private:
  void Set(PolygonView vertices, bool withMatrix);
  void SetLowestOrder(bool withMatrix);
  void SetMatricesOfClosedForm();
  void SetGeneral();
  void Integrate();
  void IntegrateLinear();
  void IntegrateCoefficients();
  void FindNodes();
  void AddEdgeFluxes();
  void AddHighEdgeFluxes();
  void ProjectGradients();
  void FindMoments();
  void ProjectFluxes();
  void AddDiffusion();
  void AddStabilisation();
  void AddLowerTerms();
  void SetLoad();

  Eigen::Index EdgeDof(Eigen::Index edge, Eigen::Index node) const
  {
    return ElementEdgeDof(this->Vertices.size(), this->Order, edge, node);
  }
  int EnlargedDegree() const;

  const EllipticProblem& Problem;
  VirtualElementOptions Options;
  int Order;
  bool ClosedForm;
  GaussRule EdgeRule; // Gauss-Lobatto

  // The element.
  std::vector<Point2> Vertices;
  ElementTriangles Cutter;
  std::span<const Triangle2> Parts;
  VirtualElement Lowest;
  double ElementArea = 0.0;
  double ElementDiameter = 0.0;
  Point2 ElementCentroid;
  Eigen::Index Dofs = 0;
  Eigen::Index BoundaryDofs = 0;
  int GradientDegree = 0; // l

  // The names of the literature: D the degrees of freedom of the polynomials, H the mass matrix, C
  // the moments of the basis functions, G and B of the gradient projection.
  PolynomialBasis Polynomials;
  Eigen::MatrixXd H;
  Eigen::MatrixXd DiffusionMass; // kappa, or the entry xx of a tensor
  Eigen::MatrixXd DiffusionMassXY;
  Eigen::MatrixXd DiffusionMassYY;
  Eigen::MatrixXd ReactionMass;
  Eigen::MatrixXd AdvectionMassX;
  Eigen::MatrixXd AdvectionMassY;
  double MeanDiffusion = 1.0;
  Eigen::MatrixXd D;
  Eigen::MatrixXd NodeValues; // all polynomials at the nodes
  Eigen::MatrixXd FluxX;      // integrals of p_i dphi_j/dx
  Eigen::MatrixXd FluxY;
  Eigen::MatrixXd C;
  Eigen::MatrixXd G;
  Eigen::MatrixXd B;
  Eigen::MatrixXd GradientProducts;
  Eigen::MatrixXd ProjectedX; // coefficients of the projections of dphi_j/dx
  Eigen::MatrixXd ProjectedY;
  Eigen::MatrixXd Values; // coefficients of the L2 projections of phi_j
  Eigen::MatrixXd Remainder;
  Eigen::MatrixXd Gradient;
  Eigen::MatrixXd LoadMatrix;
  Eigen::MatrixXd Stiffness;
  std::vector<double> Packed;
  BlockValues Work;
};

} // namespace pemesh

#endif
