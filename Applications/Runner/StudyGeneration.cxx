// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyGeneration.h"

#include "Study.h"
#include "vtkPEMDomain.h"
#include "vtkPEMDomainMesher.h"
#include "vtkPEMMeshReader.h"
#include "vtkPEMPolygonLayout.h"

namespace pemesh
{

namespace
{

void ConfigureLayout(const Study& study, vtkPEMPolygonLayout* layout)
{
  layout->RemoveAllPolygons();
  for (const StudyPolygon& polygon : study.Polygons)
  {
    const int index = layout->AddPolygon(polygon.Family, polygon.Center[0], polygon.Center[1]);
    layout->SetPolygonScale(index, polygon.Scale);
    layout->SetPolygonRotation(index, polygon.Rotation);
    layout->SetPolygonRange(index, polygon.From, polygon.To);
    if (polygon.Count > 0)
    {
      layout->SetPolygonCount(index, polygon.Count);
    }
    if (!polygon.Name.empty())
    {
      layout->SetPolygonName(index, polygon.Name);
    }
  }
}

} // namespace

StudyGeneration::StudyGeneration() = default;
StudyGeneration::~StudyGeneration() = default;

std::vector<vtkAlgorithm*> StudyGeneration::GetFilters()
{
  return { this->Reader, this->Domain, this->Layout, this->Mesher };
}

vtkAlgorithm* StudyGeneration::ConfigureReader(const Study& study)
{
  std::vector<std::string> files;
  for (const std::filesystem::path& path : FindStudyMeshes(study))
  {
    files.push_back(path.string());
  }
  this->Reader->SetFileNames(files);
  return this->Reader;
}

void StudyGeneration::ConfigureDomain(const Study& study)
{
  this->Domain->SetShapeByName(study.Domain.Shape);
  for (const auto& [name, value] : study.Domain.Parameters)
  {
    this->Domain->SetParameter(name, value);
  }
  this->Domain->SetFileName(
    study.Domain.File.empty() ? "" : (study.Folder / study.Domain.File).string());
}

vtkAlgorithm* StudyGeneration::ConfigureMesher(const Study& study)
{
  const StudyMesh& mesh = study.Mesh;
  ConfigureLayout(study, this->Layout);
  this->ConfigureDomain(study);
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
  return this->Mesher;
}

vtkAlgorithm* StudyGeneration::Configure(const Study& study)
{
  return HasMeshFiles(study) ? this->ConfigureReader(study) : this->ConfigureMesher(study);
}

} // namespace pemesh
