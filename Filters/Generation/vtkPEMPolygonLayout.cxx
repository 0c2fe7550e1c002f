// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMPolygonLayout.h"

#include "CaseStatus.h"
#include "LayoutValidity.h"
#include "NumberText.h"
#include "PolygonFamilies.h"
#include "PolygonPlacement.h"

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
#include <limits>

vtkStandardNewMacro(vtkPEMPolygonLayout);

struct vtkPEMPolygonLayout::Placement
{
  const pemesh::PolygonFamily* Family = nullptr;
  pemesh::Point2 Center;
  double Scale = 1.0;
  double Rotation = 0.0;
  int Count = 0;
  double From = 0.0;
  double To = 1.0;
  std::string Name;

  std::vector<pemesh::Point2> VerticesAt(double time) const
  {
    const double t = this->From + time * (this->To - this->From);
    return pemesh::PlacePolygon(
      this->Family->Vertices(t, this->Count), this->Center, this->Scale, this->Rotation);
  }
};

namespace
{

constexpr double MaximumScale = 10.0;
constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

bool IsWithin(double value, double low, double high)
{
  return value >= low && value <= high; // false for NaN
}

/** Where each polygon goes: its name in sentences on wrong settings. */
std::string Sentence(
  const std::string& polygon, const std::string& what, double value, const std::string& expected)
{
  return "The " + what + " of " + polygon + " is " + pemesh::FormatNumber(value) + ", expected " +
    expected + ".";
}

} // namespace

vtkPEMPolygonLayout::vtkPEMPolygonLayout()
{
  this->SetNumberOfInputPorts(0);
}

vtkPEMPolygonLayout::~vtkPEMPolygonLayout() = default;

int vtkPEMPolygonLayout::AddPolygon(const std::string& family, double centerX, double centerY)
{
  const pemesh::PolygonFamily* found = pemesh::FindPolygonFamily(family);
  if (!found)
  {
    std::vector<std::string> names;
    for (const pemesh::PolygonFamily& candidate : pemesh::PolygonFamilies())
    {
      names.emplace_back(candidate.Name);
    }
    vtkErrorMacro(<< "There is no polygon family \"" << family << "\"; did you mean \""
                  << pemesh::NearestWord(family, names) << "\"?");
    return -1;
  }
  const int index = this->GetNumberOfPolygons();
  Placement placement;
  placement.Family = found;
  placement.Center = { centerX, centerY };
  placement.Count = found->DefaultCount;
  placement.Name = "polygon " + std::to_string(index + 1) + " (" + found->Name + ")";
  this->Placements.push_back(placement);
  this->Modified();
  return index;
}

void vtkPEMPolygonLayout::RemoveAllPolygons()
{
  if (!this->Placements.empty())
  {
    this->Placements.clear();
    this->Modified();
  }
}

int vtkPEMPolygonLayout::GetNumberOfPolygons() const
{
  return static_cast<int>(this->Placements.size());
}

const vtkPEMPolygonLayout::Placement* vtkPEMPolygonLayout::PeekPlacement(int index) const
{
  return index >= 0 && index < this->GetNumberOfPolygons() ? &this->Placements[index] : nullptr;
}

vtkPEMPolygonLayout::Placement* vtkPEMPolygonLayout::FindPlacement(int index)
{
  if (!this->PeekPlacement(index))
  {
    vtkErrorMacro(<< "There is no polygon of index " << index << ": the layout has "
                  << this->GetNumberOfPolygons() << ", counted from 0.");
    return nullptr;
  }
  return &this->Placements[index];
}

void vtkPEMPolygonLayout::SetPolygonCenter(int index, double centerX, double centerY)
{
  Placement* placement = this->FindPlacement(index);
  if (placement && (placement->Center.x != centerX || placement->Center.y != centerY))
  {
    placement->Center = { centerX, centerY };
    this->Modified();
  }
}

double vtkPEMPolygonLayout::GetPolygonCenterX(int index) const
{
  const Placement* placement = this->PeekPlacement(index);
  return placement ? placement->Center.x : Undefined;
}

double vtkPEMPolygonLayout::GetPolygonCenterY(int index) const
{
  const Placement* placement = this->PeekPlacement(index);
  return placement ? placement->Center.y : Undefined;
}

void vtkPEMPolygonLayout::SetPolygonScale(int index, double scale)
{
  Placement* placement = this->FindPlacement(index);
  if (placement && placement->Scale != scale)
  {
    placement->Scale = scale;
    this->Modified();
  }
}

double vtkPEMPolygonLayout::GetPolygonScale(int index) const
{
  const Placement* placement = this->PeekPlacement(index);
  return placement ? placement->Scale : Undefined;
}

void vtkPEMPolygonLayout::SetPolygonRotation(int index, double degrees)
{
  Placement* placement = this->FindPlacement(index);
  if (placement && placement->Rotation != degrees)
  {
    placement->Rotation = degrees;
    this->Modified();
  }
}

double vtkPEMPolygonLayout::GetPolygonRotation(int index) const
{
  const Placement* placement = this->PeekPlacement(index);
  return placement ? placement->Rotation : Undefined;
}

