// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMMetricSummary.h"

#include "CaseStatus.h"
#include "ElementAccess.h"
#include "MetricSelection.h"
#include "PointDistances.h"
#include "Progress.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkPEMMetricSummary);

namespace
{

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

void AddNumber(vtkTable* table, const std::string& name, double value)
{
  vtkNew<vtkDoubleArray> column;
  column->SetName(name.c_str());
  column->InsertNextValue(value);
  table->AddColumn(column);
}

void AddId(vtkTable* table, const std::string& name, vtkIdType value)
{
  vtkNew<vtkIdTypeArray> column;
  column->SetName(name.c_str());
  column->InsertNextValue(value);
  table->AddColumn(column);
}

void AddText(vtkTable* table, const std::string& name, const std::string& value)
{
  vtkNew<vtkStringArray> column;
  column->SetName(name.c_str());
  column->InsertNextValue(value);
  table->AddColumn(column);
}

/** Largest diameter of an element; NaN where there is none. */
double MeasureMeshSize(vtkPolyData* mesh)
{
  if (!pemesh::ElementAccess::WhyUnusable(mesh).empty())
  {
    return NotANumber;
  }
  pemesh::ElementAccess access(mesh);
  std::vector<pemesh::Point2> vertices;
  double size = NotANumber;
  for (vtkIdType element = 0; element < access.GetNumberOfElements(); ++element)
  {
    access.GetVertices(element, vertices);
    const double diameter = pemesh::Diameter(vertices);
    if (std::isfinite(diameter) && !(diameter <= size))
    {
      size = diameter;
    }
  }
  return size;
}

struct Extremes
{
  double Minimum = NotANumber;
  double Maximum = NotANumber;
  double Mean = NotANumber;
  vtkIdType MinimumElement = -1;
  vtkIdType MaximumElement = -1;
};

/** Over the finite values; of several extreme elements the first. */
Extremes Summarize(vtkDataArray* values)
{
  Extremes extremes;
  double sum = 0.0;
  double error = 0.0; // A. Neumaier's compensation, Z. Angew. Math. Mech. 54 (1974) 39-51
  vtkIdType count = 0;
  for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    if (!std::isfinite(value))
    {
      continue;
    }
    if (extremes.MinimumElement < 0 || value < extremes.Minimum)
    {
      extremes.Minimum = value;
      extremes.MinimumElement = i;
    }
    if (extremes.MaximumElement < 0 || value > extremes.Maximum)
    {
      extremes.Maximum = value;
      extremes.MaximumElement = i;
    }
    const double next = sum + value;
    error += std::abs(sum) >= std::abs(value) ? (sum - next) + value : (value - next) + sum;
    sum = next;
    ++count;
  }
  if (count > 0)
  {
    extremes.Mean = (sum + error) / static_cast<double>(count);
  }
  return extremes;
}

void AddMetricColumns(vtkTable* table, vtkPolyData* mesh, const pemesh::Metric& metric)
{
  vtkDataArray* values = mesh->GetCellData()->GetArray(metric.Name);
  const Extremes extremes = Summarize(values);
  const std::string name = metric.Name;
  AddNumber(table, name + "_min", extremes.Minimum);
  AddNumber(table, name + "_max", extremes.Maximum);
  AddNumber(table, name + "_mean", extremes.Mean);
  AddId(table, name + "_min_element", extremes.MinimumElement);
  AddId(table, name + "_max_element", extremes.MaximumElement);
}

/** A field value of the mesh as a column, a number or a text; NaN where there is none. */
void AddFieldColumn(vtkTable* table, vtkPolyData* mesh, const std::string& name)
{
  if (vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(name.c_str())))
  {
    AddText(table, name, pemesh::GetFieldText(mesh, name));
  }
  else
  {
    AddNumber(table, name, pemesh::GetFieldNumber(mesh, name));
  }
}

void AddParameterColumns(vtkTable* table, vtkPolyData* mesh)
{
  auto* names =
    vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(pemesh::ParametersList));
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
  {
    if (!table->GetColumnByName(names->GetValue(i).c_str()))
    {
      AddFieldColumn(table, mesh, names->GetValue(i));
    }
  }
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/** Provenance and performances: numbers, and what the runs say of themselves. */
void AddOtherFieldColumns(vtkTable* table, vtkPolyData* mesh)
{
  vtkFieldData* fields = mesh->GetFieldData();
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = fields->GetAbstractArray(i);
    if (!array->GetName() || array->GetNumberOfValues() != 1 ||
      table->GetColumnByName(array->GetName()))
    {
      continue;
    }
    const std::string name = array->GetName();
    if (vtkDataArray::SafeDownCast(array) || EndsWith(name, "_Status") ||
      EndsWith(name, "_StatusMessage"))
    {
      AddFieldColumn(table, mesh, name);
    }
  }
}

void CopyList(vtkTable* table, vtkPolyData* mesh, const char* list)
{
  if (vtkAbstractArray* names = mesh->GetFieldData()->GetAbstractArray(list))
  {
    table->GetFieldData()->AddArray(names);
  }
}

} // namespace

vtkPEMMetricSummary::vtkPEMMetricSummary()
  : Metrics(pemesh::MetricNames())
{
}

vtkPEMMetricSummary::~vtkPEMMetricSummary() = default;

void vtkPEMMetricSummary::SetMetrics(const std::vector<std::string>& names)
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

void vtkPEMMetricSummary::AddMetric(const std::string& name)
{
  std::vector<std::string> names = this->Metrics;
  names.push_back(name);
  this->SetMetrics(names);
}

void vtkPEMMetricSummary::RemoveAllMetrics()
{
  this->SetMetrics({});
}

void vtkPEMMetricSummary::SelectAllMetrics()
{
  this->SetMetrics(pemesh::MetricNames());
}

std::vector<std::string> vtkPEMMetricSummary::GetMetrics() const
{
  return this->Metrics;
}

int vtkPEMMetricSummary::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkPEMMetricSummary::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputVector[0]);
  vtkTable* table = vtkTable::GetData(outputVector);
  AddText(table, pemesh::MeshNameField, pemesh::GetFieldText(mesh, pemesh::MeshNameField));
  AddParameterColumns(table, mesh);
  AddId(table, "Elements", mesh->GetNumberOfPolys());
  AddId(table, "Vertices", mesh->GetNumberOfPoints());
  AddNumber(table, "MeshSize", MeasureMeshSize(mesh));
  pemesh::ReportProgress(this, 0.5);
  for (const pemesh::Metric* metric : pemesh::SelectMetrics(this->Metrics))
  {
    AddMetricColumns(table, mesh, *metric);
  }
  AddOtherFieldColumns(table, mesh);
  AddText(table, "Status", pemesh::GetCaseStatus(mesh));
  AddText(table, "StatusMessage", pemesh::GetCaseStatusMessage(mesh));
  CopyList(table, mesh, pemesh::ParametersList);
  CopyList(table, mesh, pemesh::MeasuredList);
  return 1;
}

void vtkPEMMetricSummary::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Metrics:";
  for (const std::string& name : this->Metrics)
  {
    os << ' ' << name;
  }
  os << '\n';
}
