// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Whether points lie in a domain, many of them.
 */
#ifndef pemesh_DomainLocator_h
#define pemesh_DomainLocator_h

#include "Domain.h"

#include <vector>

namespace pemesh
{

/** The least axis-parallel rectangle around a domain. */
struct Box
{
  Point2 Low;
  Point2 High;

  double Width() const { return this->High.x - this->Low.x; }
  double Height() const { return this->High.y - this->Low.y; }
};

Box BoxOf(const Domain& domain);

/** Cost of a question: the edges of the domain at the height of the point. */
class DomainLocator
{
public:
  explicit DomainLocator(const Domain& domain);

  /** Exact for points off the boundary; on it, either answer. */
  bool Contains(const Point2& point) const;

private:
  struct Edge
  {
    Point2 From;
    Point2 To;
  };
  int SlabOf(double y) const;

  Box Bounds;
  std::vector<Edge> Edges;
  std::vector<int> First; ///< the first entry of each slab in SlabEdges, and the end
  std::vector<int> SlabEdges;
};

} // namespace pemesh

#endif
