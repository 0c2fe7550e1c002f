// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshRepair.h"

#include "FindingList.h"
#include "NormalForm.h"

#include <algorithm>

namespace pemesh
{

namespace
{

std::string NameOf(int element)
{
  return "Element " + std::to_string(element);
}

class Repairer
{
public:
  Repairer(const PolygonMesh& mesh, const CheckOptions& options)
    : Options(options)
    , Form(MakeNormalForm(mesh))
    , Before(mesh)
    , Findings(this->Report, mesh.NumberOfElements(), options.MostExamples)
    , Merges(this->IsChosen("duplicate-vertices"))
    , Drops(this->IsChosen("degenerate"))
    , Turns(this->IsChosen("orientation"))
    , Removes(this->IsChosen("unused-points"))
  {
  }

  MeshRepair Repair()
  {
    MeshRepair result;
    result.Mesh.Points = this->Before.Points;
    this->RepairElements(result.Mesh);
    this->ReportMergedVertices();
    this->RemoveUnused(result);
    result.Repairs = std::move(this->Report.Findings);
    std::stable_sort(result.Repairs.begin(), result.Repairs.end(),
      [](const MeshFinding& a, const MeshFinding& b) { return a.Check < b.Check; });
    result.Counts = std::move(this->Report.Counts);
    return result;
  }

private:
  bool IsChosen(const char* name) const
  {
    const std::vector<std::string>& names = this->Options.Checks;
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
  }

  template <typename MakeMessage>
  void Add(const char* check, std::initializer_list<int> elements,
    std::initializer_list<int> vertices, const Point2& place, const MakeMessage& makeMessage)
  {
    this->Findings.StartCheck(static_cast<std::size_t>(FindMeshCheck(check) - &MeshChecks()[0]));
    this->Findings.Add(elements, vertices, place, makeMessage);
  }

  void RepairElements(PolygonMesh& mesh);
  bool DropRepeatedVertices(int element, std::vector<int>& vertices);
  void ReportMergedVertices();
  void RemoveUnused(MeshRepair& result);
  Point2 PlaceOf(std::span<const int> vertices) const
  {
    return vertices.empty() ? Point2{} : this->Before.Points[vertices[0]];
  }

  const CheckOptions& Options;
  NormalForm Form;
  const PolygonMesh& Before;
  MeshReport Report;
  FindingList Findings;
  const bool Merges;
  const bool Drops;
  const bool Turns;
  const bool Removes;
};

void Repairer::RepairElements(PolygonMesh& mesh)
{
  std::vector<int> vertices;
  for (int element = 0; element < this->Before.NumberOfElements(); ++element)
  {
    const std::span<const int> before = this->Before.Element(element);
    vertices.assign(before.begin(), before.end());
    if (this->Form.Conditions[element] != ElementCondition::Unusable)
    {
      if (this->Merges)
      {
        std::transform(vertices.begin(), vertices.end(), vertices.begin(),
          [this](int vertex) { return this->Form.Original[vertex]; });
      }
      if (this->Drops && this->DropRepeatedVertices(element, vertices))
      {
        this->Add("degenerate", { element }, {}, this->PlaceOf(vertices),
          [&] { return NameOf(element) + " had repeated vertices, which are dropped."; });
      }
      if (this->Form.Conditions[element] == ElementCondition::Clockwise && this->Turns)
      {
        std::reverse(vertices.begin() + 1, vertices.end());
        this->Add("orientation", { element }, {}, this->PlaceOf(vertices),
          [&] { return NameOf(element) + " was clockwise and is turned round."; });
      }
    }
    mesh.AddElement(vertices);
  }
}

/** Whether there were some. */
bool Repairer::DropRepeatedVertices(int element, std::vector<int>& vertices)
{
  if (this->Form.Mesh.Element(element).size() < 3)
  {
    return false; // nothing that has an area would be left
  }
  const auto isSame = [this](int a, int b)
  { return this->Form.Original[a] == this->Form.Original[b]; };
  const std::size_t before = vertices.size();
  vertices.erase(std::unique(vertices.begin(), vertices.end(), isSame), vertices.end());
  while (isSame(vertices.front(), vertices.back()))
  {
    vertices.pop_back();
  }
  return vertices.size() < before;
}

void Repairer::ReportMergedVertices()
{
  if (!this->Merges)
  {
    return;
  }
  for (int vertex = 0; vertex < static_cast<int>(this->Form.Original.size()); ++vertex)
  {
    const int original = this->Form.Original[vertex];
    if (original >= 0 && original != vertex)
    {
      this->Add("duplicate-vertices", {}, { original, vertex }, this->Before.Points[vertex],
        [&]
        {
          return "Vertex " + std::to_string(vertex) + " is merged into vertex " +
            std::to_string(original) + ", which is at the same place.";
        });
    }
  }
}

/** Also of the points that merging left without an element. */
void Repairer::RemoveUnused(MeshRepair& result)
{
  const int points = static_cast<int>(result.Mesh.Points.size());
  std::vector<unsigned char> isUsed(static_cast<std::size_t>(points), 0);
  const auto isInRange = [points](int vertex) { return vertex >= 0 && vertex < points; };
  for (const int vertex : result.Mesh.Vertices)
  {
    if (isInRange(vertex))
    {
      isUsed[vertex] = 1;
    }
  }
  std::vector<int> number(static_cast<std::size_t>(points), -1);
  for (int point = 0; point < points; ++point)
  {
    const int original = this->Form.Original[point];
    const bool isCopy = original >= 0 && original != point;
    if (isUsed[point] || !(isCopy ? this->Merges : this->Removes))
    {
      number[point] = static_cast<int>(result.Points.size());
      result.Mesh.Points[result.Points.size()] = this->Before.Points[point];
      result.Points.push_back(point);
    }
    else if (!isCopy)
    {
      this->Add("unused-points", {}, { point }, this->Before.Points[point],
        [&] { return "Point " + std::to_string(point) + " was in no element and is removed."; });
    }
  }
  result.Mesh.Points.resize(result.Points.size());
  for (int& vertex : result.Mesh.Vertices)
  {
    // A number that was out of range stays so: the mesh has not more points than before.
    vertex = isInRange(vertex) ? number[vertex] : vertex;
  }
}

} // namespace

MeshRepair RepairMesh(const PolygonMesh& mesh, const CheckOptions& options)
{
  return Repairer(mesh, options).Repair();
}

} // namespace pemesh