void vtkPEMPolygonLayout::SetPolygonCount(int index, int count)
{
  Placement* placement = this->FindPlacement(index);
  if (!placement || placement->Count == count)
  {
    return;
  }
  const pemesh::PolygonFamily& family = *placement->Family;
  if (!family.CountName)
  {
    vtkErrorMacro(<< placement->Name << " has no count to set: its family \"" << family.Name
                  << "\" always has the same number of vertices.");
    return;
  }
  if (count < family.MinimumCount || count > pemesh::MaximumPolygonCount)
  {
    vtkErrorMacro(<< "The number of " << family.CountName << " of " << placement->Name << " is "
                  << count << ", expected " << family.MinimumCount << " to "
                  << pemesh::MaximumPolygonCount << ".");
    return;
  }
  placement->Count = count;
  this->Modified();
}

int vtkPEMPolygonLayout::GetPolygonCount(int index) const
{
  const Placement* placement = this->PeekPlacement(index);
  return placement ? placement->Count : 0;
}

void vtkPEMPolygonLayout::SetPolygonRange(int index, double from, double to)
{
  Placement* placement = this->FindPlacement(index);
  if (placement && (placement->From != from || placement->To != to))
  {
    placement->From = from;
    placement->To = to;
    this->Modified();
  }
}

double vtkPEMPolygonLayout::GetPolygonFrom(int index) const
{
  const Placement* placement = this->PeekPlacement(index);
  return placement ? placement->From : Undefined;
}

double vtkPEMPolygonLayout::GetPolygonTo(int index) const
{
  const Placement* placement = this->PeekPlacement(index);
  return placement ? placement->To : Undefined;
}

void vtkPEMPolygonLayout::SetPolygonName(int index, const std::string& name)
{
  Placement* placement = this->FindPlacement(index);
  if (placement && placement->Name != name)
  {
    placement->Name = name;
    this->Modified();
  }
}

std::string vtkPEMPolygonLayout::GetPolygonName(int index) const
{
  const Placement* placement = this->PeekPlacement(index);
  return placement ? placement->Name : std::string();
}

std::string vtkPEMPolygonLayout::GetPolygonFamily(int index) const
{
  const Placement* placement = this->PeekPlacement(index);
  return placement ? placement->Family->Name : std::string();
}

std::vector<double> vtkPEMPolygonLayout::GetTimes() const
{
  const bool changes = std::any_of(this->Placements.begin(), this->Placements.end(),
    [](const Placement& placement) { return placement.From != placement.To; });
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

std::string vtkPEMPolygonLayout::FindFault(double time) const
{
  const std::string misconfigured = this->WhyMisconfigured();
  if (!misconfigured.empty())
  {
    return misconfigured;
  }
  std::vector<pemesh::PlacedPolygon> polygons;
  for (const Placement& placement : this->Placements)
  {
    polygons.push_back({ placement.Name, placement.VerticesAt(time) });
  }
  return pemesh::FindLayoutFault(polygons, pemesh::UnitSquare(), time);
}

std::vector<std::string> vtkPEMPolygonLayout::FindFaults() const
{
  std::vector<std::string> faults;
  for (const double time : this->GetTimes())
  {
    std::string fault = this->FindFault(time);
    if (!fault.empty() && (faults.empty() || faults.back() != fault))
    {
      faults.push_back(std::move(fault));
    }
  }
  return faults;
}

std::string vtkPEMPolygonLayout::WhyMisconfigured() const
{
  if (!(this->FirstTime <= this->LastTime))
  {
    return "FirstTime is " + pemesh::FormatNumber(this->FirstTime) + " and LastTime " +
      pemesh::FormatNumber(this->LastTime) + "; the first must not be the later one.";
  }
  for (const Placement& placement : this->Placements)
  {
    const std::string& name = placement.Name;
    if (!std::isfinite(placement.Center.x) || !std::isfinite(placement.Center.y))
    {
      return "The center of " + name + " is not a pair of finite numbers.";
    }
    if (!(placement.Scale > 0.0 && placement.Scale <= MaximumScale))
    {
      return Sentence(name, "scale", placement.Scale, "more than 0 and at most 10");
    }
    if (!std::isfinite(placement.Rotation))
    {
      return Sentence(name, "rotation", placement.Rotation, "a finite number of degrees");
    }
    if (!IsWithin(placement.From, 0.0, 1.0) || !IsWithin(placement.To, 0.0, 1.0))
    {
      const bool first = !IsWithin(placement.From, 0.0, 1.0);
      return Sentence(name, first ? "first deformation" : "last deformation",
        first ? placement.From : placement.To, "0 to 1");
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
  families->SetName("ElementFamily");
  vtkNew<vtkIntArray> ids;
  ids->SetName("PolygonId");
  vtkNew<vtkStringArray> names;
  names->SetName("PolygonName");
  for (const Placement& placement : this->Placements)
  {
    const std::vector<pemesh::Point2> vertices = placement.VerticesAt(time);
    cells->InsertNextCell(static_cast<int>(vertices.size()));
    for (const pemesh::Point2& vertex : vertices)
    {
      cells->InsertCellPoint(points->InsertNextPoint(vertex.x, vertex.y, 0.0));
    }
    families->InsertNextValue(pemesh::PolygonFamilyIndex(placement.Family));
    ids->InsertNextValue(static_cast<int>(ids->GetNumberOfValues()));
    names->InsertNextValue(placement.Name);
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
  for (const Placement& placement : this->Placements)
  {
    os << next << placement.Name << ": family " << placement.Family->Name << ", center ("
       << placement.Center.x << ", " << placement.Center.y << "), scale " << placement.Scale
       << ", rotation " << placement.Rotation << ", count " << placement.Count << ", range "
       << placement.From << " to " << placement.To << "\n";
  }
}
