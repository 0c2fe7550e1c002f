// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TableRows.h"

#include "CaseStatus.h"
#include "TestTables.h"

#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

TEST(TableRows, EqualColumnsAreAppended)
{
  vtkNew<vtkTable> table;
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkTable> row;
    AddColumn<vtkStringArray>(row, "Mesh", { "m" + std::to_string(i) });
    AddColumn<vtkIntArray>(row, "Elements", { 10 + i });
    AddColumn<vtkDoubleArray>(row, "Area_min", { 0.5 * i });
    pemesh::AppendTableRows(table, row);
  }
  EXPECT_EQ(ColumnNames(table), (std::vector<std::string>{ "Mesh", "Elements", "Area_min" }));
  ASSERT_EQ(table->GetNumberOfRows(), 3);
  EXPECT_EQ(table->GetValue(2, 0).ToString(), "m2");
  EXPECT_TRUE(vtkIdTypeArray::SafeDownCast(table->GetColumn(1)));
  EXPECT_EQ(table->GetValue(1, 1).ToInt(), 11);
  EXPECT_EQ(table->GetValue(2, 2).ToDouble(), 1.0);
}

TEST(TableRows, NewColumnsTakeTheirPlaceAndMissingOnesAreNaN)
{
  vtkNew<vtkTable> table;
  vtkNew<vtkTable> first;
  AddColumn<vtkIdTypeArray>(first, "A", { 1 });
  AddColumn<vtkStringArray>(first, "Status", { "ok" });
  pemesh::AppendTableRows(table, first);
  vtkNew<vtkTable> second;
  AddColumn<vtkIdTypeArray>(second, "B", { 2 });
  AddColumn<vtkStringArray>(second, "Word", { "x" });
  AddColumn<vtkStringArray>(second, "Status", { "bad" });
  pemesh::AppendTableRows(table, second);
  EXPECT_EQ(ColumnNames(table), (std::vector<std::string>{ "B", "Word", "A", "Status" }));
  EXPECT_TRUE(std::isnan(table->GetValueByName(1, "A").ToDouble()));
  EXPECT_EQ(table->GetValueByName(0, "A").ToDouble(), 1.0);
  EXPECT_TRUE(std::isnan(table->GetValueByName(0, "B").ToDouble()));
  EXPECT_EQ(table->GetValueByName(1, "B").ToDouble(), 2.0);
  EXPECT_EQ(table->GetValueByName(0, "Word").ToString(), "");
  EXPECT_EQ(table->GetValueByName(1, "Status").ToString(), "bad");
}

TEST(TableRows, KindsGiveWay)
{
  vtkNew<vtkTable> table;
  vtkNew<vtkTable> integer;
  AddColumn<vtkIdTypeArray>(integer, "A", { 1 });
  vtkNew<vtkTable> number;
  AddColumn<vtkDoubleArray>(number, "A", { 0.1 });
  vtkNew<vtkTable> text;
  AddColumn<vtkStringArray>(text, "A", { "word" });
  pemesh::AppendTableRows(table, integer);
  pemesh::AppendTableRows(table, number);
  EXPECT_TRUE(vtkDoubleArray::SafeDownCast(table->GetColumn(0)));
  pemesh::AppendTableRows(table, integer);
  EXPECT_EQ(table->GetValue(2, 0).ToDouble(), 1.0);
  pemesh::AppendTableRows(table, text);
  pemesh::AppendTableRows(table, number);
  ASSERT_EQ(table->GetNumberOfRows(), 5);
  EXPECT_EQ(table->GetValue(1, 0).ToString(), "0.1");
  EXPECT_EQ(table->GetValue(3, 0).ToString(), "word");
  EXPECT_EQ(table->GetValue(4, 0).ToString(), "0.1");
}

TEST(TableRows, SeveralRowsAndNone)
{
  vtkNew<vtkTable> table;
  vtkNew<vtkTable> rows;
  AddColumn<vtkDoubleArray>(rows, "A", { 1.0, 2.0 });
  vtkNew<vtkTable> none;
  pemesh::AppendTableRows(table, none);
  pemesh::AppendTableRows(table, rows);
  pemesh::AppendTableRows(table, none);
  pemesh::AppendTableRows(table, rows);
  EXPECT_EQ(table->GetNumberOfRows(), 4);
  EXPECT_EQ(rows->GetNumberOfRows(), 2) << "the source is left alone";
}

TEST(TableRows, NumbersRowsAndUnitesLists)
{
  vtkNew<vtkTable> table;
  for (const char* name : { "a_seconds", "b_seconds", "a_seconds" })
  {
    vtkNew<vtkTable> row;
    AddColumn<vtkDoubleArray>(row, "A", { 1.0 });
    pemesh::AddToFieldList(row, pemesh::MeasuredList, name);
    pemesh::AppendTableRows(table, row);
  }
  pemesh::NumberTableRows(table);
  pemesh::NumberTableRows(table);
  EXPECT_EQ(ColumnNames(table), (std::vector<std::string>{ "Index", "A" }));
  EXPECT_EQ(table->GetValue(2, 0).ToInt(), 2);
  EXPECT_TRUE(pemesh::IsInFieldList(table, pemesh::MeasuredList, "a_seconds"));
  EXPECT_TRUE(pemesh::IsInFieldList(table, pemesh::MeasuredList, "b_seconds"));
  EXPECT_FALSE(pemesh::IsInFieldList(table, pemesh::ParametersList, "a_seconds"));
}

} // namespace
