// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExactJudge.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <map>

namespace
{

using Rational = CGAL::Exact_rational;
using Kernel = CGAL::Simple_cartesian<Rational>;
using ExactPoint = Kernel::Point_2;
using ExactPolygon = std::vector<ExactPoint>;
using Cycle = std::vector<int>;

class Judge
{
public:
  explicit Judge(const pemesh::PolygonMesh& mesh)
  {
    for (const pemesh::Point2& point : mesh.Points)
    {
      this->Points.emplace_back(Rational(point.x), Rational(point.y));
    }
    for (int i = 0; i < static_cast<int>(this->Points.size()); ++i)
    {
      this->Smallest.push_back(
        static_cast<int>(std::find(this->Points.begin(), this->Points.end(), this->Points[i]) -
          this->Points.begin()));
    }
    this->UseOnlyUsedPoints(mesh);
    for (int element = 0; element < mesh.NumberOfElements(); ++element)
    {
      this->Cycles.push_back(this->ToCycle(mesh.Element(element)));
      this->JudgeElement(element);
    }
  }

  ExactVerdict Decide()
  {
    this->FindOverlaps();
    this->FindConflicts();
    this->FindJunctions();
    this->FindFans();
    this->CountPieces();
    return this->Verdict;
  }

private:
  /** Points outside all elements are equal to none. */
  void UseOnlyUsedPoints(const pemesh::PolygonMesh& mesh)
  {
    const std::set<int> used(mesh.Vertices.begin(), mesh.Vertices.end());
    for (const int vertex : used)
    {
      const int first = *std::find_if(used.begin(), used.end(),
        [&](int other) { return this->Points[other] == this->Points[vertex]; });
      this->Smallest[vertex] = first;
      if (first != vertex)
      {
        this->Verdict.Duplicates.insert({ first, vertex });
      }
    }
  }

  Cycle ToCycle(std::span<const int> vertices) const
  {
    Cycle cycle;
    for (const int vertex : vertices)
    {
      if (cycle.empty() || cycle.back() != this->Smallest[vertex])
      {
        cycle.push_back(this->Smallest[vertex]);
      }
    }
    while (cycle.size() > 1 && cycle.back() == cycle.front())
    {
      cycle.pop_back();
    }
    return cycle;
  }

  ExactPolygon PolygonOf(const Cycle& cycle) const
  {
    ExactPolygon polygon;
    for (const int vertex : cycle)
    {
      polygon.push_back(this->Points[vertex]);
    }
    return polygon;
  }

  void JudgeElement(int element)
  {
    Cycle& cycle = this->Cycles[element];
    const ExactPolygon polygon = this->PolygonOf(cycle);
    bool isFlat = true;
    for (const ExactPoint& a : polygon)
    {
      for (const ExactPoint& b : polygon)
      {
        isFlat = isFlat && CGAL::collinear(polygon[0], a, b);
      }
    }
    if (polygon.size() < 3 || isFlat)
    {
      this->Verdict.Flat.insert(element);
      return;
    }
    const CGAL::Polygon_2<Kernel> exact(polygon.begin(), polygon.end());
    if (!exact.is_simple())
    {
      this->Verdict.Crossing.insert(element);
    }
    else if (exact.area() < 0)
    {
      this->Verdict.Clockwise.insert(element);
      std::reverse(cycle.begin(), cycle.end());
    }
  }

  bool IsSimple(int element) const
  {
    return !this->Verdict.Flat.count(element) && !this->Verdict.Crossing.count(element);
  }

  // --- Overlaps: the area of the intersection, by fans of signed triangles -----------------

  static Rational Turn(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c)
  {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  }

  static Rational DoubleArea(const ExactPolygon& polygon)
  {
    Rational sum = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    {
      sum += Turn(polygon[0], polygon[i], polygon[i + 1]);
    }
    return sum;
  }

  /** The part of a convex polygon on the left of a line (Sutherland and Hodgman). */
  static ExactPolygon Clip(const ExactPolygon& polygon, const ExactPoint& a, const ExactPoint& b)
  {
    ExactPolygon clipped;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const ExactPoint& p = polygon[i];
      const ExactPoint& q = polygon[(i + 1) % polygon.size()];
      const Rational atP = Turn(a, b, p);
      const Rational atQ = Turn(a, b, q);
      if (atP >= 0)
      {
        clipped.push_back(p);
      }
      if ((atP > 0 && atQ < 0) || (atP < 0 && atQ > 0))
      {
        const Rational part = atP / (atP - atQ);
        clipped.emplace_back(p.x() + part * (q.x() - p.x()), p.y() + part * (q.y() - p.y()));
      }
    }
    return clipped;
  }

  static Rational CommonDoubleArea(ExactPolygon first, const ExactPolygon& second)
  {
    for (std::size_t i = 0; i < 3 && !first.empty(); ++i)
    {
      first = Clip(first, second[i], second[(i + 1) % 3]);
    }
    return first.size() < 3 ? Rational(0) : DoubleArea(first);
  }

  /** Counter-clockwise triangles, each with a sign, that add up to the polygon. */
  static std::vector<std::pair<int, ExactPolygon>> FanOf(const ExactPolygon& polygon)
  {
    std::vector<std::pair<int, ExactPolygon>> fan;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    {
      const Rational turn = Turn(polygon[0], polygon[i], polygon[i + 1]);
      if (turn > 0)
      {
        fan.push_back({ 1, { polygon[0], polygon[i], polygon[i + 1] } });
      }
      else if (turn < 0)
      {
        fan.push_back({ -1, { polygon[0], polygon[i + 1], polygon[i] } });
      }
    }
    return fan;
  }

