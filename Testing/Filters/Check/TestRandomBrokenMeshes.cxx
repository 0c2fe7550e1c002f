// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Small meshes broken at random, judged by brute force in rational arithmetic; and what must not
 * change when a mesh is turned, moved, scaled or renumbered.
 */
#include "BrokenMeshes.h"
#include "ExactJudge.h"
#include "MeshChecks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <set>

namespace pemesh
{

namespace
{

/** A grid of squares and triangles on even coordinates, with some changes of any kind. */
class BrokenMesh
{
public:
  explicit BrokenMesh(std::uint64_t seed)
    : Bits(seed)
  {
    const int n = 2 + this->Draw(2);
    this->Points = GridPoints(n, 2.0);
    for (const auto& square : GridSquares(n))
    {
      if (this->Draw(2) == 0)
      {
        this->List.push_back(square);
      }
      else
      {
        this->List.push_back({ square[0], square[1], square[2] });
        this->List.push_back({ square[0], square[2], square[3] });
      }
    }
    const int changes = this->Draw(4);
    for (int i = 0; i < changes; ++i)
    {
      this->Change();
    }
  }

  RawMesh Get() const { return MakeRawMesh(this->Points, this->List); }

private:
  int Draw(int count) { return static_cast<int>(this->Bits() % static_cast<unsigned>(count)); }
  std::vector<int>& AnyElement()
  {
    return this->List[static_cast<std::size_t>(this->Draw(static_cast<int>(this->List.size())))];
  }
  int AnyPoint() { return this->Draw(static_cast<int>(this->Points.size())); }
  int AddPoint(const Point2& point)
  {
    this->Points.push_back(point);
    return static_cast<int>(this->Points.size()) - 1;
  }
  Point2 AnyPlace()
  {
    return { static_cast<double>(this->Draw(7)), static_cast<double>(this->Draw(7)) };
  }

  void Change()
  {
    std::vector<int>& element = this->AnyElement();
    const std::size_t corner =
      element.empty() ? 0 : static_cast<std::size_t>(this->Draw(static_cast<int>(element.size())));
    switch (this->Draw(10))
    {
      case 0:
        std::reverse(element.begin(), element.end());
        break;
      case 1:
        this->Points[this->AnyPoint()] = this->AnyPlace();
        break;
      case 2:
        element = this->List.back();
        this->List.pop_back();
        break;
      case 3:
        this->List.push_back({ this->AnyPoint(), this->AnyPoint(), this->AnyPoint() });
        break;
      case 4:
        this->List.push_back({ this->AddPoint(this->AnyPlace()), this->AddPoint(this->AnyPlace()),
          this->AddPoint(this->AnyPlace()) });
        break;
      case 5:
        if (!element.empty())
        {
          element[corner] = this->AddPoint(this->Points[element[corner]]);
        }
        break;
      case 6:
        element.insert(element.begin() + static_cast<std::ptrdiff_t>(corner), this->AnyPoint());
        break;
      case 7:
        if (!element.empty())
        {
          const Point2& a = this->Points[element[corner]];
          const Point2& b = this->Points[element[(corner + 1) % element.size()]];
          const Point2 middle = { 0.5 * (a.x + b.x), 0.5 * (a.y + b.y) };
          element.insert(
            element.begin() + static_cast<std::ptrdiff_t>(corner) + 1, this->AddPoint(middle));
        }
        break;
      case 8:
        if (!element.empty())
        {
          element.erase(element.begin() + static_cast<std::ptrdiff_t>(corner));
        }
        break;
      default:
        this->List.push_back(element);
        break;
    }
  }

