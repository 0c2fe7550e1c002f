// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DomainLocator.h"

#include "Predicates.h"

#include <algorithm>

namespace pemesh
{

Box BoxOf(const Domain& domain)
{
  Box box = { domain.Outer[0], domain.Outer[0] };
  for (const Point2& point : domain.Outer)
  {
    box.Low = { std::min(box.Low.x, point.x), std::min(box.Low.y, point.y) };
    box.High = { std::max(box.High.x, point.x), std::max(box.High.y, point.y) };
  }
  return box;
}

DomainLocator::DomainLocator(const Domain& domain)
  : Bounds(BoxOf(domain))
{
  const auto addLoop = [this](const std::vector<Point2>& loop)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      this->Edges.push_back({ loop[i], loop[(i + 1) % loop.size()] });
    }
  };
  addLoop(domain.Outer);
  std::for_each(domain.Holes.begin(), domain.Holes.end(), addLoop);

  // As many slabs as edges; counted first, then filled.
  const auto forSlabsOf = [this](const Edge& edge, const auto& visit)
  {
    const int last = this->SlabOf(std::max(edge.From.y, edge.To.y));
    for (int slab = this->SlabOf(std::min(edge.From.y, edge.To.y)); slab <= last; ++slab)
    {
      visit(slab);
    }
  };
  this->First.assign(this->Edges.size() + 1, 0);
  for (const Edge& edge : this->Edges)
  {
    forSlabsOf(edge, [this](int slab) { ++this->First[slab + 1]; });
  }
  for (std::size_t i = 1; i < this->First.size(); ++i)
  {
    this->First[i] += this->First[i - 1];
  }
  this->SlabEdges.resize(this->First.back());
  std::vector<int> next(this->First.begin(), this->First.end() - 1);
  for (std::size_t i = 0; i < this->Edges.size(); ++i)
  {
    forSlabsOf(this->Edges[i],
      [this, &next, i](int slab) { this->SlabEdges[next[slab]++] = static_cast<int>(i); });
  }
}

int DomainLocator::SlabOf(double y) const
{
  const double slabs =
    static_cast<double>(this->First.empty() ? this->Edges.size() : this->First.size() - 1);
  const double slab = (y - this->Bounds.Low.y) / this->Bounds.Height() * slabs;
  return static_cast<int>(std::clamp(slab, 0.0, slabs - 1.0));
}

bool DomainLocator::Contains(const Point2& point) const
{
  if (!(point.x > this->Bounds.Low.x && point.x < this->Bounds.High.x &&
        point.y > this->Bounds.Low.y && point.y < this->Bounds.High.y))
  {
    return false;
  }
  const int slab = this->SlabOf(point.y);
  bool inside = false;
  for (int i = this->First[slab]; i < this->First[slab + 1]; ++i)
  {
    const Edge& edge = this->Edges[this->SlabEdges[i]];
    const bool upward = edge.From.y <= point.y && point.y < edge.To.y;
    const bool downward = edge.To.y <= point.y && point.y < edge.From.y;
    if ((upward && Orientation(edge.From, edge.To, point) > 0) ||
      (downward && Orientation(edge.From, edge.To, point) < 0))
    {
      inside = !inside;
    }
  }
  return inside;
}

} // namespace pemesh
