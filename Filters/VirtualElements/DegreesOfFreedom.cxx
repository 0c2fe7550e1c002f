// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DegreesOfFreedom.h"

#include "EllipticProblem.h"
#include "GaussRules.h"

namespace pemesh
{

namespace
{

// Calls body(element, place, edge, from, to) for each edge of each element.
template <typename Body>
void ForEachElementEdge(const VirtualElementMesh& mesh, const Body& body)
{
  for (vtkIdType element = 0; element < mesh.NumberOfElements(); ++element)
  {
    const auto ids = mesh.Element(element);
    for (std::size_t place = 0; place < ids.size(); ++place)
    {
      const vtkIdType edge = mesh.EdgeOf[mesh.Offsets[element] + static_cast<vtkIdType>(place)];
      body(element, static_cast<vtkIdType>(place), edge, ids[place],
        ids[place + 1 == ids.size() ? 0 : place + 1]);
    }
  }
}

void NumberElements(const VirtualElementMesh& mesh, DegreesOfFreedom& dofs)
{
  const int inner = dofs.Order - 1;
  dofs.Offsets.resize(mesh.Offsets.size());
  for (std::size_t i = 0; i < mesh.Offsets.size(); ++i)
  {
    dofs.Offsets[i] = mesh.Offsets[i] * dofs.Order;
  }
  dofs.Ids.resize(mesh.Corners.size() * static_cast<std::size_t>(dofs.Order));
  ForEachElementEdge(mesh,
    [&](vtkIdType element, vtkIdType place, vtkIdType edge, vtkIdType from, vtkIdType to)
    {
      const vtkIdType n = static_cast<vtkIdType>(mesh.Element(element).size());
      vtkIdType* ids = dofs.Ids.data() + dofs.Offsets[element];
      ids[place] = from;
      for (int node = 0; node < inner; ++node)
      {
        const int along = from < to ? node : inner - 1 - node;
        ids[n + place * inner + node] = mesh.NumberOfPoints() + edge * inner + along;
      }
    });
}

// The points of an edge go from its lower end to the higher: both its elements see the same bits.
void PlacePoints(const VirtualElementMesh& mesh, DegreesOfFreedom& dofs)
{
  const int inner = dofs.Order - 1;
  const GaussRule rule = GaussLobatto(dofs.Order + 1);
  dofs.Points = mesh.Points;
  dofs.Points.resize(mesh.Points.size() + mesh.EdgeOnBoundary.size() * inner);
  dofs.Used.assign(mesh.Used.begin(), mesh.Used.end());
  dofs.Used.resize(dofs.Points.size(), 1);
  ForEachElementEdge(mesh,
    [&](vtkIdType, vtkIdType, vtkIdType edge, vtkIdType from, vtkIdType to)
    {
      const Point2& a = mesh.Points[std::min(from, to)];
      const Point2& b = mesh.Points[std::max(from, to)];
      for (int node = 0; node < inner; ++node)
      {
        const double t = rule.Points[static_cast<std::size_t>(node) + 1];
        dofs.Points[mesh.NumberOfPoints() + edge * inner + node] = { a.x + t * (b.x - a.x),
          a.y + t * (b.y - a.y) };
      }
    });
}

void FindKnown(
  const VirtualElementMesh& mesh, const EllipticProblem& problem, DegreesOfFreedom& dofs)
{
  const int inner = dofs.Order - 1;
  dofs.Known.assign(dofs.Points.size(), 0);
  ForEachElementEdge(mesh,
    [&](vtkIdType, vtkIdType, vtkIdType edge, vtkIdType from, vtkIdType to)
    {
      const Point2& a = mesh.Points[from];
      const Point2& b = mesh.Points[to];
      if (!mesh.EdgeOnBoundary[edge] || problem.IsNeumann({ 0.5 * (a.x + b.x), 0.5 * (a.y + b.y) }))
      {
        return;
      }
      dofs.Known[from] = dofs.Known[to] = 1;
      for (int node = 0; node < inner; ++node)
      {
        dofs.Known[mesh.NumberOfPoints() + edge * inner + node] = 1;
      }
    });
}

} // namespace

DegreesOfFreedom NumberDegreesOfFreedom(
  const VirtualElementMesh& mesh, const EllipticProblem& problem, int order)
{
  DegreesOfFreedom dofs;
  dofs.Order = order;
  NumberElements(mesh, dofs);
  PlacePoints(mesh, dofs);
  FindKnown(mesh, problem, dofs);
  return dofs;
}

} // namespace pemesh
