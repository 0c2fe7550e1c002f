// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMMeshCheck.h"

#include "CaseStatus.h"
#include "ElementAccess.h"
#include "MeshChecks.h"
#include "MeshConversion.h"
#include "MeshRepair.h"
#include "Progress.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

vtkStandardNewMacro(vtkPEMMeshCheck);

namespace
{

std::vector<std::string> CheckNames()
{
  std::vector<std::string> names;
  for (const pemesh::MeshCheck& check : pemesh::MeshChecks())
  {
    names.emplace_back(check.Name);
  }
  return names;
}

/** Of what can be wrong with a mesh only what leaves nothing to check. */
std::string WhyUnusable(vtkPolyData* mesh)
{
  constexpr vtkIdType Most = std::numeric_limits<int>::max();
  if (mesh->GetNumberOfPoints() == 0 || mesh->GetNumberOfPolys() == 0)
  {
    return "it has no polygons";
  }
  if (mesh->GetNumberOfCells() != mesh->GetNumberOfPolys())
  {
    return "it has cells that are not polygons (vertices, lines or strips)";
  }
  return mesh->GetNumberOfPoints() > Most || mesh->GetPolys()->GetNumberOfConnectivityIds() > Most
    ? "it has more than 2147483647 points or sides"
    : std::string();
}

/** Whatever the numbers of vertices are: those beyond an int are out of range as any other. */
pemesh::RawMesh ToRawMesh(vtkPolyData* input)
{
  pemesh::RawMesh raw;
  const vtkIdType points = input->GetNumberOfPoints();
  raw.Mesh.Points.resize(static_cast<std::size_t>(points));
  for (vtkIdType i = 0; i < points; ++i)
  {
    double point[3];
    input->GetPoint(i, point);
    raw.Mesh.Points[i] = { point[0], point[1] };
    if (point[2] != 0.0)
    {
      raw.Heights.resize(raw.Mesh.Points.size());
      raw.Heights[i] = point[2];
    }
  }
  pemesh::ElementAccess access(input);
  raw.Mesh.Offsets.reserve(static_cast<std::size_t>(access.GetNumberOfElements()) + 1);
  raw.Mesh.Vertices.reserve(
    static_cast<std::size_t>(input->GetPolys()->GetNumberOfConnectivityIds()));
  std::vector<vtkIdType> ids;
  for (vtkIdType element = 0; element < access.GetNumberOfElements(); ++element)
  {
    access.GetVertexIds(element, ids);
    for (const vtkIdType id : ids)
    {
      raw.Mesh.Vertices.push_back(
        static_cast<int>(std::clamp<vtkIdType>(id, -1, std::numeric_limits<int>::max())));
    }
    raw.Mesh.Offsets.push_back(raw.Mesh.NumberOfSides());
  }
  return raw;
}

/** Puts the repaired mesh into `output`, which has the arrays of the mesh before. */
void SetRepaired(const pemesh::MeshRepair& repair, pemesh::RawMesh& raw, vtkPolyData* output)
{
  vtkNew<vtkPointData> before;
  before->ShallowCopy(output->GetPointData());
  output->GetPointData()->Initialize();
  pemesh::SetPolygonMesh(output, repair.Mesh);
  const auto points = static_cast<vtkIdType>(repair.Points.size());
  output->GetPointData()->CopyAllOn();
  output->GetPointData()->CopyAllocate(before, points);
  std::vector<double> heights;
  for (vtkIdType i = 0; i < points; ++i)
  {
    output->GetPointData()->CopyData(before, repair.Points[i], i);
    if (!raw.Heights.empty())
    {
      const double height = raw.Heights[repair.Points[i]];
      heights.push_back(height);
      output->GetPoints()->SetPoint(i, repair.Mesh.Points[i].x, repair.Mesh.Points[i].y, height);
    }
  }
  raw = { repair.Mesh, std::move(heights) };
}

void AddFaults(const pemesh::MeshReport& report, vtkPolyData* output)
{
  vtkNew<vtkIntArray> faults;
  faults->SetName("Faults");
  faults->SetNumberOfValues(static_cast<vtkIdType>(report.Faults.size()));
  std::copy(report.Faults.begin(), report.Faults.end(), faults->GetPointer(0));
  output->GetCellData()->AddArray(faults);
}

std::string NamesOfChecks(std::uint32_t bits)
{
  std::string names;
  for (std::size_t i = 0; i < pemesh::MeshChecks().size(); ++i)
  {
    if ((bits >> i & 1U) != 0)
    {
      names += (names.empty() ? "" : " ") + std::string(pemesh::MeshChecks()[i].Name);
    }
  }
  return names;
}

/** The points of the faulty elements, numbered as they are met. */
class FaultyPoints
{
public:
  explicit FaultyPoints(const pemesh::RawMesh& raw)
    : Raw(raw)
    , Number(raw.Mesh.Points.size(), -1)
  {
    this->Points->SetDataTypeToDouble();
  }

