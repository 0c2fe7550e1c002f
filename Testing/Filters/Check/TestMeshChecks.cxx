// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Good meshes broken on purpose, one way at a time: the checks that must find it do, and no others.
 */
#include "MeshChecks.h"

#include "BrokenMeshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace pemesh
{

namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

/** 4 x 4 squares of side 1, to be changed by a test. */
class MeshChecksTest : public testing::Test
{
protected:
  static constexpr int N = 4;
  std::vector<Point2> Points = GridPoints(N);
  Elements Squares = GridSquares(N);

  static int At(int i, int j) { return GridPoint(N, i, j); }
  /** The square with its lower left corner at (i, j). */
  static int Square(int i, int j) { return j * N + i; }

  int AddPoint(double x, double y)
  {
    this->Points.push_back({ x, y });
    return static_cast<int>(this->Points.size()) - 1;
  }

  MeshReport Check(const CheckOptions& options = {}) const
  {
    return CheckMesh(MakeRawMesh(this->Points, this->Squares), options);
  }
  Fired GetFired(const CheckOptions& options = {}) const
  {
    return FiredChecks(this->Check(options));
  }
};

TEST_F(MeshChecksTest, TableIsWhole)
{
  std::set<std::string> names;
  for (const MeshCheck& check : MeshChecks())
  {
    EXPECT_TRUE(names.insert(check.Name).second) << check.Name;
    EXPECT_EQ(FindMeshCheck(check.Name), &check);
    EXPECT_GT(std::string(check.Label).size(), 3U);
    EXPECT_GT(std::string(check.Description).size(), 10U);
    EXPECT_NE(check.Function, nullptr);
  }
  EXPECT_LE(MeshChecks().size(), 32U) << "one bit each";
  EXPECT_EQ(FindMeshCheck("simpel"), nullptr);
  EXPECT_THAT(DescribeUnknownMeshCheck("simpel"), HasSubstr("\"simple\""));
}

TEST_F(MeshChecksTest, GoodMeshHasNoFindings)
{
  const MeshReport report = this->Check();
  EXPECT_EQ(FiredChecks(report), Fired());
  EXPECT_TRUE(report.Findings.empty());
  EXPECT_EQ(report.NumberOfComponents, 1);
  EXPECT_EQ(report.NumberOfHoles, 0);
}

TEST_F(MeshChecksTest, ElementTurnedRound)
{
  this->Squares[5] = { At(1, 1), At(1, 2), At(2, 2), At(2, 1) };
  const MeshReport report = this->Check();
  EXPECT_EQ(FiredChecks(report), (Fired{ { "orientation", 1 } }));
  EXPECT_THAT(report.Findings[0].Elements, ElementsAre(5));
  EXPECT_EQ(report.Findings[0].Place, (Point2{ 1.5, 1.5 }));
  EXPECT_EQ(report.Findings[0].Message, "Element 5 is clockwise.");
  EXPECT_EQ(report.Faults[5], 1);
  EXPECT_EQ(report.Faults[6], 0);
}

TEST_F(MeshChecksTest, AllElementsTurnedRound)
{
  for (auto& square : this->Squares)
  {
    std::reverse(square.begin(), square.end());
  }
  EXPECT_EQ(this->GetFired(), (Fired{ { "orientation", 16 } }));
}

TEST_F(MeshChecksTest, BowTie)
{
  std::swap(this->Squares[5][0], this->Squares[5][1]);
  const MeshReport report = this->Check();
  EXPECT_EQ(FiredChecks(report), (Fired{ { "simple", 1 } }));
  // 7 6 12 11: the sides 6-12 and 11-7 cross.
  EXPECT_EQ(report.Findings[0].Message,
    "Element 5 crosses or touches itself: its sides 6-12 and 11-7 meet.");
  EXPECT_THAT(report.Findings[0].Vertices, ElementsAre(6, 12, 11, 7));
}

TEST_F(MeshChecksTest, ElementOfTwoVertices)
{
  this->Squares.push_back({ At(0, 0), At(1, 0) });
  EXPECT_EQ(this->GetFired(), (Fired{ { "degenerate", 1 } }));
  this->Squares.back() = {};
  EXPECT_EQ(this->GetFired(), (Fired{ { "degenerate", 1 } }));
}

TEST_F(MeshChecksTest, ElementWithoutArea)
{
  // A flat triangle between two squares, one of which knows the middle of their side.
  const int middle = this->AddPoint(2.0, 1.5);
  this->Squares[Square(1, 1)] = { At(1, 1), At(2, 1), middle, At(2, 2), At(1, 2) };
  this->Squares.push_back({ At(2, 1), At(2, 2), middle });
  const MeshReport report = this->Check();
  EXPECT_EQ(FiredChecks(report), (Fired{ { "degenerate", 1 } }));
  EXPECT_EQ(report.Findings[0].Message, "Element 16 has no area: its vertices are on one line.");
}

TEST_F(MeshChecksTest, RepeatedVertex)
{
  this->Squares[5].insert(this->Squares[5].begin(), this->Squares[5].back());
  const MeshReport report = this->Check();
  EXPECT_EQ(FiredChecks(report), (Fired{ { "degenerate", 1 } }));
  EXPECT_EQ(report.Findings[0].Message, "Element 5 has vertex 11 twice in a row.");
  this->Squares[5][0] = this->AddPoint(1.0, 2.0);
  EXPECT_EQ(this->GetFired(), (Fired{ { "degenerate", 1 }, { "duplicate-vertices", 1 } }));
}

TEST_F(MeshChecksTest, ElementThatTouchesItselfAtAVertex)
{
  const int a = this->AddPoint(-1.0, -1.0);
  const int b = this->AddPoint(1.0, -1.0);
  this->Squares[0] = { At(0, 0), a, b, At(0, 0), At(1, 0), At(1, 1), At(0, 1) };
  EXPECT_EQ(this->GetFired(), (Fired{ { "simple", 1 } }));
}

TEST_F(MeshChecksTest, Sliver)
{
  const int near = this->AddPoint(2.0, -1e-7);
  this->Squares.push_back({ At(1, 0), near, At(3, 0), At(2, 0) });
  const MeshReport report = this->Check();
  EXPECT_EQ(FiredChecks(report), (Fired{ { "slivers", 1 } }));
  EXPECT_EQ(report.GetCount(CheckSeverity::Warning), 1);
  EXPECT_EQ(report.GetCount(CheckSeverity::Error), 0);
  CheckOptions options;
  options.SliverThickness = 4e-8; // twice the area is 2e-7, the squared diameter 4
  EXPECT_EQ(this->GetFired(options), Fired());
  options.SliverThickness = 6e-8;
  EXPECT_EQ(this->GetFired(options), (Fired{ { "slivers", 1 } }));
}

TEST_F(MeshChecksTest, PointOutOfThePlane)
{
  RawMesh raw = MakeRawMesh(this->Points, this->Squares);
  raw.Heights.assign(this->Points.size(), 3.0);
  EXPECT_EQ(FiredChecks(raw), Fired()) << "all at one height";
  raw.Heights[At(0, 0)] = 3.5;
  const MeshReport report = CheckMesh(raw, {});
  EXPECT_EQ(FiredChecks(report), (Fired{ { "planar", 1 } }));
  EXPECT_EQ(report.Findings[0].Message, "Element 0 has vertex 0 at height 3.5 instead of 3.");
  raw.Heights[At(1, 1)] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(FiredChecks(raw), (Fired{ { "planar", 4 } }));
}

TEST_F(MeshChecksTest, CoordinateThatIsNotFinite)
{
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() })
  {
    this->Points[At(2, 2)].y = bad;
    EXPECT_EQ(this->GetFired(), (Fired{ { "finite", 4 } }));
  }
}

