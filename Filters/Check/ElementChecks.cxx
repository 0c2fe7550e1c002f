// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The checks of one element at a time.
 */
#include "BoxTree.h"
#include "CheckFunctions.h"
#include "NumberText.h"
#include "PointDistances.h"
#include "PolygonMeasures.h"
#include "PolygonValidity.h"

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

std::string NameOf(int element)
{
  return "Element " + std::to_string(element);
}

std::string NameOfSide(std::span<const int> vertices, std::size_t side)
{
  return std::to_string(vertices[side]) + "-" +
    std::to_string(vertices[(side + 1) % vertices.size()]);
}

/** The first vertex of the element for which `isAtFault(vertex)` holds, or null. */
template <typename IsAtFault>
const int* FindVertex(const PolygonMesh& mesh, int element, const IsAtFault& isAtFault)
{
  const std::span<const int> vertices = mesh.Element(element);
  const auto found = std::find_if(vertices.begin(), vertices.end(), isAtFault);
  return found == vertices.end() ? nullptr : &*found;
}

double Median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  // NaN has no place in an order: it counts as very high.
  std::nth_element(values.begin(), middle, values.end(),
    [](double a, double b) { return a < b || (std::isnan(b) && !std::isnan(a)); });
  return *middle;
}

/** Two neighbours in the cycle of vertices that are at the same place. */
std::pair<int, int> FindRepeatedVertex(const NormalForm& form, std::span<const int> vertices)
{
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const int next = vertices[(i + 1) % vertices.size()];
    if (form.Original[vertices[i]] == form.Original[next])
    {
      return { vertices[i], next };
    }
  }
  return { -1, -1 };
}

double DiameterOf(const PolygonMesh& mesh, int element)
{
  std::vector<Point2> points;
  mesh.GetVertices(element, points);
  return Diameter(points);
}

} // namespace

void CheckVertexIds(MeshUnderCheck& mesh, FindingList& findings)
{
  for (int element = 0; element < mesh.GetMesh().NumberOfElements(); ++element)
  {
    const int* vertex = FindVertex(
      mesh.GetMesh(), element, [&mesh](int candidate) { return !mesh.IsInRange(candidate); });
    if (vertex)
    {
      findings.Add({ element }, {}, mesh.PlaceOfElement(element),
        [&]
        {
          return NameOf(element) + " uses vertex " + std::to_string(*vertex) +
            ", and the mesh has " + std::to_string(mesh.GetMesh().Points.size()) + " vertices.";
        });
    }
  }
}

void CheckFinite(MeshUnderCheck& mesh, FindingList& findings)
{
  const NormalForm& form = mesh.GetNormalForm();
  for (int element = 0; element < mesh.GetMesh().NumberOfElements(); ++element)
  {
    const int* vertex = FindVertex(mesh.GetMesh(), element,
      [&](int candidate) { return mesh.IsInRange(candidate) && !form.IsFinite[candidate]; });
    if (vertex)
    {
      findings.Add({ element }, { *vertex }, mesh.PlaceOfElement(element),
        [&]
        {
          return NameOf(element) + " has vertex " + std::to_string(*vertex) +
            ", which has a coordinate that is not a finite number.";
        });
    }
  }
}

void CheckPlanar(MeshUnderCheck& mesh, FindingList& findings)
{
  const std::vector<double>& heights = mesh.GetHeights();
  if (heights.empty())
  {
    return;
  }
  const double level = Median(heights);
  for (int element = 0; element < mesh.GetMesh().NumberOfElements(); ++element)
  {
    const int* vertex = FindVertex(mesh.GetMesh(), element,
      [&](int candidate) { return mesh.IsInRange(candidate) && heights[candidate] != level; });
    if (vertex)
    {
      findings.Add({ element }, { *vertex }, mesh.GetMesh().Points[*vertex],
        [&]
        {
          return NameOf(element) + " has vertex " + std::to_string(*vertex) + " at height " +
            FormatNumber(heights[*vertex]) + " instead of " + FormatNumber(level) + ".";
        });
    }
  }
}

