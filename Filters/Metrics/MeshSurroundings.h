// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What a metric of an element in its mesh is computed from: values of all elements, and neighbours.
 */
#ifndef pemesh_MeshSurroundings_h
#define pemesh_MeshSurroundings_h

#include "PolygonMesh.h"
#include "pemeshFiltersMetricsModule.h" // For export macro

#include <limits>
#include <span>
#include <vector>

#include <vtkType.h> // For vtkIdType

namespace pemesh
{

/** The length that an element shares with one neighbour. */
struct SharedLength
{
  int Neighbour;
  double Length;
};

/**
 * Who is beside whom. Neighbours share an edge, which is one pair of vertices: where vertices hang
 * on an edge without being vertices of it, there is a border (`pemesh check` finds such places).
 * Edges of more than two elements belong to nobody. Elements may be in either orientation and
 * repeat a vertex. Safe to use from several threads at once.
 */
class PEMESHFILTERSMETRICS_EXPORT MeshNeighbours
{
public:
  explicit MeshNeighbours(PolygonMesh mesh);

  /** An edge of the element each: the neighbour behind it; negative if there is none. */
  std::span<const int> GetTwinElements(vtkIdType element) const
  {
    const int first = this->Mesh.Offsets[static_cast<std::size_t>(element)];
    const int last = this->Mesh.Offsets[static_cast<std::size_t>(element) + 1];
    return { this->Twins.data() + first, static_cast<std::size_t>(last - first) };
  }

  /** Each neighbour once, by number. Valid until the next call in the same thread. */
  std::span<const SharedLength> GetShared(vtkIdType element) const;

  double GetPerimeter(vtkIdType element) const;
  double GetBorderLength(vtkIdType element) const;
  /** Vertices straight to `distance` where one neighbour ends and another, or none, begins. */
  int CountHangingVertices(vtkIdType element, double distance) const;

  /** Of the whole mesh. */
  double GetBoundaryLength() const;
  vtkIdType CountEdges() const;

private:
  double SideLength(int element, std::size_t side) const;

  PolygonMesh Mesh;
  std::vector<int> Twins; // a side each: the element behind it, or as in MeshAdjacency
};

struct MeshSurroundings
{
  const double* Base = nullptr; ///< the base metric of each element, NaN where undefined
  double LargestBase = std::numeric_limits<double>::quiet_NaN();
  const MeshNeighbours* Neighbours = nullptr; ///< null unless a metric needs it
};

} // namespace pemesh

#endif
