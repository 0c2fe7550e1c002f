// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// All kinds of charts with all kinds of tables: a picture and a sentence, never a crash.
#include "ChartKinds.h"
#include "ChartOptions.h"
#include "ChartPick.h"
#include "ChartSupport.h"
#include "vtkPEMCairoContextDevice2D.h"
#include "vtkPEMChart.h"
#include "vtkPEMFigure.h"

#include <vtkContext2D.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using testing::HasSubstr;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

struct NamedTable
{
  std::string Name;
  vtkSmartPointer<vtkTable> Table;
};

NamedTable MakeTable(const std::string& name, const std::vector<double>& x,
  const std::vector<double>& a, const std::vector<double>& b)
{
  auto table = ChartSupport::MakeTable({ { "x", x }, { "a", a }, { "b", b } });
  vtkNew<vtkStringArray> classes;
  classes->SetName("class");
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    classes->InsertNextValue(i % 2 == 0 ? "comb" : "star");
  }
  table->AddColumn(classes);
  return { name, table };
}

std::vector<NamedTable> Tables()
{
  std::vector<double> many(12001);
  std::vector<double> wave(many.size());
  for (std::size_t i = 0; i < many.size(); ++i)
  {
    many[i] = 1.0 + static_cast<double>(i);
    wave[i] = 2.0 + std::sin(0.01 * static_cast<double>(i));
  }
  return {
    MakeTable("plain", { 1, 2, 3, 4, 5 }, { 1, 4, 9, 16, 25 }, { 5, 1, 4, 2, 3 }),
    MakeTable("constant", { 3, 3, 3 }, { 7, 7, 7 }, { 0, 0, 0 }),
    MakeTable("one row", { 0.5 }, { 2 }, { 3 }),
    MakeTable("no row", {}, {}, {}),
    MakeTable("undefined", { NaN, NaN }, { NaN, NaN }, { NaN, NaN }),
    MakeTable("some undefined", { 1, 2, NaN, 4 }, { NaN, 2, 3, 5 }, { 1, 2, 3, NaN }),
    MakeTable("infinite", { 1, 2, 3 }, { Infinity, 2, -Infinity }, { 1, Infinity, 3 }),
    MakeTable("negative", { -1, -2, -3 }, { -5, -6, -8 }, { -1e-9, -1, -1e9 }),
    MakeTable("zero", { 0, 0 }, { 0, 0 }, { 0, 0 }),
    MakeTable("extreme", { 1e-308, 1, 1e308 }, { -1e308, 0, 1e308 }, { 1e-320, 1e-310, 1e-300 }),
    MakeTable(
      "nearly constant", { 1, 1 + 1e-15, 1 + 2e-15 }, { 1, 2, 3 }, { 1e6, 1e6, 1e6 + 1e-9 }),
    MakeTable("many", many, wave, many),
  };
}

vtkSmartPointer<vtkPEMChart> MakeChart(const pemesh::ChartKind& kind, vtkTable* table)
{
  auto chart = vtkSmartPointer<vtkPEMChart>::New();
  chart->SetTable(table);
  EXPECT_TRUE(chart->SetKindByName(kind.Name));
  if (kind.UsesX)
  {
    chart->SetXColumn("x");
  }
  chart->SetYColumns({ "a", "b" });
  return chart;
}

/** How many pixels of a small painting are not white; paints at a small size, which is harder. */
long PaintedPixels(vtkPEMChart* chart)
{
  vtkNew<vtkPEMCairoContextDevice2D> device;
  device->SetPageSize(240, 180);
  chart->SetRectangle(0, 0, 240, 180);
  chart->SetFontSize(8);
  device->Begin(nullptr);
  vtkNew<vtkContext2D> context;
  context->Begin(device);
  EXPECT_TRUE(chart->Paint(context));
  context->End();
  device->End();
  const auto picture = ChartSupport::WriteAndRead(device->GetContents(),
    // Tests side by side need a file each.
    std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".png");
  long painted = 0;
  for (const auto& pixel : picture.Pixels)
  {
    painted += pixel != std::array<unsigned char, 3>{ 255, 255, 255 } ? 1 : 0;
  }
  return painted;
}

