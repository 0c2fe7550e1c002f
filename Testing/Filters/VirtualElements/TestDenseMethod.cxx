// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The method of order 2 and 3 once more, as the literature writes it and with nothing of the
 * library: exact algebra of polynomials, dense matrices, moments inside elements kept as unknowns.
 */
#include "EllipticProblem.h"
#include "VirtualElementMethod.h"
#include "VirtualElementTestMeshes.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace
{

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using pemesh::Point2;

/** A polynomial of X and Y: coefficients by the powers. */
class Polynomial
{
public:
  static Polynomial Monomial(int a, int b, double factor = 1.0)
  {
    Polynomial result;
    result.Terms[{ a, b }] = factor;
    return result;
  }
  Polynomial operator+(const Polynomial& other) const
  {
    Polynomial result = *this;
    for (const auto& [powers, factor] : other.Terms)
    {
      result.Terms[powers] += factor;
    }
    return result;
  }
  Polynomial operator*(const Polynomial& other) const
  {
    Polynomial result;
    for (const auto& [p, x] : this->Terms)
    {
      for (const auto& [q, y] : other.Terms)
      {
        result.Terms[{ p.first + q.first, p.second + q.second }] += x * y;
      }
    }
    return result;
  }
  Polynomial operator*(double factor) const { return *this * Monomial(0, 0, factor); }
  Polynomial DX() const { return this->Derivative(1, 0); }
  Polynomial DY() const { return this->Derivative(0, 1); }
  double operator()(Point2 p) const
  {
    double sum = 0.0;
    for (const auto& [powers, factor] : this->Terms)
    {
      sum += factor * std::pow(p.x, powers.first) * std::pow(p.y, powers.second);
    }
    return sum;
  }
  /** Over a polygon, by the divergence of its primitive in X and Gauss' rule of five points. */
  double Integral(const std::vector<Point2>& polygon) const
  {
    Polynomial primitive;
    for (const auto& [powers, factor] : this->Terms)
    {
      primitive.Terms[{ powers.first + 1, powers.second }] = factor / (powers.first + 1);
    }
    constexpr std::array points{ 0.0, 0.53846931010568309, 0.90617984593866399 };
    constexpr std::array weights{ 128.0 / 225.0, 0.47862867049936647, 0.23692688505618909 };
    double sum = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Point2 a = polygon[i];
      const Point2 b = polygon[(i + 1) % polygon.size()];
      for (std::size_t q = 0; q < points.size(); ++q)
      {
        for (const double t : { 0.5 - 0.5 * points[q], 0.5 + 0.5 * points[q] })
        {
          sum += (q == 0 ? 0.25 : 0.5) * weights[q] * (b.y - a.y) *
            primitive({ a.x + t * (b.x - a.x), a.y + t * (b.y - a.y) });
        }
      }
    }
    return sum;
  }

private:
  Polynomial Derivative(int x, int y) const
  {
    Polynomial result;
    for (const auto& [powers, factor] : this->Terms)
    {
      const int power = x * powers.first + y * powers.second;
      if (power > 0)
      {
        result.Terms[{ powers.first - x, powers.second - y }] = power * factor;
      }
    }
    return result;
  }

  std::map<std::pair<int, int>, double> Terms;
};

std::vector<Polynomial> Monomials(int degree)
{
  std::vector<Polynomial> all;
  for (int total = 0; total <= degree; ++total)
  {
    for (int b = 0; b <= total; ++b)
    {
      all.push_back(Polynomial::Monomial(total - b, b));
    }
  }
  return all;
}

constexpr const char* Solution = "x^4+x^2*y^2-y^3+2*x*y";

Polynomial SolutionOf(const Polynomial& x, const Polynomial& y)
{
  return x * x * x * x + x * x * y * y + y * y * y * -1.0 + x * y * 2.0;
}

Polynomial SourceOf(const Polynomial& x, const Polynomial& y)
{
  return x * x * -14.0 + y * y * -2.0 + y * 6.0;
}

/** Of one element, in the coordinates (x - centroid) / diameter. */
struct Element
{
  MatrixXd Stiffness;
  MatrixXd Projection; ///< of the basis functions, in Monomials(k)
  VectorXd Load;
  VectorXd Truth; ///< the degrees of freedom of the solution
  double Scale = 1.0;
  Polynomial Solution;
  std::vector<Point2> Polygon;
};

MatrixXd Products(const std::vector<Polynomial>& a, const std::vector<Polynomial>& b,
  const std::vector<Point2>& polygon)
{
  MatrixXd matrix(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      matrix(static_cast<Index>(i), static_cast<Index>(j)) = (a[i] * b[j]).Integral(polygon);
    }
  }
  return matrix;
}

