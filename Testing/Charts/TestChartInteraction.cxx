// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartPick.h"
#include "ChartSupport.h"
#include "vtkPEMCairoContextDevice2D.h"
#include "vtkPEMChart.h"

#include <vtkCallbackCommand.h>
#include <vtkContext2D.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using pemesh::ChartPick;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/** Paints a panel alone, as a window would: one unit of the device is a pixel. */
ChartSupport::Picture Paint(vtkPEMPanel* panel, const std::string& name = "Interaction")
{
  vtkNew<vtkPEMCairoContextDevice2D> device;
  device->SetPageSize(600, 400);
  panel->SetRectangle(0, 0, 600, 400);
  panel->SetFontSize(12);
  device->Begin(nullptr);
  vtkNew<vtkContext2D> context;
  context->Begin(device);
  EXPECT_TRUE(panel->Paint(context));
  context->End();
  device->End();
  return ChartSupport::WriteAndRead(device->GetContents(), name + ".png");
}

vtkSmartPointer<vtkTable> MakeTable()
{
  auto table = ChartSupport::MakeTable(
    { { "t", { 0.0, 0.3, 0.6, 0.9 } }, { "a", { 1.0, 0.1 + 0.2, 0.7, 0.2 } },
      { "b", { 10.0, 90.0, 1e3, std::nan("") } }, { "Element", { 7, 8, 9, 11 } } });
  vtkNew<vtkStringArray> mesh;
  mesh->SetName("Mesh");
  for (const char* name : { "000", "001", "002", "003" })
  {
    mesh->InsertNextValue(name);
  }
  table->AddColumn(mesh);
  return table;
}

vtkSmartPointer<vtkPEMChart> MakeChart(const std::string& kind, const std::string& y)
{
  auto chart = vtkSmartPointer<vtkPEMChart>::New();
  chart->SetTable(MakeTable());
  chart->SetKindByName(kind);
  chart->SetXColumn("t");
  chart->AddYColumn(y);
  return chart;
}

TEST(ChartInteraction, APointIsPickedWithAllThatTheTableSaysOfIt)
{
  auto chart = MakeChart("scatter", "a");
  EXPECT_FALSE(chart->Pick(300, 200)); // not painted yet
  Paint(chart);
  const double x = chart->GetDeviceX(0.3);
  const double y = chart->GetDeviceY(0.3);
  const ChartPick pick = chart->Pick(x + 3, y - 2);
  ASSERT_EQ(pick.What, ChartPick::Kind::Point);
  EXPECT_EQ(pick.Row, 1);
  EXPECT_EQ(pick.Series, "a");
  EXPECT_EQ(pick.X, 0.3);
  EXPECT_EQ(pick.Y, 0.1 + 0.2); // to the last bit
  EXPECT_EQ(pick.Mesh, "001");
  EXPECT_EQ(pick.Element, 8);
  EXPECT_NEAR(pick.DeviceX, x, 1e-9);
  EXPECT_EQ(pick.Text, "mesh 001, element 8, a, t = 0.3, y = 0.3");
  EXPECT_FALSE(chart->Pick(x + 20, y));
  EXPECT_TRUE(chart->Pick(x + 20, y, 5.0));
  EXPECT_FALSE(chart->Pick(-5, 2000));
}

TEST(ChartInteraction, BetweenItsPointsTheLineIsPicked)
{
  auto chart = MakeChart("line", "b");
  chart->LogYOn();
  Paint(chart);
  // On a logarithmic axis the line is straight between the logarithms.
  const double middle = std::pow(10.0, 0.5 * (std::log10(90.0) + 3.0));
  const ChartPick pick = chart->Pick(chart->GetDeviceX(0.45), chart->GetDeviceY(middle) + 2);
  ASSERT_EQ(pick.What, ChartPick::Kind::Line);
  EXPECT_NEAR(pick.X, 0.45, 0.01);
  EXPECT_NEAR(std::log10(pick.Y), std::log10(middle), 0.02);
  // After the last defined row there is no line.
  EXPECT_FALSE(chart->Pick(chart->GetDeviceX(0.8), chart->GetDeviceY(1e3)));
}

