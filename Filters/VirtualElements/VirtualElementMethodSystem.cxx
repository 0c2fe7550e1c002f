// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "VirtualElementMethodSystem.h"

#include "ElementLoad.h"
#include "ElementMatrices.h"
#include "EllipticProblem.h"
#include "ParallelLoop.h"
#include "SolveReport.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace pemesh
{

namespace
{

constexpr vtkIdType ColumnParts = 32;

// Fills the slots of a range of elements.
class ElementWorker
{
public:
  ElementWorker(const VirtualElementMesh& mesh, const DegreesOfFreedom& dofs,
    const EllipticProblem& problem, const VirtualElementOptions& options,
    VirtualElementParts& parts)
    : Mesh(mesh)
    , Dofs(dofs)
    , Problem(problem)
    , Options(options)
    , Parts(parts)
  {
  }

  void operator()(vtkIdType first, vtkIdType last) const
  {
    ElementMatrices matrices(this->Problem, this->Options);
    ElementLoad load(this->Problem, this->Options);
    std::vector<Point2> vertices;
    std::vector<char> isNeumann;
    for (vtkIdType id = first; id < last; ++id)
    {
      this->Mesh.GetVertices(id, vertices);
      matrices.Set(vertices);
      load.Compute(matrices);
      if (this->Problem.HasNeumannEdges())
      {
        this->FindNeumannEdges(id, vertices, isNeumann);
        load.AddFluxes(vertices, isNeumann);
      }
      this->Parts.Diameter[id] = matrices.Diameter();
      this->Store(id, matrices, load.Values());
    }
  }

private:
  void FindNeumannEdges(
    vtkIdType id, const std::vector<Point2>& vertices, std::vector<char>& isNeumann) const
  {
    isNeumann.resize(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      const Point2& a = vertices[i];
      const Point2& b = vertices[i + 1 == vertices.size() ? 0 : i + 1];
      const vtkIdType edge = this->Mesh.EdgeOf[this->Mesh.Offsets[id] + static_cast<vtkIdType>(i)];
      isNeumann[i] = this->Mesh.EdgeOnBoundary[edge] &&
        this->Problem.IsNeumann({ 0.5 * (a.x + b.x), 0.5 * (a.y + b.y) });
    }
  }

  void Store(vtkIdType id, const ElementMatrices& matrices, const Eigen::VectorXd& load) const
  {
    const Eigen::Index moments = matrices.NumberOfMoments();
    const Eigen::Index outer = matrices.NumberOfDofs() - moments;
    Eigen::Map<Eigen::VectorXd> target(this->Parts.Load.data() + this->Dofs.Offsets[id], outer);
    if (moments == 0)
    {
      target = load;
      if (const auto packed = matrices.PackedMatrix(); !packed.empty())
      {
        std::copy(packed.begin(), packed.end(),
          this->Parts.Matrix.begin() + static_cast<std::ptrdiff_t>(this->Parts.MatrixOffset[id]));
        return;
      }
      this->StoreMatrix(id, matrices.Matrix());
      return;
    }
    const auto& matrix = matrices.Matrix();
    const Eigen::PartialPivLU<Eigen::MatrixXd> inner(matrix.bottomRightCorner(moments, moments));
    const Eigen::MatrixXd toMoments = inner.solve(matrix.bottomLeftCorner(moments, outer));
    target =
      load.head(outer) - matrix.topRightCorner(outer, moments) * inner.solve(load.tail(moments));
    Eigen::Map<Eigen::VectorXd>(this->Parts.MomentLoad.data() + id * moments, moments) =
      load.tail(moments);
    this->StoreMatrix(
      id, matrix.topLeftCorner(outer, outer) - matrix.topRightCorner(outer, moments) * toMoments);
  }

  void StoreMatrix(vtkIdType id, const Eigen::MatrixXd& matrix) const
  {
    double* slot = this->Parts.Matrix.data() + this->Parts.MatrixOffset[id];
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    {
      for (Eigen::Index j = 0; j < (this->Parts.Symmetric ? i + 1 : matrix.cols()); ++j, ++slot)
      {
        *slot = matrix(i, j);
      }
    }
  }

  const VirtualElementMesh& Mesh;
  const DegreesOfFreedom& Dofs;
  const EllipticProblem& Problem;
  const VirtualElementOptions& Options;
  VirtualElementParts& Parts;
};

// The elements of each degree of freedom, in ascending order, and its place in each.
struct DofUses
{
  struct Use
  {
    vtkIdType Element;
    int Place;
  };
  std::vector<vtkIdType> First;
  std::vector<Use> Uses;

  explicit DofUses(const DegreesOfFreedom& dofs)
    : First(dofs.Points.size() + 1, 0)
    , Uses(dofs.Ids.size())
  {
    for (const vtkIdType id : dofs.Ids)
    {
      ++this->First[id + 1];
    }
    for (std::size_t i = 1; i < this->First.size(); ++i)
    {
      this->First[i] += this->First[i - 1];
    }
    std::vector<vtkIdType> next(this->First.begin(), this->First.end() - 1);
    for (vtkIdType element = 0; element + 1 < static_cast<vtkIdType>(dofs.Offsets.size());
         ++element)
    {
      int place = 0;
      for (const vtkIdType id : dofs.OfElement(element))
      {
        this->Uses[next[id]++] = { element, place++ };
      }
    }
  }
};

// A range of columns of the matrix, one after the other, until all have their place.
struct ColumnPart
{
  std::vector<int> Row;
  std::vector<double> Value;
};

// Assembles parts of the columns, and the right-hand side.
class ColumnWorker
{
public:
  ColumnWorker(const DegreesOfFreedom& dofs, const DofUses& uses, const VirtualElementParts& parts,
    std::span<const double> known, VirtualElementSystem& system, std::vector<ColumnPart>& columns)
    : Dofs(dofs)
    , Uses(uses)
    , Parts(parts)
    , Known(known)
    , System(system)
    , Columns(columns)
  {
  }

  void operator()(vtkIdType first, vtkIdType last) const
  {
    std::vector<Term> terms;
    for (vtkIdType part = first; part < last; ++part)
    {
      const auto size = static_cast<vtkIdType>(this->System.DofOf.size());
      for (vtkIdType column = part * size / ColumnParts; column < (part + 1) * size / ColumnParts;
           ++column)
      {
        terms.clear();
        this->AddElements(column, terms);
        this->Store(column, terms, this->Columns[part]);
      }
    }
  }

private:
  struct Term
  {
    int Row;
    double Value;
  };

  void AddElements(vtkIdType column, std::vector<Term>& terms) const
  {
    const vtkIdType dof = this->System.DofOf[column];
    double load = 0.0;
    for (vtkIdType use = this->Uses.First[dof]; use < this->Uses.First[dof + 1]; ++use)
    {
      const vtkIdType element = this->Uses.Uses[use].Element;
      const std::size_t place = static_cast<std::size_t>(this->Uses.Uses[use].Place);
      const auto ids = this->Dofs.OfElement(element);
      load += this->Parts.Load[this->Dofs.Offsets[element] + static_cast<vtkIdType>(place)];
      for (std::size_t i = 0; i < ids.size(); ++i)
      {
        const int row = this->System.Unknown[ids[i]];
        if (row < 0)
        {
          load -= this->Parts.Entry(element, place, i, ids.size()) * this->Known[ids[i]];
        }
        else if (row >= column || !this->Parts.Symmetric)
        {
          terms.push_back({ row, this->Parts.Entry(element, i, place, ids.size()) });
        }
      }
    }
    this->System.RightHandSide[column] = load;
  }

  // The terms of a row are added in the order of the elements.
  void Store(vtkIdType column, std::vector<Term>& terms, ColumnPart& part) const
  {
    std::stable_sort(
      terms.begin(), terms.end(), [](const Term& a, const Term& b) { return a.Row < b.Row; });
    const std::size_t before = part.Row.size();
    for (const Term& term : terms)
    {
      if (part.Row.size() > before && part.Row.back() == term.Row)
      {
        part.Value.back() += term.Value;
      }
      else
      {
        part.Row.push_back(term.Row);
        part.Value.push_back(term.Value);
      }
    }
    this->System.Matrix.ColumnStart[column + 1] = static_cast<int>(part.Row.size() - before);
  }

  const DegreesOfFreedom& Dofs;
  const DofUses& Uses;
  const VirtualElementParts& Parts;
  std::span<const double> Known;
  VirtualElementSystem& System;
  std::vector<ColumnPart>& Columns;
};

void NumberUnknowns(const DegreesOfFreedom& dofs, VirtualElementSystem& system)
{
  system.Unknown.assign(dofs.Points.size(), -1);
  for (vtkIdType id = 0; id < dofs.Size(); ++id)
  {
    if (dofs.Used[id] && !dofs.Known[id])
    {
      system.Unknown[id] = static_cast<int>(system.DofOf.size());
      system.DofOf.push_back(id);
    }
  }
}

void CheckFinite(const VirtualElementParts& parts, const DegreesOfFreedom& dofs)
{
  const auto finite = [](const double* first, const double* last)
  { return std::all_of(first, last, [](double value) { return std::isfinite(value); }); };
  for (std::size_t id = 0; id + 1 < parts.MatrixOffset.size(); ++id)
  {
    if (!finite(parts.Matrix.data() + parts.MatrixOffset[id],
          parts.Matrix.data() + parts.MatrixOffset[id + 1]) ||
      !finite(parts.Load.data() + dofs.Offsets[id], parts.Load.data() + dofs.Offsets[id + 1]))
    {
      throw std::runtime_error("The matrix or the load of element " + std::to_string(id) +
        " is not finite: the element is too thin for this order and basis, or a formula is "
        "undefined there.");
    }
  }
}

} // namespace

double VirtualElementParts::Form(vtkIdType element, std::span<const double> v) const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < v.size(); ++i)
  {
    double row = 0.0;
    for (std::size_t j = 0; j < v.size(); ++j)
    {
      row += this->Entry(element, i, j, v.size()) * v[j];
    }
    sum += v[i] * row;
  }
  return sum;
}

