// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "VirtualElementMethodElement.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>
#include <vector>

namespace
{

using pemesh::Point2;
using pemesh::ProjectionConstant;
using pemesh::VirtualElement;

const std::vector<Point2> Pentagon = { { 0, 0 }, { 3, 0 }, { 3, 2 }, { 1.5, 4 }, { 0, 4 } };
const std::vector<Point2> Concave = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 3 },
  { 0.5, 1.5 }, { 0, 3 } };

Eigen::MatrixXd Stiffness(VirtualElement& element)
{
  const std::size_t n = element.NumberOfVertices();
  std::vector<double> packed(n * (n + 1) / 2);
  element.GetStiffness(packed);
  const auto size = static_cast<Eigen::Index>(n);
  Eigen::MatrixXd matrix(size, size);
  std::size_t slot = 0;
  for (Eigen::Index i = 0; i < size; ++i)
  {
    for (Eigen::Index j = 0; j <= i; ++j)
    {
      matrix(i, j) = matrix(j, i) = packed[slot++];
    }
  }
  return matrix;
}

Eigen::VectorXd ValuesOf(const std::vector<Point2>& points, double a, double b, double c)
{
  Eigen::VectorXd values(static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    values[static_cast<Eigen::Index>(i)] = a + b * points[i].x + c * points[i].y;
  }
  return values;
}

// The worked example of Beirao da Veiga et al., The hitchhiker's guide, and Sutton's MATLAB code.
TEST(VirtualElement, ThePentagonOfTheLiterature)
{
  VirtualElement element;
  element.Set(Pentagon, ProjectionConstant::VertexMean);
  EXPECT_DOUBLE_EQ(element.Area(), 21.0 / 2.0);
  EXPECT_DOUBLE_EQ(element.Diameter(), 5.0);
  EXPECT_DOUBLE_EQ(element.Centroid().x, 19.0 / 14.0);
  EXPECT_DOUBLE_EQ(element.Centroid().y, 38.0 / 21.0);
  const double constant[] = { 187.0 / 735, 157.0 / 735, 39.0 / 245, 39.0 / 245, 157.0 / 735 };
  const double x[] = { -20.0 / 21, 10.0 / 21, 20.0 / 21, 10.0 / 21, -20.0 / 21 };
  const double y[] = { -5.0 / 7, -5.0 / 7, 5.0 / 14, 5.0 / 7, 5.0 / 14 };
  for (std::size_t i = 0; i < 5; ++i)
  {
    EXPECT_NEAR(element.Constant()[i], constant[i], 1.0e-15);
    EXPECT_NEAR(element.GradientX()[i], x[i], 1.0e-15);
    EXPECT_NEAR(element.GradientY()[i], y[i], 1.0e-15);
  }
  const Eigen::MatrixXd matrix = Stiffness(element);
  const double diagonal[] = { .742177, .742177, .989626, .864626, .867177 };
  for (Eigen::Index i = 0; i < 5; ++i)
  {
    EXPECT_NEAR(matrix(i, i), diagonal[i], 5.0e-7);
  }
  const Eigen::VectorXd eigenvalues =
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
  const double expected[] = { 0, .5866, .8785, 1.0610, 1.6797 };
  for (Eigen::Index i = 0; i < 5; ++i)
  {
    EXPECT_NEAR(eigenvalues[i], expected[i], 5.0e-5);
  }
}

TEST(VirtualElement, LinearFunctionsAreTheirOwnProjection)
{
  for (const auto& polygon : { Pentagon, Concave })
  {
    for (const auto constant : { ProjectionConstant::BoundaryMean, ProjectionConstant::VertexMean })
    {
      VirtualElement element;
      element.Set(polygon, constant);
      const Eigen::VectorXd values = ValuesOf(polygon, 0.7, -2.0, 3.0);
      double projected[3] = {};
      for (std::size_t i = 0; i < polygon.size(); ++i)
      {
        const double value = values[static_cast<Eigen::Index>(i)];
        projected[0] += value * element.Constant()[i];
        projected[1] += value * element.GradientX()[i];
        projected[2] += value * element.GradientY()[i];
      }
      const Point2 c = element.Centroid();
      EXPECT_NEAR(projected[0], 0.7 - 2.0 * c.x + 3.0 * c.y, 1.0e-13);
      EXPECT_NEAR(projected[1], -2.0 * element.Diameter(), 1.0e-13);
      EXPECT_NEAR(projected[2], 3.0 * element.Diameter(), 1.0e-13);
    }
  }
}

