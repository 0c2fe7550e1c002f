// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMDomain.h"
#include "vtkPEMDomainMesher.h"

#include "CaseStatus.h"
#include "GenerationSupport.h"
#include "MeshConversion.h"
#include "MeshInvariants.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

namespace
{

using pemesh::Point2;
using testing::HasSubstr;

using Loops = std::vector<PolygonVertices>;

PolygonVertices Square(double x, double y, double side)
{
  return { { x, y }, { x + side, y }, { x + side, y + side }, { x, y + side } };
}

struct Case
{
  const char* Name;
  Loops Domain;
  Loops Polygons;
};

/** Domains of all kinds with polygons in them. */
std::vector<Case> Cases()
{
  const PolygonVertices lShape = { { 0.0, 0.0 }, { 2.0, 0.0 }, { 2.0, 1.0 }, { 1.0, 1.0 },
    { 1.0, 2.0 }, { 0.0, 2.0 } };
  const PolygonVertices arrow = { { 0.1, 0.2 }, { 3.3, -1.7 }, { 1.1, 0.3 }, { 2.9, 2.4 } };
  const PolygonVertices spiral = { { 0.0, 0.0 }, { 4.0, 0.0 }, { 4.0, 4.0 }, { 1.0, 4.0 },
    { 1.0, 2.0 }, { 2.0, 2.0 }, { 2.0, 3.0 }, { 3.0, 3.0 }, { 3.0, 1.0 }, { 0.0, 1.0 } };
  const PolygonVertices triangle = { { -5.0, 3.0 }, { -3.9, 3.1 }, { -4.7, 3.9 } };
  const PolygonVertices kite = { { 0.31, 0.22 }, { 0.57, 0.33 }, { 0.41, 0.61 }, { 0.2, 0.45 } };
  return {
    { "l-shape", { lShape }, { Square(0.4, 0.4, 0.3), Square(1.5, 0.3, 0.2) } },
    { "arrow", { arrow }, {} },
    { "spiral", { spiral }, { Square(1.3, 2.2, 0.4) } },
    { "triangle", { triangle }, {} },
    { "holes", { Square(0.0, 0.0, 1.0), kite, Square(0.7, 0.7, 0.2) },
      { Square(0.1, 0.7, 0.2), Square(0.6, 0.1, 0.3) } },
    { "hole at border", { lShape, Square(0.5, 0.001, 0.4) }, {} },
  };
}

/** 20 degrees, or the smallest angle of the domain itself. */
double PromisedAngle(const pemesh::Domain& domain)
{
  double angle = SmallestOuterAngle(PolygonVertices(domain.Outer.rbegin(), domain.Outer.rend()));
  for (const PolygonVertices& hole : domain.Holes)
  {
    angle = std::min(angle, SmallestOuterAngle(hole));
  }
  return std::min(20.0, angle);
}

class DomainMesherDomains : public testing::TestWithParam<std::tuple<int, bool, bool>>
{
};

TEST_P(DomainMesherDomains, AreMeshedAroundPolygonsAndHoles)
{
  const auto& [index, preservePolygons, preserveDomain] = GetParam();
  const Case example = Cases()[index];
  SCOPED_TRACE(example.Name);
  pemesh::Domain domain;
  ASSERT_EQ(pemesh::MakeDomain(example.Domain, domain), "");
  vtkNew<vtkPEMDomainMesher> mesher;
  mesher->SetInputData(0, MakeLayout(example.Polygons));
  mesher->SetInputData(1, MakeLayout(example.Domain));
  mesher->SetPreservePolygons(preservePolygons);
  mesher->SetPreserveDomain(preserveDomain);
  mesher->SetAreaRuleByName("constant");
  for (const double area : { 1e10, 0.01 })
  {
    mesher->SetMaximumArea(area);
    mesher->Update();
    vtkPolyData* mesh = mesher->GetOutput();
    ASSERT_EQ(pemesh::GetCaseStatusMessage(mesh), "");
    EXPECT_EQ(WhyNotAMesh(mesh, domain), "");
    EXPECT_EQ(WhyNotConstrainedDelaunay(mesh), "");
    bool split = false;
    for (std::size_t i = 0; i < example.Polygons.size(); ++i)
    {
      split = split || VerticesOf(mesh, static_cast<int>(i)) != example.Polygons[i];
    }
    EXPECT_FALSE(split && preservePolygons);
    const bool needsNoSplit = area > 1.0 || example.Polygons.empty();
    EXPECT_TRUE(split || preservePolygons || preserveDomain || needsNoSplit);
    if (preserveDomain)
    {
      std::size_t given = 0;
      for (const PolygonVertices& loop : example.Domain)
      {
        given += loop.size();
      }
      EXPECT_EQ(NumberOfBorderEdges(mesh), static_cast<int>(given));
    }
    if (!preserveDomain && !preservePolygons)
    {
      EXPECT_EQ(WhyNotConforming(mesh), "");
      EXPECT_LE(LargestFiller(mesh), area);
      EXPECT_GE(pemesh::GetFieldNumber(mesh, "AttainedMinimumAngle"), PromisedAngle(domain) - 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, DomainMesherDomains,
  testing::Combine(testing::Range(0, 6), testing::Bool(), testing::Bool()));

TEST(DomainMesher, SmallTrianglesAreNearlyAsLargeAsTheyMay)
{
  // Through the bays and holes of these domains, too: refinement alone makes 1.6 times as many as
  // the area asks for, well-spaced points 1.2 times and what the boundary takes.
  for (const Case& example : Cases())
  {
    SCOPED_TRACE(example.Name);
    pemesh::Domain domain;
    ASSERT_EQ(pemesh::MakeDomain(example.Domain, domain), "");
    vtkNew<vtkPEMDomainMesher> mesher;
    mesher->SetInputData(0, MakeLayout({}));
    mesher->SetInputData(1, MakeLayout(example.Domain));
    mesher->SetAreaRuleByName("constant");
    const double area = pemesh::DomainArea(domain) / 2500.0;
    mesher->SetMaximumArea(area);
    mesher->Update();
    vtkPolyData* mesh = mesher->GetOutput();
    EXPECT_EQ(WhyNotAMesh(mesh, domain), "");
    EXPECT_EQ(WhyNotConstrainedDelaunay(mesh), "");
    EXPECT_LE(LargestFiller(mesh), area);
    EXPECT_LT(mesh->GetNumberOfCells(), 1.4 * 2500.0);
    EXPECT_GE(pemesh::GetFieldNumber(mesh, "AttainedMinimumAngle"), PromisedAngle(domain) - 1e-9);
  }
}

TEST(DomainMesher, MeshesTheDomainOfTheSource)
{
  vtkNew<vtkPEMDomain> source;
  Generation generation;
  generation.Layout->AddPolygon("star", 0.5, 0.5);
  generation.Layout->SetPolygonScale(0, 0.5);
  generation.Mesher->SetInputConnection(1, source->GetOutputPort());
  for (const char* shape : { "rectangle", "regular-polygon", "disc" })
  {
    source->SetShapeByName(shape);
    vtkPolyData* mesh = generation.MeshAt(0.5);
    ASSERT_EQ(pemesh::GetCaseStatusMessage(mesh), "");
    pemesh::Domain domain;
    EXPECT_EQ(pemesh::ToDomain(source->GetOutput(), domain), "");
    EXPECT_EQ(WhyNotAMesh(mesh, domain), "") << shape;
    EXPECT_EQ(WhyNotAMesh(mesh) == "", std::string(shape) == "rectangle");
  }
  source->SetShapeByName("l-shape");
  EXPECT_EQ(pemesh::GetCaseStatusMessage(generation.MeshAt(0.5)),
    "polygon 1 (star) leaves the domain at t = 0.5; move it inwards or make it smaller.");
}

TEST(DomainMesher, WithoutPolygonsTheDomainsMayBeTiny)
{
  vtkNew<vtkPEMDomain> source;
  source->SetParameter("width", 1e-6);
  source->SetParameter("height", 1e6);
  vtkNew<vtkPEMDomainMesher> mesher;
  vtkNew<vtkPolyData> nothing;
  mesher->SetInputData(0, nothing);
  mesher->SetInputConnection(1, source->GetOutputPort());
  mesher->SetMinimumAngle(0.0);
  mesher->Update();
  pemesh::Domain domain;
  EXPECT_EQ(pemesh::ToDomain(source->GetOutput(), domain), "");
  EXPECT_EQ(WhyNotAMesh(mesher->GetOutput(), domain), "");
}

TEST(DomainMesher, UnusableDomainsAreFailuresOfTheCase)
{
  vtkNew<vtkPEMDomainMesher> mesher;
  mesher->SetInputData(0, MakeLayout({ Square(0.4, 0.4, 0.1) }));
  mesher->SetInputData(1, MakeLayout({ Square(0.0, 0.0, 1.0), Square(2.0, 2.0, 1.0) }));
  mesher->Update();
  EXPECT_EQ(pemesh::GetCaseStatus(mesher->GetOutput()), "invalid-domain");
  EXPECT_THAT(pemesh::GetCaseStatusMessage(mesher->GetOutput()), HasSubstr("lies beside"));

  vtkNew<vtkPEMDomain> source;
  source->SetShapeByName("file");
  mesher->SetInputConnection(1, source->GetOutputPort());
  mesher->Update();
  EXPECT_EQ(pemesh::GetCaseStatus(mesher->GetOutput()), "invalid-domain");
  EXPECT_THAT(pemesh::GetCaseStatusMessage(mesher->GetOutput()), HasSubstr("no file was named"));
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), 0);
}

} // namespace
