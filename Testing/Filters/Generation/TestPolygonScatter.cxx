// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Scattered polygons: valid at every deformation, judged by the exact check of layouts and by
 * distances between vertices and edges, and refused where they cannot fit.
 */
#include "PolygonScatter.h"

#include "ErrorLog.h"
#include "MeshInvariants.h"
#include "TestMeshes.h"
#include "vtkPEMPolygonLayout.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTrivialProducer.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace
{

using pemesh::Domain;
using pemesh::Point2;
using pemesh::ScatteredPolygon;
using pemesh::ScatterOptions;
using testing::HasSubstr;

double Distance(const Point2& point, const Point2& from, const Point2& to)
{
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double s = ((point.x - from.x) * dx + (point.y - from.y) * dy) / (dx * dx + dy * dy);
  const double clamped = std::min(std::max(s, 0.0), 1.0);
  return std::hypot(point.x - from.x - clamped * dx, point.y - from.y - clamped * dy);
}

/** From vertices to edges, both ways: that of polygons that do not meet. */
double Distance(const PolygonVertices& a, const PolygonVertices& b)
{
  double least = INFINITY;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      least = std::min({ least, Distance(a[i], b[j], b[(j + 1) % b.size()]),
        Distance(b[j], a[i], a[(i + 1) % a.size()]) });
    }
  }
  return least;
}

std::string Scatter(const ScatterOptions& options, std::vector<ScatteredPolygon>& scattered,
  const Domain& domain = pemesh::UnitSquare())
{
  return pemesh::ScatterPolygons(options, domain, {}, scattered);
}

} // namespace

TEST(PolygonScatter, ValidAtEveryDeformationWithTheGapAsked)
{
  for (int seed = 0; seed < 12; ++seed)
  {
    const double gap = seed % 3 * 0.01;
    vtkNew<vtkPEMPolygonLayout> layout;
    layout->AddPolygon("star", 0.5, 0.5);
    layout->SetPolygonScale(0, 0.5);
    ASSERT_EQ(layout->ScatterPolygons(18, seed, {}, 0.1, 0.3, gap), 1);
    EXPECT_EQ(layout->GetNumberOfPolygons(), 19);
    for (const double t : { 0.0, 0.37, 0.5, 0.9, 1.0 })
    {
      EXPECT_EQ(layout->FindFault(t), "") << seed;
    }
    layout->UpdateTimeStep(0.93);
    for (int i = 0; i < 19; ++i)
    {
      const PolygonVertices polygon = VerticesOf(layout->GetOutput(), i);
      for (const Point2& point : polygon)
      {
        const double border = std::min({ point.x, point.y, 1.0 - point.x, 1.0 - point.y });
        EXPECT_GE(border, i == 0 ? 0.0 : gap);
      }
      for (int j = 0; j < i; ++j)
      {
        EXPECT_GE(Distance(polygon, VerticesOf(layout->GetOutput(), j)), gap);
      }
    }
  }
}

TEST(PolygonScatter, CyclesOrDrawsFamiliesWithinTheRangesAsked)
{
  ScatterOptions options;
  options.Count = 60;
  options.Families = { "comb", "random" };
  options.SmallestScale = 0.05;
  options.LargestScale = 0.15;
  options.LargestRotation = 45.0;
  std::vector<ScatteredPolygon> polygons;
  ASSERT_EQ(Scatter(options, polygons), "");
  ASSERT_EQ(polygons.size(), 60u);
  std::set<double> scales;
  std::set<std::uint64_t> seeds;
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    EXPECT_STREQ(polygons[i].Family->Name, i % 2 == 0 ? "comb" : "random");
    EXPECT_GE(polygons[i].Place.Scale, 0.05);
    EXPECT_LE(polygons[i].Place.Scale, 0.15);
    EXPECT_GE(polygons[i].Rotation, 0.0);
    EXPECT_LE(polygons[i].Rotation, 45.0);
    scales.insert(polygons[i].Place.Scale);
    seeds.insert(polygons[i].Seed);
  }
  EXPECT_EQ(scales.size(), 60u);
  EXPECT_EQ(seeds.size(), 60u);
  options.DrawsFamilies = true;
  ASSERT_EQ(Scatter(options, polygons), "");
  const auto combs = std::count_if(polygons.begin(), polygons.end(),
    [](const ScatteredPolygon& polygon) { return std::string(polygon.Family->Name) == "comb"; });
  EXPECT_GT(combs, 15);
  EXPECT_LT(combs, 45);
  EXPECT_NE(combs, 30) << "drawn, not cycled (with this seed)";
}

TEST(PolygonScatter, TheSameForTheSameSeedOnly)
{
  ScatterOptions options;
  std::vector<ScatteredPolygon> first, again, other;
  ASSERT_EQ(Scatter(options, first), "");
  ASSERT_EQ(Scatter(options, again), "");
  options.Seed = 1;
  ASSERT_EQ(Scatter(options, other), "");
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    EXPECT_EQ(first[i].Place, again[i].Place);
    EXPECT_EQ(first[i].Rotation, again[i].Rotation);
    EXPECT_NE(first[i].Place.Center, other[i].Place.Center);
  }
}

