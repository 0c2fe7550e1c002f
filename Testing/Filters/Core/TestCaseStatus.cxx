// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseStatus.h"

#include <cmath>

#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

using namespace pemesh;

TEST(CaseStatus, IsOkWhereNothingWasSaid)
{
  vtkNew<vtkPolyData> data;
  EXPECT_EQ(GetCaseStatus(data), "ok");
  EXPECT_EQ(GetCaseStatusMessage(data), "");
  EXPECT_FALSE(IsCaseFailed(data));
  EXPECT_EQ(GetCaseStatus(nullptr), "ok");
}

TEST(CaseStatus, TellsAFailure)
{
  vtkNew<vtkPolyData> data;
  SetCaseFailed(data, "meshing-failed", "It did not work.");
  EXPECT_TRUE(IsCaseFailed(data));
  EXPECT_EQ(GetCaseStatus(data), "meshing-failed");
  EXPECT_EQ(GetCaseStatusMessage(data), "It did not work.");
  SetCaseFailed(data, "unreadable-mesh", "Another.");
  EXPECT_EQ(GetCaseStatus(data), "unreadable-mesh");
  EXPECT_EQ(data->GetFieldData()->GetNumberOfArrays(), 2);
}

TEST(CaseStatus, TravelsWithAShallowCopyAndNotBack)
{
  vtkNew<vtkPolyData> input;
  SetFieldNumber(input, "t", 0.5);
  AddToFieldList(input, ParametersList, "t");
  vtkNew<vtkPolyData> output;
  output->ShallowCopy(input);
  SetCaseFailed(output, "no-mesh", "x");
  SetFieldNumber(output, "t", 0.75);
  AddToFieldList(output, ParametersList, "angle");
  EXPECT_FALSE(IsCaseFailed(input));
  EXPECT_EQ(GetFieldNumber(input, "t"), 0.5);
  EXPECT_EQ(GetFieldNumber(output, "t"), 0.75);
  EXPECT_FALSE(IsInFieldList(input, ParametersList, "angle"));
  EXPECT_TRUE(IsInFieldList(output, ParametersList, "t"));
}

TEST(CaseStatus, FieldsThatAreMissingOrOfAnotherType)
{
  vtkNew<vtkPolyData> data;
  EXPECT_TRUE(std::isnan(GetFieldNumber(data, "none")));
  EXPECT_EQ(GetFieldText(data, "none"), "");
  vtkNew<vtkIntArray> integers;
  integers->SetName("count");
  data->GetFieldData()->AddArray(integers);
  EXPECT_TRUE(std::isnan(GetFieldNumber(data, "count"))); // no value
  integers->InsertNextValue(7);
  EXPECT_EQ(GetFieldNumber(data, "count"), 7.0);
  EXPECT_EQ(GetFieldText(data, "count"), "");
  SetFieldText(data, "text", "größe");
  EXPECT_EQ(GetFieldText(data, "text"), "größe");
  EXPECT_TRUE(std::isnan(GetFieldNumber(data, "text")));
}

TEST(CaseStatus, ListsHoldEachNameOnce)
{
  vtkNew<vtkPolyData> data;
  EXPECT_FALSE(IsInFieldList(data, MeasuredList, "seconds"));
  AddToFieldList(data, MeasuredList, "seconds");
  AddToFieldList(data, MeasuredList, "bytes");
  AddToFieldList(data, MeasuredList, "seconds");
  EXPECT_TRUE(IsInFieldList(data, MeasuredList, "bytes"));
  EXPECT_EQ(data->GetFieldData()->GetAbstractArray(MeasuredList)->GetNumberOfValues(), 2);
}
