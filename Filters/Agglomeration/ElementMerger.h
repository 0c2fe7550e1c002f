// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Merges neighbouring elements of a mesh into groups, each of which stays a simple polygon.
 *
 * Sides keep the numbers of the mesh: the sides on the boundary of a group are linked to a loop,
 * and a merge cuts the common sides out of two loops. Groups are known by one of their elements
 * (union-find).
 *
 * Two groups may be merged if their boundaries have exactly one chain of sides in common, and no
 * vertex off that chain: then, and only then, the union of two simple polygons is one, without
 * hole or pinch. This is combinatorics alone; coordinates are never looked at.
 */
#ifndef pemesh_ElementMerger_h
#define pemesh_ElementMerger_h

#include "PolygonMesh.h"
#include "pemeshFiltersAgglomerationModule.h" // For export macro

#include <vector>

namespace pemesh
{

class PEMESHFILTERSAGGLOMERATION_EXPORT ElementMerger
{
public:
  static constexpr int Border = -1;
  static constexpr int None = -1;

  /** Groups of one element each. The mesh must be one in which WhyNotAgglomerable finds no fault,
   * and must outlive the merger; the adjacency need not. */
  ElementMerger(const PolygonMesh& mesh, const MeshAdjacency& adjacency);

  const PolygonMesh& GetMesh() const { return this->Mesh; }
  int GetNumberOfGroups() const { return this->NumberOfGroups; }

  /** The group of an element. */
  int Find(int element)
  {
    while (this->Groups[element].Parent != element)
    {
      Group& group = this->Groups[element];
      group.Parent = this->Groups[group.Parent].Parent;
      element = group.Parent;
    }
    return element;
  }
  bool IsGroup(int element) const { return this->Groups[element].Parent == element; }

  /** Has the loop of a group fetched from memory, for those who know what they will ask next. */
  void Prefetch(int group) const { __builtin_prefetch(&this->Sides[this->Groups[group].First]); }

  ///@{
  /** The loop of a group, counter-clockwise: some side of it, and the side after (before) one. */
  int GetFirstSide(int group) const { return this->Groups[group].First; }
  int GetNextSide(int side) const { return this->Sides[side].Next; }
  int GetPreviousSide(int side) const { return this->Sides[side].Previous; }
  int GetNumberOfSides(int group) const { return this->Groups[group].Count; }
  ///@}

  /** The vertex where a side starts. */
  int GetVertex(int side) const { return this->Sides[side].Vertex; }

  /** The group on the other side, or Border. */
  int GetGroupAcross(int side)
  {
    const int across = this->Sides[side].Across;
    return across < 0 ? Border : this->Find(across);
  }

  /** The side, on the same loop or another, that starts at the same vertex and comes next counter-
   * clockwise; round the vertex it comes back to the first, jumping across the outside. */
  int GetSideAround(int side) const
  {
    const int twin = this->Sides[this->Sides[side].Previous].Twin;
    return twin >= 0 ? twin : -2 - twin;
  }

  /** The groups across the sides of a group, each once, in the order of its loop. */
  void GetNeighbors(int group, std::vector<int>& neighbors);

  /** The points of the loop. */
  void GetVertices(int group, std::vector<Point2>& vertices) const;

  /** Whether the union is a simple polygon. Linear in the sides of the smaller group. */
  bool CanMerge(int a, int b);

  /** The merged group, one of the two; None, and nothing is changed, if they cannot be merged. */
  int Merge(int a, int b);

  /** The points of the union of two groups that can be merged, in its order. */
  bool GetUnion(int a, int b, std::vector<Point2>& vertices);

private:
  /** The sides that two groups have in common, as the loop of the first of them runs. */
  struct Chain
  {
    int First = None;
    int Last = None;
    int Length = 0;
  };

  // Rules jump about in the mesh: what is asked of a side, or of a group, lies in one place.
  struct Side
  {
    int Next;
    int Previous;
    int Twin;    ///< -2 - s on the border: there s starts where this side ends
    int Across;  ///< the element of the twin, or Border
    int Element; ///< whose side it is
    int Vertex;  ///< where it starts
  };
  struct Group
  {
    int Parent;
    int First; ///< side
    int Count; ///< of sides
  };

  bool IsOnGroup(int side, int group);
  bool FindChain(int a, int b, Chain& chain);
  void Link(int before, int after);

  const PolygonMesh& Mesh;
  std::vector<Side> Sides;
  std::vector<Group> Groups;
  int NumberOfGroups = 0;
};

} // namespace pemesh

#endif
