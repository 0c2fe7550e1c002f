// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMDomain.h"

#include "CaseStatus.h"
#include "DomainShapes.h"
#include "MeshConversion.h"
#include "NumberText.h"
#include "PolygonFile.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkPEMDomain);

namespace
{

constexpr const char* FileShape = "file";

void AddLoop(const std::vector<pemesh::Point2>& loop, pemesh::PolygonMesh& mesh)
{
  for (const pemesh::Point2& point : loop)
  {
    mesh.Vertices.push_back(static_cast<int>(mesh.Points.size()));
    mesh.Points.push_back(point);
  }
  mesh.Offsets.push_back(mesh.NumberOfSides());
}

} // namespace

vtkPEMDomain::vtkPEMDomain()
{
  this->SetNumberOfInputPorts(0);
  const pemesh::DomainShape& shape = pemesh::DomainShapes().front();
  this->ShapeName = shape.Name;
  this->Values = pemesh::ParameterValues(shape.Parameters);
}

void vtkPEMDomain::SetShapeByName(const std::string& name)
{
  if (name == this->ShapeName)
  {
    return;
  }
  const pemesh::DomainShape* shape = pemesh::FindDomainShape(name);
  if (!shape && name != FileShape)
  {
    std::vector<std::string> names = { FileShape };
    for (const pemesh::DomainShape& known : pemesh::DomainShapes())
    {
      names.emplace_back(known.Name);
    }
    vtkErrorMacro(<< "There is no shape of domains \"" << name << "\"; did you mean \""
                  << pemesh::NearestWord(name, names) << "\"?");
    return;
  }
  this->ShapeName = name;
  this->Values = shape ? pemesh::ParameterValues(shape->Parameters) : pemesh::ParameterValues();
  this->Modified();
}

std::string vtkPEMDomain::GetShapeName() const
{
  return this->ShapeName;
}

void vtkPEMDomain::SetParameter(const std::string& name, double value)
{
  if (value == this->Values.Get(name))
  {
    return;
  }
  const std::string why = this->Values.Set(name, value);
  if (!why.empty())
  {
    vtkErrorMacro(<< "Domain of shape " << this->ShapeName << ": " << why);
    return;
  }
  this->Modified();
}

double vtkPEMDomain::GetParameter(const std::string& name) const
{
  return this->Values.Get(name);
}

void vtkPEMDomain::SetFileName(const std::string& path)
{
  if (path != this->FileName)
  {
    this->FileName = path;
    this->Modified();
  }
}

std::string vtkPEMDomain::FindDomain(pemesh::Domain& domain) const
{
  if (const pemesh::DomainShape* shape = pemesh::FindDomainShape(this->ShapeName))
  {
    domain = shape->Make(this->Values);
    return {};
  }
  if (this->FileName.empty())
  {
    return "The domain is to come from a file, but no file was named.";
  }
  try
  {
    const std::string why = pemesh::MakeDomain(pemesh::ReadPolygonFile(this->FileName), domain);
    return why.empty() ? why : this->FileName + ": " + why;
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
}

int vtkPEMDomain::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  pemesh::Domain domain;
  const std::string why = this->FindDomain(domain);
  if (!why.empty())
  {
    pemesh::SetCaseFailed(output, "invalid-domain", why);
    return 1;
  }
  pemesh::PolygonMesh loops;
  AddLoop(domain.Outer, loops);
  for (const std::vector<pemesh::Point2>& hole : domain.Holes)
  {
    AddLoop(hole, loops);
  }
  pemesh::SetPolygonMesh(output, loops);
  return 1;
}

void vtkPEMDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shape: " << this->ShapeName << "\n";
  for (const pemesh::Parameter& parameter : this->Values.GetParameters())
  {
    os << indent << parameter.Name << ": " << this->Values.Get(parameter.Name) << "\n";
  }
  os << indent << "FileName: " << this->FileName << "\n";
}
