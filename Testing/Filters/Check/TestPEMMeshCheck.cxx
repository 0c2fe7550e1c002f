// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMMeshCheck.h"

#include "CaseStatus.h"
#include "ErrorLog.h"
#include "MeshFormats.h"
#include "ParallelLoop.h"
#include "TestMeshes.h"

#include <algorithm>
#include <limits>
#include <sstream>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace pemesh;
using testing::HasSubstr;

namespace
{

vtkTable* TableOf(vtkPEMMeshCheck* check)
{
  return vtkTable::SafeDownCast(check->GetOutputDataObject(2));
}

std::string Text(vtkPEMMeshCheck* check, vtkIdType row, const char* column)
{
  return TableOf(check)->GetValueByName(row, column).ToString();
}

/** The house with its square clockwise, a copy of a vertex, an unused point, and arrays. */
vtkSmartPointer<vtkPolyData> MakeBrokenHouse()
{
  auto mesh = MakeTestMesh(
    { { 9, 9 }, { 0, 0 }, { 0.5, 0 }, { 0.5, 1 }, { 0, 1 }, { 1, 0 }, { 1, 1 }, { 0.5, 1 } },
    { { 1, 4, 3, 2 }, { 2, 5, 3 }, { 5, 6, 7 } });
  vtkNew<vtkDoubleArray> number;
  number->SetName("Number");
  for (int i = 0; i < 8; ++i)
  {
    number->InsertNextValue(i);
  }
  mesh->GetPointData()->AddArray(number);
  vtkNew<vtkIntArray> family;
  family->SetName("Family");
  for (const int value : { 5, 6, 7 })
  {
    family->InsertNextValue(value);
  }
  mesh->GetCellData()->AddArray(family);
  SetFieldText(mesh, MeshNameField, "house");
  return mesh;
}

} // namespace

TEST(PEMMeshCheck, PassesAGoodMeshOn)
{
  vtkNew<vtkPEMMeshCheck> check;
  check->SetInputData(MakeHouse());
  check->RepairOn();
  check->Update();
  ExpectSameMesh(check->GetOutput(), MakeHouse());
  EXPECT_EQ(check->GetNumberOfErrors() + check->GetNumberOfWarnings(), 0);
  EXPECT_EQ(check->GetNumberOfRepairs(), 0);
  EXPECT_EQ(check->GetNumberOfComponents(), 1);
  EXPECT_EQ(check->GetNumberOfHoles(), 0);
  EXPECT_EQ(check->GetOutput()->GetCellData()->GetArray("Faults")->GetRange()[1], 0.0);
  EXPECT_EQ(vtkPolyData::SafeDownCast(check->GetOutputDataObject(1))->GetNumberOfCells(), 0);
  EXPECT_EQ(TableOf(check)->GetNumberOfRows(), 0);
  EXPECT_EQ(TableOf(check)->GetNumberOfColumns(), 7);
}

TEST(PEMMeshCheck, SaysWhatAndWhere)
{
  const auto mesh = MakeBrokenHouse();
  vtkNew<vtkPEMMeshCheck> check;
  check->SetInputData(mesh);
  check->Update();
  EXPECT_EQ(PolygonsOf(check->GetOutput()), PolygonsOf(mesh)) << "nothing is repaired unasked";
  EXPECT_EQ(check->GetNumberOfErrors(), 2);
  EXPECT_EQ(check->GetNumberOfWarnings(), 1);
  EXPECT_EQ(check->GetNumberOfFindings("orientation"), 1);
  EXPECT_EQ(check->GetNumberOfFindings("simple"), 0);
  ASSERT_EQ(TableOf(check)->GetNumberOfRows(), 3);
  EXPECT_EQ(Text(check, 0, "Check"), "orientation");
  EXPECT_EQ(Text(check, 0, "Severity"), "error");
  EXPECT_EQ(Text(check, 0, "Element"), "0");
  EXPECT_EQ(Text(check, 0, "Vertex"), "-1");
  EXPECT_EQ(Text(check, 0, "x"), "0.25");
  EXPECT_EQ(Text(check, 0, "y"), "0.5");
  EXPECT_EQ(Text(check, 2, "Severity"), "warning");
  EXPECT_EQ(Text(check, 2, "Vertex"), "0");
  auto* faults = vtkIntArray::SafeDownCast(check->GetOutput()->GetCellData()->GetArray("Faults"));
  EXPECT_EQ(faults->GetValue(0), 1);
  EXPECT_EQ(faults->GetValue(1), 0);
  EXPECT_EQ(faults->GetValue(2), 1);
  auto* cells = vtkPolyData::SafeDownCast(check->GetOutputDataObject(1));
  ASSERT_EQ(cells->GetNumberOfCells(), 2);
  auto* names = vtkStringArray::SafeDownCast(cells->GetCellData()->GetAbstractArray("Check"));
  EXPECT_EQ(names->GetValue(0), "orientation");
  EXPECT_EQ(names->GetValue(1), "duplicate-vertices");
  EXPECT_EQ(cells->GetCellData()->GetArray("Element")->GetTuple1(1), 2.0);
}

