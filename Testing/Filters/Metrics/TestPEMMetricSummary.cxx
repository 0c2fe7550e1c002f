// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMMetricSummary.h"
#include "vtkPEMMetrics.h"

#include "CaseStatus.h"
#include "MetricMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

using namespace pemesh::test;

namespace
{

std::vector<std::string> ColumnNames(vtkTable* table)
{
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    names.emplace_back(table->GetColumnName(i));
  }
  return names;
}

vtkSmartPointer<vtkTable> Summarize(vtkPolyData* mesh, const std::vector<std::string>& metrics)
{
  vtkNew<vtkPEMMetrics> measure;
  measure->SetMetrics(metrics);
  measure->SetInputData(mesh);
  vtkNew<vtkPEMMetricSummary> summary;
  summary->SetMetrics(metrics);
  summary->SetInputConnection(measure->GetOutputPort());
  EXPECT_EQ(summary->GetExecutive()->Update(), 1);
  return summary->GetOutput();
}

double Number(vtkTable* table, const char* column)
{
  vtkAbstractArray* array = table->GetColumnByName(column);
  return array ? array->GetVariantValue(0).ToDouble() : -1e300;
}

std::string Text(vtkTable* table, const char* column)
{
  auto* array = vtkStringArray::SafeDownCast(table->GetColumnByName(column));
  return array ? array->GetValue(0) : "(no such column)";
}

void AddParameters(vtkPolyData* mesh, double t)
{
  pemesh::SetFieldText(mesh, "Mesh", "000_0.5");
  pemesh::SetFieldNumber(mesh, "AttainedMinimumAngle", 21.5);
  pemesh::SetFieldNumber(mesh, "t", t);
  pemesh::AddToFieldList(mesh, pemesh::ParametersList, "t");
}

} // namespace

TEST(vtkPEMMetricSummary, OneRowWithItsColumnsInOrder)
{
  auto mesh = MakeMesh({ { { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 } }, SquareCoordinates(),
    SquareCoordinates(), { { 0, 0 }, { 1, 0 }, { 0, 1 } } });
  AddParameters(mesh, 0.5);
  pemesh::SetFieldNumber(mesh, "vem_condition-number", 1e5);
  pemesh::SetFieldText(mesh, "vem_Status", "ok");
  pemesh::SetFieldText(mesh, "vem_StatusMessage", "");
  pemesh::AddToFieldList(mesh, pemesh::MeasuredList, "vem_solve-seconds");
  const auto table = Summarize(mesh, { "Area", "NumberOfEdges" });
  ASSERT_EQ(table->GetNumberOfRows(), 1);
  const std::vector<std::string> expected = { "Mesh", "t", "Elements", "Vertices", "MeshSize",
    "NumberOfEdges_min", "NumberOfEdges_max", "NumberOfEdges_mean", "NumberOfEdges_min_element",
    "NumberOfEdges_max_element", "Area_min", "Area_max", "Area_mean", "Area_min_element",
    "Area_max_element", "AttainedMinimumAngle", "vem_condition-number", "vem_Status",
    "vem_StatusMessage", "Status", "StatusMessage" };
  EXPECT_EQ(ColumnNames(table), expected);
  EXPECT_EQ(Text(table, "Mesh"), "000_0.5");
  EXPECT_EQ(Number(table, "t"), 0.5);
  EXPECT_EQ(Number(table, "Elements"), 4);
  EXPECT_EQ(Number(table, "Vertices"), 15);
  EXPECT_EQ(Number(table, "MeshSize"), std::sqrt(8.0));
  EXPECT_EQ(Number(table, "Area_min"), 0.5);
  EXPECT_EQ(Number(table, "Area_max"), 4.0);
  EXPECT_EQ(Number(table, "Area_mean"), 6.5 / 4.0);
  EXPECT_EQ(Number(table, "Area_min_element"), 3);
  EXPECT_EQ(Number(table, "Area_max_element"), 0);
  EXPECT_EQ(Number(table, "NumberOfEdges_max_element"), 0) << "of several the first";
  EXPECT_EQ(Text(table, "Status"), "ok");
  EXPECT_EQ(Text(table, "StatusMessage"), "");
  EXPECT_TRUE(pemesh::IsInFieldList(table, pemesh::ParametersList, "t"));
  EXPECT_TRUE(pemesh::IsInFieldList(table, pemesh::MeasuredList, "vem_solve-seconds"));
}

