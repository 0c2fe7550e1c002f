// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * How fast meshes are checked, good and broken ones.
 *
 *   BenchmarkCheck [largest number of elements = 1e6]
 *
 * One line a mesh: elements, seconds by the clock and of all processors, findings, peak memory of a
 * process that made the mesh and checked it, and how much of that the mesh alone takes.
 */
#include "MeshChecks.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>

namespace
{

using pemesh::RawMesh;

/** Triangles of a grid with moved vertices. */
RawMesh MakeTriangles(double elements)
{
  const int n = static_cast<int>(std::sqrt(elements / 2.0));
  std::mt19937_64 bits(1);
  const auto random = [&bits] { return static_cast<double>(bits() >> 11) * 0x1p-53 - 0.5; };
  RawMesh raw;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const bool isInside = i > 0 && i < n && j > 0 && j < n;
      const double by = isInside ? 0.5 : 0.0;
      raw.Mesh.Points.push_back({ (i + by * random()) / n, (j + by * random()) / n });
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const int a = j * (n + 1) + i;
      raw.Mesh.AddElement(std::initializer_list<int>{ a, a + 1, a + n + 2 });
      raw.Mesh.AddElement(std::initializer_list<int>{ a, a + n + 2, a + n + 1 });
    }
  }
  return raw;
}

/** Concave octagons, teeth against teeth. */
RawMesh MakeConcave(double elements)
{
  const int n = static_cast<int>(std::sqrt(elements));
  RawMesh raw;
  const int width = 3 * n + 1;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      const double tooth = j == 0 || j == n ? 0.0 : i % 3 == 1 ? 0.4 : i % 3 == 2 ? -0.4 : 0.0;
      raw.Mesh.Points.push_back({ i / 3.0, j + tooth });
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const int a = j * width + 3 * i;
      const int b = a + width;
      raw.Mesh.AddElement(
        std::initializer_list<int>{ a, a + 1, a + 2, a + 3, b + 3, b + 2, b + 1, b });
    }
  }
  return raw;
}

/** Every triangle with vertices of its own. */
RawMesh MakeSoup(double elements)
{
  const RawMesh whole = MakeTriangles(elements);
  RawMesh raw;
  for (const int vertex : whole.Mesh.Vertices)
  {
    raw.Mesh.Points.push_back(whole.Mesh.Points[vertex]);
    raw.Mesh.Vertices.push_back(static_cast<int>(raw.Mesh.Vertices.size()));
  }
  raw.Mesh.Offsets = whole.Mesh.Offsets;
  return raw;
}

/** Vertices moved so far that many triangles turn over and overlap. */
RawMesh MakeTangled(double elements)
{
  RawMesh raw = MakeTriangles(elements);
  std::mt19937_64 bits(2);
  const double step = 2.0 / std::sqrt(elements);
  for (std::size_t i = 0; i < raw.Mesh.Points.size(); i += 5)
  {
    raw.Mesh.Points[i].x += step * (static_cast<double>(bits() >> 11) * 0x1p-53 - 0.5);
  }
  return raw;
}

double PeakMegabytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void Measure(const char* name, const RawMesh& raw)
{
  const double before = PeakMegabytes();
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t processorStart = std::clock();
  const pemesh::MeshReport report = pemesh::CheckMesh(raw, {});
  const double processor = static_cast<double>(std::clock() - processorStart) / CLOCKS_PER_SEC;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::printf("%-10s %9d elements %7.2f s (%.2f s of processors) %9lld errors %7lld warnings %6.0f "
              "MB (mesh %.0f MB)\n",
    name, raw.Mesh.NumberOfElements(), seconds.count(), processor,
    static_cast<long long>(report.GetCount(pemesh::CheckSeverity::Error)),
    static_cast<long long>(report.GetCount(pemesh::CheckSeverity::Warning)), PeakMegabytes(),
    before);
  std::fflush(stdout);
}

struct Sample
{
  const char* Name;
  RawMesh (*Make)(double elements);
};

constexpr Sample Samples[] = { { "triangles", MakeTriangles }, { "concave", MakeConcave },
  { "soup", MakeSoup }, { "tangled", MakeTangled } };

} // namespace

int main(int argc, char** argv)
{
  const double largest = argc > 1 ? std::atof(argv[1]) : 1e6;
  for (double elements = 1e5; elements <= largest; elements *= 10.0)
  {
    for (const Sample& sample : Samples)
    {
      const pid_t child = fork(); // so that the peak of one is not that of another
      if (child == 0)
      {
        Measure(sample.Name, sample.Make(elements));
        std::_Exit(0);
      }
      waitpid(child, nullptr, 0);
    }
  }
  return 0;
}
