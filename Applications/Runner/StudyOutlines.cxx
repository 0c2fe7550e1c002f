// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyOutlines.h"

#include "CaseStatus.h"
#include "ElementAccess.h"
#include "Study.h"
#include "StudyGeneration.h"
#include "StudyLayout.h"
#include "vtkPEMDomain.h"
#include "vtkPEMPolygonLayout.h"

#include <stdexcept>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

void ReadLoops(vtkPolyData* data, std::vector<std::vector<Point2>>& loops)
{
  ElementAccess elements(data);
  loops.resize(static_cast<std::size_t>(elements.GetNumberOfElements()));
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    elements.GetVertices(static_cast<vtkIdType>(i), loops[i]);
  }
}

void ReadPolygons(vtkPEMPolygonLayout* layout, StudyOutlines& outlines)
{
  std::vector<std::vector<Point2>> loops;
  ReadLoops(layout->GetOutput(), loops);
  vtkDataArray* families = layout->GetOutput()->GetCellData()->GetArray("ElementFamily");
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    outlines.Polygons.push_back({ std::move(loops[i]),
      families ? static_cast<int>(families->GetTuple1(static_cast<vtkIdType>(i))) : 0,
      layout->GetPolygonName(static_cast<int>(i)) });
  }
}

} // namespace

StudyOutlines MakeStudyOutlines(const Study& study, double t)
{
  StudyOutlines outlines;
  if (HasMeshFiles(study))
  {
    return outlines;
  }
  vtkNew<vtkPEMDomain> domain;
  ConfigureDomain(study, domain);
  domain->Update();
  if (IsCaseFailed(domain->GetOutput()))
  {
    outlines.Fault = GetCaseStatusMessage(domain->GetOutput());
    return outlines;
  }
  ReadLoops(domain->GetOutput(), outlines.Domain);
  if (!IsTriangulated(study.Mesh))
  {
    return outlines;
  }
  try
  {
    vtkNew<vtkPEMPolygonLayout> layout;
    layout->SetInputConnection(domain->GetOutputPort());
    ConfigureLayout(study, layout);
    if (layout->GetNumberOfPolygons() > 0)
    {
      layout->UpdateTimeStep(t);
      ReadPolygons(layout, outlines);
      outlines.Fault = layout->FindFault(t);
    }
  }
  catch (const std::exception& error)
  {
    outlines.Fault = error.what();
  }
  return outlines;
}

} // namespace pemesh
