// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The files of fonts by their families, for devices that cannot be told a family. Private to this
 * module.
 */
#ifndef pemesh_FontFiles_h
#define pemesh_FontFiles_h

#include "pemeshChartsModule.h" // For export macro

#include <string>

namespace pemesh
{

/**
 * The file of the installed font that comes nearest to a family, as Cairo chooses it; empty where
 * there is none. Looked up once for every family.
 */
std::string FindFontFile(const std::string& family, bool bold);

/**
 * Empty where the family is installed, or stands for any of a kind ("sans", "serif", "monospace");
 * else one sentence that says which is drawn in its place and what to do.
 */
PEMESHCHARTS_EXPORT std::string WhyOtherFont(const std::string& family);

} // namespace pemesh

#endif
