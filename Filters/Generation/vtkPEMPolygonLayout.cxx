// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMPolygonLayout.h"

#include "CaseStatus.h"
#include "Domain.h"
#include "LayoutPolygon.h"
#include "LayoutValidity.h"
#include "MeshConversion.h"
#include "NumberText.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <utility>

vtkStandardNewMacro(vtkPEMPolygonLayout);

vtkPEMPolygonLayout::vtkPEMPolygonLayout() = default;

vtkPEMPolygonLayout::~vtkPEMPolygonLayout() = default;

int vtkPEMPolygonLayout::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  information->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

std::vector<double> vtkPEMPolygonLayout::GetTimes() const
{
  const bool changes = std::any_of(this->Polygons.begin(), this->Polygons.end(),
    [](const pemesh::LayoutPolygon& polygon) { return polygon.ChangesWithTime(); });
  const int count = changes && this->LastTime > this->FirstTime ? this->NumberOfTimes : 1;
  std::vector<double> times = { this->FirstTime };
  for (int i = 1; i < count; ++i)
  {
    const double time = i == count - 1
      ? this->LastTime
      : this->FirstTime + i * (this->LastTime - this->FirstTime) / (count - 1);
    if (time > times.back()) // steps may be finer than doubles
    {
      times.push_back(time);
    }
  }
  return times;
}

std::vector<pemesh::PlacedPolygon> vtkPEMPolygonLayout::PolygonsAt(double time) const
{
  std::vector<pemesh::PlacedPolygon> polygons;
  for (int i = 0; i < this->GetNumberOfPolygons(); ++i)
  {
    polygons.push_back({ this->Polygons[i].NameAt(i), this->Polygons[i].VerticesAt(time) });
  }
  return polygons;
}

std::string vtkPEMPolygonLayout::UpdateDomain(pemesh::Domain& domain)
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    domain = pemesh::UnitSquare();
    return {};
  }
  this->GetInputAlgorithm(0, 0)->Update();
  auto* input = vtkPolyData::SafeDownCast(this->GetInputDataObject(0, 0));
  return pemesh::IsCaseFailed(input) ? pemesh::GetCaseStatusMessage(input)
                                     : pemesh::ToDomain(input, domain);
}

std::string vtkPEMPolygonLayout::FindFaultIn(const pemesh::Domain& domain, double time) const
{
  return pemesh::FindLayoutFault(this->PolygonsAt(time), domain, time);
}

std::string vtkPEMPolygonLayout::FindFault(double time)
{
  pemesh::Domain domain;
  const std::string fault = this->WhyNoLayout(domain);
  return fault.empty() ? this->FindFaultIn(domain, time) : fault;
}

std::vector<std::string> vtkPEMPolygonLayout::FindFaults()
{
  pemesh::Domain domain;
  const std::string unusable = this->WhyNoLayout(domain);
  if (!unusable.empty())
  {
    return { unusable };
  }
  std::vector<std::string> faults;
  for (const double time : this->GetTimes())
  {
    std::string fault = this->FindFaultIn(domain, time);
    if (!fault.empty() && (faults.empty() || faults.back() != fault))
    {
      faults.push_back(std::move(fault));
    }
  }
  return faults;
}

std::string vtkPEMPolygonLayout::WhyNoLayout(pemesh::Domain& domain)
{
  std::string why = this->WhyMisconfigured();
  return why.empty() ? this->UpdateDomain(domain) : why;
}

std::string vtkPEMPolygonLayout::WhyMisconfigured() const
{
  if (!(this->FirstTime <= this->LastTime))
  {
    return "FirstTime is " + pemesh::FormatNumber(this->FirstTime) + " and LastTime " +
      pemesh::FormatNumber(this->LastTime) + "; the first must not be the later one.";
  }
  for (int i = 0; i < this->GetNumberOfPolygons(); ++i)
  {
    std::string why = this->Polygons[i].WhyInvalid(this->Polygons[i].NameAt(i));
    if (!why.empty())
    {
      return why;
    }
  }
  return {};
}

int vtkPEMPolygonLayout::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  const std::string misconfigured = this->WhyMisconfigured();
  if (!misconfigured.empty())
  {
    vtkErrorMacro(<< misconfigured);
    return 0;
  }
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const std::vector<double> times = this->GetTimes();
  const double range[2] = { times.front(), times.back() };
  vtkInformation* information = outputVector->GetInformationObject(0);
  information->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
  information->Set(Pipeline::TIME_RANGE(), range, 2);
  return 1;
}

int vtkPEMPolygonLayout::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  vtkPolyData* output = vtkPolyData::GetData(information);
  const std::string misconfigured = this->WhyMisconfigured();
  if (!misconfigured.empty())
  {
    vtkErrorMacro(<< misconfigured);
    return 0;
  }
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  double time = this->FirstTime;
  if (information->Has(Pipeline::UPDATE_TIME_STEP()))
  {
    const double asked = information->Get(Pipeline::UPDATE_TIME_STEP());
    time = std::isnan(asked) ? time : std::clamp(asked, 0.0, 1.0);
  }

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> families;
  families->SetName(pemesh::ElementFamilyArray);
  vtkNew<vtkIntArray> ids;
  ids->SetName(pemesh::PolygonIdArray);
  vtkNew<vtkStringArray> names;
  names->SetName("PolygonName");
  for (int i = 0; i < this->GetNumberOfPolygons(); ++i)
  {
    const pemesh::LayoutPolygon& polygon = this->Polygons[i];
    const std::vector<pemesh::Point2> vertices = polygon.VerticesAt(time);
    cells->InsertNextCell(static_cast<int>(vertices.size()));
    for (const pemesh::Point2& vertex : vertices)
    {
      cells->InsertCellPoint(points->InsertNextPoint(vertex.x, vertex.y, 0.0));
    }
    families->InsertNextValue(pemesh::PolygonFamilyIndex(polygon.Family));
    ids->InsertNextValue(i);
    names->InsertNextValue(polygon.NameAt(i));
  }
  output->SetPoints(points);
  output->SetPolys(cells);
  output->GetCellData()->AddArray(families);
  output->GetCellData()->AddArray(ids);
  output->GetCellData()->AddArray(names);
  pemesh::SetFieldNumber(output, "t", time);
  pemesh::AddToFieldList(output, pemesh::ParametersList, "t");
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  return 1;
}

void vtkPEMPolygonLayout::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FirstTime: " << this->FirstTime << "\n";
  os << indent << "LastTime: " << this->LastTime << "\n";
  os << indent << "NumberOfTimes: " << this->NumberOfTimes << "\n";
  os << indent << "Polygons: " << this->GetNumberOfPolygons() << "\n";
  const vtkIndent next = indent.GetNextIndent();
  for (int i = 0; i < this->GetNumberOfPolygons(); ++i)
  {
    const pemesh::LayoutPolygon& polygon = this->Polygons[i];
    os << next << polygon.NameAt(i) << ": family " << polygon.Family->Name << ", center ("
       << polygon.Center.x << ", " << polygon.Center.y << "), scale " << polygon.Scale
       << ", rotation " << polygon.Rotation << ", range " << polygon.From << " to " << polygon.To;
    for (const pemesh::Parameter& parameter : polygon.Family->Parameters)
    {
      os << ", " << parameter.Name << " " << polygon.Parameters.Get(parameter.Name);
    }
    os << "\n";
  }
}