TEST(PEMMeshCheck, RepairsAndCarriesArraysAlong)
{
  vtkNew<vtkPEMMeshCheck> check;
  check->SetInputData(MakeBrokenHouse());
  check->RepairOn();
  check->Update();
  ExpectSameMesh(check->GetOutput(), MakeHouse());
  EXPECT_EQ(check->GetNumberOfErrors() + check->GetNumberOfWarnings(), 0);
  EXPECT_EQ(check->GetNumberOfRepairs(), 3);
  EXPECT_EQ(check->GetNumberOfRepairs("unused-points"), 1);
  EXPECT_EQ(Text(check, 0, "Severity"), "repaired");
  vtkDataArray* number = check->GetOutput()->GetPointData()->GetArray("Number");
  ASSERT_TRUE(number && number->GetNumberOfTuples() == 6);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(number->GetTuple1(i), i + 1);
  }
  EXPECT_EQ(check->GetOutput()->GetCellData()->GetArray("Family")->GetTuple1(2), 7.0);
  EXPECT_EQ(GetFieldText(check->GetOutput(), MeshNameField), "house");
}

TEST(PEMMeshCheck, WhatCannotBeRepairedIsSaid)
{
  auto mesh =
    MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 5, 5 } }, { { 0, 2, 1, 3 } });
  vtkNew<vtkPEMMeshCheck> check;
  check->SetInputData(mesh);
  check->RepairOn();
  check->Update();
  ASSERT_EQ(TableOf(check)->GetNumberOfRows(), 2);
  EXPECT_EQ(Text(check, 0, "Severity"), "repaired");
  EXPECT_EQ(Text(check, 1, "Check"), "simple");
  EXPECT_EQ(check->GetNumberOfErrors(), 1);
}

TEST(PEMMeshCheck, ChecksAreChosenByName)
{
  vtkNew<vtkPEMMeshCheck> check;
  ErrorLog log(check);
  check->SetInputData(MakeBrokenHouse());
  check->SetChecks({ "unused-points", "orientation", "orientation" });
  EXPECT_EQ(check->GetChecks(), (std::vector<std::string>{ "orientation", "unused-points" }));
  check->SetChecks({ "orientaton" });
  EXPECT_THAT(log.GetText(), HasSubstr("\"orientation\""));
  EXPECT_EQ(check->GetChecks().size(), 2U) << "unchanged";
  check->Update();
  EXPECT_EQ(TableOf(check)->GetNumberOfRows(), 2);
  EXPECT_EQ(check->GetNumberOfComponents(), -1);
  check->SetChecks({});
  check->Update();
  EXPECT_EQ(TableOf(check)->GetNumberOfRows(), 0) << "none is none";
  check->SelectAllChecks();
  EXPECT_EQ(check->GetChecks(), vtkPEMMeshCheck::GetAvailableChecks());
  EXPECT_EQ(check->GetChecks().size(), 17U);
}

TEST(PEMMeshCheck, ComparesWithADomain)
{
  vtkNew<vtkPEMMeshCheck> check;
  ErrorLog log(check);
  check->SetInputData(0, MakeHouse());
  check->SetInputData(
    1, MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, { { 0, 1, 2, 3 } }));
  check->Update();
  EXPECT_EQ(check->GetNumberOfErrors(), 0);
  check->SetInputData(
    1, MakeTestMesh({ { 0, 0 }, { 2, 0 }, { 2, 1 }, { 0, 1 } }, { { 0, 1, 2, 3 } }));
  check->Update();
  EXPECT_EQ(check->GetNumberOfFindings("coverage"), 1);
  EXPECT_THAT(Text(check, 0, "Message"), HasSubstr("add up to 1"));
  check->SetInputData(
    1, MakeTestMesh({ { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } }, { { 0, 1, 2, 3 } }));
  check->Update();
  EXPECT_THAT(log.GetText(), HasSubstr("loop 1 of the domain"));
}

