// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// What the two classes add to CsvTable, whose rules TestIOCore pins.
#include "ErrorLog.h"
#include "TestFolder.h"
#include "vtkPEMTableReader.h"
#include "vtkPEMTableWriter.h"

#include <gmock/gmock.h>

#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <cmath>
#include <fstream>

using pemesh::ErrorLog;
using testing::HasSubstr;

TEST(TableFiles, KeepNamesKindsAndBits)
{
  vtkNew<vtkStringArray> names;
  names->SetName("Mesh");
  names->InsertNextValue("001_0.5");
  names->InsertNextValue("a, \"b\"");
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("Area_min");
  numbers->InsertNextValue(0.1 + 0.2);
  numbers->InsertNextValue(std::nan(""));
  vtkNew<vtkIdTypeArray> counts;
  counts->SetName("Elements");
  counts->InsertNextValue(7);
  counts->InsertNextValue(-3);
  vtkNew<vtkTable> table;
  table->AddColumn(names);
  table->AddColumn(numbers);
  table->AddColumn(counts);

  vtkNew<vtkPEMTableWriter> writer;
  writer->SetFileName(pemesh::TestPath("bits.csv"));
  writer->SetInputData(table);
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkPEMTableReader> reader;
  reader->SetFileName(writer->GetFileName());
  reader->Update();
  vtkTable* again = reader->GetOutput();
  ASSERT_EQ(again->GetNumberOfColumns(), 3);
  auto* mesh = vtkStringArray::SafeDownCast(again->GetColumnByName("Mesh"));
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->GetValue(0), "001_0.5");
  EXPECT_EQ(mesh->GetValue(1), "a, \"b\"");
  auto* area = vtkDoubleArray::SafeDownCast(again->GetColumnByName("Area_min"));
  ASSERT_TRUE(area);
  EXPECT_EQ(area->GetValue(0), 0.1 + 0.2);
  EXPECT_TRUE(std::isnan(area->GetValue(1)));
  auto* elements = vtkIdTypeArray::SafeDownCast(again->GetColumnByName("Elements"));
  ASSERT_TRUE(elements);
  EXPECT_EQ(elements->GetValue(1), -3);
}

TEST(TableFiles, SayWhatIsWrongWithAFile)
{
  std::ofstream(pemesh::TestPath("short.csv")) << "a,b\n1,2\n3\n";
  vtkNew<vtkPEMTableReader> reader;
  ErrorLog errors(reader);
  reader->Update();
  EXPECT_THAT(errors.GetText(), HasSubstr("set which table"));
  reader->SetFileName(pemesh::TestPath("short.csv"));
  reader->Update();
  EXPECT_THAT(errors.GetText(), HasSubstr("short.csv"));
  EXPECT_THAT(errors.GetText(), HasSubstr("line 3"));
  reader->SetFileName(pemesh::TestPath("there-is-none.csv"));
  reader->Update();
  EXPECT_THAT(errors.GetText(), HasSubstr("there-is-none.csv"));
  EXPECT_EQ(reader->GetOutput()->GetNumberOfRows(), 0);

  vtkNew<vtkTable> table;
  vtkNew<vtkPEMTableWriter> writer;
  ErrorLog writing(writer);
  writer->SetInputData(table);
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_THAT(writing.GetText(), HasSubstr("set where"));
  writer->SetFileName(pemesh::TestPath("short.csv") / "inside-a-file.csv");
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_THAT(writing.GetText(), HasSubstr("Not a directory"));
}
