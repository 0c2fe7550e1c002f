// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMMetrics.h"

#include "CaseStatus.h"
#include "ElementAccess.h"
#include "ElementGeometry.h"
#include "MetricSelection.h"
#include "ParallelLoop.h"
#include "Progress.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSMPThreadLocal.h>

#include <algorithm>
#include <limits>
#include <optional>

vtkStandardNewMacro(vtkPEMMetrics);

namespace
{

enum class Condition : unsigned char
{
  Measured,
  Repeated,
  Degenerate
};

/** Buffers of one thread; the access is made by the thread that uses it. */
struct Worker
{
  std::optional<pemesh::ElementAccess> Access;
  std::vector<pemesh::Point2> Vertices;
  pemesh::ElementGeometry Geometry;
};

/**
 * Measures a range of elements. Each element is independent of all others and writes its own
 * values only, so the result does not depend on how elements are spread over threads.
 */
class ElementMeasurer
{
public:
  ElementMeasurer(vtkPolyData* mesh, const std::vector<const pemesh::Metric*>& metrics,
    const std::vector<double*>& values, std::vector<Condition>& conditions)
    : Mesh(mesh)
    , Metrics(metrics)
    , Values(values)
    , Conditions(conditions)
  {
  }

  void MeasureRange(vtkIdType begin, vtkIdType end)
  {
    Worker& worker = this->Workers.Local();
    if (!worker.Access)
    {
      worker.Access = pemesh::ElementAccess(this->Mesh);
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
    this->Conditions[static_cast<std::size_t>(element)] = !valid ? Condition::Degenerate
      : worker.Geometry.HasRepeatedVertices()                    ? Condition::Repeated
                                                                 : Condition::Measured;
    for (std::size_t i = 0; i < this->Metrics.size(); ++i)
    {
      this->Values[i][element] = valid ? this->Metrics[i]->Function(worker.Geometry)
                                       : std::numeric_limits<double>::quiet_NaN();
    }
  }

  vtkPolyData* Mesh;
  const std::vector<const pemesh::Metric*>& Metrics;
  const std::vector<double*>& Values;
  std::vector<Condition>& Conditions;
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

std::string DescribeCondition(
  const std::vector<Condition>& conditions, Condition which, const char* what)
{
  const auto count = std::count(conditions.begin(), conditions.end(), which);
  if (count == 0)
  {
    return {};
  }
  const auto first = std::find(conditions.begin(), conditions.end(), which) - conditions.begin();
  return std::to_string(count) + " of " + std::to_string(conditions.size()) + " elements " + what +
    " (the first is element " + std::to_string(first) + ")";
}

} // namespace

vtkPEMMetrics::vtkPEMMetrics()
  : Metrics(pemesh::MetricNames())
{
}

vtkPEMMetrics::~vtkPEMMetrics() = default;

void vtkPEMMetrics::SetMetrics(const std::vector<std::string>& names)
{
  const std::string problem = pemesh::WhyUnknownMetric(names);
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return;
  }
  std::vector<std::string> normalized = pemesh::NormalizeMetricNames(names);
  if (normalized != this->Metrics)
  {
    this->Metrics = std::move(normalized);
    this->Modified();
  }
}

void vtkPEMMetrics::AddMetric(const std::string& name)
{
  std::vector<std::string> names = this->Metrics;
  names.push_back(name);
  this->SetMetrics(names);
}

void vtkPEMMetrics::RemoveAllMetrics()
{
  this->SetMetrics({});
}

void vtkPEMMetrics::SelectAllMetrics()
{
  this->SetMetrics(pemesh::MetricNames());
}

std::vector<std::string> vtkPEMMetrics::GetMetrics() const
{
  return this->Metrics;
}

std::vector<std::string> vtkPEMMetrics::GetAvailableMetrics()
{
  return pemesh::MetricNames();
}

int vtkPEMMetrics::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(input);
  if (pemesh::IsCaseFailed(input))
  {
    return 1;
  }
  const std::string problem = pemesh::ElementAccess::WhyUnusable(output);
  if (!problem.empty())
  {
    pemesh::SetCaseFailed(output, "unusable-mesh", "The mesh cannot be measured: " + problem + ".");
    return 1;
  }
  const std::vector<const pemesh::Metric*> metrics = pemesh::SelectMetrics(this->Metrics);
  const vtkIdType elements = output->GetNumberOfPolys();
  std::vector<double*> values;
  for (const pemesh::Metric* metric : metrics)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(metric->Name);
    array->SetNumberOfValues(elements);
    values.push_back(array->GetPointer(0));
    output->GetCellData()->AddArray(array);
  }
  std::vector<Condition> conditions(static_cast<std::size_t>(elements), Condition::Measured);
  ElementMeasurer measurer(output, metrics, values, conditions);
  const auto measureRange = [&measurer](vtkIdType begin, vtkIdType end)
  { measurer.MeasureRange(begin, end); };
  const vtkIdType chunk = ChunkSize(output, elements);
  for (vtkIdType begin = 0; begin < elements; begin += chunk)
  {
    const vtkIdType end = std::min(begin + chunk, elements);
    pemesh::ParallelLoop(begin, end, 0, measureRange);
    if (!pemesh::ReportProgress(this, static_cast<double>(end) / static_cast<double>(elements)))
    {
      output->Initialize();
      return 1;
    }
  }
  const std::string degenerate = DescribeCondition(conditions, Condition::Degenerate,
    "cannot be measured and have NaN: fewer than three distinct vertices, no area, crossing edges "
    "or coordinates that are not finite");
  const std::string repeated =
    DescribeCondition(conditions, Condition::Repeated, "repeat a vertex, which was ignored");
  if (!degenerate.empty() || !repeated.empty())
  {
    vtkWarningMacro(<< degenerate << (degenerate.empty() || repeated.empty() ? "" : "; ")
                    << repeated << ".");
  }
  return 1;
}

void vtkPEMMetrics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Metrics:";
  for (const std::string& name : this->Metrics)
  {
    os << ' ' << name;
  }
  os << '\n';
}
