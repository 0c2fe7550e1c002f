// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMMetricSummary.h"
#include "vtkPEMMetrics.h"

#include "CaseStatus.h"
#include "MeshMetrics.h"
#include "MetricMeshes.h"
#include "ValueStatistics.h"
#include "vtkPEMMeshReader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
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
  const std::vector<std::string> expected = { "Mesh", "t", "Elements", "Vertices", "Edges",
    "Triangles", "Polygons", "MeshSize", "MinAreaRatio", "TotalArea", "BoundaryLength",
    "UndefinedElements", "NumberOfEdges_min", "NumberOfEdges_max", "NumberOfEdges_mean",
    "NumberOfEdges_min_element", "NumberOfEdges_max_element", "Area_min", "Area_max", "Area_mean",
    "Area_min_element", "Area_max_element", "AttainedMinimumAngle", "vem_condition-number",
    "vem_Status", "vem_StatusMessage", "Status", "StatusMessage" };
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

TEST(vtkPEMMetricSummary, NumbersOfTheMesh)
{
  // A square and a triangle on it; a third element has no area.
  const Coordinates points = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { .5, 2 }, { 2, 0 },
    { 3, 0 } };
  const auto mesh = MakeSharedMesh(points, { { 0, 1, 2, 3 }, { 3, 2, 4 }, { 1, 5, 6 } });
  const auto table = Summarize(mesh, { "VEMIndicator" });
  EXPECT_EQ(Number(table, "Elements"), 3);
  EXPECT_EQ(Number(table, "Vertices"), 7);
  EXPECT_EQ(Number(table, "Edges"), 4 + 2 + 3);
  EXPECT_EQ(Number(table, "Triangles"), 2);
  EXPECT_EQ(Number(table, "Polygons"), 1);
  EXPECT_EQ(Number(table, "MeshSize"), std::sqrt(2.0));
  EXPECT_EQ(Number(table, "TotalArea"), 1.5);
  EXPECT_EQ(Number(table, "MinAreaRatio"), 0.5);
  EXPECT_NEAR(Number(table, "BoundaryLength"), 3.0 + 2.0 * std::sqrt(1.25) + 4.0, 1e-14);
  EXPECT_EQ(Number(table, "UndefinedElements"), 1);
  const double square = (std::sqrt(0.5) + 1.75) / 3.0;
  const double triangle = (std::sqrt(0.5) / std::sqrt(1.25) + 2.0) / 3.0;
  EXPECT_NEAR(Number(table, "MeshRho"), std::sqrt((square + triangle) / 2.0), 1e-14);
}

TEST(vtkPEMMetricSummary, ChoosesNumbersOfTheMesh)
{
  vtkNew<vtkPEMMetricSummary> summary;
  summary->SetMetrics({});
  summary->SetInputData(MakeMesh({ SquareCoordinates() }));
  summary->Update();
  EXPECT_EQ(summary->GetOutput()->GetColumnByName("MeshRho"), nullptr) << "not cheap";
  summary->SetMeshMetrics({ "MeshRho", "TotalArea" });
  summary->Update();
  const std::vector<std::string> expected = { "Mesh", "MeshRho", "TotalArea", "Status",
    "StatusMessage" };
  EXPECT_EQ(ColumnNames(summary->GetOutput()), expected);
  EXPECT_NEAR(
    Number(summary->GetOutput(), "MeshRho"), std::sqrt((std::sqrt(0.5) + 1.75) / 3.0), 1e-15);
  summary->SetMeshMetrics({ "usual" });
  summary->SelectAllMetrics();
  EXPECT_EQ(summary->GetMeshMetrics(), pemesh::MeshMetricNames());
}

TEST(vtkPEMMetricSummary, TheQualityOfPublishedMeshes)
{
  // T. Sorgente et al., Adv. Comput. Math. 48 (2022) 3, their data set.
  const std::map<std::string, double> published = { { "Triangle0.off", .91428628 },
    { "Triangle1.off", .9184023 }, { "Triangle2.off", .91975263 }, { "Triangle3.off", .92010596 },
    { "Maze0.obj", .91077731 }, { "Jenga0.off", .84652647 }, { "Jenga1.off", .78894889 },
    { "Jenga2.off", .75421299 }, { "Jenga3.off", .7405337 }, { "Slices0.off", .68370777 },
    { "Slices1.off", .55670336 }, { "Slices2.off", .48133657 }, { "Slices3.off", .43026395 } };
  vtkNew<vtkPEMMeshReader> reader;
  vtkNew<vtkPEMMetricSummary> summary;
  summary->SetMetrics({});
  summary->SetMeshMetrics({ "MeshRho", "TotalArea", "BoundaryLength" });
  summary->SetInputConnection(reader->GetOutputPort());
  for (const auto& [name, rho] : published)
  {
    reader->SetFileNames({ std::string(PEMESH_TEST_DATA) + "/Meshes/vem_quality_2d/" + name });
    summary->Update();
    EXPECT_NEAR(Number(summary->GetOutput(), "MeshRho"), rho, 5e-9) << name;
    EXPECT_NEAR(Number(summary->GetOutput(), "TotalArea"), 1.0, 1e-12) << name;
    EXPECT_NEAR(Number(summary->GetOutput(), "BoundaryLength"), 4.0, 1e-12) << name;
  }
}

