// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * check: what is wrong with mesh files, and where.
 */
#include "CaseStatus.h"
#include "Commands.h"
#include "CsvTable.h"
#include "MeshChecks.h"
#include "MeshFormats.h"
#include "NumberText.h"
#include "Terminal.h"
#include "vtkPEMDomain.h"
#include "vtkPEMMeshCheck.h"
#include "vtkPEMMeshReader.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

namespace pemesh
{

namespace
{

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct CheckArguments
{
  std::vector<std::string> Meshes;
  std::string Output;
  std::vector<std::string> Only;
  std::string Domain;
  double Tolerance = 1e-12;
  double SliverThickness = 1e-6;
  int Examples = 3;
  bool Repair = false;
  bool AsJson = false;
};

std::string CountText(vtkIdType count, const std::string& one, const std::string& many)
{
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/** The files written for one mesh, in the folder asked for. */
struct OutputFiles
{
  fs::path Findings;
  fs::path Faults;
  fs::path Repaired;
};

OutputFiles FilesOf(
  const CheckArguments& arguments, const std::string& mesh, const std::string& name)
{
  const fs::path folder = arguments.Output;
  return { folder / (name + "-findings.csv"), folder / (name + "-faults.vtp"),
    folder / (name + fs::path(mesh).extension().string()) };
}

bool IsSameFile(const fs::path& a, const fs::path& b)
{
  std::error_code error;
  // Made absolute first: of what is not there weakly_canonical leaves a relative path as it is.
  return fs::weakly_canonical(fs::absolute(a), error) ==
    fs::weakly_canonical(fs::absolute(b), error);
}

/** Throws where the arguments make no sense, before anything is written. */
void CheckTheArguments(const CheckArguments& arguments, vtkPEMMeshReader* names)
{
  for (const std::string& name : arguments.Only)
  {
    if (!FindMeshCheck(name))
    {
      throw std::runtime_error(DescribeUnknownMeshCheck(name));
    }
  }
  if (arguments.Repair && arguments.Output.empty())
  {
    throw std::runtime_error("--repair needs a folder for the repaired meshes: -o DIR.");
  }
  for (std::size_t i = 0; arguments.Repair && i < arguments.Meshes.size(); ++i)
  {
    const OutputFiles files =
      FilesOf(arguments, arguments.Meshes[i], names->GetMeshName(static_cast<int>(i)));
    for (const std::string& mesh : arguments.Meshes)
    {
      // NODE and ELE are a pair: whichever is named, both are written.
      if (IsSameFile(
            fs::path(mesh).replace_extension(), fs::path(files.Repaired).replace_extension()))
      {
        throw std::runtime_error("\"" + mesh +
          "\" would be written over; give another folder with -o for the repaired meshes.");
      }
    }
  }
}

vtkSmartPointer<vtkPolyData> ReadDomain(const std::string& file)
{
  vtkNew<vtkPEMDomain> domain;
  domain->SetShapeByName("file");
  domain->SetFileName(file);
  domain->Update();
  if (IsCaseFailed(domain->GetOutput()))
  {
    throw std::runtime_error(GetCaseStatusMessage(domain->GetOutput()));
  }
  return domain->GetOutput();
}

vtkSmartPointer<vtkPEMMeshCheck> MakeFilter(const CheckArguments& arguments)
{
  auto check = vtkSmartPointer<vtkPEMMeshCheck>::New();
  if (!arguments.Only.empty())
  {
    check->SetChecks(arguments.Only);
  }
  check->SetRepair(arguments.Repair);
  check->SetTolerance(arguments.Tolerance);
  check->SetSliverThickness(arguments.SliverThickness);
  if (!arguments.Domain.empty())
  {
    check->SetInputData(1, ReadDomain(arguments.Domain));
  }
  return check;
}

vtkTable* TableOf(vtkPEMMeshCheck* check)
{
  return vtkTable::SafeDownCast(check->GetOutputDataObject(2));
}

void WriteFiles(const OutputFiles& files, bool repaired, vtkPEMMeshCheck* check)
{
  WriteCsvFile(files.Findings, TableOf(check));
  auto* faulty = vtkPolyData::SafeDownCast(check->GetOutputDataObject(1));
  fs::remove(files.Faults); // of an earlier run
  if (faulty->GetNumberOfCells() > 0)
  {
    WriteMesh(files.Faults, faulty);
  }
  if (repaired)
  {
    vtkNew<vtkPolyData> mesh;
    mesh->ShallowCopy(check->GetOutput());
    mesh->GetCellData()->RemoveArray("Faults");
    WriteMesh(files.Repaired, mesh);
  }
}

std::string Summary(vtkPEMMeshCheck* check)
{
  const vtkIdType errors = check->GetNumberOfErrors();
  const vtkIdType warnings = check->GetNumberOfWarnings();
  std::string text = errors == 0 ? "OK" : CountText(errors, "error", "errors");
  text += warnings == 0 ? "" : ", " + CountText(warnings, "warning", "warnings");
  if (check->GetRepair() && check->GetNumberOfRepairs() > 0)
  {
    text += ", " + CountText(check->GetNumberOfRepairs(), "repair", "repairs");
  }
  vtkPolyData* mesh = check->GetOutput();
  text += " (" + CountText(mesh->GetNumberOfPolys(), "element", "elements") + ", " +
    CountText(mesh->GetNumberOfPoints(), "vertex", "vertices");
  if (check->GetNumberOfHoles() > 0)
  {
    text += ", " + CountText(check->GetNumberOfHoles(), "hole", "holes");
  }
  return text + ")";
}

/** A line for each check that found or repaired something, and the first sentences of it. */
void PrintFindings(vtkPEMMeshCheck* check, int examples)
{
  vtkTable* table = TableOf(check);
  std::string heading;
  int printed = 0;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const std::string name = table->GetValueByName(row, "Check").ToString();
    const std::string severity = table->GetValueByName(row, "Severity").ToString();
    if (severity + name != heading)
    {
      heading = severity + name;
      printed = 0;
      const vtkIdType count =
        severity == "repaired" ? check->GetNumberOfRepairs(name) : check->GetNumberOfFindings(name);
      std::cout << "  " << severity << " " << name << ": " << count << "\n";
    }
    if (++printed <= examples)
    {
      std::cout << "    " << table->GetValueByName(row, "Message").ToString() << " ("
                << FormatNumber(table->GetValueByName(row, "x").ToDouble()) << ", "
                << FormatNumber(table->GetValueByName(row, "y").ToDouble()) << ")\n";
    }
  }
}

/** A number, or null where JSON has none. */
Json NumberAsJson(double value)
{
  return std::isfinite(value) ? Json(value) : Json();
}

Json FindingsAsJson(vtkTable* table)
{
  Json list = Json::array();
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    list.push_back({ { "check", table->GetValueByName(row, "Check").ToString() },
      { "severity", table->GetValueByName(row, "Severity").ToString() },
      { "element", table->GetValueByName(row, "Element").ToTypeInt64() },
      { "vertex", table->GetValueByName(row, "Vertex").ToTypeInt64() },
      { "x", NumberAsJson(table->GetValueByName(row, "x").ToDouble()) },
      { "y", NumberAsJson(table->GetValueByName(row, "y").ToDouble()) },
      { "message", table->GetValueByName(row, "Message").ToString() } });
  }
  return list;
}

Json MeshAsJson(const std::string& mesh, vtkPEMMeshCheck* check)
{
  Json counts = Json::object();
  for (const std::string& name : check->GetChecks())
  {
    counts[name] = check->GetNumberOfFindings(name);
  }
  return { { "mesh", mesh }, { "ok", check->GetNumberOfErrors() == 0 },
    { "elements", check->GetOutput()->GetNumberOfPolys() },
    { "vertices", check->GetOutput()->GetNumberOfPoints() },
    { "errors", check->GetNumberOfErrors() }, { "warnings", check->GetNumberOfWarnings() },
    { "repairs", check->GetNumberOfRepairs() }, { "components", check->GetNumberOfComponents() },
    { "holes", check->GetNumberOfHoles() }, { "counts", counts },
    { "findings", FindingsAsJson(TableOf(check)) } };
}

/** Whether the mesh has no errors; throws where a file cannot be read or written. */
bool CheckOne(const CheckArguments& arguments, const std::string& mesh, const std::string& name,
  vtkPEMMeshCheck* check, Json& list)
{
  check->SetInputData(0, ReadMesh(mesh, ElementOrientation::AsStored));
  check->Update();
  if (IsCaseFailed(check->GetOutput()))
  {
    throw std::runtime_error(mesh + ": " + GetCaseStatusMessage(check->GetOutput()));
  }
  if (!arguments.Output.empty())
  {
    WriteFiles(FilesOf(arguments, mesh, name), arguments.Repair, check);
  }
  if (arguments.AsJson)
  {
    list.push_back(MeshAsJson(mesh, check));
  }
  else
  {
    std::cout << mesh << ": " << Summary(check) << "\n";
    PrintFindings(check, arguments.Examples);
  }
  return check->GetNumberOfErrors() == 0;
}

int Check(const CheckArguments& arguments)
{
  vtkNew<vtkPEMMeshReader> names; // for names that are unique
  names->SetFileNames(arguments.Meshes);
  CheckTheArguments(arguments, names);
  const auto check = MakeFilter(arguments);
  Json list = Json::array();
  bool allGood = true;
  for (std::size_t i = 0; i < arguments.Meshes.size(); ++i)
  {
    const std::string& mesh = arguments.Meshes[i];
    try
    {
      const std::string name = names->GetMeshName(static_cast<int>(i));
      allGood = CheckOne(arguments, mesh, name, check, list) && allGood;
    }
    catch (const std::exception& error)
    {
      Complain(error.what());
      list.push_back({ { "mesh", mesh }, { "ok", false }, { "message", error.what() } });
      allGood = false;
    }
  }
  if (arguments.AsJson)
  {
    std::cout << list.dump(2) << "\n";
  }
  return allGood ? AllDone : PartFailed;
}

} // namespace

