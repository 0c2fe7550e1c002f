// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Appearance.h"
#include "CorrelationPage.h"
#include "FailureList.h"
#include "GeometryPage.h"
#include "LayoutCanvas.h"
#include "LogDock.h"
#include "MeshCanvas.h"
#include "MeshPage.h"
#include "MetricCharts.h"
#include "PanelView.h"
#include "ResultSet.h"
#include "RunController.h"
#include "Selection.h"
#include "SolverPage.h"
#include "StudioFixture.h"
#include "StudioSupport.h"
#include "StudioWindow.h"
#include "StudyModel.h"
#include "StudyPreview.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QListWidget>
#include <QMimeData>
#include <QProcess>
#include <QSlider>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>

using namespace pemesh;
using studio_test::Drag;
using studio_test::Keep;
using studio_test::Studio;
using studio_test::WaitFor;

namespace
{

QPoint OnCanvas(const LayoutCanvas* canvas, double x, double y)
{
  return canvas->GetTransform().ToScreen({ x, y }).toPoint();
}

/** In the colour of the first series; a point rather than the edge of one. */
QPoint FindLowestMark(const QImage& image)
{
  for (int y = image.height() - 1; y > 3; --y)
  {
    for (int x = 0; x < image.width(); ++x)
    {
      if (image.pixel(x, y) == qRgb(0, 114, 178))
      {
        return { x, y - 3 };
      }
    }
  }
  return {};
}

} // namespace

TEST_F(Studio, WhatIsAddedStaysSelectedWhenOutlinesOfBeforeComeIn)
{
  this->AddFamily("family-star");
  LayoutCanvas* canvas = this->Window.GetMeshPage()->GetCanvas();
  ASSERT_EQ(canvas->GetSelected(), 0);
  canvas->SetOutlines({});
  EXPECT_EQ(canvas->GetSelected(), 0);
  this->Window.GetModel()->GetUndoStack()->undo();
  canvas->SetOutlines({});
  EXPECT_EQ(canvas->GetSelected(), -1);
}

TEST_F(Studio, APolygonIsAddedMovedScaledAndTurnedWithTheMouse)
{
  StudyModel* model = this->Window.GetModel();
  LayoutCanvas* canvas = this->Window.GetMeshPage()->GetCanvas();
  Keep(&this->Window, "empty");
  this->AddFamily("family-star");
  ASSERT_EQ(model->GetStudy().Polygons.size(), 1U);
  ASSERT_TRUE(this->WaitForMesh());
  QTest::qWait(200);
  Drag(canvas, OnCanvas(canvas, 0.5, 0.5), OnCanvas(canvas, 0.3, 0.65));
  EXPECT_NEAR(model->GetStudy().Polygons[0].Center[0], 0.3, 0.01);
  EXPECT_NEAR(model->GetStudy().Polygons[0].Center[1], 0.65, 0.01);
  EXPECT_EQ(model->GetUndoStack()->count(), 2) << "a drag is one edit";
  ASSERT_TRUE(this->WaitForMesh());
  model->GetUndoStack()->undo();
  EXPECT_EQ(model->GetStudy().Polygons[0].Center[0], 0.5);
  model->GetUndoStack()->redo();
  QTest::qWait(200);
  this->AddFamily("family-comb");
  QTest::qWait(200);
  Drag(canvas, OnCanvas(canvas, 0.5, 0.5), OnCanvas(canvas, 0.7, 0.3));
  QTest::qWait(200);
  ASSERT_TRUE(this->WaitForMesh());
  EXPECT_TRUE(this->Window.GetPreview()->GetFault().isEmpty());
  Keep(&this->Window, "mesh");
}

TEST_F(Studio, AStrokeDrawnByHandBecomesAPolygon)
{
  LayoutCanvas* canvas = this->Window.GetMeshPage()->GetCanvas();
  canvas->SetTool(LayoutCanvas::Tool::Draw);
  constexpr int points = 120;
  for (int i = 0; i <= points; ++i)
  {
    const double angle = 6.2 * i / points;
    const QPoint at = OnCanvas(canvas, 0.5 + 0.25 * std::cos(angle), 0.5 + 0.2 * std::sin(angle));
    i == 0 ? QTest::mousePress(canvas, Qt::LeftButton, {}, at) : QTest::mouseMove(canvas, at);
    QTest::qWait(1);
  }
  QTest::mouseRelease(canvas, Qt::LeftButton);
  const auto& polygons = this->Window.GetModel()->GetStudy().Polygons;
  ASSERT_EQ(polygons.size(), 1U);
  EXPECT_EQ(polygons[0].Family, "points");
  EXPECT_GE(polygons[0].Points.size(), 8U);
  EXPECT_LE(polygons[0].Points.size(), 60U);
  ASSERT_TRUE(this->WaitForMesh());
  EXPECT_TRUE(this->Window.GetPreview()->GetFault().isEmpty())
    << this->Window.GetPreview()->GetFault().toStdString();
  Keep(&this->Window, "drawn");
  this->Window.GetModel()->GetUndoStack()->undo();
  EXPECT_TRUE(this->Window.GetModel()->GetStudy().Polygons.empty());
}