TEST_F(MeshChecksTest, VertexOutOfRange)
{
  for (const int bad : { -1, 25, std::numeric_limits<int>::max(), std::numeric_limits<int>::min() })
  {
    this->Squares[5][2] = bad;
    const MeshReport report = this->Check();
    EXPECT_EQ(FiredChecks(report), (Fired{ { "vertex-numbers", 1 } })) << bad;
    EXPECT_THAT(report.Findings[0].Message, HasSubstr("25 vertices"));
  }
}

TEST_F(MeshChecksTest, DuplicateVertex)
{
  this->Squares[5][2] = this->AddPoint(2.0, 2.0);
  const MeshReport report = this->Check();
  EXPECT_EQ(FiredChecks(report), (Fired{ { "duplicate-vertices", 1 } }));
  EXPECT_THAT(report.Findings[0].Vertices, ElementsAre(12, 25));
  EXPECT_THAT(report.Findings[0].Elements, ElementsAre(5));
}

TEST_F(MeshChecksTest, SoupOfSquaresIsAMeshWithDuplicateVertices)
{
  std::vector<Point2> points;
  Elements squares;
  for (const auto& square : this->Squares)
  {
    squares.emplace_back();
    for (const int vertex : square)
    {
      squares.back().push_back(static_cast<int>(points.size()));
      points.push_back(this->Points[vertex]);
    }
  }
  const MeshReport report = CheckMesh(MakeRawMesh(points, squares), {});
  EXPECT_EQ(FiredChecks(report), (Fired{ { "duplicate-vertices", 64 - 25 } }));
  EXPECT_EQ(report.NumberOfComponents, 1);
}

