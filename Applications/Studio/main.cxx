// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Appearance.h"
#include "Session.h"
#include "StudioWindow.h"
#include "Translations.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QSettings>
#include <QTimer>

int main(int argc, char* argv[])
{
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("PEMesh"));
  QApplication::setApplicationName(QStringLiteral("pemesh-studio"));
  QApplication::setApplicationDisplayName(QStringLiteral("PEMesh Studio"));
  QApplication::setApplicationVersion(QStringLiteral(PEMESH_VERSION));
  pemesh::InstallTranslations(application);
  QCommandLineParser parser;
  parser.setApplicationDescription(QApplication::translate("main",
    "Makes families of polygonal meshes, measures them, solves on them, and shows what "
    "geometry does to the solution."));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(QStringLiteral("files"),
    QApplication::translate("main", "A study (.json), or one or more meshes."),
    QStringLiteral("[STUDY.json | MESH…]"));
  parser.process(application);
  pemesh::ApplyTheme(application,
    static_cast<pemesh::ThemeChoice>(QSettings().value(QStringLiteral("theme")).toInt()));
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
