// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the smallest angle of a mesh, in radians.
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPEMMeshReader.h>
#include <vtkPEMMetrics.h>
#include <vtkPolyData.h>

#include <cstdio>

int main(int, char* arguments[])
{
  vtkNew<vtkPEMMeshReader> reader;
  reader->SetFileName(arguments[1]);
  vtkNew<vtkPEMMetrics> metrics;
  metrics->SetInputConnection(reader->GetOutputPort());
  metrics->Update();
  std::printf("%.15g\n", metrics->GetOutput()->GetCellData()->GetArray("MinAngle")->GetRange()[0]);
}