void ForElements(
  vtkIdType elements, SolveReport& report, const std::function<void(vtkIdType, vtkIdType)>& body)
{
  constexpr vtkIdType parts = 64;
  const vtkIdType length = elements / parts + 1;
  for (vtkIdType first = 0; first < elements; first += length)
  {
    ParallelLoop(first, std::min(elements, first + length), 0, body);
    report.Check();
  }
}

VirtualElementParts ComputeElementParts(const VirtualElementMesh& mesh,
  const DegreesOfFreedom& dofs, const EllipticProblem& problem,
  const VirtualElementOptions& options, SolveReport& report)
{
  VirtualElementParts parts;
  parts.Symmetric = !problem.HasAdvection();
  parts.Definite = parts.Symmetric && !problem.HasReaction();
  const vtkIdType elements = mesh.NumberOfElements();
  parts.MatrixOffset.assign(elements + 1, 0);
  for (vtkIdType id = 0; id < elements; ++id)
  {
    const std::size_t n = dofs.OfElement(id).size();
    parts.MatrixOffset[id + 1] =
      parts.MatrixOffset[id] + (parts.Symmetric ? n * (n + 1) / 2 : n * n);
  }
  parts.Matrix.resize(parts.MatrixOffset.back());
  parts.Load.resize(dofs.Ids.size());
  parts.MomentLoad.resize(
    static_cast<std::size_t>(elements) * (options.Order * (options.Order - 1) / 2));
  parts.Diameter.resize(elements);
  ForElements(elements, report, ElementWorker(mesh, dofs, problem, options, parts));
  CheckFinite(parts, dofs);
  return parts;
}

