// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMDomainMesher.h"

#include "AreaRules.h"
#include "CaseStatus.h"
#include "Domain.h"
#include "DomainMesh.h"
#include "ElementAccess.h"
#include "LayoutValidity.h"
#include "MeshConversion.h"
#include "NumberText.h"
#include "PolygonMeasures.h"
#include "Progress.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkPEMDomainMesher);

namespace
{

constexpr const char* PolygonNameArray = "PolygonName";
constexpr int Filler = -1;
constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

/** What the mesher takes from its input. */
struct Layout
{
  std::vector<pemesh::PlacedPolygon> Polygons; ///< as given
  std::vector<int> Ids;
  std::vector<int> Families;
};

int CellNumber(vtkPolyData* input, const char* name, vtkIdType cell, int otherwise)
{
  vtkDataArray* array = input->GetCellData()->GetArray(name);
  return array ? static_cast<int>(array->GetTuple1(cell)) : otherwise;
}

/** Empty if all is well, else one sentence on what cannot be meshed. */
std::string ReadLayout(vtkPolyData* input, const pemesh::Domain& domain, Layout& layout)
{
  if (input->GetNumberOfCells() == 0)
  {
    return {};
  }
  const std::string unusable = pemesh::ElementAccess::WhyUnusable(input);
  if (!unusable.empty())
  {
    return "The layout cannot be used: " + unusable + ".";
  }
  auto* names =
    vtkStringArray::SafeDownCast(input->GetCellData()->GetAbstractArray(PolygonNameArray));
  pemesh::ElementAccess access(input);
  for (vtkIdType cell = 0; cell < access.GetNumberOfElements(); ++cell)
  {
    pemesh::PlacedPolygon polygon;
    polygon.Name =
      names ? std::string(names->GetValue(cell)) : "polygon " + std::to_string(cell + 1);
    access.GetVertices(cell, polygon.Vertices);
    layout.Polygons.push_back(std::move(polygon));
    layout.Ids.push_back(CellNumber(input, pemesh::PolygonIdArray, cell, static_cast<int>(cell)));
    layout.Families.push_back(CellNumber(input, pemesh::ElementFamilyArray, cell, Filler));
  }
  return pemesh::FindLayoutFault(layout.Polygons, domain, pemesh::GetFieldNumber(input, "t"));
}

/** The polygons, turned round where they are clockwise (their first vertex stays the first). */
std::vector<std::vector<pemesh::Point2>> CounterClockwisePolygons(const Layout& layout)
{
  std::vector<std::vector<pemesh::Point2>> polygons;
  for (const pemesh::PlacedPolygon& polygon : layout.Polygons)
  {
    polygons.push_back(polygon.Vertices);
    if (pemesh::PolygonOrientation(polygon.Vertices) < 0)
    {
      std::reverse(polygons.back().begin() + 1, polygons.back().end());
    }
  }
  return polygons;
}

/** The word of the status for what became of a mesh. */
const char* StatusWord(pemesh::DomainMeshStatus status)
{
  return status == pemesh::DomainMeshStatus::TargetNotReached ? "target-not-reached"
                                                              : "meshing-failed";
}

pemesh::DomainMesh MeshOrExplain(const pemesh::Domain& domain,
  const std::vector<std::vector<pemesh::Point2>>& polygons,
  const pemesh::DomainMeshOptions& options, int target)
{
  try
  {
    return target > 0 ? pemesh::MeshDomainToCount(domain, polygons, options, target)
                      : pemesh::MeshDomain(domain, polygons, options);
  }
  catch (const std::exception& error) // also of CGAL, and of memory that is not there
  {
    pemesh::DomainMesh mesh;
    mesh.MaximumArea = options.MaximumArea;
    mesh.Message = std::string("The domain could not be meshed: ") + error.what();
    return mesh;
  }
}

vtkSmartPointer<vtkIntArray> ElementNumbers(
  const char* name, const std::vector<int>& ofPolygons, vtkIdType numberOfElements)
{
  auto numbers = vtkSmartPointer<vtkIntArray>::New();
  numbers->SetName(name);
  numbers->SetNumberOfValues(numberOfElements);
  numbers->FillValue(Filler);
  std::copy(ofPolygons.begin(), ofPolygons.end(), numbers->GetPointer(0));
  return numbers;
}

void WriteMesh(const pemesh::PolygonMesh& mesh, const Layout& layout, vtkPolyData* output)
{
  pemesh::SetPolygonMesh(output, mesh);
  const vtkIdType count = mesh.NumberOfElements();
  output->GetCellData()->AddArray(
    ElementNumbers(pemesh::ElementFamilyArray, layout.Families, count));
  output->GetCellData()->AddArray(ElementNumbers(pemesh::PolygonIdArray, layout.Ids, count));
}

void WriteOutcome(const pemesh::DomainMesh& mesh, const Layout& layout, vtkPolyData* output)
{
  const bool isDone = mesh.Status == pemesh::DomainMeshStatus::Done;
  pemesh::SetFieldNumber(
    output, "MaximumArea", std::isfinite(mesh.MaximumArea) ? mesh.MaximumArea : Undefined);
  pemesh::SetFieldNumber(
    output, "AttainedMinimumAngle", isDone ? mesh.AttainedMinimumAngle : Undefined);
  if (isDone)
  {
    WriteMesh(mesh.Elements, layout, output);
  }
  else
  {
    pemesh::SetCaseFailed(output, StatusWord(mesh.Status), mesh.Message);
  }
}

} // namespace

