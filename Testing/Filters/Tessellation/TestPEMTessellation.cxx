// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMTessellation.h"

#include "CaseStatus.h"
#include "ErrorLog.h"
#include "MeshConversion.h"
#include "SampleDomains.h"
#include "TessellationInvariants.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>

namespace pemesh
{

namespace
{

using ::testing::ElementsAre;
using ::testing::HasSubstr;

vtkSmartPointer<vtkPolyData> LoopsOf(const Domain& domain)
{
  PolygonMesh loops;
  const auto add = [&loops](const std::vector<Point2>& loop)
  {
    std::vector<int> vertices;
    for (const Point2& point : loop)
    {
      vertices.push_back(static_cast<int>(loops.Points.size()));
      loops.Points.push_back(point);
    }
    loops.AddElement(vertices);
  };
  add(domain.Outer);
  std::for_each(domain.Holes.begin(), domain.Holes.end(), add);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  SetPolygonMesh(data, loops);
  return data;
}

TEST(PEMTessellation, MakesASensibleMeshByDefault)
{
  vtkNew<vtkPEMTessellation> filter;
  filter->Update();
  vtkPolyData* mesh = filter->GetOutput();
  EXPECT_EQ(GetCaseStatus(mesh), "ok");
  EXPECT_EQ(mesh->GetNumberOfCells(), 100);
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(WhyNotAMeshOf(UnitSquare(), ToPolygonMesh(mesh)), "");
  for (const char* name : { "ElementFamily", "PolygonId" })
  {
    auto* array = vtkIntArray::SafeDownCast(mesh->GetCellData()->GetArray(name));
    ASSERT_TRUE(array);
    EXPECT_EQ(array->GetNumberOfTuples(), 100);
    EXPECT_EQ(array->GetValue(99), -1);
  }
  EXPECT_EQ(GetFieldText(mesh, "Tessellation"), "voronoi");
  EXPECT_EQ(GetFieldNumber(mesh, "cells"), 100.0);
}

TEST(PEMTessellation, TakesADomain)
{
  const Domain domain = SampleDomains()[12].Region;
  vtkNew<vtkPEMTessellation> filter;
  const vtkSmartPointer<vtkPolyData> loops = LoopsOf(domain);
  filter->SetInputData(loops);
  filter->SetKindByName("hexagons");
  filter->Update();
  EXPECT_EQ(WhyNotAMeshOf(domain, ToPolygonMesh(filter->GetOutput())), "");
}

TEST(PEMTessellation, SettersThatChangeNothingLeaveItUpToDate)
{
  vtkNew<vtkPEMTessellation> filter;
  const vtkMTimeType before = filter->GetMTime();
  filter->SetKindByName("voronoi");
  filter->SetParameter("cells", 100);
  filter->SetMaximumNumberOfElements(20000000);
  EXPECT_EQ(filter->GetMTime(), before);
  filter->SetParameter("cells", 50);
  EXPECT_GT(filter->GetMTime(), before);
  EXPECT_EQ(filter->GetParameter("cells"), 50);
  filter->SetKindByName("koch");
  EXPECT_THAT(filter->GetParameterNames(), ElementsAre("squares", "depth", "amplitude"));
  filter->SetKindByName("voronoi");
  EXPECT_EQ(filter->GetParameter("cells"), 50);
}

TEST(PEMTessellation, WrongSettingsAreErrors)
{
  vtkNew<vtkPEMTessellation> filter;
  ErrorLog log(filter);
  filter->SetKindByName("voronoy");
  EXPECT_THAT(log.GetText(), HasSubstr("did you mean \"voronoi\""));
  log.Clear();
  filter->SetParameter("cell", 5);
  EXPECT_THAT(log.GetText(), HasSubstr("did you mean \"cells\""));
  log.Clear();
  filter->SetParameter("cells", 0);
  EXPECT_THAT(log.GetText(), HasSubstr("cells is 0; it must be an integer between 1 and"));
  EXPECT_EQ(filter->GetParameter("cells"), 100);
  log.Clear();
  EXPECT_TRUE(std::isnan(filter->GetParameter("squares")));
  EXPECT_THAT(log.GetText(), HasSubstr("no parameter \"squares\""));
}

TEST(PEMTessellation, CasesFailByName)
{
  vtkNew<vtkPEMTessellation> filter;
  filter->SetMaximumNumberOfElements(99);
  filter->Update();
  EXPECT_EQ(GetCaseStatus(filter->GetOutput()), "too-many-elements");
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  filter->SetMaximumNumberOfElements(1000);

  Domain bowTie = { { { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } }, {} };
  const vtkSmartPointer<vtkPolyData> crossed = LoopsOf(bowTie);
  filter->SetInputData(crossed);
  filter->Update();
  EXPECT_EQ(GetCaseStatus(filter->GetOutput()), "invalid-domain");

  const vtkSmartPointer<vtkPolyData> far = LoopsOf(RectangleDomain(1e13, 1e13, 1e13 + 1, 1e13 + 1));
  filter->SetInputData(far);
  filter->Update();
  EXPECT_EQ(GetCaseStatus(filter->GetOutput()), "tessellation-failed");

  const vtkSmartPointer<vtkPolyData> failed = LoopsOf(UnitSquare());
  SetCaseFailed(failed, "bad-file", "It was bad.");
  filter->SetInputData(failed);
  filter->Update();
  EXPECT_EQ(GetCaseStatus(filter->GetOutput()), "bad-file");
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 1);
}

} // namespace

} // namespace pemesh
