// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMSeriesTable.h"

#include "TestTables.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/** A row of t and t^2 for any time; counts what it is asked. */
class RowSource : public vtkTableAlgorithm
{
public:
  static RowSource* New();

  std::vector<double> Times{ 0.0, 0.25, 0.5, 1.0 };
  std::vector<double> Asked;
  double ExtraFrom = 2.0; // rows from here on have one more column
  double FailAt = 2.0;
  bool HasNoTime = false;

protected:
  RowSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    vtkInformation* info = output->GetInformationObject(0);
    if (!this->HasNoTime)
    {
      const double range[2] = { this->Times.front(), this->Times.back() };
      info->Set(Pipeline::TIME_STEPS(), this->Times.data(), static_cast<int>(this->Times.size()));
      info->Set(Pipeline::TIME_RANGE(), range, 2);
    }
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    vtkInformation* info = output->GetInformationObject(0);
    const double t =
      info->Has(Pipeline::UPDATE_TIME_STEP()) ? info->Get(Pipeline::UPDATE_TIME_STEP()) : -1.0;
    this->Asked.push_back(t);
    if (t == this->FailAt)
    {
      vtkErrorMacro(<< "cannot do " << t);
      return 0;
    }
    vtkTable* row = vtkTable::GetData(output, 0);
    AddColumn<vtkStringArray>(row, "Mesh", { "at " + std::to_string(t) });
    AddColumn<vtkDoubleArray>(row, "t", { t });
    if (t >= this->ExtraFrom)
    {
      AddColumn<vtkDoubleArray>(row, "Extra", { 7.0 });
    }
    AddColumn<vtkDoubleArray>(row, "Square", { t * t });
    info->Set(vtkDataObject::DATA_TIME_STEP(), t);
    return 1;
  }
};
vtkStandardNewMacro(RowSource);

struct Walk
{
  vtkNew<RowSource> Source;
  vtkNew<vtkPEMSeriesTable> Series;
  vtkNew<vtkTest::ErrorObserver> Errors;

  Walk()
  {
    this->Series->SetInputConnection(this->Source->GetOutputPort());
    for (vtkAlgorithm* filter : { static_cast<vtkAlgorithm*>(this->Source.Get()),
           static_cast<vtkAlgorithm*>(this->Series.Get()) })
    {
      filter->AddObserver(vtkCommand::ErrorEvent, this->Errors);
      filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Errors);
    }
  }

  int Update() { return this->Series->GetExecutive()->Update(); }
  vtkTable* Table() { return this->Series->GetOutput(); }
};

TEST(PEMSeriesTable, WalksAllStepsInOrder)
{
  Walk walk;
  EXPECT_EQ(walk.Update(), 1);
  EXPECT_EQ(walk.Source->Asked, walk.Source->Times);
  EXPECT_EQ(
    ColumnNames(walk.Table()), (std::vector<std::string>{ "Index", "Mesh", "t", "Square" }));
  ASSERT_EQ(walk.Table()->GetNumberOfRows(), 4);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    const double t = walk.Source->Times[static_cast<std::size_t>(i)];
    EXPECT_EQ(walk.Table()->GetValue(i, 0).ToInt(), i);
    EXPECT_EQ(walk.Table()->GetValueByName(i, "t").ToDouble(), t);
    EXPECT_EQ(walk.Table()->GetValueByName(i, "Square").ToDouble(), t * t);
  }
  EXPECT_FALSE(walk.Series->GetOutputInformation(0)->Has(Pipeline::TIME_STEPS()));
}

TEST(PEMSeriesTable, SecondUpdateDoesNothingAndModifiedStartsAgain)
{
  Walk walk;
  walk.Update();
  walk.Update();
  EXPECT_EQ(walk.Source->Asked.size(), 4u);
  walk.Source->Modified();
  walk.Update();
  EXPECT_EQ(walk.Source->Asked.size(), 8u);
  EXPECT_EQ(walk.Table()->GetNumberOfRows(), 4);
  walk.Source->Times = { 0.5, 0.75 };
  walk.Source->Modified();
  walk.Update();
  EXPECT_EQ(walk.Table()->GetNumberOfRows(), 2);
}

TEST(PEMSeriesTable, KeepsAnOldOutputAlone)
{
  Walk walk;
  walk.Update();
  vtkNew<vtkTable> kept;
  kept->ShallowCopy(walk.Table());
  walk.Source->Times = { 0.5 };
  walk.Source->Modified();
  walk.Update();
  EXPECT_EQ(kept->GetNumberOfRows(), 4);
  EXPECT_EQ(kept->GetValueByName(3, "t").ToDouble(), 1.0);
}

TEST(PEMSeriesTable, AnInputWithoutTimeIsOneRow)
{
  Walk walk;
  walk.Source->HasNoTime = true;
  walk.Update();
  EXPECT_EQ(walk.Table()->GetNumberOfRows(), 1);
  EXPECT_EQ(walk.Source->Asked, std::vector<double>{ -1.0 });
}

