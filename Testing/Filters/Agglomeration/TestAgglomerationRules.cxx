// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AgglomerationRules.h"

#include "Agglomeration.h"
#include "AgglomerationChecks.h"
#include "AgglomerationState.h"
#include "ElementGeometry.h"
#include "MetricRegistry.h"
#include "PartMerger.h"
#include "SampleMeshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

namespace pemesh
{

namespace
{

using ::testing::HasSubstr;

/** How many old elements each new one is made of. */
std::vector<int> CountMembers(const AgglomerationResult& result)
{
  std::vector<int> members(static_cast<std::size_t>(result.Mesh.NumberOfElements()), 0);
  for (const int group : result.Group)
  {
    ++members[static_cast<std::size_t>(group)];
  }
  return members;
}

class EveryRule : public testing::TestWithParam<int>
{
protected:
  const AgglomerationRule& GetRule() const
  {
    return AgglomerationRules()[static_cast<std::size_t>(GetParam())];
  }

  AgglomerationOptions MakeOptions(const SampleMesh& sample) const
  {
    AgglomerationOptions options(this->GetRule());
    options.Placed = sample.Placed;
    options.Metric =
      this->GetRule().Metric == RuleMetric::WorstFirst ? FindMetric("AreaPerimeterRatio") : nullptr;
    options.Parameters.Set("max-diameter", sample.Placed.empty() ? 3.5 : 0.0);
    return options;
  }
};

TEST_P(EveryRule, KeepsTheInvariants)
{
  for (const SampleMesh& sample : SampleMeshes())
  {
    for (const double percentage : { 0.0, 50.0, 3.0 })
    {
      AgglomerationOptions options = this->MakeOptions(sample);
      options.TargetPercentage = percentage;
      EXPECT_EQ(WhyNotAnAgglomeration(sample.Mesh, Agglomerate(sample.Mesh, options)), "")
        << sample.Name << ", " << percentage;
    }
  }
}

TEST_P(EveryRule, GivesTheSameBitsAgain)
{
  const SampleMesh sample = MeshOfRandomLayout(5);
  const AgglomerationOptions options = this->MakeOptions(sample);
  const AgglomerationResult first = Agglomerate(sample.Mesh, options);
  const AgglomerationResult second = Agglomerate(sample.Mesh, options);
  EXPECT_EQ(first.Group, second.Group);
  EXPECT_EQ(first.Mesh.Vertices, second.Mesh.Vertices);
  EXPECT_EQ(first.Mesh.Points, second.Mesh.Points);
}

TEST_P(EveryRule, NeverMergesPlacedPolygonsUnlessTold)
{
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
  {
    const SampleMesh sample = MeshOfRandomLayout(seed);
    const int elements = sample.Mesh.NumberOfElements();
    for (const int target : { 1, 10, elements / 3 })
    {
      AgglomerationOptions options = this->MakeOptions(sample);
      options.TargetElements = target;
      const AgglomerationResult result = Agglomerate(sample.Mesh, options);
      const std::vector<int> members = CountMembers(result);
      for (int element = 0; element < elements; ++element)
      {
        if (sample.Placed[static_cast<std::size_t>(element)])
        {
          EXPECT_EQ(
            members.at(static_cast<std::size_t>(result.Group[static_cast<std::size_t>(element)])),
            1)
            << seed << ", " << target;
        }
      }
    }
  }
}

TEST_P(EveryRule, AgglomeratesAgglomerates)
{
  SampleMesh sample{ "", TriangleGrid(16, 16, 4), {} };
  for (int round = 0; round < 3; ++round)
  {
    AgglomerationOptions options = this->MakeOptions(sample);
    options.TargetPercentage = 40.0;
    const AgglomerationResult result = Agglomerate(sample.Mesh, options);
    ASSERT_EQ(WhyNotAnAgglomeration(sample.Mesh, result), "");
    sample.Mesh = result.Mesh;
  }
  EXPECT_EQ(ExactArea(sample.Mesh), "256");
}

TEST_P(EveryRule, StopsWhenTold)
{
  const SampleMesh sample{ "", TriangleGrid(60, 60, 1), {} };
  int calls = 0;
  const AgglomerationResult result = Agglomerate(sample.Mesh, this->MakeOptions(sample),
    [&calls](double fraction)
    {
      EXPECT_GE(fraction, 0.0);
      EXPECT_LE(fraction, 1.0);
      return ++calls < 2;
    });
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(result.Status, AgglomerationStatus::Stopped);
}

INSTANTIATE_TEST_SUITE_P(AgglomerationRules, EveryRule,
  testing::Range(0, static_cast<int>(AgglomerationRules().size())),
  [](const auto& test)
  { return std::string(AgglomerationRules()[static_cast<std::size_t>(test.param)].Name); });

TEST(AgglomerationRules, RandomReachesTheTarget)
{
  const PolygonMesh mesh = TriangleGrid(20, 20, 1);
  AgglomerationOptions options(*FindAgglomerationRule("random"));
  std::set<std::vector<int>> results;
  for (const int target : { 800, 799, 400, 80, 7, 1 })
  {
    for (const double seed : { 1.0, 2.0 })
    {
      ASSERT_EQ(options.Parameters.Set("seed", seed), "");
      options.TargetElements = target;
      const AgglomerationResult result = Agglomerate(mesh, options);
      ASSERT_EQ(WhyNotAnAgglomeration(mesh, result), "");
      EXPECT_EQ(result.Mesh.NumberOfElements(), target);
      results.insert(result.Group);
    }
  }
  EXPECT_EQ(results.size(), 10U); // 800 and 1 leave no choice
}

/** Every rule with a target, on meshes where nothing stands in its way. */
TEST(AgglomerationRules, MeetTheTargetExactly)
{
  for (const PolygonMesh& mesh : { TriangleGrid(20, 20, 3), BrickWall(16, 24, 4) })
  {
    for (const char* name : { "random", "quality", "metis", "regular" })
    {
      for (const int target : { 300, 100, 37, 2 })
      {
        AgglomerationOptions options(*FindAgglomerationRule(name));
        options.TargetElements = target;
        const AgglomerationResult result = Agglomerate(mesh, options);
        ASSERT_EQ(WhyNotAnAgglomeration(mesh, result), "");
        EXPECT_EQ(result.Mesh.NumberOfElements(), target) << name;
      }
    }
  }
}

TEST(AgglomerationRules, APercentageIsOfTheInput)
{
  AgglomerationOptions options(*FindAgglomerationRule("metis"));
  EXPECT_EQ(Agglomerate(TriangleGrid(10, 10, 1), options).Mesh.NumberOfElements(), 40);
  options.TargetPercentage = 7.5;
  EXPECT_EQ(Agglomerate(TriangleGrid(10, 10, 1), options).Mesh.NumberOfElements(), 15);
}

TEST(AgglomerationRules, RegularBlocksHoldAboutAsManyElements)
{
  const PolygonMesh mesh = TriangleGrid(32, 32, 5);
  AgglomerationOptions options(*FindAgglomerationRule("regular"));
  options.Parameters.Set("elements-per-block", 16.0);
  const AgglomerationResult result = Agglomerate(mesh, options);
  const std::vector<int> members = CountMembers(result);
  EXPECT_EQ(members.size(), 128U);
  EXPECT_LE(*std::max_element(members.begin(), members.end()), 32);
  EXPECT_GE(std::count(members.begin(), members.end(), 16), 64);
}

TEST(AgglomerationRules, MetisPartsAreEven)
{
  const PolygonMesh mesh = TriangleGrid(64, 64, 5);
  AgglomerationOptions options(*FindAgglomerationRule("metis"));
  options.TargetElements = 819;
  const std::vector<int> members = CountMembers(Agglomerate(mesh, options));
  EXPECT_LE(*std::max_element(members.begin(), members.end()), 20);
  const auto even = std::count_if(
    members.begin(), members.end(), [](int count) { return count >= 8 && count <= 12; });
  EXPECT_GT(even, 700);
}

/** Columns ten times as wide on the right: by area, few of those make up many of the others. */
TEST(AgglomerationRules, MetisWeighsByAMetric)
{
  PolygonMesh mesh = TriangleGrid(24, 24, 5);
  for (Point2& point : mesh.Points)
  {
    point.x = point.x <= 12.0 ? point.x : 12.0 + 10.0 * (point.x - 12.0);
  }
  AgglomerationOptions options(*FindAgglomerationRule("metis"));
  options.TargetElements = 55;
  options.Metric = FindMetric("Area");
  const AgglomerationResult result = Agglomerate(mesh, options);
  ASSERT_EQ(WhyNotAnAgglomeration(mesh, result), "");
  int left = 0;
  for (int element = 0; element < result.Mesh.NumberOfElements(); ++element)
  {
    left += result.Mesh.Points[result.Mesh.Element(element)[0]].x < 11.0 ? 1 : 0;
  }
  EXPECT_LE(left, 9); // a part in eleven of the area, or 5 of 55 elements; 27 by number
  EXPECT_GE(left, 2);
}

/** One needle among squares: it goes first, and into the neighbour along its long side. */
TEST(AgglomerationRules, QualityMergesTheWorstFirst)
{
  PolygonMesh mesh;
  mesh.Points = { { 0, 0 }, { 1, 0 }, { 1.01, 0 }, { 2.01, 0 }, { 0, 1 }, { 1, 1 }, { 1.01, 1 },
    { 2.01, 1 }, { 0, 2 }, { 1, 2 }, { 1.01, 2 }, { 2.01, 2 } };
  mesh.AddElement(std::vector<int>{ 0, 1, 5, 4 });
  mesh.AddElement(std::vector<int>{ 1, 2, 6, 5 }); // the needle
  mesh.AddElement(std::vector<int>{ 2, 3, 7, 6 });
  mesh.AddElement(std::vector<int>{ 4, 5, 6, 10, 9, 8 });
  mesh.AddElement(std::vector<int>{ 6, 7, 11, 10 });
  AgglomerationOptions options(*FindAgglomerationRule("quality"));
  for (const char* metric : { "AreaPerimeterRatio", "ShapeRegularity", "EdgeRatio" })
  {
    options.Metric = FindMetric(metric);
    ASSERT_TRUE(options.Metric);
    options.TargetElements = 4;
    const AgglomerationResult result = Agglomerate(mesh, options);
    ASSERT_EQ(WhyNotAnAgglomeration(mesh, result), "");
    EXPECT_NE(result.Group[1] == result.Group[0], result.Group[1] == result.Group[2]) << metric;
    EXPECT_EQ(result.Mesh.NumberOfElements(), 4);
  }
}

/** Where the target ends a round, near ties do not count: exactly the worst is merged. */
TEST(AgglomerationRules, QualityMergesExactlyTheWorst)
{
  for (const std::uint64_t seed : { 1, 2, 3 })
  {
    const PolygonMesh mesh = TriangleGrid(20, 20, seed);
    AgglomerationOptions options(*FindAgglomerationRule("quality"));
    options.Metric = FindMetric("AreaPerimeterRatio");
    options.TargetElements = mesh.NumberOfElements() - 1;
    const AgglomerationResult result = Agglomerate(mesh, options);
    int worst = -1;
    double least = 2.0;
    ElementGeometry geometry;
    std::vector<Point2> vertices;
    for (int element = 0; element < mesh.NumberOfElements(); ++element)
    {
      mesh.GetVertices(element, vertices);
      ASSERT_TRUE(geometry.SetVertices(vertices));
      const double value = options.Metric->Function(geometry);
      worst = value < least ? element : worst;
      least = std::min(value, least);
    }
    const std::vector<int> members = CountMembers(result);
    EXPECT_EQ(
      members.at(static_cast<std::size_t>(result.Group.at(static_cast<std::size_t>(worst)))), 2);
  }
}

/** What merging is for: the worst of the mesh is better than before. */
TEST(AgglomerationRules, QualityRemovesTheWorst)
{
  PolygonMesh mesh = TriangleGrid(20, 20, 6);
  for (Point2& point : mesh.Points)
  {
    point.y *= 0.2; // flat triangles
  }
  const Metric* metric = FindMetric("AreaPerimeterRatio");
  AgglomerationOptions options(*FindAgglomerationRule("quality"));
  options.Metric = metric;
  const auto worst = [metric](const PolygonMesh& measured)
  {
    ElementGeometry geometry;
    std::vector<Point2> vertices;
    double least = 1.0;
    for (int element = 0; element < measured.NumberOfElements(); ++element)
    {
      measured.GetVertices(element, vertices);
      geometry.SetVertices(vertices);
      least = std::min(least, metric->Function(geometry));
    }
    return least;
  };
  EXPECT_GT(worst(Agglomerate(mesh, options).Mesh), 1.2 * worst(mesh));
}

/** Partitions worse than any partitioner makes them. */
TEST(AgglomerationRules, RepairsAnyPartition)
{
  const PolygonMesh mesh = TriangleGrid(12, 12, 7);
  const int elements = mesh.NumberOfElements();
  const ParameterValues none;
  const std::function<bool(double)> progress;
  const std::vector<bool> placed(static_cast<std::size_t>(elements), false);
  for (const int stride : { 1, 2, 5, 7, 40 })
  {
    ElementMerger merger(mesh, FindAdjacency(mesh));
    AgglomerationState state{ merger, placed, true, 40, true, nullptr, none, progress, {} };
    std::vector<int> part;
    for (int element = 0; element < elements; ++element)
    {
      part.push_back(element / stride % 20); // in many pieces; parts 20 to 39 are empty
    }
    ASSERT_TRUE(MergeParts(state, part, 40, std::vector<int>(part.size(), 1)));
    EXPECT_EQ(merger.GetNumberOfGroups(), 40);
    std::vector<Point2> vertices;
    for (int group = 0; group < elements; ++group)
    {
      if (merger.IsGroup(group))
      {
        merger.GetVertices(group, vertices);
        EXPECT_TRUE(IsSimpleAndCounterClockwise(vertices));
      }
    }
  }
}

/** A part that is a disc stays whole, however its elements are numbered. */
TEST(AgglomerationRules, KeepsPartsThatAreDiscs)
{
  const PolygonMesh mesh = TriangleGrid(24, 24, 8);
  const ParameterValues none;
  const std::function<bool(double)> progress;
  const std::vector<bool> placed(static_cast<std::size_t>(mesh.NumberOfElements()), false);
  ElementMerger merger(mesh, FindAdjacency(mesh));
  AgglomerationState state{ merger, placed, true, 1, true, nullptr, none, progress, {} };
  std::vector<int> part;
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    const int column = element / 2 % 24;
    const int row = element / 2 / 24;
    part.push_back(column / 6 + 4 * (row / 6));
  }
  state.Target = 16;
  ASSERT_TRUE(MergeParts(state, part, 16, std::vector<int>(part.size(), 1)));
  EXPECT_EQ(merger.GetNumberOfGroups(), 16);
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    for (int other = 0; other < element; other += 17)
    {
      EXPECT_EQ(merger.Find(element) == merger.Find(other), part[element] == part[other]);
    }
  }
}

TEST(AgglomerationRules, UnknownNamesAreToldTheNearest)
{
  EXPECT_EQ(FindAgglomerationRule("randon"), nullptr);
  EXPECT_THAT(DescribeUnknownAgglomerationRule("randon"), HasSubstr("did you mean \"random\""));
}

} // namespace

} // namespace pemesh
