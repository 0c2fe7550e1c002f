// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// Work that was not saved comes back after the program was killed.
#include "Session.h"
#include "StudioSupport.h"
#include "StudioWindow.h"
#include "StudyModel.h"
#include "TestFolder.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include <cstdio>

using namespace pemesh;
using studio_test::WaitFor;

namespace
{

QStringList KeptStudies()
{
  return QDir(Session::GetAutosaveFolder()).entryList({ "*.json" }, QDir::Files);
}

/** With a home of its own, where the program keeps what is not saved. */
class Recovery : public testing::Test
{
protected:
  Recovery() { qputenv("HOME", pemesh::TestFolder("recovery-home").c_str()); }
  ~Recovery() override { qputenv("HOME", this->Before); }

  /** A program that edits a study and is killed. */
  static void LoseWork()
  {
    QProcess program;
    program.start(QApplication::applicationFilePath(),
      { "--gtest_filter=RecoveryChild.*", "--gtest_also_run_disabled_tests" });
    ASSERT_TRUE(program.waitForStarted());
    QByteArray output;
    ASSERT_TRUE(WaitFor(
      [&]
      {
        program.waitForReadyRead(10);
        output += program.readAllStandardOutput();
        return output.contains("kept");
      }))
      << output.toStdString() << program.readAllStandardError().toStdString();
    EXPECT_EQ(KeptStudies().size(), 1);
    program.kill();
    ASSERT_TRUE(program.waitForFinished());
  }

  static void Answer(QMessageBox::StandardButton button)
  {
    QTimer::singleShot(0, qApp,
      [button]
      {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        ASSERT_NE(box, nullptr) << "nothing is offered";
        box->button(button)->click();
      });
  }

  QByteArray Before = qgetenv("HOME");
};

} // namespace

TEST(RecoveryChild, DISABLED_EditsAndWaits)
{
  StudioWindow window;
  window.GetModel()->AddItem(
    "polygons", { JsonValue::Object{ { "family", { std::string("maze") } } } }, "add");
  ASSERT_TRUE(WaitFor([] { return KeptStudies().size() == 1; }));
  std::puts("kept");
  std::fflush(stdout);
  WaitFor([] { return false; }, 300000);
}

TEST_F(Recovery, AStudyOfAProgramThatWasKilledIsOfferedAndComesBack)
{
  LoseWork();
  StudioWindow window;
  Answer(QMessageBox::Yes);
  window.GetSession()->OfferRecovery();
  ASSERT_EQ(window.GetModel()->GetStudy().Polygons.size(), 1U);
  EXPECT_EQ(window.GetModel()->GetStudy().Polygons[0].Family, "maze");
  EXPECT_TRUE(window.GetModel()->IsModified());
  EXPECT_EQ(KeptStudies().size(), 1) << "still kept, now by this program";
  window.GetSession()->OfferRecovery(); // offers nothing: no one would answer
  window.GetModel()->MakeNew();
}

TEST_F(Recovery, WhatIsNotWantedIsNotOfferedAgain)
{
  LoseWork();
  StudioWindow window;
  Answer(QMessageBox::No);
  window.GetSession()->OfferRecovery();
  EXPECT_TRUE(window.GetModel()->GetStudy().Polygons.empty());
  EXPECT_TRUE(KeptStudies().isEmpty());
}

TEST_F(Recovery, WhatAProgramThatRunsKeepsIsItsOwn)
{
  StudioWindow first;
  first.GetModel()->AddItem(
    "polygons", { JsonValue::Object{ { "family", { std::string("star") } } } }, "add");
  first.GetSession()->Autosave();
  ASSERT_EQ(KeptStudies().size(), 1);
  StudioWindow second;
  second.GetSession()->OfferRecovery(); // no question
  EXPECT_TRUE(second.GetModel()->GetStudy().Polygons.empty());
  EXPECT_EQ(KeptStudies().size(), 1);
  first.GetModel()->MakeNew();
}
