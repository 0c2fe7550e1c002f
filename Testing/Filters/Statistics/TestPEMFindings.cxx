// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMFindings.h"

#include "TestTables.h"
#include "vtkPEMCorrelation.h"

#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkTestErrorObserver.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace
{

using testing::HasSubstr;
using Numbers = std::vector<double>;

/** Six studies of five meshes: Good drives the error, Poor hardly, Flat never changes. */
vtkNew<vtkTable> MakePooled(bool pooled)
{
  vtkNew<vtkTable> table;
  std::vector<std::string> studies;
  Numbers good;
  Numbers poor;
  Numbers error;
  for (int row = 0; row < 30; ++row)
  {
    studies.push_back("study" + std::to_string(row / 5));
    good.push_back(1.0 + row % 5 + 2.0 * (row / 5));
    poor.push_back((row * 17) % 23 + 0.1 * row);
    error.push_back(100.0 * std::pow(good.back(), -1.9));
  }
  if (pooled)
  {
    AddColumn<vtkStringArray>(table, "Study", studies);
  }
  AddColumn<vtkDoubleArray>(table, "Poor_min", poor);
  AddColumn<vtkDoubleArray>(table, "Good_min", good);
  AddColumn<vtkDoubleArray>(table, "Flat_min", Numbers(30, 1.0));
  AddColumn<vtkDoubleArray>(table, "vem_error", error);
  return table;
}

std::string TextAt(vtkTable* table, vtkIdType row, const char* column)
{
  return table->GetValueByName(row, column).ToString();
}

TEST(PEMFindings, RanksMetricsAloneAndJointly)
{
  vtkNew<vtkTable> table = MakePooled(true);
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(table);
  vtkNew<vtkPEMFindings> findings;
  findings->SetInputConnection(0, correlation->GetOutputPort());
  findings->SetInputData(1, table);
  findings->Update();
  vtkTable* result = findings->GetOutput();
  ASSERT_EQ(result->GetNumberOfRows(), 3);
  EXPECT_EQ(TextAt(result, 0, "Metric"), "Good_min");
  EXPECT_EQ(TextAt(result, 1, "Metric"), "Poor_min");
  EXPECT_EQ(TextAt(result, 2, "Metric"), "Flat_min");
  EXPECT_EQ(result->GetValueByName(2, "Rank").ToInt(), 0);
  EXPECT_EQ(TextAt(result, 0, "Words"), "strong negative, a power law with exponent -1.9");
  EXPECT_EQ(result->GetValueByName(0, "JointRank").ToInt(), 1);
  EXPECT_NEAR(result->GetValueByName(0, "JointWeight").ToDouble(), -1.0, 0.05);
  EXPECT_THAT(TextAt(result, 0, "Joint"), HasSubstr("Jointly, 2 metrics predict"));
  EXPECT_EQ(TextAt(result, 1, "Joint"), "") << "once for each performance";
  const std::string text = findings->GetText();
  EXPECT_THAT(text, HasSubstr("vem_error (30 rows of 6 families)"));
  EXPECT_THAT(text,
    HasSubstr("  1. Good_min: strong negative, a power law with exponent -1.9; "
              "Spearman -1, p 0.001"));
  EXPECT_THAT(text, HasSubstr("Without a coefficient: 1, as Flat_min: undefined: X has one value"));
  EXPECT_THAT(text, HasSubstr("Note: p by letting 6 families change places"));
}

TEST(PEMFindings, AlongOneFamilyNothingIsClaimedThatCannotBe)
{
  vtkNew<vtkTable> table = MakePooled(false);
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(table);
  vtkNew<vtkPEMFindings> findings;
  findings->SetInputConnection(0, correlation->GetOutputPort());
  findings->SetInputData(1, table);
  findings->SetNumberOfSentences(1);
  findings->Update();
  const std::string text = findings->GetText();
  EXPECT_THAT(text, HasSubstr("No joint model: All rows are of one family"));
  EXPECT_THAT(text, HasSubstr("are no sample"));
  EXPECT_THAT(text, HasSubstr("... and 1 more."));
  EXPECT_THAT(text, testing::Not(HasSubstr(", p ")));
}

TEST(PEMFindings, OneRowAndInfiniteValuesAreSentences)
{
  const auto text = [](const Numbers& metric, const Numbers& error)
  {
    vtkNew<vtkTable> table;
    AddColumn<vtkDoubleArray>(table, "A_min", metric);
    AddColumn<vtkDoubleArray>(table, "run_e", error);
    vtkNew<vtkPEMCorrelation> correlation;
    correlation->SetInputData(table);
    vtkNew<vtkPEMFindings> findings;
    findings->SetInputConnection(0, correlation->GetOutputPort());
    findings->SetInputData(1, table);
    findings->Update();
    return findings->GetText();
  };
  const std::string one = text({ 1 }, { 2 });
  EXPECT_THAT(one, HasSubstr("run_e (1 row)"));
  EXPECT_THAT(one, HasSubstr("A_min: undefined: fewer than two rows have both values."));
  EXPECT_THAT(one, HasSubstr("No joint model: Fewer than two rows have all values."));
  const std::string infinite = text({ 1, 2, 3, 4 }, { 1, 5, HUGE_VAL, -HUGE_VAL });
  EXPECT_THAT(infinite, HasSubstr("1. A_min: weak negative; Spearman -0.2."));
}

TEST(PEMFindings, WrongInputsAreErrorsAndNoPerformanceIsASentence)
{
  vtkNew<vtkTable> table = MakePooled(true);
  vtkNew<vtkPEMFindings> findings;
  vtkNew<vtkTest::ErrorObserver> errors;
  findings->AddObserver(vtkCommand::ErrorEvent, errors);
  findings->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  findings->SetInputData(0, table);
  findings->SetInputData(1, table);
  EXPECT_EQ(findings->GetExecutive()->Update(), 0);
  EXPECT_THAT(errors->GetErrorMessage(), HasSubstr("vtkPEMCorrelation"));
  table->RemoveColumnByName("vem_error");
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(table);
  findings->SetInputConnection(0, correlation->GetOutputPort());
  findings->Update();
  EXPECT_EQ(findings->GetOutput()->GetNumberOfRows(), 0);
  EXPECT_THAT(findings->GetText(), HasSubstr("<run>_<performance>"));
}

} // namespace