TEST_F(MeshChecksTest, NearlyEqualVertexAndTheCrackBesideIt)
{
  // The copy lies inside its square, so that a crack opens and nothing overlaps.
  const double off = 1e-13;
  this->Squares[5][2] = this->AddPoint(2.0 - off, 2.0 - off);
  const MeshReport report = this->Check();
  EXPECT_EQ(FiredChecks(report), (Fired{ { "holes", 1 }, { "near-vertices", 1 } }));
  EXPECT_THAT(report.Findings[0].Message, HasSubstr("no side joins them"));
  EXPECT_EQ(report.NumberOfHoles, 1);
  CheckOptions exact;
  exact.Tolerance = 0.0;
  EXPECT_EQ(this->GetFired(exact), (Fired{ { "holes", 1 } }));
}

TEST_F(MeshChecksTest, ShortSide)
{
  const int near = this->AddPoint(1e-13, 0.0);
  this->Squares[0] = { At(0, 0), near, At(1, 0), At(1, 1), At(0, 1) };
  const MeshReport report = this->Check();
  EXPECT_EQ(FiredChecks(report), (Fired{ { "near-vertices", 1 } }));
  EXPECT_THAT(report.Findings[0].Message, HasSubstr("at the other end of a side"));
}

TEST_F(MeshChecksTest, UnusedPoint)
{
  this->AddPoint(0.5, 0.5);
  this->AddPoint(std::numeric_limits<double>::quiet_NaN(), 0.0);
  const MeshReport report = this->Check();
  EXPECT_EQ(FiredChecks(report), (Fired{ { "unused-points", 2 } }));
  EXPECT_THAT(report.Findings[1].Vertices, ElementsAre(26));
}

TEST_F(MeshChecksTest, ElementTwice)
{
  this->Squares.push_back(this->Squares[5]);
  const MeshReport report = this->Check();
  EXPECT_EQ(FiredChecks(report), (Fired{ { "sides", 4 }, { "overlaps", 1 } }));
  EXPECT_THAT(report.Findings[0].Elements, ElementsAre(1, 5, 16));
  EXPECT_EQ(report.Findings[0].Message, "Side 6-7 has more than two elements: 1, 5 and 16.");
}

