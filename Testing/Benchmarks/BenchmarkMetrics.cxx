// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * How fast elements are measured, by all metrics and by each kernel.
 *
 *   BenchmarkMetrics [largest number of elements = 1e6] [largest number of triangles = the same]
 *
 * For a mesh of triangles, one of Voronoi cells and one of agglomerated, concave elements, of 10^4
 * elements and more: elements a second of vtkPEMMetrics with all metrics, of processor time on one
 * thread and by the clock with one and with two threads (the best of three each; only a machine
 * with nothing else to do tells what the second thread gains), that over the target and over the
 * two predecessors of PEMesh, the processor time an element over that at 10^5 elements (linear
 * cost: 1), and the peak memory over that of mesh and result arrays. Then, for 10^5 elements, what
 * each kernel costs alone, and that over two baselines of the same run: the plain shoelace formula,
 * and the largest inscribed circle by trying all triples of edges and vertices (of the first few
 * elements). Every mesh is made and measured in a process of its own. For the linear cost up to
 * 10^7 elements: BenchmarkMetrics 1e7, of which the agglomerated ones take the longest.
 */
#include "../Filters/Geometry/BruteForce.h"
#include "ElementAccess.h"
#include "EnclosingCircle.h"
#include "InscribedCircle.h"
#include "ParallelLoop.h"
#include "PolygonCrossings.h"
#include "PolygonKernel.h"
#include "PolygonMeasures.h"
#include "vtkPEMAgglomerate.h"
#include "vtkPEMDomainMesher.h"
#include "vtkPEMMetrics.h"
#include "vtkPEMTessellation.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <span>
#include <string>
#include <vector>

namespace
{

using pemesh::Point2;
using pemesh::PolygonView;

void MakeTriangles(double elements, vtkPolyData* mesh)
{
  vtkNew<vtkPolyData> noPolygons;
  vtkNew<vtkPEMDomainMesher> mesher;
  mesher->SetInputData(noPolygons);
  mesher->SetAreaRuleByName("constant");
  mesher->SetMaximumArea(1.13 / elements); // the mean is below the largest
  mesher->Update();
  mesh->ShallowCopy(mesher->GetOutput());
}

void MakeVoronoiCells(double elements, vtkPolyData* mesh)
{
  vtkNew<vtkPEMTessellation> tessellation;
  tessellation->SetKindByName("voronoi");
  tessellation->SetParameter("cells", elements);
  tessellation->Update();
  mesh->ShallowCopy(tessellation->GetOutput());
}

void MakeAgglomeratedElements(double elements, vtkPolyData* mesh)
{
  constexpr double TrianglesOfAnElement = 10.0; // which have 9.4 vertices then
  vtkNew<vtkPolyData> triangles;
  MakeTriangles(TrianglesOfAnElement * elements, triangles);
  vtkNew<vtkPEMAgglomerate> agglomerate;
  agglomerate->SetInputData(triangles);
  agglomerate->SetRuleByName("metis");
  agglomerate->SetTargetPercentage(100.0 / TrianglesOfAnElement);
  agglomerate->Update();
  mesh->ShallowCopy(agglomerate->GetOutput());
}

/**
 * Elements a second, one thread. Those of the predecessors of PEMesh (of 2022, with 17 metrics, and
 * of 2024, with 12) were measured on two cores of an Intel Xeon virtual machine, Debian 12, g++ 12,
 * median of three, on meshes of the same kinds.
 */
struct MeshKind
{
  const char* Name;
  void (*Make)(double elements, vtkPolyData* mesh);
  double Target;
  double Predecessor2022;
  double Predecessor2024;
};

constexpr MeshKind MeshKinds[] = {
  { "triangles", MakeTriangles, 2.4e6, 24e3, 13.5e3 },
  { "voronoi", MakeVoronoiCells, 600e3, 6.6e3, 4.2e3 },
  { "agglomerated", MakeAgglomeratedElements, 250e3, 3.8e3, 2.0e3 },
};

/** All buffers a kernel may need, so that none of them allocates for every element. */
struct Buffers
{
  pemesh::InscribedCircleFinder CircleFinder;
  pemesh::PolygonKernelFinder KernelFinder;
};

struct KernelCost
{
  const char* Name;
  double (*Function)(PolygonView polygon, Buffers& buffers);
  std::size_t MostElements;
};

double PlainArea(PolygonView polygon, Buffers& /*buffers*/)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& a = polygon[i];
    const Point2& b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    sum += a.x * b.y - a.y * b.x;
  }
  return 0.5 * sum;
}

