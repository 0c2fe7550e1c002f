// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The files of fonts by their families, for devices that cannot be told a family. Private to this
 * module.
 */
#ifndef pemesh_FontFiles_h
#define pemesh_FontFiles_h

#include <string>

namespace pemesh
{

/**
 * The file of the installed font that comes nearest to a family, as Cairo chooses it; empty where
 * there is none. Looked up once for every family.
 */
std::string FindFontFile(const std::string& family, bool bold);

} // namespace pemesh

#endif