TEST_F(Studio, CornersThatAreClickedBecomeAPolygon)
{
  LayoutCanvas* canvas = this->Window.GetMeshPage()->GetCanvas();
  canvas->SetTool(LayoutCanvas::Tool::Draw);
  for (const auto& [x, y] : { std::pair(0.2, 0.2), { 0.8, 0.2 }, { 0.8, 0.8 }, { 0.5, 0.4 } })
  {
    QTest::mouseClick(canvas, Qt::LeftButton, {}, OnCanvas(canvas, x, y));
  }
  QTest::keyClick(canvas, Qt::Key_Return);
  const auto& polygons = this->Window.GetModel()->GetStudy().Polygons;
  ASSERT_EQ(polygons.size(), 1U);
  EXPECT_EQ(polygons[0].Points.size(), 4U);
}

TEST_F(Studio, MeshesThatAreDroppedAreAStudyOfFiles)
{
  QMimeData data;
  data.setUrls({ QUrl::fromLocalFile(PEMESH_TEST_DATA "/Meshes/vem_quality_2d/Jenga1.off"),
    QUrl::fromLocalFile(PEMESH_TEST_DATA "/Meshes/vem_quality_2d/Jenga2.off") });
  QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&this->Window, &enter);
  QDropEvent drop(
    QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier, QEvent::Drop);
  QApplication::sendEvent(&this->Window, &drop);
  EXPECT_EQ(this->Window.GetModel()->GetStudy().Meshes.size(), 2U);
  ASSERT_TRUE(this->WaitForMesh());
  EXPECT_EQ(this->Window.GetPreview()->GetNumberOfCases(), 2);
  auto* slider = this->Window.GetMeshPage()->findChild<QSlider*>("timeSlider");
  const auto first = this->Window.GetPreview()->GetPicture()->GetNumberOfElements();
  slider->setValue(1);
  ASSERT_TRUE(WaitFor(
    [&] { return this->Window.GetPreview()->GetPicture()->GetNumberOfElements() != first; }));
  Keep(&this->Window, "files");
}

TEST_F(Studio, TheWindowStaysAliveWhileTheSliderMovesAndTheMeshIsMade)
{
  this->AddFamily("family-maze");
  this->Window.GetModel()->SetValue("mesh.max-area",
    { JsonValue::Object{ { "rule", { std::string("constant") } }, { "value", JsonNumber(2e-5) } } },
    "area");
  auto* slider = this->Window.GetMeshPage()->findChild<QSlider*>("timeSlider");
  QTest::qWait(300);
  studio_test::Watchdog watchdog;
  for (int i = 0; i < 40; ++i)
  {
    slider->setValue(500 + 5 * i);
    QTest::qWait(10);
  }
  ASSERT_TRUE(this->WaitForMesh());
  RecordProperty("longest-stall-milliseconds", static_cast<int>(watchdog.GetLongestStall()));
  std::printf("slider: %s, %lld elements\n", watchdog.Describe().c_str(),
    static_cast<long long>(this->Window.GetPreview()->GetPicture()->GetNumberOfElements()));
}

