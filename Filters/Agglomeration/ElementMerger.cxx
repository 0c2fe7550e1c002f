// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementMerger.h"

#include <algorithm>
#include <utility>

namespace pemesh
{

ElementMerger::ElementMerger(const PolygonMesh& mesh, const MeshAdjacency& adjacency)
  : Mesh(mesh)
  , Sides(mesh.Vertices.size())
  , Groups(static_cast<std::size_t>(mesh.NumberOfElements()))
  , NumberOfGroups(mesh.NumberOfElements())
{
  std::vector<int> borderFrom(mesh.Points.size(), None);
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    const int begin = mesh.Offsets[element];
    const int end = mesh.Offsets[element + 1];
    this->Groups[element] = { element, begin, end - begin };
    for (int side = begin; side < end; ++side)
    {
      const int twin = adjacency.Twin[side];
      const int vertex = mesh.Vertices[side];
      this->Sides[side] = { side + 1 == end ? begin : side + 1, side == begin ? end - 1 : side - 1,
        twin, twin < 0 ? Border : adjacency.Element[twin], element, vertex };
      if (twin < 0)
      {
        borderFrom[vertex] = side;
      }
    }
  }
  for (Side& side : this->Sides)
  {
    if (side.Twin < 0)
    {
      side.Twin = -2 - borderFrom[this->GetVertex(side.Next)];
    }
  }
}

void ElementMerger::GetNeighbors(int group, std::vector<int>& neighbors)
{
  neighbors.clear();
  const int first = this->GetFirstSide(group);
  int side = first;
  do
  {
    const int neighbor = this->GetGroupAcross(side);
    if (neighbor != Border &&
      std::find(neighbors.begin(), neighbors.end(), neighbor) == neighbors.end())
    {
      neighbors.push_back(neighbor);
    }
    side = this->GetNextSide(side);
  } while (side != first);
}

void ElementMerger::GetVertices(int group, std::vector<Point2>& vertices) const
{
  vertices.clear();
  const int first = this->GetFirstSide(group);
  int side = first;
  do
  {
    vertices.push_back(this->Mesh.Points[this->GetVertex(side)]);
    side = this->GetNextSide(side);
  } while (side != first);
}

/** Whether the vertex where a side starts is on the loop of a group. */
bool ElementMerger::IsOnGroup(int side, int group)
{
  for (int around = this->GetSideAround(side); around != side; around = this->GetSideAround(around))
  {
    if (this->Find(this->Sides[around].Element) == group)
    {
      return true;
    }
  }
  return false;
}

bool ElementMerger::FindChain(int a, int b, Chain& chain)
{
  chain = {};
  const int first = this->GetFirstSide(a);
  int side = first;
  bool wasShared = this->GetGroupAcross(this->GetPreviousSide(side)) == b;
  do
  {
    const bool isShared = this->GetGroupAcross(side) == b;
    if (isShared && !wasShared)
    {
      if (chain.First != None) // a second chain: the union would have a hole
      {
        return false;
      }
      chain.First = side;
    }
    if (!isShared && wasShared)
    {
      chain.Last = this->GetPreviousSide(side);
    }
    if (!isShared && !wasShared && this->IsOnGroup(side, b)) // a pinch
    {
      return false;
    }
    chain.Length += isShared ? 1 : 0;
    wasShared = isShared;
    side = this->GetNextSide(side);
  } while (side != first);
  return chain.First != None;
}

bool ElementMerger::CanMerge(int a, int b)
{
  Chain chain;
  return a != b &&
    (this->Groups[a].Count <= this->Groups[b].Count ? this->FindChain(a, b, chain)
                                                    : this->FindChain(b, a, chain));
}

void ElementMerger::Link(int before, int after)
{
  this->Sides[before].Next = after;
  this->Sides[after].Previous = before;
}

int ElementMerger::Merge(int a, int b)
{
  if (this->Groups[a].Count > this->Groups[b].Count)
  {
    std::swap(a, b);
  }
  Chain chain;
  if (a == b || !this->FindChain(a, b, chain))
  {
    return None;
  }
  // b walks the chain the other way round.
  const int afterInB = this->GetNextSide(this->Sides[chain.First].Twin);
  const int beforeInB = this->GetPreviousSide(this->Sides[chain.Last].Twin);
  const int beforeInA = this->GetPreviousSide(chain.First);
  const int afterInA = this->GetNextSide(chain.Last);
  this->Link(beforeInA, afterInB);
  this->Link(beforeInB, afterInA);
  this->Groups[a].Parent = b;
  this->Groups[b].First = afterInB;
  this->Groups[b].Count += this->Groups[a].Count - 2 * chain.Length;
  --this->NumberOfGroups;
  return b;
}

bool ElementMerger::GetUnion(int a, int b, std::vector<Point2>& vertices)
{
  vertices.clear();
  if (this->Groups[a].Count > this->Groups[b].Count)
  {
    std::swap(a, b);
  }
  Chain chain;
  if (a == b || !this->FindChain(a, b, chain))
  {
    return false;
  }
  const int endInA = chain.First;
  for (int side = this->GetNextSide(chain.Last); side != endInA; side = this->GetNextSide(side))
  {
    vertices.push_back(this->Mesh.Points[this->GetVertex(side)]);
  }
  const int endInB = this->Sides[chain.Last].Twin;
  for (int side = this->GetNextSide(this->Sides[chain.First].Twin); side != endInB;
       side = this->GetNextSide(side))
  {
    vertices.push_back(this->Mesh.Points[this->GetVertex(side)]);
  }
  return true;
}

} // namespace pemesh
