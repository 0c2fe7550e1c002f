// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * How large a triangle may be, as a function of place.
 *
 * The area bound of a place is that of an equilateral triangle whose side is
 *   s(x) = max( min( S, min_e (h_e + g d(x, e)) ), max_p (|p| - 1.5 d(x, p)) ),
 * S the side that belongs to the maximum area, e the edges of the polygons with their wanted sizes
 * h_e, g the gradation, p the segments that must not be split, d the distance. Without gradation
 * the second minimum is left out. The last term is there because an edge that must keep its length
 * has a round triangle only if that is about as large as the edge, and smaller triangles behind it
 * would be flat, layer upon layer. The slope of 1.5 was tried out on pairs of families: up to it
 * the minimum angle of 20 degrees was reached but for single triangles at a preserved edge, from 2
 * on it was not.
 */
#ifndef pemesh_SizeField_h
#define pemesh_SizeField_h

#include "DomainTriangulation.h"
#include "Point2.h"

#include <vector>

namespace pemesh
{

/**
 * The lower envelope of cones over segments: the least value_i + slope * distance to segment i.
 * A query takes logarithmic time where few segments come near the minimum.
 */
class ConeEnvelope
{
public:
  struct Cone
  {
    Point2 From;
    Point2 To;
    double Value;
  };

  ConeEnvelope() = default;
  ConeEnvelope(std::vector<Cone> cones, double slope);

  bool IsEmpty() const { return this->Cones.empty(); }
  double GetLeastValue() const { return this->Nodes.front().LeastValue; }

  /** The envelope, or `cap` if that is less. */
  double At(const Point2& point, double cap) const;

private:
  /** A box around some cones: those of its two children, which follow it, or its own if it is a
   * leaf. */
  struct Node
  {
    Point2 Low;
    Point2 High;
    double LeastValue;
    int First;
    int Last;   ///< one beyond
    int Second; ///< the second child (the first is the next node), or -1 for a leaf
  };

  void Build(int first, int last);
  double LowerBound(const Point2& point, const Node& node) const;

  std::vector<Cone> Cones;
  std::vector<Node> Nodes;
  double Slope = 0.0;
};

class SizeField
{
public:
  struct Options
  {
    double MaximumArea;
    double Gradation;      ///< growth of the wanted edge length per unit of distance; 0: off
    double SizeAtPolygons; ///< wanted edge length there; 0: the length of the polygon's own edge
    const std::vector<bool>& Preserved; ///< an input segment each
  };

  SizeField(const DomainBoundary& boundary, const Options& options);

  /** The greatest area of a triangle with its centroid there. */
  double AreaBoundAt(const Point2& point) const;

  /** Whether that is less than the area. Much faster, as most triangles are far below. */
  bool IsTooLarge(double area, const Point2& centroid) const;

  /** No place has a smaller bound. */
  double GetLeastBound() const { return this->LeastBound; }

  /** Whether all places have the same bound. */
  bool IsUniform() const { return this->Wanted.IsEmpty() && this->Preserved.IsEmpty(); }

  bool HasLongPreservedSegments() const { return !this->Preserved.IsEmpty(); }

private:
  double MaximumArea;
  double MaximumSide;
  double LeastBound;
  ConeEnvelope Wanted;
  ConeEnvelope Preserved; ///< of the negative lengths
};

} // namespace pemesh

#endif
