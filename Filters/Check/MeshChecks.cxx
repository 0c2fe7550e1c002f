// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshChecks.h"

#include "CheckFunctions.h"
#include "NumberText.h"
#include "PolygonMeasures.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pemesh
{

namespace
{

constexpr CheckSeverity Warning = CheckSeverity::Warning;
constexpr CheckSeverity Error = CheckSeverity::Error;

const std::array Table = {
  MeshCheck{ "vertex-numbers", "Vertex numbers", "an element uses a vertex that is not there",
    Error, false, CheckVertexIds },
  MeshCheck{ "finite", "Finite coordinates",
    "an element has a vertex with a coordinate that is not a finite number", Error, false,
    CheckFinite },
  MeshCheck{ "planar", "Planar", "an element has a vertex at another height (z) than most points",
    Error, false, CheckPlanar },
  MeshCheck{ "degenerate", "Degenerate elements",
    "an element has fewer than three vertices, no area, or a vertex repeated in a row (only this "
    "last can be repaired)",
    Error, true, CheckDegenerate },
  MeshCheck{ "simple", "Simple elements", "sides of an element cross or touch (exact)", Error,
    false, CheckSimple },
  MeshCheck{ "orientation", "Orientation", "a simple element is clockwise (exact)", Error, true,
    CheckOrientation },
  MeshCheck{ "slivers", "Slivers", "an element is very thin for its diameter", Warning, false,
    CheckSlivers },
  MeshCheck{ "duplicate-vertices", "Duplicate vertices", "two vertices have equal coordinates",
    Error, true, CheckDuplicateVertices },
  MeshCheck{ "near-vertices", "Nearly equal vertices", "two vertices are as near as rounding",
    Warning, false, CheckNearVertices },
  MeshCheck{ "unused-points", "Unused points", "a point is in no element", Warning, true,
    CheckUnusedPoints },
  MeshCheck{ "sides", "Sides", "a side has more than two elements, or two on the same side of it",
    Error, false, CheckSides },
  MeshCheck{ "t-junctions", "T-junctions",
    "a vertex lies in the interior of a side of another element, exactly or within rounding", Error,
    false, CheckTJunctions },
  MeshCheck{ "pinched-vertices", "Pinched vertices",
    "the elements around a vertex hang together by that vertex only", Error, false,
    CheckPinchedVertices },
  MeshCheck{ "overlaps", "Overlaps", "the interiors of two elements meet (exact)", Error, false,
    CheckOverlaps },
  MeshCheck{ "connected", "Connected", "elements are not joined to the others by sides", Error,
    false, CheckConnected },
  MeshCheck{ "holes", "Holes", "the mesh leaves a hole (that the domain, if given, does not have)",
    Warning, false, CheckHoles },
  MeshCheck{ "coverage", "Coverage",
    "the mesh has another area or another border than the domain; only if that is given", Error,
    false, CheckCoverage },
};

bool IsChosen(const MeshCheck& check, const CheckOptions& options)
{
  return options.Checks.empty() ||
    std::find(options.Checks.begin(), options.Checks.end(), check.Name) != options.Checks.end();
}

void SetFacts(MeshUnderCheck& mesh, MeshReport& report)
{
  if (!mesh.HasSides())
  {
    return;
  }
  const MeshSides& sides = mesh.GetSides();
  report.NumberOfComponents = sides.NumberOfComponents;
  std::vector<Point2> points;
  report.NumberOfHoles = 0;
  for (const std::vector<int>& loop : sides.Loops)
  {
    points.clear();
    for (const int vertex : loop)
    {
      points.push_back(mesh.GetMesh().Points[vertex]);
    }
    report.NumberOfHoles += SignedArea(points) < 0.0;
  }
}

} // namespace

std::span<const MeshCheck> MeshChecks()
{
  return Table;
}

const MeshCheck* FindMeshCheck(std::string_view name)
{
  const auto* found = std::find_if(
    Table.begin(), Table.end(), [name](const MeshCheck& check) { return name == check.Name; });
  return found == Table.end() ? nullptr : found;
}

std::string DescribeUnknownMeshCheck(std::string_view name)
{
  const auto* nearest = std::min_element(Table.begin(), Table.end(),
    [name](const MeshCheck& a, const MeshCheck& b)
    { return EditDistance(name, a.Name) < EditDistance(name, b.Name); });
  return "There is no check \"" + std::string(name) + "\"; the nearest is \"" + nearest->Name +
    "\".";
}

std::int64_t MeshReport::GetCount(CheckSeverity severity) const
{
  std::int64_t count = 0;
  for (std::size_t i = 0; i < this->Counts.size(); ++i)
  {
    count += Table[i].Severity == severity ? this->Counts[i] : 0;
  }
  return count;
}

std::int64_t MeshReport::GetCount(std::string_view check) const
{
  const MeshCheck* found = FindMeshCheck(check);
  return found && !this->Counts.empty() ? this->Counts[found - Table.data()] : 0;
}

MeshReport CheckMesh(const RawMesh& raw, const CheckOptions& options)
{
  MeshReport report;
  MeshUnderCheck mesh(raw, options);
  FindingList findings(report, raw.Mesh.NumberOfElements(), options.MostExamples);
  for (std::size_t i = 0; i < Table.size() && !report.IsStopped; ++i)
  {
    if (IsChosen(Table[i], options))
    {
      findings.StartCheck(i);
      Table[i].Function(mesh, findings);
    }
    report.IsStopped = options.Progress &&
      !options.Progress(static_cast<double>(i + 1) / static_cast<double>(Table.size()));
  }
  SetFacts(mesh, report);
  return report;
}

const NormalForm& MeshUnderCheck::GetNormalForm()
{
  if (!this->Form)
  {
    this->Form = MakeNormalForm(this->Raw.Mesh);
  }
  return *this->Form;
}

const MeshSides& MeshUnderCheck::GetSides()
{
  if (!this->Sides)
  {
    this->Sides = FindSides(this->GetNormalForm(), this->Options.Tolerance);
  }
  return *this->Sides;
}

Point2 MeshUnderCheck::PlaceOfElement(int element)
{
  Point2 sum;
  double count = 0.0;
  for (const int vertex : this->Raw.Mesh.Element(element))
  {
    if (this->IsInRange(vertex) && this->GetNormalForm().IsFinite[vertex])
    {
      sum.x += this->Raw.Mesh.Points[vertex].x;
      sum.y += this->Raw.Mesh.Points[vertex].y;
      count += 1.0;
    }
  }
  return count > 0.0 ? Point2{ sum.x / count, sum.y / count } : Point2{};
}

ElementsAround::ElementsAround(const PolygonMesh& mesh, const std::vector<unsigned char>& isWanted)
{
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    for (const int vertex : mesh.Element(element))
    {
      if (vertex >= 0 && vertex < static_cast<int>(isWanted.size()) && isWanted[vertex])
      {
        this->Pairs.emplace_back(vertex, element);
      }
    }
  }
  std::sort(this->Pairs.begin(), this->Pairs.end());
  this->Pairs.erase(std::unique(this->Pairs.begin(), this->Pairs.end()), this->Pairs.end());
}

std::vector<int> ElementsAround::Get(int vertex) const
{
  std::vector<int> elements;
  for (auto found =
         std::lower_bound(this->Pairs.begin(), this->Pairs.end(), std::pair<int, int>(vertex, 0));
       found != this->Pairs.end() && found->first == vertex; ++found)
  {
    elements.push_back(found->second);
  }
  return elements;
}

} // namespace pemesh
