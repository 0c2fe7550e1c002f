// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshValues.h"

#include "ElementAccess.h"
#include "MeshSurroundings.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkPolyData.h>

#include <stdexcept>

namespace pemesh
{

MeshValues::MeshValues(vtkPolyData* mesh)
  : Mesh(mesh)
  , IsUsable(ElementAccess::WhyUnusable(mesh).empty())
  , Measurer(mesh)
{
}

void MeshValues::Provide(const std::vector<std::string>& metrics)
{
  const auto elements = static_cast<std::size_t>(this->Mesh->GetNumberOfPolys());
  std::vector<MetricColumn> columns;
  for (const std::string& name : metrics)
  {
    vtkDataArray* array = this->Mesh->GetCellData()->GetArray(name.c_str());
    if (array &&
      (array->GetNumberOfComponents() != 1 ||
        static_cast<std::size_t>(array->GetNumberOfTuples()) != elements))
    {
      array = nullptr; // no value an element
    }
    if (!this->Get(name).empty() || (!array && (!this->IsUsable || !FindMetric(name))))
    {
      continue;
    }
    std::vector<double>& values = this->Measured[name];
    values.resize(elements);
    if (array)
    {
      for (std::size_t i = 0; i < elements; ++i)
      {
        values[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
      }
    }
    else
    {
      columns.push_back({ FindMetric(name), values.data() });
    }
  }
  if (!columns.empty())
  {
    this->Measurer.Measure(columns, [](double) { return true; });
  }
}

std::span<const double> MeshValues::Get(const std::string& metric) const
{
  auto* array = vtkDoubleArray::SafeDownCast(this->Mesh->GetCellData()->GetArray(metric.c_str()));
  if (array && array->GetNumberOfComponents() == 1 &&
    array->GetNumberOfTuples() == this->Mesh->GetNumberOfPolys())
  {
    return { array->GetPointer(0), static_cast<std::size_t>(array->GetNumberOfTuples()) };
  }
  const auto measured = this->Measured.find(metric);
  return measured == this->Measured.end() ? std::span<const double>{} : measured->second;
}

const MeshNeighbours* MeshValues::GetNeighbours()
{
  if (!this->IsUsable)
  {
    return nullptr;
  }
  try
  {
    return &this->Measurer.GetNeighbours();
  }
  catch (const std::length_error&)
  {
    return nullptr; // too large for them
  }
}

} // namespace pemesh
