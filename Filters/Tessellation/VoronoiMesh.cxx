// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "VoronoiMesh.h"

#include "DomainLocator.h"
#include "PolygonMeasures.h"
#include "RandomSites.h"
#include "TilingLattice.h"
#include "VoronoiCells.h"

#include <cmath>
#include <limits>

namespace pemesh
{

namespace
{

int FindNearestSite(const std::vector<Point2>& sites, const Point2& point)
{
  int nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    const double dx = sites[i].x - point.x;
    const double dy = sites[i].y - point.y;
    if (dx * dx + dy * dy < least)
    {
      least = dx * dx + dy * dy;
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

/** Of the parts of each cell together; the site itself where there is no part. */
std::vector<Point2> FindCentroids(const ClippedMesh& mesh, const std::vector<Point2>& sites)
{
  std::vector<Point2> moments(sites.size()); // about the site
  std::vector<double> areas(sites.size(), 0.0);
  std::vector<Point2> vertices;
  for (int element = 0; element < mesh.Mesh.NumberOfElements(); ++element)
  {
    mesh.Mesh.GetVertices(element, vertices);
    const int cell =
      mesh.Cells[element] >= 0 ? mesh.Cells[element] : FindNearestSite(sites, vertices[0]);
    const double area = SignedArea(vertices);
    const Point2 centroid = Centroid(vertices);
    areas[cell] += area;
    moments[cell].x += area * (centroid.x - sites[cell].x);
    moments[cell].y += area * (centroid.y - sites[cell].y);
  }
  std::vector<Point2> centroids = sites;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    if (areas[i] > 0.0)
    {
      centroids[i].x += moments[i].x / areas[i];
      centroids[i].y += moments[i].y / areas[i];
    }
  }
  return centroids;
}

TessellationResult Fail(std::string message)
{
  return { TessellationStatus::Failed, std::move(message), {} };
}

TessellationResult MakeRelaxedVoronoi(
  const TessellationInput& input, double spacing, int iterations)
{
  const double count = input.Values.Get("cells");
  if (count > input.MaximumElements)
  {
    return TooManyElements(count, input.MaximumElements);
  }
  std::vector<Point2> sites;
  std::string why = RandomSites(
    input.Region, input.Values.GetInteger("cells"), spacing, input.Values.Get("seed"), sites);
  // An iteration costs as much as the mesh itself.
  const double share = iterations / (iterations + 1.0);
  why = !why.empty()
    ? why
    : RelaxSites(
        input.Region, iterations, [&](double done) { return input.Progress(share * done); }, sites);
  ClippedMesh mesh;
  why = !why.empty()
    ? why
    : VoronoiMesh(
        sites, input.Region,
        [&](double done) { return input.Progress(share + (1.0 - share) * done); }, mesh);
  if (!why.empty())
  {
    return Fail(std::move(why));
  }
  return { TessellationStatus::Done, {}, std::move(mesh.Mesh) };
}

} // namespace

std::string VoronoiMesh(const std::vector<Point2>& sites, const Domain& domain,
  const std::function<bool(double)>& progress, ClippedMesh& mesh)
{
  double tolerance = 0.0;
  std::string why = FindTolerance(domain, static_cast<double>(sites.size()), tolerance);
  if (!why.empty())
  {
    return why;
  }
  const PolygonMesh cells = VoronoiCells(
    sites, BoxOf(domain), tolerance, [&](double done) { return progress(0.5 * done); });
  if (cells.NumberOfElements() != static_cast<int>(sites.size()) || !progress(0.5))
  {
    return "Stopped.";
  }
  return ClipMesh(cells, domain, tolerance, mesh);
}

std::string RelaxSites(const Domain& domain, int iterations,
  const std::function<bool(double)>& progress, std::vector<Point2>& sites)
{
  const DomainLocator locator(domain);
  ClippedMesh mesh;
  for (int i = 0; i < iterations; ++i)
  {
    std::string why = VoronoiMesh(
      sites, domain, [&](double done) { return progress((i + done) / iterations); }, mesh);
    if (!why.empty())
    {
      return why;
    }
    const std::vector<Point2> centroids = FindCentroids(mesh, sites);
    for (std::size_t site = 0; site < sites.size(); ++site)
    {
      sites[site] = locator.Contains(centroids[site]) ? centroids[site] : sites[site];
    }
  }
  return {};
}

TessellationResult MakeVoronoi(const TessellationInput& input)
{
  return MakeRelaxedVoronoi(input, input.Values.Get("spacing"), 0);
}

TessellationResult MakeCentroidalVoronoi(const TessellationInput& input)
{
  return MakeRelaxedVoronoi(input, 0.0, input.Values.GetInteger("iterations"));
}

} // namespace pemesh
