// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Any bytes as a mesh file: each is read as a mesh that can be used, written and read again, or is
 * refused with a std::runtime_error. libFuzzer looks for the bytes that make something else happen.
 *
 *   FuzzMeshFormats --format=NAME [--seeds=FOLDER] FOLDER [options of libFuzzer]
 *
 * Of a pair of files (NODE and ELE) the first byte 0 ends the one and begins the other. With
 * --seeds small meshes are written to the folder first.
 */
#include "ElementAccess.h"
#include "MeshFormats.h"
#include "TextFile.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

#include <unistd.h>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace
{

namespace fs = std::filesystem;

const pemesh::MeshFormat* Format = nullptr;

/** In memory, where the system has such a place; one for each process. */
fs::path Folder()
{
  const fs::path memory = "/dev/shm";
  const fs::path base = fs::exists(memory) ? memory : fs::temp_directory_path();
  return base / ("pemesh-fuzz-" + std::to_string(getpid()));
}

/** n squares in a row, each with a vertex in the middle of its lower side. */
vtkSmartPointer<vtkPolyData> MakeRow(int n)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, 1.0, 0.0);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const double x = static_cast<double>(i);
    points->InsertNextPoint(x + 0.1, -0.25, 0.0);
    points->InsertNextPoint(x + 1.0, 0.0, 0.0);
    points->InsertNextPoint(x + 1.0, 1.0, 0.0);
    const vtkIdType left = i == 0 ? 0 : 3 * i;
    const vtkIdType polygon[] = { left, 3 * i + 2, 3 * i + 3, 3 * i + 4, left + 1 };
    polygons->InsertNextCell(5, polygon);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polygons);
  return mesh;
}

bool IsPair()
{
  return Format->Extensions.size() > 1;
}

fs::path FileOf(std::size_t extension)
{
  return (Folder() / "mesh") += Format->Extensions[extension];
}

void WriteBytes(const fs::path& path, std::string_view bytes)
{
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file || std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size())
  {
    std::abort();
  }
  std::fclose(file);
}

void WriteSeeds(const fs::path& folder)
{
  fs::create_directories(folder);
  for (const int n : { 1, 3 })
  {
    Format->Write(FileOf(0), MakeRow(n));
    std::string bytes = pemesh::ReadTextFile(FileOf(0));
    if (IsPair())
    {
      bytes += '\0' + pemesh::ReadTextFile(FileOf(1));
    }
    WriteBytes(folder / ("row" + std::to_string(n)), bytes);
  }
}

std::string ValueOf(std::string_view argument, std::string_view option)
{
  return argument.substr(0, option.size()) == option ? std::string(argument.substr(option.size()))
                                                     : std::string();
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv)
{
  vtkObject::GlobalWarningDisplayOff();
  fs::create_directories(Folder());
  std::atexit([] { fs::remove_all(Folder()); });
  std::string seeds;
  for (int i = 1; i < *argc; ++i)
  {
    if (const std::string name = ValueOf((*argv)[i], "--format="); !name.empty())
    {
      Format = pemesh::FindMeshFormat(name);
    }
    if (const std::string folder = ValueOf((*argv)[i], "--seeds="); !folder.empty())
    {
      seeds = folder;
    }
  }
  if (!Format)
  {
    std::fputs("FuzzMeshFormats: --format=NAME is missing or no name of a format.\n", stderr);
    std::exit(2);
  }
  if (!seeds.empty())
  {
    WriteSeeds(seeds);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t end = IsPair() ? bytes.find('\0') : std::string_view::npos;
  WriteBytes(FileOf(0), bytes.substr(0, end));
  if (IsPair())
  {
    WriteBytes(
      FileOf(1), end == std::string_view::npos ? std::string_view() : bytes.substr(end + 1));
  }
  vtkSmartPointer<vtkPolyData> mesh;
  try
  {
    mesh = pemesh::ReadMesh(FileOf(0));
  }
  catch (const std::runtime_error&)
  {
    return 0;
  }
  if (mesh->GetNumberOfCells() > 0)
  {
    if (!pemesh::ElementAccess::WhyUnusable(mesh).empty())
    {
      std::abort();
    }
    Format->Write(FileOf(0), mesh); // what was read can be written
  }
  return 0;
}
