// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StraightVertices.h"

#include "PolygonMeasures.h"
#include "PolygonValidity.h"
#include "Predicates.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pemesh
{

namespace
{

/** What is across a side: an element, or -1. */
int ElementAcross(const MeshAdjacency& adjacency, int side)
{
  const int twin = adjacency.Twin[side];
  return twin < 0 ? -1 : adjacency.Element[twin];
}

class StraightVertexRemover
{
public:
  explicit StraightVertexRemover(PolygonMesh& mesh)
    : Mesh(mesh)
    , Adjacency(FindAdjacency(mesh))
    , IsExact(mesh.Points.size(), false)
    , IsRemoved(mesh.Points.size(), false)
  {
    double largest = 0.0;
    for (const int vertex : mesh.Vertices)
    {
      const Point2& point = mesh.Points[vertex];
      largest = std::max({ largest, std::abs(point.x), std::abs(point.y) });
    }
    this->Tolerance = 4.0 * 0x1p-52 * largest;
  }

  double Run(bool rounded)
  {
    for (int element = 0; element < this->Mesh.NumberOfElements(); ++element)
    {
      this->MarkExact(element);
    }
    this->IsRemoved = this->IsExact;
    if (rounded)
    {
      for (int element = 0; element < this->Mesh.NumberOfElements(); ++element)
      {
        this->MarkRounded(element);
      }
      this->KeepElementsSimple();
    }
    const double moved = rounded ? this->MovedArea() : 0.0;
    this->Remove();
    return moved;
  }

private:
  Point2 PointOf(int side) const { return this->Mesh.Points[this->Mesh.Vertices[side]]; }

  bool HasValenceTwo(int element, int side) const
  {
    return ElementAcross(this->Adjacency, side) ==
      ElementAcross(this->Adjacency, PreviousSide(this->Mesh, element, side));
  }

  void MarkExact(int element)
  {
    for (int side = this->Mesh.Offsets[element]; side < this->Mesh.Offsets[element + 1]; ++side)
    {
      if (this->HasValenceTwo(element, side) &&
        Orientation(this->PointOf(PreviousSide(this->Mesh, element, side)), this->PointOf(side),
          this->PointOf(NextSide(this->Mesh, element, side))) == 0)
      {
        this->IsExact[this->Mesh.Vertices[side]] = true;
      }
    }
  }

  /** Each run of vertices of valence two is looked at from one of its two elements. */
  void MarkRounded(int element)
  {
    const int begin = this->Mesh.Offsets[element];
    const int end = this->Mesh.Offsets[element + 1];
    for (int side = begin; side < end; ++side)
    {
      const int across = ElementAcross(this->Adjacency, side);
      if (!this->HasValenceTwo(element, side) && (across < 0 || element < across))
      {
        this->MarkRun(element, side);
      }
    }
  }

  /** From a side at a vertex that stays, to the next one that must stay. */
  void MarkRun(int element, int first)
  {
    this->Chain.assign(1, first);
    int side = NextSide(this->Mesh, element, first);
    for (; this->HasValenceTwo(element, side); side = NextSide(this->Mesh, element, side))
    {
      this->Chain.push_back(side);
    }
    this->Chain.push_back(side);
    for (std::size_t from = 0; from + 1 < this->Chain.size();)
    {
      std::size_t to = from + 1;
      while (to + 1 < this->Chain.size() && this->IsStraight(from, to + 1))
      {
        ++to;
      }
      for (std::size_t i = from + 1; i < to; ++i)
      {
        this->IsRemoved[this->Mesh.Vertices[this->Chain[i]]] = true;
      }
      from = to;
    }
  }

  /** Whether all between two vertices of the run lie on the segment, in order, but for rounding. */
  bool IsStraight(std::size_t from, std::size_t to) const
  {
    const Point2 a = this->PointOf(this->Chain[from]);
    const Point2 b = this->PointOf(this->Chain[to]);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    double reached = 0.0;
    for (std::size_t i = from + 1; i < to; ++i)
    {
      const Point2 v = this->PointOf(this->Chain[i]);
      const double along = ((b.x - a.x) * (v.x - a.x) + (b.y - a.y) * (v.y - a.y)) / length;
      const double off = ((b.x - a.x) * (v.y - a.y) - (b.y - a.y) * (v.x - a.x)) / length;
      if (!(std::abs(off) <= this->Tolerance && along >= reached && along <= length))
      {
        return false;
      }
      reached = along;
    }
    return true;
  }

  /** The vertices of an element that stay. */
  void CollectRest(int element, std::vector<Point2>& rest) const
  {
    rest.clear();
    for (const int vertex : this->Mesh.Element(element))
    {
      if (!this->IsRemoved[vertex])
      {
        rest.push_back(this->Mesh.Points[vertex]);
      }
    }
  }

  bool LosesInexactly(int element) const
  {
    const auto vertices = this->Mesh.Element(element);
    return std::any_of(vertices.begin(), vertices.end(),
      [this](int vertex) { return this->IsRemoved[vertex] && !this->IsExact[vertex]; });
  }

  /** What an element gets back, its neighbour gets back too, and must be looked at again. Ends,
   * because vertices only come back. */
  void KeepElementsSimple()
  {
    std::vector<Point2> rest;
    bool changed = true;
    while (changed)
    {
      changed = false;
      for (int element = 0; element < this->Mesh.NumberOfElements(); ++element)
      {
        if (!this->LosesInexactly(element))
        {
          continue;
        }
        this->CollectRest(element, rest);
        if (IsSimple(rest) && PolygonOrientation(rest) > 0)
        {
          continue;
        }
        changed = true;
        for (const int vertex : this->Mesh.Element(element))
        {
          this->IsRemoved[vertex] = this->IsExact[vertex];
        }
      }
    }
  }

  /** Between the runs removed and the segments in their place, each run once. */
  double MovedArea() const
  {
    double moved = 0.0;
    std::vector<Point2> run;
    for (int element = 0; element < this->Mesh.NumberOfElements(); ++element)
    {
      for (int side = this->Mesh.Offsets[element]; side < this->Mesh.Offsets[element + 1]; ++side)
      {
        const int across = ElementAcross(this->Adjacency, side);
        if (this->IsRemoved[this->Mesh.Vertices[side]] || (across >= 0 && across < element))
        {
          continue;
        }
        run.assign(1, this->PointOf(side));
        int next = NextSide(this->Mesh, element, side);
        for (; this->IsRemoved[this->Mesh.Vertices[next]];
             next = NextSide(this->Mesh, element, next))
        {
          run.push_back(this->PointOf(next));
        }
        run.push_back(this->PointOf(next));
        moved += std::abs(SignedArea(run));
      }
    }
    return moved;
  }

  void Remove()
  {
    PolygonMesh rest;
    std::vector<int> vertices;
    for (int element = 0; element < this->Mesh.NumberOfElements(); ++element)
    {
      vertices.clear();
      for (const int vertex : this->Mesh.Element(element))
      {
        if (!this->IsRemoved[vertex])
        {
          vertices.push_back(vertex);
        }
      }
      rest.AddElement(vertices);
    }
    this->Mesh.Offsets.swap(rest.Offsets);
    this->Mesh.Vertices.swap(rest.Vertices);
  }

  PolygonMesh& Mesh;
  MeshAdjacency Adjacency;
  std::vector<bool> IsExact;   ///< a point each: straight by exact arithmetic
  std::vector<bool> IsRemoved; ///< a point each
  std::vector<int> Chain;      ///< sides, from one vertex that stays to the next
  double Tolerance = 0.0;
};

} // namespace

double RemoveStraightVertices(PolygonMesh& mesh, StraightVertices which)
{
  return which == StraightVertices::Keep
    ? 0.0
    : StraightVertexRemover(mesh).Run(which == StraightVertices::RemoveRounded);
}

} // namespace pemesh
