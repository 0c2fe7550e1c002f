// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StiffnessMeasures.h"

#include "VirtualElementMethodElement.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pemesh
{

namespace
{

constexpr std::size_t Most = 6; // columns: three of C, three of m
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Most, Most>;

double Dot(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += a[i] * b[i];
  }
  return sum;
}

void Subtract(std::vector<double>& a, double factor, const std::vector<double>& b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    a[i] -= factor * b[i];
  }
}

/** Buffers that a thread keeps from element to element. */
class Calculator
{
public:
  StiffnessMeasures Measure(PolygonView polygon)
  {
    this->Element.Set(polygon, ProjectionConstant::VertexMean);
    this->SetColumns(polygon);
    this->Orthogonalize();
    StiffnessMeasures measures;
    measures.ProjectionCondition = this->ComputeCondition();
    measures.StabilityRatio = this->ComputeStabilityRatio();
    return measures;
  }

private:
  void SetColumns(PolygonView polygon)
  {
    const auto Assign = [](std::vector<double>& column, std::span<const double> values)
    { column.assign(values.begin(), values.end()); };
    Assign(this->Columns[0], this->Element.Constant());
    Assign(this->Columns[1], this->Element.GradientX());
    Assign(this->Columns[2], this->Element.GradientY());
    this->Columns[3].assign(polygon.size(), 1.0);
    this->Columns[4].resize(polygon.size());
    this->Columns[5].resize(polygon.size());
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Point2 scaled = this->Element.Scaled(polygon[i]);
      this->Columns[4][i] = scaled.x;
      this->Columns[5][i] = scaled.y;
    }
    this->Basis = this->Columns;
  }

  /**
   * Gram-Schmidt, repeated until nothing is lost to rounding. A column that depends on the ones
   * before leaves a direction of rounding errors, which does no harm: K is known there as well.
   */
  void Orthogonalize()
  {
    const std::size_t size = this->Columns[0].size();
    this->Rank = 0;
    this->Triangle.setZero();
    for (std::size_t k = 0; k < Most && this->Rank < size; ++k)
    {
      std::vector<double>& column = this->Basis[k];
      double before = 0.0;
      double norm = std::sqrt(Dot(column, column));
      for (int pass = 0; pass < 5 && (pass == 0 || norm < 0.5 * before); ++pass)
      {
        before = norm;
        for (std::size_t j = 0; j < this->Rank; ++j)
        {
          const double factor = Dot(column, this->Basis[j]);
          Subtract(column, factor, this->Basis[j]);
          if (k < 3)
          {
            this->Triangle(j, k) += factor;
          }
        }
        norm = std::sqrt(Dot(column, column));
      }
      if (k < 3)
      {
        this->Triangle(k, k) = norm;
      }
      if (norm > 0.0)
      {
        for (double& value : column)
        {
          value /= norm;
        }
        std::swap(this->Basis[this->Rank], column);
        ++this->Rank;
      }
    }
  }

  double ComputeCondition() const
  {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(this->Triangle);
    const Eigen::Vector3d values = svd.info() == Eigen::Success
      ? Eigen::Vector3d(svd.singularValues())
      : Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()); // not finite
    return values(0) / values(2);
  }

  double ComputeStabilityRatio()
  {
    const auto rank = static_cast<Eigen::Index>(this->Rank);
    std::array<std::array<double, 3>, Most> projections; // C' q of a vector q of the basis
    for (std::size_t k = 0; k < this->Rank; ++k)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        projections[k][j] = Dot(this->Columns[j], this->Basis[k]);
      }
    }
    for (std::size_t k = 0; k < this->Rank; ++k) // q - m C' q
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        Subtract(this->Basis[k], projections[k][j], this->Columns[3 + j]);
      }
    }
    const double diameter = this->Element.Diameter();
    const double scale = this->Element.Area() / (diameter * diameter);
    SmallMatrix restricted(rank, rank);
    for (Eigen::Index i = 0; i < rank; ++i)
    {
      for (Eigen::Index j = 0; j <= i; ++j)
      {
        restricted(i, j) = Dot(this->Basis[i], this->Basis[j]) +
          scale * (projections[i][1] * projections[j][1] + projections[i][2] * projections[j][2]);
      }
    }
    const Eigen::SelfAdjointEigenSolver<SmallMatrix> solver(restricted, Eigen::EigenvaluesOnly);
    const bool hasOnes = this->Columns[0].size() > this->Rank;
    const double second = solver.eigenvalues()(1);
    const double largest = solver.eigenvalues()(rank - 1);
    return std::max(
      0.0, hasOnes ? std::min(second, 1.0) / std::max(largest, 1.0) : second / largest);
  }

  VirtualElement Element;
  std::array<std::vector<double>, Most> Columns;
  std::array<std::vector<double>, Most> Basis;
  std::size_t Rank = 0;
  Eigen::Matrix3d Triangle;
};

} // namespace

StiffnessMeasures MeasureStiffness(PolygonView polygon)
{
  thread_local Calculator calculator;
  return calculator.Measure(polygon);
}

} // namespace pemesh