void AddCheckCommand(CLI::App& program, int& exitCode)
{
  auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command = program.add_subcommand(
    "check", "Check mesh files: what is wrong, and where (exit code 1 if there are errors)");
  command->add_option("MESH", arguments->Meshes, "Mesh files")->required();
  command->add_option("-o,--output", arguments->Output,
    "Folder for the findings (CSV), the faulty elements (VTP) and the repaired meshes");
  command
    ->add_option("--only", arguments->Only,
      "Names of checks, with commas (default: all; see pemesh list checks)")
    ->delimiter(',');
  command->add_flag("--repair", arguments->Repair,
    "Turn clockwise elements round, merge equal vertices, drop repeated ones, remove unused "
    "points; the meshes go to the folder, in the format they have");
  command->add_option("--domain", arguments->Domain,
    "Mesh file or table of points whose polygons are the loops of the domain to cover");
  command
    ->add_option("--tolerance", arguments->Tolerance,
      "What counts as rounding, relative to the diagonal of the mesh")
    ->capture_default_str()
    ->check(CLI::Range(0.0, 1.0));
  command
    ->add_option("--sliver", arguments->SliverThickness,
      "Elements are slivers if twice their area is less than this times their diameter squared")
    ->capture_default_str()
    ->check(CLI::Range(0.0, 1.0));
  command->add_option("--examples", arguments->Examples, "Sentences printed for each check")
    ->capture_default_str()
    ->check(CLI::Range(0, 100));
  command->add_flag("--json", arguments->AsJson, "As JSON");
  command->callback([arguments, &exitCode] { exitCode = Check(*arguments); });
}

} // namespace pemesh
