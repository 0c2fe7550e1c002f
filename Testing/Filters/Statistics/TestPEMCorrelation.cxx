// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMCorrelation.h"

#include "BruteForce.h"
#include "CaseStatus.h"
#include "TestTables.h"

#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkIdTypeArray.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

using Numbers = std::vector<double>;

/** A series table of eight meshes with two metrics and one run. */
vtkNew<vtkTable> MakeSeries()
{
  vtkNew<vtkTable> table;
  AddColumn<vtkIdTypeArray>(table, "Index", { 0, 1, 2, 3, 4, 5, 6, 7 });
  AddColumn<vtkStringArray>(table, "Mesh", std::vector<std::string>(8, "m"));
  AddColumn<vtkDoubleArray>(table, "t", { 0, .1, .2, .3, .4, .5, .6, .7 });
  AddColumn<vtkIdTypeArray>(table, "Elements", { 9, 9, 9, 8, 8, 8, 7, 7 });
  AddColumn<vtkDoubleArray>(table, "Area_min", { 8, 7, 6, 5, 4, 3, 2, 1 });
  AddColumn<vtkDoubleArray>(table, "Area_max", Numbers(8, 0.5));
  AddColumn<vtkDoubleArray>(table, "Area_mean", { 1, 4, 2, NaN, 5, 3, 0, 6 });
  AddColumn<vtkIdTypeArray>(table, "Area_min_element", { 0, 1, 2, 3, 4, 5, 6, 7 });
  AddColumn<vtkIdTypeArray>(table, "Area_max_element", { 0, 1, 2, 3, 4, 5, 6, 7 });
  AddColumn<vtkDoubleArray>(table, "vem_error", { 1, 2, 4, 8, 16, 32, 64, 128 });
  AddColumn<vtkDoubleArray>(table, "vem_seconds", { 3, 1, 4, 1, 5, 9, 2, 6 });
  AddColumn<vtkStringArray>(table, "vem_Status", std::vector<std::string>(8, "ok"));
  pemesh::AddToFieldList(table, pemesh::MeasuredList, "vem_seconds");
  return table;
}

vtkIdType FindPair(vtkTable* result, const std::string& x, const std::string& y)
{
  for (vtkIdType i = 0; i < result->GetNumberOfRows(); ++i)
  {
    if (result->GetValueByName(i, "X").ToString() == x &&
      result->GetValueByName(i, "Y").ToString() == y)
    {
      return i;
    }
  }
  return -1;
}

TEST(PEMCorrelation, DefaultPairs)
{
  vtkNew<vtkTable> table = MakeSeries();
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(table);
  correlation->Update();
  vtkTable* result = correlation->GetOutput();
  EXPECT_EQ(ColumnNames(result),
    (std::vector<std::string>{ "X", "Y", "N", "Families", "Pearson", "Spearman", "Kendall",
      "DistanceCorrelation", "Partial", "Coefficient", "Tested", "P", "PHolm", "PBenjaminiHochberg",
      "Low", "High", "Trend", "Direction", "Strength", "Form", "FormParameter", "FormFit",
      "Words" }));
  std::vector<std::string> pairs;
  for (vtkIdType i = 0; i < result->GetNumberOfRows(); ++i)
  {
    pairs.push_back(result->GetValue(i, 0).ToString() + " " + result->GetValue(i, 1).ToString());
  }
  EXPECT_EQ(pairs,
    (std::vector<std::string>{ "Area_min Area_max", "Area_min Area_mean", "Area_min vem_error",
      "Area_max Area_mean", "Area_max vem_error", "Area_mean vem_error" }));
}

TEST(PEMCorrelation, StatisticsOfMetricsAreNoPerformances)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  for (const char* name : { "MinAngle_deviation", "MinAngle_q0.05_placed", "MinAngle_bin1",
         "MinAngle_undefined", "MinAngle_min_element", "run_dofs" })
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    for (const double value : { 1.0, 2.0, 4.0 })
    {
      column->InsertNextValue(value);
    }
    table->AddColumn(column);
  }
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(table);
  correlation->Update();
  std::set<std::string> x;
  std::set<std::string> y;
  vtkTable* pairs = correlation->GetOutput();
  for (vtkIdType row = 0; row < pairs->GetNumberOfRows(); ++row)
  {
    x.insert(pairs->GetValueByName(row, "X").ToString());
    y.insert(pairs->GetValueByName(row, "Y").ToString());
  }
  const std::set<std::string> metrics = { "MinAngle_deviation", "MinAngle_q0.05_placed" };
  EXPECT_EQ(x, metrics) << "no counts, no elements";
  EXPECT_TRUE(y.count("run_dofs"));
  EXPECT_FALSE(y.count("MinAngle_bin1"));
  EXPECT_FALSE(y.count("MinAngle_undefined"));
}