TEST(vtkPEMMetricSummary, UndefinedElementsDoNotCount)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  auto mesh = MakeMesh(std::vector<Coordinates>(4, SquareCoordinates()));
  vtkNew<vtkDoubleArray> area;
  area->SetName("Area");
  for (const double value : { nan, 3.0, 1.0, 1.0 })
  {
    area->InsertNextValue(value);
  }
  mesh->GetCellData()->AddArray(area);
  vtkNew<vtkPEMMetricSummary> summary;
  summary->SetInputData(mesh);
  summary->Update();
  vtkTable* table = summary->GetOutput();
  EXPECT_EQ(Number(table, "Area_min"), 1.0);
  EXPECT_EQ(Number(table, "Area_min_element"), 2);
  EXPECT_EQ(Number(table, "Area_max_element"), 1);
  EXPECT_DOUBLE_EQ(Number(table, "Area_mean"), 5.0 / 3.0);
  EXPECT_TRUE(std::isnan(Number(table, "MinAngle_min"))) << "never measured";
  EXPECT_EQ(Number(table, "MinAngle_min_element"), -1);
}

TEST(vtkPEMMetricSummary, TheMeanOfManyIsExact)
{
  // Plain summation of these loses about eleven digits.
  auto mesh = MakeMesh(std::vector<Coordinates>(1000, SquareCoordinates()));
  vtkNew<vtkDoubleArray> area;
  area->SetName("Area");
  for (int i = 0; i < 1000; ++i)
  {
    area->InsertNextValue(i == 0 ? 1e16 : (i == 999 ? -1e16 : 1.0));
  }
  mesh->GetCellData()->AddArray(area);
  vtkNew<vtkPEMMetricSummary> summary;
  summary->SetInputData(mesh);
  summary->Update();
  EXPECT_EQ(Number(summary->GetOutput(), "Area_mean"), 0.998);
}

TEST(vtkPEMMetricSummary, AFailedMeshHasTheSameColumns)
{
  auto good = MakeMesh({ SquareCoordinates() });
  AddParameters(good, 0.0);
  auto failed = vtkSmartPointer<vtkPolyData>::New();
  AddParameters(failed, 0.9);
  pemesh::SetCaseFailed(failed, "invalid-layout", "Polygons 1 and 2 overlap at t = 0.9.");
  const std::vector<std::string> metrics = { "Area", "KernelArea" };
  const auto row = Summarize(failed, metrics);
  EXPECT_EQ(ColumnNames(row), ColumnNames(Summarize(good, metrics)));
  ASSERT_EQ(row->GetNumberOfRows(), 1);
  EXPECT_EQ(Number(row, "t"), 0.9);
  EXPECT_EQ(Number(row, "Elements"), 0);
  EXPECT_TRUE(std::isnan(Number(row, "MeshSize")));
  EXPECT_TRUE(std::isnan(Number(row, "Area_mean")));
  EXPECT_EQ(Number(row, "Area_max_element"), -1);
  EXPECT_EQ(Text(row, "Status"), "invalid-layout");
  EXPECT_EQ(Text(row, "StatusMessage"), "Polygons 1 and 2 overlap at t = 0.9.");
}

TEST(vtkPEMMetricSummary, KeepsToThePipelineContract)
{
  vtkNew<vtkPEMMetricSummary> summary;
  int errors = 0;
  int executions = 0;
  const auto Count = [](vtkObject* object, unsigned long event, int* counter)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(counter);
    command->SetCallback(
      [](vtkObject*, unsigned long, void* client, void*) { ++*static_cast<int*>(client); });
    object->AddObserver(event, command);
  };
  Count(summary->GetExecutive(), vtkCommand::ErrorEvent, &errors);
  Count(summary, vtkCommand::ErrorEvent, &errors);
  Count(summary, vtkCommand::StartEvent, &executions);
  EXPECT_EQ(summary->GetExecutive()->Update(), 0) << "no input";
  EXPECT_GT(errors, 0);
  errors = 0;
  summary->AddMetric("NoSuchMetric");
  EXPECT_EQ(errors, 1);
  std::ostringstream text;
  summary->Print(text);
  EXPECT_NE(text.str().find("KernelAreaRatio"), std::string::npos);
  executions = 0;
  summary->SetInputData(MakeMesh({ SquareCoordinates() }));
  summary->Update();
  summary->Update();
  EXPECT_EQ(executions, 1);
  EXPECT_EQ(summary->GetOutput()->GetNumberOfRows(), 1);
}
