// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Meshes for the tests of the virtual element method, made by hand.
 */
#ifndef pemesh_VirtualElementTestMeshes_h
#define pemesh_VirtualElementTestMeshes_h

#include "Point2.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <random>
#include <vector>

namespace pemesh
{

using IdList = std::vector<vtkIdType>;

inline vtkSmartPointer<vtkPolyData> MakeMesh(
  const std::vector<Point2>& points, const std::vector<IdList>& elements)
{
  auto coordinates = vtkSmartPointer<vtkPoints>::New();
  coordinates->SetDataTypeToDouble();
  for (const Point2& point : points)
  {
    coordinates->InsertNextPoint(point.x, point.y, 0.0);
  }
  auto polygons = vtkSmartPointer<vtkCellArray>::New();
  for (const IdList& element : elements)
  {
    polygons->InsertNextCell(static_cast<vtkIdType>(element.size()), element.data());
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(coordinates);
  mesh->SetPolys(polygons);
  return mesh;
}

/** A grid of n x n points' squares whose vertices elements may use; unused ones are kept. */
class GridPoints
{
public:
  explicit GridPoints(int n)
    : N(n)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        this->Points.push_back({ static_cast<double>(i) / n, static_cast<double>(j) / n });
      }
    }
  }

  vtkIdType Id(int i, int j) const { return static_cast<vtkIdType>(j) * (this->N + 1) + i; }

  /** Moves the points inside by up to `amount` of a square. Same for the same seed. */
  void Jitter(double amount, unsigned seed)
  {
    std::mt19937_64 random(seed);
    const auto number = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53 - 0.5; };
    for (int j = 1; j < this->N; ++j)
    {
      for (int i = 1; i < this->N; ++i)
      {
        Point2& point = this->Points[static_cast<std::size_t>(this->Id(i, j))];
        point.x += amount * number() / this->N;
        point.y += amount * number() / this->N;
      }
    }
  }

  int N;
  std::vector<Point2> Points;
};

/** 2 n^2 triangles. */
inline vtkSmartPointer<vtkPolyData> MakeTriangles(int n, double jitter = 0.0, unsigned seed = 1)
{
  GridPoints grid(n);
  grid.Jitter(jitter, seed);
  std::vector<IdList> elements;
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      elements.push_back({ grid.Id(i, j), grid.Id(i + 1, j), grid.Id(i + 1, j + 1) });
      elements.push_back({ grid.Id(i, j), grid.Id(i + 1, j + 1), grid.Id(i, j + 1) });
    }
  }
  return MakeMesh(grid.Points, elements);
}

/** n x n blocks (n even): an L of three squares, eight vertices with the straight ones, and a
 * square. */
inline vtkSmartPointer<vtkPolyData> MakeLShapes(int n, double jitter = 0.0, unsigned seed = 1)
{
  GridPoints grid(n);
  grid.Jitter(jitter, seed);
  std::vector<IdList> elements;
  for (int j = 0; j < n; j += 2)
  {
    for (int i = 0; i < n; i += 2)
    {
      const auto id = [&grid, i, j](int a, int b) { return grid.Id(i + a, j + b); };
      elements.push_back(
        { id(0, 0), id(1, 0), id(2, 0), id(2, 1), id(1, 1), id(1, 2), id(0, 2), id(0, 1) });
      elements.push_back({ id(1, 1), id(2, 1), id(2, 2), id(1, 2) });
    }
  }
  return MakeMesh(grid.Points, elements);
}

/**
 * A chessboard of n x n fields (n even): every other one cut into four, so that the rest have a
 * hanging vertex on each side. The centres of the rest are points that no element uses.
 */
inline vtkSmartPointer<vtkPolyData> MakeChessboard(int n)
{
  const GridPoints grid(2 * n);
  std::vector<IdList> elements;
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const auto id = [&grid, i, j](int a, int b) { return grid.Id(2 * i + a, 2 * j + b); };
      if ((i + j) % 2 == 0)
      {
        elements.push_back({ id(0, 0), id(1, 0), id(1, 1), id(0, 1) });
        elements.push_back({ id(1, 0), id(2, 0), id(2, 1), id(1, 1) });
        elements.push_back({ id(1, 1), id(2, 1), id(2, 2), id(1, 2) });
        elements.push_back({ id(0, 1), id(1, 1), id(1, 2), id(0, 2) });
      }
      else
      {
        elements.push_back(
          { id(0, 0), id(1, 0), id(2, 0), id(2, 1), id(2, 2), id(1, 2), id(0, 2), id(0, 1) });
      }
    }
  }
  return MakeMesh(grid.Points, elements);
}

/**
 * The unit square cut in two: the maze of Attene et al., Math. Comput. Simul. 190 (2021), at
 * deformation t, and what is left of the square. As t nears 1 the maze becomes a thin ribbon.
 */
inline vtkSmartPointer<vtkPolyData> MakeMaze(double t)
{
  std::vector<Point2> points = { { 0, 1 }, { 0, .75 }, { 0, .5 }, { 0, .25 }, { 0, 0 }, { .25, 0 },
    { .5, 0 }, { .75, 0 }, { 1, 0 }, { 1, .25 }, { 1, .5 }, { 1, .75 }, { .75, .75 }, { .5, .75 } };
  const std::vector<Point2> start = { { .5, .5 }, { .75, .5 }, { .75, .25 }, { .5, .25 },
    { .25, .25 }, { .25, .5 }, { .25, .75 }, { .25, 1 } };
  const std::vector<Point2> end = { { .5, .745 }, { .995, .745 }, { .995, .005 }, { .5, .005 },
    { .005, .005 }, { .005, .5 }, { .005, .75 }, { .005, 1 } };
  for (std::size_t i = 0; i < start.size(); ++i)
  {
    points.push_back({ start[i].x * (1 - t) + end[i].x * t, start[i].y * (1 - t) + end[i].y * t });
  }
  points.push_back({ 1, 1 });
  IdList maze;
  for (vtkIdType id = 0; id < 22; ++id)
  {
    maze.push_back(id);
  }
  return MakeMesh(points, { maze, { 11, 22, 21, 20, 19, 18, 17, 16, 15, 14, 13, 12 } });
}

} // namespace pemesh

#endif