/** An empty frame has axes and labels only: a sentence in it or below it says why. */
TEST(ChartKinds, EveryKindHasAPictureOfEveryTable)
{
  for (const pemesh::ChartKind& kind : pemesh::ChartKinds())
  {
    for (const NamedTable& table : Tables())
    {
      for (const char* log : { "", "xy" })
      {
        SCOPED_TRACE(std::string(kind.Name) + ", " + table.Name + ", log " + log);
        auto chart = MakeChart(kind, table.Table);
        chart->SetLogAxes(log);
        ASSERT_EQ(chart->WhyNotDrawable(), "");
        EXPECT_GT(PaintedPixels(chart), 400);
        // And whatever is asked of it then has an answer.
        chart->Pick(120, 90);
        chart->SelectRectangle(0, 0, 240, 180);
        chart->Zoom(120, 90, 2.0);
        chart->SetHighlightedRows({ 0, 1 });
        EXPECT_GT(PaintedPixels(chart), 400);
        EXPECT_TRUE(chart->MakeDataTable());
      }
    }
  }
}

TEST(ChartKinds, OptionsOfEveryKindWorkOnEveryTable)
{
  for (const pemesh::ChartKind& kind : pemesh::ChartKinds())
  {
    for (const NamedTable& table : Tables())
    {
      for (const char* fit : { "linear", "power", "exponential", "best" })
      {
        SCOPED_TRACE(std::string(kind.Name) + ", " + table.Name + ", " + fit);
        auto chart = MakeChart(kind, table.Table);
        chart->SetYColumns({ "a" });
        if (kind.LeastY > 1)
        {
          chart->AddYColumn("b");
        }
        chart->SetOption("fit", fit);
        chart->SetOption("group-by", kind.LeastY > 1 ? "" : "class");
        chart->SetOption("method", "kendall");
        chart->SetOption("bins", "7");
        chart->SetOption("y-min", "0.5");
        ASSERT_EQ(chart->WhyNotDrawable(), "");
        if (std::string(fit) == "best")
        {
          EXPECT_GT(PaintedPixels(chart), 400);
        }
      }
    }
  }
}

TEST(ChartKinds, WhatIsMissingIsSaidInOneSentence)
{
  const auto note = [](const char* kind, const std::string& table, const std::string& log)
  {
    for (const NamedTable& each : Tables())
    {
      if (each.Name == table)
      {
        auto chart = MakeChart(*pemesh::FindChartKind(kind), each.Table);
        chart->SetLogAxes(log);
        return chart->GetNote();
      }
    }
    return std::string();
  };
  EXPECT_EQ(note("scatter", "plain", "xy"), "");
  EXPECT_EQ(
    note("scatter", "negative", "y"), "Not drawn: 6 values not positive (logarithmic y axis).");
  EXPECT_EQ(note("scatter", "constant", ""), "All values of x are 3.");
  EXPECT_THAT(note("small-multiples", "constant", ""), HasSubstr("All values of a are 7."));
  EXPECT_EQ(note("scatter", "one row", ""), "");
  EXPECT_EQ(note("box", "infinite", ""), "Not drawn: 3 values infinite.");
  EXPECT_EQ(note("violin", "some undefined", ""), "Not drawn: 2 values undefined.");
  EXPECT_THAT(note("convergence", "negative", ""), HasSubstr("No order of \"a\""));
  EXPECT_THAT(note("correlation-matrix", "constant", ""),
    HasSubstr("No correlation with a column of one value or none: a, b."));
}

TEST(ChartKinds, TheTableIsComplete)
{
  for (const pemesh::ChartKind& kind : pemesh::ChartKinds())
  {
    EXPECT_EQ(pemesh::FindChartKind(kind.Name), &kind);
    EXPECT_NE(std::string(kind.Description), "");
    EXPECT_GT(kind.Aspect, 0.3);
    for (const std::string& option : kind.Options)
    {
      EXPECT_TRUE(pemesh::FindSetting(pemesh::ChartOptionFields(), option)) << option;
    }
    EXPECT_TRUE(pemesh::HasOption(kind, "x-min"));
  }
  EXPECT_EQ(pemesh::FindChartKind("pie"), nullptr);
  vtkNew<vtkPEMChart> chart;
  chart->SetTable(Tables()[0].Table);
  chart->SetYColumns({ "a" });
  chart->SetKindByName("scatter-matrix");
  EXPECT_EQ(chart->WhyNotDrawable(), "This kind of chart needs at least 2 columns, and has 1.");
}

