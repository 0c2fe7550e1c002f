// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementTableModel.h"
#include "MeshCanvas.h"
#include "RenderWidget.h"
#include "StudioSupport.h"
#include "SurfaceMesh.h"
#include "SurfacePicture.h"
#include "SurfaceWindow.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QTableView>
#include <QTest>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <set>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

using namespace pemesh;
using studio_test::WaitFor;

namespace
{

/** n by n squares with a cell array "Area" and the point arrays of a solution and a truth. */
vtkSmartPointer<vtkPolyData> MakeSquares(vtkIdType n)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  vtkNew<vtkDoubleArray> solution;
  solution->SetName("vem_Solution");
  for (vtkIdType i = 0; i <= n; ++i)
  {
    for (vtkIdType j = 0; j <= n; ++j)
    {
      const double x = static_cast<double>(j) / static_cast<double>(n);
      const double y = static_cast<double>(i) / static_cast<double>(n);
      points->InsertNextPoint(x, y, 0.0);
      solution->InsertNextValue(std::sin(6.0 * x) * std::cos(5.0 * y));
    }
  }
  vtkNew<vtkCellArray> squares;
  vtkNew<vtkDoubleArray> area;
  area->SetName("Area");
  for (vtkIdType i = 0; i < n; ++i)
  {
    for (vtkIdType j = 0; j < n; ++j)
    {
      const vtkIdType first = i * (n + 1) + j;
      const vtkIdType corners[4] = { first, first + 1, first + n + 2, first + n + 1 };
      squares->InsertNextCell(4, corners);
      area->InsertNextValue(static_cast<double>(i + j));
    }
  }
  vtkNew<vtkDoubleArray> truth;
  truth->DeepCopy(solution);
  truth->SetName("vem_GroundTruth");
  mesh->SetPoints(points);
  mesh->SetPolys(squares);
  mesh->GetCellData()->AddArray(area);
  mesh->GetPointData()->AddArray(solution);
  mesh->GetPointData()->AddArray(truth);
  return mesh;
}

int CountColors(const QImage& image)
{
  std::set<QRgb> colors;
  for (int y = 0; y < image.height(); y += 3)
  {
    for (int x = 0; x < image.width(); x += 3)
    {
      colors.insert(image.pixel(x, y));
    }
  }
  return static_cast<int>(colors.size());
}

} // namespace

TEST(MeshPicture, FindsTheElementAtAPointAndTheExtremes)
{
  const MeshPicture picture(MakeSquares(10));
  EXPECT_EQ(picture.FindElement({ 0.05, 0.05 }), 0);
  EXPECT_EQ(picture.FindElement({ 0.95, 0.05 }), 9);
  EXPECT_EQ(picture.FindElement({ 0.05, 0.95 }), 90);
  EXPECT_EQ(picture.FindElement({ 1.05, 0.5 }), -1);
  const MeshPicture::Extremes extremes = picture.FindExtremes("Area");
  EXPECT_EQ(extremes.Elements[0], 0);
  EXPECT_EQ(extremes.Elements[1], 99);
  EXPECT_EQ(extremes.Values[1], 18.0);
  EXPECT_TRUE(std::isnan(picture.GetValue("Nothing", 0)));
}

TEST(MeshPicture, AMillionElementsAreShownWhileTheWindowAnswers)
{
  const auto picture = std::make_shared<const MeshPicture>(MakeSquares(1000));
  MeshCanvas canvas;
  canvas.resize(900, 700);
  canvas.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas));
  const double range[2] = { 0.0, 0.0 };
  studio_test::Watchdog watchdog;
  QElapsedTimer clock;
  clock.start();
  canvas.SetPicture(picture);
  canvas.SetColors("Area", "area", range, false);
  for (int i = 0; i < 20; ++i)
  {
    PlaneTransform transform = canvas.GetTransform();
    transform.Origin += QPointF(1.0, 0.5);
    canvas.SetTransform(transform);
    QTest::qWait(10);
  }
  ASSERT_TRUE(WaitFor([&canvas] { return CountColors(canvas.grab().toImage()) > 60; }, 60000));
  std::printf("a million elements: seen after %lld ms, %s\n",
    static_cast<long long>(clock.elapsed()), watchdog.Describe().c_str());
}

