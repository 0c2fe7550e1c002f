// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshChoiceDialog.h"
#include "ResultSet.h"
#include "RunController.h"
#include "Selection.h"
#include "StudioFixture.h"
#include "StudioSupport.h"
#include "StudyModel.h"

#include <gmock/gmock.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>
#include <QTimer>

#include <cstdio>
#include <fstream>

using namespace pemesh;
using studio_test::Keep;
using studio_test::ReadFile;
using studio_test::WaitFor;

namespace
{

/** Processes of whoever started them that have a text in their command lines. */
int CountProcesses(const std::string& text)
{
  int count = 0;
  std::error_code ignored; // of those that end meanwhile
  for (const auto& entry : std::filesystem::directory_iterator("/proc", ignored))
  {
    const std::string line = ReadFile((entry.path() / "cmdline").string());
    count += line.find(text) != std::string::npos ? 1 : 0;
  }
  return count;
}

class StudioRuns : public studio_test::Studio
{
protected:
  RunController* Controller() const { return this->Window.GetController(); }
  int Cases() const { return this->Window.GetResults()->GetNumberOfCases(); }

  /** Selects rows of the dialog of meshes when it opens, and accepts it. */
  void ChooseInDialog(const std::vector<int>& rows)
  {
    QTimer::singleShot(0, &this->Window,
      [rows]
      {
        auto* dialog = qobject_cast<MeshChoiceDialog*>(QApplication::activeModalWidget());
        ASSERT_NE(dialog, nullptr);
        auto* table = dialog->findChild<QTableWidget*>();
        table->clearSelection();
        for (const int row : rows)
        {
          table->selectionModel()->select(
            table->model()->index(row, 0), QItemSelectionModel::Select | QItemSelectionModel::Rows);
        }
        EXPECT_EQ(dialog->GetCases(), rows);
        Keep(dialog, "choice");
        QTest::mouseClick(dialog->findChild<QPushButton*>("primary"), Qt::LeftButton);
      });
  }
};

} // namespace

TEST_F(StudioRuns, WhatIsPausedGoesOnToTheSameResults)
{
  const std::filesystem::path folder = this->MakeGatedStudy("paused", 4);
  ASSERT_TRUE(this->RunUntil(2)) << this->GetLogText();
  this->Controller()->Pause();
  ASSERT_TRUE(this->WaitForEnd());
  EXPECT_TRUE(this->Controller()->IsPaused());
  EXPECT_FALSE(std::filesystem::exists(folder / "paused")) << "it is not the result yet";
  ASSERT_TRUE(WaitFor([this] { return this->Cases() == 2; })) << "what is done is shown";

  LetAllThrough(folder, 4);
  int told = 0;
  QObject::connect(this->Controller(), &RunController::Told, &this->Window, [&told] { ++told; });
  this->Window.Run();
  ASSERT_TRUE(this->WaitForEnd());
  ASSERT_TRUE(WaitFor([this] { return this->Cases() == 4; })) << this->GetLogText();
  EXPECT_EQ(told, 2) << "what was done is not done again";
  EXPECT_FALSE(this->Controller()->IsPaused());
  EXPECT_FALSE(std::filesystem::exists(folder / "paused.running"));
  const std::string continued = ReadFile((folder / "paused" / "results.csv").string());
  told = 0;
  this->Window.Run();
  ASSERT_TRUE(this->WaitForEnd());
  EXPECT_EQ(told, 4) << "a new run does all of it";
  EXPECT_EQ(ReadFile((folder / "paused" / "results.csv").string()), continued);
}

TEST_F(StudioRuns, CancellingWhatIsPausedBringsBackTheResultsBefore)
{
  const std::filesystem::path folder = this->MakeGatedStudy("given-up", 3);
  LetAllThrough(folder, 3);
  ASSERT_TRUE(this->Run());
  this->Window.GetModel()->SetValue("sweep[0].count", JsonNumber(9), "count");
  ASSERT_TRUE(this->RunUntil(2));
  this->Controller()->Pause();
  ASSERT_TRUE(this->WaitForEnd());
  ASSERT_TRUE(this->Controller()->IsPaused());
  ASSERT_TRUE(
    WaitFor([this] { return this->Window.GetResults()->GetFolder().endsWith("running"); }));
  this->Controller()->Cancel();
  ASSERT_TRUE(WaitFor([this] { return this->Cases() == 3; })) << this->GetLogText();
  EXPECT_FALSE(this->Window.GetResults()->GetFolder().endsWith("running"));
  EXPECT_FALSE(std::filesystem::exists(folder / "given-up.running"));
}

TEST_F(StudioRuns, StoppingWhatIsPausedKeepsWhatIsDone)
{
  const std::filesystem::path folder = this->MakeGatedStudy("settled", 4);
  ASSERT_TRUE(this->RunUntil(2));
  this->Controller()->Pause();
  ASSERT_TRUE(this->WaitForEnd());
  this->Controller()->Stop();
  ASSERT_TRUE(WaitFor([&] { return std::filesystem::exists(folder / "settled" / "results.csv"); }));
  ASSERT_TRUE(this->WaitForEnd());
  const QString settled = QString::fromStdString((folder / "settled").string());
  ASSERT_TRUE(WaitFor([&] { return this->Window.GetResults()->GetFolder() == settled; }));
  EXPECT_EQ(this->Cases(), 2);
  EXPECT_FALSE(this->Controller()->IsPaused());
}

