// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "VirtualElementMethodSystem.h"

#include "ElementTriangles.h"
#include "ParallelLoop.h"
#include "Quadrature.h"
#include "TestProblems.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace pemesh
{

namespace
{

constexpr double LoadTolerance = 1.0e-10;
constexpr vtkIdType ColumnParts = 32;

// The integral of f, and of f times the two scaled monomials, over an element.
std::array<double, 3> IntegrateSource(const TestProblem& problem, const VirtualElement& element,
  std::span<const Triangle2> triangles, bool moments)
{
  // Relative to the integral of |f|, which also bounds the moments (the monomials are at most one).
  const auto agree = [](const auto& coarse, const auto& fine, double)
  {
    const double allowed = LoadTolerance * fine.Absolute[0];
    for (std::size_t k = 0; k < fine.Value.size(); ++k)
    {
      if (!(std::abs(coarse.Value[k] - fine.Value[k]) <= allowed))
      {
        return false;
      }
    }
    return true;
  };
  TestProblemBlock source;
  const auto justSource = [&](const PointBlock& points, IntegrandValues<1>& values)
  {
    problem.Evaluate(points, source);
    values[0] = source.Source;
  };
  const auto withMoments = [&](const PointBlock& points, IntegrandValues<3>& values)
  {
    problem.Evaluate(points, source);
    values[0] = source.Source;
    for (std::size_t i = 0; i < PointBlockSize; ++i)
    {
      const Point2 m = element.Scaled({ points.X[i], points.Y[i] });
      values[1][i] = source.Source[i] * m.x;
      values[2][i] = source.Source[i] * m.y;
    }
  };
  std::array<double, 3> sum{};
  for (const Triangle2& triangle : triangles)
  {
    if (moments)
    {
      const auto part = IntegrateOverTriangle<3>(triangle, withMoments, agree);
      std::transform(sum.begin(), sum.end(), part.begin(), sum.begin(), std::plus<>());
    }
    else
    {
      sum[0] += IntegrateOverTriangle<1>(triangle, justSource, agree)[0];
    }
  }
  return sum;
}

// Fills the slots of a range of elements.
class ElementWorker
{
public:
  ElementWorker(const VirtualElementMesh& mesh, const TestProblem& problem,
    const VirtualElementOptions& options, VirtualElementParts& parts)
    : Mesh(mesh)
    , Problem(problem)
    , Options(options)
    , Parts(parts)
  {
  }

  void operator()(vtkIdType first, vtkIdType last) const
  {
    VirtualElement element;
    std::vector<Point2> vertices;
    ElementTriangles triangles;
    for (vtkIdType id = first; id < last; ++id)
    {
      this->Mesh.GetVertices(id, vertices);
      element.Set(vertices, this->Options.Constant);
      this->Parts.Diameter[id] = element.Diameter();
      const std::size_t offset = this->Parts.StiffnessOffset[id];
      element.GetStiffness(
        { this->Parts.Stiffness.data() + offset, this->Parts.StiffnessOffset[id + 1] - offset });

      const bool moments = this->Options.Load == LoadProjection::Gradient;
      const auto integral =
        IntegrateSource(this->Problem, element, triangles.Cut(vertices), moments);
      double* load = this->Parts.Load.data() + this->Mesh.Offsets[id];
      for (std::size_t i = 0; i < vertices.size(); ++i)
      {
        load[i] = element.Constant()[i] * integral[0] + element.GradientX()[i] * integral[1] +
          element.GradientY()[i] * integral[2];
      }
    }
  }

private:
  const VirtualElementMesh& Mesh;
  const TestProblem& Problem;
  const VirtualElementOptions& Options;
  VirtualElementParts& Parts;
};

// Builds columns of the lower triangle. A column adds up its entries in the order of the elements
// around its point, whoever builds it. Run twice: to count, then to fill.
class ColumnWorker
{
public:
  ColumnWorker(const VirtualElementMesh& mesh, const VirtualElementParts& parts,
    std::span<const double> known, VirtualElementSystem& system, bool fill)
    : Mesh(mesh)
    , Parts(parts)
    , Known(known)
    , System(system)
    , Fill(fill)
  {
  }

  void operator()(vtkIdType first, vtkIdType last) const
  {
    // As long as there are unknowns: the loop must not have many parts.
    std::vector<double> sums(this->System.PointOf.size(), 0.0);
    std::vector<char> met(this->System.PointOf.size(), 0);
    std::vector<int> rows;
    for (vtkIdType column = first; column < last; ++column)
    {
      rows.clear();
      this->AddElements(column, sums, met, rows);
      this->Store(column, sums, met, rows);
    }
  }

private:
  void AddElements(vtkIdType column, std::vector<double>& sums, std::vector<char>& met,
    std::vector<int>& rows) const
  {
    const vtkIdType point = this->System.PointOf[column];
    double load = 0.0;
    for (vtkIdType use = this->Mesh.FirstUse[point]; use < this->Mesh.FirstUse[point + 1]; ++use)
    {
      const vtkIdType element = this->Mesh.UseElement[use];
      const std::size_t place = static_cast<std::size_t>(this->Mesh.UsePlace[use]);
      const auto ids = this->Mesh.Element(element);
      const auto stiffness = this->Parts.StiffnessOf(element);
      load += this->Parts.Load[this->Mesh.Offsets[element] + static_cast<vtkIdType>(place)];
      for (std::size_t i = 0; i < ids.size(); ++i)
      {
        const int row = this->System.Unknown[ids[i]];
        if (row < 0)
        {
          load -= PackedEntry(stiffness, place, i) * this->Known[ids[i]];
        }
        else if (row >= column)
        {
          if (!met[row])
          {
            met[row] = 1;
            rows.push_back(row);
          }
          sums[row] += PackedEntry(stiffness, place, i);
        }
      }
    }
    this->System.RightHandSide[column] = load;
  }

  // Leaves the work space clean for the next column.
  void Store(vtkIdType column, std::vector<double>& sums, std::vector<char>& met,
    std::vector<int>& rows) const
  {
    SymmetricMatrix& matrix = this->System.Matrix;
    if (this->Fill)
    {
      std::sort(rows.begin(), rows.end());
      int slot = matrix.ColumnStart[column];
      for (const int row : rows)
      {
        matrix.Row[slot] = row;
        matrix.Value[slot] = sums[row];
        ++slot;
      }
    }
    else
    {
      matrix.ColumnStart[column + 1] = static_cast<int>(rows.size());
    }
    for (const int row : rows)
    {
      sums[row] = 0.0;
      met[row] = 0;
    }
  }

  const VirtualElementMesh& Mesh;
  const VirtualElementParts& Parts;
  std::span<const double> Known;
  VirtualElementSystem& System;
  bool Fill;
};

void NumberUnknowns(const VirtualElementMesh& mesh, VirtualElementSystem& system)
{
  system.Unknown.assign(mesh.Points.size(), -1);
  for (vtkIdType id = 0; id < mesh.NumberOfPoints(); ++id)
  {
    if (mesh.Used[id] && !mesh.OnBoundary[id])
    {
      system.Unknown[id] = static_cast<int>(system.PointOf.size());
      system.PointOf.push_back(id);
    }
  }
}

} // namespace

VirtualElementParts ComputeElementParts(
  const VirtualElementMesh& mesh, const TestProblem& problem, const VirtualElementOptions& options)
{
  VirtualElementParts parts;
  const vtkIdType elements = mesh.NumberOfElements();
  parts.StiffnessOffset.assign(elements + 1, 0);
  for (vtkIdType id = 0; id < elements; ++id)
  {
    const std::size_t n = mesh.Element(id).size();
    parts.StiffnessOffset[id + 1] = parts.StiffnessOffset[id] + n * (n + 1) / 2;
  }
  parts.Stiffness.resize(parts.StiffnessOffset.back());
  parts.Load.resize(mesh.Corners.size());
  parts.Diameter.resize(elements);
  ElementWorker worker(mesh, problem, options, parts);
  ParallelLoop(0, elements, 0, worker);
  return parts;
}

VirtualElementSystem AssembleSystem(
  const VirtualElementMesh& mesh, const VirtualElementParts& parts, std::span<const double> known)
{
  VirtualElementSystem system;
  NumberUnknowns(mesh, system);
  const vtkIdType unknowns = static_cast<vtkIdType>(system.PointOf.size());
  system.RightHandSide.resize(unknowns);
  std::vector<int>& start = system.Matrix.ColumnStart;
  start.assign(unknowns + 1, 0);
  const vtkIdType grain = unknowns / ColumnParts + 1;
  ColumnWorker counter(mesh, parts, known, system, false);
  ParallelLoop(0, unknowns, grain, counter);
  for (vtkIdType column = 0; column < unknowns; ++column)
  {
    if (start[column + 1] > std::numeric_limits<int>::max() - start[column])
    {
      throw std::runtime_error("The stiffness matrix has more than 2^31 entries: a mesh with fewer "
                               "vertices, or with fewer vertices an element, is needed.");
    }
    start[column + 1] += start[column];
  }
  system.Matrix.Row.resize(start.back());
  system.Matrix.Value.resize(start.back());
  ColumnWorker filler(mesh, parts, known, system, true);
  ParallelLoop(0, unknowns, grain, filler);
  return system;
}

} // namespace pemesh
