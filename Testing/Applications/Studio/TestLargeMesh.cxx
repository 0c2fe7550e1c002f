// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementTableModel.h"
#include "MeshCanvas.h"
#include "RenderWidget.h"
#include "StudioSupport.h"
#include "SurfaceMesh.h"
#include "SurfaceWindow.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QTableView>
#include <QTest>

#include <cmath>
#include <cstdio>
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
  std::printf("a million elements: seen after %lld ms, longest stall %lld ms\n",
    static_cast<long long>(clock.elapsed()), static_cast<long long>(watchdog.GetLongestStall()));
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
  const SurfaceMesh surface = MakeSurface(MeshPicture(mesh), "Height", stop);
  ASSERT_EQ(surface.Blocks.size(), 1U);
  EXPECT_EQ(surface.Range[1], 4.0);
  vtkPolyData* block = surface.Blocks[0];
  ASSERT_EQ(block->GetNumberOfCells(), 3);
  double area = 0.0;
  for (vtkIdType i = 0; i < 3; ++i)
  {
    vtkNew<vtkIdList> ids;
    block->GetCellPoints(i, ids);
    double p[3][3];
    for (int j = 0; j < 3; ++j)
    {
      block->GetPoint(ids->GetId(j), p[j]);
      EXPECT_EQ(p[j][2], static_cast<double>(ids->GetId(j)));
    }
    area +=
      0.5 * ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]));
  }
  EXPECT_DOUBLE_EQ(area, 0.75);
  EXPECT_TRUE(MakeSurface(MeshPicture(mesh), "Nothing", stop).Blocks.empty());
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
  std::printf("a table of a million elements: longest stall %lld ms\n",
    static_cast<long long>(watchdog.GetLongestStall()));
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
  EXPECT_GT(CountColors(window.GetView()->grabFramebuffer()), 100);
  const qint64 first = watchdog.GetLongestStall();
  watchdog.Restart();
  window.BeginFrame();
  ASSERT_TRUE(WaitFor([&window] { return window.IsComplete(); }, 120000));
  std::printf("surfaces of %lld elements: longest stall %lld ms, then %lld ms in a picture of "
              "%lld ms\n",
    static_cast<long long>(n * n), static_cast<long long>(first),
    static_cast<long long>(watchdog.GetLongestStall()),
    static_cast<long long>(window.GetFrameTime()));
}

/** Without the scale. */
QImage SidesOf(const SurfaceWindow& window)
{
  const QImage image = window.GetView()->grabFramebuffer();
  return image.copy(0, 0, image.width() * 8 / 10, image.height());
}

} // namespace

TEST(SurfaceWindow, ShowsLargeSolutionsInBlocksThatTheMouseTurns)
{
  SurfaceWindow window;
  ShowSquares(window, 300);
  const QImage before = window.GetView()->grabFramebuffer();
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
  const QImage after = window.GetView()->grabFramebuffer();
  EXPECT_NE(after, before) << "the mouse turns the camera";
  EXPECT_GT(CountColors(SidesOf(window)), 100);
  window.BeginFrame();
  ASSERT_TRUE(WaitFor([&window] { return window.IsComplete(); }));
  EXPECT_EQ(window.GetView()->grabFramebuffer(), after) << "whatever blocks come in a turn";
}

TEST(SurfaceWindow, AMillionElementsAreDrawnWhileTheWindowAnswers)
{
  SurfaceWindow window;
  ShowSquares(window, 1000);
}
