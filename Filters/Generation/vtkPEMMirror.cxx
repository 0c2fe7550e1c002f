// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMMirror.h"

#include "Progress.h"
#include "RepeatFilter.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkPEMMirror);

int vtkPEMMirror::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  pemesh::RepeatRequest repeat;
  repeat.FailureStatus = "not-mirrorable";
  repeat.Times = this->NumberOfTimes;
  repeat.CopiesEachTime = 4.0;
  repeat.Repetition = pemesh::MirrorOnce;
  repeat.MaximumNumberOfElements = this->MaximumNumberOfElements;
  repeat.Progress = [this](double fraction) { return pemesh::ReportProgress(this, fraction); };
  pemesh::RepeatPolyData(
    vtkPolyData::GetData(inputVector[0]), repeat, vtkPolyData::GetData(outputVector));
  return 1;
}

void vtkPEMMirror::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfTimes: " << this->NumberOfTimes << "\n";
  os << indent << "MaximumNumberOfElements: " << this->MaximumNumberOfElements << "\n";
}
