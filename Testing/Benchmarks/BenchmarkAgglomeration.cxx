// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * How fast a triangulation is agglomerated by each rule, beside plain METIS on its dual graph.
 *
 *   BenchmarkAgglomeration [largest number of triangles = 1e6] [percentage to keep = 10]
 *
 * One line a size and rule: elements, seconds of processor time, peak memory beyond the input, cut
 * edges of the dual graph, and the ratios of time and cut to those of one call of
 * METIS_PartGraphKway in the same run; of that, too, how many of its parts are in pieces or empty.
 * Every line is measured in a process of its own.
 */
#include "Agglomeration.h"
#include "DualGraph.h"
#include "MeshConversion.h"
#include "MetricRegistry.h"
#include "vtkPEMDomainMesher.h"
#include "vtkPEMPolygonLayout.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace
{

using pemesh::AgglomerationOptions;
using pemesh::AgglomerationResult;
using pemesh::PolygonMesh;

struct Input
{
  PolygonMesh Mesh;
  std::vector<bool> Placed;
  double MeanDiameter = 0.0; ///< of an element
};

struct Measurement
{
  double Seconds = 0.0;
  double Megabytes = 0.0;
  double Elements = 0.0;
  double Cut = 0.0;
  double Pieces = 0.0; ///< parts in pieces
  double Empty = 0.0;  ///< parts
};

Input MakeInput(double triangles)
{
  vtkNew<vtkPEMPolygonLayout> layout;
  layout->AddPolygon("comb", 0.25, 0.25);
  layout->AddPolygon("star", 0.75, 0.25);
  layout->AddPolygon("zeta", 0.25, 0.75);
  layout->AddPolygon("u-like", 0.75, 0.75);
  vtkNew<vtkPEMDomainMesher> mesher;
  mesher->SetInputConnection(layout->GetOutputPort());
  mesher->SetAreaRuleByName("constant");
  mesher->SetMaximumArea(0.825 / triangles);
  mesher->UpdateTimeStep(0.5);
  Input input;
  input.Mesh = pemesh::ToPolygonMesh(mesher->GetOutput());
  vtkDataArray* ids = mesher->GetOutput()->GetCellData()->GetArray(pemesh::PolygonIdArray);
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    input.Placed.push_back(ids->GetTuple1(i) >= 0.0);
  }
  input.MeanDiameter = std::sqrt(2.3 / input.Mesh.NumberOfElements());
  return input;
}

pemesh::DualGraph MakeGraph(const Input& input)
{
  pemesh::ElementMerger merger(input.Mesh, pemesh::FindAdjacency(input.Mesh));
  return pemesh::MakeDualGraph(merger, [&input](int element) { return input.Placed[element]; });
}

double PeakMegabytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/** Runs the work in a process of its own, so that its peak memory is that of this work alone. */
Measurement MeasureApart(const std::function<void(Measurement&)>& work)
{
  int channel[2];
  Measurement measured;
  if (pipe(channel) != 0)
  {
    return measured;
  }
  const pid_t child = fork();
  if (child == 0)
  {
    const double before = PeakMegabytes();
    work(measured);
    measured.Megabytes -= before;
    const bool sent = write(channel[1], &measured, sizeof(measured)) == sizeof(measured);
    _exit(sent ? 0 : 1);
  }
  close(channel[1]);
  if (read(channel[0], &measured, sizeof(measured)) != sizeof(measured))
  {
    std::printf("a measurement failed\n");
  }
  close(channel[0]);
  waitpid(child, nullptr, 0);
  return measured;
}