// Gauss-Lobatto on [0, 1].
std::vector<double> NodesOf(int k)
{
  const double root = 0.5 / std::sqrt(5.0);
  return k == 2 ? std::vector{ 0.0, 0.5, 1.0 } : std::vector{ 0.0, 0.5 - root, 0.5 + root, 1.0 };
}

std::vector<double> WeightsOf(int k)
{
  return k == 2 ? std::vector{ 1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0 }
                : std::vector{ 1.0 / 12.0, 5.0 / 12.0, 5.0 / 12.0, 1.0 / 12.0 };
}

Element MakeElement(const std::vector<Point2>& vertices, int k)
{
  Element element;
  const Polynomial one = Polynomial::Monomial(0, 0);
  const double realArea = one.Integral(vertices);
  const Point2 centre{ Polynomial::Monomial(1, 0).Integral(vertices) / realArea,
    Polynomial::Monomial(0, 1).Integral(vertices) / realArea };
  double h = 0.0;
  for (const Point2& a : vertices)
  {
    for (const Point2& b : vertices)
    {
      h = std::max(h, std::hypot(b.x - a.x, b.y - a.y));
    }
  }
  for (const Point2& a : vertices)
  {
    element.Polygon.push_back({ (a.x - centre.x) / h, (a.y - centre.y) / h });
  }
  element.Scale = h;
  const std::vector<Point2>& polygon = element.Polygon;
  const double area = one.Integral(polygon);
  const std::size_t n = polygon.size();
  const auto count = [](int degree) { return Index{ (degree + 1) * (degree + 2) / 2 }; };
  const Index moments = count(k - 2);
  const Index boundary = static_cast<Index>(n) * k;
  const Index dofs = boundary + moments;
  const std::vector<Polynomial> m = Monomials(k);
  const MatrixXd mass = Products(m, m, polygon);
  // Degree of freedom edge k + node is the node of the edge, the last one the next edge's first.
  const std::vector<double> nodes = NodesOf(k);
  const std::vector<double> weights = WeightsOf(k);
  MatrixXd d(dofs, count(k));
  MatrixXd fluxX = MatrixXd::Zero(count(k - 1), dofs);
  MatrixXd fluxY = fluxX;
  MatrixXd b = MatrixXd::Zero(count(k), dofs);
  for (std::size_t edge = 0; edge < n; ++edge)
  {
    const Point2 from = polygon[edge];
    const Point2 to = polygon[(edge + 1) % n];
    const Point2 normal{ to.y - from.y, from.x - to.x }; // times the length
    for (int node = 0; node <= k; ++node)
    {
      const double t = nodes[static_cast<std::size_t>(node)];
      const double weight = weights[static_cast<std::size_t>(node)];
      const Point2 p{ from.x + t * (to.x - from.x), from.y + t * (to.y - from.y) };
      const Index dof = (static_cast<Index>(edge) * k + node) % boundary;
      for (Index a = 0; a < count(k); ++a)
      {
        const Polynomial& monomial = m[static_cast<std::size_t>(a)];
        d(dof, a) = monomial(p);
        b(a, dof) += weight * (normal.x * monomial.DX()(p) + normal.y * monomial.DY()(p));
        if (a < count(k - 1))
        {
          fluxX(a, dof) += weight * normal.x * monomial(p);
          fluxY(a, dof) += weight * normal.y * monomial(p);
        }
      }
    }
  }
  d.bottomRows(moments) = mass.topRows(moments) / area;
  // -(integral of q phi_j) for q of degree k - 2 is -(area) times the moments that make q.
  const auto inMoments = [&](const Polynomial& q) -> VectorXd
  {
    const MatrixXd right = Products({ m.begin(), m.begin() + moments }, { q }, polygon);
    return mass.topLeftCorner(moments, moments).fullPivLu().solve(right);
  };
  std::vector<Polynomial> dx;
  std::vector<Polynomial> dy;
  for (Index a = 0; a < count(k); ++a)
  {
    const Polynomial& monomial = m[static_cast<std::size_t>(a)];
    dx.push_back(monomial.DX());
    dy.push_back(monomial.DY());
    const Polynomial laplace = monomial.DX().DX() + monomial.DY().DY();
    b.row(a).tail(moments) -= area * inMoments(laplace).transpose();
    if (a < count(k - 1))
    {
      fluxX.row(a).tail(moments) -= area * inMoments(dx.back()).transpose();
      fluxY.row(a).tail(moments) -= area * inMoments(dy.back()).transpose();
    }
  }
  MatrixXd g = Products(dx, dx, polygon) + Products(dy, dy, polygon);
  g.row(0) = mass.row(0) / area; // the mean
  b.row(0).setZero();
  b(0, boundary) = 1.0;
  element.Projection = g.fullPivLu().solve(b);
  const MatrixXd low = mass.topLeftCorner(count(k - 1), count(k - 1));
  const MatrixXd rest = MatrixXd::Identity(dofs, dofs) - d * element.Projection;
  element.Stiffness = fluxX.transpose() * low.fullPivLu().solve(fluxX) +
    fluxY.transpose() * low.fullPivLu().solve(fluxY) + rest.transpose() * rest;
  // f against the L2 projections of degree k - 1, whose moments of degree k - 1 are those of the
  // gradient projection.
  MatrixXd c = mass.topRows(count(k - 1)) * element.Projection;
  c.topRows(moments).setZero();
  c.topRightCorner(moments, moments).diagonal().setConstant(area);
  const Polynomial x = Polynomial::Monomial(1, 0, h) + Polynomial::Monomial(0, 0, centre.x);
  const Polynomial y = Polynomial::Monomial(0, 1, h) + Polynomial::Monomial(0, 0, centre.y);
  const std::vector<Polynomial> lower(m.begin(), m.begin() + count(k - 1));
  element.Load =
    h * h * (low.fullPivLu().solve(c)).transpose() * Products(lower, { SourceOf(x, y) }, polygon);
  element.Solution = SolutionOf(x, y);
  element.Truth.resize(dofs);
  for (std::size_t edge = 0; edge < n; ++edge)
  {
    for (int node = 0; node < k; ++node)
    {
      const double t = nodes[static_cast<std::size_t>(node)];
      const Point2 from = polygon[edge];
      const Point2 to = polygon[(edge + 1) % n];
      element.Truth(static_cast<Index>(edge) * k + node) =
        element.Solution({ from.x + t * (to.x - from.x), from.y + t * (to.y - from.y) });
    }
  }
  element.Truth.tail(moments) =
    Products({ m.begin(), m.begin() + moments }, { element.Solution }, polygon) / area;
  return element;
}

