// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMTriangulate.h"

#include "CaseStatus.h"
#include "ElementAccess.h"
#include "TriangulatedMesh.h"

#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkPEMTriangulate);

int vtkPEMTriangulate::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (pemesh::IsCaseFailed(input))
  {
    output->ShallowCopy(input);
    return 1;
  }
  const std::string why = pemesh::ElementAccess::WhyUnusable(input);
  if (!why.empty())
  {
    output->GetFieldData()->PassData(input->GetFieldData());
    pemesh::SetCaseFailed(output, "unusable-mesh", "The mesh cannot be triangulated: " + why + ".");
    return 1;
  }
  output->ShallowCopy(pemesh::TriangulateMesh(input));
  return 1;
}

void vtkPEMTriangulate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