TEST_F(Studio, ANewUsersWholePath)
{
  const std::filesystem::path folder = this->MakeStudy("whole-path", 8);
  this->Window.ShowPage(StudioWindow::SolverPageIndex);
  QTest::qWait(100);
  ASSERT_TRUE(this->Run()) << this->Window.GetLog()->GetText().toStdString();
  const std::string results =
    studio_test::ReadFile((folder / "whole-path" / "results.csv").string());
  ASSERT_FALSE(results.empty()) << this->Window.GetLog()->GetText().toStdString();
  EXPECT_EQ(this->Window.GetResults()->GetNumberOfCases(), 8);

  // The command line gives the same to the byte.
  QProcess program;
  program.setWorkingDirectory(QString::fromStdString(folder.string()));
  program.start(
    QStringLiteral(PEMESH_BINARY_DIR "/bin/pemesh"), { "run", "whole-path.json", "-o", "by-hand" });
  ASSERT_TRUE(program.waitForFinished(120000));
  EXPECT_EQ(studio_test::ReadFile((folder / "by-hand" / "results.csv").string()), results);

  ASSERT_TRUE(WaitFor([this] { return this->Window.GetResults()->GetPicture() != nullptr; }));
  auto* solver = this->Find<SolverPage>();
  ASSERT_TRUE(WaitFor([=] { return !solver->GetSolutions()->GetPainted().Image.isNull(); }));
  Keep(&this->Window, "solution");
  solver->GetTabs()->setCurrentIndex(1);
  ASSERT_TRUE(WaitFor([=] { return !solver->GetCharts()->GetPainted().Image.isNull(); }));
  QTest::qWait(500);
  Keep(&this->Window, "performances");

  auto* geometry = this->Find<GeometryPage>();
  this->Window.ShowPage(StudioWindow::GeometryPageIndex);
  QTest::qWait(500);
  MeshCanvas* canvas = geometry->GetCanvas();
  const QPoint middle = canvas->GetTransform().ToScreen({ 0.4, 0.6 }).toPoint();
  QTest::mouseClick(canvas, Qt::LeftButton, {}, middle);
  EXPECT_GE(this->Window.GetSelection()->GetElement(), 0);
  EXPECT_TRUE(geometry->GetTable()->currentIndex().isValid()) << "linked to the table";
  Keep(&this->Window, "geometry");
  geometry->ShowView(1);
  ASSERT_TRUE(WaitFor([=] { return geometry->GetCharts()->GetView()->GetNumberOfPanels() > 20; }));
  QTest::qWait(1500);
  Keep(&this->Window, "metrics");
  geometry->ShowView(2);
  ASSERT_TRUE(WaitFor([=] { return !geometry->GetScatter()->GetPainted().Image.isNull(); }));
  QTest::qWait(500);
  Keep(&this->Window, "scatter");

  this->Window.ShowPage(StudioWindow::CorrelationPageIndex);
  auto* correlation = this->Find<CorrelationPage>();
  EXPECT_GT(correlation->GetFindings()->count(), 10);
  correlation->SetColumns("MinAngle_min", "pemesh-vem_condition-number");
  ASSERT_TRUE(WaitFor([=] { return !correlation->GetChart()->GetPainted().Image.isNull(); }));
  QTest::qWait(500);
  Keep(&this->Window, "correlation");
  // The lowest mark is that of the mildest mesh; a click on it selects that mesh everywhere.
  const QPoint lowest = FindLowestMark(correlation->GetChart()->GetPainted().Image);
  QTest::mouseClick(correlation->GetChart(), Qt::LeftButton, {}, lowest);
  EXPECT_EQ(this->Window.GetSelection()->GetCase(), 0);
  const QString figure = QString::fromStdString((folder / "correlation.pdf").string());
  EXPECT_EQ(correlation->GetChart()->Export(figure).toStdString(), "");
  EXPECT_GT(std::filesystem::file_size(figure.toStdString()), 1000U);
}

TEST_F(Studio, CancellingLeavesTheResultsOfTheRunBefore)
{
  const std::filesystem::path folder = this->MakeStudy("cancel", 3);
  ASSERT_TRUE(this->Run());
  const std::string before = studio_test::ReadFile((folder / "cancel" / "results.csv").string());
  this->Window.GetModel()->SetValue("sweep[0].count", JsonNumber(200), "count");
  this->Window.Run();
  QTest::qWait(400);
  QElapsedTimer clock;
  clock.start();
  this->Window.GetController()->Cancel();
  ASSERT_TRUE(WaitFor([this] { return !this->Window.GetController()->IsRunning(); }));
  std::printf("cancelled in %lld ms\n", static_cast<long long>(clock.elapsed()));
  EXPECT_EQ(studio_test::ReadFile((folder / "cancel" / "results.csv").string()), before);
  EXPECT_FALSE(std::filesystem::exists(folder / "cancel.running"));
}

