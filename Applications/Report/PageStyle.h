// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * How the page looks, on a screen, in the dark and on paper, and what sorts its tables.
 */
#ifndef pemesh_PageStyle_h
#define pemesh_PageStyle_h

namespace pemesh
{

extern const char* const PageStyle;
extern const char* const PageScript;

} // namespace pemesh

#endif
