// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The language of the window: that of the user where there is a translation, else English.
 */
#ifndef pemesh_Translations_h
#define pemesh_Translations_h

class QApplication;

namespace pemesh
{

/** Those of Qt and of PEMesh Studio (pemesh-studio_<language>.qm), for the locale of the system. */
void InstallTranslations(QApplication& application);

} // namespace pemesh

#endif