TEST_F(StudioRuns, ClosingDuringARunPausesItForTheNextTime)
{
  const std::filesystem::path folder = this->MakeGatedStudy("closed", 4);
  ASSERT_TRUE(this->RunUntil(2));
  const std::string script = (folder / "gated.sh").string();
  ASSERT_TRUE(WaitFor([&] { return CountProcesses(script) > 0; })) << "a mesh is being solved";
  QElapsedTimer clock;
  clock.start();
  this->Window.close();
  ASSERT_TRUE(WaitFor([this] { return !this->Window.isVisible(); }));
  std::printf("closed during a run in %lld ms\n", static_cast<long long>(clock.elapsed()));
  EXPECT_EQ(CountProcesses(script), 0) << "it leaves no process";
  EXPECT_FALSE(this->Controller()->IsRunning());
  EXPECT_FALSE(std::filesystem::exists(folder / "closed"));

  StudioWindow next;
  next.show();
  ASSERT_TRUE(next.OpenFiles({ this->Window.GetModel()->GetFile() }));
  EXPECT_TRUE(next.GetController()->IsPaused());
  EXPECT_FALSE(next.GetController()->IsRunning()) << "nothing runs unasked";
  ASSERT_TRUE(WaitFor([&next] { return next.GetResults()->GetNumberOfCases() == 2; }));
  LetAllThrough(folder, 4);
  next.Run();
  ASSERT_TRUE(WaitFor([&next] { return next.GetResults()->GetNumberOfCases() == 4; }, 120000))
    << next.GetResults()->GetNumberOfCases();
  ASSERT_TRUE(WaitFor([&next] { return !next.GetController()->IsRunning(); }));
}

TEST_F(StudioRuns, ClosingAStudyWithoutAFileEndsItsRunAndLeavesNothing)
{
  this->AddFamily("family-star");
  this->Window.GetModel()->SetValue("name", { std::string("never-saved") }, "name");
  this->Window.GetModel()->SetValue("sweep[0].count", JsonNumber(500), "count");
  ASSERT_TRUE(this->RunUntil(1));
  const QString work = this->Controller()->GetWorkFolder();
  QTimer::singleShot(0, &this->Window,
    []
    {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      ASSERT_NE(box, nullptr) << "it asks about the study";
      box->button(QMessageBox::Discard)->click();
    });
  this->Window.close();
  ASSERT_TRUE(WaitFor([this] { return !this->Window.isVisible(); }));
  EXPECT_FALSE(std::filesystem::exists(work.toStdString()));
}

TEST_F(StudioRuns, OnlyTheChosenMeshesAreRun)
{
  const std::filesystem::path folder = this->MakeGatedStudy("chosen", 5);
  LetAllThrough(folder, 5);
  this->ChooseInDialog({ 1, 3 });
  this->Window.RunSome();
  ASSERT_TRUE(this->WaitForEnd());
  ASSERT_TRUE(WaitFor([this] { return this->Cases() == 2; })) << this->GetLogText();
  const ResultSet* results = this->Window.GetResults();
  EXPECT_TRUE(results->GetMeshName(0).startsWith("001")) << results->GetMeshName(0).toStdString();
  EXPECT_TRUE(results->GetMeshName(1).startsWith("003"));
}

TEST_F(StudioRuns, ResultsAreShownWhileTheRunGoesOn)
{
  const std::filesystem::path folder = this->MakeGatedStudy("half-way", 5);
  ASSERT_TRUE(this->RunUntil(2));
  QTest::qWait(2100); // from here on the runner saves its tables with the next mesh
  LetThrough(folder, 2);
  ASSERT_TRUE(WaitFor([this] { return this->Cases() == 3; })) << this->GetLogText();
  EXPECT_TRUE(this->Controller()->IsRunning());
  this->Window.GetSelection()->SetCase(1);
  ASSERT_TRUE(WaitFor([this] { return this->Window.GetResults()->GetPicture() != nullptr; }));
  LetAllThrough(folder, 5);
  ASSERT_TRUE(this->WaitForEnd());
  ASSERT_TRUE(WaitFor([this] { return this->Cases() == 5; }));
  EXPECT_EQ(this->Window.GetSelection()->GetCase(), 1) << "the mesh in view stays";
}

TEST_F(StudioRuns, AMeshOfOtherResultsIsNeverShown)
{
  const std::filesystem::path folder = this->MakeGatedStudy("other", 2);
  ASSERT_TRUE(this->Run());
  const QString first = QString::fromStdString((folder / "other").string());
  const std::filesystem::path second = folder / "second";
  std::filesystem::copy(folder / "other", second, std::filesystem::copy_options::recursive);
  ResultSet results;
  int changes = 0;
  QObject::connect(&results, &ResultSet::Changed, &results, [&changes] { ++changes; });
  for (int i = 0; i < 20; ++i)
  {
    changes = 0;
    results.Load(first);
    ASSERT_TRUE(WaitFor([&] { return changes == 1; }));
    results.ShowCase(0);
    results.Load(QString::fromStdString(second.string()));
    ASSERT_TRUE(WaitFor([&] { return changes == 2; }));
    WaitFor([] { return false; }, 10);
    EXPECT_EQ(results.GetPicture(), nullptr);
    EXPECT_EQ(results.GetCase(), -1);
  }
}
