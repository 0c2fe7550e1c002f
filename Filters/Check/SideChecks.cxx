// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The checks of how elements hang together, and of the border.
 */
#include "BoxTree.h"
#include "CheckFunctions.h"
#include "NumberText.h"
#include "PolygonMeasures.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pemesh
{

namespace
{

Point2 MiddleOf(const Point2& a, const Point2& b)
{
  return { 0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y };
}

std::string NameOfSide(int from, int to)
{
  return std::to_string(from) + "-" + std::to_string(to);
}

/** "3, 5 and 8"; of many the first few and their number. */
std::string ListOf(const std::vector<int>& numbers)
{
  constexpr std::size_t Most = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(numbers.size(), Most); ++i)
  {
    const bool isLast = i + 1 == numbers.size();
    text += (i == 0 ? "" : isLast ? " and " : ", ") + std::to_string(numbers[i]);
  }
  return text +
    (numbers.size() > Most ? " and " + std::to_string(numbers.size() - Most) + " more" : "");
}

bool IsExplained(const MeshSides& sides, std::span<const int> vertices)
{
  return std::any_of(vertices.begin(), vertices.end(),
    [&sides](int vertex) { return sides.IsExplained[vertex] != 0; });
}

std::vector<Point2> PointsOf(const PolygonMesh& mesh, std::span<const int> vertices)
{
  std::vector<Point2> points;
  for (const int vertex : vertices)
  {
    points.push_back(mesh.Points[vertex]);
  }
  return points;
}

Point2 MeanOf(const std::vector<Point2>& points)
{
  Point2 mean;
  for (const Point2& point : points)
  {
    mean.x += point.x / static_cast<double>(points.size());
    mean.y += point.y / static_cast<double>(points.size());
  }
  return mean;
}

/** Whether points lie on the boundary of a domain, but for rounding. */
class BoundaryOfDomain
{
public:
  BoundaryOfDomain(const Domain& domain, double distance)
    : Distance(distance)
  {
    this->AddLoop(domain.Outer);
    for (const std::vector<Point2>& hole : domain.Holes)
    {
      this->AddLoop(hole);
    }
    std::vector<std::pair<int, Box>> items;
    for (std::size_t i = 0; i < this->Sides.size(); ++i)
    {
      items.emplace_back(static_cast<int>(i), BoxOf(this->Sides[i].first, this->Sides[i].second));
    }
    this->Tree.emplace(std::move(items));
  }

  bool Has(const Point2& point) const
  {
    bool isOn = false;
    this->Tree->Query(Inflated(BoxOf(point), this->Distance),
      [&](int side)
      {
        isOn = this->DistanceTo(this->Sides[side], point) <= this->Distance;
        return !isOn;
      });
    return isOn;
  }

private:
  using Side = std::pair<Point2, Point2>;

  void AddLoop(const std::vector<Point2>& loop)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      this->Sides.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
    }
  }

  static double DistanceTo(const Side& side, const Point2& point)
  {
    const auto& [a, b] = side;
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const double x = (b.x - a.x) / length;
    const double y = (b.y - a.y) / length;
    const double along = std::clamp((point.x - a.x) * x + (point.y - a.y) * y, 0.0, length);
    return std::hypot(point.x - (a.x + along * x), point.y - (a.y + along * y));
  }

  double Distance;
  std::vector<Side> Sides;
  std::optional<BoxTree> Tree;
};

BoundaryOfDomain MakeBoundary(MeshUnderCheck& mesh)
{
  const CheckOptions& options = mesh.GetOptions();
  return { *options.ExpectedDomain, options.Tolerance * mesh.GetNormalForm().Diagonal };
}

void CheckArea(MeshUnderCheck& mesh, FindingList& findings)
{
  const NormalForm& form = mesh.GetNormalForm();
  double area = 0.0;
  std::vector<Point2> points;
  for (int element = 0; element < form.Mesh.NumberOfElements(); ++element)
  {
    if (!IsSimple(form.Conditions[element]))
    {
      return; // reported, and the area has no meaning then
    }
    form.Mesh.GetVertices(element, points);
    area += SignedArea(points);
  }
  const Domain& domain = *mesh.GetOptions().ExpectedDomain;
  const double expected = DomainArea(domain);
  if (!(std::abs(area - expected) <= mesh.GetOptions().AreaTolerance * expected))
  {
    findings.Add({}, {}, MeanOf(domain.Outer),
      [&]
      {
        return "The areas of the elements add up to " + FormatNumber(area) +
          ", and the area of the domain is " + FormatNumber(expected) + ".";
      });
  }
}

} // namespace

void CheckSides(MeshUnderCheck& mesh, FindingList& findings)
{
  const std::vector<Point2>& points = mesh.GetMesh().Points;
  for (const SideConflict& conflict : mesh.GetSides().Conflicts)
  {
    const int ends[2] = { conflict.From, conflict.To };
    findings.Add(conflict.Elements, ends, MiddleOf(points[conflict.From], points[conflict.To]),
      [&]
      {
        const std::string side = NameOfSide(conflict.From, conflict.To);
        const std::string elements = ListOf(conflict.Elements);
        return conflict.Elements.size() > 2
          ? "Side " + side + " has more than two elements: " + elements + "."
          : "Elements " + elements + " lie on the same side of side " + side + ".";
      });
  }
}