void CheckDegenerate(MeshUnderCheck& mesh, FindingList& findings)
{
  const NormalForm& form = mesh.GetNormalForm();
  for (int element = 0; element < mesh.GetMesh().NumberOfElements(); ++element)
  {
    const std::span<const int> vertices = mesh.GetMesh().Element(element);
    const std::size_t places = form.Mesh.Element(element).size();
    const ElementCondition condition = form.Conditions[element];
    std::string fault;
    std::pair<int, int> repeated = { -1, -1 };
    if (vertices.size() < 3)
    {
      fault = " has fewer than three vertices.";
    }
    else if (condition == ElementCondition::Flat)
    {
      fault = places < 3 ? " has no area: its vertices are at fewer than three places."
                         : " has no area: its vertices are on one line.";
    }
    else if (condition != ElementCondition::Unusable && places < vertices.size())
    {
      repeated = FindRepeatedVertex(form, vertices);
      fault = repeated.first == repeated.second
        ? " has vertex " + std::to_string(repeated.first) + " twice in a row."
        : " has vertices " + std::to_string(repeated.first) + " and " +
          std::to_string(repeated.second) + " in a row, which are at the same place.";
    }
    if (!fault.empty())
    {
      const int first[1] = { repeated.first };
      findings.Add(std::span<const int>(&element, 1),
        std::span<const int>(first, repeated.first < 0 ? 0 : 1), mesh.PlaceOfElement(element),
        [&] { return NameOf(element) + fault; });
    }
  }
}

void CheckSimple(MeshUnderCheck& mesh, FindingList& findings)
{
  const NormalForm& form = mesh.GetNormalForm();
  std::vector<Point2> points;
  for (int element = 0; element < form.Mesh.NumberOfElements(); ++element)
  {
    if (form.Conditions[element] != ElementCondition::Crossing)
    {
      continue;
    }
    const std::span<const int> vertices = form.Mesh.Element(element);
    form.Mesh.GetVertices(element, points);
    const EdgePair pair = FindSelfCrossing(points).value_or(EdgePair{});
    const Point2& from = points[pair.First];
    const Point2& to = points[(pair.First + 1) % points.size()];
    const int ends[4] = { vertices[pair.First], vertices[(pair.First + 1) % vertices.size()],
      vertices[pair.Second], vertices[(pair.Second + 1) % vertices.size()] };
    findings.Add(std::span<const int>(&element, 1), ends,
      { 0.5 * from.x + 0.5 * to.x, 0.5 * from.y + 0.5 * to.y },
      [&]
      {
        return NameOf(element) + " crosses or touches itself: its sides " +
          NameOfSide(vertices, pair.First) + " and " + NameOfSide(vertices, pair.Second) + " meet.";
      });
  }
}

void CheckOrientation(MeshUnderCheck& mesh, FindingList& findings)
{
  const NormalForm& form = mesh.GetNormalForm();
  for (int element = 0; element < form.Mesh.NumberOfElements(); ++element)
  {
    if (form.Conditions[element] == ElementCondition::Clockwise)
    {
      findings.Add({ element }, {}, mesh.PlaceOfElement(element),
        [&] { return NameOf(element) + " is clockwise."; });
    }
  }
}

void CheckSlivers(MeshUnderCheck& mesh, FindingList& findings)
{
  const NormalForm& form = mesh.GetNormalForm();
  const double least = mesh.GetOptions().SliverThickness;
  std::vector<Point2> points;
  for (int element = 0; element < form.Mesh.NumberOfElements(); ++element)
  {
    if (!IsSimple(form.Conditions[element]))
    {
      continue;
    }
    form.Mesh.GetVertices(element, points);
    Box box = BoxOf(points[0]);
    for (const Point2& point : points)
    {
      box.Add(BoxOf(point));
    }
    // The diagonal of the box is at least the diameter: most elements need no more than that.
    const double area = SignedArea(points);
    const double diagonal = std::hypot(box.East - box.West, box.North - box.South);
    if (2.0 * (area / diagonal) >= least * diagonal)
    {
      continue;
    }
    const double diameter = DiameterOf(form.Mesh, element);
    const double thickness = 2.0 * (area / diameter) / diameter;
    if (thickness < least)
    {
      findings.Add({ element }, {}, mesh.PlaceOfElement(element),
        [&]
        {
          return NameOf(element) + " is a sliver: twice its area over its diameter squared is " +
            FormatNumber(thickness) + ".";
        });
    }
  }
}

} // namespace pemesh
