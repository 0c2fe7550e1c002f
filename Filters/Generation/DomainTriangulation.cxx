// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DomainTriangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <stdexcept>
#include <utility>

namespace pemesh
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel,
  CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using DataStructure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using CgalTriangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, DataStructure,
  CGAL::No_constraint_intersection_tag>;

/**
 * CGAL restores the Delaunay property around a new constraint in the order of memory addresses, so
 * where points lie on one circle the result changes from run to run. Here that step is left out;
 * RefinableTriangulation::MakeDelaunay does it in a fixed order.
 */
class RepeatableTriangulation : public CgalTriangulation
{
  void triangulate_hole(
    List_faces& intersected, List_edges& boundaryLeft, List_edges& boundaryRight) override
  {
    List_edges newEdges;
    this->Ctr::triangulate_hole(intersected, boundaryLeft, boundaryRight, newEdges);
  }
};

using Face = RepeatableTriangulation::Face_handle;
using Vertex = RepeatableTriangulation::Vertex_handle;

constexpr int NotInDomain = -1;

/** Between the number of a face outside and what is stored in it. */
int OutsideCode(int number)
{
  return -2 - number;
}

[[noreturn]] void RefuseMeetingLoops()
{
  throw std::runtime_error("Two edges of the domain's boundary meet; its loops must be apart.");
}

void InsertBoundary(const DomainBoundary& boundary, RepeatableTriangulation& triangulation)
{
  std::vector<Vertex> vertices;
  vertices.reserve(boundary.Points.size());
  Face hint;
  for (std::size_t i = 0; i < boundary.Points.size(); ++i)
  {
    const Point2& point = boundary.Points[i];
    const Vertex vertex = triangulation.insert(Kernel::Point_2(point.x, point.y), hint);
    if (triangulation.number_of_vertices() != i + 1)
    {
      RefuseMeetingLoops();
    }
    vertex->info() = static_cast<int>(i);
    vertices.push_back(vertex);
    hint = vertex->face();
  }
  for (const InputSegment& segment : boundary.Segments)
  {
    triangulation.insert_constraint(vertices[segment.From], vertices[segment.To]);
  }
}

/** The face to the left of the last segment, which is one of the outer loop. */
Face FindFaceInside(const DomainBoundary& boundary, const RepeatableTriangulation& triangulation)
{
  const InputSegment& segment = boundary.Segments.back();
  for (const Face face : triangulation.finite_face_handles())
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      if (face->vertex(triangulation.ccw(edge))->info() == segment.From &&
        face->vertex(triangulation.cw(edge))->info() == segment.To)
      {
        return face;
      }
    }
  }
  RefuseMeetingLoops();
}

/** Numbers the faces of the domain in the order in which a walk from the outer loop meets them. */
std::vector<Face> NumberDomainFaces(
  const DomainBoundary& boundary, RepeatableTriangulation& triangulation)
{
  for (const Face face : triangulation.all_face_handles())
  {
    face->info() = NotInDomain;
  }
  std::vector<Face> faces = { FindFaceInside(boundary, triangulation) };
  faces[0]->info() = 0;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const Face face = faces[i];
    for (int edge = 0; edge < 3; ++edge)
    {
      const Face neighbor = face->neighbor(edge);
      if (!face->is_constrained(edge) && neighbor->info() == NotInDomain)
      {
        if (triangulation.is_infinite(neighbor))
        {
          RefuseMeetingLoops();
        }
        neighbor->info() = static_cast<int>(faces.size());
        faces.push_back(neighbor);
      }
    }
  }
  return faces;
}

/** The other finite faces: number i is stored as OutsideCode(i). */
std::vector<Face> NumberOutsideFaces(RepeatableTriangulation& triangulation)
{
  std::vector<Face> faces;
  for (const Face face : triangulation.finite_face_handles())
  {
    if (face->info() == NotInDomain)
    {
      face->info() = OutsideCode(static_cast<int>(faces.size()));
      faces.push_back(face);
    }
  }
  return faces;
}

