// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CsvTable.h"

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <gmock/gmock.h>

using namespace pemesh;

namespace
{

template <typename Array, typename Value>
void AddColumn(vtkTable* table, const char* name, const std::vector<Value>& values)
{
  vtkNew<Array> column;
  column->SetName(name);
  for (const Value& value : values)
  {
    column->InsertNextValue(value);
  }
  table->AddColumn(column);
}

std::string Failure(const std::string& text)
{
  try
  {
    ParseCsv(text, "table.csv");
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "no failure";
}

} // namespace

TEST(CsvTable, WritesByTheStandard)
{
  vtkNew<vtkTable> table;
  AddColumn<vtkIntArray>(table, "Index", std::vector<int>{ 0, -1 });
  AddColumn<vtkStringArray>(
    table, "Mesh, name", std::vector<std::string>{ "a \"b\",\nc", "plain" });
  AddColumn<vtkDoubleArray>(
    table, "t", std::vector<double>{ 0.1, std::numeric_limits<double>::quiet_NaN() });
  EXPECT_EQ(FormatCsv(table), "Index,\"Mesh, name\",t\n0,\"a \"\"b\"\",\nc\",0.1\n-1,plain,nan\n");
}

TEST(CsvTable, ReadsWhatItWrites)
{
  vtkNew<vtkTable> table;
  AddColumn<vtkIdTypeArray>(
    table, "Index", std::vector<vtkIdType>{ 0, std::numeric_limits<vtkIdType>::max(), -7 });
  AddColumn<vtkStringArray>(table, "Text", std::vector<std::string>{ "", ",\"\r\n", "ü 网格" });
  AddColumn<vtkDoubleArray>(table, "Number",
    std::vector<double>{ 1.0 / 3.0, -0.0, std::numeric_limits<double>::infinity() });
  AddColumn<vtkStringArray>(table, "Nothing", std::vector<std::string>{ "", "", "" });
  AddColumn<vtkStringArray>(table, "Code", std::vector<std::string>{ "007", "000", "1" });
  const std::string text = FormatCsv(table);
  const auto again = ParseCsv(text, "x");
  EXPECT_EQ(FormatCsv(again), text);
  ASSERT_EQ(again->GetNumberOfColumns(), 5);
  for (vtkIdType i = 0; i < 5; ++i)
  {
    EXPECT_STREQ(again->GetColumn(i)->GetClassName(), table->GetColumn(i)->GetClassName());
    EXPECT_STREQ(again->GetColumnName(i), table->GetColumnName(i));
  }
  EXPECT_EQ(again->GetValueByName(1, "Text").ToString(), ",\"\r\n");
  EXPECT_TRUE(std::signbit(again->GetValueByName(1, "Number").ToDouble()));
}

TEST(CsvTable, ASingleEmptyColumnKeepsItsRows)
{
  vtkNew<vtkTable> table;
  AddColumn<vtkStringArray>(table, "Text", std::vector<std::string>{ "", "x", "" });
  const auto again = ParseCsv(FormatCsv(table), "x");
  EXPECT_EQ(again->GetNumberOfRows(), 3);
  EXPECT_EQ(again->GetValue(1, 0).ToString(), "x");
}

TEST(CsvTable, ReadsFilesOfOthers)
{
  const auto table =
    ParseCsv("\xEF\xBB\xBFname,\"x\",y\r\n\r\n\"a\"\"b\", 2.5 ,\r\nc,1,3\r\n", "x");
  ASSERT_EQ(table->GetNumberOfRows(), 2);
  EXPECT_EQ(table->GetValueByName(0, "name").ToString(), "a\"b");
  EXPECT_EQ(table->GetValueByName(0, "x").ToDouble(), 2.5);
  EXPECT_TRUE(std::isnan(table->GetValueByName(0, "y").ToDouble())); // nothing is NaN
  EXPECT_EQ(table->GetValueByName(1, "y").ToDouble(), 3.0);
  EXPECT_EQ(ParseCsv("a,b\r1,2\r3,4\r", "x")->GetNumberOfRows(), 2); // old ends of lines
  EXPECT_EQ(ParseCsv("a,b", "x")->GetNumberOfColumns(), 2);          // no rows
  EXPECT_EQ(ParseCsv("a,b\n1,2", "x")->GetNumberOfRows(), 1);        // no end of line
}

TEST(CsvTable, SaysWhatIsWrongAndWhere)
{
  using testing::HasSubstr;
  EXPECT_THAT(Failure(""), HasSubstr("\"table.csv\" is empty"));
  EXPECT_THAT(Failure("\n\n"), HasSubstr("is empty"));
  EXPECT_THAT(Failure("a,b\n1,2\n3\n"), HasSubstr("line 3, has 1 fields where the header has 2"));
  EXPECT_THAT(Failure("a,b\n\"x\ny\",2\n1,2,3\n"), HasSubstr("line 4, has 3 fields"));
  EXPECT_THAT(Failure("a,b,a\n"), HasSubstr("line 1, names the column \"a\" twice"));
  EXPECT_THAT(Failure("a\n\"x\n"), HasSubstr("line 2, opens a quote that is never closed"));
  EXPECT_THAT(Failure("a\n\"x\"y\n"), HasSubstr("line 2, has text after a closing quote"));
}

TEST(CsvTable, RandomBytesAreATableOrAnError)
{
  std::mt19937_64 engine(5);
  const std::string bytes = "a1,\"\r\n .-\xff";
  int tables = 0;
  for (int i = 0; i < 5000; ++i)
  {
    std::string text;
    for (std::size_t length = engine() % 30; length > 0; --length)
    {
      text += bytes[engine() % bytes.size()];
    }
    if (Failure(text) == "no failure")
    {
      ++tables;
      const auto table = ParseCsv(text, "x");
      const std::string again = FormatCsv(table);
      EXPECT_EQ(FormatCsv(ParseCsv(again, "x")), again);
    }
  }
  EXPECT_GT(tables, 100);
}
