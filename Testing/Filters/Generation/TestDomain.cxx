// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestFolder.h"
#include "vtkPEMDomain.h"

#include "CaseStatus.h"
#include "DomainShapes.h"
#include "ErrorLog.h"
#include "MeshConversion.h"
#include "MeshInvariants.h"

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>

namespace
{

using pemesh::Point2;
using testing::HasSubstr;

std::string WriteFile(const std::string& name, const std::string& text)
{
  const std::string path = pemesh::TestPath(name);
  std::ofstream(path) << text;
  return path;
}

pemesh::Domain DomainOf(vtkPEMDomain* source)
{
  source->Update();
  EXPECT_EQ(pemesh::GetCaseStatusMessage(source->GetOutput()), "");
  pemesh::Domain domain;
  EXPECT_EQ(pemesh::ToDomain(source->GetOutput(), domain), "");
  return domain;
}

TEST(Domain, IsTheUnitSquareByDefault)
{
  vtkNew<vtkPEMDomain> source;
  EXPECT_EQ(source->GetShapeName(), "rectangle");
  EXPECT_EQ(source->GetParameter("width"), 1.0);
  EXPECT_EQ(DomainOf(source).Outer, pemesh::UnitSquare().Outer);
}

TEST(Domain, EveryShapeIsValidAtTheEndsOfItsRanges)
{
  for (const pemesh::DomainShape& shape : pemesh::DomainShapes())
  {
    SCOPED_TRACE(shape.Name);
    for (const pemesh::Parameter& parameter : shape.Parameters)
    {
      for (const double value : { parameter.Default, parameter.Least, parameter.Greatest })
      {
        pemesh::ParameterValues values(shape.Parameters);
        ASSERT_EQ(values.Set(parameter.Name, value), "");
        const pemesh::Domain made = shape.Make(values);
        pemesh::Domain domain;
        EXPECT_EQ(pemesh::MakeDomain({ made.Outer }, domain), "") << parameter.Name << value;
        EXPECT_EQ(domain.Outer, made.Outer) << "counter-clockwise";
        const auto less = [](double Point2::*coordinate)
        { return [=](const Point2& a, const Point2& b) { return a.*coordinate < b.*coordinate; }; };
        const auto& outer = made.Outer;
        EXPECT_EQ(std::min_element(outer.begin(), outer.end(), less(&Point2::x))->x, 0.0);
        EXPECT_EQ(std::min_element(outer.begin(), outer.end(), less(&Point2::y))->y, 0.0);
      }
    }
  }
}

TEST(Domain, ShapesHaveTheirAreasAndSizes)
{
  vtkNew<vtkPEMDomain> source;
  source->SetParameter("width", 3.0);
  source->SetParameter("height", 0.5);
  EXPECT_EQ(pemesh::DomainArea(DomainOf(source)), 1.5);

  source->SetShapeByName("l-shape");
  EXPECT_EQ(source->GetParameter("width"), 1.0) << "a new shape starts from its defaults";
  EXPECT_EQ(pemesh::DomainArea(DomainOf(source)), 0.75);
  source->SetParameter("share", 0.25);
  source->SetParameter("width", 2.0);
  EXPECT_EQ(pemesh::DomainArea(DomainOf(source)), 2.0 * (1.0 - 0.0625));

  for (const char* name : { "regular-polygon", "disc" })
  {
    source->SetShapeByName(name);
    for (const int sides : { 3, 4, 5, 6, 7, 8, 10, 64, 1001 })
    {
      SCOPED_TRACE(sides);
      source->SetParameter("sides", sides);
      source->SetParameter("radius", 2.0);
      const pemesh::Domain domain = DomainOf(source);
      ASSERT_EQ(domain.Outer.size(), static_cast<std::size_t>(sides));
      const double angle = 2.0 * std::numbers::pi / sides;
      EXPECT_NEAR(pemesh::DomainArea(domain), 2.0 * sides * std::sin(angle), 1e-12);
      EXPECT_EQ(domain.Outer[0].y, domain.Outer.back().y) << "it stands on a level side";
      for (std::size_t i = 0; i < domain.Outer.size(); ++i)
      {
        const Point2& next = domain.Outer[(i + 1) % domain.Outer.size()];
        EXPECT_NEAR(std::hypot(next.x - domain.Outer[i].x, next.y - domain.Outer[i].y),
          4.0 * std::sin(0.5 * angle), 1e-13);
      }
    }
  }
  source->SetParameter("sides", 4.0);
  EXPECT_TRUE(pemesh::IsRectangle(DomainOf(source)));
}

TEST(Domain, FilesGiveLoopsInAnyOrderAndOrientation)
{
  const std::string path = WriteFile("domain.csv",
    "0.2,0.2\n0.2,0.4\n0.4,0.4\n0.4,0.2\n\n"
    "0,0\n0,1\n2,1\n2,0\n\n"
    "1,0.5\n1.5,0.5\n1,0.75\n");
  vtkNew<vtkPEMDomain> source;
  source->SetShapeByName("file");
  source->SetFileName(path);
  const pemesh::Domain domain = DomainOf(source);
  EXPECT_EQ(pemesh::DomainArea(domain), 2.0 - 0.04 - 0.0625);
  ASSERT_EQ(domain.Holes.size(), 2u);
  EXPECT_EQ(source->GetOutput()->GetNumberOfCells(), 3);
  EXPECT_EQ(source->GetOutput()->GetCell(0)->GetNumberOfPoints(), 4) << "the outer loop first";
  EXPECT_EQ(domain.Holes[0][0], (Point2{ 0.2, 0.2 }));
}

TEST(Domain, UnusableFilesAreFailuresOfTheCase)
{
  vtkNew<vtkPEMDomain> source;
  source->SetShapeByName("file");
  const auto failure = [&source](const std::string& path)
  {
    source->SetFileName(path);
    source->Update();
    EXPECT_EQ(pemesh::GetCaseStatus(source->GetOutput()), "invalid-domain");
    EXPECT_EQ(source->GetOutput()->GetNumberOfCells(), 0);
    return pemesh::GetCaseStatusMessage(source->GetOutput());
  };
  EXPECT_THAT(failure(""), HasSubstr("no file was named"));
  EXPECT_THAT(failure("/nowhere/domain.csv"), HasSubstr("/nowhere/domain.csv"));
  EXPECT_THAT(failure(WriteFile("bow.csv", "0,0\n1,1\n1,0\n0,1\n")),
    HasSubstr("bow.csv: The boundary of the domain cannot be used: loop 1 of the domain crosses"));
  EXPECT_THAT(failure(WriteFile("two.csv", "0,0\n1,0\n1,1\n\n2,0\n3,0\n3,1\n")),
    HasSubstr("Hole 1 of the domain lies beside its outer loop"));
}

TEST(Domain, WrongSettingsAreErrors)
{
  vtkNew<vtkPEMDomain> source;
  pemesh::ErrorLog log(source);
  source->SetShapeByName("dics");
  EXPECT_THAT(log.GetText(), HasSubstr("no shape of domains \"dics\"; did you mean \"disc\"?"));
  EXPECT_EQ(source->GetShapeName(), "rectangle");
  log.Clear();
  source->SetParameter("widht", 2.0);
  EXPECT_THAT(log.GetText(), HasSubstr("did you mean \"width\"?"));
  EXPECT_TRUE(std::isnan(source->GetParameter("widht")));
  log.Clear();
  source->SetParameter("width", 0.0);
  EXPECT_THAT(log.GetText(), HasSubstr("width is 0; it must be between"));
  EXPECT_EQ(source->GetParameter("width"), 1.0);
  log.Clear();
  source->SetShapeByName("disc");
  source->SetParameter("sides", 7.5);
  EXPECT_THAT(log.GetText(), HasSubstr("sides is 7.5; it must be an integer between 3"));
  const vtkMTimeType before = source->GetMTime();
  source->SetShapeByName("disc");
  source->SetParameter("sides", 64.0);
  EXPECT_EQ(source->GetMTime(), before) << "nothing has changed";
  std::ostringstream text;
  source->Print(text);
  EXPECT_THAT(text.str(), HasSubstr("sides: 64"));
}

} // namespace
