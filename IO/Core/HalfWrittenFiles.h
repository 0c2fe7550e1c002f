// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What is left of a file that was being written (TextFile.h) when its program was killed.
 */
#ifndef pemesh_HalfWrittenFiles_h
#define pemesh_HalfWrittenFiles_h

#include "pemeshIOCoreModule.h" // For export macro

#include <filesystem>

namespace pemesh
{

/** Removes temporary files of processes that are no more from a folder; not from those below. */
PEMESHIOCORE_EXPORT void RemoveHalfWrittenFiles(const std::filesystem::path& folder);

} // namespace pemesh

#endif
