// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PooledTable.h"

#include "ColumnRoles.h"
#include "TestTables.h"
#include "vtkPEMCorrelation.h"
#include "vtkPEMJoinedTable.h"
#include "vtkPEMPooledTable.h"

#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkIdTypeArray.h>
#include <vtkTestErrorObserver.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace
{

using testing::HasSubstr;
using Strings = std::vector<std::string>;

vtkSmartPointer<vtkTable> Results(const Strings& meshes, const std::vector<double>& values)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  AddColumn<vtkStringArray>(table, "Mesh", meshes);
  AddColumn<vtkDoubleArray>(table, "Area_min", values);
  return table;
}

std::string Complaint(vtkTable* table, vtkTable* performances)
{
  try
  {
    pemesh::JoinPerformances(table, performances, "mine.csv");
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return {};
}

TEST(PooledTable, StudiesAreToldApart)
{
  auto second = Results({ "a", "c" }, { 3, 4 });
  AddColumn<vtkDoubleArray>(second, "vem_error", { 5, 6 });
  const auto pooled = pemesh::PoolStudies({ { "comb", Results({ "a", "b" }, { 1, 2 }) },
    { "star", second }, { "comb", Results({ "a" }, { 7 }) } });
  EXPECT_EQ(ColumnNames(pooled), (Strings{ "Study", "Mesh", "Area_min", "vem_error" }));
  EXPECT_EQ(
    pemesh::ColumnTexts(pooled, "Study"), (Strings{ "comb", "comb", "star", "star", "comb-2" }));
  EXPECT_TRUE(std::isnan(pemesh::ColumnNumbers(pooled, "vem_error")[0]));
  EXPECT_EQ(pemesh::ColumnNumbers(pooled, "vem_error")[3], 6.0);
  const auto alone = pemesh::PoolStudies({ { "comb", Results({ "a" }, { 1 }) } });
  EXPECT_EQ(ColumnNames(alone), (Strings{ "Mesh", "Area_min" }));
}

TEST(PooledTable, PerformancesAreJoinedByMeshName)
{
  const auto table = Results({ "a", "b", "c" }, { 1, 2, 3 });
  vtkNew<vtkTable> mine;
  AddColumn<vtkStringArray>(mine, "Mesh", { "c", "a" });
  AddColumn<vtkIdTypeArray>(mine, "iterations", { 30, 10 });
  AddColumn<vtkStringArray>(mine, "remark", { "x", "y" });
  pemesh::JoinPerformances(table, mine, "mine.csv");
  const std::vector<double> iterations = pemesh::ColumnNumbers(table, "iterations");
  EXPECT_EQ(iterations[0], 10.0);
  EXPECT_TRUE(std::isnan(iterations[1]));
  EXPECT_EQ(iterations[2], 30.0);
  EXPECT_EQ(pemesh::ColumnTexts(table, "remark"), (Strings{ "y", "", "x" }));
  EXPECT_EQ(pemesh::PerformanceColumns(table), (Strings{ "iterations" }));
}

TEST(PooledTable, JoiningFailsInASentence)
{
  const auto table = Results({ "mesh-a", "mesh-b" }, { 1, 2 });
  vtkNew<vtkTable> unknown;
  AddColumn<vtkStringArray>(unknown, "Mesh", { "mesh_a" });
  AddColumn<vtkDoubleArray>(unknown, "e", { 1 });
  EXPECT_EQ(Complaint(table, unknown),
    "\"mine.csv\" names the mesh \"mesh_a\", which the results have not; the nearest is "
    "\"mesh-a\".");
  vtkNew<vtkTable> twice;
  AddColumn<vtkStringArray>(twice, "Mesh", { "mesh-a", "mesh-a" });
  AddColumn<vtkDoubleArray>(twice, "e", { 1, 2 });
  EXPECT_THAT(Complaint(table, twice), HasSubstr("\"mesh-a\" twice"));
  vtkNew<vtkTable> nameless;
  AddColumn<vtkDoubleArray>(nameless, "e", { 1 });
  EXPECT_THAT(Complaint(table, nameless), HasSubstr("\"mine.csv\" has no column \"Mesh\""));
  EXPECT_THAT(Complaint(table, Results({ "mesh-a" }, { 1 })), HasSubstr("\"Area_min\", which"));
  vtkNew<vtkTable> empty;
  AddColumn<vtkStringArray>(empty, "Mesh", { "mesh-a" });
  EXPECT_THAT(Complaint(table, empty), HasSubstr("nothing to join"));
  EXPECT_EQ(ColumnNames(table), (Strings{ "Mesh", "Area_min" })) << "a failed join changes nothing";
}

TEST(PooledTable, MeshesOfSeveralStudiesNeedTheStudy)
{
  const auto pooled = pemesh::PoolStudies(
    { { "comb", Results({ "a" }, { 1 }) }, { "star", Results({ "a" }, { 2 }) } });
  vtkNew<vtkTable> mine;
  AddColumn<vtkStringArray>(mine, "Mesh", { "a" });
  AddColumn<vtkDoubleArray>(mine, "e", { 5 });
  EXPECT_THAT(Complaint(pooled, mine), HasSubstr("add a column \"Study\""));
  AddColumn<vtkStringArray>(mine, "Study", { "star" });
  EXPECT_EQ(Complaint(pooled, mine), "");
  EXPECT_EQ(pemesh::ColumnNumbers(pooled, "e")[1], 5.0);
}

/** In a pipeline: pooled, joined, correlated with the studies as families. */
TEST(PooledTable, PoolingAndJoiningAreFilters)
{
  vtkNew<vtkPEMPooledTable> pooled;
  pooled->AddInputDataObject(0, Results({ "a", "b" }, { 1, 2 }));
  pooled->AddInputDataObject(0, Results({ "a", "b" }, { 5, 3 }));
  pooled->SetStudyNames({ "comb", "star" });
  vtkNew<vtkTable> mine;
  AddColumn<vtkStringArray>(mine, "Study", { "star", "star", "comb", "comb" });
  AddColumn<vtkStringArray>(mine, "Mesh", { "b", "a", "b", "a" });
  AddColumn<vtkDoubleArray>(mine, "iterations", { 30, 50, 20, 10 });
  vtkNew<vtkPEMJoinedTable> joined;
  joined->SetInputConnection(0, pooled->GetOutputPort());
  joined->SetInputData(1, mine);
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputConnection(joined->GetOutputPort());
  correlation->Update();
  EXPECT_EQ(
    pemesh::ColumnTexts(joined->GetOutput(), "Study"), (Strings{ "comb", "comb", "star", "star" }));
  EXPECT_EQ(ColumnNames(pooled->GetOutput()), (Strings{ "Study", "Mesh", "Area_min" }))
    << "joining leaves its input as it was";
  vtkTable* pairs = correlation->GetOutput();
  ASSERT_EQ(pairs->GetNumberOfRows(), 1);
  EXPECT_EQ(pairs->GetValueByName(0, "Pearson").ToDouble(), 1.0);
  EXPECT_EQ(pairs->GetValueByName(0, "Families").ToInt(), 2);

  vtkNew<vtkTest::ErrorObserver> errors;
  for (vtkAlgorithm* filter :
    { static_cast<vtkAlgorithm*>(pooled), static_cast<vtkAlgorithm*>(joined) })
  {
    filter->AddObserver(vtkCommand::ErrorEvent, errors);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  }
  joined->SetSourceName("mine.csv");
  joined->SetInputData(1, Results({ "c" }, { 1 }));
  EXPECT_EQ(joined->GetExecutive()->Update(), 0);
  EXPECT_THAT(errors->GetErrorMessage(), HasSubstr("\"mine.csv\""));
  errors->Clear();
  pooled->AddStudyName("third");
  EXPECT_EQ(pooled->GetExecutive()->Update(), 0);
  EXPECT_THAT(errors->GetErrorMessage(), HasSubstr("3 names of studies for 2 tables"));
}

TEST(ColumnRoles, AreToldByTheName)
{
  for (const char* metric :
    { "Area_min", "Area_mean_placed", "Area_q0.25", "Area_deviation_selected", "Area_area_mean" })
  {
    EXPECT_TRUE(pemesh::IsMetricColumn(metric)) << metric;
  }
  vtkNew<vtkTable> table;
  for (const char* neither : { "Area_min_element", "Area_bin3", "Elements", "_x", "x_" })
  {
    EXPECT_FALSE(pemesh::IsMetricColumn(neither)) << neither;
    EXPECT_FALSE(pemesh::IsPerformanceColumn(table, neither)) << neither;
  }
  EXPECT_TRUE(pemesh::IsPerformanceColumn(table, "pemesh-vem_condition-number"));
}

} // namespace