constexpr std::size_t All = 1000000000;
constexpr KernelCost Kernels[] = {
  { "plain shoelace area (baseline)", PlainArea, All },
  { "area", [](PolygonView p, Buffers&) { return pemesh::SignedArea(p); }, All },
  { "edges", [](PolygonView p, Buffers&) { return pemesh::MeasureEdges(p).Perimeter; }, All },
  { "angles", [](PolygonView p, Buffers&) { return pemesh::MeasureAngles(p).Largest; }, All },
  { "orientation", [](PolygonView p, Buffers&) { return double(pemesh::PolygonOrientation(p)); },
    All },
  { "convex or not", [](PolygonView p, Buffers&) { return double(pemesh::IsConvex(p)); }, All },
  { "crossing edges", [](PolygonView p, Buffers&) { return double(pemesh::HasCrossingEdges(p)); },
    All },
  { "farthest pair", [](PolygonView p, Buffers&) { return pemesh::FarthestPair(p).Distance; },
    All },
  { "closest pair", [](PolygonView p, Buffers&) { return pemesh::ClosestPair(p).Distance; }, All },
  { "enclosing circle",
    [](PolygonView p, Buffers&) { return pemesh::SmallestEnclosingCircle(p).Radius; }, All },
  { "kernel area",
    [](PolygonView p, Buffers& b)
    {
      b.KernelFinder.Find(p);
      return b.KernelFinder.GetArea();
    },
    All },
  { "circle in the kernel",
    [](PolygonView p, Buffers& b) { return b.CircleFinder.FindInKernel(p).Radius; }, All },
  { "inscribed circle", [](PolygonView p, Buffers& b) { return b.CircleFinder.Find(p).Radius; },
    All },
  { "inscribed circle, all triples (baseline)",
    [](PolygonView p, Buffers&) { return pemesh::test::BruteInscribedRadius(p); }, 100 },
};

double ProcessorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/** Megabytes, of /proc/self/status: VmRSS, now, or VmHWM, at most since ResetPeak. */
double Memory(const std::string& entry)
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
  {
    if (word == entry + ":")
    {
      double kilobytes = 0.0;
      status >> kilobytes;
      return kilobytes / 1024.0;
    }
  }
  return 0.0;
}

void ResetPeak()
{
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
}

struct Timing
{
  double Clock = 1e300;
  double Processor = 1e300;
};

Timing MeasureAll(vtkPolyData* mesh, int threads, int repetitions)
{
  pemesh::SetNumberOfThreads(threads);
  Timing best;
  for (int i = 0; i < repetitions; ++i)
  {
    vtkNew<vtkPEMMetrics> metrics;
    metrics->SetInputData(mesh);
    const auto start = std::chrono::steady_clock::now();
    const double processor = ProcessorSeconds();
    metrics->Update();
    const std::chrono::duration<double> clock = std::chrono::steady_clock::now() - start;
    best.Clock = std::min(best.Clock, clock.count());
    best.Processor = std::min(best.Processor, ProcessorSeconds() - processor);
  }
  return best;
}

/** Peak of measuring, over what mesh and result arrays take. */
double MeasureMemory(vtkPolyData* mesh)
{
  pemesh::SetNumberOfThreads(1);
  ResetPeak();
  const double before = Memory("VmRSS");
  vtkNew<vtkPEMMetrics> metrics;
  metrics->SetInputData(mesh);
  metrics->Update();
  const double peak = Memory("VmHWM");
  const auto size =
    static_cast<double>(mesh->GetNumberOfPolys()) * static_cast<double>(sizeof(double));
  const double results = size * static_cast<double>(metrics->GetMetrics().size()) / 1048576.0;
  const double meshMemory = static_cast<double>(mesh->GetActualMemorySize()) / 1024.0;
  return (peak - before + meshMemory) / (meshMemory + results);
}

