// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SampleMeshes.h"

#include "MeshConversion.h"
#include "PolygonFamilies.h"
#include "vtkPEMDomainMesher.h"
#include "vtkPEMPolygonLayout.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <random>

namespace pemesh
{

namespace
{

class Random
{
public:
  explicit Random(std::uint64_t seed)
    : Engine(seed)
  {
  }
  double Uniform() { return static_cast<double>(this->Engine() >> 11) * 0x1p-53; }
  int Below(int count) { return static_cast<int>(this->Uniform() * count); }

private:
  std::mt19937_64 Engine;
};

/** Points (i, j) with inner ones moved by up to 0.2. */
void AddJitteredPoints(int columns, int rows, Random& random, PolygonMesh& mesh)
{
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i <= columns; ++i)
    {
      const bool inside = i > 0 && i < columns && j > 0 && j < rows;
      const double dx = inside ? 0.4 * (random.Uniform() - 0.5) : 0.0;
      const double dy = inside ? 0.4 * (random.Uniform() - 0.5) : 0.0;
      mesh.Points.push_back({ i + dx, j + dy });
    }
  }
}

struct Placement
{
  int Family;
  double X, Y, Scale, Rotation;
};

void Place(const std::vector<Placement>& polygons, vtkPEMPolygonLayout* layout)
{
  layout->RemoveAllPolygons();
  for (const Placement& polygon : polygons)
  {
    const int index = layout->AddPolygon(
      PolygonFamilies()[static_cast<std::size_t>(polygon.Family)].Name, polygon.X, polygon.Y);
    layout->SetPolygonScale(index, polygon.Scale);
    layout->SetPolygonRotation(index, polygon.Rotation);
  }
}

} // namespace

PolygonMesh TriangleGrid(int columns, int rows, std::uint64_t seed)
{
  Random random(seed);
  PolygonMesh mesh;
  AddJitteredPoints(columns, rows, random, mesh);
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const int a = j * (columns + 1) + i;
      const int c = a + columns + 2;
      mesh.AddElement(std::vector<int>{ a, a + 1, c });
      mesh.AddElement(std::vector<int>{ a, c, c - 1 });
    }
  }
  return mesh;
}

PolygonMesh BrickWall(int columns, int rows, std::uint64_t seed)
{
  Random random(seed);
  PolygonMesh mesh;
  AddJitteredPoints(2 * columns, rows, random, mesh);
  const auto point = [columns](int i, int j) { return j * (2 * columns + 1) + i; };
  for (int j = 0; j < rows; ++j)
  {
    // Every other row starts with half a brick.
    for (int i = j % 2 == 0 ? 0 : -1; i < 2 * columns; i += 2)
    {
      const int from = std::max(i, 0);
      const int to = std::min(i + 2, 2 * columns);
      std::vector<int> brick;
      for (int k = from; k <= to; ++k)
      {
        brick.push_back(point(k, j));
      }
      for (int k = to; k >= from; --k)
      {
        brick.push_back(point(k, j + 1));
      }
      mesh.AddElement(brick);
    }
  }
  return mesh;
}

PolygonMesh TriangleFrame(int size, std::uint64_t seed)
{
  const PolygonMesh whole = TriangleGrid(size, size, seed);
  PolygonMesh frame;
  frame.Points = whole.Points;
  for (int element = 0; element < whole.NumberOfElements(); ++element)
  {
    const int i = element / 2 % size;
    const int j = element / 2 / size;
    const bool inHole = 3 * i >= size && 3 * i < 2 * size && 3 * j >= size && 3 * j < 2 * size;
    if (!inHole)
    {
      frame.AddElement(whole.Element(element));
    }
  }
  RemoveUnusedPoints(frame);
  return frame;
}

SampleMesh MeshOfRandomLayout(std::uint64_t seed)
{
  Random random(seed);
  // Fixed polygons have no vertices of their own; their families come last.
  const auto families = static_cast<int>(std::count_if(PolygonFamilies().begin(),
    PolygonFamilies().end(), [](const PolygonFamily& family) { return !family.IsFixed(); }));
  vtkNew<vtkPEMPolygonLayout> layout;
  const double time = 0.95 * random.Uniform();
  std::vector<Placement> polygons;
  for (int trial = 0; trial < 20 && polygons.size() < 3; ++trial)
  {
    polygons.push_back({ random.Below(families), 0.1 + 0.8 * random.Uniform(),
      0.1 + 0.8 * random.Uniform(), 0.3 + 0.7 * random.Uniform(), 360.0 * random.Uniform() });
    Place(polygons, layout);
    if (!layout->FindFault(time).empty())
    {
      polygons.pop_back();
      Place(polygons, layout);
    }
  }
  vtkNew<vtkPEMDomainMesher> mesher;
  mesher->SetInputConnection(layout->GetOutputPort());
  mesher->UpdateTimeStep(time);
  SampleMesh sample{ "layout " + std::to_string(seed), ToPolygonMesh(mesher->GetOutput()), {} };
  vtkDataArray* ids = mesher->GetOutput()->GetCellData()->GetArray(PolygonIdArray);
  for (int element = 0; element < sample.Mesh.NumberOfElements(); ++element)
  {
    sample.Placed.push_back(ids->GetTuple1(element) >= 0.0);
  }
  return sample;
}

std::vector<SampleMesh> SampleMeshes()
{
  std::vector<SampleMesh> samples = {
    { "triangles", TriangleGrid(12, 9, 1), {} },
    { "bricks", BrickWall(8, 11, 2), {} },
    { "frame", TriangleFrame(12, 3), {} },
    { "one triangle", {}, {} },
  };
  samples.back().Mesh.Points = { { 0, 0 }, { 1, 0 }, { 0, 1 } };
  samples.back().Mesh.AddElement(std::vector<int>{ 0, 1, 2 });
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
  {
    samples.push_back(MeshOfRandomLayout(seed));
  }
  return samples;
}

} // namespace pemesh
