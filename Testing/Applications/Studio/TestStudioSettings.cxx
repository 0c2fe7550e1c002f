// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// Preferences, the style of plots, choices of solvers, and what is exported.
#include "Appearance.h"
#include "CorrelationPage.h"
#include "CsvTable.h"
#include "LogDock.h"
#include "MeshPage.h"
#include "PanelView.h"
#include "PlotStyle.h"
#include "Preferences.h"
#include "PreferencesDialog.h"
#include "ResultSet.h"
#include "RunController.h"
#include "SolverPage.h"
#include "StudioFixture.h"
#include "StudioMenus.h"
#include "StudioSupport.h"
#include "StudyModel.h"
#include "StyleDialog.h"
#include "TestFolder.h"

#include <gmock/gmock.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

#include <set>

#include <vtkTable.h>
#include <vtkVariant.h>

using namespace pemesh;
using studio_test::Keep;
using studio_test::WaitFor;

namespace
{

class StudioSettings : public studio_test::Studio
{
protected:
  ~StudioSettings() override
  {
    ResetPreferences();
    ResetUserStyle();
    ApplyTheme(*qApp, ThemeChoice::Light);
  }
};

} // namespace

TEST_F(StudioSettings, PreferencesAreInForceAtOnceAndKept)
{
  this->Window.findChild<StudioMenus*>()->ShowPreferences();
  auto* dialog = this->Find<PreferencesDialog>();
  ASSERT_NE(dialog, nullptr);
  Keep(dialog, "preferences");
  dialog->findChild<QComboBox*>(ThemePreference)->setCurrentIndex(2);
  EXPECT_TRUE(CurrentTheme().IsDark);
  const double size = QApplication::font().pointSizeF();
  dialog->findChild<QSpinBox*>(TextSizePreference)->setValue(20);
  EXPECT_EQ(QApplication::font().pointSizeF(), 20.0);
  EXPECT_NEAR(TextScale(), 20.0 / size, 1e-9);
  dialog->findChild<QSpinBox*>(WorkersPreference)->setValue(3);
  dialog->findChild<QSpinBox*>(AutosavePreference)->setValue(7);
  EXPECT_EQ(GetPreference(WorkersPreference), 3);
  EXPECT_EQ(QSettings().value(AutosavePreference).toInt(), 7) << "also for the next session";
  QTest::mouseClick(
    dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::RestoreDefaults),
    Qt::LeftButton);
  EXPECT_EQ(GetPreference(AutosavePreference), 3);
  EXPECT_EQ(QApplication::font().pointSizeF(), size);
  EXPECT_EQ(dialog->findChild<QSpinBox*>(WorkersPreference)->value(), 0);
  QSettings().setValue(WorkersPreference, -4);
  EXPECT_EQ(GetPreference(WorkersPreference), 0) << "whatever the file says";
  dialog->close();
}

TEST_F(StudioSettings, AStyleOfTheStudyIsDrawnAndUndone)
{
  StudyModel* model = this->Window.GetModel();
  StyleDialog dialog(model);
  const auto set = [&dialog](const char* name, bool on)
  { dialog.findChild<QCheckBox*>(QLatin1String(name))->setChecked(on); };
  set("frame", true);
  EXPECT_TRUE(LoadUserStyle().Frame);
  auto* owner = dialog.findChild<QComboBox*>(QString(), Qt::FindDirectChildrenOnly);
  ASSERT_NE(owner, nullptr);
  owner->setCurrentIndex(1);
  set("color-bar", false);
  EXPECT_FALSE(model->GetStudy().Style.Settings.empty()) << "it is saved with the study";
  EXPECT_FALSE(LoadPlotStyle().ColorBar);
  EXPECT_TRUE(LoadUserStyle().ColorBar) << "other studies are as they were";
  EXPECT_TRUE(LoadPlotStyle().Frame) << "what the study does not say is that of the user";
  const std::string file = pemesh::TestPath("named.json");
  dialog.SaveAs(QString::fromStdString(file));
  model->GetUndoStack()->undo();
  EXPECT_TRUE(LoadPlotStyle().ColorBar);
  dialog.Load(QString::fromStdString(file));
  EXPECT_FALSE(LoadPlotStyle().ColorBar) << "of the file";
  Keep(&dialog, "style");
  model->SetValue("style", { JsonValue::Object{ { "font-family", { std::string("Nowhere") } } } },
    "a font that is not there");
  EXPECT_THAT(this->GetLogText(), testing::HasSubstr("\"Nowhere\" is not installed"));
  model->MakeNew();
  EXPECT_TRUE(LoadPlotStyle().ColorBar) << "it went with its study";
}