TEST(ChartInteraction, RectanglesSelectTheRowsInThem)
{
  auto chart = MakeChart("scatter", "a");
  Paint(chart);
  const auto select = [&](double x0, double y0, double x1, double y1)
  {
    return chart->SelectRectangle(
      chart->GetDeviceX(x0), chart->GetDeviceY(y0), chart->GetDeviceX(x1), chart->GetDeviceY(y1));
  };
  EXPECT_THAT(select(0.2, 0.1, 0.95, 0.5), ElementsAre(1, 3));
  EXPECT_THAT(select(0.95, 0.5, 0.2, 0.1), ElementsAre(1, 3)); // from any corner
  EXPECT_THAT(select(0.1, 0.8, 0.2, 0.9), IsEmpty());
  EXPECT_THAT(select(-9, -9, 9, 9), ElementsAre(0, 1, 2, 3));
}

TEST(ChartInteraction, HighlightedRowsStandOutInEveryChartOverTheTable)
{
  for (const char* kind : { "scatter", "line" })
  {
    auto chart = MakeChart(kind, "a");
    const auto before = Paint(chart);
    chart->SetHighlightedRows({ 2, 99, 2 });
    EXPECT_THAT(chart->GetHighlightedRows(), ElementsAre(2, 99));
    const auto after = Paint(chart, std::string("Highlighted-") + kind);
    // A dark ring around the point, and nothing anywhere else.
    const int column = static_cast<int>(chart->GetDeviceX(0.6));
    const int row = 399 - static_cast<int>(chart->GetDeviceY(0.7));
    int near = 0;
    for (int y = 0; y < 400; ++y)
    {
      for (int x = 0; x < 600; ++x)
      {
        const bool differs = before.At(x, y) != after.At(x, y);
        const bool isNear = std::abs(x - column) < 12 && std::abs(y - row) < 12;
        near += differs && isNear ? 1 : 0;
        EXPECT_FALSE(differs && !isNear) << x << " " << y;
      }
    }
    EXPECT_GT(near, 20);
  }
}

TEST(ChartInteraction, ZoomKeepsThePointUnderTheMouse)
{
  auto chart = MakeChart("scatter", "b");
  chart->SetLogAxes("y");
  Paint(chart);
  double all[4];
  const double x = chart->GetDeviceX(0.3);
  const double y = chart->GetDeviceY(90.0);
  ASSERT_TRUE(chart->GetVisibleRange(x, y, all));
  EXPECT_FALSE(chart->IsZoomed());
  ASSERT_TRUE(chart->Zoom(x, y, 2.0));
  EXPECT_TRUE(chart->IsZoomed());
  double seen[4];
  ASSERT_TRUE(chart->GetVisibleRange(x, y, seen));
  EXPECT_NEAR(seen[1] - seen[0], 0.5 * (all[1] - all[0]), 1e-12);
  EXPECT_NEAR(std::log10(seen[3] / seen[2]), 0.5 * std::log10(all[3] / all[2]), 1e-12);
  // Before and after it is painted the point is where it was.
  EXPECT_EQ(chart->Pick(x, y).Row, 1);
  Paint(chart);
  EXPECT_NEAR(chart->GetDeviceX(0.3), x, 12.0); // other labels may need another margin
  EXPECT_THAT(chart->DescribeVisibleRange(x, y), HasSubstr("t from "));

  ASSERT_TRUE(chart->Pan(x, y, 10.0, 0.0));
  double moved[4];
  ASSERT_TRUE(chart->GetVisibleRange(x, y, moved));
  EXPECT_LT(moved[0], seen[0]);
  EXPECT_NEAR(moved[3], seen[3], 1e-9 * seen[3]);

  chart->ResetView();
  EXPECT_FALSE(chart->IsZoomed());
  double again[4];
  ASSERT_TRUE(chart->GetVisibleRange(x, y, again));
  EXPECT_EQ(again[0], all[0]);
  EXPECT_EQ(again[3], all[3]);
}

