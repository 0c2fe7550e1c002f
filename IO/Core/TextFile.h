// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Files read and written whole. All functions throw std::runtime_error with one sentence that
 * names the file.
 */
#ifndef pemesh_TextFile_h
#define pemesh_TextFile_h

#include "pemeshIOCoreModule.h" // For export macro

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <string_view>

namespace pemesh
{

/** The contents of a file, or its first `most` bytes. */
PEMESHIOCORE_EXPORT std::string ReadTextFile(
  const std::filesystem::path& path, std::size_t most = std::numeric_limits<std::size_t>::max());

/**
 * Writes under a temporary name in the same folder, brings that to the disk, then renames: a reader
 * sees the old file or the new one, never a part, even after a power cut. The folder is made if
 * missing.
 */
PEMESHIOCORE_EXPORT void WriteTextFile(
  const std::filesystem::path& path, std::string_view contents);

/** The same for a file that `write` makes under the temporary name that it is given. */
PEMESHIOCORE_EXPORT void WriteFileSafely(const std::filesystem::path& path,
  const std::function<void(const std::filesystem::path& temporary)>& write);

} // namespace pemesh

#endif
