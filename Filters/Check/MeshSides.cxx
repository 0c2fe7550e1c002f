// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshSides.h"

#include "SideJunctions.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace pemesh
{

namespace
{

/** Disjoint sets by union by smallest member and path halving (R. E. Tarjan, J. van Leeuwen,
 * J. ACM 31 (1984) 245-281). */
class DisjointSets
{
public:
  explicit DisjointSets(int size)
    : Parent(static_cast<std::size_t>(size))
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }

  int Find(int member)
  {
    while (this->Parent[member] != member)
    {
      this->Parent[member] = this->Parent[this->Parent[member]];
      member = this->Parent[member];
    }
    return member;
  }

  void Unite(int a, int b)
  {
    a = this->Find(a);
    b = this->Find(b);
    this->Parent[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<int> Parent;
};

bool IsLess(const BorderPiece& a, const BorderPiece& b)
{
  return std::tie(a.From, a.To, a.Element) < std::tie(b.From, b.To, b.Element);
}

/** By the vertices they join, in whichever direction. */
std::pair<int, int> KeyOf(const BorderPiece& piece)
{
  return std::minmax(piece.From, piece.To);
}

/** Sorts the pieces and calls `use(group)` for those that join the same two vertices. */
template <typename Use>
void ForEachGroup(std::vector<BorderPiece>& pieces, const Use& use)
{
  std::sort(pieces.begin(), pieces.end(),
    [](const BorderPiece& a, const BorderPiece& b)
    { return KeyOf(a) != KeyOf(b) ? KeyOf(a) < KeyOf(b) : IsLess(a, b); });
  for (std::size_t first = 0; first < pieces.size();)
  {
    std::size_t last = first;
    while (last < pieces.size() && KeyOf(pieces[last]) == KeyOf(pieces[first]))
    {
      ++last;
    }
    use(std::span<const BorderPiece>(pieces.data() + first, last - first));
    first = last;
  }
}

/** Builds MeshSides step by step. */
class SideMatcher
{
public:
  explicit SideMatcher(const NormalForm& form)
    : Form(form)
    , Sets(form.Mesh.NumberOfElements())
  {
    this->Sides.IsExplained.assign(form.Mesh.Points.size(), 0);
  }

  MeshSides Match(double distance)
  {
    this->ExplainFaultyElements();
    this->MatchWholeSides();
    this->Sides.Junctions = FindJunctions(this->Form, this->Open, distance);
    this->MatchPieces();
    std::sort(this->Sides.Border.begin(), this->Sides.Border.end(), IsLess);
    this->TraceLoops();
    this->NumberComponents();
    return std::move(this->Sides);
  }

private:
  void ExplainFaultyElements();
  void MatchWholeSides();
  void FindConflict(std::span<const BorderPiece> group);
  void Join(std::span<const BorderPiece> group);
  void MatchPieces();
  void TraceLoops();
  void NumberComponents();

  const NormalForm& Form;
  DisjointSets Sets;
  MeshSides Sides;
  std::vector<BorderPiece> Open; // whole sides without a counterpart
};

void SideMatcher::ExplainFaultyElements()
{
  for (const int vertex : this->Form.Stranded)
  {
    this->Sides.IsExplained[vertex] = 1;
  }
  for (int element = 0; element < this->Form.Mesh.NumberOfElements(); ++element)
  {
    if (!IsSimple(this->Form.Conditions[element]))
    {
      for (const int vertex : this->Form.Mesh.Element(element))
      {
        this->Sides.IsExplained[vertex] = 1;
      }
    }
  }
}

void SideMatcher::MatchWholeSides()
{
  const PolygonMesh& mesh = this->Form.Mesh;
  const MeshAdjacency adjacency = FindAdjacency(mesh);
  std::vector<BorderPiece> conflicting;
  for (int side = 0; side < mesh.NumberOfSides(); ++side)
  {
    const int element = adjacency.Element[side];
    const int twin = adjacency.Twin[side];
    if (twin >= 0)
    {
      this->Sets.Unite(element, adjacency.Element[twin]);
      continue;
    }
    const BorderPiece piece = { mesh.Vertices[side], mesh.Vertices[NextSide(mesh, element, side)],
      element };
    // An element of one place only has a side of no length.
    if (piece.From != piece.To)
    {
      (twin == MeshAdjacency::Border ? this->Open : conflicting).push_back(piece);
    }
  }
  ForEachGroup(conflicting,
    [this](std::span<const BorderPiece> group)
    {
      this->FindConflict(group);
      this->Join(group);
    });
}

void SideMatcher::FindConflict(std::span<const BorderPiece> group)
{
  std::vector<int> simple;
  int forward = 0;
  int backward = 0;
  for (const BorderPiece& piece : group)
  {
    if (IsSimple(this->Form.Conditions[piece.Element]))
    {
      ++(piece.From < piece.To ? forward : backward);
      simple.push_back(piece.Element);
    }
  }
  const auto [from, to] = KeyOf(group[0]);
  if (forward > 1 || backward > 1)
  {
    std::sort(simple.begin(), simple.end());
    this->Sides.Conflicts.push_back({ from, to, std::move(simple) });
  }
  this->Sides.IsExplained[from] = 1;
  this->Sides.IsExplained[to] = 1;
}

/** Joins all elements of a group; the surplus of pieces in one direction is border. */
void SideMatcher::Join(std::span<const BorderPiece> group)
{
  std::ptrdiff_t balance = 0;
  for (const BorderPiece& piece : group)
  {
    balance += piece.From < piece.To ? 1 : -1;
    this->Sets.Unite(piece.Element, group[0].Element);
  }
  for (const BorderPiece& piece : group)
  {
    if (balance != 0 && (piece.From < piece.To) == (balance > 0))
    {
      this->Sides.Border.push_back(piece);
      balance -= balance > 0 ? 1 : -1;
    }
  }
}

/** Cuts the open sides at their junctions and matches the pieces. */
void SideMatcher::MatchPieces()
{
  std::vector<BorderPiece> pieces;
  std::size_t next = 0;
  const std::vector<Junction>& junctions = this->Sides.Junctions;
  for (const BorderPiece& side : this->Open)
  {
    int from = side.From;
    for (; next < junctions.size() && junctions[next].Element == side.Element &&
         junctions[next].From == side.From && junctions[next].To == side.To;
         ++next)
    {
      pieces.push_back({ from, junctions[next].Vertex, side.Element });
      from = junctions[next].Vertex;
    }
    pieces.push_back({ from, side.To, side.Element });
  }
  ForEachGroup(pieces, [this](std::span<const BorderPiece> group) { this->Join(group); });
}

/** A path along the border; whenever it comes back to a vertex of its own, a loop is cut off. */
void SideMatcher::TraceLoops()
{
  const std::vector<BorderPiece>& border = this->Sides.Border;
  std::vector<int> next(this->Form.Mesh.Points.size(), -1); // the next piece from a vertex
  for (std::size_t i = border.size(); i-- > 0;)
  {
    next[border[i].From] = static_cast<int>(i);
  }
  std::vector<int> place(this->Form.Mesh.Points.size(), -1); // in the path
  std::vector<int> path;
  for (const BorderPiece& start : border)
  {
    int vertex = start.From;
    while (true)
    {
      if (place[vertex] >= 0)
      {
        const auto first = path.begin() + place[vertex];
        this->Sides.Loops.emplace_back(first, path.end());
        std::for_each(first, path.end(), [&place](int on) { place[on] = -1; });
        path.erase(first, path.end());
      }
      const int piece = next[vertex];
      if (piece < 0)
      {
        break;
      }
      const bool hasMore =
        piece + 1 < static_cast<int>(border.size()) && border[piece + 1].From == vertex;
      next[vertex] = hasMore ? piece + 1 : -1;
      place[vertex] = static_cast<int>(path.size());
      path.push_back(vertex);
      vertex = border[piece].To;
    }
    // As many pieces enter each vertex as leave it, so that nothing is left of a path.
    std::for_each(path.begin(), path.end(), [&place](int on) { place[on] = -1; });
    path.clear();
  }
}

void SideMatcher::NumberComponents()
{
  const int elements = this->Form.Mesh.NumberOfElements();
  this->Sides.Component.assign(static_cast<std::size_t>(elements), -1);
  for (int element = 0; element < elements; ++element)
  {
    if (this->Form.Mesh.Element(element).size() > 1)
    {
      const int root = this->Sets.Find(element); // the smallest of its set
      this->Sides.Component[element] =
        root == element ? this->Sides.NumberOfComponents++ : this->Sides.Component[root];
    }
  }
}

} // namespace

MeshSides FindSides(const NormalForm& form, double tolerance)
{
  return SideMatcher(form).Match(tolerance * form.Diagonal);
}

} // namespace pemesh
