// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ClipMesh.h"

#include "BoundaryContacts.h"
#include "HoleLinks.h"
#include "PlanarFaces.h"

#include <algorithm>
#include <numeric>

namespace pemesh
{

namespace
{

/** The ends of an edge and the points inside it, in order. */
void ListPoints(
  const PointsOnEdges& pointsOnEdges, int edge, int from, int to, std::vector<int>& list)
{
  list.assign(1, from);
  const auto found = pointsOnEdges.find(edge);
  if (found != pointsOnEdges.end())
  {
    for (const PointOnEdge& point : found->second)
    {
      list.push_back(point.Point);
    }
  }
  list.push_back(to);
}

/** A cell is cut if the boundary, or a line from a hole, has a point in common with it. */
std::vector<bool> FindCutCells(const BoundaryContacts& contacts)
{
  std::vector<bool> isCut(static_cast<std::size_t>(contacts.Cells.NumberOfElements()), false);
  for (int side = 0; side < contacts.Cells.NumberOfSides(); ++side)
  {
    if (contacts.IsTouched[contacts.Cells.Vertices[side]])
    {
      isCut[contacts.Adjacency.Element[side]] = true;
    }
  }
  for (const auto& [side, points] : contacts.OnCellEdges)
  {
    isCut[contacts.Adjacency.Element[side]] = true;
    const int twin = contacts.Adjacency.Twin[side];
    if (twin >= 0)
    {
      isCut[contacts.Adjacency.Element[twin]] = true;
    }
  }
  return isCut;
}

/** The pieces of the edges of the cut cells and of the boundary. */
class PieceCollector
{
public:
  PieceCollector(const BoundaryContacts& contacts, const std::vector<bool>& isCut)
    : Contacts(contacts)
    , IsCut(isCut)
  {
  }

  std::vector<HalfEdge> Collect()
  {
    for (int side = 0; side < this->Contacts.Cells.NumberOfSides(); ++side)
    {
      this->CollectSide(side);
    }
    for (int edge = 0; edge < static_cast<int>(this->Contacts.DomainEdges.size()); ++edge)
    {
      const DomainEdge& domainEdge = this->Contacts.DomainEdges[edge];
      ListPoints(this->Contacts.OnDomainEdges, edge, domainEdge.From, domainEdge.To, this->Points);
      this->AddPieces({ -1, true, false }, { -1, false, true });
    }
    MergeRepetitions(this->Pieces);
    return std::move(this->Pieces);
  }

private:
  /** An edge between a cut cell and another one comes from the cut one, between two from either. */
  void CollectSide(int side)
  {
    const int edge = this->Contacts.EdgeOf(side);
    const std::vector<int>& cells = this->Contacts.Adjacency.Element;
    if (!this->IsCut[cells[side]] || (side != edge && this->IsCut[cells[edge]]))
    {
      return;
    }
    const int twin = this->Contacts.Adjacency.Twin[edge];
    ListPoints(this->Contacts.OnCellEdges, edge, this->Contacts.Cells.Vertices[edge],
      this->Contacts.EndOf(edge), this->Points);
    this->AddPieces({ cells[edge], false, false }, { twin >= 0 ? cells[twin] : -1, false, false });
  }

  void AddPieces(const LeftSide& left, const LeftSide& right)
  {
    for (std::size_t i = 0; i + 1 < this->Points.size(); ++i)
    {
      this->Pieces.push_back({ this->Points[i], this->Points[i + 1], left });
      this->Pieces.push_back({ this->Points[i + 1], this->Points[i], right });
    }
  }

  const BoundaryContacts& Contacts;
  const std::vector<bool>& IsCut;
  std::vector<int> Points;
  std::vector<HalfEdge> Pieces;
};

/** Parts of cells, of which some are known to be in the domain. */
struct Parts
{
  PolygonMesh Mesh;
  std::vector<int> Cells;
  std::vector<bool> IsInDomain;

