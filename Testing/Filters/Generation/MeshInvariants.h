// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What must hold of every mesh of a domain, checked in rational arithmetic: an independent
 * judge of the mesher, which never shares code with it.
 */
#ifndef pemesh_MeshInvariants_h
#define pemesh_MeshInvariants_h

#include "Domain.h"
#include "Point2.h"

#include <string>
#include <vector>

class vtkPolyData;

using PolygonVertices = std::vector<pemesh::Point2>;

/** By the shoelace formula, in double precision. */
double SignedArea(const PolygonVertices& polygon);

/** In exact arithmetic. */
bool IsSimpleAndCounterClockwise(const PolygonVertices& polygon);

/** The vertices of a cell. */
PolygonVertices VerticesOf(vtkPolyData* mesh, int cell);

/**
 * Empty if the points are double, none unused and none twice, all cells are polygons, simple and
 * counter-clockwise, and no edge is used twice in one direction. Else a sentence.
 */
std::string WhyNotPolygons(vtkPolyData* mesh);

/**
 * Empty if, besides, the mesh covers the domain once: every edge is used once in one direction and
 * once in the other, or lies on the border; the border is made of the loops of the domain, with all
 * their vertices (others lie on their edges as nearly as doubles can, exactly on upright and level
 * ones); the areas add up to exactly what the border encloses.
 */
std::string WhyNotACover(vtkPolyData* mesh, const pemesh::Domain& domain);

/**
 * Empty if the mesh covers the domain with placed polygons and triangles: `PolygonId` and
 * `ElementFamily` are there and placed polygons come first. Else a sentence.
 */
std::string WhyNotAMesh(vtkPolyData* mesh, const pemesh::Domain& domain = pemesh::UnitSquare());

/** Empty if no edge between two fillers could be flipped to make both more nearly Delaunay. */
std::string WhyNotConstrainedDelaunay(vtkPolyData* mesh);

/** Empty if no filler sees the edge of a placed polygon or of the domain under an obtuse angle. */
std::string WhyNotConforming(vtkPolyData* mesh);

/** The angles of the triangle in degrees, smallest first, by the law of cosines. */
std::vector<double> AnglesOf(const PolygonVertices& triangle);

/** The smallest angle in degrees that the polygon leaves outside at any of its vertices. */
double SmallestOuterAngle(const PolygonVertices& polygon);

#endif
