// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonMeasures.h"
#include "RandomSites.h"
#include "SampleDomains.h"
#include "TessellationInvariants.h"
#include "VoronoiMesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pemesh
{

namespace
{

using ::testing::HasSubstr;

const auto Go = [](double) { return true; };

double SquaredDistance(const Point2& a, const Point2& b)
{
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

std::vector<Point2> Sites(const Domain& domain, int count, double spacing = 0.0)
{
  std::vector<Point2> sites;
  EXPECT_EQ(RandomSites(domain, count, spacing, 7, sites), "");
  return sites;
}

/** By Green's theorem: the integral of the squared distance to the site over each element. */
double Energy(const ClippedMesh& mesh, const std::vector<Point2>& sites)
{
  double energy = 0.0;
  std::vector<Point2> vertices;
  for (int element = 0; element < mesh.Mesh.NumberOfElements(); ++element)
  {
    mesh.Mesh.GetVertices(element, vertices);
    const Point2& site = sites[mesh.Cells[element]];
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      const Point2& p = vertices[i];
      const Point2& q = vertices[(i + 1) % vertices.size()];
      const Point2 a = { p.x - site.x, p.y - site.y };
      const Point2 b = { q.x - site.x, q.y - site.y };
      energy += (a.x * b.y - a.y * b.x) / 12.0 *
        (a.x * a.x + a.y * a.y + a.x * b.x + a.y * b.y + b.x * b.x + b.y * b.y);
    }
  }
  return energy;
}

double Energy(const Domain& domain, const std::vector<Point2>& sites)
{
  ClippedMesh mesh;
  EXPECT_EQ(VoronoiMesh(sites, domain, Go, mesh), "");
  return Energy(mesh, sites);
}

TEST(VoronoiMesh, NoOtherSiteIsNearerThanThatOfTheCell)
{
  for (const SampleDomain& domain : SampleDomains())
  {
    const std::vector<Point2> sites = Sites(domain.Region, 150);
    ClippedMesh mesh;
    ASSERT_EQ(VoronoiMesh(sites, domain.Region, Go, mesh), "") << domain.Name;
    ASSERT_EQ(WhyNotAMeshOf(domain.Region, mesh.Mesh), "") << domain.Name;
    const double length = std::sqrt(DomainArea(domain.Region));
    for (int element = 0; element < mesh.Mesh.NumberOfElements(); ++element)
    {
      ASSERT_GE(mesh.Cells[element], 0);
      for (const int vertex : mesh.Mesh.Element(element))
      {
        // The cell is the hull of its vertices, up to the boundary.
        const Point2& point = mesh.Mesh.Points[vertex];
        const double own = std::sqrt(SquaredDistance(point, sites[mesh.Cells[element]]));
        for (const Point2& site : sites)
        {
          ASSERT_GE(std::sqrt(SquaredDistance(point, site)), own - 1e-8 * length) << domain.Name;
        }
      }
    }
  }
}

TEST(VoronoiMesh, SitesOnAGridHaveSquareCellsWithFourVertices)
{
  std::vector<Point2> sites;
  for (int j = 0; j < 10; ++j)
  {
    for (int i = 0; i < 10; ++i)
    {
      sites.push_back({ (i + 0.5) / 10.0, (j + 0.5) / 10.0 });
    }
  }
  ClippedMesh mesh;
  ASSERT_EQ(VoronoiMesh(sites, UnitSquare(), Go, mesh), "");
  EXPECT_EQ(WhyNotAMeshOf(UnitSquare(), mesh.Mesh), "");
  EXPECT_EQ(mesh.Mesh.NumberOfElements(), 100);
  EXPECT_EQ(mesh.Mesh.NumberOfSides(), 400);
  EXPECT_EQ(mesh.Mesh.Points.size(), 121U);
}

TEST(VoronoiMesh, OneSiteHasTheWholeDomain)
{
  ClippedMesh mesh;
  ASSERT_EQ(VoronoiMesh({ { 0.2, 0.7 } }, UnitSquare(), Go, mesh), "");
  EXPECT_EQ(mesh.Mesh.NumberOfElements(), 1);
  EXPECT_EQ(mesh.Mesh.Points.size(), 4U);
}

/** Mean squared distance to the nearest of Poisson points of density d: 1 / (pi d). */
TEST(VoronoiMesh, TheEnergyOfRandomSitesIsThatOfAPoissonProcess)
{
  const int count = 4000;
  const double energy = Energy(UnitSquare(), Sites(UnitSquare(), count));
  EXPECT_NEAR(energy * count, 1.0 / std::numbers::pi, 0.02);
}

TEST(VoronoiMesh, EveryStepOfLloydLowersTheEnergy)
{
  for (const int sample : { 0, 4, 8, 9, 12 }) // square, L, comb, sieve, nested holes
  {
    const SampleDomain domain = SampleDomains()[sample];
    std::vector<Point2> sites = Sites(domain.Region, 120);
    double energy = Energy(domain.Region, sites);
    const double first = energy;
    for (int i = 0; i < 12; ++i)
    {
      ASSERT_EQ(RelaxSites(domain.Region, 1, Go, sites), "");
      const double next = Energy(domain.Region, sites);
      ASSERT_LT(next, energy) << domain.Name;
      energy = next;
    }
    EXPECT_LT(energy, 0.75 * first) << domain.Name;
  }
}

TEST(VoronoiMesh, AStepOfLloydGoesToTheCentroid)
{
  const Domain lShape = SampleDomains()[4].Region;
  std::vector<Point2> sites = { { 0.8, 0.1 } };
  ASSERT_EQ(RelaxSites(lShape, 1, Go, sites), "");
  EXPECT_NEAR(sites[0].x, 5.0 / 12.0, 1e-15);
  EXPECT_NEAR(sites[0].y, 5.0 / 12.0, 1e-15);
  // The centroid of a ring is not in it.
  const Domain ring = SampleDomains()[11].Region;
  sites = { { 0.97, 0.0 } };
  ASSERT_EQ(RelaxSites(ring, 1, Go, sites), "");
  EXPECT_EQ(sites[0], (Point2{ 0.97, 0.0 }));
}

/** No mesh has less than regular hexagons: 5 / (18 sqrt(3)) (Fejes Toth); Lloyd comes near. */
TEST(VoronoiMesh, LloydComesNearRegularHexagons)
{
  std::vector<Point2> sites = Sites(UnitSquare(), 400);
  ASSERT_EQ(RelaxSites(UnitSquare(), 100, Go, sites), "");
  const double least = 5.0 / (18.0 * std::numbers::sqrt3);
  const double energy = Energy(UnitSquare(), sites) * 400.0;
  EXPECT_GT(energy, least);
  EXPECT_LT(energy, 1.06 * least);
}

TEST(RandomSites, KeepTheirDistance)
{
  for (const SampleDomain& domain : SampleDomains())
  {
    const double spacing = 0.5;
    const std::vector<Point2> sites = Sites(domain.Region, 200, spacing);
    ASSERT_EQ(sites.size(), 200U);
    const double squared =
      spacing * spacing * 2.0 / std::numbers::sqrt3 * DomainArea(domain.Region) / 200.0;
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        ASSERT_GE(SquaredDistance(sites[i], sites[j]), squared * (1.0 - 1e-12)) << domain.Name;
      }
    }
  }
}

TEST(RandomSites, ThatFindNoPlaceAreRefused)
{
  std::vector<Point2> sites;
  const Domain needle = { { { 0.0, 0.0 }, { 1.0, 1.0 }, { 1.0, 1.0 + 1e-9 } }, {} };
  EXPECT_THAT(
    RandomSites(needle, 10, 0.0, 1, sites), HasSubstr("of 10 random points found a place"));
}

} // namespace

} // namespace pemesh