TEST(PEMCorrelation, AlongOneFamilyOnlyTheTrend)
{
  vtkNew<vtkTable> table = MakeSeries();
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(table);
  correlation->SetBootstrap(50);
  correlation->Update();
  vtkTable* result = correlation->GetOutput();
  const vtkIdType row = FindPair(result, "Area_min", "vem_error");
  ASSERT_GE(row, 0);
  EXPECT_EQ(result->GetValueByName(row, "N").ToInt(), 8);
  EXPECT_EQ(result->GetValueByName(row, "Spearman").ToDouble(), -1.0);
  EXPECT_EQ(result->GetValueByName(row, "Kendall").ToDouble(), -1.0);
  EXPECT_NEAR(result->GetValueByName(row, "Pearson").ToDouble(),
    brute::Pearson({ 8, 7, 6, 5, 4, 3, 2, 1 }, { 1, 2, 4, 8, 16, 32, 64, 128 }), 1e-14);
  for (const char* p : { "P", "PHolm", "PBenjaminiHochberg", "Low", "High" })
  {
    EXPECT_TRUE(std::isnan(result->GetValueByName(row, p).ToDouble()));
  }
  EXPECT_EQ(result->GetValueByName(row, "Trend").ToString(), "decreasing");
  EXPECT_NE(pemesh::GetFieldText(result, "Note").find("one family"), std::string::npos);
  // The error doubles while the area falls by one: exp(-log(2) x).
  EXPECT_EQ(result->GetValueByName(row, "Words").ToString(),
    "strong negative, an exponential with rate -0.69");
  EXPECT_NEAR(result->GetValueByName(row, "FormParameter").ToDouble(), -std::log(2.0), 1e-12);
}

TEST(PEMCorrelation, ConstantColumnAndMissingValues)
{
  vtkNew<vtkTable> table = MakeSeries();
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(table);
  correlation->Update();
  vtkTable* result = correlation->GetOutput();
  const vtkIdType constant = FindPair(result, "Area_max", "vem_error");
  EXPECT_TRUE(std::isnan(result->GetValueByName(constant, "Pearson").ToDouble()));
  EXPECT_TRUE(std::isnan(result->GetValueByName(constant, "Kendall").ToDouble()));
  EXPECT_EQ(result->GetValueByName(constant, "Trend").ToString(), "constant");
  EXPECT_EQ(
    result->GetValueByName(constant, "Words").ToString(), "undefined: X has one value only");
  const vtkIdType mixed = FindPair(result, "Area_mean", "vem_error");
  EXPECT_EQ(result->GetValueByName(mixed, "N").ToInt(), 7);
  EXPECT_NEAR(result->GetValueByName(mixed, "Kendall").ToDouble(),
    brute::KendallTauB({ 1, 4, 2, 5, 3, 0, 6 }, { 1, 2, 4, 16, 32, 64, 128 }), 1e-14);
  EXPECT_EQ(result->GetValueByName(mixed, "Trend").ToString(), "mixed");
}

TEST(PEMCorrelation, IndependentRowsHavePValues)
{
  vtkNew<vtkTable> table = MakeSeries();
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(table);
  correlation->IndependentRowsOn();
  correlation->Update();
  vtkTable* result = correlation->GetOutput();
  const vtkIdType row = FindPair(result, "Area_min", "vem_error");
  EXPECT_NEAR(result->GetValueByName(row, "P").ToDouble(), 2.0 / 40320, 1e-12);
  // Three pairs have a coefficient: those with the constant column are no tests.
  EXPECT_NEAR(result->GetValueByName(row, "PHolm").ToDouble(), 3 * 2.0 / 40320, 1e-12);
  // The other two are equal: Holm counts two, Benjamini and Hochberg three in three.
  const vtkIdType other = FindPair(result, "Area_mean", "vem_error");
  const double p = result->GetValueByName(other, "P").ToDouble();
  EXPECT_DOUBLE_EQ(result->GetValueByName(other, "PHolm").ToDouble(), std::min(1.0, 2 * p));
  EXPECT_DOUBLE_EQ(result->GetValueByName(other, "PBenjaminiHochberg").ToDouble(), p);
  const vtkIdType constant = FindPair(result, "Area_max", "vem_error");
  EXPECT_TRUE(std::isnan(result->GetValueByName(constant, "P").ToDouble()));
}

