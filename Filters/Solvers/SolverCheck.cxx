// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverCheck.h"

#include "CaseStatus.h"
#include "SolverCommand.h"
#include "SolverRun.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace pemesh
{

namespace
{

constexpr std::size_t Vertices = 11;

/** The vertex that stands at a place of the second numbering, and the other way round. */
std::size_t Renumbered(std::size_t vertex)
{
  return Vertices - 1 - vertex;
}

vtkSmartPointer<vtkPolyData> MakeMesh(bool isRenumbered)
{
  using Point = std::array<double, 2>;
  const std::array<Point, Vertices> points{ { { 0, 0 }, { .5, 0 }, { 1, 0 }, { 0, .5 }, { .5, .4 },
    { 1, .5 }, { 0, 1 }, { .5, 1 }, { 1, 1 }, { .3, .7 }, { .25, 0 } } };
  const std::vector<std::vector<std::size_t>> elements{ { 0, 10, 1, 4, 3 }, { 1, 2, 5, 4 },
    { 4, 5, 8 }, { 4, 8, 7 }, { 3, 4, 9 }, { 4, 7, 9 }, { 7, 6, 9 }, { 6, 3, 9 } };
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataTypeToDouble();
  for (std::size_t i = 0; i < Vertices; ++i)
  {
    const Point& point = points[isRenumbered ? Renumbered(i) : i];
    coordinates->InsertNextPoint(point[0], point[1], 0.0);
  }
  vtkNew<vtkCellArray> cells;
  for (const std::vector<std::size_t>& element : elements)
  {
    cells->InsertNextCell(static_cast<int>(element.size()));
    for (const std::size_t vertex : element)
    {
      cells->InsertCellPoint(static_cast<vtkIdType>(isRenumbered ? Renumbered(vertex) : vertex));
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(coordinates);
  mesh->SetPolys(cells);
  SetFieldText(mesh, MeshNameField, isRenumbered ? "check-renumbered" : "check");
  return mesh;
}

/** What can be said without running anything. */
void CheckCommand(const SolverDescription& description, std::vector<SolverFinding>& findings)
{
  const auto names = [&](const char* placeholder)
  {
    return std::any_of(description.Command.begin(), description.Command.end(),
      [=](const std::string& argument) { return argument.find(placeholder) != std::string::npos; });
  };
  if (!names("{mesh}") && !names("{node}") && !names("{stem}") && !TakesList(description))
  {
    findings.push_back({ false,
      "The command has neither {mesh} nor {stem} nor {list}: the solver is not told what to solve "
      "on." });
  }
  if (description.Performances.empty())
  {
    findings.push_back({ false,
      "The description names no performances, so that studies have nothing to compare but the "
      "solution." });
  }
  if (description.VersionCommand.empty())
  {
    findings.push_back({ false,
      "The description has no version-command: results will not say which version made them, nor "
      "will --resume see a new one." });
  }
}

void KeepOutcome(const SolverOutcome& outcome, std::vector<SolverFinding>& findings)
{
  const std::vector<std::string>& faults = outcome.Answer.Faults;
  if (outcome.Status != "ok" && faults.empty())
  {
    findings.push_back({ true, outcome.Message });
  }
  for (const std::string& fault : faults)
  {
    findings.push_back({ true, fault });
  }
  if (!outcome.Hint.empty())
  {
    findings.push_back({ !faults.empty(), outcome.Hint });
  }
}

/** By how much two solutions of one problem differ, over the size of the first; 1 if it is 0. */
double Difference(vtkDoubleArray* first, vtkDoubleArray* renumbered)
{
  double largest = 0.0;
  double difference = 0.0;
  for (std::size_t i = 0; i < Vertices; ++i)
  {
    const double value = first->GetValue(static_cast<vtkIdType>(i));
    const double other = renumbered->GetValue(static_cast<vtkIdType>(Renumbered(i)));
    largest = std::max(largest, std::abs(value));
    difference = std::max(difference, std::abs(value - other));
  }
  return largest > 0.0 ? difference / largest : 1.0;
}

void CompareOrders(
  const SolverAnswer& first, const SolverAnswer& renumbered, std::vector<SolverFinding>& findings)
{
  double range[2];
  first.Solution->GetRange(range);
  if (range[0] == range[1])
  {
    findings.push_back(
      { false, "The solution is the same at all vertices, which few problems have." });
    return;
  }
  constexpr double tolerance = 1e-6; // of an iterative solver, amply
  if (Difference(first.Solution, renumbered.Solution) > tolerance)
  {
    findings.push_back({ true,
      "The solution changes with the numbering of the vertices: it must be written in the order "
      "of the vertices of the mesh file." });
  }
}

} // namespace

std::vector<SolverFinding> CheckSolver(const SolverDescription& description,
  const std::map<std::string, std::string>& options, const std::filesystem::path& folder)
{
  std::vector<SolverFinding> findings;
  SolverRun run;
  run.Description = description;
  run.WorkDirectory = folder;
  for (const SolverOption& option : description.Options)
  {
    run.Options[option.Name] = option.Default;
  }
  for (const auto& [name, value] : options)
  {
    run.Options[name] = value;
  }
  try
  {
    CheckSolverRun(run);
    CheckCommand(description, findings);
    const SolverOutcome first = RunSolver(run, MakeMesh(false));
    KeepOutcome(first, findings);
    if (first.Status == "ok")
    {
      const SolverOutcome renumbered = RunSolver(run, MakeMesh(true));
      if (renumbered.Status == "ok")
      {
        CompareOrders(first.Answer, renumbered.Answer, findings);
      }
      else
      {
        findings.push_back({ true, "A second mesh was not solved: " + renumbered.Message });
      }
    }
  }
  catch (const std::exception& error)
  {
    findings.push_back({ true, error.what() });
  }
  std::stable_sort(findings.begin(), findings.end(),
    [](const SolverFinding& a, const SolverFinding& b) { return a.IsError && !b.IsError; });
  return findings;
}

} // namespace pemesh
