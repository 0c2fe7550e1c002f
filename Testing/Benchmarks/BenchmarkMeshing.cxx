// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * How fast the unit square is meshed around four polygons, beside CGAL's mesher on the same domain.
 *
 *   BenchmarkMeshing [largest size = 1e7] [largest size of the baseline = 1e5]
 *
 * One line a size: triangles, seconds, triangles a second, smallest angle, peak memory of the
 * process that did nothing else (its libraries included), and the ratio to the baseline's speed.
 */
#include "DomainMesh.h"
#include "PolygonFamilies.h"
#include "PolygonPlacement.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <list>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace
{

using pemesh::Point2;

constexpr double MinimumAngle = 20.0;

struct Result
{
  double Triangles = 0.0;
  double Seconds = 0.0;
  double SmallestAngle = 0.0;
  double Megabytes = 0.0;
};

std::vector<std::vector<Point2>> FourPolygons()
{
  std::vector<std::vector<Point2>> polygons;
  const std::pair<const char*, Point2> places[] = { { "n-sided", { 0.25, 0.25 } },
    { "convexity", { 0.75, 0.25 } }, { "isotropy", { 0.25, 0.75 } }, { "u-like", { 0.75, 0.75 } } };
  for (const auto& [name, center] : places)
  {
    const pemesh::PolygonFamily* family = pemesh::FindPolygonFamily(name);
    polygons.push_back(pemesh::PlacePolygon(
      family->Vertices(0.5, pemesh::ParameterValues(family->Parameters)), center, 0.7, 15.0));
  }
  return polygons;
}

/** Both meshers make triangles of about two thirds of the area allowed, or less. */
double AreaFor(double size)
{
  return 1.0 / size;
}

/** CGAL bounds edges: this length gives it about as many triangles. */
double LengthFor(double size)
{
  return 2.0 / std::sqrt(size);
}

/** Processor time, so that other programs on the machine count less. */
double SecondsOf(const std::function<void()>& work)
{
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

Result MeshWithPEMesh(double size)
{
  pemesh::DomainMeshOptions options;
  options.MinimumAngle = MinimumAngle;
  options.MaximumArea = AreaFor(size);
  options.MaximumElements = pemesh::MostElements;
  const std::vector<std::vector<Point2>> polygons = FourPolygons();
  Result result;
  result.Seconds = SecondsOf(
    [&]
    {
      const pemesh::DomainMesh mesh = pemesh::MeshDomain(pemesh::UnitSquare(), polygons, options);
      result.Triangles = mesh.Elements.NumberOfElements() - static_cast<double>(polygons.size());
      result.SmallestAngle = mesh.AttainedMinimumAngle;
    });
  return result;
}

Result MeshWithCgal(double size)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using DataStructure =
    CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Kernel>,
      CGAL::Delaunay_mesh_face_base_2<Kernel>>;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, DataStructure>;
  using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;
  const std::vector<std::vector<Point2>> polygons = FourPolygons();
  Result result;
  Triangulation triangulation;
  result.Seconds = SecondsOf(
    [&]
    {
      std::vector<std::vector<Point2>> loops = polygons;
      loops.push_back(pemesh::UnitSquare().Outer);
      std::list<Kernel::Point_2> seeds;
      for (const std::vector<Point2>& loop : loops)
      {
        std::vector<Kernel::Point_2> points;
        for (const Point2& point : loop)
        {
          points.emplace_back(point.x, point.y);
        }
        triangulation.insert_constraint(points.begin(), points.end(), true);
      }
      for (const std::vector<Point2>& polygon : polygons)
      {
        // Just to the left of the first edge is inside.
        const Point2& from = polygon[0];
        const Point2& to = polygon[1];
        seeds.emplace_back(0.5 * (from.x + to.x) - 1e-6 * (to.y - from.y),
          0.5 * (from.y + to.y) + 1e-6 * (to.x - from.x));
      }
      const double sine = std::sin(MinimumAngle * std::numbers::pi / 180.0);
      CGAL::refine_Delaunay_mesh_2(
        triangulation, seeds.begin(), seeds.end(), Criteria(sine * sine, LengthFor(size)), false);
    });
  result.SmallestAngle = 60.0;
  for (const auto face : triangulation.finite_face_handles())
  {
    for (int i = 0; face->is_in_domain() && i < 3; ++i)
    {
      const auto from = face->vertex((i + 1) % 3)->point() - face->vertex(i)->point();
      const auto to = face->vertex((i + 2) % 3)->point() - face->vertex(i)->point();
      const double angle = std::atan2(from.x() * to.y() - from.y() * to.x(), from * to);
      result.SmallestAngle = std::min(result.SmallestAngle, angle * 180.0 / std::numbers::pi);
    }
    result.Triangles += face->is_in_domain();
  }
  return result;
}

/** Runs the work in a process of its own, whose peak memory is then its own as well. */
Result RunApart(const std::function<Result()>& work)
{
  Result result;
  int ends[2];
  if (pipe(ends) != 0)
  {
    return result;
  }
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0)
  {
    result = work();
    const bool written = write(ends[1], &result, sizeof(result)) == sizeof(result);
    _exit(written ? EXIT_SUCCESS : EXIT_FAILURE);
  }
  rusage usage = {};
  wait4(child, nullptr, 0, &usage);
  close(ends[1]);
  if (read(ends[0], &result, sizeof(result)) != sizeof(result))
  {
    std::printf("(failed) ");
  }
  close(ends[0]);
  result.Megabytes = static_cast<double>(usage.ru_maxrss) / 1024.0;
  return result;
}

void Print(const char* name, const Result& result)
{
  std::printf("%-8s %9.0f %8.2f s %9.0f /s %6.2f deg %7.0f MB", name, result.Triangles,
    result.Seconds, result.Triangles / result.Seconds, result.SmallestAngle, result.Megabytes);
}

} // namespace

int main(int count, char** arguments)
{
  const double largest = count > 1 ? std::atof(arguments[1]) : 1e7;
  const double largestBaseline = count > 2 ? std::atof(arguments[2]) : 1e5;
  std::printf(
    "Unit square less four polygons, minimum angle %g degrees, one thread\n", MinimumAngle);
  for (double size = 1e4; size <= 1.001 * largest; size *= 10.0)
  {
    const Result own = RunApart([size] { return MeshWithPEMesh(size); });
    Print("PEMesh", own);
    if (size <= 1.001 * largestBaseline)
    {
      const Result baseline = RunApart([size] { return MeshWithCgal(size); });
      std::printf("  %5.1f x\n",
        own.Triangles / own.Seconds * baseline.Seconds / std::max(1.0, baseline.Triangles));
      Print("CGAL", baseline);
    }
    std::printf("\n");
  }
  return EXIT_SUCCESS;
}