double SecondsOf(const std::function<void()>& work)
{
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

void CountPieces(
  const pemesh::DualGraph& graph, const std::vector<int>& part, int parts, Measurement& measured)
{
  std::vector<int> pieces(static_cast<std::size_t>(parts), 0);
  std::vector<bool> seen(part.size(), false);
  std::vector<int> stack;
  for (int start = 0; start < graph.NumberOfNodes(); ++start)
  {
    if (seen[start])
    {
      continue;
    }
    ++pieces[part[start]];
    seen[start] = true;
    stack.assign(1, start);
    while (!stack.empty())
    {
      const int node = stack.back();
      stack.pop_back();
      for (int j = graph.Offsets[node]; j < graph.Offsets[node + 1]; ++j)
      {
        const int neighbor = graph.Neighbors[j];
        if (!seen[neighbor] && part[neighbor] == part[start])
        {
          seen[neighbor] = true;
          stack.push_back(neighbor);
        }
      }
    }
  }
  measured.Empty = static_cast<double>(std::count(pieces.begin(), pieces.end(), 0));
  measured.Pieces = static_cast<double>(
    std::count_if(pieces.begin(), pieces.end(), [](int count) { return count > 1; }));
}

Measurement MeasureMetis(const pemesh::DualGraph& graph, int parts, bool byBlocks)
{
  return MeasureApart(
    [&](Measurement& measured)
    {
      std::vector<int> part;
      measured.Seconds = SecondsOf(
        [&]
        {
          part = byBlocks ? pemesh::PartitionByBlocks(graph, parts, 1)
                          : pemesh::PartitionPlainly(graph, parts, 1);
        });
      measured.Megabytes = PeakMegabytes();
      measured.Elements = parts;
      measured.Cut = static_cast<double>(pemesh::CountCutEdges(graph, part));
      CountPieces(graph, part, parts, measured);
    });
}

Measurement MeasureRule(const Input& input, const pemesh::DualGraph& graph,
  const pemesh::AgglomerationRule& rule, const char* metric, double percentage)
{
  return MeasureApart(
    [&](Measurement& measured)
    {
      AgglomerationOptions options(rule);
      options.Placed = input.Placed;
      options.Metric = metric ? pemesh::FindMetric(metric) : nullptr;
      options.TargetPercentage = percentage;
      // Large enough for the target to be met.
      options.Parameters.Set("max-diameter", 6.0 * input.MeanDiameter * 10.0 / percentage);
      AgglomerationResult result;
      measured.Seconds = SecondsOf([&] { result = pemesh::Agglomerate(input.Mesh, options); });
      measured.Megabytes = PeakMegabytes();
      measured.Elements = result.Mesh.NumberOfElements();
      std::vector<int> part;
      for (const int element : graph.Elements)
      {
        part.push_back(result.Group.at(static_cast<std::size_t>(element)));
      }
      measured.Cut = static_cast<double>(pemesh::CountCutEdges(graph, part));
    });
}

void Print(const std::string& name, const Measurement& measured, const Measurement& plain)
{
  std::printf("%-32s %9.0f %8.2f s %7.0f MB  cut %9.0f  time %6.3f cut %6.3f of plain METIS\n",
    name.c_str(), measured.Elements, measured.Seconds, measured.Megabytes, measured.Cut,
    measured.Seconds / plain.Seconds, measured.Cut / plain.Cut);
  std::fflush(stdout);
}

void MeasureSize(double triangles, double percentage)
{
  const Input input = MakeInput(triangles);
  malloc_trim(0); // what the mesher freed must not hide what a rule takes
  const pemesh::DualGraph graph = MakeGraph(input);
  const int parts =
    static_cast<int>(std::lround(percentage / 100.0 * input.Mesh.NumberOfElements()));
  std::printf("%d elements\n", input.Mesh.NumberOfElements());
  const Measurement plain = MeasureMetis(graph, parts, false);
  Print("METIS_PartGraphKway", plain, plain);
  std::printf("  of its parts %.0f (%.1f %%) are in pieces, %.0f are empty\n", plain.Pieces,
    100.0 * plain.Pieces / parts, plain.Empty);
  Print("METIS by blocks, not repaired", MeasureMetis(graph, parts, true), plain);
  for (const pemesh::AgglomerationRule& rule : pemesh::AgglomerationRules())
  {
    if (rule.Metric != pemesh::RuleMetric::WorstFirst)
    {
      Print(rule.Name, MeasureRule(input, graph, rule, nullptr, percentage), plain);
      continue;
    }
    for (const char* metric :
      { "AreaPerimeterRatio", "ShapeRegularity", "CircleRatio", "MinAngle" })
    {
      Print(std::string(rule.Name) + " " + metric,
        MeasureRule(input, graph, rule, metric, percentage), plain);
    }
  }
}

} // namespace

int main(int count, char** arguments)
{
  const double largest = count > 1 ? std::atof(arguments[1]) : 1e6;
  const double percentage = count > 2 ? std::atof(arguments[2]) : 10.0;
  for (double triangles = 1e4; triangles <= 1.001 * largest; triangles *= 10.0)
  {
    MeasureSize(triangles, percentage);
  }
  return 0;
}