namespace
{

/** Squares of the sizes 1, 2, 3, 4 and a triangle, of which two are placed. */
vtkSmartPointer<vtkPolyData> MeshOfGroups()
{
  std::vector<Coordinates> polygons;
  for (const double size : { 1.0, 2.0, 3.0, 4.0 })
  {
    polygons.push_back({ { 0, 0 }, { size, 0 }, { size, size }, { 0, size } });
  }
  polygons.push_back({ { 0, 0 }, { 1, 0 }, { 0, 1 } });
  auto mesh = MakeMesh(polygons);
  vtkNew<vtkIntArray> ids;
  ids->SetName("PolygonId");
  vtkNew<vtkIntArray> mask;
  mask->SetName("Mine");
  for (const int id : { -1, 0, 1, -1, -1 })
  {
    ids->InsertNextValue(id);
    mask->InsertNextValue(id == -1 ? 0 : 7);
  }
  mesh->GetCellData()->AddArray(ids);
  mesh->GetCellData()->AddArray(mask);
  return mesh;
}

} // namespace

TEST(vtkPEMMetricSummary, StatisticsOfGroups)
{
  vtkNew<vtkPEMMetrics> measure;
  measure->SetInputData(MeshOfGroups());
  vtkNew<vtkPEMMetricSummary> summary;
  summary->SetInputConnection(measure->GetOutputPort());
  summary->SetMetrics({ "ShortestEdge" });
  summary->SetGroups({ "all", "triangles", "polygons", "placed", "filler", "selected" });
  summary->SetStatistics({ "mean", "standard-deviation", "area-mean", "undefined", "max" });
  summary->SetSelection("Mine");
  summary->Update();
  vtkTable* table = summary->GetOutput();
  EXPECT_EQ(Number(table, "ShortestEdge_mean"), 2.2);
  EXPECT_DOUBLE_EQ(
    Number(table, "ShortestEdge_deviation"), std::sqrt((1 + 4 + 9 + 16 + 1) / 5.0 - 2.2 * 2.2));
  EXPECT_DOUBLE_EQ(Number(table, "ShortestEdge_area_mean"), (1 + 8 + 27 + 64 + 0.5) / 30.5);
  EXPECT_EQ(Number(table, "ShortestEdge_undefined"), 0);
  EXPECT_EQ(Number(table, "ShortestEdge_mean_triangles"), 1.0);
  EXPECT_EQ(Number(table, "ShortestEdge_mean_polygons"), 2.5);
  EXPECT_DOUBLE_EQ(Number(table, "ShortestEdge_deviation_polygons"), std::sqrt(1.25));
  EXPECT_EQ(Number(table, "ShortestEdge_mean_placed"), 2.5);
  EXPECT_DOUBLE_EQ(Number(table, "ShortestEdge_area_mean_placed"), (8 + 27) / 13.0);
  EXPECT_EQ(Number(table, "ShortestEdge_mean_filler"), 2.0);
  EXPECT_EQ(Number(table, "ShortestEdge_max_element_placed"), 2);
  EXPECT_EQ(Number(table, "ShortestEdge_max_element_filler"), 3);
  EXPECT_EQ(Number(table, "ShortestEdge_mean_selected"), 2.5);
  EXPECT_EQ(table->GetColumnByName("ShortestEdge_min"), nullptr);
  EXPECT_EQ(table->GetValueByName(0, "Status").ToString(), "ok");
  summary->SetSelection("ShortestEdge:2:3");
  summary->Update();
  EXPECT_EQ(Number(summary->GetOutput(), "ShortestEdge_mean_selected"), 2.5);
  summary->SetSelection("NumberOfEdges::3.5"); // of a metric that is not asked for
  summary->Update();
  EXPECT_EQ(Number(summary->GetOutput(), "ShortestEdge_mean_selected"), 1.0);
  summary->SetSelection("AreaJump:0:1"); // no neighbours: undefined, never selected
  summary->Update();
  EXPECT_TRUE(std::isnan(Number(summary->GetOutput(), "ShortestEdge_mean_selected")));
  EXPECT_EQ(summary->GetOutput()->GetValueByName(0, "Status").ToString(), "ok");
  summary->SetSelection("PolygonId:0:0");
  summary->Update();
  EXPECT_EQ(Number(summary->GetOutput(), "ShortestEdge_mean_selected"), 2.0);
  summary->SetSelection("no such array");
  summary->Update();
  EXPECT_TRUE(std::isnan(Number(summary->GetOutput(), "ShortestEdge_mean_selected")));
  EXPECT_EQ(Number(summary->GetOutput(), "ShortestEdge_max_element_selected"), -1);
  EXPECT_EQ(summary->GetOutput()->GetValueByName(0, "Status").ToString(), "no-such-array");
}