  void Add(std::span<const int> vertices, int cell, bool isInDomain)
  {
    this->Mesh.AddElement(vertices);
    this->Cells.push_back(cell);
    this->IsInDomain.push_back(isInDomain);
  }
};

/** Whole cells, and what is left of cut cells; parts that are outside for certain are left out. */
Parts CollectParts(const BoundaryContacts& contacts, const std::vector<bool>& isCut,
  const std::vector<HalfEdge>& pieces)
{
  Parts parts;
  for (const PlanarFace& face : FindPlanarFaces(contacts.Cells.Points, pieces))
  {
    const bool isOfCell = face.Left.Cell >= 0 && isCut[face.Left.Cell];
    if (!face.Left.OffDomain && (face.Left.InDomain || isOfCell))
    {
      parts.Add(face.Vertices, face.Left.Cell, face.Left.InDomain);
    }
  }
  for (int cell = 0; cell < contacts.Cells.NumberOfElements(); ++cell)
  {
    if (!isCut[cell] && !contacts.Cells.Element(cell).empty())
    {
      parts.Add(contacts.Cells.Element(cell), cell, false);
    }
  }
  parts.Mesh.Points = contacts.Cells.Points;
  return parts;
}

/** What is next to a part in the domain is in the domain, for no part crosses the boundary. */
void SpreadOverDomain(Parts& parts)
{
  const MeshAdjacency adjacency = FindAdjacency(parts.Mesh);
  std::vector<int> known;
  for (int part = 0; part < parts.Mesh.NumberOfElements(); ++part)
  {
    if (parts.IsInDomain[part])
    {
      known.push_back(part);
    }
  }
  while (!known.empty())
  {
    const int part = known.back();
    known.pop_back();
    for (int side = parts.Mesh.Offsets[part]; side < parts.Mesh.Offsets[part + 1]; ++side)
    {
      const int twin = adjacency.Twin[side];
      if (twin >= 0 && !parts.IsInDomain[adjacency.Element[twin]])
      {
        parts.IsInDomain[adjacency.Element[twin]] = true;
        known.push_back(adjacency.Element[twin]);
      }
    }
  }
}

/** Whether the sides of the mesh that have no neighbour are the pieces of the boundary. */
bool IsBorderTheBoundary(const PolygonMesh& mesh, const std::vector<HalfEdge>& pieces)
{
  std::vector<std::pair<int, int>> boundary;
  for (const HalfEdge& piece : pieces)
  {
    if (piece.Left.InDomain)
    {
      boundary.emplace_back(piece.From, piece.To);
    }
  }
  const MeshAdjacency adjacency = FindAdjacency(mesh);
  std::vector<std::pair<int, int>> border;
  for (int side = 0; side < mesh.NumberOfSides(); ++side)
  {
    if (adjacency.Twin[side] == MeshAdjacency::Conflict)
    {
      return false;
    }
    if (adjacency.Twin[side] == MeshAdjacency::Border)
    {
      const int next = NextSide(mesh, adjacency.Element[side], side);
      border.emplace_back(mesh.Vertices[side], mesh.Vertices[next]);
    }
  }
  std::sort(boundary.begin(), boundary.end());
  std::sort(border.begin(), border.end());
  return boundary == border;
}

} // namespace

std::string ClipMesh(
  const PolygonMesh& cells, const Domain& domain, double tolerance, ClippedMesh& clipped)
{
  BoundaryContacts contacts = FindBoundaryContacts(cells, domain, tolerance);
  std::vector<bool> isCut = FindCutCells(contacts);
  HoleLinks links(contacts);
  links.MarkCells(contacts, isCut);
  std::vector<HalfEdge> pieces = PieceCollector(contacts, isCut).Collect();
  links.AddTo(tolerance, contacts.Cells.Points, pieces);
  Parts parts = CollectParts(contacts, isCut, pieces);
  SpreadOverDomain(parts);
  std::vector<int> order(parts.Cells.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&parts](int a, int b) { return parts.Cells[a] < parts.Cells[b]; });
  clipped = {};
  for (const int part : order)
  {
    if (parts.IsInDomain[part])
    {
      clipped.Mesh.AddElement(parts.Mesh.Element(part));
      clipped.Cells.push_back(parts.Cells[part]);
    }
  }
  clipped.Mesh.Points = std::move(parts.Mesh.Points);
  if (!IsBorderTheBoundary(clipped.Mesh, pieces))
  {
    return "Where cells meet the boundary of the domain, rounding to double precision leaves gaps; "
           "change the number of cells or the seed.";
  }
  RemoveUnusedPoints(clipped.Mesh);
  return {};
}

} // namespace pemesh
