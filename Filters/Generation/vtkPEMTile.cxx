// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMTile.h"

#include "Progress.h"
#include "RepeatFilter.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkPEMTile);

int vtkPEMTile::RequestData(vtkInformation* vtkNotUsed(request), vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  pemesh::RepeatRequest repeat;
  repeat.FailureStatus = "not-tileable";
  repeat.Times = 1;
  repeat.CopiesEachTime = static_cast<double>(this->NumberOfColumns) * this->NumberOfRows;
  repeat.Repetition = [this](const pemesh::MeshBox& box)
  { return pemesh::TileBox(box, this->NumberOfColumns, this->NumberOfRows); };
  repeat.MaximumNumberOfElements = this->MaximumNumberOfElements;
  repeat.Progress = [this](double fraction) { return pemesh::ReportProgress(this, fraction); };
  pemesh::RepeatPolyData(
    vtkPolyData::GetData(inputVector[0]), repeat, vtkPolyData::GetData(outputVector));
  return 1;
}

void vtkPEMTile::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfColumns: " << this->NumberOfColumns << "\n";
  os << indent << "NumberOfRows: " << this->NumberOfRows << "\n";
  os << indent << "MaximumNumberOfElements: " << this->MaximumNumberOfElements << "\n";
}
