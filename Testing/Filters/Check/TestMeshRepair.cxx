// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshRepair.h"

#include "BrokenMeshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace pemesh
{

namespace
{

using testing::ElementsAre;

/** 2 x 2 squares with everything that can be mended, and nothing else. */
RawMesh MakeMendable()
{
  std::vector<Point2> points = GridPoints(2);
  Elements squares = GridSquares(2);
  std::reverse(squares[0].begin() + 1, squares[0].end()); // clockwise
  points.push_back({ 7, 7 });                             // unused: 9
  points.push_back({ 1, 1 });                             // a copy of 4: 10
  squares[3][0] = 10;
  squares[2].push_back(squares[2][3]); // repeated
  squares[1].push_back(1);             // repeated around the end
  return MakeRawMesh(points, squares);
}

TEST(MeshRepair, MendsAllThatIsSafe)
{
  const RawMesh raw = MakeMendable();
  EXPECT_EQ(FiredChecks(raw),
    (Fired{ { "orientation", 1 }, { "degenerate", 2 }, { "duplicate-vertices", 1 },
      { "unused-points", 1 } }));
  const MeshRepair repair = RepairMesh(raw.Mesh, {});
  EXPECT_EQ(repair.Mesh.Points, GridPoints(2));
  EXPECT_EQ(ElementsOf(repair.Mesh), GridSquares(2));
  EXPECT_THAT(repair.Points, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8));
  EXPECT_EQ(FiredChecks(RawMesh{ repair.Mesh, {} }), Fired());
  std::vector<std::string> sentences;
  for (const MeshFinding& finding : repair.Repairs)
  {
    sentences.push_back(finding.Message);
  }
  EXPECT_THAT(sentences,
    ElementsAre("Element 1 had repeated vertices, which are dropped.",
      "Element 2 had repeated vertices, which are dropped.",
      "Element 0 was clockwise and is turned round.",
      "Vertex 10 is merged into vertex 4, which is at the same place.",
      "Point 9 was in no element and is removed."));
}

TEST(MeshRepair, DoesOnlyWhatIsChosen)
{
  const RawMesh raw = MakeMendable();
  for (const char* chosen : { "orientation", "degenerate", "duplicate-vertices", "unused-points" })
  {
    CheckOptions options;
    options.Checks = { chosen };
    const MeshRepair repair = RepairMesh(raw.Mesh, options);
    Fired left = FiredChecks(raw);
    left.erase(chosen);
    EXPECT_EQ(FiredChecks(RawMesh{ repair.Mesh, {} }), left) << chosen;
  }
}

TEST(MeshRepair, LeavesWhatIsNotSafe)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Elements broken = { { 0, 1, 99 }, { 0, 1, 4 }, { 0, 0, 1 }, { 0, 1 }, { 0, 2, 1, 3 } };
  const RawMesh raw = MakeRawMesh({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { nan, 0 } }, broken);
  const MeshRepair repair = RepairMesh(raw.Mesh, {});
  EXPECT_EQ(ElementsOf(repair.Mesh), broken);
  EXPECT_THAT(repair.Counts, testing::Each(0));
  EXPECT_THAT(repair.Repairs, testing::IsEmpty());
}

TEST(MeshRepair, NumbersOutOfRangeStaySoWhenPointsGo)
{
  const RawMesh raw =
    MakeRawMesh({ { 9, 9 }, { 0, 0 }, { 1, 0 }, { 0, 1 } }, { { 1, 2, 3 }, { 1, 2, 4 } });
  const MeshRepair repair = RepairMesh(raw.Mesh, {});
  EXPECT_EQ(ElementsOf(repair.Mesh), (Elements{ { 0, 1, 2 }, { 0, 1, 4 } }));
  EXPECT_THAT(repair.Points, ElementsAre(1, 2, 3));
  EXPECT_EQ(FiredChecks(RawMesh{ repair.Mesh, {} }), (Fired{ { "vertex-numbers", 1 } }));
}

} // namespace

} // namespace pemesh
