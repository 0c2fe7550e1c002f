// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshMeasurer.h"

#include "ElementAccess.h"
#include "ElementGeometry.h"
#include "MeshConversion.h"
#include "MeshSurroundings.h"
#include "ParallelLoop.h"

#include <vtkCellArray.h>
#include <vtkPolyData.h>
#include <vtkSMPThreadLocal.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace pemesh
{

namespace
{

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

/** Buffers of one thread; the access is made by the thread that uses it. */
struct Worker
{
  std::optional<ElementAccess> Access;
  std::vector<Point2> Vertices;
  ElementGeometry Geometry;
};

/**
 * Measures a range of elements. Each element is independent of all others and writes its own
 * values only, so the result does not depend on how elements are spread over threads.
 */
class ElementMeasurer
{
public:
  ElementMeasurer(vtkPolyData* mesh, const std::vector<MetricColumn>& columns,
    std::vector<ElementCondition>& conditions)
    : Mesh(mesh)
    , Columns(columns)
    , Conditions(conditions)
  {
  }

  void MeasureRange(vtkIdType begin, vtkIdType end)
  {
    Worker& worker = this->Workers.Local();
    if (!worker.Access)
    {
      worker.Access = ElementAccess(this->Mesh);
    }
    for (vtkIdType element = begin; element < end; ++element)
    {
      this->Measure(worker, element);
    }
  }

private:
  void Measure(Worker& worker, vtkIdType element)
  {
    worker.Access->GetVertices(element, worker.Vertices);
    const bool valid = worker.Geometry.SetVertices(worker.Vertices);
    this->Conditions[static_cast<std::size_t>(element)] = !valid ? ElementCondition::Degenerate
      : worker.Geometry.HasRepeatedVertices()                    ? ElementCondition::Repeated
                                                                 : ElementCondition::Measured;
    for (const MetricColumn& column : this->Columns)
    {
      column.Values[element] = valid ? column.Definition->Function(worker.Geometry) : NotANumber;
    }
  }

  vtkPolyData* Mesh;
  const std::vector<MetricColumn>& Columns;
  std::vector<ElementCondition>& Conditions;
  vtkSMPThreadLocal<Worker> Workers;
};

/** Large enough to keep threads busy, small enough to stop within a fraction of a second. */
vtkIdType ChunkSize(vtkPolyData* mesh, vtkIdType elements)
{
  constexpr vtkIdType VerticesOfAChunk = 200000;
  constexpr vtkIdType MostChunks = 100;
  const vtkIdType vertices = mesh->GetPolys()->GetNumberOfConnectivityIds() / elements;
  const vtkIdType fitting =
    std::max<vtkIdType>(1, VerticesOfAChunk / std::max<vtkIdType>(1, vertices));
  return vertices > 1000 ? fitting : std::max(std::min(elements, fitting), elements / MostChunks);
}

/** Calls `body` for all elements in parallel, a chunk after the other. */
bool LoopOverElements(vtkPolyData* mesh, const std::function<bool(double)>& goOn,
  const std::function<void(vtkIdType, vtkIdType)>& body)
{
  const vtkIdType elements = mesh->GetNumberOfPolys();
  const vtkIdType chunk = elements > 0 ? ChunkSize(mesh, elements) : 1;
  for (vtkIdType begin = 0; begin < elements; begin += chunk)
  {
    const vtkIdType end = std::min(begin + chunk, elements);
    ParallelLoop(begin, end, 0, body);
    if (!goOn(static_cast<double>(end) / static_cast<double>(elements)))
    {
      return false;
    }
  }
  return true;
}

double LargestOf(const double* values, vtkIdType count)
{
  double largest = NotANumber;
  for (vtkIdType i = 0; i < count; ++i)
  {
    largest = values[i] > largest || std::isnan(largest) ? values[i] : largest;
  }
  return largest;
}

const MetricColumn* FindColumn(const std::vector<MetricColumn>& columns, std::string_view name)
{
  const auto found = std::ranges::find_if(
    columns, [name](const MetricColumn& column) { return name == column.Definition->Name; });
  return found == columns.end() ? nullptr : &*found;
}

} // namespace

MeshMeasurer::MeshMeasurer(vtkPolyData* mesh)
  : Mesh(mesh)
  , Conditions(static_cast<std::size_t>(mesh->GetNumberOfPolys()), ElementCondition::Measured)
{
}

MeshMeasurer::~MeshMeasurer() = default;

const MeshNeighbours& MeshMeasurer::GetNeighbours()
{
  if (!this->Neighbours)
  {
    this->Neighbours = std::make_unique<MeshNeighbours>(ToPolygonMesh(this->Mesh));
  }
  return *this->Neighbours;
}

bool MeshMeasurer::Measure(
  const std::vector<MetricColumn>& columns, const std::function<bool(double)>& goOn)
{
  std::vector<MetricColumn> alone;
  std::vector<MetricColumn> inMesh;
  for (const MetricColumn& column : columns)
  {
    (column.Definition->InMesh ? inMesh : alone).push_back(column);
  }
  std::vector<std::vector<double>> aside; // of base metrics that nobody asked for
  for (const MetricColumn& column : inMesh)
  {
    const std::string_view base = column.Definition->Base;
    if (!base.empty() && !FindColumn(alone, base))
    {
      aside.emplace_back(static_cast<std::size_t>(this->Mesh->GetNumberOfPolys()));
      alone.push_back({ FindMetric(base), aside.back().data() });
    }
  }
  const double steps = static_cast<double>(inMesh.size()) + 1.0;
  double done = 0.0;
  const auto report = [&](double fraction)
  {
    const bool last = fraction == 1.0 && done + 1.0 == steps;
    return goOn(last ? 1.0 : (done + fraction) / steps);
  };
  bool isComplete = this->MeasureAlone(alone, report);
  for (const MetricColumn& column : inMesh)
  {
    done += 1.0;
    isComplete = isComplete && this->MeasureInMesh(alone, column, report);
  }
  return isComplete;
}

bool MeshMeasurer::MeasureAlone(
  const std::vector<MetricColumn>& columns, const std::function<bool(double)>& goOn)
{
  ElementMeasurer measurer(this->Mesh, columns, this->Conditions);
  return LoopOverElements(this->Mesh, goOn,
    [&measurer](vtkIdType begin, vtkIdType end) { measurer.MeasureRange(begin, end); });
}

bool MeshMeasurer::MeasureInMesh(const std::vector<MetricColumn>& columns,
  const MetricColumn& column, const std::function<bool(double)>& goOn)
{
  const Metric& metric = *column.Definition;
  MeshSurroundings surroundings;
  if (const MetricColumn* base = FindColumn(columns, metric.Base))
  {
    surroundings.Base = base->Values;
    surroundings.LargestBase = LargestOf(base->Values, this->Mesh->GetNumberOfPolys());
  }
  if ((metric.Needs & NeedsNeighbours) != 0)
  {
    surroundings.Neighbours = &this->GetNeighbours();
  }
  return LoopOverElements(this->Mesh, goOn,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType element = begin; element < end; ++element)
      {
        const bool isDefined =
          this->Conditions[static_cast<std::size_t>(element)] != ElementCondition::Degenerate;
        column.Values[element] = isDefined ? metric.InMesh(surroundings, element) : NotANumber;
      }
    });
}

} // namespace pemesh