VirtualElementSystem AssembleSystem(
  const DegreesOfFreedom& dofs, const VirtualElementParts& parts, std::span<const double> known)
{
  VirtualElementSystem system;
  NumberUnknowns(dofs, system);
  const DofUses uses(dofs);
  const vtkIdType unknowns = static_cast<vtkIdType>(system.DofOf.size());
  system.Matrix.Symmetric = parts.Symmetric;
  system.Matrix.Definite = parts.Definite;
  system.RightHandSide.resize(unknowns);
  std::vector<int>& start = system.Matrix.ColumnStart;
  start.assign(unknowns + 1, 0);
  std::vector<ColumnPart> columns(ColumnParts);
  ParallelLoop(0, ColumnParts, 1, ColumnWorker(dofs, uses, parts, known, system, columns));
  for (vtkIdType column = 0; column < unknowns; ++column)
  {
    if (start[column + 1] > std::numeric_limits<int>::max() - start[column])
    {
      throw std::runtime_error("The stiffness matrix has more than 2^31 entries: a mesh with fewer "
                               "vertices, or with fewer vertices an element, is needed.");
    }
    start[column + 1] += start[column];
  }
  system.Matrix.Row.reserve(start.back());
  system.Matrix.Value.reserve(start.back());
  for (ColumnPart& part : columns)
  {
    system.Matrix.Row.insert(system.Matrix.Row.end(), part.Row.begin(), part.Row.end());
    system.Matrix.Value.insert(system.Matrix.Value.end(), part.Value.begin(), part.Value.end());
    part = {};
  }
  return system;
}

} // namespace pemesh