TEST_F(MeshChecksTest, VertexMovedAcross)
{
  // Two squares become bow-ties or turn over; what lies around them is not reported again.
  this->Points[At(2, 2)] = { 0.5, 2.25 };
  const Fired fired = this->GetFired();
  EXPECT_GT(fired.count("simple"), 0U);
  EXPECT_GT(fired.count("overlaps"), 0U);
  EXPECT_EQ(fired.count("holes"), 0U);
  EXPECT_EQ(fired.count("t-junctions"), 0U);
}

TEST_F(MeshChecksTest, TriangleFoldedOver)
{
  // Four triangles around (1, 1), which moves beyond one of their outer sides.
  const std::vector<Point2> points = { { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 }, { 1, -1 } };
  const MeshReport report =
    CheckMesh(MakeRawMesh(points, { { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } }), {});
  // Element 0 lies below its side 0-1, over the tips of the others.
  EXPECT_EQ(
    FiredChecks(report), (Fired{ { "orientation", 1 }, { "sides", 2 }, { "overlaps", 3 } }));
}

TEST_F(MeshChecksTest, TJunctionExact)
{
  const int middle = this->AddPoint(2.0, 1.5);
  this->Squares[Square(1, 1)] = { At(1, 1), At(2, 1), middle, At(2, 2), At(1, 2) };
  const MeshReport report = this->Check();
  EXPECT_EQ(FiredChecks(report), (Fired{ { "t-junctions", 1 } }));
  EXPECT_EQ(report.Findings[0].Message,
    "Vertex 25 lies exactly on side 12-7 of element 6, which does not have it.");
  EXPECT_THAT(report.Findings[0].Elements, ElementsAre(6));
  EXPECT_EQ(report.NumberOfComponents, 1);
  EXPECT_EQ(report.NumberOfHoles, 0);
}

TEST_F(MeshChecksTest, TJunctionWithinRounding)
{
  for (const double off : { -1e-15, 1e-15, -1e-13, 1e-13 })
  {
    this->Points.resize(25);
    const int middle = this->AddPoint(2.0 + off, 1.5);
    this->Squares[Square(1, 1)] = { At(1, 1), At(2, 1), middle, At(2, 2), At(1, 2) };
    const MeshReport report = this->Check();
    EXPECT_EQ(FiredChecks(report), (Fired{ { "t-junctions", 1 } })) << off;
    EXPECT_THAT(report.Findings[0].Message, HasSubstr("within rounding"));
  }
  this->Points.resize(25);
  const int middle = this->AddPoint(2.0 + 1e-3, 1.5);
  this->Squares[Square(1, 1)] = { At(1, 1), At(2, 1), middle, At(2, 2), At(1, 2) };
  EXPECT_EQ(this->GetFired()["overlaps"], 1) << "that is no rounding";
}

TEST_F(MeshChecksTest, SeveralVerticesOnOneSide)
{
  const int one = this->AddPoint(2.0, 1.25);
  const int two = this->AddPoint(2.0, 1.5);
  const int three = this->AddPoint(2.0, 1.75);
  this->Squares[Square(1, 1)] = { At(1, 1), At(2, 1), one, two, three, At(2, 2), At(1, 2) };
  this->Squares[Square(2, 1)] = { At(2, 1), At(3, 1), At(3, 2), At(2, 2), two };
  EXPECT_EQ(this->GetFired(), (Fired{ { "t-junctions", 2 } }));
}

TEST_F(MeshChecksTest, HoleIsAWarning)
{
  this->Squares.erase(this->Squares.begin() + 5);
  const MeshReport report = this->Check();
  EXPECT_EQ(FiredChecks(report), (Fired{ { "holes", 1 } }));
  EXPECT_EQ(report.NumberOfHoles, 1);
  EXPECT_EQ(report.GetCount(CheckSeverity::Error), 0);
  EXPECT_EQ(report.Findings[0].Message, "A hole of 4 sides and area 1 begins at vertex 6.");
  EXPECT_EQ(report.Findings[0].Place, (Point2{ 1.5, 1.5 }));
}