/** All degrees of freedom of a mesh of the unit square: vertices first. */
struct Whole
{
  std::vector<Element> Elements;
  std::vector<std::vector<Index>> Ids;
  Index Size = 0;
  Index FirstMoment = 0;
  std::vector<char> OnBoundary;
};

Whole MakeWhole(vtkPolyData* mesh, int k)
{
  Whole whole;
  std::map<std::pair<vtkIdType, vtkIdType>, Index> edges;
  Index next = mesh->GetNumberOfPoints();
  const auto side = [mesh](vtkIdType id)
  {
    const double* p = mesh->GetPoint(id);
    return (p[0] == 0.0) + 2 * (p[0] == 1.0) + 4 * (p[1] == 0.0) + 8 * (p[1] == 1.0);
  };
  for (vtkIdType id = 0; id < next; ++id)
  {
    whole.OnBoundary.push_back(side(id) != 0);
  }
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    vtkIdType n = 0;
    const vtkIdType* ids = nullptr;
    mesh->GetPolys()->GetCellAtId(cell, n, ids);
    const std::vector<vtkIdType> corners(ids, ids + n);
    std::vector<Point2> vertices;
    std::vector<Index> all;
    for (vtkIdType i = 0; i < n; ++i)
    {
      const vtkIdType from = corners[static_cast<std::size_t>(i)];
      const vtkIdType to = corners[static_cast<std::size_t>((i + 1) % n)];
      vertices.push_back({ mesh->GetPoint(from)[0], mesh->GetPoint(from)[1] });
      const auto [entry, isNew] = edges.try_emplace(std::minmax({ from, to }), next);
      if (isNew)
      {
        next += k - 1;
        whole.OnBoundary.resize(static_cast<std::size_t>(next), (side(from) & side(to)) != 0);
      }
      all.push_back(from);
      for (int node = 0; node < k - 1; ++node)
      {
        all.push_back(entry->second + (from < to ? node : k - 2 - node));
      }
    }
    whole.Elements.push_back(MakeElement(vertices, k));
    whole.Ids.push_back(all);
  }
  whole.FirstMoment = next;
  for (auto& ids : whole.Ids)
  {
    for (int moment = 0; moment < k * (k - 1) / 2; ++moment)
    {
      ids.push_back(next++);
    }
  }
  whole.OnBoundary.resize(static_cast<std::size_t>(next), 0);
  whole.Size = next;
  return whole;
}

double Norm1(const MatrixXd& matrix)
{
  return matrix.cwiseAbs().colwise().sum().maxCoeff();
}

struct DenseAnswer
{
  VectorXd Values;
  double EnergyError = 0.0;
  double ErrorL2 = 0.0;
  double Condition1 = 0.0;
  double Condition2 = 0.0;
  Index Unknowns = 0;
};

