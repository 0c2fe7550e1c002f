// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CountSearch.h"

#include "CaseStatus.h"
#include "GenerationSupport.h"
#include "MeshInvariants.h"
#include "vtkPEMDomainMesher.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{

using testing::HasSubstr;

struct Outcome
{
  int Trials = 0;
  double Count = 0.0;
};

Outcome RunSearch(pemesh::CountSearch& search, const std::function<double(double)>& countOf)
{
  Outcome outcome;
  while (search.IsSearching() && outcome.Trials < 1000)
  {
    outcome.Count = countOf(search.GetBound());
    search.Report(outcome.Count);
    ++outcome.Trials;
  }
  return outcome;
}

TEST(CountSearch, FindsTheBoundInFewTrials)
{
  const std::function<double(double)> laws[] = {
    [](double bound) { return std::ceil(1.7 / bound); },
    [](double bound) { return 400.0 + std::ceil(0.6 / bound); },
    [](double bound) { return std::ceil(std::pow(bound, -0.6)) + 10.0; },
    [](double bound) { return std::ceil((1.5 + 0.02 * std::sin(300.0 * bound)) / bound); },
  };
  for (std::size_t law = 0; law < std::size(laws); ++law)
  {
    for (const double target : { 500.0, 3000.0, 1e5, 1e6 })
    {
      for (const double first : { 1.0 / target, 1e-3, 1.0 })
      {
        pemesh::CountSearch search(target, 0.02, first, 1.0);
        const Outcome outcome = RunSearch(search, laws[law]);
        EXPECT_TRUE(search.IsReached()) << law << " " << target << " " << first;
        EXPECT_NEAR(outcome.Count, target, 0.02 * target);
        EXPECT_EQ(laws[law](search.GetBound()), outcome.Count);
        EXPECT_LE(outcome.Trials, 12) << law << " " << target << " " << first;
      }
    }
  }
}

TEST(CountSearch, SaysWhatIsLeastOrNearest)
{
  pemesh::CountSearch tooSmall(100.0, 0.02, 0.01, 1.0);
  const Outcome least =
    RunSearch(tooSmall, [](double bound) { return 400.0 + std::ceil(0.6 / bound); });
  EXPECT_FALSE(tooSmall.IsReached());
  EXPECT_TRUE(tooSmall.IsTargetTooSmall());
  EXPECT_EQ(tooSmall.GetNearestCount(), 401.0);
  EXPECT_LE(least.Trials, 12);

  pemesh::CountSearch jump(100.0, 0.02, 0.01, 1.0);
  const Outcome nearest =
    RunSearch(jump, [](double bound) { return bound > 0.0125 ? 70.0 : 110.0; });
  EXPECT_FALSE(jump.IsReached());
  EXPECT_FALSE(jump.IsTargetTooSmall());
  EXPECT_EQ(jump.GetNearestCount(), 110.0);
  EXPECT_LE(jump.GetBound(), 0.0125);
  EXPECT_LE(nearest.Trials, 41);
}

TEST(CountSearch, EndsOnCountsThatNeverChange)
{
  pemesh::CountSearch search(100.0, 0.02, 0.01, 1.0);
  const Outcome outcome = RunSearch(search, [](double) { return 50.0; });
  EXPECT_FALSE(search.IsReached());
  EXPECT_LE(outcome.Trials, 41);
}

class DomainMesherTargets : public testing::TestWithParam<bool>
{
};

TEST_P(DomainMesherTargets, AreMetWithinTwoPercent)
{
  Generation generation;
  generation.Layout->AddPolygon("comb", 0.3, 0.3);
  generation.Layout->AddPolygon("star", 0.7, 0.7);
  generation.Layout->SetPolygonScale(0, 0.7);
  generation.Layout->SetPolygonScale(1, 0.7);
  generation.Mesher->SetPreservePolygons(GetParam());
  for (const double t : { 0.1, 0.6 })
  {
    for (const int target : { 1000, 1777, 6000 })
    {
      generation.Mesher->SetTargetNumberOfElements(target);
      vtkPolyData* mesh = generation.MeshAt(t);
      ASSERT_EQ(pemesh::GetCaseStatusMessage(mesh), "");
      EXPECT_NEAR(static_cast<double>(mesh->GetNumberOfCells()), target, 0.02 * target);
      const double bound = pemesh::GetFieldNumber(mesh, "MaximumArea");
      const vtkIdType count = mesh->GetNumberOfCells();
      EXPECT_TRUE(GetParam() || LargestFiller(mesh) <= bound);
      generation.Mesher->SetTargetNumberOfElements(0);
      generation.Mesher->SetAreaRuleByName("constant");
      generation.Mesher->SetMaximumArea(bound);
      EXPECT_EQ(generation.MeshAt(t)->GetNumberOfCells(), count) << "the bound gives the mesh";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(SplitAndPreserved, DomainMesherTargets, testing::Bool());

TEST(DomainMesherTarget, NamesTheLeastNumberPossible)
{
  Generation generation;
  generation.Layout->AddPolygon("comb", 0.5, 0.5);
  generation.Mesher->SetAreaRuleByName("none");
  const vtkIdType least = generation.MeshAt(0.9)->GetNumberOfCells();
  generation.Mesher->SetTargetNumberOfElements(20);
  vtkPolyData* mesh = generation.MeshAt(0.9);
  EXPECT_EQ(pemesh::GetCaseStatus(mesh), "target-not-reached");
  EXPECT_EQ(mesh->GetNumberOfCells(), 0);
  EXPECT_EQ(pemesh::GetCaseStatusMessage(mesh),
    "A mesh of 20 elements is not possible: the polygons, the domain and the minimum angle force " +
      std::to_string(least) + "; set at least that, or a smaller minimum angle.");
  generation.Mesher->SetTargetNumberOfElements(least);
  EXPECT_EQ(pemesh::GetCaseStatus(generation.MeshAt(0.9)), "ok");

  generation.Mesher->SetTargetNumberOfElements(5000);
  generation.Mesher->SetMaximumNumberOfElements(4000);
  EXPECT_THAT(pemesh::GetCaseStatusMessage(generation.MeshAt(0.9)),
    HasSubstr("The target of 5000 elements is beyond the limit of 4000"));
}

} // namespace
