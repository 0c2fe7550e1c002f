// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The look of the window: colours of the light and the dark theme, and the style sheet of both.
 */
#ifndef pemesh_Appearance_h
#define pemesh_Appearance_h

#include <QColor>

class QApplication;

namespace pemesh
{

struct Theme
{
  QColor Window;
  QColor Panel;  ///< cards, lists, editors
  QColor Canvas; ///< behind meshes
  QColor Text;
  QColor Muted; ///< text of less weight
  QColor Border;
  QColor Accent;
  QColor AccentSoft; ///< behind what is selected
  QColor Danger;
  QColor DangerSoft;
  bool IsDark = false;
};

enum class ThemeChoice
{
  System,
  Light,
  Dark
};

/** Sets style, palette and style sheet of the application; text in points, 0: as the system. */
void ApplyTheme(QApplication& application, ThemeChoice choice, double textSize = 0.0);

/** How much larger the text is than that of the system. */
double TextScale();

const Theme& CurrentTheme();

} // namespace pemesh

#endif
