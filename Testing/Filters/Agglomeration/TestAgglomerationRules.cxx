// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AgglomerationRules.h"

#include "Agglomeration.h"
#include "AgglomerationChecks.h"
#include "MetricRegistry.h"
#include "SampleMeshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace pemesh
{

namespace
{

using ::testing::HasSubstr;

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
  const SampleMesh sample = MeshOfRandomLayout(2);
  AgglomerationOptions options = this->MakeOptions(sample);
  options.TargetElements = 1;
  const AgglomerationResult result = Agglomerate(sample.Mesh, options);
  ASSERT_EQ(WhyNotAnAgglomeration(sample.Mesh, result), "");
  std::vector<int> members(static_cast<std::size_t>(result.Mesh.NumberOfElements()), 0);
  for (const int group : result.Group)
  {
    ++members[static_cast<std::size_t>(group)];
  }
  int placed = 0;
  for (std::size_t element = 0; element < sample.Placed.size(); ++element)
  {
    if (sample.Placed[element])
    {
      EXPECT_EQ(members[static_cast<std::size_t>(result.Group[element])], 1);
      ++placed;
    }
  }
  EXPECT_GT(placed, 0);
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

TEST(AgglomerationRules, UnknownNamesAreToldTheNearest)
{
  EXPECT_EQ(FindAgglomerationRule("randon"), nullptr);
  EXPECT_THAT(DescribeUnknownAgglomerationRule("randon"), HasSubstr("did you mean \"random\""));
}

} // namespace

} // namespace pemesh