TEST_F(MeshChecksTest, HolesThatTouchAreTwoAndPinchTheMesh)
{
  this->Squares.erase(this->Squares.begin() + Square(2, 2));
  this->Squares.erase(this->Squares.begin() + Square(1, 1));
  const MeshReport report = this->Check();
  EXPECT_EQ(FiredChecks(report), (Fired{ { "pinched-vertices", 1 }, { "holes", 2 } }));
  EXPECT_THAT(report.Findings[0].Vertices, ElementsAre(At(2, 2)));
  EXPECT_THAT(report.Findings[0].Elements, testing::SizeIs(2));
}

TEST_F(MeshChecksTest, ElementInAHoleThatFillsOnlyPartOfIt)
{
  this->Squares.erase(this->Squares.begin() + 5);
  this->Squares.push_back({ At(1, 1), At(2, 1), At(1, 2) });
  EXPECT_EQ(this->GetFired(), (Fired{ { "holes", 1 } }));
  // Loose in the hole.
  const int a = this->AddPoint(1.25, 1.25);
  const int b = this->AddPoint(1.5, 1.25);
  const int c = this->AddPoint(1.25, 1.5);
  this->Squares.back() = { a, b, c };
  EXPECT_EQ(this->GetFired(), (Fired{ { "connected", 1 }, { "holes", 1 } }));
}

TEST_F(MeshChecksTest, TwoPieces)
{
  for (int j = 0; j < N; ++j)
  {
    this->Squares[Square(1, j)].clear();
  }
  std::erase_if(this->Squares, [](const auto& square) { return square.empty(); });
  const MeshReport report = this->Check();
  EXPECT_EQ(FiredChecks(report), (Fired{ { "connected", 1 } }));
  EXPECT_EQ(report.NumberOfComponents, 2);
  EXPECT_EQ(
    report.Findings[0].Message, "No side joins element 0 and 3 others to the rest of the mesh.");
}

TEST_F(MeshChecksTest, ElementsThatShareAVertexOnly)
{
  const std::vector<Point2> points = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };
  EXPECT_EQ(FiredChecks(MakeRawMesh(points, { { 0, 1, 2 }, { 0, 3, 4 } })),
    (Fired{ { "pinched-vertices", 1 }, { "connected", 1 } }));
}

TEST_F(MeshChecksTest, ElementOnTopOfOthers)
{
  const int a = this->AddPoint(1.25, 1.25);
  const int b = this->AddPoint(2.75, 1.25);
  const int c = this->AddPoint(2.75, 1.5);
  this->Squares.push_back({ a, b, c });
  const MeshReport report = this->Check();
  EXPECT_EQ(FiredChecks(report), (Fired{ { "overlaps", 2 }, { "connected", 1 } }));
  EXPECT_EQ(report.Findings[0].Message, "Elements 5 and 16 overlap.");
  EXPECT_EQ(report.Findings[1].Message, "Elements 6 and 16 overlap.");
  EXPECT_EQ(report.Faults[16], 3);
}

TEST_F(MeshChecksTest, ConcaveElementsWhoseBoxesMeetDoNotOverlap)
{
  // Two combs that reach between each other's teeth without touching; each is one element.
  const std::vector<Point2> points = { { 0, 0 }, { 5, 0 }, { 5, 3 }, { 4, 3 }, { 4, 1 }, { 1, 1 },
    { 1, 3 }, { 0, 3 }, { 2, 2 }, { 3, 2 }, { 3, 4 }, { 2, 4 } };
  const Elements combs = { { 0, 1, 2, 3, 4, 5, 6, 7 }, { 8, 9, 10, 11 } };
  EXPECT_EQ(FiredChecks(MakeRawMesh(points, combs)), (Fired{ { "connected", 1 } }));
  std::vector<Point2> lower = points;
  lower[8].y = lower[9].y = 1.0 - 1e-15;
  CheckOptions exact;
  exact.Tolerance = 0.0;
  EXPECT_EQ(FiredChecks(MakeRawMesh(lower, combs), exact)["overlaps"], 1);
  lower[8].y = lower[9].y = 1.0;
  EXPECT_EQ(FiredChecks(MakeRawMesh(lower, combs), exact)["overlaps"], 0) << "they touch";
}

