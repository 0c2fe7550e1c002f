// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The check for elements whose interiors meet.
 *
 * Convex sets are apart if a line along a side of one of them has the other on its far side (the
 * separating axis of two polygons); concave elements are cut into triangles, whose corners are
 * vertices of the mesh. So orientations of three vertices decide everything, exactly.
 */
#include "BoxTree.h"
#include "CheckFunctions.h"
#include "ParallelLoop.h"
#include "Predicates.h"
#include "TriangulatePolygon.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <utility>

namespace pemesh
{

namespace
{

using ElementPair = std::pair<int, int>;

/** The elements as convex pieces. */
class ConvexPieces
{
public:
  explicit ConvexPieces(const NormalForm& form)
    : Form(form)
  {
    PolygonTriangulator triangulator;
    std::vector<Point2> points;
    this->First.push_back(0);
    for (int element = 0; element < form.Mesh.NumberOfElements(); ++element)
    {
      if (IsSimple(form.Conditions[element]) && !form.IsConvex[element])
      {
        form.Mesh.GetVertices(element, points);
        const std::span<const int> vertices = form.Mesh.Element(element);
        for (const PolygonTriangle& triangle : triangulator.Triangulate(points))
        {
          this->Triangles.push_back(
            { vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]] });
        }
      }
      this->First.push_back(static_cast<int>(this->Triangles.size()));
    }
  }

  Box BoxOfElement(int element) const { return this->BoxOfPiece(this->Form.Mesh.Element(element)); }

  bool DoInteriorsMeet(int first, int second) const
  {
    const Box box = this->BoxOfElement(second);
    const int count = this->CountPieces(second);
    for (int i = 0; i < this->CountPieces(first); ++i)
    {
      const std::span<const int> piece = this->Piece(first, i);
      const Box pieceBox = this->BoxOfPiece(piece);
      if (!pieceBox.Meets(box))
      {
        continue;
      }
      for (int j = 0; j < count; ++j)
      {
        const std::span<const int> other = this->Piece(second, j);
        if (this->BoxOfPiece(other).Meets(pieceBox) && !this->IsSeparatedBySide(piece, other) &&
          !this->IsSeparatedBySide(other, piece))
        {
          return true;
        }
      }
    }
    return false;
  }

private:
  int CountPieces(int element) const
  {
    return this->Form.IsConvex[element] ? 1 : this->First[element + 1] - this->First[element];
  }

  std::span<const int> Piece(int element, int index) const
  {
    return this->Form.IsConvex[element] ? this->Form.Mesh.Element(element)
                                        : this->Triangles[this->First[element] + index];
  }

  Box BoxOfPiece(std::span<const int> vertices) const
  {
    Box box = BoxOf(this->Form.Mesh.Points[vertices[0]]);
    for (const int vertex : vertices.subspan(1))
    {
      box.Add(BoxOf(this->Form.Mesh.Points[vertex]));
    }
    return box;
  }

  /** Whether a side of `piece` has all vertices of `other` on its right or on its line. */
  bool IsSeparatedBySide(std::span<const int> piece, std::span<const int> other) const
  {
    const std::vector<Point2>& points = this->Form.Mesh.Points;
    for (std::size_t i = 0; i < piece.size(); ++i)
    {
      const int from = piece[i];
      const int to = piece[i + 1 == piece.size() ? 0 : i + 1];
      // A shared vertex is on the line: to ask for its sign would need exact arithmetic.
      const bool isBeyond = std::all_of(other.begin(), other.end(),
        [&](int vertex)
        {
          return vertex == from || vertex == to ||
            Orientation(points[from], points[to], points[vertex]) <= 0;
        });
      if (isBeyond)
      {
        return true;
      }
    }
    return false;
  }

  const NormalForm& Form;
  std::vector<int> First;
  std::vector<std::array<int, 3>> Triangles;
};

