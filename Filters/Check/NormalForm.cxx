// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "NormalForm.h"

#include "BoxTree.h"
#include "ParallelLoop.h"
#include "PolygonMeasures.h"
#include "PolygonValidity.h"
#include "Predicates.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

bool IsInRange(const PolygonMesh& mesh, int vertex)
{
  return vertex >= 0 && vertex < static_cast<int>(mesh.Points.size());
}

/** Points that are finite and in an element, in any order. */
std::vector<int> FindUsedPoints(const PolygonMesh& mesh, const std::vector<unsigned char>& isFinite)
{
  std::vector<unsigned char> isUsed(mesh.Points.size(), 0);
  for (const int vertex : mesh.Vertices)
  {
    if (IsInRange(mesh, vertex))
    {
      isUsed[vertex] = isFinite[vertex];
    }
  }
  std::vector<int> used;
  for (std::size_t i = 0; i < isUsed.size(); ++i)
  {
    if (isUsed[i])
    {
      used.push_back(static_cast<int>(i));
    }
  }
  return used;
}

void FindOriginals(const PolygonMesh& mesh, std::vector<int> used, std::vector<int>& original)
{
  const std::vector<Point2>& points = mesh.Points;
  std::sort(used.begin(), used.end(),
    [&](int a, int b)
    {
      const Point2& p = points[a];
      const Point2& q = points[b];
      return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : a < b;
    });
  original.assign(points.size(), -1);
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    const bool isCopy = i > 0 && points[used[i]] == points[used[i - 1]];
    original[used[i]] = isCopy ? original[used[i - 1]] : used[i];
  }
}

double DiagonalOf(const std::vector<Point2>& points, const std::vector<int>& used)
{
  if (used.empty())
  {
    return 0.0;
  }
  Box box = BoxOf(points[used[0]]);
  for (const int point : used)
  {
    box.Add(BoxOf(points[point]));
  }
  return std::hypot(box.East - box.West, box.North - box.South);
}

bool IsUsable(const NormalForm& form, std::span<const int> vertices)
{
  return std::all_of(vertices.begin(), vertices.end(),
    [&](int vertex) { return IsInRange(form.Mesh, vertex) && form.IsFinite[vertex]; });
}

/** Appends the vertices of an element, equal ones as one and none twice in a row. */
void AppendPlaces(NormalForm& form, std::span<const int> vertices)
{
  std::vector<int>& all = form.Mesh.Vertices;
  const std::size_t first = all.size();
  for (const int vertex : vertices)
  {
    const int original = form.Original[vertex];
    if (all.size() == first || all.back() != original)
    {
      all.push_back(original);
    }
  }
  while (all.size() > first + 1 && all.back() == all[first])
  {
    all.pop_back();
  }
}

void AppendStranded(NormalForm& form, std::span<const int> vertices)
{
  for (const int vertex : vertices)
  {
    if (IsInRange(form.Mesh, vertex) && form.IsFinite[vertex])
    {
      form.Stranded.push_back(form.Original[vertex]);
    }
  }
}

/** No vertex is at the place of the one before, so that it is enough that none turns. */
bool AreOnOneLine(PolygonView polygon)
{
  const std::size_t size = polygon.size();
  for (std::size_t i = 0; i < size; ++i)
  {
    if (Orientation(polygon[i], polygon[(i + 1) % size], polygon[(i + 2) % size]) != 0)
    {
      return false;
    }
  }
  return true;
}

/** Turns the element round if it is clockwise. */
ElementCondition Normalize(
  std::span<int> vertices, std::vector<Point2>& points, unsigned char& isConvex)
{
  if (vertices.size() < 3 || AreOnOneLine(points))
  {
    return ElementCondition::Flat;
  }
  const bool isClockwise = PolygonOrientation(points) < 0;
  if (isClockwise)
  {
    std::reverse(points.begin() + 1, points.end());
  }
  isConvex = PolygonOrientation(points) > 0 && IsConvex(points);
  if (!isConvex && FindSelfCrossing(points))
  {
    return ElementCondition::Crossing;
  }
  if (isClockwise)
  {
    std::reverse(vertices.begin() + 1, vertices.end());
  }
  return isClockwise ? ElementCondition::Clockwise : ElementCondition::Sound;
}

void NormalizeRange(NormalForm& form, vtkIdType first, vtkIdType last)
{
  std::vector<Point2> points;
  for (vtkIdType element = first; element < last; ++element)
  {
    if (form.Conditions[element] == ElementCondition::Unusable)
    {
      continue;
    }
    const int begin = form.Mesh.Offsets[element];
    const int end = form.Mesh.Offsets[element + 1];
    form.Mesh.GetVertices(static_cast<int>(element), points);
    form.Conditions[element] =
      Normalize({ form.Mesh.Vertices.data() + begin, static_cast<std::size_t>(end - begin) },
        points, form.IsConvex[element]);
  }
}

} // namespace

NormalForm MakeNormalForm(const PolygonMesh& mesh)
{
  NormalForm form;
  form.Mesh.Points = mesh.Points;
  form.IsFinite.resize(mesh.Points.size());
  std::transform(mesh.Points.begin(), mesh.Points.end(), form.IsFinite.begin(),
    [](const Point2& point) { return std::isfinite(point.x) && std::isfinite(point.y); });
  std::vector<int> used = FindUsedPoints(mesh, form.IsFinite);
  form.Diagonal = DiagonalOf(mesh.Points, used);
  FindOriginals(mesh, std::move(used), form.Original);
  const auto elements = static_cast<std::size_t>(mesh.NumberOfElements());
  form.Conditions.assign(elements, ElementCondition::Sound);
  form.IsConvex.assign(elements, 0);
  form.Mesh.Offsets.reserve(elements + 1);
  form.Mesh.Vertices.reserve(mesh.Vertices.size());
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    if (IsUsable(form, mesh.Element(element)))
    {
      AppendPlaces(form, mesh.Element(element));
    }
    else
    {
      form.Conditions[element] = ElementCondition::Unusable;
      AppendStranded(form, mesh.Element(element));
    }
    form.Mesh.Offsets.push_back(form.Mesh.NumberOfSides());
  }
  ParallelLoop(0, mesh.NumberOfElements(), 0,
    [&form](vtkIdType first, vtkIdType last) { NormalizeRange(form, first, last); });
  return form;
}

} // namespace pemesh
