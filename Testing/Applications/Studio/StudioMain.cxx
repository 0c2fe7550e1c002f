// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the tests on a display of their own: an Xvfb that ends with them.
#include "Appearance.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QProcess>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <csignal>
#include <cstdio>

#include <sys/prctl.h>

namespace
{

// For the programs that the tests start, which use the same.
constexpr const char* DisplayOfTests = "PEMESH_TEST_DISPLAY";
constexpr const char* HomeOfTests = "PEMESH_TEST_HOME";

/** False if there is no display to be had. */
bool StartDisplay(QProcess& server)
{
  if (qEnvironmentVariableIsSet(DisplayOfTests))
  {
    return true;
  }
  server.setChildProcessModifier([] { prctl(PR_SET_PDEATHSIG, SIGTERM); }); // even after a crash
  server.start(QStringLiteral("Xvfb"),
    { QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"),
      QStringLiteral("0"), QStringLiteral("1600x1000x24"), QStringLiteral("-nolisten"),
      QStringLiteral("tcp") });
  if (!server.waitForStarted() || !server.waitForReadyRead())
  {
    return false;
  }
  qputenv("DISPLAY", ":" + server.readLine().trimmed());
  qputenv(DisplayOfTests, qgetenv("DISPLAY"));
  return true;
}

} // namespace

int main(int argc, char* argv[])
{
  testing::InitGoogleTest(&argc, argv);
  if (GTEST_FLAG_GET(list_tests))
  {
    return RUN_ALL_TESTS();
  }
  QProcess server;
  if (!StartDisplay(server))
  {
    std::fputs("Xvfb did not start: install the Debian package xvfb.\n", stderr);
    return 1;
  }
  qputenv("QT_QPA_PLATFORM", "xcb");
  int result = 1;
  {
    QApplication application(argc, argv);
    QStandardPaths::setTestModeEnabled(true);
    // Other tests run beside: settings and kept studies are of this process.
    QTemporaryDir home(QStringLiteral(PEMESH_TEST_OUTPUT "/home-XXXXXX"));
    if (!qEnvironmentVariableIsSet(HomeOfTests))
    {
      qputenv(HomeOfTests, home.path().toUtf8());
      qputenv("HOME", home.path().toUtf8());
    }
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, home.path());
    QApplication::setOrganizationName(QStringLiteral("PEMesh"));
    QApplication::setApplicationName(QStringLiteral("pemesh-studio-test"));
    pemesh::ApplyTheme(application, pemesh::ThemeChoice::Light);
    result = RUN_ALL_TESTS();
  }
  if (server.state() != QProcess::NotRunning)
  {
    server.terminate();
    server.waitForFinished();
  }
  return result;
}
