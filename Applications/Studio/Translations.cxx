// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Translations.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace pemesh
{

void InstallTranslations(QApplication& application)
{
  const std::pair<QString, QString> catalogues[] = {
    { QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath) },
    { QStringLiteral("pemesh-studio"),
      QApplication::applicationDirPath() + QStringLiteral("/../share/pemesh/translations") }
  };
  for (const auto& [name, folder] : catalogues)
  {
    auto* translator = new QTranslator(&application);
    if (translator->load(QLocale(), name, QStringLiteral("_"), folder))
    {
      QApplication::installTranslator(translator);
    }
  }
}

} // namespace pemesh