TEST_F(Studio, StoppingKeepsWhatIsDone)
{
  const std::filesystem::path folder = this->MakeStudy("stop", 200);
  int done = 0;
  QObject::connect(
    this->Window.GetController(), &RunController::Told, &this->Window, [&done] { ++done; });
  this->Window.Run();
  ASSERT_TRUE(WaitFor([&done] { return done > 2; }, 60000));
  this->Window.GetController()->Stop();
  ASSERT_TRUE(WaitFor([this] { return !this->Window.GetController()->IsRunning(); }));
  ASSERT_TRUE(WaitFor([this] { return !this->Window.GetResults()->IsEmpty(); }));
  EXPECT_GE(this->Window.GetResults()->GetNumberOfCases(), 3);
  EXPECT_LT(this->Window.GetResults()->GetNumberOfCases(), 200);
}

TEST_F(Studio, TheFailuresOfASolverAreListedWithTheirLogs)
{
  const std::filesystem::path folder = this->MakeStudy("failing", 2);
  std::ofstream(folder / "broken.json") << R"({"name": "broken", "mesh-format": "off",
    "command": ["sh", "-c", "echo the matrix is singular >&2; exit 3", "{mesh}", "{output}"]})";
  this->Window.GetModel()->SetValue(
    "solvers[0]", { JsonValue::Object{ { "solver", { std::string("broken.json") } } } }, "solver");
  this->Window.ShowPage(StudioWindow::SolverPageIndex);
  ASSERT_TRUE(this->Run()) << this->GetLogText();
  auto* solver = this->Find<SolverPage>();
  FailureList* failures = solver->GetFailures();
  ASSERT_EQ(failures->GetCount(), 2);
  solver->GetTabs()->setCurrentIndex(2);
  failures->GetTable()->setCurrentCell(0, 0);
  EXPECT_EQ(this->Window.GetSelection()->GetCase(), 0) << "its mesh is selected everywhere";
  EXPECT_EQ(failures->GetTable()->item(0, 1)->text(), "broken");
  EXPECT_EQ(failures->GetLog(), "the matrix is singular");
  Keep(&this->Window, "failures");
}

TEST_F(Studio, OpeningAStudyThatWasRunShowsItsResultsAndRunsNothing)
{
  const std::filesystem::path folder = this->MakeStudy("again", 2);
  ASSERT_TRUE(this->Run());
  this->Window.GetModel()->MakeNew();
  StudioWindow second;
  second.show();
  ASSERT_TRUE(second.OpenFiles({ QString::fromStdString((folder / "again.json").string()) }));
  ASSERT_TRUE(WaitFor([&second] { return !second.GetResults()->IsEmpty(); }));
  EXPECT_EQ(second.GetResults()->GetNumberOfCases(), 2);
  EXPECT_FALSE(second.GetController()->IsRunning());
  EXPECT_FALSE(second.isWindowModified());
}

TEST_F(Studio, AMetricOpensOnTheWholeScreen)
{
  this->MakeStudy("detach", 2);
  ASSERT_TRUE(this->Run());
  this->Window.ShowPage(StudioWindow::GeometryPageIndex);
  auto* geometry = this->Find<GeometryPage>();
  geometry->ShowView(1);
  ASSERT_TRUE(WaitFor([=] { return geometry->GetCharts()->GetView()->GetNumberOfPanels() > 20; }));
  const QPoint at = geometry->GetCharts()->GetView()->GetPainted().Boxes[2].center().toPoint();
  QTest::mouseDClick(geometry->GetCharts()->GetView(), Qt::LeftButton, {}, at);
  auto* detached = geometry->findChild<PanelView*>("detached");
  ASSERT_NE(detached, nullptr);
  EXPECT_TRUE(detached->isFullScreen());
  ASSERT_TRUE(WaitFor([=] { return detached->GetNumberOfPanels() == 1; }));
  detached->close();
}

TEST_F(Studio, TheDarkThemeIsDarkAllOver)
{
  this->AddFamily("family-zeta");
  ASSERT_TRUE(this->WaitForMesh());
  ApplyTheme(*qApp, ThemeChoice::Dark);
  QTest::qWait(200);
  Keep(&this->Window, "dark");
  const QImage image = this->Window.grab().toImage();
  int light = 0;
  for (int y = 0; y < image.height(); y += 4)
  {
    for (int x = 0; x < image.width(); x += 4)
    {
      light += image.pixelColor(x, y).lightness() > 200 ? 1 : 0;
    }
  }
  EXPECT_LT(light, image.width() * image.height() / 16 / 10);
  ApplyTheme(*qApp, ThemeChoice::Light);
}