DenseAnswer SolveDense(vtkPolyData* mesh, int k)
{
  const Whole whole = MakeWhole(mesh, k);
  MatrixXd stiffness = MatrixXd::Zero(whole.Size, whole.Size);
  VectorXd load = VectorXd::Zero(whole.Size);
  VectorXd truth = VectorXd::Zero(whole.Size);
  for (std::size_t e = 0; e < whole.Elements.size(); ++e)
  {
    stiffness(whole.Ids[e], whole.Ids[e]) += whole.Elements[e].Stiffness;
    load(whole.Ids[e]) += whole.Elements[e].Load;
    truth(whole.Ids[e]) = whole.Elements[e].Truth;
  }
  std::vector<Index> outer;
  std::vector<Index> inner;
  for (Index i = 0; i < whole.Size; ++i)
  {
    if (!whole.OnBoundary[static_cast<std::size_t>(i)] && stiffness(i, i) != 0.0)
    {
      (i < whole.FirstMoment ? outer : inner).push_back(i);
    }
  }
  std::vector<Index> unknown = outer;
  unknown.insert(unknown.end(), inner.begin(), inner.end());
  DenseAnswer answer;
  answer.Values = truth;
  answer.Values(unknown).setZero();
  const VectorXd rest = load - stiffness * answer.Values;
  answer.Values(unknown) = stiffness(unknown, unknown).fullPivLu().solve(rest(unknown));
  const VectorXd error = truth - answer.Values;
  answer.EnergyError = std::sqrt(error.dot(stiffness * error) / truth.dot(stiffness * truth));
  const MatrixXd condensed = stiffness(outer, outer) -
    stiffness(outer, inner) *
      MatrixXd(stiffness(inner, inner)).fullPivLu().solve(MatrixXd(stiffness(inner, outer)));
  answer.Condition1 = Norm1(condensed) * Norm1(condensed.inverse());
  const VectorXd spectrum =
    Eigen::SelfAdjointEigenSolver<MatrixXd>(0.5 * (condensed + condensed.transpose()))
      .eigenvalues();
  answer.Condition2 = spectrum.maxCoeff() / spectrum.minCoeff();
  answer.Unknowns = static_cast<Index>(outer.size());
  double square = 0.0;
  for (std::size_t e = 0; e < whole.Elements.size(); ++e)
  {
    const Element& element = whole.Elements[e];
    const VectorXd coefficients = element.Projection * answer.Values(whole.Ids[e]);
    Polynomial difference = element.Solution;
    const std::vector<Polynomial> m = Monomials(k);
    for (std::size_t a = 0; a < m.size(); ++a)
    {
      difference = difference + m[a] * -coefficients(static_cast<Index>(a));
    }
    square += element.Scale * element.Scale * (difference * difference).Integral(element.Polygon);
  }
  answer.ErrorL2 = std::sqrt(square);
  return answer;
}

TEST(DenseMethod, TheSolverOfOrderTwoAndThreeGivesTheSame)
{
  for (const int order : { 2, 3 })
  {
    for (const auto& mesh : { pemesh::MakeLShapes(6, 0.4), pemesh::MakeTriangles(3, 0.4),
           pemesh::MakeMaze(0.5), pemesh::MakeChessboard(2) })
    {
      SCOPED_TRACE(std::to_string(order) + ", points " + std::to_string(mesh->GetNumberOfPoints()));
      pemesh::ProblemFormulas formulas;
      formulas.Solution = Solution;
      pemesh::VirtualElementOptions options;
      options.Order = order;
      options.Basis = FindByName(pemesh::BasisRules(), "monomial"); // moments depend on it
      options.Details = true;
      const pemesh::VirtualElementResult result =
        SolveElliptic(mesh, pemesh::EllipticProblem(formulas), options);
      const DenseAnswer expected = SolveDense(mesh, order);
      EXPECT_EQ(result.DegreesOfFreedom, static_cast<double>(expected.Unknowns));
      for (std::size_t i = 0; i < result.Solution.size(); ++i)
      {
        // Where no element uses a vertex there is no unknown.
        if (expected.Values(static_cast<Index>(i)) != 0.0)
        {
          EXPECT_NEAR(result.Solution[i], expected.Values(static_cast<Index>(i)), 1.0e-11) << i;
        }
      }
      EXPECT_NEAR(result.RelativeErrorEnergy / expected.EnergyError, 1.0, 1.0e-8);
      EXPECT_NEAR(result.AbsoluteErrorL2 / expected.ErrorL2, 1.0, 1.0e-8);
      EXPECT_NEAR(result.ConditionNumber / expected.Condition1, 1.0, 1.0e-8);
      EXPECT_NEAR(result.SpectralConditionNumber / expected.Condition2, 1.0, 1.0e-4);
    }
  }
}

} // namespace
