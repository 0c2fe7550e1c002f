// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TriangulatePolygon.h"

#include "PolygonMeasures.h"
#include "Predicates.h"

#include <algorithm>

namespace pemesh
{

namespace
{

const Point2& At(PolygonView polygon, int vertex)
{
  return polygon[static_cast<std::size_t>(vertex)];
}

/** Whether p is in the triangle with its boundary, or only inside; its corners do not count. */
bool IsInTriangle(const Point2& p, const Point2& a, const Point2& b, const Point2& c, bool strictly)
{
  if (p.x < std::min({ a.x, b.x, c.x }) || p.x > std::max({ a.x, b.x, c.x }) ||
    p.y < std::min({ a.y, b.y, c.y }) || p.y > std::max({ a.y, b.y, c.y }) || p == a || p == b ||
    p == c)
  {
    return false;
  }
  const int least = strictly ? 1 : 0;
  return Orientation(c, a, p) >= least && Orientation(a, b, p) >= least &&
    Orientation(b, c, p) >= least;
}

} // namespace

const std::vector<PolygonTriangle>& PolygonTriangulator::Triangulate(PolygonView polygon)
{
  this->Triangles.clear();
  this->Polygon = polygon;
  const int orientation = PolygonOrientation(polygon);
  if (orientation == 0)
  {
    return this->Triangles;
  }
  this->LinkVertices(orientation < 0);
  int vertex = this->Next[0];
  while (this->Remaining >= 3)
  {
    int ear = this->FindEar(vertex, false);
    if (ear < 0)
    {
      // Only polygons that touch or cross themselves come here.
      ear = this->FindEar(vertex, true);
    }
    if (ear >= 0)
    {
      // Past the neighbour, for a fan of needles serves nobody.
      vertex = this->Next[static_cast<std::size_t>(this->Next[static_cast<std::size_t>(ear)])];
      this->CutEar(ear);
    }
    else
    {
      vertex = this->Remove(vertex);
    }
  }
  return this->Triangles;
}

/** A ring of the vertices, counter-clockwise, without repeats in a row. */
void PolygonTriangulator::LinkVertices(bool reversed)
{
  const std::size_t size = this->Polygon.size();
  this->Next.resize(size);
  this->Previous.resize(size);
  this->Turn.resize(size);
  this->Remaining = static_cast<int>(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    const int after = static_cast<int>(i + 1 == size ? 0 : i + 1);
    const int before = static_cast<int>(i == 0 ? size - 1 : i - 1);
    this->Next[i] = reversed ? before : after;
    this->Previous[i] = reversed ? after : before;
    this->Turn[i] = 1;
  }
  for (std::size_t i = 0; i < size; ++i)
  {
    const auto next = static_cast<std::size_t>(this->Next[i]);
    if (this->Polygon[i] == this->Polygon[next] && next != i)
    {
      const auto previous = static_cast<std::size_t>(this->Previous[i]);
      this->Next[previous] = static_cast<int>(next);
      this->Previous[next] = static_cast<int>(previous);
      this->Next[i] = -1;
      --this->Remaining;
    }
  }
  this->Reflex.clear();
  int inRing = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    if (this->Next[i] < 0)
    {
      continue;
    }
    inRing = static_cast<int>(i);
    this->Turn[i] = this->TurnAt(inRing);
    if (this->Turn[i] <= 0)
    {
      this->Reflex.push_back(inRing);
    }
  }
  if (this->Next[0] < 0)
  {
    this->Next[0] = inRing; // not in the ring itself: only the way in
  }
}

int PolygonTriangulator::TurnAt(int vertex) const
{
  const auto i = static_cast<std::size_t>(vertex);
  return Orientation(
    At(this->Polygon, this->Previous[i]), this->Polygon[i], At(this->Polygon, this->Next[i]));
}

bool PolygonTriangulator::IsEar(int vertex, bool strictly) const
{
  const auto i = static_cast<std::size_t>(vertex);
  if (this->Turn[i] <= 0)
  {
    return false;
  }
  const int previous = this->Previous[i];
  const int next = this->Next[i];
  const Point2& a = At(this->Polygon, previous);
  const Point2& b = this->Polygon[i];
  const Point2& c = At(this->Polygon, next);
  return std::none_of(this->Reflex.begin(), this->Reflex.end(),
    [&](int other)
    {
      return this->Turn[static_cast<std::size_t>(other)] <= 0 && other != previous &&
        other != next && IsInTriangle(At(this->Polygon, other), a, b, c, strictly);
    });
}

/** The first ear from `start` on, or -1. */
int PolygonTriangulator::FindEar(int start, bool strictly) const
{
  int vertex = start;
  for (int i = 0; i < this->Remaining; ++i)
  {
    if (this->IsEar(vertex, strictly))
    {
      return vertex;
    }
    vertex = this->Next[static_cast<std::size_t>(vertex)];
  }
  return -1;
}

void PolygonTriangulator::CutEar(int vertex)
{
  const auto i = static_cast<std::size_t>(vertex);
  this->Triangles.push_back({ this->Previous[i], vertex, this->Next[i] });
  this->Remove(vertex);
}

/** Takes a vertex out of the ring and returns the next one. */
int PolygonTriangulator::Remove(int vertex)
{
  const auto i = static_cast<std::size_t>(vertex);
  const int next = this->Next[i];
  const int previous = this->Previous[i];
  this->Next[static_cast<std::size_t>(previous)] = next;
  this->Previous[static_cast<std::size_t>(next)] = previous;
  this->Turn[i] = 1; // blocks nothing any more
  --this->Remaining;
  // Angles only get smaller, so no vertex has to enter the list of those that block.
  this->Turn[static_cast<std::size_t>(next)] = this->TurnAt(next);
  this->Turn[static_cast<std::size_t>(previous)] = this->TurnAt(previous);
  return next;
}

std::vector<PolygonTriangle> TriangulatePolygon(PolygonView polygon)
{
  PolygonTriangulator triangulator;
  return triangulator.Triangulate(polygon);
}

} // namespace pemesh
