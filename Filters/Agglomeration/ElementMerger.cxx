// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementMerger.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pemesh
{

ElementMerger::ElementMerger(const PolygonMesh& mesh, MeshAdjacency adjacency)
  : Mesh(mesh)
  , Twin(std::move(adjacency.Twin))
  , Element(std::move(adjacency.Element))
  , Next(mesh.Vertices.size())
  , Previous(mesh.Vertices.size())
  , Parent(static_cast<std::size_t>(mesh.NumberOfElements()))
  , First(mesh.Offsets.begin(), mesh.Offsets.end() - 1)
  , Count(Parent.size())
  , NumberOfGroups(mesh.NumberOfElements())
{
  std::iota(this->Parent.begin(), this->Parent.end(), 0);
  std::vector<int> borderFrom(mesh.Points.size(), None);
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    const int begin = mesh.Offsets[element];
    const int end = mesh.Offsets[element + 1];
    this->Count[element] = end - begin;
    for (int side = begin; side < end; ++side)
    {
      this->Next[side] = side + 1 == end ? begin : side + 1;
      this->Previous[this->Next[side]] = side;
      if (this->Twin[side] < 0)
      {
        borderFrom[mesh.Vertices[side]] = side;
      }
    }
  }
  for (std::size_t side = 0; side < this->Twin.size(); ++side)
  {
    if (this->Twin[side] < 0)
    {
      this->Twin[side] = -2 - borderFrom[mesh.Vertices[this->Next[side]]];
    }
  }
}

void ElementMerger::GetNeighbors(int group, std::vector<int>& neighbors)
{
  neighbors.clear();
  const int first = this->First[group];
  int side = first;
  do
  {
    const int neighbor = this->GetGroupAcross(side);
    if (neighbor != Border &&
      std::find(neighbors.begin(), neighbors.end(), neighbor) == neighbors.end())
    {
      neighbors.push_back(neighbor);
    }
    side = this->Next[side];
  } while (side != first);
}

void ElementMerger::GetVertices(int group, std::vector<Point2>& vertices) const
{
  vertices.clear();
  const int first = this->First[group];
  int side = first;
  do
  {
    vertices.push_back(this->Mesh.Points[this->Mesh.Vertices[side]]);
    side = this->Next[side];
  } while (side != first);
}

/** Whether the vertex where a side starts is on the loop of a group. */
bool ElementMerger::IsOnGroup(int side, int group)
{
  for (int around = this->GetSideAround(side); around != side; around = this->GetSideAround(around))
  {
    if (this->Find(this->Element[around]) == group)
    {
      return true;
    }
  }
  return false;
}

bool ElementMerger::FindChain(int a, int b, Chain& chain)
{
  chain = {};
  const int first = this->First[a];
  int side = first;
  bool wasShared = this->GetGroupAcross(this->Previous[side]) == b;
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
      chain.Last = this->Previous[side];
    }
    if (!isShared && !wasShared && this->IsOnGroup(side, b)) // a pinch
    {
      return false;
    }
    chain.Length += isShared ? 1 : 0;
    wasShared = isShared;
    side = this->Next[side];
  } while (side != first);
  return chain.First != None;
}

bool ElementMerger::CanMerge(int a, int b)
{
  Chain chain;
  return a != b &&
    (this->Count[a] <= this->Count[b] ? this->FindChain(a, b, chain)
                                      : this->FindChain(b, a, chain));
}

void ElementMerger::Link(int before, int after)
{
  this->Next[before] = after;
  this->Previous[after] = before;
}

int ElementMerger::Merge(int a, int b)
{
  if (this->Count[a] > this->Count[b])
  {
    std::swap(a, b);
  }
  Chain chain;
  if (a == b || !this->FindChain(a, b, chain))
  {
    return None;
  }
  // b walks the chain the other way round.
  const int afterInB = this->Next[this->Twin[chain.First]];
  const int beforeInB = this->Previous[this->Twin[chain.Last]];
  const int beforeInA = this->Previous[chain.First];
  const int afterInA = this->Next[chain.Last];
  this->Link(beforeInA, afterInB);
  this->Link(beforeInB, afterInA);
  this->Parent[a] = b;
  this->First[b] = afterInB;
  this->Count[b] += this->Count[a] - 2 * chain.Length;
  --this->NumberOfGroups;
  return b;
}

bool ElementMerger::GetUnion(int a, int b, std::vector<Point2>& vertices)
{
  vertices.clear();
  if (this->Count[a] > this->Count[b])
  {
    std::swap(a, b);
  }
  Chain chain;
  if (a == b || !this->FindChain(a, b, chain))
  {
    return false;
  }
  const int endInA = chain.First;
  for (int side = this->Next[chain.Last]; side != endInA; side = this->Next[side])
  {
    vertices.push_back(this->Mesh.Points[this->Mesh.Vertices[side]]);
  }
  const int endInB = this->Twin[chain.Last];
  for (int side = this->Next[this->Twin[chain.First]]; side != endInB; side = this->Next[side])
  {
    vertices.push_back(this->Mesh.Points[this->Mesh.Vertices[side]]);
  }
  return true;
}

} // namespace pemesh