  /** -1 for a vertex that cannot be used. */
  vtkIdType GetNumber(int vertex)
  {
    if (vertex < 0 || vertex >= static_cast<int>(this->Number.size()))
    {
      return -1;
    }
    const pemesh::Point2& point = this->Raw.Mesh.Points[vertex];
    if (this->Number[vertex] < 0 && std::isfinite(point.x) && std::isfinite(point.y))
    {
      this->Number[vertex] = this->Points->InsertNextPoint(
        point.x, point.y, this->Raw.Heights.empty() ? 0.0 : this->Raw.Heights[vertex]);
    }
    return this->Number[vertex];
  }

  vtkPoints* GetPoints() { return this->Points; }

private:
  const pemesh::RawMesh& Raw;
  std::vector<vtkIdType> Number;
  vtkNew<vtkPoints> Points;
};

/** The elements with faults, with points of their own. */
void FillFaultyCells(
  const pemesh::RawMesh& raw, const pemesh::MeshReport& report, vtkPolyData* output)
{
  vtkNew<vtkIdTypeArray> elements;
  elements->SetName("Element");
  vtkNew<vtkIntArray> faults;
  faults->SetName("Faults");
  vtkNew<vtkStringArray> checks;
  checks->SetName("Check");
  vtkNew<vtkCellArray> cells;
  FaultyPoints points(raw);
  std::vector<vtkIdType> corners;
  for (int element = 0; element < raw.Mesh.NumberOfElements(); ++element)
  {
    if (report.Faults[element] == 0)
    {
      continue;
    }
    corners.clear();
    for (const int vertex : raw.Mesh.Element(element))
    {
      corners.push_back(points.GetNumber(vertex));
    }
    corners.erase(std::remove(corners.begin(), corners.end(), -1), corners.end());
    cells->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
    elements->InsertNextValue(element);
    faults->InsertNextValue(report.Faults[element]);
    checks->InsertNextValue(NamesOfChecks(report.FaultBits[element]));
  }
  output->SetPoints(points.GetPoints());
  output->SetPolys(cells);
  output->GetCellData()->AddArray(elements);
  output->GetCellData()->AddArray(faults);
  output->GetCellData()->AddArray(checks);
}

/** The columns of the table of findings, row by row. */
class FindingRows
{
public:
  FindingRows()
  {
    this->Check->SetName("Check");
    this->Severity->SetName("Severity");
    this->Element->SetName("Element");
    this->Vertex->SetName("Vertex");
    this->X->SetName("x");
    this->Y->SetName("y");
    this->Message->SetName("Message");
  }

