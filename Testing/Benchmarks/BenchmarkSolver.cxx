// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * How fast the bundled solver is, by order and kind of mesh, and against a 5-point matrix
 * factorised by Eigen in the same run.
 *
 *   BenchmarkSolver [largest number of unknowns = 1e6] [threads = 1] [mesh = all of them] [order =
 * all]
 *
 * One line a run: unknowns, seconds of all processors, in all and of the stages, the ratio to the
 * baseline at the same number of unknowns, error, peak memory of a process that did this alone.
 */
#include "EllipticProblem.h"
#include "MeshConversion.h"
#include "ParallelLoop.h"
#include "Tessellations.h"
#include "TestProblems.h"
#include "VirtualElementMethod.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iterator>
#include <string>
#include <vector>

namespace
{

/** Of all processors: other work on the machine does not count. */
double ProcessorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

vtkSmartPointer<vtkPolyData> MakeMesh(const char* name, double cells)
{
  const pemesh::Tessellation& entry =
    pemesh::Tessellations()[static_cast<std::size_t>(pemesh::FindTessellation(name))];
  pemesh::TessellationInput input;
  input.Values = pemesh::ParameterValues(entry.Parameters);
  input.Values.Set(entry.Parameters[0].Name, cells);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  pemesh::SetPolygonMesh(mesh, pemesh::MakeTessellation(entry, input).Mesh);
  return mesh;
}

/** Eigen's SimplicialLDLT on the 5-point matrix, assembled and solved. */
double BaselineSeconds(double unknowns)
{
  const int n = static_cast<int>(std::sqrt(unknowns));
  const double start = ProcessorSeconds();
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const int id = j * n + i;
      entries.emplace_back(id, id, 4.0);
      if (i + 1 < n)
      {
        entries.emplace_back(id + 1, id, -1.0);
      }
      if (j + 1 < n)
      {
        entries.emplace_back(id + n, id, -1.0);
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(n * n, n * n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::VectorXd solution = solver.solve(Eigen::VectorXd::Ones(n * n));
  return solution.allFinite() ? ProcessorSeconds() - start : 0.0;
}

struct Sample
{
  const char* Mesh;
  double Cells; ///< for so many unknowns
  int Order;
};

void Measure(const Sample& sample, int threads)
{
  const auto mesh = MakeMesh(sample.Mesh, sample.Cells);
  pemesh::SetNumberOfThreads(threads);
  pemesh::VirtualElementOptions options;
  options.Order = sample.Order;
  std::vector<double> ends;
  const double start = ProcessorSeconds();
  const auto result = pemesh::SolveElliptic(mesh, *pemesh::FindTestProblem("franke"), options,
    [&, last = 0.0](double fraction) mutable
    {
      if (fraction > last) // the same one is told again within a stage
      {
        ends.push_back(ProcessorSeconds());
      }
      last = fraction;
      return true;
    });
  ends.push_back(ProcessorSeconds());
  const double seconds = ends.back() - start;
  const double memory = result.MemoryMegabytes;
  const double baseline = BaselineSeconds(result.DegreesOfFreedom);
  std::printf("%-10s order %d %9lld elements %9.0f unknowns %7.2f s (", sample.Mesh, sample.Order,
    static_cast<long long>(mesh->GetNumberOfPolys()), result.DegreesOfFreedom, seconds);
  constexpr const char* stages[] = { "mesh", "elements", "assembly", "solution", "condition",
    "details", "errors" };
  double begin = start;
  for (std::size_t i = 0; i < ends.size() && i < std::size(stages); ++i)
  {
    std::printf("%s%s %.2f", i == 0 ? "" : ", ", stages[i], ends[i] - begin);
    begin = ends[i];
  }
  std::printf(") %5.2f x baseline (%.2f s)  L2 error %.1e  %5.0f MB\n", seconds / baseline,
    baseline, result.RelativeErrorL2, memory);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  const double largest = argc > 1 ? std::atof(argv[1]) : 1e6;
  const int threads = argc > 2 ? std::atoi(argv[2]) : 1;
  const std::string wanted = argc > 3 ? argv[3] : "";
  const int order = argc > 4 ? std::atoi(argv[4]) : 0;
  for (double unknowns = 1e5; unknowns <= largest; unknowns *= 10.0)
  {
    const double side = std::round(std::sqrt(unknowns));
    std::vector<Sample> samples = { { "triangles", side, 1 }, { "voronoi", unknowns / 2.0, 1 } };
    if (unknowns == 1e5)
    {
      samples.push_back({ "triangles", std::round(std::sqrt(unknowns / 2.0)), 3 }); // 1e5 triangles
    }
    for (const Sample& sample : samples)
    {
      if ((!wanted.empty() && wanted != sample.Mesh) || (order > 0 && order != sample.Order))
      {
        continue;
      }
      const pid_t child = fork(); // so that the peak of one is not that of another
      if (child == 0)
      {
        Measure(sample, threads);
        std::_Exit(0);
      }
      waitpid(child, nullptr, 0);
    }
  }
  return 0;
}
