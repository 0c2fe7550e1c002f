// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyGeneration.h"

#include "MeshConversion.h"
#include "StraightVertices.h"
#include "Study.h"
#include "StudyLayout.h"
#include "vtkPEMAgglomerate.h"
#include "vtkPEMDomain.h"
#include "vtkPEMDomainMesher.h"
#include "vtkPEMMeshReader.h"
#include "vtkPEMMirror.h"
#include "vtkPEMPolygonLayout.h"
#include "vtkPEMTessellation.h"
#include "vtkPEMTile.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace pemesh
{

void ConfigureDomain(const Study& study, vtkPEMDomain* domain)
{
  domain->SetShapeByName(study.Domain.Shape);
  for (const auto& [name, value] : study.Domain.Parameters)
  {
    domain->SetParameter(name, value);
  }
  domain->SetFileName(study.Domain.File.empty() ? "" : (study.Folder / study.Domain.File).string());
}

StudyGeneration::StudyGeneration() = default;
StudyGeneration::~StudyGeneration() = default;

std::vector<vtkAlgorithm*> StudyGeneration::GetFilters()
{
  return { this->Reader, this->Domain, this->Layout, this->Mesher, this->Tessellation, this->Tile,
    this->Mirror, this->Agglomeration };
}

vtkAlgorithm* StudyGeneration::ConfigureReader(const Study& study)
{
  if (this->Reader->GetNumberOfFileNames() == 0) // no sweep changes them, and the search takes time
  {
    for (const std::filesystem::path& path : FindStudyMeshes(study))
    {
      this->Reader->AddFileName(path.string());
    }
  }
  return this->Reader;
}

vtkAlgorithm* StudyGeneration::ConfigureMesher(const Study& study)
{
  const StudyMesh& mesh = study.Mesh;
  ConfigureDomain(study, this->Domain);
  this->Layout->SetInputConnection(this->Domain->GetOutputPort());
  try
  {
    ConfigureLayout(study, this->Layout);
  }
  catch (const std::runtime_error& error) // a file, or polygons that find no room: of this case
  {
    this->LayoutFault = error.what();
    this->Layout->RemoveAllPolygons();
  }
  this->Mesher->SetInputConnection(0, this->Layout->GetOutputPort());
  this->Mesher->SetInputConnection(1, this->Domain->GetOutputPort());
  this->Mesher->SetAreaRuleByName(mesh.MaximumArea.Rule);
  if (this->Mesher->GetAreaRule() == vtkPEMDomainMesher::AREA_CONSTANT)
  {
    this->Mesher->SetMaximumArea(mesh.MaximumArea.Value);
  }
  this->Mesher->SetMinimumAngle(mesh.MinimumAngle);
  this->Mesher->SetPreservePolygons(mesh.PreservePolygons);
  this->Mesher->SetPreserveDomain(mesh.PreserveDomain);
  this->Mesher->SetMaximumNumberOfElements(mesh.MaximumElements);
  this->Mesher->SetGradation(mesh.Gradation);
  this->Mesher->SetSizeAtPolygons(mesh.SizeAtPolygons);
  return this->Mesher;
}

void StudyGeneration::SetMaximumArea(double area)
{
  this->Mesher->SetAreaRule(vtkPEMDomainMesher::AREA_CONSTANT);
  this->Mesher->SetMaximumArea(area);
}

double StudyGeneration::GetDomainArea()
{
  this->Domain->Update();
  pemesh::Domain domain;
  return ToDomain(this->Domain->GetOutput(), domain).empty() ? DomainArea(domain) : 1.0;
}

vtkAlgorithm* StudyGeneration::ConfigureTessellation(const Study& study)
{
  ConfigureDomain(study, this->Domain);
  this->Tessellation->SetInputConnection(this->Domain->GetOutputPort());
  this->Tessellation->SetKindByName(study.Mesh.Source);
  this->Tessellation->SetMaximumNumberOfElements(study.Mesh.MaximumElements);
  for (const auto& [name, value] : study.Mesh.Parameters)
  {
    this->Tessellation->SetParameter(name, value);
  }
  return this->Tessellation;
}

vtkAlgorithm* StudyGeneration::ConfigureSource(const Study& study)
{
  if (HasMeshFiles(study))
  {
    return this->ConfigureReader(study);
  }
  return IsTriangulated(study.Mesh) ? this->ConfigureMesher(study)
                                    : this->ConfigureTessellation(study);
}

void StudyGeneration::ConfigureAgglomeration(const StudyAgglomeration& agglomeration)
{
  this->Agglomeration->SetRuleByName(agglomeration.Rule);
  for (const auto& [name, value] : agglomeration.Parameters)
  {
    this->Agglomeration->SetParameter(name, value);
  }
  this->Agglomeration->SetMetric(agglomeration.Metric);
  this->Agglomeration->SetTargetNumberOfElements(agglomeration.Elements);
  this->Agglomeration->SetTargetPercentage(agglomeration.Percentage);
  this->Agglomeration->SetKeepPolygons(agglomeration.KeepPolygons);
  const auto* mode = std::ranges::find(StraightVerticesNames, agglomeration.StraightVertices);
  this->Agglomeration->SetStraightVertices(static_cast<int>(mode - StraightVerticesNames));
}

vtkAlgorithm* StudyGeneration::Configure(const Study& study)
{
  this->LayoutFault.clear();
  vtkAlgorithm* last = this->ConfigureSource(study);
  const auto append = [&last](vtkAlgorithm* filter)
  {
    filter->SetInputConnection(last->GetOutputPort());
    last = filter;
  };
  if (study.Mesh.Tile != std::array<int, 2>{ 1, 1 })
  {
    this->Tile->SetNumberOfColumns(study.Mesh.Tile[0]);
    this->Tile->SetNumberOfRows(study.Mesh.Tile[1]);
    this->Tile->SetMaximumNumberOfElements(study.Mesh.MaximumElements);
    append(this->Tile);
  }
  if (study.Mesh.Mirror > 0)
  {
    this->Mirror->SetNumberOfTimes(study.Mesh.Mirror);
    this->Mirror->SetMaximumNumberOfElements(study.Mesh.MaximumElements);
    append(this->Mirror);
  }
  if (study.Mesh.Agglomeration.Rule != "none")
  {
    this->ConfigureAgglomeration(study.Mesh.Agglomeration);
    append(this->Agglomeration);
  }
  return last;
}

} // namespace pemesh