TEST(PolygonScatter, RefusesWhatCannotFit)
{
  ScatterOptions options;
  options.Count = 200;
  std::vector<ScatteredPolygon> polygons;
  const std::string message = Scatter(options, polygons);
  EXPECT_THAT(message, testing::StartsWith("Only "));
  EXPECT_THAT(message,
    HasSubstr(" of 200 scattered polygons found a place with scales from 0.2 to 0.2 and a gap of "
              "0.01; scatter fewer, or make the scales or the gap smaller."));
  EXPECT_TRUE(polygons.empty());
  // Squares of side 0.1 and the gap, 0.11: at most 9 x 9; random ones come to about 56 % of that.
  const int placed = std::stoi(message.substr(5));
  EXPECT_GT(placed, 35);
  EXPECT_LT(placed, 64);
  options.Count = 1;
  options.SmallestScale = options.LargestScale = 3.0;
  EXPECT_THAT(Scatter(options, polygons), testing::StartsWith("Only 0 of 1"));
}

TEST(PolygonScatter, ManySmallOnesInLittleTime)
{
  ScatterOptions options;
  options.Count = 5000;
  options.SmallestScale = options.LargestScale = 0.015;
  options.Gap = 0.0;
  std::vector<ScatteredPolygon> polygons;
  EXPECT_EQ(Scatter(options, polygons), "");
  EXPECT_EQ(polygons.size(), 5000u);
}

TEST(PolygonScatter, StaysInDomainsWithHolesOfAnySize)
{
  const std::vector<std::vector<Point2>> loops = { { { -100, -100 }, { 100, -100 }, { 0, 100 } },
    { { -20, -50 }, { 20, -50 }, { 0, 0 } } };
  Domain domain;
  ASSERT_EQ(pemesh::MakeDomain(loops, domain), "");
  ScatterOptions options;
  options.Count = 25;
  options.SmallestScale = 10.0;
  options.LargestScale = 20.0;
  options.Gap = 1.0;
  std::vector<ScatteredPolygon> polygons;
  ASSERT_EQ(Scatter(options, polygons, domain), "");
  for (const ScatteredPolygon& polygon : polygons)
  {
    const double half = polygon.Place.Scale * 0.25;
    const Point2 c = polygon.Place.Center;
    const PolygonVertices square = { { c.x - half, c.y - half }, { c.x + half, c.y - half },
      { c.x + half, c.y + half }, { c.x - half, c.y + half } };
    EXPECT_GE(Distance(square, loops[0]), 1.0);
    EXPECT_GE(Distance(square, loops[1]), 1.0);
    EXPECT_GT(c.y, -100.0);
    EXPECT_LT(2.0 * std::abs(c.x) + c.y, 100.0) << "inside the outer triangle";
    EXPECT_FALSE(c.y > -50.0 && 2.5 * std::abs(c.x) + c.y < 0.0) << "outside the hole";
  }
}

TEST(PolygonScatter, DomainIsTheInputOfTheLayout)
{
  vtkNew<vtkPEMPolygonLayout> layout;
  layout->SetInputDataObject(
    0, pemesh::MakeTestMesh({ { 2, 2 }, { 4, 2 }, { 4, 3 }, { 2, 3 } }, { { 0, 1, 2, 3 } }));
  ASSERT_EQ(layout->ScatterPolygons(5, 3, { "zeta" }, 0.5, 0.5, 0.0), 0);
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_GT(layout->GetPolygonCenterX(i), 2.0);
    EXPECT_LT(layout->GetPolygonCenterY(i), 3.0);
  }
}

TEST(PolygonScatter, WrongOptionsAreNamed)
{
  vtkNew<vtkPEMPolygonLayout> layout;
  pemesh::ErrorLog log(layout);
  EXPECT_EQ(layout->ScatterPolygons(0, 0, {}, 0.1, 0.2, 0.0), -1);
  EXPECT_THAT(log.GetText(), HasSubstr("number of polygons to scatter is 0"));
  EXPECT_EQ(layout->ScatterPolygons(1, -1, {}, 0.1, 0.2, 0.0), -1);
  EXPECT_EQ(layout->ScatterPolygons(1, 0.5, {}, 0.1, 0.2, 0.0), -1);
  EXPECT_THAT(log.GetText(), HasSubstr("The seed is -1"));
  EXPECT_EQ(layout->ScatterPolygons(1, 0, { "combe" }, 0.1, 0.2, 0.0), -1);
  EXPECT_THAT(log.GetText(), HasSubstr("family \"combe\" to scatter; did you mean \"comb\"?"));
  EXPECT_EQ(layout->ScatterPolygons(1, 0, { "file" }, 0.1, 0.2, 0.0), -1);
  EXPECT_EQ(layout->ScatterPolygons(1, 0, {}, 0.3, 0.2, 0.0), -1);
  EXPECT_THAT(log.GetText(), HasSubstr("scales of the polygons to scatter are 0.3 to 0.2"));
  EXPECT_EQ(layout->ScatterPolygons(1, 0, {}, 0.1, 0.2, NAN), -1);
  EXPECT_THAT(log.GetText(), HasSubstr("gap"));
  EXPECT_EQ(layout->GetNumberOfPolygons(), 0);
}