TEST(vtkPEMMetricSummary, QuantilesAndHistogram)
{
  vtkNew<vtkPEMMetrics> measure;
  measure->SetInputData(MeshOfGroups());
  vtkNew<vtkPEMMetricSummary> summary;
  summary->SetInputConnection(measure->GetOutputPort());
  summary->SetMetrics({ "ShortestEdge" }); // 1 1 2 3 4
  summary->SetQuantiles({ 0.0, 0.05, 0.5, 0.875, 1.0 });
  summary->SetHistogramBins(3);
  summary->SetGroups({ "all", "placed" });
  summary->Update();
  vtkTable* table = summary->GetOutput();
  EXPECT_EQ(Number(table, "ShortestEdge_q0"), 1.0);
  EXPECT_EQ(Number(table, "ShortestEdge_q0.05"), 1.0);
  EXPECT_EQ(Number(table, "ShortestEdge_q0.5"), 2.0);
  EXPECT_EQ(Number(table, "ShortestEdge_q0.875"), 3.5);
  EXPECT_EQ(Number(table, "ShortestEdge_q1"), 4.0);
  EXPECT_EQ(Number(table, "ShortestEdge_q0.5_placed"), 2.5);
  EXPECT_EQ(Number(table, "ShortestEdge_bin1"), 2);
  EXPECT_EQ(Number(table, "ShortestEdge_bin2"), 1);
  EXPECT_EQ(Number(table, "ShortestEdge_bin3"), 2) << "the largest is in the last part";
  EXPECT_EQ(Number(table, "ShortestEdge_bin2_placed"), 0);
}

TEST(ValueStatistics, OfNoneAndOfEqualValues)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const pemesh::ValueSummary none =
    pemesh::SummarizeValues(std::vector<double>{ nan, nan }, {}, {}, true);
  EXPECT_EQ(none.Count, 0);
  EXPECT_EQ(none.Undefined, 2);
  EXPECT_EQ(none.MinimumElement, -1);
  EXPECT_TRUE(std::isnan(none.StandardDeviation));
  EXPECT_TRUE(std::isnan(pemesh::Quantile({}, 0.5)));
  const std::vector<double> equal(5, 1e300);
  EXPECT_EQ(pemesh::SummarizeValues(equal, {}, {}, true).StandardDeviation, 0.0);
  EXPECT_EQ(pemesh::Histogram(equal, 2), (std::vector<vtkIdType>{ 0, 5 }));
  EXPECT_EQ(pemesh::Quantile(equal, 0.3), 1e300);
  // Far from zero, where squares of values would cancel.
  const std::vector<double> far = { 1e9 + 1.0, 1e9 + 2.0, 1e9 + 3.0 };
  EXPECT_DOUBLE_EQ(
    pemesh::SummarizeValues(far, {}, {}, true).StandardDeviation, std::sqrt(2.0 / 3.0));
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
  summary->SetStatistics({ "median" });
  summary->SetGroups({ "all", "squares" });
  summary->SetMeshMetrics({ "Area" });
  summary->SetQuantiles({ 0.5, 1.5 });
  EXPECT_EQ(errors, 5);
  EXPECT_EQ(summary->GetGroups(), std::vector<std::string>{ "all" }) << "nothing changed";
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

/** An array of another length than the polygons is none, whatever its name. */
TEST(vtkPEMMetricSummary, ArraysOfAnotherLengthAreNone)
{
  for (const char* name : { "Region", "Area" })
  {
    auto mesh = MakeMesh({ SquareCoordinates(), SquareCoordinates() });
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell({ 0, 1 });
    mesh->SetLines(lines);
    vtkNew<vtkDoubleArray> values;
    values->SetName(name);
    values->SetNumberOfValues(3);
    values->Fill(1.0);
    mesh->GetCellData()->AddArray(values);
    vtkNew<vtkPEMMetricSummary> summary;
    summary->SetMetrics({ "MinAngle" });
    summary->SetSelection(name);
    summary->SetInputData(mesh);
    summary->Update();
    EXPECT_EQ(summary->GetOutput()->GetNumberOfRows(), 1);
  }
}

TEST(vtkPEMMetricSummary, ARepeatedVertexMakesNoPolygonOfATriangle)
{
  vtkNew<vtkPEMMetricSummary> summary;
  summary->SetMetrics({ "Area" });
  summary->SetMeshMetrics({ "Triangles", "Polygons" });
  summary->SetInputData(MakeSharedMesh({ { 0, 0 }, { 1, 0 }, { 0, 1 } }, { { 0, 1, 1, 2 } }));
  summary->Update();
  vtkTable* table = summary->GetOutput();
  EXPECT_EQ(table->GetValueByName(0, "Triangles").ToInt(), 1);
  EXPECT_EQ(table->GetValueByName(0, "Polygons").ToInt(), 0);
}