TEST(PEMSeriesTable, RowsThatDifferAreUnited)
{
  Walk walk;
  walk.Source->ExtraFrom = 0.5;
  walk.Update();
  EXPECT_EQ(ColumnNames(walk.Table()),
    (std::vector<std::string>{ "Index", "Mesh", "t", "Extra", "Square" }));
  EXPECT_TRUE(std::isnan(walk.Table()->GetValueByName(1, "Extra").ToDouble()));
  EXPECT_EQ(walk.Table()->GetValueByName(2, "Extra").ToDouble(), 7.0);
}

TEST(PEMSeriesTable, AnErrorOnTheWayEndsTheWalk)
{
  Walk walk;
  walk.Source->FailAt = 0.5;
  EXPECT_EQ(walk.Update(), 0);
  EXPECT_TRUE(walk.Errors->GetError());
  EXPECT_EQ(walk.Source->Asked, (std::vector<double>{ 0.0, 0.25, 0.5 }));
  // Mended, it starts from the first step.
  walk.Source->FailAt = 2.0;
  walk.Source->Asked.clear();
  walk.Source->Modified();
  EXPECT_EQ(walk.Update(), 1);
  EXPECT_EQ(walk.Source->Asked, walk.Source->Times);
  EXPECT_EQ(walk.Table()->GetNumberOfRows(), 4);
}

TEST(PEMSeriesTable, AnErrorAtTheFirstStep)
{
  Walk walk;
  walk.Source->FailAt = 0.0;
  EXPECT_EQ(walk.Update(), 0);
  EXPECT_EQ(walk.Table()->GetNumberOfRows(), 0);
}

/** Records the progress of a filter, and asks it to stop after a number of reports. */
struct ProgressWatch
{
  vtkNew<vtkCallbackCommand> Command;
  std::vector<double> Seen;
  std::size_t StopAfter = 1000;

  explicit ProgressWatch(vtkAlgorithm* filter)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject* caller, unsigned long, void* data, void*)
      {
        auto* watch = static_cast<ProgressWatch*>(data);
        auto* algorithm = static_cast<vtkAlgorithm*>(caller);
        watch->Seen.push_back(algorithm->GetProgress());
        algorithm->SetAbortExecute(watch->Seen.size() >= watch->StopAfter ? 1 : 0);
      });
    filter->AddObserver(vtkCommand::ProgressEvent, this->Command);
  }
};

TEST(PEMSeriesTable, ReportsProgress)
{
  Walk walk;
  ProgressWatch watch(walk.Series);
  walk.Update();
  ASSERT_FALSE(watch.Seen.empty());
  EXPECT_EQ(watch.Seen.back(), 1.0);
  EXPECT_NE(std::find(watch.Seen.begin(), watch.Seen.end(), 0.5), watch.Seen.end());
}

TEST(PEMSeriesTable, AbortEmptiesTheOutputAndStartsOver)
{
  Walk walk;
  {
    ProgressWatch watch(walk.Series);
    watch.StopAfter = 3;
    walk.Update();
    EXPECT_LT(walk.Source->Asked.size(), 4u);
    EXPECT_EQ(walk.Table()->GetNumberOfRows(), 0);
    walk.Series->RemoveAllObservers();
  }
  walk.Source->Asked.clear();
  walk.Series->Modified();
  walk.Update();
  EXPECT_EQ(walk.Table()->GetNumberOfRows(), 4);
  EXPECT_EQ(walk.Source->Asked.size(), 4u);
}

/** Passes a table through and counts how often it is asked to. */
class CountingFilter : public vtkTableAlgorithm
{
public:
  static CountingFilter* New();
  int Executions = 0;

protected:
  int RequestData(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override
  {
    ++this->Executions;
    vtkTable::GetData(output, 0)->ShallowCopy(vtkTable::GetData(input[0], 0));
    return 1;
  }
};
vtkStandardNewMacro(CountingFilter);

TEST(PEMSeriesTable, FiltersDownstreamSeeTheWholeTableOnce)
{
  Walk walk;
  vtkNew<CountingFilter> after;
  after->SetInputConnection(walk.Series->GetOutputPort());
  EXPECT_EQ(after->GetExecutive()->Update(), 1);
  EXPECT_EQ(after->Executions, 1);
  EXPECT_EQ(after->GetOutput()->GetNumberOfRows(), 4);
  // A failure on the way does not reach them.
  walk.Source->FailAt = 0.5;
  walk.Source->Modified();
  EXPECT_EQ(after->GetExecutive()->Update(), 0);
  EXPECT_EQ(after->Executions, 1);
}

TEST(PEMSeriesTable, PrintsItself)
{
  vtkNew<vtkPEMSeriesTable> series;
  std::ostringstream stream;
  series->Print(stream);
  EXPECT_NE(stream.str().find("CurrentStep"), std::string::npos);
}

} // namespace