TEST(ChartInteraction, ZoomToARectangleShowsWhatIsInIt)
{
  auto chart = MakeChart("scatter", "a");
  Paint(chart);
  ASSERT_TRUE(chart->ZoomToRectangle(chart->GetDeviceX(0.7), chart->GetDeviceY(0.8),
    chart->GetDeviceX(0.2), chart->GetDeviceY(0.25)));
  double seen[4];
  ASSERT_TRUE(chart->GetVisibleRange(300, 200, seen));
  EXPECT_THAT(seen,
    ElementsAre(testing::DoubleNear(0.2, 1e-9), testing::DoubleNear(0.7, 1e-9),
      testing::DoubleNear(0.25, 1e-9), testing::DoubleNear(0.8, 1e-9)));
  Paint(chart);
  // What is not seen is neither picked nor selected.
  EXPECT_THAT(chart->SelectRectangle(0, 0, 600, 400), ElementsAre(1, 2));
  EXPECT_FALSE(chart->Pick(chart->GetDeviceX(0.9), chart->GetDeviceY(0.2)));
  // Zooming in without end stops before numbers run out.
  int steps = 0;
  while (chart->Zoom(300, 200, 10.0) && steps < 100)
  {
    ++steps;
  }
  EXPECT_GT(steps, 4);
  EXPECT_LT(steps, 15);
  Paint(chart);
}

TEST(ChartInteraction, WhatChangesThePictureSaysSo)
{
  auto chart = MakeChart("scatter", "a");
  Paint(chart);
  int events = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&events);
  counter->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  chart->AddObserver(vtkCommand::ModifiedEvent, counter);
  const auto count = [&](auto&& change)
  {
    events = 0;
    change();
    return events;
  };
  EXPECT_EQ(count([&] { chart->Zoom(300, 200, 2.0); }), 1);
  EXPECT_EQ(count([&] { chart->Pan(300, 200, 5.0, 5.0); }), 1);
  EXPECT_EQ(count([&] { chart->ResetView(); }), 1);
  EXPECT_EQ(count([&] { chart->ResetView(); }), 0);
  EXPECT_EQ(count([&] { chart->SetHighlightedRows({ 1 }); }), 1);
  EXPECT_EQ(count([&] { chart->SetHighlightedRows({ 1 }); }), 0);
  EXPECT_EQ(count([&] { chart->SetStyleByName("marker", "square"); }), 1);
  EXPECT_EQ(count([&] { chart->Pick(300, 200); }), 0);
  EXPECT_EQ(count([&] { chart->Zoom(1, 1, 2.0); }), 0); // outside of the axes
}

/** A million points are drawn as a density, and picked one by one all the same. */
TEST(ChartInteraction, PicksAreExactWhereManyPointsAreDrawnAsADensity)
{
  std::mt19937 random(7);
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i < 200000; ++i)
  {
    x.push_back(std::ldexp(static_cast<double>(random()), -32));
    y.push_back(std::ldexp(static_cast<double>(random()), -32));
  }
  vtkNew<vtkPEMChart> chart;
  chart->SetTable(ChartSupport::MakeTable({ { "x", x }, { "y", y } }));
  chart->SetKindByName("scatter");
  chart->SetXColumn("x");
  chart->AddYColumn("y");
  Paint(chart, "Density");
  for (const std::size_t row : { 0u, 17u, 123456u, 199999u })
  {
    // The nearest by brute force in the units of the device.
    const double px = chart->GetDeviceX(x[row]) + 0.2;
    const double py = chart->GetDeviceY(y[row]) - 0.1;
    std::size_t nearest = 0;
    double best = 1e300;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      const double distance =
        std::hypot(chart->GetDeviceX(x[i]) - px, chart->GetDeviceY(y[i]) - py);
      nearest = distance < best ? i : nearest;
      best = std::min(best, distance);
    }
    const ChartPick pick = chart->Pick(px, py);
    EXPECT_EQ(pick.Row, static_cast<vtkIdType>(nearest));
    EXPECT_EQ(pick.X, x[nearest]);
    EXPECT_EQ(pick.Y, y[nearest]);
  }
}

TEST(ChartInteraction, APanelInASceneMarksItAsDirty)
{
  auto chart = MakeChart("scatter", "a");
  vtkNew<vtkContextScene> scene;
  scene->AddItem(chart);
  Paint(chart);
  scene->SetDirty(false);
  chart->SetHighlightedRows({ 0 });
  EXPECT_TRUE(scene->GetDirty());
}

} // namespace