void CheckTJunctions(MeshUnderCheck& mesh, FindingList& findings)
{
  const MeshSides& sides = mesh.GetSides();
  for (const Junction& junction : sides.Junctions)
  {
    const int vertices[3] = { junction.Vertex, junction.From, junction.To };
    if (IsExplained(sides, vertices))
    {
      continue;
    }
    findings.Add(std::span<const int>(&junction.Element, 1), vertices,
      mesh.GetMesh().Points[junction.Vertex],
      [&]
      {
        return "Vertex " + std::to_string(junction.Vertex) + " lies " +
          (junction.IsExact ? "exactly" : "within rounding") + " on side " +
          NameOfSide(junction.From, junction.To) + " of element " +
          std::to_string(junction.Element) + ", which does not have it.";
      });
  }
}

void CheckPinchedVertices(MeshUnderCheck& mesh, FindingList& findings)
{
  const MeshSides& sides = mesh.GetSides();
  std::vector<int> pinched;
  for (std::size_t i = 1; i < sides.Border.size(); ++i)
  {
    const int vertex = sides.Border[i].From;
    const bool isNew = pinched.empty() || pinched.back() != vertex;
    if (isNew && sides.Border[i - 1].From == vertex && !sides.IsExplained[vertex])
    {
      pinched.push_back(vertex);
    }
  }
  std::vector<unsigned char> isPinched(mesh.GetMesh().Points.size(), 0);
  for (const int vertex : pinched)
  {
    isPinched[vertex] = 1;
  }
  const ElementsAround around(mesh.GetNormalForm().Mesh, isPinched);
  for (const int vertex : pinched)
  {
    const std::vector<int> elements = around.Get(vertex);
    findings.Add(elements, std::span<const int>(&vertex, 1), mesh.GetMesh().Points[vertex],
      [&]
      {
        return "Elements " + ListOf(elements) + " around vertex " + std::to_string(vertex) +
          " are not all joined by sides there.";
      });
  }
}

void CheckConnected(MeshUnderCheck& mesh, FindingList& findings)
{
  const MeshSides& sides = mesh.GetSides();
  if (sides.NumberOfComponents < 2)
  {
    return;
  }
  const PolygonMesh& form = mesh.GetNormalForm().Mesh;
  const auto components = static_cast<std::size_t>(sides.NumberOfComponents);
  std::vector<int> first(components, -1);
  std::vector<int> size(components, 0);
  std::vector<unsigned char> isExplained(components, 0);
  for (int element = 0; element < form.NumberOfElements(); ++element)
  {
    const int component = sides.Component[element];
    if (component >= 0)
    {
      first[component] = first[component] < 0 ? element : first[component];
      ++size[component];
      isExplained[component] |=
        static_cast<unsigned char>(IsExplained(sides, form.Element(element)));
    }
  }
  const auto largest = std::max_element(size.begin(), size.end()) - size.begin();
  for (std::size_t i = 0; i < components; ++i)
  {
    if (static_cast<std::ptrdiff_t>(i) != largest && !isExplained[i])
    {
      findings.Add({ first[i] }, {}, mesh.PlaceOfElement(first[i]),
        [&]
        {
          return size[i] == 1 ? "No side joins element " + std::to_string(first[i]) + " to another."
                              : "No side joins element " + std::to_string(first[i]) + " and " +
              std::to_string(size[i] - 1) + " others to the rest of the mesh.";
        });
    }
  }
}

void CheckHoles(MeshUnderCheck& mesh, FindingList& findings)
{
  const MeshSides& sides = mesh.GetSides();
  std::optional<BoundaryOfDomain> boundary;
  if (mesh.GetOptions().ExpectedDomain)
  {
    boundary.emplace(MakeBoundary(mesh));
  }
  for (const std::vector<int>& loop : sides.Loops)
  {
    const std::vector<Point2> points = PointsOf(mesh.GetMesh(), loop);
    const double area = SignedArea(points);
    const bool isExpected = boundary &&
      std::all_of(
        points.begin(), points.end(), [&](const Point2& point) { return boundary->Has(point); });
    if (area < 0.0 && !isExpected && !IsExplained(sides, loop))
    {
      findings.Add({}, std::span<const int>(loop.data(), 1), MeanOf(points),
        [&]
        {
          return "A hole of " + std::to_string(loop.size()) + " sides and area " +
            FormatNumber(-area) + " begins at vertex " + std::to_string(loop[0]) + ".";
        });
    }
  }
}

void CheckCoverage(MeshUnderCheck& mesh, FindingList& findings)
{
  if (!mesh.GetOptions().ExpectedDomain)
  {
    return;
  }
  CheckArea(mesh, findings);
  const MeshSides& sides = mesh.GetSides();
  const BoundaryOfDomain boundary = MakeBoundary(mesh);
  int previous = -1;
  for (const BorderPiece& piece : sides.Border)
  {
    const Point2& point = mesh.GetMesh().Points[piece.From];
    if (piece.From != previous && !sides.IsExplained[piece.From] && !boundary.Has(point))
    {
      findings.Add({ piece.Element }, { piece.From }, point,
        [&]
        {
          return "Vertex " + std::to_string(piece.From) +
            " is on the border of the mesh and not on that of the domain.";
        });
    }
    previous = piece.From;
  }
}

} // namespace pemesh
