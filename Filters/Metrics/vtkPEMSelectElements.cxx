// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMSelectElements.h"

#include "CaseStatus.h"
#include "ElementAccess.h"
#include "ElementSelection.h"
#include "ExtremeElements.h"
#include "MetricRegistry.h"
#include "Progress.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkPEMSelectElements);

namespace
{

/** The first `count` of the elements, the smallest (largest) values first. */
void KeepExtreme(std::vector<vtkIdType>& elements, const std::vector<double>& values, bool largest,
  vtkIdType count)
{
  const auto comesFirst = [&](vtkIdType a, vtkIdType b)
  {
    const double x = values[static_cast<std::size_t>(a)];
    const double y = values[static_cast<std::size_t>(b)];
    return x != y ? (x < y) != largest : a < b;
  };
  if (count < static_cast<vtkIdType>(elements.size()))
  {
    std::nth_element(elements.begin(), elements.begin() + count, elements.end(), comesFirst);
    elements.resize(static_cast<std::size_t>(count));
    std::sort(elements.begin(), elements.end());
  }
}

void NumberArray(vtkDataSetAttributes* data, const char* name, const std::vector<vtkIdType>& ids)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), array->GetPointer(0));
  data->AddArray(array);
}

/** The values of the elements or points `ids`, in their order. */
void CopyArrays(
  vtkDataSetAttributes* from, const std::vector<vtkIdType>& ids, vtkDataSetAttributes* to)
{
  to->CopyAllOn();
  to->CopyAllocate(from, static_cast<vtkIdType>(ids.size()));
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    to->CopyData(from, ids[i], static_cast<vtkIdType>(i));
  }
}

void CopyElements(vtkPolyData* mesh, const std::vector<vtkIdType>& elements, vtkPolyData* output)
{
  pemesh::ElementAccess access(mesh);
  std::vector<vtkIdType> number(static_cast<std::size_t>(mesh->GetNumberOfPoints()), -1);
  std::vector<vtkIdType> vertices;
  std::vector<vtkIdType> used;
  vtkNew<vtkCellArray> polygons;
  for (const vtkIdType element : elements)
  {
    access.GetVertexIds(element, vertices);
    for (vtkIdType& vertex : vertices)
    {
      vtkIdType& mine = number[static_cast<std::size_t>(vertex)];
      if (mine < 0)
      {
        mine = static_cast<vtkIdType>(used.size());
        used.push_back(vertex);
      }
      vertex = mine;
    }
    polygons->InsertNextCell(static_cast<vtkIdType>(vertices.size()), vertices.data());
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(used.size()));
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), mesh->GetPoint(used[i]));
  }
  output->SetPoints(points);
  output->SetPolys(polygons);
  CopyArrays(mesh->GetCellData(), elements, output->GetCellData());
  CopyArrays(mesh->GetPointData(), used, output->GetPointData());
  NumberArray(output->GetCellData(), "OriginalElement", elements);
  NumberArray(output->GetPointData(), "OriginalVertex", used);
  output->GetFieldData()->PassData(mesh->GetFieldData());
}

/** The first elements of the smallest and of the largest value, which may be one, with a mark. */
void CopyExtremes(vtkPolyData* mesh, vtkDataArray* values, vtkPolyData* output)
{
  const auto [smallest, largest] = pemesh::FindExtremeElements(values);
  std::vector<vtkIdType> extremes;
  vtkNew<vtkIntArray> marks;
  marks->SetName("Extreme");
  if (smallest >= 0)
  {
    extremes = { std::min(smallest, largest), std::max(smallest, largest) };
    extremes.resize(smallest == largest ? 1 : 2);
  }
  for (const vtkIdType element : extremes)
  {
    marks->InsertNextValue(
      static_cast<int>(element == largest) - static_cast<int>(element == smallest));
  }
  CopyElements(mesh, extremes, output);
  output->GetCellData()->AddArray(marks);
}