std::vector<RefinableTriangulation::Triangle> ConvertInside(
  const std::vector<Face>& faces, std::vector<RefinableTriangulation::Segment>& segments)
{
  std::vector<RefinableTriangulation::Triangle> triangles(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      triangles[i].Vertex[edge] = faces[i]->vertex(edge)->info();
      triangles[i].Neighbor[edge] = faces[i]->neighbor(edge)->info();
      if (faces[i]->is_constrained(edge))
      {
        const int from = faces[i]->vertex((edge + 1) % 3)->info();
        segments[from].Triangle = static_cast<int>(i);
        triangles[i].Neighbor[edge] = ~from;
      }
    }
  }
  return triangles;
}

OutsideTriangles ConvertOutside(const RepeatableTriangulation& triangulation,
  const std::vector<Face>& faces, std::size_t numberOfSegments)
{
  OutsideTriangles outside;
  outside.Beyond.assign(numberOfSegments, OutsideTriangles::OutsideHull);
  outside.Triangles.resize(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    RefinableTriangulation::Triangle& triangle = outside.Triangles[i];
    for (int edge = 0; edge < 3; ++edge)
    {
      const Face neighbor = faces[i]->neighbor(edge);
      triangle.Vertex[edge] = faces[i]->vertex(edge)->info();
      triangle.Neighbor[edge] = triangulation.is_infinite(neighbor) ? OutsideTriangles::OutsideHull
                                                                    : OutsideCode(neighbor->info());
      if (faces[i]->is_constrained(edge)) // a segment runs with the domain on its left
      {
        const int from = faces[i]->vertex((edge + 2) % 3)->info();
        outside.Beyond[from] = static_cast<int>(i);
        triangle.Neighbor[edge] = ~from;
      }
    }
  }
  return outside;
}

} // namespace

DomainBoundary MakeDomainBoundary(
  const Domain& domain, const std::vector<std::vector<Point2>>& polygons)
{
  DomainBoundary boundary;
  const auto add = [&boundary](const std::vector<Point2>& loop, bool reversed)
  {
    const int first = static_cast<int>(boundary.Points.size());
    const int n = static_cast<int>(loop.size());
    boundary.Points.insert(boundary.Points.end(), loop.begin(), loop.end());
    for (int i = 0; i < n; ++i)
    {
      const int after = first + (i + 1) % n;
      const int before = first + (i + n - 1) % n;
      boundary.Segments.push_back({ first + i, reversed ? before : after });
      boundary.Before.push_back(reversed ? after : before);
    }
  };
  for (const std::vector<Point2>& polygon : polygons)
  {
    add(polygon, true);
  }
  boundary.NumberOfPolygonSegments = static_cast<int>(boundary.Segments.size());
  for (const std::vector<Point2>& hole : domain.Holes)
  {
    add(hole, true);
  }
  add(domain.Outer, false);
  return boundary;
}

DomainTriangulation TriangulateDomain(const DomainBoundary& boundary)
{
  RepeatableTriangulation triangulation;
  std::vector<Face> inside;
  try
  {
    InsertBoundary(boundary, triangulation);
    inside = NumberDomainFaces(boundary, triangulation);
  }
  catch (const RepeatableTriangulation::Intersection_of_constraints_exception&)
  {
    RefuseMeetingLoops();
  }

  std::vector<RefinableTriangulation::Segment> segments(boundary.Segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    segments[i] = { -1, static_cast<int>(i) };
  }
  std::vector<RefinableTriangulation::Triangle> triangles = ConvertInside(inside, segments);
  for (const RefinableTriangulation::Segment& segment : segments)
  {
    if (segment.Triangle < 0)
    {
      RefuseMeetingLoops();
    }
  }
  DomainTriangulation result = { RefinableTriangulation(
                                   boundary.Points, std::move(triangles), std::move(segments)),
    ConvertOutside(triangulation, NumberOutsideFaces(triangulation), boundary.Segments.size()) };
  result.Inside.MakeDelaunay();
  return result;
}

} // namespace pemesh
