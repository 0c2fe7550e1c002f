// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Looks through a MAT file of MATLAB's version 5 before matio reads it, which takes whatever
 * memory the dimensions of an array ask for.
 */
#ifndef pemesh_MatFileCheck_h
#define pemesh_MatFileCheck_h

#include <filesystem>

namespace pemesh
{

/** Throws unless the file is whole and its arrays have the values that their dimensions say. */
void CheckMatFile(const std::filesystem::path& path);

} // namespace pemesh

#endif