TEST(SurfaceMesh, TrianglesOfConcaveElementsAddUpToTheirArea)
{
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Height");
  vtkNew<vtkCellArray> elements;
  elements->InsertNextCell(5); // a square with a notch of a quarter
  const double corners[5][2] = { { 0, 0 }, { 1, 0 }, { 0.5, 0.5 }, { 1, 1 }, { 0, 1 } };
  for (int i = 0; i < 5; ++i)
  {
    elements->InsertCellPoint(points->InsertNextPoint(corners[i][0], corners[i][1], 0.0));
    values->InsertNextValue(i);
  }
  mesh->SetPoints(points);
  mesh->SetPolys(elements);
  mesh->GetPointData()->AddArray(values);
  const std::atomic<bool> stop{ false };
  const MeshPicture picture(mesh);
  const SurfaceShape shape = MakeSurfaceShape(picture, stop);
  const SurfaceField field = MakeSurfaceField(picture, "Height");
  EXPECT_EQ(field.Range[1], 4.0);
  const vtkSmartPointer<vtkPolyData> data = MakeSurfaceData(shape, field);
  ASSERT_EQ(data->GetNumberOfCells(), 3);
  double area = 0.0;
  for (vtkIdType i = 0; i < 3; ++i)
  {
    vtkNew<vtkIdList> ids;
    data->GetCellPoints(i, ids);
    double p[3][3];
    for (int j = 0; j < 3; ++j)
    {
      data->GetPoint(ids->GetId(j), p[j]);
      EXPECT_EQ(p[j][2], static_cast<double>(ids->GetId(j)));
    }
    area +=
      0.5 * ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]));
  }
  EXPECT_DOUBLE_EQ(area, 0.75);
  EXPECT_TRUE(MakeSurfaceField(picture, "Nothing").Values.empty());
}

namespace
{

/** From straight above: the square from -1 to 1 fills the image. */
SurfaceView FromAbove(int size)
{
  SurfaceView view;
  view.Matrix = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1 };
  view.Light = { 0.0, 0.0, 1.0 };
  view.ZScale = 0.1;
  view.Size = { size, size };
  for (int i = 0; i < 256; ++i)
  {
    view.Colors.push_back(qRgb(i, 0, 255 - i));
  }
  return view;
}

} // namespace

TEST(SurfacePicture, TheNearestOfSeveralIsSeenInTheColourOfItsValue)
{
  // A square at height 0, and a triangle above the half of it that lies to the right.
  const SurfaceShape shape{ { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 }, { 0, -1 }, { 1, -1 },
                              { 1, 1 } },
    { { 4, 5, 6 }, { 0, 1, 2 }, { 0, 2, 3 } } };
  const SurfaceField field{ { 0, 0, 0, 0, 1, 1, 1 }, { 0.0, 1.0 } };
  const std::atomic<bool> stop{ false };
  const QImage image = PaintSurface(shape, field, FromAbove(40), stop);
  EXPECT_EQ(image.pixelColor(38, 30), QColor(255, 0, 0)) << "the triangle, seen first or last";
  EXPECT_EQ(image.pixelColor(3, 3), QColor(0, 0, 255));
  EXPECT_EQ(image.pixelColor(22, 3), QColor(0, 0, 255)) << "beside the long edge";
}

TEST(SurfacePicture, SmallTrianglesLeaveNoHoles)
{
  const MeshPicture picture(MakeSquares(300));
  const std::atomic<bool> stop{ false };
  SurfaceView view = FromAbove(211); // pixels and elements do not fit
  view.Matrix = { 2, 0, 0, -1, 0, 2, 0, -1, 0, 0, -1, 0, 0, 0, 0, 1 };
  const QImage image = PaintSurface(
    MakeSurfaceShape(picture, stop), MakeSurfaceField(picture, "vem_Solution"), view, stop);
  for (int y = 0; y < image.height(); ++y)
  {
    for (int x = 0; x < image.width(); ++x)
    {
      ASSERT_EQ(qAlpha(image.pixel(x, y)), 255) << x << " " << y;
    }
  }
}

TEST(SurfacePicture, WhatIsBehindTheCameraOrUndefinedDoesNoHarm)
{
  const SurfaceShape shape{ { { -1, -1 }, { 1, -1 }, { 1, 1 } }, { { 0, 1, 2 } } };
  const std::atomic<bool> stop{ false };
  SurfaceView view = FromAbove(10);
  const SurfaceField undefined{ { NAN, NAN, NAN }, { 0.0, 0.0 } };
  EXPECT_EQ(PaintSurface(shape, undefined, view, stop).pixelColor(8, 8), QColor(128, 128, 128));
  view.Matrix[15] = -1.0;
  EXPECT_EQ(qAlpha(PaintSurface(shape, undefined, view, stop).pixel(8, 8)), 0);
}

