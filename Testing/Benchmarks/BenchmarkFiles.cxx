// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * How fast meshes are read and written, and how much memory that takes.
 *
 *   BenchmarkFiles [elements = 1e6] [repetitions = 3] [formats = all]
 *
 * The mesh is Voronoi cells of random points. The baseline is the least that an OFF file can cost:
 * its numbers parsed by std::from_chars out of the mapped file, and put by std::to_chars into a
 * buffer that is written at once; nothing is checked. Every measurement is a process of its own;
 * seconds are processor time, the least of the repetitions, and "memory" is what the process takes
 * beyond what it held before, in units of the file plus the mesh.
 */
#include "MeshConversion.h"
#include "MeshFormats.h"
#include "Tessellations.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

namespace
{

namespace fs = std::filesystem;

constexpr double Megabyte = 1024.0 * 1024.0;

struct Result
{
  double Seconds = std::numeric_limits<double>::infinity();
  double Megabytes = 0.0;
};

/** Now, not the most there ever was: the first value of statm is the size, the second what is
 * resident. */
double ResidentMegabytes()
{
  std::ifstream file("/proc/self/statm");
  double pages = 0.0;
  file >> pages >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / Megabyte;
}

double PeakMegabytes()
{
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024.0 / Megabyte;
}

/** Runs the work in processes of their own, one after the other. */
Result RunApart(int repetitions, const std::function<void()>& work)
{
  Result best;
  for (int i = 0; i < repetitions; ++i)
  {
    int ends[2];
    if (pipe(ends) != 0)
    {
      std::perror("pipe");
      std::exit(EXIT_FAILURE);
    }
    std::fflush(stdout);
    if (fork() == 0)
    {
      const double before = ResidentMegabytes();
      const std::clock_t start = std::clock();
      work();
      Result result;
      result.Seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      result.Megabytes = PeakMegabytes() - before;
      const bool written = write(ends[1], &result, sizeof(result)) == sizeof(result);
      _exit(written ? EXIT_SUCCESS : EXIT_FAILURE);
    }
    close(ends[1]);
    Result result;
    if (read(ends[0], &result, sizeof(result)) == sizeof(result) && result.Seconds < best.Seconds)
    {
      best = result;
    }
    close(ends[0]);
    wait(nullptr);
  }
  return best;
}

vtkSmartPointer<vtkPolyData> MakeVoronoi(double elements)
{
  const int kind = pemesh::FindTessellation("voronoi");
  const pemesh::Tessellation& voronoi = pemesh::Tessellations()[static_cast<std::size_t>(kind)];
  pemesh::TessellationInput input;
  input.Values = pemesh::ParameterValues(voronoi.Parameters);
  const std::string why = input.Values.Set("cells", elements);
  const pemesh::TessellationResult result = pemesh::MakeTessellation(voronoi, input);
  if (!why.empty() || result.Status != pemesh::TessellationStatus::Done)
  {
    std::fprintf(stderr, "%s %s\n", why.c_str(), result.Message.c_str());
    std::exit(EXIT_FAILURE);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  pemesh::SetPolygonMesh(mesh, result.Mesh);
  return mesh;
}

/** Coordinates, offsets and connectivity as VTK holds them. */
double MeshMegabytes(vtkPolyData* mesh)
{
  const auto numbers = 3 * mesh->GetNumberOfPoints() + mesh->GetNumberOfPolys() + 1 +
    mesh->GetPolys()->GetNumberOfConnectivityIds();
  return static_cast<double>(numbers) * sizeof(double) / Megabyte;
}

/** The numbers of an OFF file and nothing else. */
void ReadBare(const fs::path& path)
{
  const int file = open(path.c_str(), O_RDONLY);
  struct stat status = {};
  fstat(file, &status);
  const auto size = static_cast<std::size_t>(status.st_size);
  void* memory = mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, file, 0);
  const char* at = static_cast<const char*>(memory) + 3; // behind OFF
  const char* const end = static_cast<const char*>(memory) + size;
  const auto next = [&at, end](auto& value)
  {
    while (at != end && (*at == ' ' || *at == '\n'))
    {
      ++at;
    }
    at = std::from_chars(at, end, value).ptr;
  };
  std::int64_t points = 0;
  std::int64_t faces = 0;
  std::int64_t edges = 0;
  next(points);
  next(faces);
  next(edges);
  std::vector<double> coordinates(static_cast<std::size_t>(3 * points));
  for (double& coordinate : coordinates)
  {
    next(coordinate);
  }
  std::vector<std::int64_t> offsets{ 0 };
  std::vector<std::int64_t> connectivity;
  for (std::int64_t i = 0; i < faces; ++i)
  {
    std::int64_t corners = 0;
    next(corners);
    for (std::int64_t j = 0; j < corners; ++j)
    {
      std::int64_t vertex = 0;
      next(vertex);
      connectivity.push_back(vertex);
    }
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  munmap(memory, size);
  close(file);
}

void WriteBare(const fs::path& path, vtkPolyData* mesh)
{
  constexpr std::size_t longest = 32;
  const vtkIdType points = mesh->GetNumberOfPoints();
  vtkCellArray* cells = mesh->GetPolys();
  std::vector<char> text(static_cast<std::size_t>(
    64 * points + 9 * (cells->GetNumberOfConnectivityIds() + cells->GetNumberOfCells()) + 4096));
  char* at = text.data();
  const auto put = [&at](auto value, char after)
  {
    at = std::to_chars(at, at + longest, value).ptr;
    *at++ = after;
  };
  at = std::copy_n("OFF\n", 4, at);
  put(points, ' ');
  put(cells->GetNumberOfCells(), ' ');
  put(0, '\n');
  const auto* coordinates = static_cast<const double*>(mesh->GetPoints()->GetVoidPointer(0));
  for (vtkIdType i = 0; i < points; ++i)
  {
    put(coordinates[3 * i], ' ');
    put(coordinates[3 * i + 1], ' ');
    put(0, '\n');
  }
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    vtkIdType corners = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(i, corners, ids);
    put(corners, ' ');
    for (vtkIdType j = 0; j < corners; ++j)
    {
      put(ids[j], j + 1 == corners ? '\n' : ' ');
    }
  }
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  const char* from = text.data();
  while (from != at)
  {
    const ssize_t written = write(file, from, static_cast<std::size_t>(at - from));
    if (written <= 0)
    {
      std::perror("write");
      std::exit(EXIT_FAILURE);
    }
    from += written;
  }
  fdatasync(file);
  close(file);
}

double FileMegabytes(const fs::path& folder, const pemesh::MeshFormat& format)
{
  double bytes = 0.0;
  for (const char* extension : format.Extensions)
  {
    bytes += static_cast<double>(fs::file_size(folder / (std::string(format.Name) + extension)));
  }
  return bytes / Megabyte;
}

fs::path FileOf(const fs::path& folder, const pemesh::MeshFormat& format)
{
  return folder / (std::string(format.Name) + format.Extensions.front());
}

/** The formats that the arguments name, or all. */
std::vector<const pemesh::MeshFormat*> ChooseFormats(const std::vector<std::string_view>& names)
{
  std::vector<const pemesh::MeshFormat*> formats;
  for (const pemesh::MeshFormat& format : pemesh::MeshFormats())
  {
    if (names.empty() || std::find(names.begin(), names.end(), format.Name) != names.end())
    {
      formats.push_back(&format);
    }
  }
  return formats;
}

void Print(const char* what, const Result& result, const Result& bare, double space)
{
  std::printf("  %s %6.2f s %5.2f x  memory %4.2f", what, result.Seconds,
    result.Seconds / bare.Seconds, result.Megabytes / space);
}

struct Writing
{
  Result Bare;
  std::vector<Result> Formats;
  double MeshMegabytes = 0.0;
};

Writing MeasureWriting(double elements, int repetitions, const fs::path& folder,
  const std::vector<const pemesh::MeshFormat*>& formats)
{
  const auto mesh = MakeVoronoi(elements);
  std::printf("%lld elements, %lld vertices, %.0f MB as a mesh\n",
    static_cast<long long>(mesh->GetNumberOfPolys()),
    static_cast<long long>(mesh->GetNumberOfPoints()), MeshMegabytes(mesh));
  Writing writing;
  writing.MeshMegabytes = MeshMegabytes(mesh);
  writing.Bare = RunApart(repetitions, [&] { WriteBare(folder / "bare", mesh); });
  for (const pemesh::MeshFormat* format : formats)
  {
    writing.Formats.push_back(
      RunApart(repetitions, [&] { format->Write(FileOf(folder, *format), mesh); }));
  }
  return writing;
}

} // namespace