  void Add(const std::vector<pemesh::MeshFinding>& findings, bool areRepaired)
  {
    for (const pemesh::MeshFinding& finding : findings)
    {
      const bool isError = finding.Check->Severity == pemesh::CheckSeverity::Error;
      this->Check->InsertNextValue(finding.Check->Name);
      this->Severity->InsertNextValue(areRepaired ? "repaired" : isError ? "error" : "warning");
      this->Element->InsertNextValue(finding.Elements.empty() ? -1 : finding.Elements[0]);
      this->Vertex->InsertNextValue(finding.Vertices.empty() ? -1 : finding.Vertices[0]);
      this->X->InsertNextValue(finding.Place.x);
      this->Y->InsertNextValue(finding.Place.y);
      this->Message->InsertNextValue(finding.Message);
    }
  }

  void Give(vtkTable* table)
  {
    for (vtkAbstractArray* column : std::initializer_list<vtkAbstractArray*>{ this->Check,
           this->Severity, this->Element, this->Vertex, this->X, this->Y, this->Message })
    {
      table->AddColumn(column);
    }
  }

private:
  vtkNew<vtkStringArray> Check;
  vtkNew<vtkStringArray> Severity;
  vtkNew<vtkIdTypeArray> Element;
  vtkNew<vtkIdTypeArray> Vertex;
  vtkNew<vtkDoubleArray> X;
  vtkNew<vtkDoubleArray> Y;
  vtkNew<vtkStringArray> Message;
};

vtkIdType CountOf(const std::vector<vtkIdType>& counts, const std::string& name)
{
  const pemesh::MeshCheck* check = pemesh::FindMeshCheck(name);
  return check && !counts.empty() ? counts[check - pemesh::MeshChecks().data()] : 0;
}

} // namespace

vtkPEMMeshCheck::vtkPEMMeshCheck()
  : Checks(CheckNames())
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

vtkPEMMeshCheck::~vtkPEMMeshCheck() = default;

void vtkPEMMeshCheck::SetChecks(const std::vector<std::string>& names)
{
  for (const std::string& name : names)
  {
    if (!pemesh::FindMeshCheck(name))
    {
      vtkErrorMacro(<< pemesh::DescribeUnknownMeshCheck(name));
      return;
    }
  }
  std::vector<std::string> chosen = CheckNames();
  chosen.erase(std::remove_if(chosen.begin(), chosen.end(),
                 [&names](const std::string& name)
                 { return std::find(names.begin(), names.end(), name) == names.end(); }),
    chosen.end());
  if (chosen != this->Checks)
  {
    this->Checks = std::move(chosen);
    this->Modified();
  }
}

void vtkPEMMeshCheck::SelectAllChecks()
{
  this->SetChecks(CheckNames());
}

std::vector<std::string> vtkPEMMeshCheck::GetChecks() const
{
  return this->Checks;
}

std::vector<std::string> vtkPEMMeshCheck::GetAvailableChecks()
{
  return CheckNames();
}

vtkIdType vtkPEMMeshCheck::GetNumberOfFindings(const std::string& check) const
{
  return CountOf(this->FindingCounts, check);
}

vtkIdType vtkPEMMeshCheck::GetNumberOfRepairs(const std::string& check) const
{
  return CountOf(this->RepairCounts, check);
}

int vtkPEMMeshCheck::FillInputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1)
  {
    information->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkPEMMeshCheck::FillOutputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkDataObject::DATA_TYPE_NAME(), port == 2 ? "vtkTable" : "vtkPolyData");
  return 1;
}

