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
#include <cstdint>
#include <optional>
#include <string_view>

#ifdef __linux__
#include <sys/mman.h>
#endif

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
  std::vector<double> Block; // values of some elements, one element after the other
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
      worker.Block.resize(BlockSize * this->Columns.size());
    }
    for (vtkIdType first = begin; first < end; first += BlockSize)
    {
      const vtkIdType last = std::min(first + BlockSize, end);
      for (vtkIdType element = first; element < last; ++element)
      {
        this->Measure(worker, element,
          worker.Block.data() + static_cast<std::size_t>(element - first) * this->Columns.size());
      }
      this->Write(worker.Block, first, last);
    }
  }

private:
  static constexpr vtkIdType BlockSize = 64;

  void Measure(Worker& worker, vtkIdType element, double* row)
  {
    worker.Access->GetVertices(element, worker.Vertices);
    const bool valid = worker.Geometry.SetVertices(worker.Vertices);
    this->Conditions[static_cast<std::size_t>(element)] = !valid ? ElementCondition::Degenerate
      : worker.Geometry.HasRepeatedVertices()                    ? ElementCondition::Repeated
                                                                 : ElementCondition::Measured;
    for (const MetricColumn& column : this->Columns)
    {
      *row++ = valid ? column.Definition->Function(worker.Geometry) : NotANumber;
    }
  }

  /**
   * A column after the other, many elements at a time: the arrays of a large mesh all begin at the
   * same place of a page, and as many places of the cache as there are columns would collide.
   */
  void Write(const std::vector<double>& block, vtkIdType first, vtkIdType last) const
  {
    const double* value = block.data();
    for (std::size_t i = 0; i < this->Columns.size(); ++i, ++value)
    {
      const double* from = value;
      for (vtkIdType element = first; element < last; ++element, from += this->Columns.size())
      {
        this->Columns[i].Values[element] = *from;
      }
    }
  }

  vtkPolyData* Mesh;
  const std::vector<MetricColumn>& Columns;
  std::vector<ElementCondition>& Conditions;
  vtkSMPThreadLocal<Worker> Workers;
};

/**
 * Fresh memory in pages of 2 MB where the system has them: writing to new pages of 4 kB one by one
 * costs as much as measuring a triangle. Only a hint, and only for pages that are filled anyway.
 */
void AskForLargePages([[maybe_unused]] double* values, [[maybe_unused]] std::size_t count)
{
#ifdef __linux__
  constexpr std::uintptr_t PageSize = std::uintptr_t{ 1 } << 21;
  const auto address = reinterpret_cast<std::uintptr_t>(values);
  const std::uintptr_t first = (address + PageSize - 1) / PageSize * PageSize;
  const std::uintptr_t last = (address + count * sizeof(double)) / PageSize * PageSize;
  if (first < last)
  {
    madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
  }
#endif
}

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
  for (const MetricColumn& column : columns)
  {
    AskForLargePages(column.Values, this->Conditions.size());
  }
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