BoxTree MakeTree(const NormalForm& form, const ConvexPieces& pieces)
{
  std::vector<std::pair<int, Box>> items;
  items.reserve(form.Conditions.size());
  for (int element = 0; element < form.Mesh.NumberOfElements(); ++element)
  {
    if (IsSimple(form.Conditions[element]))
    {
      items.emplace_back(element, pieces.BoxOfElement(element));
    }
  }
  return BoxTree(std::move(items));
}

/** Sorted. */
std::vector<ElementPair> FindOverlaps(const NormalForm& form)
{
  // Where an element lies over more than so many others, the mesh is beyond counting pairs.
  constexpr int MostOfOne = 100;
  const ConvexPieces pieces(form);
  const BoxTree tree = MakeTree(form, pieces);
  std::vector<ElementPair> overlaps;
  std::mutex mutex;
  ParallelLoop(0, form.Mesh.NumberOfElements(), 0,
    [&](vtkIdType first, vtkIdType last)
    {
      std::vector<ElementPair> found;
      for (int element = static_cast<int>(first); element < static_cast<int>(last); ++element)
      {
        if (!IsSimple(form.Conditions[element]))
        {
          continue;
        }
        int partners = 0;
        tree.Query(pieces.BoxOfElement(element),
          [&](int other)
          {
            if (other > element && pieces.DoInteriorsMeet(element, other))
            {
              found.emplace_back(element, other);
              ++partners;
            }
            return partners < MostOfOne;
          });
      }
      const std::lock_guard<std::mutex> lock(mutex);
      overlaps.insert(overlaps.end(), found.begin(), found.end());
    });
  std::sort(overlaps.begin(), overlaps.end());
  return overlaps;
}

/** Pairs that overlap by rounding only, because a vertex is not quite on a side; sorted. */
std::vector<ElementPair> FindPairsAtNearJunctions(const MeshSides& sides, const PolygonMesh& mesh)
{
  std::vector<unsigned char> isNear(mesh.Points.size(), 0);
  for (const Junction& junction : sides.Junctions)
  {
    isNear[junction.Vertex] |= static_cast<unsigned char>(!junction.IsExact);
  }
  const ElementsAround around(mesh, isNear);
  std::vector<ElementPair> pairs;
  for (const Junction& junction : sides.Junctions)
  {
    if (!junction.IsExact)
    {
      for (const int element : around.Get(junction.Vertex))
      {
        pairs.push_back(std::minmax(element, junction.Element));
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Point2 CommonPlace(const Box& a, const Box& b)
{
  const double west = std::max(a.West, b.West);
  const double south = std::max(a.South, b.South);
  return { 0.5 * west + 0.5 * std::min(a.East, b.East),
    0.5 * south + 0.5 * std::min(a.North, b.North) };
}

} // namespace

void CheckOverlaps(MeshUnderCheck& mesh, FindingList& findings)
{
  const NormalForm& form = mesh.GetNormalForm();
  const std::vector<ElementPair> overlaps = FindOverlaps(form);
  if (overlaps.empty())
  {
    return;
  }
  const std::vector<ElementPair> byRounding = FindPairsAtNearJunctions(mesh.GetSides(), form.Mesh);
  const auto boxOf = [&form](int element)
  {
    const std::span<const int> vertices = form.Mesh.Element(element);
    Box box = BoxOf(form.Mesh.Points[vertices[0]]);
    for (const int vertex : vertices)
    {
      box.Add(BoxOf(form.Mesh.Points[vertex]));
    }
    return box;
  };
  for (const auto& [first, second] : overlaps)
  {
    if (!std::binary_search(byRounding.begin(), byRounding.end(), ElementPair(first, second)))
    {
      findings.Add({ first, second }, {}, CommonPlace(boxOf(first), boxOf(second)),
        [first = first, second = second] {
          return "Elements " + std::to_string(first) + " and " + std::to_string(second) +
            " overlap.";
        });
    }
  }
}

} // namespace pemesh