TEST_F(StudioSettings, TheMeshPageRunsTheSolver)
{
  const std::filesystem::path folder = pemesh::TestFolder("mesh-page");
  StudyModel* model = this->Window.GetModel();
  this->AddFamily("family-star");
  model->SetValue("sweep[0].count", JsonNumber(2), "count");
  model->SetValue("name", { std::string("mesh-page") }, "name");
  model->Save(QString::fromStdString((folder / "mesh-page.json").string()));
  auto* button = this->Window.GetMeshPage()->findChild<QToolButton*>("primary");
  ASSERT_NE(button, nullptr);
  EXPECT_EQ(button->text().toStdString(), "Run the solver");
  QTest::mouseClick(button, Qt::LeftButton);
  ASSERT_EQ(model->GetStudy().Solvers.size(), 1U) << "the default one, as there was none";
  EXPECT_EQ(model->GetStudy().Solvers[0].Solver, "pemesh-vem");
  EXPECT_FALSE(button->isEnabled());
  ASSERT_TRUE(this->WaitForEnd());
  ASSERT_TRUE(WaitFor([this] { return this->Window.GetResults()->GetNumberOfCases() == 2; }))
    << this->GetLogText();
}

TEST_F(StudioSettings, OptionsOfSolversAreChosenFromWhatTheyOffer)
{
  StudyModel* model = this->Window.GetModel();
  model->AddItem(
    "solvers", { JsonValue::Object{ { "solver", { std::string("pemesh-vem") } } } }, "solver");
  this->Window.ShowPage(StudioWindow::SolverPageIndex);
  auto* solver = this->Find<SolverPage>();
  auto* problem = solver->findChild<QComboBox*>("solvers[0].problem");
  ASSERT_NE(problem, nullptr);
  EXPECT_GT(problem->count(), 10);
  EXPECT_EQ(problem->currentText(), "franke");
  problem->setCurrentText("quartic");
  EXPECT_THAT(model->GetText(), testing::HasSubstr("\"problem\": \"quartic\""));
  EXPECT_EQ(model->GetFault().toStdString(), "");
  auto* basis = solver->findChild<QComboBox*>("solvers[0].basis");
  ASSERT_NE(basis, nullptr);
  EXPECT_EQ(basis->count(), 3);
  model->GetUndoStack()->undo();
  EXPECT_EQ(problem->currentText(), "franke");
}

TEST_F(StudioSettings, NumbersOfChartsAreExportedAsATable)
{
  const std::filesystem::path folder = this->MakeStudy("numbers", 4);
  ASSERT_TRUE(this->Run()) << this->GetLogText();
  this->Window.ShowPage(StudioWindow::CorrelationPageIndex);
  auto* correlation = this->Find<CorrelationPage>();
  correlation->SetColumns("MinAngle_min", "pemesh-vem_condition-number");
  const std::filesystem::path one = folder / "one.csv";
  ASSERT_EQ(
    correlation->GetChart()->Export(QString::fromStdString(one.string())).toStdString(), "");
  const auto table = ReadCsvFile(one);
  ASSERT_EQ(table->GetNumberOfRows(), 4);
  const vtkTable* results = this->Window.GetResults()->GetTable();
  for (vtkIdType row = 0; row < 4; ++row)
  {
    EXPECT_EQ(table->GetValueByName(row, "X").ToDouble(),
      const_cast<vtkTable*>(results)->GetValueByName(row, "MinAngle_min").ToDouble());
  }
  ASSERT_TRUE(WaitFor([this] { return this->Window.GetResults()->GetPicture() != nullptr; }));
  const std::filesystem::path sides = folder / "solutions.csv";
  ASSERT_EQ(this->Find<SolverPage>()
              ->GetSolutions()
              ->Export(QString::fromStdString(sides.string()))
              .toStdString(),
    "");
  const auto solutions = ReadCsvFile(sides);
  std::set<std::string> charts;
  for (vtkIdType row = 0; row < solutions->GetNumberOfRows(); ++row)
  {
    charts.insert(solutions->GetValueByName(row, "Chart").ToString());
  }
  EXPECT_GE(charts.size(), 3U) << "solution, truth and error";
}