int main(int count, char** arguments)
{
  const double elements = count > 1 ? std::atof(arguments[1]) : 1e6;
  const int repetitions = count > 2 ? std::atoi(arguments[2]) : 3;
  const auto formats = ChooseFormats({ arguments + std::min(count, 3), arguments + count });
  const fs::path folder = fs::temp_directory_path() / ("pemesh-files-" + std::to_string(getpid()));
  fs::create_directories(folder);
  const Writing writing = MeasureWriting(elements, repetitions, folder, formats);
  // The mesh is gone: what reading takes is what the process grows by.
  const Result bare = RunApart(repetitions, [&] { ReadBare(folder / "bare"); });
  std::printf("%-14s %4.0f MB  read %6.2f s                       write %6.2f s\n", "bare off",
    static_cast<double>(fs::file_size(folder / "bare")) / Megabyte, bare.Seconds,
    writing.Bare.Seconds);
  for (std::size_t i = 0; i < formats.size(); ++i)
  {
    const pemesh::MeshFormat& format = *formats[i];
    const double megabytes = FileMegabytes(folder, format);
    const double space = megabytes + writing.MeshMegabytes;
    const Result reading = RunApart(repetitions, [&] { format.Read(FileOf(folder, format)); });
    std::printf("%-14s %4.0f MB", format.Name, megabytes);
    Print("read", reading, bare, space);
    Print("write", writing.Formats[i], writing.Bare, space);
    std::printf("\n");
  }
  fs::remove_all(folder);
  return EXIT_SUCCESS;
}