int vtkPEMMeshCheck::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  output->ShallowCopy(input);
  this->ForgetResults();
  pemesh::CheckOptions options;
  const std::string problem = this->GetOptions(vtkPolyData::GetData(inputVector[1]), options);
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 0;
  }
  if (pemesh::IsCaseFailed(input))
  {
    return 1;
  }
  const std::string unusable = WhyUnusable(input);
  if (!unusable.empty())
  {
    pemesh::SetCaseFailed(output, "unusable-mesh", "The mesh cannot be checked: " + unusable + ".");
    return 1;
  }
  FindingRows rows;
  pemesh::RawMesh raw = ToRawMesh(input);
  if (this->Repair)
  {
    const pemesh::MeshRepair repair = pemesh::RepairMesh(raw.Mesh, options);
    this->RepairCounts.assign(repair.Counts.begin(), repair.Counts.end());
    this->NumberOfRepairs =
      std::accumulate(this->RepairCounts.begin(), this->RepairCounts.end(), vtkIdType{ 0 });
    if (this->NumberOfRepairs > 0)
    {
      SetRepaired(repair, raw, output);
    }
    rows.Add(repair.Repairs, true);
  }
  const pemesh::MeshReport report = pemesh::CheckMesh(raw, options);
  if (report.IsStopped)
  {
    output->Initialize();
    return 1;
  }
  rows.Add(report.Findings, false);
  rows.Give(vtkTable::GetData(outputVector, 2));
  AddFaults(report, output);
  FillFaultyCells(raw, report, vtkPolyData::GetData(outputVector, 1));
  this->KeepResults(report);
  return 1;
}

std::string vtkPEMMeshCheck::GetOptions(vtkPolyData* domain, pemesh::CheckOptions& options)
{
  for (const double number : { this->SliverThickness, this->Tolerance, this->AreaTolerance })
  {
    if (std::isnan(number)) // passes vtkSetClampMacro
    {
      return "SliverThickness, Tolerance and AreaTolerance must be numbers from 0 to 1.";
    }
  }
  options.SliverThickness = this->SliverThickness;
  options.Tolerance = this->Tolerance;
  options.AreaTolerance = this->AreaTolerance;
  options.MostExamples = this->MaximumNumberOfExamples;
  options.Checks = this->Checks;
  options.Progress = [this](double fraction) { return pemesh::ReportProgress(this, fraction); };
  if (this->Checks.empty())
  {
    options.Checks = { "" }; // none: an empty list stands for all
  }
  return domain && domain->GetNumberOfCells() > 0
    ? pemesh::ToDomain(domain, options.ExpectedDomain.emplace())
    : std::string();
}

void vtkPEMMeshCheck::ForgetResults()
{
  this->NumberOfErrors = this->NumberOfWarnings = this->NumberOfRepairs = 0;
  this->NumberOfComponents = this->NumberOfHoles = -1;
  this->FindingCounts.clear();
  this->RepairCounts.clear();
}

void vtkPEMMeshCheck::KeepResults(const pemesh::MeshReport& report)
{
  this->FindingCounts.assign(report.Counts.begin(), report.Counts.end());
  this->NumberOfErrors = report.GetCount(pemesh::CheckSeverity::Error);
  this->NumberOfWarnings = report.GetCount(pemesh::CheckSeverity::Warning);
  this->NumberOfComponents = report.NumberOfComponents;
  this->NumberOfHoles = report.NumberOfHoles;
}

void vtkPEMMeshCheck::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Checks:";
  for (const std::string& name : this->Checks)
  {
    os << ' ' << name;
  }
  os << '\n' << indent << "Repair: " << (this->Repair ? "On\n" : "Off\n");
  os << indent << "SliverThickness: " << this->SliverThickness << '\n';
  os << indent << "Tolerance: " << this->Tolerance << '\n';
  os << indent << "AreaTolerance: " << this->AreaTolerance << '\n';
  os << indent << "MaximumNumberOfExamples: " << this->MaximumNumberOfExamples << '\n';
  os << indent << "NumberOfErrors: " << this->NumberOfErrors << '\n';
  os << indent << "NumberOfWarnings: " << this->NumberOfWarnings << '\n';
  os << indent << "NumberOfRepairs: " << this->NumberOfRepairs << '\n';
  os << indent << "NumberOfComponents: " << this->NumberOfComponents << '\n';
  os << indent << "NumberOfHoles: " << this->NumberOfHoles << '\n';
}
