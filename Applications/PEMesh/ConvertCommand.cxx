// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * convert: mesh files into another format.
 */
#include "Commands.h"
#include "MeshFormats.h"
#include "Terminal.h"
#include "TriangulatedMesh.h"
#include "vtkPEMMeshReader.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

namespace fs = std::filesystem;

struct ConvertArguments
{
  std::vector<std::string> Meshes;
  std::string Output;
  std::string Format;
  bool AsStored = false;
  bool Triangulate = false;
};

/** One mesh to be read and the file that it becomes. */
struct Conversion
{
  fs::path From;
  fs::path To;
};

std::string CountText(vtkIdType count, const char* one, const char* many)
{
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

bool HasExtensionOf(const fs::path& file, const MeshFormat& format)
{
  const MeshFormat* found = FindMeshFormatOfFile(file);
  return found && std::string(found->Extensions.front()) == format.Extensions.front();
}

/** Whether the output names a file, not a folder; throws where neither makes sense. */
bool IsOneFile(const ConvertArguments& arguments)
{
  const fs::path output = arguments.Output;
  if (arguments.Meshes.size() == 1 && FindMeshFormatOfFile(output) && !fs::is_directory(output))
  {
    return true;
  }
  if (arguments.Format.empty())
  {
    throw std::runtime_error(arguments.Meshes.size() == 1
        ? "\"" + arguments.Output + "\" is no mesh file, whose endings are " +
          ListMeshExtensions() + "; for a folder give a format with --to."
        : "Several meshes go to a folder, and need a format: --to NAME (see pemesh list formats).");
  }
  if (fs::exists(output) && !fs::is_directory(output))
  {
    throw std::runtime_error("\"" + arguments.Output + "\" is a file, not a folder.");
  }
  return false;
}

const MeshFormat& FormatOf(const ConvertArguments& arguments, bool isOneFile)
{
  const MeshFormat* ofFile = isOneFile ? FindMeshFormatOfFile(arguments.Output) : nullptr;
  const MeshFormat& format = arguments.Format.empty() ? *ofFile : *FindMeshFormat(arguments.Format);
  if (isOneFile && !HasExtensionOf(arguments.Output, format))
  {
    throw std::runtime_error("\"" + arguments.Output + "\" does not end as files of the format " +
      format.Name + " do: " + format.Extensions.front() + ".");
  }
  return format;
}

fs::path PlaceOf(const fs::path& file)
{
  std::error_code error;
  return fs::weakly_canonical(fs::absolute(file), error);
}

/** NODE and ELE are a pair, whichever is named: the endings say nothing more. */
bool WouldWriteOver(const fs::path& to, const fs::path& from, const MeshFormat& format)
{
  return HasExtensionOf(from, format) &&
    PlaceOf(to).replace_extension() == PlaceOf(from).replace_extension();
}

std::vector<Conversion> PlanConversions(
  const ConvertArguments& arguments, bool isOneFile, const MeshFormat& format)
{
  vtkNew<vtkPEMMeshReader> names; // for names that are unique
  names->SetFileNames(arguments.Meshes);
  std::vector<Conversion> conversions;
  for (std::size_t i = 0; i < arguments.Meshes.size(); ++i)
  {
    const std::string name = names->GetMeshName(static_cast<int>(i));
    const fs::path to = isOneFile ? fs::path(arguments.Output)
                                  : fs::path(arguments.Output) / (name + format.Extensions.front());
    for (const std::string& mesh : arguments.Meshes)
    {
      if (WouldWriteOver(to, mesh, format))
      {
        throw std::runtime_error(
          "\"" + mesh + "\" would be written over; give another place with -o.");
      }
    }
    conversions.push_back({ arguments.Meshes[i], to });
  }
  return conversions;
}

/** What the file does not hold of the mesh, or "". */
std::string DescribeLoss(const MeshFormat& format, vtkPolyData* mesh)
{
  std::string text;
  if (const vtkIdType cut = CountElementsToCut(format, mesh))
  {
    text += "; " + std::string(format.Name) + " holds " +
      (format.MostCorners == 3 ? "triangles" : "triangles and quadrilaterals") +
      " only: " + CountText(cut, "larger element is", "larger elements are") +
      " cut into triangles";
  }
  const int arrays = mesh->GetPointData()->GetNumberOfArrays() +
    mesh->GetCellData()->GetNumberOfArrays() + mesh->GetFieldData()->GetNumberOfArrays();
  if (arrays > 0 && !format.KeepsArrays)
  {
    text += "; " + CountText(arrays, "array is", "arrays are") + " left out";
  }
  return text;
}

void ConvertOne(
  const Conversion& conversion, const MeshFormat& format, const ConvertArguments& arguments)
{
  auto mesh = ReadMesh(conversion.From,
    arguments.AsStored ? ElementOrientation::AsStored : ElementOrientation::CounterClockwise);
  if (arguments.Triangulate)
  {
    mesh = TriangulateMesh(mesh);
  }
  format.Write(conversion.To, mesh);
  std::cout << conversion.To.string() << ": "
            << CountText(mesh->GetNumberOfPolys(), "element", "elements") << ", "
            << CountText(mesh->GetNumberOfPoints(), "vertex", "vertices")
            << DescribeLoss(format, mesh) << "\n";
}

int Convert(const ConvertArguments& arguments)
{
  const bool isOneFile = IsOneFile(arguments);
  const MeshFormat& format = FormatOf(arguments, isOneFile);
  int exitCode = AllDone;
  for (const Conversion& conversion : PlanConversions(arguments, isOneFile, format))
  {
    try
    {
      ConvertOne(conversion, format, arguments);
    }
    catch (const std::exception& error)
    {
      Complain(error.what());
      exitCode = PartFailed;
    }
  }
  return exitCode;
}

} // namespace

void AddConvertCommand(CLI::App& program, int& exitCode)
{
  auto arguments = std::make_shared<ConvertArguments>();
  CLI::App* command = program.add_subcommand("convert", "Convert mesh files into another format");
  command->add_option("MESH", arguments->Meshes, "Mesh files")->required();
  command
    ->add_option("-o,--output", arguments->Output,
      "The file, whose ending names the format, or with --to a folder, made where it is missing")
    ->required();
  command
    ->add_option("--to", arguments->Format, "Format (see pemesh list formats); needed for a folder")
    ->check(CLI::IsMember(MeshFormatNames()));
  command->add_flag("--as-stored", arguments->AsStored,
    "Leave elements that are clockwise as they are (default: they are reversed)");
  command->add_flag("--triangulate", arguments->Triangulate,
    "Cut elements into triangles, for programs that draw concave ones wrongly; the array "
    "OriginalElement names the element of each");
  command->callback([arguments, &exitCode] { exitCode = Convert(*arguments); });
}

} // namespace pemesh
