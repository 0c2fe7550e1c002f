// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "VirtualElementMethodElement.h"

#include "PolygonMeasures.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

Point2 Difference(const Point2& a, const Point2& b)
{
  return { a.x - b.x, a.y - b.y };
}

} // namespace

double PolygonDiameter(PolygonView vertices)
{
  double square = 0.0;
  for (std::size_t i = 1; i < vertices.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const Point2 d = Difference(vertices[i], vertices[j]);
      square = std::max(square, d.x * d.x + d.y * d.y);
    }
  }
  return std::sqrt(square);
}

std::vector<double> BoundaryMeanWeights(PolygonView vertices)
{
  const std::size_t n = vertices.size();
  std::vector<double> weights(n, 0.0);
  double perimeter = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t next = i + 1 == n ? 0 : i + 1;
    const Point2 edge = Difference(vertices[next], vertices[i]);
    const double length = std::sqrt(edge.x * edge.x + edge.y * edge.y);
    perimeter += length;
    weights[i] += 0.5 * length;
    weights[next] += 0.5 * length;
  }
  for (double& weight : weights)
  {
    weight /= perimeter;
  }
  return weights;
}

void VirtualElement::Set(PolygonView vertices, ProjectionConstant constant)
{
  const std::size_t n = vertices.size();
  this->ElementArea = SignedArea(vertices);
  this->ElementDiameter = PolygonDiameter(vertices);
  this->ElementCentroid = pemesh::Centroid(vertices);
  this->Constants.assign(n, 1.0 / static_cast<double>(n));
  this->GradientsX.resize(n);
  this->GradientsY.resize(n);
  this->Monomials.resize(n);
  if (constant == ProjectionConstant::BoundaryMean)
  {
    this->Constants = BoundaryMeanWeights(vertices);
  }
  Point2 mean; // of the monomials, in the same weights
  const double factor = this->ElementDiameter / (2.0 * this->ElementArea);
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point2& previous = vertices[i == 0 ? n - 1 : i - 1];
    const Point2& next = vertices[i + 1 == n ? 0 : i + 1];
    this->GradientsX[i] = factor * (next.y - previous.y);
    this->GradientsY[i] = factor * (previous.x - next.x);
    this->Monomials[i] = this->Scaled(vertices[i]);
    mean.x += this->Constants[i] * this->Monomials[i].x;
    mean.y += this->Constants[i] * this->Monomials[i].y;
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    this->Constants[i] -= this->GradientsX[i] * mean.x + this->GradientsY[i] * mean.y;
  }
}

void VirtualElement::GetStiffness(std::span<double> packed)
{
  const std::size_t n = this->NumberOfVertices();
  this->Remainder.resize(n * n);
  for (std::size_t j = 0; j < n; ++j)
  {
    double* column = this->Remainder.data() + j * n;
    for (std::size_t v = 0; v < n; ++v)
    {
      column[v] = -(this->Constants[j] + this->GradientsX[j] * this->Monomials[v].x +
        this->GradientsY[j] * this->Monomials[v].y);
    }
    column[j] += 1.0;
  }
  const double scale = this->ElementArea / (this->ElementDiameter * this->ElementDiameter);
  for (std::size_t i = 0; i < n; ++i)
  {
    const double* first = this->Remainder.data() + i * n;
    for (std::size_t j = 0; j <= i; ++j)
    {
      const double* second = this->Remainder.data() + j * n;
      double stabilisation = 0.0;
      for (std::size_t v = 0; v < n; ++v)
      {
        stabilisation += first[v] * second[v];
      }
      packed[i * (i + 1) / 2 + j] = stabilisation +
        scale *
          (this->GradientsX[i] * this->GradientsX[j] + this->GradientsY[i] * this->GradientsY[j]);
    }
  }
}

} // namespace pemesh