TEST_F(MeshChecksTest, DomainFindsMissingElements)
{
  CheckOptions options;
  options.ExpectedDomain = Domain{ { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } }, {} };
  EXPECT_EQ(this->GetFired(options), Fired());
  const Elements all = this->Squares;
  this->Squares.erase(this->Squares.begin() + 5); // inside: a hole, whose four vertices are off
  EXPECT_EQ(this->GetFired(options), (Fired{ { "holes", 1 }, { "coverage", 5 } }));
  options.ExpectedDomain->Holes = { { { 1, 1 }, { 2, 1 }, { 2, 2 }, { 1, 2 } } };
  EXPECT_EQ(this->GetFired(options), Fired());
  this->Squares = all;
  EXPECT_EQ(this->GetFired(options), (Fired{ { "coverage", 1 } })) << "the hole is filled";
  options.ExpectedDomain->Holes.clear();
  this->Squares.erase(this->Squares.begin()); // at the corner
  EXPECT_EQ(this->GetFired(options), (Fired{ { "coverage", 2 }, { "unused-points", 1 } }));
}

TEST_F(MeshChecksTest, ExamplesAreLimitedAndAllAreCounted)
{
  for (auto& square : this->Squares)
  {
    std::reverse(square.begin(), square.end());
  }
  CheckOptions options;
  options.MostExamples = 3;
  const MeshReport report = this->Check(options);
  EXPECT_EQ(report.Findings.size(), 3U);
  EXPECT_EQ(report.GetCount("orientation"), 16);
  EXPECT_THAT(report.Faults, testing::Each(1));
}

TEST_F(MeshChecksTest, OnlyChosenChecksAreMade)
{
  std::reverse(this->Squares[3].begin(), this->Squares[3].end());
  this->AddPoint(0.5, 0.5);
  CheckOptions options;
  options.Checks = { "unused-points" };
  EXPECT_EQ(this->GetFired(options), (Fired{ { "unused-points", 1 } }));
  EXPECT_EQ(this->Check(options).NumberOfComponents, -1) << "no check needed to know";
}

TEST_F(MeshChecksTest, StopsWhenAskedTo)
{
  CheckOptions options;
  int calls = 0;
  options.Progress = [&calls](double) { return ++calls < 3; };
  EXPECT_TRUE(this->Check(options).IsStopped);
  EXPECT_EQ(calls, 3);
}

TEST_F(MeshChecksTest, NothingAtAll)
{
  EXPECT_EQ(FiredChecks(RawMesh{}), Fired());
  EXPECT_EQ(FiredChecks(MakeRawMesh({}, { { 0, 1, 2 } })), (Fired{ { "vertex-numbers", 1 } }));
  EXPECT_EQ(
    FiredChecks(MakeRawMesh({ { 0, 0 } }, { { 0, 0, 0 }, { 0 } })), (Fired{ { "degenerate", 2 } }));
}

TEST_F(MeshChecksTest, EverythingOnOneHeapIsCountedWithoutEnd)
{
  const int n = 300;
  Elements heap;
  for (int i = 0; i < n; ++i)
  {
    heap.push_back({ 0, 1, 2 });
  }
  const MeshReport report = CheckMesh(MakeRawMesh({ { 0, 0 }, { 1, 0 }, { 0, 1 } }, heap), {});
  EXPECT_GE(report.GetCount("overlaps"), n - 1);
  EXPECT_EQ(report.GetCount("sides"), 3);
}

} // namespace

} // namespace pemesh