vtkPEMDomainMesher::vtkPEMDomainMesher()
{
  this->SetNumberOfInputPorts(2);
}

int vtkPEMDomainMesher::FillInputPortInformation(int port, vtkInformation* information)
{
  if (port == 1)
  {
    information->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, information);
}

void vtkPEMDomainMesher::SetAreaRuleByName(const std::string& name)
{
  const int rule = pemesh::FindAreaRule(name);
  if (rule >= 0)
  {
    this->SetAreaRule(rule);
    return;
  }
  std::vector<std::string> names;
  for (const pemesh::AreaRule& candidate : pemesh::AreaRules())
  {
    names.emplace_back(candidate.Name);
  }
  vtkErrorMacro(<< "There is no area rule \"" << name << "\"; did you mean \""
                << pemesh::NearestWord(name, names) << "\"?");
}

std::string vtkPEMDomainMesher::GetAreaRuleName() const
{
  return pemesh::AreaRules()[this->AreaRule].Name;
}

std::string vtkPEMDomainMesher::WhyMisconfigured() const
{
  if (std::isnan(this->MinimumAngle))
  {
    return "MinimumAngle is not a number, expected 0 to 33 degrees.";
  }
  for (const auto& [name, value] :
    { std::pair("Gradation", this->Gradation), { "SizeAtPolygons", this->SizeAtPolygons } })
  {
    if (!(value >= 0.0 && std::isfinite(value)))
    {
      return std::string(name) + " is " + pemesh::FormatNumber(value) + ", expected 0 or more.";
    }
  }
  if (this->AreaRule == AREA_CONSTANT && !(this->MaximumArea > 0.0))
  {
    return "MaximumArea is " + pemesh::FormatNumber(this->MaximumArea) + ", expected more than 0.";
  }
  return {};
}

pemesh::DomainMeshOptions vtkPEMDomainMesher::MakeOptions(
  const std::vector<std::vector<pemesh::Point2>>& polygons)
{
  pemesh::DomainMeshOptions options;
  options.MinimumAngle = this->MinimumAngle;
  options.MaximumArea = pemesh::AreaRules()[this->AreaRule].MaximumArea(
    { polygons, this->MinimumAngle, this->MaximumArea });
  options.Gradation = this->Gradation;
  options.SizeAtPolygons = this->SizeAtPolygons;
  options.PreservePolygons = this->PreservePolygons;
  options.PreserveDomain = this->PreserveDomain;
  options.MaximumElements = static_cast<int>(this->MaximumNumberOfElements);
  options.Progress = [this](double fraction) { return pemesh::ReportProgress(this, fraction); };
  return options;
}

int vtkPEMDomainMesher::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const std::string misconfigured = this->WhyMisconfigured();
  if (!misconfigured.empty())
  {
    vtkErrorMacro(<< misconfigured);
    return 0;
  }
  if (pemesh::IsCaseFailed(input))
  {
    output->ShallowCopy(input);
    return 1;
  }
  output->GetFieldData()->PassData(input->GetFieldData());
  vtkPolyData* domainInput = vtkPolyData::GetData(inputVector[1]);
  if (domainInput && pemesh::IsCaseFailed(domainInput))
  {
    pemesh::SetCaseFailed(
      output, pemesh::GetCaseStatus(domainInput), pemesh::GetCaseStatusMessage(domainInput));
    return 1;
  }
  pemesh::Domain domain;
  const std::string noDomain = pemesh::ToDomain(domainInput, domain);
  if (!noDomain.empty())
  {
    pemesh::SetCaseFailed(output, "invalid-domain", noDomain);
    return 1;
  }
  Layout layout;
  const std::string fault = ReadLayout(input, domain, layout);
  if (!fault.empty())
  {
    pemesh::SetCaseFailed(output, "invalid-layout", fault);
    return 1;
  }
  const std::vector<std::vector<pemesh::Point2>> polygons = CounterClockwisePolygons(layout);
  pemesh::DomainMeshOptions options = this->MakeOptions(polygons);
  for (const pemesh::PlacedPolygon& polygon : layout.Polygons)
  {
    options.PolygonNames.push_back(polygon.Name);
  }
  const pemesh::DomainMesh mesh =
    MeshOrExplain(domain, polygons, options, static_cast<int>(this->TargetNumberOfElements));
  if (mesh.Status == pemesh::DomainMeshStatus::Stopped)
  {
    output->Initialize(); // the caller does not want it
    return 1;
  }
  WriteOutcome(mesh, layout, output);
  return 1;
}

void vtkPEMDomainMesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AreaRule: " << this->GetAreaRuleName() << "\n";
  os << indent << "MaximumArea: " << this->MaximumArea << "\n";
  os << indent << "MinimumAngle: " << this->MinimumAngle << "\n";
  os << indent << "TargetNumberOfElements: " << this->TargetNumberOfElements << "\n";
  os << indent << "Gradation: " << this->Gradation << "\n";
  os << indent << "SizeAtPolygons: " << this->SizeAtPolygons << "\n";
  os << indent << "PreservePolygons: " << this->PreservePolygons << "\n";
  os << indent << "PreserveDomain: " << this->PreserveDomain << "\n";
  os << indent << "MaximumNumberOfElements: " << this->MaximumNumberOfElements << "\n";
}
