// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Convergence.h"
#include "ErrorLog.h"
#include "vtkPEMConvergence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <cmath>
#include <limits>

namespace
{

using pemesh::ConvergenceTable;
using testing::HasSubstr;

const double NaN = std::numeric_limits<double>::quiet_NaN();

TEST(Convergence, APowerHasItsExponentForOrder)
{
  // Not in order, and one mesh without a size.
  const std::vector<double> sizes = { 0.5, 0.125, 0.25, NaN };
  std::vector<double> cubes;
  for (const double size : sizes)
  {
    cubes.push_back(7.0 * std::pow(size, 3.0));
  }
  const ConvergenceTable table = pemesh::MakeConvergenceTable("h", sizes, { { "e", cubes } });
  EXPECT_EQ(table.Sizes, (std::vector<double>{ 0.5, 0.25, 0.125 }));
  const auto& column = table.Columns.at(0);
  EXPECT_TRUE(std::isnan(column.Orders[0]));
  EXPECT_NEAR(column.Orders[1], 3.0, 1.0e-13);
  EXPECT_NEAR(column.Orders[2], 3.0, 1.0e-13);
  EXPECT_NEAR(column.Order, 3.0, 1.0e-13);
  EXPECT_NEAR(column.StandardError, 0.0, 1.0e-13);
}

// The logarithms to base 2 are (0, 0), (-1, -1), (-2, -4): the line of least squares has the slope
// 2 and the residuals 1/3, -2/3, 1/3, so that the variance of the slope is (6/9) / 1 / 2 = 1/3.
TEST(Convergence, TheFitIsThatOfLeastSquares)
{
  const ConvergenceTable table = pemesh::MakeConvergenceTable(
    "h", std::vector{ 1.0, 0.5, 0.25 }, { { "e", { 1.0, 0.5, 0.0625 } } });
  EXPECT_NEAR(table.Columns[0].Order, 2.0, 1.0e-13);
  EXPECT_NEAR(table.Columns[0].StandardError, std::sqrt(1.0 / 3.0), 1.0e-13);
}

TEST(Convergence, WhatHasNoLogarithmHasNoOrder)
{
  const ConvergenceTable table =
    pemesh::MakeConvergenceTable("h", std::vector{ 1.0, 0.5, 0.25, 0.25 },
      { { "e", { 4.0, 0.0, 0.25, 0.125 } }, { "f", { NaN, NaN, NaN, NaN } } });
  EXPECT_TRUE(std::isnan(table.Columns[0].Orders[1]));
  EXPECT_TRUE(std::isnan(table.Columns[0].Orders[2]));
  EXPECT_TRUE(std::isnan(table.Columns[0].Orders[3])); // the same size
  EXPECT_TRUE(std::isnan(table.Columns[1].Order));
}

TEST(Convergence, TheTextsCanBePasted)
{
  const ConvergenceTable table =
    pemesh::MakeConvergenceTable("h", std::vector{ 1.0, 0.5 }, { { "error_l2", { 1.0, 0.25 } } });
  EXPECT_EQ(pemesh::FindConvergenceFormat("csv")->Format(table),
    "h,error_l2,error_l2_order\n1,1,nan\n0.5,0.25,2\nfit,,2\n");
  EXPECT_EQ(pemesh::FindConvergenceFormat("markdown")->Format(table),
    "| h | error_l2 | order |\n|---:|---:|---:|\n| 1.000e+00 | 1.000e+00 | - |\n"
    "| 5.000e-01 | 2.500e-01 | 2.00 |\n| fit |  | 2.00 |\n");
  EXPECT_THAT(pemesh::FindConvergenceFormat("latex")->Format(table),
    testing::AllOf(HasSubstr("\\begin{tabular}{rrr}"), HasSubstr("error\\_l2 & order \\\\\n"),
      HasSubstr("$5.000 \\cdot 10^{-1}$ & $2.500 \\cdot 10^{-1}$ & 2.00 \\\\\n")));
  EXPECT_EQ(pemesh::FindConvergenceFormat("pdf"), nullptr);
}

vtkSmartPointer<vtkTable> MakeTable()
{
  auto table = vtkSmartPointer<vtkTable>::New();
  const auto add = [&](const char* name, const std::vector<double>& values)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    for (const double value : values)
    {
      column->InsertNextValue(value);
    }
    table->AddColumn(column);
  };
  add("MeshSize", { 1.0, 0.5 });
  add("vem_dofs", { 16.0, 64.0 });
  add("vem_relative-error-l2", { 4.0, 1.0 });
  add("vem_condition-number", { 4.0, 1.0 });
  return table;
}

TEST(PEMConvergence, TakesTheErrorsOfATable)
{
  vtkNew<vtkPEMConvergence> filter;
  filter->SetInputData(MakeTable());
  filter->Update();
  ASSERT_EQ(filter->GetOutput()->GetNumberOfColumns(), 3);
  EXPECT_DOUBLE_EQ(
    filter->GetOutput()->GetValueByName(1, "vem_relative-error-l2_order").ToDouble(), 2.0);
  vtkTable* fits = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  EXPECT_EQ(fits->GetValueByName(0, "Error").ToString(), "vem_relative-error-l2");
  EXPECT_DOUBLE_EQ(fits->GetValueByName(0, "Order").ToDouble(), 2.0);
  filter->SetSizeColumn("vem_dofs");
  filter->SizeIsCountOn();
  filter->Update();
  EXPECT_DOUBLE_EQ(filter->GetOutput()->GetValue(1, 0).ToDouble(), 0.125);
  EXPECT_THAT(filter->FormatOutput("markdown"), HasSubstr("| 1.250e-01 | 1.000e+00 | 2.00 |"));
}

TEST(PEMConvergence, AColumnThatIsNotThereIsAnError)
{
  vtkNew<vtkPEMConvergence> filter;
  const pemesh::ErrorLog log(filter);
  filter->SetInputData(MakeTable());
  filter->SetSizeColumn("MehsSize");
  EXPECT_EQ(filter->GetExecutive()->Update(), 0);
  EXPECT_THAT(log.GetText(), HasSubstr("MeshSize"));
}

} // namespace