TEST(ChartKinds, HistogramsCountEveryValueOnce)
{
  auto chart = MakeChart(*pemesh::FindChartKind("histogram"), Tables()[0].Table);
  chart->SetYColumns({ "a" });
  chart->SetOption("bins", "4");
  auto data = chart->MakeDataTable();
  // 1 4 | 9 | 16 | 25 between 1, 7, 13, 19, 25.
  const auto column = [&](const char* name, int row)
  { return data->GetValueByName(row, name).ToDouble(); };
  ASSERT_EQ(data->GetNumberOfRows(), 4);
  const double counts[] = { 2, 1, 1, 1 };
  for (int bin = 0; bin < 4; ++bin)
  {
    EXPECT_EQ(column("Points", bin), counts[bin]);
    EXPECT_DOUBLE_EQ(column("X", bin), 1.0 + 6.0 * bin);
    EXPECT_DOUBLE_EQ(column("XTo", bin), 7.0 + 6.0 * bin);
    EXPECT_EQ(column("YTo", bin), counts[bin]);
  }
}

TEST(ChartKinds, BarsArePickedAndStandForTheirRows)
{
  auto chart = MakeChart(*pemesh::FindChartKind("histogram"), Tables()[0].Table);
  chart->SetYColumns({ "a" });
  chart->SetOption("bins", "4");
  PaintedPixels(chart);
  const pemesh::ChartPick pick = chart->Pick(chart->GetDeviceX(4.0), chart->GetDeviceY(1.5));
  EXPECT_EQ(pick.What, pemesh::ChartPick::Kind::Area);
  EXPECT_EQ(pick.Text, "2 values from 1 to 7");
  EXPECT_THAT(chart->SelectRectangle(chart->GetDeviceX(3.0), chart->GetDeviceY(0.5),
                chart->GetDeviceX(8.0), chart->GetDeviceY(0.7)),
    testing::ElementsAre(0, 1, 2));
}

TEST(ChartKinds, ConvergenceSaysTheOrderBetweenTheGivenSizes)
{
  std::vector<double> h;
  std::vector<double> error;
  for (int i = 0; i < 6; ++i)
  {
    h.push_back(std::pow(0.5, i));
    error.push_back(i < 2 ? 1.0 : 3.0 * h.back() * h.back()); // of order 2 once it is fine
  }
  vtkNew<vtkPEMChart> chart;
  chart->SetTable(ChartSupport::MakeTable({ { "h", h }, { "error", error } }));
  chart->SetKindByName("convergence");
  chart->SetXColumn("h");
  chart->AddYColumn("error", "L2 error");
  chart->SetOption("slope-to", "0.3");
  EXPECT_EQ(chart->MakeDataTable()->GetValueByName(0, "Series").ToString(), "L2 error: order 2.00");
  chart->SetOption("slope-to", "nan");
  EXPECT_NE(chart->MakeDataTable()->GetValueByName(0, "Series").ToString(), "L2 error: order 2.00");
}

/** A line through meshes in no order would go to and fro. */
TEST(ChartKinds, ConvergenceJoinsOnlyARefinement)
{
  for (const bool isOrdered : { true, false })
  {
    const std::vector<double> h = { 0.4, isOrdered ? 0.2 : 0.05, 0.1 };
    vtkNew<vtkPEMChart> chart;
    chart->SetTable(ChartSupport::MakeTable({ { "h", h }, { "e", { 0.16, 0.04, 0.01 } } }));
    chart->SetKindByName("convergence");
    chart->SetXColumn("h");
    chart->AddYColumn("e");
    chart->SetOption("slopes", "false");
    PaintedPixels(chart);
    const double x = 0.5 * (chart->GetDeviceX(h[0]) + chart->GetDeviceX(h[1]));
    const double y = 0.5 * (chart->GetDeviceY(0.16) + chart->GetDeviceY(0.04));
    EXPECT_EQ(static_cast<bool>(chart->Pick(x, y)), isOrdered);
  }
}