TEST(PEMMeshCheck, BrokenInputIsNoFailure)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto mesh = MakeTestMesh({ { 0, 0 }, { 1, 0 }, { nan, 1 }, { 0, 1 } },
    { { 0, 1, 2 }, { 0, 1, 123456789012345 }, { 0, -5, 1 }, { 0 }, {}, { 0, 1, 3 } });
  vtkNew<vtkPEMMeshCheck> check;
  check->SetInputData(mesh);
  check->Update();
  EXPECT_FALSE(IsCaseFailed(check->GetOutput()));
  EXPECT_EQ(check->GetNumberOfFindings("finite"), 1);
  EXPECT_EQ(check->GetNumberOfFindings("vertex-numbers"), 2);
  EXPECT_EQ(check->GetNumberOfFindings("degenerate"), 2);
  EXPECT_EQ(check->GetNumberOfErrors(), 5);
  auto* cells = vtkPolyData::SafeDownCast(check->GetOutputDataObject(1));
  EXPECT_EQ(cells->GetNumberOfCells(), 5);
  EXPECT_EQ(cells->GetNumberOfPoints(), 2) << "vertices that cannot be used are left out";
}

TEST(PEMMeshCheck, FailedAndEmptyMeshesArePassedOn)
{
  auto failed = MakeHouse();
  SetCaseFailed(failed, "invalid-layout", "Polygon 1 leaves the domain.");
  vtkNew<vtkPEMMeshCheck> check;
  check->SetInputData(failed);
  check->Update();
  EXPECT_EQ(GetCaseStatus(check->GetOutput()), "invalid-layout");
  EXPECT_EQ(check->GetOutput()->GetCellData()->GetArray("Faults"), nullptr);
  vtkNew<vtkPolyData> empty;
  check->SetInputData(empty);
  check->Update();
  EXPECT_EQ(GetCaseStatus(check->GetOutput()), "unusable-mesh");
  EXPECT_THAT(GetCaseStatusMessage(check->GetOutput()), HasSubstr("no polygons"));
}

TEST(PEMMeshCheck, OptionsAreClampedAndPrinted)
{
  vtkNew<vtkPEMMeshCheck> check;
  ErrorLog log(check);
  EXPECT_EQ(check->GetSliverThickness(), 1e-6);
  EXPECT_EQ(check->GetTolerance(), 1e-12);
  EXPECT_EQ(check->GetAreaTolerance(), 1e-9);
  EXPECT_EQ(check->GetMaximumNumberOfExamples(), 100);
  EXPECT_FALSE(check->GetRepair());
  check->SetTolerance(-1.0);
  EXPECT_EQ(check->GetTolerance(), 0.0);
  std::ostringstream text;
  check->Print(text);
  EXPECT_THAT(text.str(), HasSubstr("t-junctions"));
  check->SetInputData(MakeHouse());
  check->SetTolerance(std::numeric_limits<double>::quiet_NaN());
  check->Update();
  EXPECT_THAT(log.GetText(), HasSubstr("numbers from 0 to 1"));
}

TEST(PEMMeshCheck, SameTableForAnyNumberOfThreads)
{
  const auto mesh = MakeJitteredGrid(40, 3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); i += 7)
  {
    double point[3];
    mesh->GetPoint(i, point);
    mesh->GetPoints()->SetPoint(i, point[0] + 0.04, point[1], 0.0); // overlaps here and there
  }
  std::vector<std::string> texts;
  for (const int threads : { 4, 2, 1 })
  {
    SetNumberOfThreads(threads);
    vtkNew<vtkPEMMeshCheck> check;
    check->SetInputData(mesh);
    check->Update();
    EXPECT_GT(check->GetNumberOfFindings("overlaps"), 10);
    texts.emplace_back();
    for (vtkIdType row = 0; row < TableOf(check)->GetNumberOfRows(); ++row)
    {
      texts.back() += Text(check, row, "Message") + Text(check, row, "x") + "\n";
    }
  }
  SetNumberOfThreads(0);
  EXPECT_EQ(texts[0], texts[1]);
  EXPECT_EQ(texts[0], texts[2]);
}

TEST(PEMMeshCheck, SeesTheOrientationOfAFileIfItIsReadAsStored)
{
  const std::filesystem::path folder = TestFolder();
  for (const char* name : { "mesh.off", "mesh.obj", "mesh.node", "mesh.vtp" })
  {
    auto mesh =
      MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, { { 0, 1, 2 }, { 0, 3, 2 } });
    WriteMesh(folder / name, mesh);
    vtkNew<vtkPEMMeshCheck> check;
    check->SetInputData(ReadMesh(folder / name, ElementOrientation::AsStored));
    check->Update();
    EXPECT_EQ(check->GetNumberOfFindings("orientation"), 1) << name;
    EXPECT_EQ(check->GetNumberOfErrors(), 1) << name;
    check->SetInputData(ReadMesh(folder / name));
    check->Update();
    EXPECT_EQ(check->GetNumberOfErrors(), 0) << name;
  }
}
