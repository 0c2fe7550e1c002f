// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DomainMesh.h"

#include "CountSearch.h"
#include "NumberText.h"
#include "PolygonMeasures.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pemesh
{

namespace
{

/** Triangles of the lattice have 90 % of the area allowed, those near the boundary less. */
constexpr double LikelyShare = 0.85;

/** A trial that makes so many times the elements wanted need not be completed. */
constexpr int EnoughTooMany = 4;

std::string WhyNotReached(const CountSearch& search, double target, const DomainMesh& last)
{
  const std::string wanted = "A mesh of " + FormatNumber(target) + " elements ";
  const std::string nearest = FormatNumber(search.GetNearestCount());
  if (!search.IsTargetTooSmall())
  {
    return wanted + "was not found: the nearest has " + nearest + "; set the target to that.";
  }
  const std::string least = last.Status == DomainMeshStatus::Done
    ? FormatNumber(last.Elements.NumberOfElements())
    : "more than " + nearest;
  return wanted + "is not possible: the polygons, the domain and the minimum angle force " + least +
    "; set at least that, or a smaller minimum angle.";
}

double AreaToFill(const Domain& domain, const std::vector<std::vector<Point2>>& polygons)
{
  double area = DomainArea(domain);
  for (const std::vector<Point2>& polygon : polygons)
  {
    area -= SignedArea(polygon);
  }
  return area;
}

} // namespace

DomainMesh MeshDomainToCount(const Domain& domain, const std::vector<std::vector<Point2>>& polygons,
  const DomainMeshOptions& options, int target)
{
  DomainMesh mesh;
  if (target > options.MaximumElements)
  {
    mesh.Message = "The target of " + FormatNumber(target) + " elements is beyond the limit of " +
      FormatNumber(options.MaximumElements) + "; raise the limit.";
    return mesh;
  }
  const double area = AreaToFill(domain, polygons);
  CountSearch search(target, CountTolerance, area / (LikelyShare * target), area);
  double done = 0.0; // each trial takes half of what is left of the progress
  while (search.IsSearching())
  {
    DomainMeshOptions trial = options;
    trial.MaximumArea = search.GetBound();
    if (search.GetBound() < area && target < options.MaximumElements / EnoughTooMany)
    {
      trial.MaximumElements = EnoughTooMany * std::max(target, 1000);
      trial.MaximumElements = std::min(trial.MaximumElements, options.MaximumElements);
    }
    if (options.Progress)
    {
      trial.Progress = [&options, done](double fraction)
      { return options.Progress(done + 0.5 * (1.0 - done) * fraction); };
    }
    mesh = MeshDomain(domain, polygons, trial);
    if (mesh.Status == DomainMeshStatus::Stopped)
    {
      return mesh;
    }
    const bool isTooLarge = mesh.Status == DomainMeshStatus::TooManyElements;
    if (mesh.Status != DomainMeshStatus::Done && !isTooLarge)
    {
      return mesh;
    }
    search.Report(isTooLarge ? trial.MaximumElements + 1.0 : mesh.Elements.NumberOfElements());
    done += 0.5 * (1.0 - done);
  }
  if (!search.IsReached())
  {
    mesh.Message = WhyNotReached(search, target, mesh);
    mesh.Status = DomainMeshStatus::TargetNotReached;
    mesh.Elements = {};
  }
  return mesh;
}

} // namespace pemesh