TEST(LargeElementTable, AMillionElementsAreSortedWhileTheWindowAnswers)
{
  const auto picture = std::make_shared<const MeshPicture>(MakeSquares(1000));
  ElementTableModel model;
  QTableView table;
  table.setModel(&model);
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&table));
  int sorted = 0;
  QObject::connect(&model, &ElementTableModel::Sorted, &model, [&sorted] { ++sorted; });
  studio_test::Watchdog watchdog;
  model.SetPicture(picture);
  model.sort(model.FindColumn("Area"), Qt::DescendingOrder);
  ASSERT_TRUE(WaitFor([&sorted] { return sorted == 1; }));
  EXPECT_EQ(model.GetElement(0), 999999) << "the largest value first";
  table.selectRow(0);
  model.sort(model.FindColumn("Area"), Qt::AscendingOrder);
  ASSERT_TRUE(WaitFor([&sorted] { return sorted == 2; }));
  EXPECT_EQ(table.currentIndex().row(), 999999) << "it stays with its element";
  std::printf("a table of a million elements: %s\n", watchdog.Describe().c_str());
}

namespace
{

/** Shows squares, waits until all are drawn and says how long that took. */
void ShowSquares(SurfaceWindow& window, vtkIdType n)
{
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  ASSERT_TRUE(window.GetView()->isValid()) << "no OpenGL 3.2";
  const auto picture = std::make_shared<const MeshPicture>(MakeSquares(n));
  studio_test::Watchdog watchdog;
  window.SetMesh(picture, "vem");
  ASSERT_TRUE(WaitFor([&window] { return window.IsComplete(); }, 120000));
  EXPECT_GT(CountColors(window.GrabView()), 100);
  const std::string first = watchdog.Describe();
  watchdog.Restart();
  const std::clock_t before = std::clock();
  window.BeginFrame();
  ASSERT_TRUE(WaitFor([&window] { return window.IsComplete(); }, 120000));
  const auto work = 1000 * (std::clock() - before) / CLOCKS_PER_SEC;
  std::printf("surfaces of %lld elements: %s; then a picture of %lld ms "
              "(%lld ms of processors), %s\n",
    static_cast<long long>(n * n), first.c_str(), static_cast<long long>(window.GetFrameTime()),
    static_cast<long long>(work), watchdog.Describe().c_str());
}

/** Without the scale. */
QImage SidesOf(const SurfaceWindow& window)
{
  const QImage image = window.GrabView();
  return image.copy(0, 0, image.width() * 8 / 10, image.height());
}

} // namespace

TEST(SurfaceWindow, ShowsLargeSolutionsThatTheMouseTurns)
{
  SurfaceWindow window;
  ShowSquares(window, 300);
  const QImage before = window.GrabView();
  studio_test::Keep(&window, "surfaces");
  const QPoint middle = window.GetView()->rect().center() - QPoint(200, 0);
  QTest::mousePress(window.GetView(), Qt::LeftButton, {}, middle);
  QTest::mouseMove(window.GetView(), middle + QPoint(60, 20));
  QTest::qWait(50);
  EXPECT_FALSE(window.IsComplete());
  EXPECT_LT(CountColors(SidesOf(window)), 10) << "an outline while it moves";
  QTest::mouseMove(window.GetView(), middle + QPoint(90, 30));
  QTest::mouseRelease(window.GetView(), Qt::LeftButton, {}, middle + QPoint(90, 30));
  ASSERT_TRUE(WaitFor([&window] { return window.IsComplete(); }));
  const QImage after = window.GrabView();
  EXPECT_NE(after, before) << "the mouse turns the camera";
  EXPECT_GT(CountColors(SidesOf(window)), 100);
  window.BeginFrame();
  ASSERT_TRUE(WaitFor([&window] { return window.IsComplete(); }));
  EXPECT_EQ(window.GrabView(), after) << "whatever was painted before";
}

TEST(SurfaceWindow, AMillionElementsAreDrawnWhileTheWindowAnswers)
{
  SurfaceWindow window;
  ShowSquares(window, 1000);
}