  std::mt19937_64 Bits;
  std::vector<Point2> Points;
  Elements List;
};

CheckOptions AllExamples()
{
  CheckOptions options;
  options.MostExamples = 1000000;
  return options;
}

std::set<int> ElementsOfCheck(const MeshReport& report, const char* check)
{
  std::set<int> elements;
  for (const MeshFinding& finding : report.Findings)
  {
    if (finding.Check == FindMeshCheck(check))
    {
      elements.insert(finding.Elements.begin(), finding.Elements.end());
    }
  }
  return elements;
}

std::set<std::pair<int, int>> PairsOfCheck(
  const MeshReport& report, const char* check, std::vector<int> MeshFinding::*numbers)
{
  std::set<std::pair<int, int>> pairs;
  for (const MeshFinding& finding : report.Findings)
  {
    if (finding.Check == FindMeshCheck(check))
    {
      pairs.insert({ (finding.*numbers)[0], (finding.*numbers)[1] });
    }
  }
  return pairs;
}

/** An element and the vertex on its side. */
std::set<std::pair<int, int>> JunctionsOf(const MeshReport& report)
{
  std::set<std::pair<int, int>> junctions;
  for (const MeshFinding& finding : report.Findings)
  {
    if (finding.Check == FindMeshCheck("t-junctions"))
    {
      junctions.insert({ finding.Elements[0], finding.Vertices[0] });
    }
  }
  return junctions;
}

class RandomBrokenMeshes : public testing::TestWithParam<int>
{
};

TEST_P(RandomBrokenMeshes, AreJudgedAsByBruteForce)
{
  int connected = 0;
  for (int i = 0; i < 250; ++i)
  {
    const auto seed = static_cast<std::uint64_t>(1000 * GetParam() + i);
    SCOPED_TRACE(seed);
    const RawMesh raw = BrokenMesh(seed).Get();
    const MeshReport report = CheckMesh(raw, AllExamples());
    const ExactVerdict verdict = JudgeExactly(raw.Mesh);
    ASSERT_EQ(ElementsOfCheck(report, "simple"), verdict.Crossing);
    ASSERT_EQ(ElementsOfCheck(report, "orientation"), verdict.Clockwise);
    ASSERT_EQ(
      PairsOfCheck(report, "duplicate-vertices", &MeshFinding::Vertices), verdict.Duplicates);
    ASSERT_EQ(PairsOfCheck(report, "overlaps", &MeshFinding::Elements), verdict.Overlaps);
    ASSERT_EQ(PairsOfCheck(report, "sides", &MeshFinding::Vertices), verdict.ConflictingSides);
    const std::set<int> degenerate = ElementsOfCheck(report, "degenerate");
    ASSERT_TRUE(std::includes(
      degenerate.begin(), degenerate.end(), verdict.Flat.begin(), verdict.Flat.end()));
    // Below, other faults could be the cause, and then the rest is not reported again.
    if (!verdict.Flat.empty() || !verdict.Crossing.empty() || !verdict.ConflictingSides.empty())
    {
      continue;
    }
    ASSERT_EQ(JunctionsOf(report), verdict.Junctions);
    if (!verdict.Junctions.empty() || !verdict.Overlaps.empty())
    {
      continue;
    }
    ++connected;
    ASSERT_EQ(report.GetCount("pinched-vertices"), verdict.Pinched.size());
    ASSERT_EQ(report.NumberOfComponents, verdict.Components);
    if (verdict.Pinched.empty())
    {
      ASSERT_EQ(report.NumberOfHoles, verdict.Holes);
      ASSERT_EQ(report.GetCount("holes"), verdict.Holes);
    }
  }
  EXPECT_GT(connected, 25) << "enough meshes get to the last judgement";
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomBrokenMeshes, testing::Range(0, 12));

class UnchangedFindings : public testing::TestWithParam<int>
{
protected:
  static std::string TextOf(const MeshReport& report, bool withMessages)
  {
    std::string text;
    for (const MeshFinding& finding : report.Findings)
    {
      text += finding.Check->Name;
      for (const int element : finding.Elements)
      {
        text += " e" + std::to_string(element);
      }
      text += withMessages ? " " + finding.Message + "\n" : "\n";
    }
    return text;
  }
};

TEST_P(UnchangedFindings, WhenTheMeshIsTurnedMovedOrScaled)
{
  for (int i = 0; i < 50; ++i)
  {
    const RawMesh raw = BrokenMesh(static_cast<std::uint64_t>(70000 + 100 * GetParam() + i)).Get();
    const Fired before = FiredChecks(raw, AllExamples());
    RawMesh turned = raw;
    RawMesh moved = raw;
    RawMesh scaled = raw;
    for (std::size_t point = 0; point < raw.Mesh.Points.size(); ++point)
    {
      const Point2& p = raw.Mesh.Points[point];
      turned.Mesh.Points[point] = { -p.y, p.x };
      moved.Mesh.Points[point] = { p.x + 0x1p20, p.y - 0x1p18 };
      scaled.Mesh.Points[point] = { p.x * 0x1p-300, p.y * 0x1p-300 };
    }
    EXPECT_EQ(FiredChecks(turned, AllExamples()), before);
    EXPECT_EQ(FiredChecks(scaled, AllExamples()), before);
    const MeshReport here = CheckMesh(raw, AllExamples());
    const MeshReport there = CheckMesh(moved, AllExamples());
    EXPECT_EQ(TextOf(there, true), TextOf(here, true));
  }
}

TEST_P(UnchangedFindings, WhenElementsComeInAnotherOrder)
{
  for (int i = 0; i < 50; ++i)
  {
    const RawMesh raw = BrokenMesh(static_cast<std::uint64_t>(80000 + 100 * GetParam() + i)).Get();
    Elements elements = ElementsOf(raw.Mesh);
    std::reverse(elements.begin(), elements.end());
    std::rotate(elements.begin(), elements.begin() + 2, elements.end());
    EXPECT_EQ(FiredChecks(MakeRawMesh(raw.Mesh.Points, elements), AllExamples()),
      FiredChecks(raw, AllExamples()));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, UnchangedFindings, testing::Range(0, 4));

} // namespace

} // namespace pemesh
