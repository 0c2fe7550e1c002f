// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Preferences.h"

#include "Appearance.h"

#include <QApplication>
#include <QCoreApplication>
#include <QSettings>

#include <algorithm>
#include <cstring>

namespace pemesh
{

namespace
{

struct PreferenceTexts
{
  Q_DECLARE_TR_FUNCTIONS(Preferences)
};

} // namespace

std::vector<Preference> Preferences()
{
  return {
    { ThemePreference, PreferenceTexts::tr("Theme"), PreferenceTexts::tr("Colours of the window"),
      0,
      { PreferenceTexts::tr("As the system"), PreferenceTexts::tr("Light"),
        PreferenceTexts::tr("Dark") } },
    { TextSizePreference, PreferenceTexts::tr("Size of text"),
      PreferenceTexts::tr("Of the window and of charts on the screen"), 5, {}, 5, 24,
      PreferenceTexts::tr(" pt"), PreferenceTexts::tr("As the system") },
    { AutosavePreference, PreferenceTexts::tr("Keep unsaved work after"),
      PreferenceTexts::tr(
        "How long after a change the study is kept for the case that the program ends by "
        "accident"),
      3, {}, 1, 3600, PreferenceTexts::tr(" s") },
    { WorkersPreference, PreferenceTexts::tr("Meshes at a time"),
      PreferenceTexts::tr("How many meshes of a study are made and solved at the same time"), 0, {},
      0, 1024, {}, PreferenceTexts::tr("As many as the machine has cores") },
    { RecentPreference, PreferenceTexts::tr("Recent studies"),
      PreferenceTexts::tr("How many the menu File lists; 0 forgets them"), 10, {}, 0, 50 },
  };
}

int GetPreference(const char* key)
{
  for (const Preference& preference : Preferences())
  {
    if (std::strcmp(preference.Key, key) == 0)
    {
      const int greatest = preference.Choices.isEmpty()
        ? preference.Greatest
        : static_cast<int>(preference.Choices.size()) - 1;
      return std::clamp(QSettings().value(QLatin1String(key), preference.Default).toInt(),
        preference.Least, greatest);
    }
  }
  return 0;
}

void SetPreference(const char* key, int value)
{
  QSettings().setValue(QLatin1String(key), value);
}

void ResetPreferences()
{
  for (const Preference& preference : Preferences())
  {
    QSettings().remove(QLatin1String(preference.Key));
  }
}

void ApplyPreferences(QApplication& application)
{
  const int size = GetPreference(TextSizePreference);
  const bool isOwn = size > Preferences()[1].Least;
  ApplyTheme(
    application, static_cast<ThemeChoice>(GetPreference(ThemePreference)), isOwn ? size : 0.0);
}

} // namespace pemesh
