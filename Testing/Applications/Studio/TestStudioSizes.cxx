// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// The window on small and on dense screens: nothing is cut off.
#include "Appearance.h"
#include "CorrelationPage.h"
#include "GeometryPage.h"
#include "MetricCharts.h"
#include "PanelView.h"
#include "ResultSet.h"
#include "SolverPage.h"
#include "StudioFixture.h"
#include "StudioSupport.h"
#include "TestFolder.h"

#include <gmock/gmock.h>

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QProcess>
#include <QTabWidget>
#include <QTest>
#include <QToolButton>

using namespace pemesh;
using studio_test::Keep;
using studio_test::WaitFor;
using testing::IsEmpty;

namespace
{

/** Buttons, choices and lines of text that have less room than they need. */
std::vector<std::string> CutOff(const QWidget& window)
{
  std::vector<std::string> found;
  for (const QWidget* widget : window.findChildren<QWidget*>())
  {
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    const auto* label = qobject_cast<const QLabel*>(widget);
    const bool isText = (button && !button->text().isEmpty()) ||
      (label && !label->text().isEmpty() && !label->wordWrap()) ||
      qobject_cast<const QComboBox*>(widget);
    const bool isCut =
      widget->isVisible() && isText && widget->width() < widget->minimumSizeHint().width();
    const bool isMenuOfHidden =
      widget->isVisible() && widget->objectName() == QStringLiteral("qt_toolbar_ext_button");
    if (isCut || isMenuOfHidden)
    {
      found.push_back(std::string(widget->metaObject()->className()) + " " +
        (button     ? button->text()
            : label ? label->text()
                    : widget->objectName())
          .toStdString());
    }
  }
  return found;
}

class StudioSizes : public studio_test::Studio
{
protected:
  void Look(const char* name, int width, int height)
  {
    QTest::qWait(300);
    EXPECT_EQ(this->Window.size(), QSize(width, height)) << "it does not become so small";
    EXPECT_THAT(CutOff(this->Window), IsEmpty()) << name;
    Keep(&this->Window, (std::string(name) + "-" + std::to_string(width)).c_str());
  }

  /** Every page and every view of it. */
  void LookAtAll(int width, int height)
  {
    this->Window.resize(width, height);
    this->Window.ShowPage(StudioWindow::MeshPageIndex);
    this->Look("page-mesh", width, height);
    this->Window.ShowPage(StudioWindow::GeometryPageIndex);
    auto* geometry = this->Find<GeometryPage>();
    for (int view = 0; view < 3; ++view)
    {
      geometry->ShowView(view);
      ASSERT_TRUE(WaitFor([=] { return !geometry->GetCharts()->GetView()->IsBusy(); }));
      this->Look(("page-geometry-" + std::to_string(view)).c_str(), width, height);
    }
    this->Window.ShowPage(StudioWindow::SolverPageIndex);
    auto* solver = this->Find<SolverPage>();
    for (int tab = 0; tab < 3; ++tab)
    {
      solver->GetTabs()->setCurrentIndex(tab);
      ASSERT_TRUE(WaitFor(
        [=] { return !solver->GetSolutions()->IsBusy() && !solver->GetCharts()->IsBusy(); }));
      this->Look(("page-solver-" + std::to_string(tab)).c_str(), width, height);
    }
    this->Window.ShowPage(StudioWindow::CorrelationPageIndex);
    ASSERT_TRUE(WaitFor([this] { return !this->Find<CorrelationPage>()->GetChart()->IsBusy(); }));
    this->Look("page-correlation", width, height);
  }
};

} // namespace

TEST_F(StudioSizes, NothingIsCutOffWhileThereIsNothing)
{
  this->LookAtAll(1024, 700);
}

TEST_F(StudioSizes, NothingIsCutOffWithResults)
{
  this->MakeStudy("sizes", 5);
  ASSERT_TRUE(this->Run()) << this->GetLogText();
  ASSERT_TRUE(WaitFor([this] { return this->Window.GetResults()->GetPicture() != nullptr; }));
  this->LookAtAll(1024, 700);
  this->LookAtAll(1280, 800);
}

TEST(StudioScreens, WorksOnADenseScreen)
{
  QProcess program;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("QT_SCALE_FACTOR", "2");
  environment.insert("PEMESH_TEST_OUTPUT", QString::fromStdString(pemesh::TestFolder()));
  program.setProcessEnvironment(environment);
  program.setProcessChannelMode(QProcess::MergedChannels);
  program.start(QApplication::applicationFilePath(),
    { "--gtest_filter=Studio.APolygonIsAddedMovedScaledAndTurnedWithTheMouse:"
      "StudioSelection.ARectangleOnTheMeshMarksElementsEverywhere" });
  ASSERT_TRUE(program.waitForFinished(240000));
  EXPECT_EQ(program.exitCode(), 0) << program.readAll().toStdString();
}
