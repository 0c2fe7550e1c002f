// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A polygonal mesh as flat arrays, and which elements are neighbours: what kernels that change or
 * check whole meshes work on.
 *
 * Side s of the mesh is the edge from Vertices[s] to the next vertex of the same element; the sides
 * of element e are Offsets[e] to Offsets[e + 1] - 1, counter-clockwise. So a side is at the same
 * time a position in Vertices.
 */
#ifndef pemesh_PolygonMesh_h
#define pemesh_PolygonMesh_h

#include "Point2.h"
#include "pemeshFiltersGeometryModule.h" // For export macro

#include <span>
#include <vector>

namespace pemesh
{

struct PolygonMesh
{
  std::vector<Point2> Points;
  std::vector<int> Offsets = { 0 }; ///< one more than elements
  std::vector<int> Vertices;        ///< element after element

  int NumberOfElements() const { return static_cast<int>(this->Offsets.size()) - 1; }
  int NumberOfSides() const { return static_cast<int>(this->Vertices.size()); }

  std::span<const int> Element(int element) const
  {
    const int first = this->Offsets[element];
    return { this->Vertices.data() + first,
      static_cast<std::size_t>(this->Offsets[element + 1] - first) };
  }

  /** The points of the vertices of an element, in their order. */
  void GetVertices(int element, std::vector<Point2>& vertices) const
  {
    vertices.clear();
    for (const int vertex : this->Element(element))
    {
      vertices.push_back(this->Points[vertex]);
    }
  }

  void AddElement(std::span<const int> vertices)
  {
    this->Vertices.insert(this->Vertices.end(), vertices.begin(), vertices.end());
    this->Offsets.push_back(this->NumberOfSides());
  }
};

/** The sides that face each other. Linear time and memory in the number of sides. */
struct MeshAdjacency
{
  static constexpr int Border = -1;   ///< no other element has this side
  static constexpr int Conflict = -2; ///< more than two elements have it, or two turn the same way

  std::vector<int> Twin;    ///< a side each: the side of the neighbour, Border or Conflict
  std::vector<int> Element; ///< a side each: whose it is
};

PEMESHFILTERSGEOMETRY_EXPORT MeshAdjacency FindAdjacency(const PolygonMesh& mesh);

/** The side after (before) a side in its element. */
inline int NextSide(const PolygonMesh& mesh, int element, int side)
{
  return side + 1 == mesh.Offsets[element + 1] ? mesh.Offsets[element] : side + 1;
}
inline int PreviousSide(const PolygonMesh& mesh, int element, int side)
{
  return side == mesh.Offsets[element] ? mesh.Offsets[element + 1] - 1 : side - 1;
}

/** Removes points that no element uses; returns the new number of each old point, -1 if removed. */
PEMESHFILTERSGEOMETRY_EXPORT std::vector<int> RemoveUnusedPoints(PolygonMesh& mesh);

} // namespace pemesh

#endif