void MeasureKernels(vtkPolyData* mesh)
{
  pemesh::ElementAccess access(mesh);
  std::vector<Point2> points;
  std::vector<std::size_t> offsets = { 0 };
  std::vector<Point2> element;
  for (vtkIdType i = 0; i < access.GetNumberOfElements(); ++i)
  {
    access.GetVertices(i, element);
    points.insert(points.end(), element.begin(), element.end());
    offsets.push_back(points.size());
  }
  Buffers buffers;
  std::vector<double> costs;
  for (const KernelCost& kernel : Kernels)
  {
    const std::size_t count = std::min(kernel.MostElements, offsets.size() - 1);
    double sum = 0.0;
    double best = 1e300;
    for (int repetition = 0; repetition < 3; ++repetition)
    {
      const double start = ProcessorSeconds();
      for (std::size_t i = 0; i < count; ++i)
      {
        const PolygonView all(points);
        sum += kernel.Function(all.subspan(offsets[i], offsets[i + 1] - offsets[i]), buffers);
      }
      best = std::min(best, ProcessorSeconds() - start);
    }
    costs.push_back(1e6 * best / static_cast<double>(count));
    std::printf("    %-42s %8.3f us an element, %6.1f x shoelace (sum %.6g)\n", kernel.Name,
      costs.back(), costs.back() / costs.front(), sum / 3.0);
  }
  const double circle = costs[costs.size() - 2];
  std::printf(
    "    the inscribed circle is %.0f x as fast as by all triples\n", costs.back() / circle);
  std::fflush(stdout);
}

/** `reference` is the cost of an element at 10^5 of them, shared by the processes; 0 before. */
void Measure(const MeshKind& kind, double elements, double& reference)
{
  vtkNew<vtkPolyData> mesh;
  kind.Make(elements, mesh);
  const auto count = static_cast<double>(mesh->GetNumberOfPolys());
  if (count == 0.0)
  {
    std::printf("%-13s %9.0f elements were not made\n", kind.Name, elements);
    std::fflush(stdout);
    return;
  }
  const double memory = MeasureMemory(mesh);
  const int repetitions = elements > 2e6 ? 1 : 3;
  const Timing one = MeasureAll(mesh, 1, repetitions);
  const Timing two = MeasureAll(mesh, 2, repetitions);
  const double vertices = static_cast<double>(mesh->GetPolys()->GetNumberOfConnectivityIds());
  const double speed = count / one.Processor;
  constexpr double SizeForKernels = 1e5;
  reference = elements == SizeForKernels ? 1.0 / speed : reference;
  const double growth = reference > 0.0 ? 1.0 / (speed * reference) : std::nan("");
  std::printf("%-13s %9.0f %8.1f %9.0f %9.0f %9.0f %7.2f %7.2f %7.0f %7.0f %7.2f %7.2f\n",
    kind.Name, count, vertices / count, 1e-3 * speed, 1e-3 * count / one.Clock,
    1e-3 * count / two.Clock, one.Clock / two.Clock, speed / kind.Target,
    speed / kind.Predecessor2022, speed / kind.Predecessor2024, growth, memory);
  std::fflush(stdout);
  if (elements == SizeForKernels)
  {
    MeasureKernels(mesh);
  }
}

} // namespace

int main(int argc, char** argv)
{
  const double largest = argc > 1 ? std::atof(argv[1]) : 1e6;
  const double largestOfTriangles = argc > 2 ? std::atof(argv[2]) : largest;
  std::printf(
    "%d metrics, k elements/s\n", static_cast<int>(vtkNew<vtkPEMMetrics>()->GetMetrics().size()));
  std::printf("%-13s %9s %8s %9s %9s %9s %7s %7s %7s %7s %7s %7s\n", "mesh", "elements", "vertices",
    "processor", "1 thread", "2 threads", "2 / 1", "/target", "/2022", "/2024", "cost", "memory");
  std::fflush(stdout); // before there are more processes
  auto* reference = static_cast<double*>(
    mmap(nullptr, sizeof(double), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  if (reference == MAP_FAILED)
  {
    std::perror("mmap");
    return 1;
  }
  for (const MeshKind& kind : MeshKinds)
  {
    *reference = 0.0;
    const double limit = kind.Make == MakeTriangles ? largestOfTriangles : largest;
    for (double elements = 1e4; elements <= 1.001 * limit; elements *= 10.0)
    {
      const pid_t child = fork(); // so that the peak of one is not that of another
      if (child == 0)
      {
        Measure(kind, elements, *reference);
        std::_Exit(0);
      }
      waitpid(child, nullptr, 0);
    }
  }
  return 0;
}