TEST(VirtualElement, TheEnergyOfLinearFunctionsIsExact)
{
  for (const auto& polygon : { Pentagon, Concave })
  {
    VirtualElement element;
    element.Set(polygon, ProjectionConstant::BoundaryMean);
    const Eigen::MatrixXd matrix = Stiffness(element);
    const Eigen::VectorXd linear = ValuesOf(polygon, 5.0, -2.0, 3.0);
    EXPECT_NEAR(linear.dot(matrix * linear), 13.0 * element.Area(), 1.0e-11);
    EXPECT_LT((matrix * ValuesOf(polygon, 1.0, 0.0, 0.0)).norm(), 1.0e-13);
    const Eigen::VectorXd eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
    EXPECT_NEAR(eigenvalues[0], 0.0, 1.0e-13);
    EXPECT_GT(eigenvalues[1], 0.1); // only constants have no energy
  }
}

// The mean over the boundary of phi_i - Pi phi_i vanishes; integrated edge by edge, midpoints.
TEST(VirtualElement, TheBoundaryMeanIsKept)
{
  VirtualElement element;
  element.Set(Concave, ProjectionConstant::BoundaryMean);
  for (std::size_t i = 0; i < Concave.size(); ++i)
  {
    double sum = 0.0;
    for (std::size_t v = 0; v < Concave.size(); ++v)
    {
      const std::size_t w = (v + 1) % Concave.size();
      const Point2 middle = { (Concave[v].x + Concave[w].x) / 2,
        (Concave[v].y + Concave[w].y) / 2 };
      const double length = std::hypot(Concave[v].x - Concave[w].x, Concave[v].y - Concave[w].y);
      const double phi = (v == i || w == i) ? 0.5 : 0.0;
      const Point2 m = element.Scaled(middle);
      sum += length *
        (phi - element.Constant()[i] - element.GradientX()[i] * m.x - element.GradientY()[i] * m.y);
    }
    EXPECT_NEAR(sum, 0.0, 1.0e-14);
  }
}

TEST(VirtualElement, ATriangleIsTheFiniteElement)
{
  const std::vector<Point2> triangle = { { 0.2, 0.1 }, { 1.3, 0.4 }, { 0.5, 0.9 } };
  VirtualElement element;
  element.Set(triangle, ProjectionConstant::BoundaryMean);
  const Eigen::MatrixXd matrix = Stiffness(element);
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      // |T| grad_i . grad_j = e_i . e_j / (4 |T|) with e_i the edge opposite to vertex i.
      const auto edge = [&triangle](std::size_t k)
      {
        const Point2& a = triangle[(k + 1) % 3];
        const Point2& b = triangle[(k + 2) % 3];
        return Point2{ b.x - a.x, b.y - a.y };
      };
      const double exact = (edge(i).x * edge(j).x + edge(i).y * edge(j).y) / (4.0 * element.Area());
      EXPECT_NEAR(
        matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)), exact, 1.0e-14);
    }
    EXPECT_NEAR(element.Constant()[i], 1.0 / 3.0, 1.0e-15); // the mean of a hat function
  }
}

TEST(VirtualElement, TheMatrixDoesNotDependOnSizeOrPlace)
{
  VirtualElement element;
  element.Set(Concave, ProjectionConstant::BoundaryMean);
  const Eigen::MatrixXd matrix = Stiffness(element);
  for (const double size : { 1.0e-9, 1.0, 1.0e9 })
  {
    std::vector<Point2> moved = Concave;
    for (Point2& point : moved) // turned by the angle of the triangle 3, 4, 5
    {
      point = { size * (0.6 * point.x - 0.8 * point.y + 2.0),
        size * (0.8 * point.x + 0.6 * point.y - 1.0) };
    }
    element.Set(moved, ProjectionConstant::BoundaryMean);
    EXPECT_LT((Stiffness(element) - matrix).cwiseAbs().maxCoeff(), 1.0e-13) << size;
  }
}

} // namespace