/** Four studies of four meshes; what they share along the family differs from what tells them
 * apart. */
vtkNew<vtkTable> MakePooled()
{
  vtkNew<vtkTable> table;
  std::vector<std::string> studies;
  Numbers metric;
  Numbers error;
  Numbers size;
  for (int study = 0; study < 4; ++study)
  {
    for (int i = 0; i < 4; ++i)
    {
      studies.push_back(std::string(1, static_cast<char>('a' + study)));
      metric.push_back(10.0 * study + i);
      size.push_back(1.0 + i * study % 3);
      error.push_back(100.0 * study + i * i);
    }
  }
  AddColumn<vtkStringArray>(table, "Study", studies);
  AddColumn<vtkDoubleArray>(table, "MeshSize", size);
  AddColumn<vtkDoubleArray>(table, "Area_min", metric);
  AddColumn<vtkDoubleArray>(table, "vem_error", error);
  return table;
}

TEST(PEMCorrelation, PooledStudiesHaveFamilyWiseTests)
{
  vtkNew<vtkTable> table = MakePooled();
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(table);
  correlation->SetBootstrap(200);
  correlation->Update();
  vtkTable* result = correlation->GetOutput();
  ASSERT_EQ(result->GetNumberOfRows(), 1);
  EXPECT_EQ(result->GetValueByName(0, "Families").ToInt(), 4);
  // Of the 24 arrangements only the given one and its reverse order so well... the reverse does
  // not, because within families both rise.
  EXPECT_DOUBLE_EQ(result->GetValueByName(0, "P").ToDouble(), 1.0 / 24);
  EXPECT_GT(result->GetValueByName(0, "Low").ToDouble(), 0.5);
  EXPECT_EQ(result->GetValueByName(0, "High").ToDouble(), 1.0);
  EXPECT_NE(pemesh::GetFieldText(result, "Note").find("all 24 arrangements"), std::string::npos);
  correlation->SetFamilyColumn("MeshSize");
  correlation->Update();
  EXPECT_EQ(correlation->GetOutput()->GetValueByName(0, "Families").ToInt(), 3);
}

TEST(PEMCorrelation, GivenColumnsMakeItPartial)
{
  vtkNew<vtkTable> table = MakePooled();
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(table);
  correlation->AddGivenColumn("MeshSize");
  correlation->Update();
  vtkTable* result = correlation->GetOutput();
  EXPECT_EQ(result->GetValueByName(0, "Coefficient").ToString(), "Spearman given MeshSize");
  EXPECT_EQ(result->GetValueByName(0, "Partial").ToDouble(),
    result->GetValueByName(0, "Tested").ToDouble());
  EXPECT_GT(result->GetValueByName(0, "Partial").ToDouble(), 0.9);
}

TEST(PEMCorrelation, NamedColumnsOnly)
{
  vtkNew<vtkTable> table = MakeSeries();
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(table);
  correlation->SetXColumns({ "t", "Elements" });
  correlation->SetYColumns({ "Elements", "t", "vem_seconds" });
  correlation->Update();
  vtkTable* result = correlation->GetOutput();
  ASSERT_EQ(result->GetNumberOfRows(), 3);
  EXPECT_EQ(FindPair(result, "t", "Elements"), 0);
  EXPECT_EQ(FindPair(result, "t", "vem_seconds"), 1);
  EXPECT_EQ(FindPair(result, "Elements", "vem_seconds"), 2);
  // Steps: no two meshes against the trend, although tau-b is short of 1 because of ties.
  EXPECT_EQ(result->GetValueByName(0, "Trend").ToString(), "decreasing");
}

