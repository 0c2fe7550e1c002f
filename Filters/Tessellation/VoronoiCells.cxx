// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "VoronoiCells.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace pemesh
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using DataStructure =
  CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>,
    CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, DataStructure>;

constexpr int Unnumbered = -1;

/**
 * Points so far out that they own no point of `bounds`, and all around, so that the cells of all
 * sites are bounded.
 */
std::vector<Point2> Sentinels(const Box& bounds)
{
  constexpr int Count = 24;
  const Point2 center = { bounds.Low.x + 0.5 * bounds.Width(),
    bounds.Low.y + 0.5 * bounds.Height() };
  const double radius = 4.0 * std::hypot(bounds.Width(), bounds.Height());
  std::vector<Point2> sentinels;
  for (int i = 0; i < Count; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * i / Count;
    sentinels.push_back(
      { center.x + radius * std::cos(angle), center.y + radius * std::sin(angle) });
  }
  return sentinels;
}

/** Computed from the vertex of the smallest number, so that it does not hang on the face. */
Point2 Circumcenter(Delaunay::Face_handle face)
{
  std::array<Delaunay::Vertex_handle, 3> vertices = { face->vertex(0), face->vertex(1),
    face->vertex(2) };
  std::sort(vertices.begin(), vertices.end(),
    [](const auto& a, const auto& b) { return a->info() < b->info(); });
  const auto& origin = vertices[0]->point();
  const double bx = vertices[1]->point().x() - origin.x();
  const double by = vertices[1]->point().y() - origin.y();
  const double cx = vertices[2]->point().x() - origin.x();
  const double cy = vertices[2]->point().y() - origin.y();
  const double b = bx * bx + by * by;
  const double c = cx * cx + cy * cy;
  const double determinant = 2.0 * (bx * cy - by * cx);
  return { origin.x() + (cy * b - by * c) / determinant,
    origin.y() + (bx * c - cx * b) / determinant };
}

/** Joins numbers to classes; the class is named by its smallest number. */
class Classes
{
public:
  int Find(int number)
  {
    while (this->Parent[number] != number)
    {
      this->Parent[number] = this->Parent[this->Parent[number]];
      number = this->Parent[number];
    }
    return number;
  }
  void Join(int a, int b)
  {
    const int first = this->Find(a);
    const int second = this->Find(b);
    this->Parent[std::max(first, second)] = std::min(first, second);
  }
  void Add() { this->Parent.push_back(static_cast<int>(this->Parent.size())); }

private:
  std::vector<int> Parent;
};

void ContractShortEdges(PolygonMesh& mesh, double tolerance)
{
  Classes classes;
  std::for_each(mesh.Points.begin(), mesh.Points.end(), [&](const Point2&) { classes.Add(); });
  bool anyShort = false;
  for (int cell = 0; cell < mesh.NumberOfElements(); ++cell)
  {
    for (int side = mesh.Offsets[cell]; side < mesh.Offsets[cell + 1]; ++side)
    {
      const int from = mesh.Vertices[side];
      const int to = mesh.Vertices[NextSide(mesh, cell, side)];
      const Point2& a = mesh.Points[from];
      const Point2& b = mesh.Points[to];
      if (std::abs(a.x - b.x) < tolerance && std::abs(a.y - b.y) < tolerance)
      {
        classes.Join(from, to);
        anyShort = true;
      }
    }
  }
  if (anyShort)
  {
    for (int& vertex : mesh.Vertices)
    {
      vertex = classes.Find(vertex);
    }
    RemoveRepeatedVertices(mesh);
  }
}

} // namespace

void RemoveRepeatedVertices(PolygonMesh& mesh)
{
  PolygonMesh kept;
  kept.Vertices.reserve(mesh.Vertices.size());
  kept.Offsets.reserve(mesh.Offsets.size());
  std::vector<int> vertices;
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    const std::span<const int> all = mesh.Element(element);
    vertices.clear();
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      if (all[i] != all[(i + 1) % all.size()])
      {
        vertices.push_back(all[i]);
      }
    }
    kept.AddElement(vertices.size() < 3 ? std::span<const int>() : vertices);
  }
  mesh.Vertices.swap(kept.Vertices);
  mesh.Offsets.swap(kept.Offsets);
}

PolygonMesh VoronoiCells(const std::vector<Point2>& sites, const Box& bounds, double tolerance,
  const std::function<bool(double)>& progress)
{
  Delaunay triangulation;
  int number = static_cast<int>(sites.size());
  for (const Point2& sentinel : Sentinels(bounds))
  {
    triangulation.insert(Kernel::Point_2(sentinel.x, sentinel.y))->info() = number++;
  }
  PolygonMesh mesh;
  std::vector<Delaunay::Vertex_handle> vertices(sites.size());
  Delaunay::Face_handle hint;
  const std::size_t step = sites.size() / 50 + 1;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    if (i % step == 0 && !progress(static_cast<double>(i) / static_cast<double>(sites.size())))
    {
      return mesh;
    }
    const std::size_t before = triangulation.number_of_vertices();
    const auto vertex = triangulation.insert(Kernel::Point_2(sites[i].x, sites[i].y), hint);
    hint = vertex->face();
    if (triangulation.number_of_vertices() > before)
    {
      vertex->info() = static_cast<int>(i);
      vertices[i] = vertex;
    }
  }
  for (const Delaunay::Face_handle face : triangulation.all_face_handles())
  {
    face->info() = Unnumbered;
  }
  std::vector<int> cell;
  for (const Delaunay::Vertex_handle vertex : vertices)
  {
    cell.clear();
    if (vertex != Delaunay::Vertex_handle())
    {
      Delaunay::Face_circulator face = triangulation.incident_faces(vertex); // counter-clockwise
      const Delaunay::Face_circulator first = face;
      do
      {
        if (face->info() == Unnumbered)
        {
          face->info() = static_cast<int>(mesh.Points.size());
          mesh.Points.push_back(Circumcenter(face));
        }
        cell.push_back(face->info());
      } while (++face != first);
    }
    mesh.AddElement(cell);
  }
  ContractShortEdges(mesh, tolerance);
  return mesh;
}

} // namespace pemesh
