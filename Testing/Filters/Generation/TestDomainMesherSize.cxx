// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMDomainMesher.h"

#include "CaseStatus.h"
#include "ErrorLog.h"
#include "GenerationSupport.h"
#include "MeshInvariants.h"
#include "PolygonFamilies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace
{

using pemesh::Point2;
using testing::HasSubstr;

double DistanceToEdge(const Point2& point, const Point2& from, const Point2& to)
{
  const Point2 along = { to.x - from.x, to.y - from.y };
  const double place = ((point.x - from.x) * along.x + (point.y - from.y) * along.y) /
    (along.x * along.x + along.y * along.y);
  const double inside = std::clamp(place, 0.0, 1.0);
  return std::hypot(point.x - from.x - inside * along.x, point.y - from.y - inside * along.y);
}

/** The formula of the header, by brute force. */
double WantedArea(const Point2& point, const std::vector<PolygonVertices>& polygons,
  double gradation, double sizeAtPolygons, double maximumArea)
{
  double side = INFINITY;
  for (const PolygonVertices& polygon : polygons)
  {
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Point2& to = polygon[(i + 1) % polygon.size()];
      const double length = std::hypot(to.x - polygon[i].x, to.y - polygon[i].y);
      side = std::min(side,
        (sizeAtPolygons > 0.0 ? sizeAtPolygons : length) +
          gradation * DistanceToEdge(point, polygon[i], to));
    }
  }
  return std::min(maximumArea, std::sqrt(3.0) / 4.0 * side * side);
}

class DomainMesherGradation : public testing::TestWithParam<std::tuple<int, double, double>>
{
};

TEST_P(DomainMesherGradation, BoundsEveryFillerAtItsCentroid)
{
  const auto& [family, gradation, size] = GetParam();
  Generation generation;
  generation.Layout->AddPolygon(pemesh::PolygonFamilies()[family].Name, 0.35, 0.4);
  generation.Layout->AddPolygon("n-sided", 0.8, 0.8);
  generation.Layout->SetPolygonScale(0, 0.6);
  generation.Layout->SetPolygonScale(1, 0.4);
  generation.Mesher->SetGradation(gradation);
  generation.Mesher->SetSizeAtPolygons(size);
  generation.Mesher->SetAreaRuleByName("constant");
  generation.Mesher->SetMaximumArea(0.003);
  vtkPolyData* mesh = generation.MeshAt(0.4);
  ASSERT_EQ(pemesh::GetCaseStatusMessage(mesh), "");
  EXPECT_EQ(WhyNotAMesh(mesh), "");
  EXPECT_GE(pemesh::GetFieldNumber(mesh, "AttainedMinimumAngle"), 20.0);
  const std::vector<PolygonVertices> placed = { VerticesOf(generation.Layout->GetOutput(), 0),
    VerticesOf(generation.Layout->GetOutput(), 1) };
  double least = 0.0; // the number of triangles that the bounds ask for
  int graded = 0;
  for (int cell = 2; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const PolygonVertices filler = VerticesOf(mesh, cell);
    const Point2 centroid = { (filler[0].x + filler[1].x + filler[2].x) / 3.0,
      (filler[0].y + filler[1].y + filler[2].y) / 3.0 };
    const double bound = WantedArea(centroid, placed, gradation, size, 0.003);
    ASSERT_LE(SignedArea(filler), bound * (1.0 + 1e-9)) << "filler " << cell;
    least += SignedArea(filler) / bound;
    graded += bound < 0.003;
  }
  EXPECT_GT(graded, 50);
  if (size > 0.0) // otherwise short edges next to long ones ask for more by their angles
  {
    EXPECT_LT(mesh->GetNumberOfCells(), 2.5 * least + 200.0) << "not finer than wanted";
  }
}

INSTANTIATE_TEST_SUITE_P(All, DomainMesherGradation,
  testing::Combine(testing::Range(0, 8), testing::Values(0.1, 0.7), testing::Values(0.0, 0.01)));

TEST(DomainMesherSize, PreservedPolygonsStayAsTheyAre)
{
  Generation generation;
  generation.Layout->AddPolygon("comb", 0.5, 0.5);
  generation.Mesher->SetGradation(0.3);
  generation.Mesher->PreservePolygonsOn();
  vtkPolyData* mesh = generation.MeshAt(0.7);
  EXPECT_EQ(WhyNotAMesh(mesh), "");
  EXPECT_EQ(VerticesOf(mesh, 0), VerticesOf(generation.Layout->GetOutput(), 0));
  EXPECT_GE(pemesh::GetFieldNumber(mesh, "AttainedMinimumAngle"), 10.0);
}

TEST(DomainMesherSize, GradationWithoutPolygonsOrRuleChangesNothing)
{
  Generation generation;
  generation.Mesher->SetGradation(0.3);
  EXPECT_EQ(generation.MeshAt(0.0)->GetNumberOfCells(), 2);
  generation.Layout->AddPolygon("zeta", 0.5, 0.5);
  generation.Mesher->SetGradation(1e9);
  const vtkIdType count = generation.MeshAt(0.5)->GetNumberOfCells();
  generation.Mesher->SetGradation(0.0);
  EXPECT_NEAR(static_cast<double>(generation.MeshAt(0.5)->GetNumberOfCells()), count, 0.2 * count);
}

TEST(DomainMesherSize, TenThousandEdgesAreNoObstacle)
{
  Generation generation;
  generation.Layout->AddPolygon("n-sided", 0.5, 0.5);
  generation.Layout->SetPolygonParameter(0, "sides", 10000);
  generation.Mesher->SetGradation(0.5);
  vtkPolyData* mesh = generation.MeshAt(1.0);
  EXPECT_EQ(pemesh::GetCaseStatusMessage(mesh), "");
  EXPECT_GT(mesh->GetNumberOfCells(), 20000);
  EXPECT_LT(mesh->GetNumberOfCells(), 200000);
}

TEST(DomainMesherSize, WrongSettingsAreErrors)
{
  Generation generation;
  pemesh::ErrorLog log(generation.Mesher);
  generation.Mesher->SetGradation(-0.1);
  EXPECT_EQ(generation.Mesher->GetExecutive()->Update(), 0);
  EXPECT_THAT(log.GetText(), HasSubstr("Gradation is -0.1, expected 0 or more"));
  log.Clear();
  generation.Mesher->SetGradation(0.1);
  generation.Mesher->SetSizeAtPolygons(NAN);
  EXPECT_EQ(generation.Mesher->GetExecutive()->Update(), 0);
  EXPECT_THAT(log.GetText(), HasSubstr("SizeAtPolygons is nan"));
}

} // namespace