std::string TrendOf(const Numbers& x, const Numbers& y, double threshold = 0.7)
{
  vtkNew<vtkTable> table;
  AddColumn<vtkDoubleArray>(table, "a", x);
  AddColumn<vtkDoubleArray>(table, "b", y);
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(table);
  correlation->AddXColumn("a");
  correlation->AddYColumn("b");
  correlation->SetTrendThreshold(threshold);
  correlation->Update();
  return correlation->GetOutput()->GetValueByName(0, "Trend").ToString();
}

TEST(PEMCorrelation, TrendIsWhatItsDefinitionSays)
{
  EXPECT_EQ(TrendOf({ 1, 2 }, { 1, 2 }), "undefined");
  EXPECT_EQ(TrendOf({ 1, 2, NaN }, { 1, 2, 3 }), "undefined");
  EXPECT_EQ(TrendOf({ 1, 2, 3 }, { 2, 2, 2 }), "constant");
  EXPECT_EQ(TrendOf({ 1, 2, 3, 4, 5 }, { 0, 0, 0, 0, 1 }), "increasing"); // tau-b = 0.63
  EXPECT_EQ(TrendOf({ 1, 2, 3, 4, 5 }, { 1, 1, 0, 0, 0 }), "decreasing");
  // One exchange of neighbours in five: 9 pairs against 1, tau = 0.8.
  EXPECT_EQ(TrendOf({ 1, 2, 3, 4, 5 }, { 2, 1, 3, 4, 5 }), "increasing");
  EXPECT_EQ(TrendOf({ 1, 2, 3, 4, 5 }, { 2, 1, 3, 4, 5 }, 0.9), "mixed");
  // Two exchanges: tau = 0.6.
  EXPECT_EQ(TrendOf({ 1, 2, 3, 4, 5 }, { 2, 1, 4, 3, 5 }), "mixed");
  EXPECT_EQ(TrendOf({ 1, 2, 3, 4, 5 }, { -2, -1, -4, -3, -5 }, 0.6), "decreasing");
  EXPECT_EQ(TrendOf({ 1, 2, 3, 4 }, { 1, 2, 2, 1 }, 0.0), "mixed");
}

TEST(PEMCorrelation, ARelationThatTurnsBackIsNotLost)
{
  Numbers x;
  Numbers y;
  for (int i = -20; i <= 20; ++i)
  {
    x.push_back(i);
    y.push_back(i * i);
  }
  vtkNew<vtkTable> table;
  AddColumn<vtkDoubleArray>(table, "a", x);
  AddColumn<vtkDoubleArray>(table, "b", y);
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(table);
  correlation->AddXColumn("a");
  correlation->AddYColumn("b");
  const auto words = [&]
  {
    correlation->Update();
    return correlation->GetOutput()->GetValueByName(0, "Words").ToString();
  };
  EXPECT_EQ(words(), "weak, of no direction; not monotone: distance correlation 0.49");
  correlation->SetCoefficient("distance");
  EXPECT_EQ(words(), "moderate, of no direction");
}

TEST(PEMCorrelation, UnknownAndTextColumnsAreErrors)
{
  vtkNew<vtkTable> table = MakeSeries();
  const auto complaint = [&](const std::string& name)
  {
    vtkNew<vtkPEMCorrelation> correlation;
    vtkNew<vtkTest::ErrorObserver> errors;
    correlation->AddObserver(vtkCommand::ErrorEvent, errors);
    correlation->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
    correlation->SetInputData(table);
    correlation->SetXColumns({ name });
    EXPECT_EQ(correlation->GetExecutive()->Update(), 0);
    return errors->GetErrorMessage();
  };
  EXPECT_NE(complaint("Area_mim").find("did you mean \"Area_min\"?"), std::string::npos);
  EXPECT_NE(complaint("Mesh").find("holds text"), std::string::npos);
}