  void FindOverlaps()
  {
    const int elements = static_cast<int>(this->Cycles.size());
    for (int i = 0; i < elements; ++i)
    {
      for (int j = i + 1; j < elements && this->IsSimple(i); ++j)
      {
        Rational common = 0;
        if (this->IsSimple(j))
        {
          for (const auto& [sign, triangle] : FanOf(this->PolygonOf(this->Cycles[i])))
          {
            for (const auto& [otherSign, other] : FanOf(this->PolygonOf(this->Cycles[j])))
            {
              common += sign * otherSign * CommonDoubleArea(triangle, other);
            }
          }
        }
        if (common > 0)
        {
          this->Verdict.Overlaps.insert({ i, j });
        }
      }
    }
  }

  // --- Sides ----------------------------------------------------------------------------------

  template <typename Use>
  void ForEachSide(const Use& use) const
  {
    for (int element = 0; element < static_cast<int>(this->Cycles.size()); ++element)
    {
      const Cycle& cycle = this->Cycles[element];
      for (std::size_t i = 0; i < cycle.size() && cycle.size() > 1; ++i)
      {
        use(element, cycle[i], cycle[(i + 1) % cycle.size()]);
      }
    }
  }

  int CountSides(int from, int to, bool simpleOnly) const
  {
    int count = 0;
    this->ForEachSide([&](int element, int a, int b)
      { count += a == from && b == to && (!simpleOnly || this->IsSimple(element)); });
    return count;
  }

  void FindConflicts()
  {
    this->ForEachSide(
      [&](int, int from, int to)
      {
        if (this->CountSides(from, to, true) > 1)
        {
          this->Verdict.ConflictingSides.insert(std::minmax(from, to));
        }
      });
  }

  void FindJunctions()
  {
    std::set<int> border;
    this->ForEachSide(
      [&](int, int from, int to)
      {
        if (this->CountSides(to, from, false) == 0)
        {
          border.insert({ from, to });
        }
      });
    this->ForEachSide(
      [&](int element, int from, int to)
      {
        for (const int vertex : border)
        {
          if (this->CountSides(to, from, false) == 0 &&
            CGAL::are_strictly_ordered_along_line(
              this->Points[from], this->Points[vertex], this->Points[to]))
          {
            this->Verdict.Junctions.insert({ element, vertex });
          }
        }
      });
  }

  bool HaveCommonSide(int first, int second, int vertex) const
  {
    bool found = false;
    this->ForEachSide(
      [&](int element, int from, int to)
      {
        found = found ||
          (element == first && (vertex < 0 || from == vertex || to == vertex) &&
            this->IsSideOf(second, to, from));
      });
    return found;
  }

  bool IsSideOf(int element, int from, int to) const
  {
    const Cycle& cycle = this->Cycles[element];
    for (std::size_t i = 0; i < cycle.size(); ++i)
    {
      if (cycle[i] == from && cycle[(i + 1) % cycle.size()] == to)
      {
        return true;
      }
    }
    return false;
  }

  /** How many groups the elements fall into when those with a common side are joined. */
  int CountGroups(std::vector<int> elements, int vertex) const
  {
    int groups = 0;
    while (!elements.empty())
    {
      ++groups;
      std::vector<int> group = { elements.back() };
      elements.pop_back();
      for (std::size_t i = 0; i < group.size(); ++i)
      {
        const auto joined = std::partition(elements.begin(), elements.end(),
          [&](int other) { return !this->HaveCommonSide(group[i], other, vertex); });
        group.insert(group.end(), joined, elements.end());
        elements.erase(joined, elements.end());
      }
    }
    return groups;
  }

  void FindFans()
  {
    std::map<int, std::vector<int>> around;
    for (int element = 0; element < static_cast<int>(this->Cycles.size()); ++element)
    {
      for (const int vertex : this->Cycles[element])
      {
        around[vertex].push_back(element);
      }
    }
    for (const auto& [vertex, elements] : around)
    {
      if (this->CountGroups(elements, vertex) > 1)
      {
        this->Verdict.Pinched.insert(vertex);
      }
    }
  }

  void CountPieces()
  {
    std::vector<int> elements;
    std::set<int> vertices;
    std::set<std::pair<int, int>> sides;
    for (int element = 0; element < static_cast<int>(this->Cycles.size()); ++element)
    {
      if (this->Cycles[element].size() > 1)
      {
        elements.push_back(element);
      }
    }
    this->ForEachSide(
      [&](int, int from, int to)
      {
        vertices.insert(from);
        sides.insert(std::minmax(from, to));
      });
    const int characteristic = static_cast<int>(vertices.size()) - static_cast<int>(sides.size()) +
      static_cast<int>(elements.size());
    this->Verdict.Components = this->CountGroups(elements, -1);
    this->Verdict.Holes = this->Verdict.Components - characteristic;
  }

  std::vector<ExactPoint> Points;
  std::vector<int> Smallest;
  std::vector<Cycle> Cycles;
  ExactVerdict Verdict;
};

} // namespace

ExactVerdict JudgeExactly(const pemesh::PolygonMesh& mesh)
{
  return Judge(mesh).Decide();
}
