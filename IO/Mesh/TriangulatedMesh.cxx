// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TriangulatedMesh.h"

#include "CutElements.h"

#include <span>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

void CopyElementArrays(vtkCellData* from, vtkIdTypeArray* elements, vtkCellData* to)
{
  to->CopyAllOn();
  to->CopyAllocate(from, elements->GetNumberOfValues());
  for (vtkIdType i = 0; i < elements->GetNumberOfValues(); ++i)
  {
    to->CopyData(from, elements->GetValue(i), i);
  }
  to->RemoveArray(OriginalElementArray); // of an earlier selection
  to->AddArray(elements);
}

} // namespace

vtkSmartPointer<vtkPolyData> TriangulateMesh(vtkPolyData* mesh)
{
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdTypeArray> elements;
  elements->SetName(OriginalElementArray);
  constexpr int corners = 3;
  ForEachCutElement(mesh, corners,
    [&](vtkIdType element, std::span<const vtkIdType> ids)
    {
      triangles->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
      elements->InsertNextValue(element);
    });
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(mesh->GetPoints());
  result->SetPolys(triangles);
  result->GetPointData()->PassData(mesh->GetPointData());
  result->GetFieldData()->PassData(mesh->GetFieldData());
  CopyElementArrays(mesh->GetCellData(), elements, result->GetCellData());
  return result;
}

} // namespace pemesh
