// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMMetrics.h"
#include "vtkPEMSelectElements.h"

#include "CaseStatus.h"
#include "ElementSelection.h"
#include "MetricMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkPointData.h>

using namespace pemesh::test;

namespace
{

/** A strip of five rectangles of the widths 3, 1, 4, 1, 5, with the numbers of its points. */
vtkSmartPointer<vtkPolyData> Strip()
{
  Coordinates points = { { 0, 0 }, { 0, 1 } };
  std::vector<std::vector<vtkIdType>> polygons;
  double x = 0.0;
  for (const double width : { 3.0, 1.0, 4.0, 1.0, 5.0 })
  {
    x += width;
    points.push_back({ x, 0 });
    points.push_back({ x, 1 });
    const auto last = static_cast<vtkIdType>(points.size());
    polygons.push_back({ last - 4, last - 2, last - 1, last - 3 });
  }
  auto mesh = MakeSharedMesh(points, polygons);
  vtkNew<vtkDoubleArray> number;
  number->SetName("Number");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    number->InsertNextValue(static_cast<double>(i));
  }
  mesh->GetPointData()->AddArray(number);
  vtkNew<vtkPEMMetrics> metrics;
  metrics->SetInputData(mesh);
  metrics->Update();
  return metrics->GetOutput();
}

std::vector<int> Elements(vtkPEMSelectElements* filter, int port = 0)
{
  EXPECT_EQ(filter->GetExecutive()->Update(), 1);
  std::vector<int> ids;
  vtkPolyData* output = filter->GetOutput(port);
  for (vtkIdType i = 0; i < output->GetNumberOfPolys(); ++i)
  {
    ids.push_back(static_cast<int>(CellValue(output, "OriginalElement", i)));
  }
  return ids;
}

int CountErrors(vtkPEMSelectElements* filter)
{
  int errors = 0;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&errors);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* client, void*) { ++*static_cast<int*>(client); });
  filter->AddObserver(vtkCommand::ErrorEvent, command);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, command);
  EXPECT_EQ(filter->GetExecutive()->Update(), 0);
  return errors;
}

} // namespace

TEST(vtkPEMSelectElements, ByRange)
{
  vtkNew<vtkPEMSelectElements> filter;
  filter->SetInputData(Strip());
  filter->SetMetric("Area");
  EXPECT_EQ(Elements(filter), (std::vector<int>{ 0, 1, 2, 3, 4 }));
  filter->SetMinimum(3.0);
  filter->SetMaximum(4.0);
  EXPECT_EQ(Elements(filter), (std::vector<int>{ 0, 2 })) << "the ends are included";
  EXPECT_EQ(Elements(filter, 1), (std::vector<int>{ 1, 3, 4 }));
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetNumberOfPoints(), 8);
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(CellValue(output, "Area", 1), 4.0);
  vtkDataArray* numbers = output->GetPointData()->GetArray("Number");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const auto original =
      static_cast<vtkIdType>(output->GetPointData()->GetArray("OriginalVertex")->GetTuple1(i));
    EXPECT_EQ(numbers->GetTuple1(i), static_cast<double>(original));
    EXPECT_EQ(
      output->GetPoint(i)[0], vtkPolyData::SafeDownCast(filter->GetInput())->GetPoint(original)[0]);
  }
  filter->SetMinimum(100.0);
  EXPECT_TRUE(Elements(filter).empty());
}

TEST(vtkPEMSelectElements, TheExtremeOnes)
{
  vtkNew<vtkPEMSelectElements> filter;
  filter->SetInputData(Strip());
  filter->SetMetric("Area");
  filter->SetCount(2);
  filter->SetMode(vtkPEMSelectElements::Largest);
  EXPECT_EQ(Elements(filter), (std::vector<int>{ 2, 4 }));
  filter->SetMode(vtkPEMSelectElements::Smallest);
  EXPECT_EQ(Elements(filter), (std::vector<int>{ 1, 3 }));
  filter->SetCount(1);
  EXPECT_EQ(Elements(filter), (std::vector<int>{ 1 })) << "of equal ones the first";
  filter->SetMode(vtkPEMSelectElements::Worst);
  filter->SetMetric("CircleRatio"); // up is good: the longest rectangle
  EXPECT_EQ(Elements(filter), (std::vector<int>{ 4 }));
  filter->SetMetric("VEMRatio"); // down is good
  EXPECT_EQ(Elements(filter), (std::vector<int>{ 4 }));
  filter->SetCount(100);
  EXPECT_EQ(Elements(filter).size(), 5U);
}