TEST(ChartKinds, WhatHasNoColourIsSaid)
{
  const double infinity = std::numeric_limits<double>::infinity();
  vtkNew<vtkPEMChart> chart;
  chart->SetTable(ChartSupport::MakeTable({ { "x", { 1, 2, 3, 4 } }, { "y", { 1, 2, 3, 4 } },
    { "c", { 1, infinity, std::nan(""), -5 } } }));
  chart->SetKindByName("scatter");
  chart->SetXColumn("x");
  chart->AddYColumn("y");
  chart->SetColorColumn("c");
  EXPECT_THAT(chart->GetNote(), HasSubstr("Grey: 2 values of c undefined or infinite."));
  chart->LogColorOn();
  EXPECT_THAT(chart->GetNote(), HasSubstr("Grey: 3 values of c"));
}

TEST(ChartKinds, ManySmallMultiplesAskForMoreHeight)
{
  vtkNew<vtkPEMChart> chart;
  chart->SetTable(ChartSupport::MakeTable({ { "x", { 1, 2 } }, { "y", { 3, 4 } } }));
  chart->SetKindByName("small-multiples");
  chart->SetXColumn("x");
  chart->AddYColumn("y");
  const double ofOne = chart->GetPreferredAspect();
  for (int i = 0; i < 8; ++i)
  {
    chart->AddYColumn("y");
  }
  EXPECT_GT(chart->GetPreferredAspect(), ofOne + 0.2);
}

TEST(ChartKinds, DistributionsOfOneValueSaySo)
{
  for (const char* kind : { "histogram", "box", "violin" })
  {
    vtkNew<vtkPEMChart> chart;
    chart->SetTable(ChartSupport::MakeTable({ { "y", { 3.5, 3.5, std::nan("") } } }));
    chart->SetKindByName(kind);
    chart->AddYColumn("y");
    EXPECT_THAT(chart->GetNote(), HasSubstr("All values of y are 3.5.")) << kind;
  }
}

TEST(ChartKinds, FitsAreNamedWithTheirNumbers)
{
  std::vector<double> x = { 1, 2, 4, 8 };
  std::vector<double> y;
  for (const double value : x)
  {
    y.push_back(2.5 * std::pow(value, -1.9));
  }
  vtkNew<vtkPEMChart> chart;
  chart->SetTable(ChartSupport::MakeTable({ { "x", x }, { "y", y } }));
  chart->SetKindByName("scatter");
  chart->SetXColumn("x");
  chart->AddYColumn("y");
  chart->SetOption("fit", "best");
  auto data = chart->MakeDataTable();
  EXPECT_EQ(data->GetValueByName(data->GetNumberOfRows() - 1, "Series").ToString(),
    "fit: y = 2.5 x^−1.9, R² = 1");
  EXPECT_EQ(chart->SetOption("fit", "cubic"),
    "The setting fit is \"cubic\"; it must be one of none, linear, power, exponential, best; the "
    "nearest is \"none\".");
  EXPECT_THAT(chart->SetOption("fits", "best"), HasSubstr("nearest is \"fit\""));
}

TEST(ChartKinds, CorrelationsAreOrderedByStrength)
{
  vtkNew<vtkPEMChart> chart;
  chart->SetTable(ChartSupport::MakeTable({ { "noise", { 3, 1, 4, 1, 5 } },
    { "up", { 1, 2, 3, 4, 5 } }, { "down", { 9, 7, 5, 3, 2 } } }));
  chart->SetKindByName("correlation-matrix");
  chart->SetYColumns({ "noise", "up", "down" });
  auto data = chart->MakeDataTable();
  ASSERT_EQ(data->GetNumberOfRows(), 9);
  EXPECT_EQ(data->GetValueByName(1, "Series").ToString(), "up and down: −1");
  EXPECT_EQ(data->GetValueByName(1, "Value").ToDouble(), -1.0);
  chart->SetXColumn("noise"); // leads when asked for
  EXPECT_THAT(
    chart->MakeDataTable()->GetValueByName(0, "Series").ToString(), HasSubstr("noise and noise"));
}

} // namespace