/** Those that are not in a sorted list, of the first `count`. */
std::vector<vtkIdType> OthersThan(const std::vector<vtkIdType>& selected, vtkIdType count)
{
  std::vector<vtkIdType> others;
  for (vtkIdType element = 0; element < count; ++element)
  {
    if (!std::binary_search(selected.begin(), selected.end(), element))
    {
      others.push_back(element);
    }
  }
  return others;
}

} // namespace

vtkPEMSelectElements::vtkPEMSelectElements()
{
  this->SetNumberOfOutputPorts(3);
}

vtkPEMSelectElements::~vtkPEMSelectElements() = default;

void vtkPEMSelectElements::SetMetric(const std::string& name)
{
  if (name != this->Metric)
  {
    this->Metric = name;
    this->Modified();
  }
}

void vtkPEMSelectElements::SetSelection(const std::string& text)
{
  std::string fault;
  const pemesh::ElementSelection selection = pemesh::ParseElementSelection(text, fault);
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault);
    return;
  }
  this->SetMetric(selection.Array);
  this->SetMode(selection.HasRange ? Range : NotZero);
  this->SetMinimum(selection.Minimum);
  this->SetMaximum(selection.Maximum);
}

/** The mode, with Worst turned into the end that is bad, where that is known. */
int vtkPEMSelectElements::GetEffectiveMode() const
{
  const pemesh::Metric* metric = pemesh::FindMetric(this->Metric);
  if (this->Mode != Worst || !metric || metric->Good == 0)
  {
    return this->Mode;
  }
  return metric->Good > 0 ? Smallest : Largest;
}

std::vector<vtkIdType> vtkPEMSelectElements::Select(
  const std::vector<double>& values, int mode) const
{
  const bool hasRule = mode == Range || mode == NotZero;
  const pemesh::ElementSelection rule{ this->Metric, mode == Range, this->Minimum, this->Maximum };
  std::vector<vtkIdType> selected;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (hasRule ? rule.Contains(values[i]) : std::isfinite(values[i]))
    {
      selected.push_back(static_cast<vtkIdType>(i));
    }
  }
  if (!hasRule)
  {
    KeepExtreme(selected, values, mode == Largest, this->Count);
  }
  return selected;
}

int vtkPEMSelectElements::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, SelectedPort);
  const int mode = this->GetEffectiveMode();
  if (mode == Worst)
  {
    vtkErrorMacro(<< "The worst elements by " << this->Metric
                  << " are not known: it is no metric of which one end is good. Choose the "
                     "smallest or the largest.");
    return 0;
  }
  output->ShallowCopy(input);
  if (pemesh::IsCaseFailed(input))
  {
    return 1;
  }
  vtkDataArray* array = input->GetCellData()->GetArray(this->Metric.c_str());
  if (!array || array->GetNumberOfComponents() != 1 ||
    !pemesh::ElementAccess::WhyUnusable(input).empty())
  {
    pemesh::SetCaseFailed(output, "no-such-array",
      "The mesh has no values of " + this->Metric + " to select by: measure it first.");
    return 1;
  }
  std::vector<double> values(static_cast<std::size_t>(input->GetNumberOfPolys()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  const std::vector<vtkIdType> selected = this->Select(values, mode);
  output->Initialize();
  CopyElements(input, selected, output);
  if (pemesh::ReportProgress(this, 0.4))
  {
    CopyElements(input, OthersThan(selected, input->GetNumberOfPolys()),
      vtkPolyData::GetData(outputVector, OtherPort));
  }
  if (pemesh::ReportProgress(this, 0.8))
  {
    CopyExtremes(input, array, vtkPolyData::GetData(outputVector, ExtremePort));
  }
  pemesh::ReportProgress(this, 1.0);
  return 1;
}

void vtkPEMSelectElements::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Metric: " << this->Metric << '\n';
  os << indent << "Mode: " << this->Mode << '\n';
  os << indent << "Minimum: " << this->Minimum << '\n';
  os << indent << "Maximum: " << this->Maximum << '\n';
  os << indent << "Count: " << this->Count << '\n';
}
