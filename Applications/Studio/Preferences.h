// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What a user chooses for all sessions, as a table: the dialog is made from it.
 */
#ifndef pemesh_Preferences_h
#define pemesh_Preferences_h

#include <QString>
#include <QStringList>

#include <vector>

class QApplication;

namespace pemesh
{

/** A choice, whose value is its place, or a whole number. */
struct Preference
{
  const char* Key; ///< of the settings that Qt keeps
  QString Label;
  QString Tip;
  int Default = 0;
  QStringList Choices = {}; ///< none: a number
  int Least = 0;
  int Greatest = 0;
  QString Unit = {};
  QString WhenLeast = {}; ///< what the least number stands for, if not for itself
};

///@{
/** Keys. */
inline constexpr const char* ThemePreference = "theme";
inline constexpr const char* TextSizePreference = "textSize";
inline constexpr const char* AutosavePreference = "autosaveSeconds";
inline constexpr const char* WorkersPreference = "workers";
inline constexpr const char* RecentPreference = "recentStudies";
///@}

/** In the language of the user. */
std::vector<Preference> Preferences();

/** Within its range; the default where nothing was chosen. */
int GetPreference(const char* key);
void SetPreference(const char* key, int value);
void ResetPreferences();

/** Theme and size of the text. */
void ApplyPreferences(QApplication& application);

} // namespace pemesh

#endif
