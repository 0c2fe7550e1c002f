// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartSupport.h"
#include "vtkPEMChart.h"
#include "vtkPEMFigure.h"

#include <vtkNew.h>
#include <vtkStringArray.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace
{

using testing::HasSubstr;

constexpr double UnitsAPoint = 20.0; // of vtkPEMFigure

/** Writes a PNG and reads it back; the chart then knows where its points are. */
ChartSupport::Picture Paint(vtkPEMChart* chart, const std::string& name)
{
  vtkNew<vtkPEMFigure> figure;
  figure->AddPanel(chart);
  const std::string path = pemesh::TestPath(name + ".png");
  EXPECT_TRUE(figure->Write(path)) << figure->GetErrorMessage();
  return ChartSupport::ReadPng(path);
}

/** The colour of the picture at a point of the chart. */
std::array<unsigned char, 3> ColorAt(
  const ChartSupport::Picture& picture, const vtkPEMChart* chart, double x, double y)
{
  const double pixels = 300.0 / 72.0 / UnitsAPoint;
  return picture.At(static_cast<int>(chart->GetDeviceX(x) * pixels),
    picture.Height - 1 - static_cast<int>(chart->GetDeviceY(y) * pixels));
}

constexpr std::array<unsigned char, 3> Blue = { 0x00, 0x72, 0xB2 };
constexpr std::array<unsigned char, 3> Vermilion = { 0xD5, 0x5E, 0x00 };
constexpr std::array<unsigned char, 3> White = { 255, 255, 255 };

TEST(Chart, MarkersStandAtTheirPoints)
{
  auto table = ChartSupport::MakeTable(
    { { "x", { 0.13, 1.07, 2.21 } }, { "a", { 1.1, 5.3, 2.7 } }, { "b", { 4.4, 0.3, 5.1 } } });
  vtkNew<vtkPEMChart> chart;
  chart->SetTable(table);
  chart->SetKindByName("scatter");
  chart->SetXColumn("x");
  chart->SetYColumns({ "a", "b" });
  const auto picture = Paint(chart, "Markers");
  EXPECT_EQ(ColorAt(picture, chart, 1.07, 5.3), Blue);
  EXPECT_EQ(ColorAt(picture, chart, 2.21, 2.7), Blue);
  EXPECT_EQ(ColorAt(picture, chart, 0.13, 4.4), Vermilion);
  EXPECT_EQ(ColorAt(picture, chart, 1.6, 4.1), White); // nothing between the points
}

TEST(Chart, LogarithmicAxesPutPowersAtEqualDistances)
{
  auto table =
    ChartSupport::MakeTable({ { "x", { 1e-6, 1e-3, 1.0 } }, { "y", { 1e2, 1e9, 1e16 } } });
  vtkNew<vtkPEMChart> chart;
  chart->SetTable(table);
  chart->SetXColumn("x");
  chart->AddYColumn("y");
  ASSERT_TRUE(chart->SetLogAxes("xy"));
  const auto picture = Paint(chart, "Logarithmic");
  EXPECT_NEAR(chart->GetDeviceX(1e-3) - chart->GetDeviceX(1e-6),
    chart->GetDeviceX(1.0) - chart->GetDeviceX(1e-3), 1e-6);
  EXPECT_EQ(ColorAt(picture, chart, 1e-3, 1e9), Blue);
  // The line through three points in line: in the middle between two of them.
  EXPECT_EQ(ColorAt(picture, chart, std::pow(10.0, -1.5), std::pow(10.0, 12.5)), Blue);
  EXPECT_FALSE(chart->SetLogAxes("z"));
}

TEST(Chart, NaNIsAGap)
{
  const double nan = std::nan("");
  auto table =
    ChartSupport::MakeTable({ { "x", { 0, 1, 2, 3, 4 } }, { "y", { 1, 2, nan, 4, 5 } } });
  vtkNew<vtkPEMChart> chart;
  chart->SetTable(table);
  chart->SetXColumn("x");
  chart->AddYColumn("y");
  const auto picture = Paint(chart, "Gap");
  EXPECT_EQ(ColorAt(picture, chart, 0.5, 1.5), Blue);
  EXPECT_EQ(ColorAt(picture, chart, 3.5, 4.5), Blue);
  EXPECT_NE(ColorAt(picture, chart, 1.5, 2.5), Blue);
  EXPECT_EQ(chart->GetNote(), "Not drawn: 1 value undefined.");
}

TEST(Chart, ValuesThatAreNotPositiveAreLeftOutAndTold)
{
  auto table = ChartSupport::MakeTable({ { "x", { 1, 2, 3, 4 } }, { "y", { 0, -1, 10, 100 } } });
  vtkNew<vtkPEMChart> chart;
  chart->SetTable(table);
  chart->SetXColumn("x");
  chart->AddYColumn("y");
  EXPECT_EQ(chart->GetNote(), "");
  chart->LogYOn();
  EXPECT_EQ(chart->GetNote(), "Not drawn: 2 values not positive (logarithmic y axis).");
  const auto picture = Paint(chart, "NotPositive");
  EXPECT_EQ(ColorAt(picture, chart, 3, 10), Blue);
}

TEST(Chart, DegenerateDataHaveRanges)
{
  auto table = ChartSupport::MakeTable({ { "one", { 5.0 } }, { "zero", { 0.0 } },
    { "huge", { 1e308 } }, { "tiny", { 1e-310 } }, { "nan", { std::nan("") } } });
  for (const char* x : { "one", "zero", "huge", "tiny", "nan" })
  {
    for (const char* y : { "one", "zero", "huge", "tiny", "nan" })
    {
      for (const char* axes : { "", "xy" })
      {
        vtkNew<vtkPEMChart> chart;
        chart->SetTable(table);
        chart->SetXColumn(x);
        chart->AddYColumn(y);
        chart->SetLogAxes(axes);
        EXPECT_EQ(chart->WhyNotDrawable(), "");
        vtkNew<vtkPEMFigure> figure;
        figure->SetDPI(72);
        figure->AddPanel(chart);
        EXPECT_TRUE(figure->Write(pemesh::TestPath("Degenerate.png"))) << x << y << axes;
        EXPECT_TRUE(std::isfinite(chart->GetDeviceX(1.0))) << x << y << axes;
      }
    }
  }
}

TEST(Chart, AnEmptyTableIsDrawnEmpty)
{
  vtkNew<vtkPEMChart> chart;
  chart->SetTable(ChartSupport::MakeTable({ { "x", {} }, { "y", {} } }));
  chart->SetXColumn("x");
  chart->AddYColumn("y");
  EXPECT_GT(Paint(chart, "Empty").Width, 0);
}

TEST(Chart, BandsAreFilledBetweenTheirColumns)
{
  auto table = ChartSupport::MakeTable({ { "t", { 0, 1, 2 } }, { "low", { 0, 0, 0 } },
    { "high", { 10, 10, 10 } }, { "mean", { 4, 4, 4 } } });
  vtkNew<vtkPEMChart> chart;
  chart->SetTable(table);
  chart->SetXColumn("t");
  chart->AddBand("low", "high", "mean", "range and mean");
  const auto picture = Paint(chart, "Band");
  EXPECT_EQ(ColorAt(picture, chart, 0.5, 4), Blue);
  const auto pale = ColorAt(picture, chart, 0.7, 7.3);
  EXPECT_NE(pale, White);
  EXPECT_GT(pale[2], pale[0]);
  EXPECT_EQ(ColorAt(picture, chart, 0.7, 10.2), White);
}

TEST(Chart, ColoursFollowAColumn)
{
  auto table =
    ChartSupport::MakeTable({ { "x", { 0, 1, 2 } }, { "y", { 0, 1, 2 } }, { "c", { 5, 7, 9 } } });
  vtkNew<vtkPEMChart> chart;
  chart->SetTable(table);
  chart->SetKindByName("scatter");
  chart->SetXColumn("x");
  chart->AddYColumn("y");
  chart->SetColorColumn("c");
  auto picture = Paint(chart, "Coloured");
  const std::array<unsigned char, 3> purple = { 0x44, 0x01, 0x54 };
  const std::array<unsigned char, 3> yellow = { 0xFD, 0xE7, 0x25 };
  EXPECT_EQ(ColorAt(picture, chart, 0, 0), purple);
  EXPECT_EQ(ColorAt(picture, chart, 2, 2), yellow);

  vtkNew<vtkStringArray> classes;
  classes->SetName("family");
  for (const char* name : { "comb", "star", "comb" })
  {
    classes->InsertNextValue(name);
  }
  table->AddColumn(classes);
  chart->SetColorColumn("family");
  picture = Paint(chart, "Classes");
  EXPECT_EQ(ColorAt(picture, chart, 0, 0), Blue);
  EXPECT_EQ(ColorAt(picture, chart, 1, 1), Vermilion);
  EXPECT_EQ(ColorAt(picture, chart, 2, 2), Blue);
}

TEST(Chart, ColumnsThatDoNotExistAreNamedWithTheNearest)
{
  auto table = ChartSupport::MakeTable({ { "MinAngle_min", { 1 } }, { "Area_min", { 1 } } });
  vtkNew<vtkStringArray> text;
  text->SetName("Mesh");
  text->InsertNextValue("one");
  table->AddColumn(text);
  vtkNew<vtkPEMChart> chart;
  EXPECT_EQ(chart->WhyNotDrawable(), "The chart has no table.");
  chart->SetTable(table);
  EXPECT_EQ(chart->WhyNotDrawable(), "The chart has no y column.");
  chart->AddYColumn("MinAngel_min");
  EXPECT_EQ(chart->WhyNotDrawable(),
    "The table has no column \"MinAngel_min\"; the nearest is \"MinAngle_min\".");
  chart->SetYColumns({ "Area_min" });
  chart->SetXColumn("Mesh");
  EXPECT_THAT(chart->WhyNotDrawable(), HasSubstr("\"Mesh\" holds text"));
  chart->SetXColumn("");
  EXPECT_EQ(chart->WhyNotDrawable(), "");
}

TEST(Chart, SettersModifyOnlyWhenSomethingChanges)
{
  vtkNew<vtkPEMChart> chart;
  chart->SetXTitle("angle");
  const auto time = chart->GetMTime();
  chart->SetXTitle("angle");
  chart->SetKind(vtkPEMChart::KIND_LINE);
  EXPECT_EQ(chart->GetMTime(), time);
  chart->SetKind(777);
  EXPECT_EQ(chart->GetKind(), static_cast<int>(vtkPEMChart::GetKindNames().size()) - 1);
  EXPECT_TRUE(chart->SetKindByName("scatter"));
  EXPECT_EQ(chart->GetKind(), vtkPEMChart::KIND_SCATTER);
  EXPECT_FALSE(chart->SetKindByName("pie"));
  std::ostringstream text;
  chart->Print(text);
  EXPECT_THAT(text.str(), HasSubstr("XTitle: angle"));
}

} // namespace
