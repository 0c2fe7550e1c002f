// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Preferences.h"
#include "Session.h"
#include "StudioWindow.h"
#include "Translations.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QTimer>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>

namespace
{

/** Where there is none, Qt would end the program by abort(). */
bool HasDisplay(int argc, char* argv[])
{
  const bool isChosen = std::any_of(argv, argv + argc,
    [](const char* argument) { return std::strcmp(argument, "-platform") == 0; });
  return isChosen ||
    std::ranges::any_of(std::array{ "DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM" },
      [](const char* name) { return !qEnvironmentVariableIsEmpty(name); });
}

void Describe(QCommandLineParser& parser)
{
  parser.setApplicationDescription(QApplication::translate("main",
    "Makes families of polygonal meshes, measures them, solves on them, and shows what "
    "geometry does to the solution."));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(QStringLiteral("files"),
    QApplication::translate("main", "A study (.json), or one or more meshes."),
    QStringLiteral("[STUDY.json | MESH…]"));
}

} // namespace

int main(int argc, char* argv[])
{
  QApplication::setOrganizationName(QStringLiteral("PEMesh"));
  QApplication::setApplicationName(QStringLiteral("pemesh-studio"));
  QApplication::setApplicationVersion(QStringLiteral(PEMESH_VERSION));
  QCommandLineParser parser;
  if (!HasDisplay(argc, argv))
  {
    const QCoreApplication application(argc, argv);
    Describe(parser);
    parser.process(application); // --help and --version need no window
    std::fputs("pemesh-studio: there is no display to show a window on (DISPLAY and "
               "WAYLAND_DISPLAY are not set): start it on a desktop, or use pemesh, which needs "
               "none.\n",
      stderr);
    return 2;
  }
  QApplication application(argc, argv);
  QApplication::setApplicationDisplayName(QStringLiteral("PEMesh Studio"));
  QApplication::setDesktopFileName(QStringLiteral("pemesh-studio"));
  pemesh::InstallTranslations(application);
  Describe(parser);
  parser.process(application);
  pemesh::ApplyPreferences(application);
  pemesh::StudioWindow window;
  window.show();
  const QStringList files = parser.positionalArguments();
  QTimer::singleShot(0, &window,
    [&window, files]
    {
      window.GetSession()->OfferRecovery();
      if (!files.isEmpty())
      {
        window.OpenFiles(files);
      }
    });
  return QApplication::exec();
}