/** Rounding errors in a value that does not change are no finding. */
TEST(PEMCorrelation, RoundingErrorsAreNoRelation)
{
  vtkNew<vtkTable> table = MakeSeries();
  Numbers size;
  Numbers fine;
  for (int i = 0; i < 8; ++i)
  {
    size.push_back(0.5 + i * 1e-15);
    fine.push_back(0.5 + i * 1e-10);
  }
  size[3] = NaN;
  AddColumn<vtkDoubleArray>(table, "run_size", size);
  AddColumn<vtkDoubleArray>(table, "run_fine", fine);
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(table);
  correlation->SetXColumns({ "Area_min" });
  correlation->SetYColumns({ "run_size", "run_fine" });
  correlation->Update();
  vtkTable* result = correlation->GetOutput();
  EXPECT_EQ(result->GetValueByName(0, "Words").ToString(), "undefined: Y has one value only");
  EXPECT_EQ(result->GetValueByName(0, "N").ToInt(), 7);
  EXPECT_EQ(result->GetValueByName(1, "Spearman").ToDouble(), -1.0);
}

TEST(PEMCorrelation, WrongOptionsAreErrors)
{
  vtkNew<vtkTable> table = MakeSeries();
  const auto complaint = [&](auto change)
  {
    vtkNew<vtkPEMCorrelation> correlation;
    vtkNew<vtkTest::ErrorObserver> errors;
    correlation->AddObserver(vtkCommand::ErrorEvent, errors);
    correlation->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
    correlation->SetInputData(table);
    change(correlation);
    EXPECT_EQ(correlation->GetExecutive()->Update(), 0);
    return errors->GetErrorMessage();
  };
  using Filter = vtkPEMCorrelation*;
  EXPECT_NE(complaint([](Filter c) { c->SetCoefficient("spaerman"); }).find("spearman, pearson"),
    std::string::npos);
  EXPECT_NE(
    complaint([](Filter c) { c->SetFamilyColumn("Stduy"); }).find("no column"), std::string::npos);
  EXPECT_NE(complaint([](Filter c) { c->SetGivenColumns({ "Elemnts" }); }).find("Elements"),
    std::string::npos);
}

/** Where nothing changes places there is no p-value, and the table says so. */
TEST(PEMCorrelation, PartialCoefficientsOfEveryKind)
{
  vtkNew<vtkTable> table = MakeSeries();
  for (const char* kind : { "kendall", "distance" })
  {
    vtkNew<vtkPEMCorrelation> correlation;
    correlation->SetInputData(table);
    correlation->SetCoefficient(kind);
    correlation->SetGivenColumns({ "Elements" });
    correlation->IndependentRowsOn();
    correlation->Update();
    vtkTable* result = correlation->GetOutput();
    ASSERT_GT(result->GetNumberOfRows(), 0);
    int defined = 0;
    for (vtkIdType row = 0; row < result->GetNumberOfRows(); ++row)
    {
      const double partial = result->GetValueByName(row, "Partial").ToDouble();
      defined += std::isnan(partial) ? 0 : 1;
      EXPECT_TRUE(std::isnan(partial) || std::fabs(partial) <= 1.0);
      EXPECT_TRUE(std::isnan(result->GetValueByName(row, "P").ToDouble()));
    }
    EXPECT_GT(defined, 0) << kind;
    EXPECT_NE(pemesh::GetFieldText(result, "Note").find("no p-values"), std::string::npos);
  }
}

TEST(PEMCorrelation, EmptyTableGivesNoPairs)
{
  vtkNew<vtkTable> table;
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetInputData(table);
  EXPECT_EQ(correlation->GetExecutive()->Update(), 1);
  EXPECT_EQ(correlation->GetOutput()->GetNumberOfRows(), 0);
  EXPECT_EQ(correlation->GetOutput()->GetNumberOfColumns(), 23);
}

TEST(PEMCorrelation, SettersCompareBeforeModified)
{
  vtkNew<vtkPEMCorrelation> correlation;
  correlation->SetXColumns({ "a" });
  const vtkMTimeType time = correlation->GetMTime();
  correlation->SetXColumns({ "a" });
  correlation->SetPermutations(999);
  correlation->RemoveAllYColumns();
  EXPECT_EQ(correlation->GetMTime(), time);
  correlation->SetPermutations(-5);
  EXPECT_EQ(correlation->GetPermutations(), 1);
  correlation->SetTrendThreshold(3.0);
  EXPECT_EQ(correlation->GetTrendThreshold(), 1.0);
  std::ostringstream stream;
  correlation->Print(stream);
  EXPECT_NE(stream.str().find("XColumns: a"), std::string::npos);
}

} // namespace