TEST(vtkPEMSelectElements, BySelectionAsItIsWritten)
{
  vtkNew<vtkPEMSelectElements> filter;
  filter->SetInputData(Strip());
  const std::vector<std::pair<std::string, std::vector<int>>> cases = { { "Area:3:4", { 0, 2 } },
    { "Area::3", { 0, 1, 3 } }, { "Area:4:", { 2, 4 } }, { "Area:1e0:1", { 1, 3 } },
    { "Area::", { 0, 1, 2, 3, 4 } }, { "Area", { 0, 1, 2, 3, 4 } }, { "Area:-inf:2.5", { 1, 3 } } };
  for (const auto& [text, expected] : cases)
  {
    filter->SetSelection(text);
    EXPECT_EQ(Elements(filter), expected) << text;
  }
  for (const char* text : { "Area:4:3", "Area:a:b", "Area:3", ":1:2", "Area:nan:", ":" })
  {
    std::string fault;
    EXPECT_TRUE(pemesh::ParseElementSelection(text, fault).Array.empty()) << text;
    EXPECT_NE(fault.find("\"" + std::string(text) + "\""), std::string::npos) << text;
  }
}

TEST(vtkPEMSelectElements, ExtremesAreAnOutputOfTheirOwn)
{
  vtkNew<vtkPEMSelectElements> filter;
  filter->SetInputData(Strip());
  filter->SetSelection("Area:3:4");
  constexpr int Port = vtkPEMSelectElements::ExtremePort;
  EXPECT_EQ(Elements(filter, Port), (std::vector<int>{ 1, 4 })) << "of equal ones the first";
  EXPECT_EQ(CellValue(filter->GetOutput(Port), "Extreme", 0), -1.0);
  EXPECT_EQ(CellValue(filter->GetOutput(Port), "Extreme", 1), 1.0);
  EXPECT_EQ(CellValue(filter->GetOutput(Port), "Area", 1), 5.0);
  filter->SetMetric("NumberOfEdges"); // all have four
  EXPECT_EQ(Elements(filter, Port), std::vector<int>{ 0 });
  EXPECT_EQ(CellValue(filter->GetOutput(Port), "Extreme", 0), 0.0);
}

TEST(vtkPEMSelectElements, UndefinedIsNeverSelected)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  auto mesh = MakeMesh(std::vector<Coordinates>(3, SquareCoordinates()));
  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  for (const double value : { nan, 2.0, 1.0 })
  {
    values->InsertNextValue(value);
  }
  mesh->GetCellData()->AddArray(values);
  vtkNew<vtkPEMSelectElements> filter;
  filter->SetInputData(mesh);
  filter->SetMetric("Values");
  EXPECT_EQ(Elements(filter), (std::vector<int>{ 1, 2 }));
  EXPECT_EQ(Elements(filter, 1), (std::vector<int>{ 0 }));
  filter->SetMode(vtkPEMSelectElements::Largest);
  EXPECT_EQ(Elements(filter), (std::vector<int>{ 1, 2 }));
}

TEST(vtkPEMSelectElements, WhatCannotBeSelected)
{
  vtkNew<vtkPEMSelectElements> filter;
  filter->SetInputData(Strip());
  filter->SetMode(vtkPEMSelectElements::Worst);
  filter->SetMetric("Area");
  EXPECT_GT(CountErrors(filter), 0) << "no end of Area is good";
  filter->SetMode(vtkPEMSelectElements::Range);
  filter->SetMetric("NoSuchArray");
  EXPECT_EQ(filter->GetExecutive()->Update(), 1);
  EXPECT_EQ(pemesh::GetCaseStatus(filter->GetOutput()), "no-such-array");
  auto failed = Strip();
  pemesh::SetCaseFailed(failed, "invalid-layout", "Polygon 1 crosses polygon 2.");
  filter->SetInputData(failed);
  filter->Update();
  EXPECT_EQ(pemesh::GetCaseStatus(filter->GetOutput()), "invalid-layout");
  std::ostringstream text;
  filter->Print(text);
  EXPECT_NE(text.str().find("NoSuchArray"), std::string::npos);
}
