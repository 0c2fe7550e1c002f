// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Tells whether texts and files are those of an earlier run.
 */
#ifndef pemesh_ContentDigest_h
#define pemesh_ContentDigest_h

#include "pemeshIOCoreModule.h" // For export macro

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace pemesh
{

/** The MD5 of parts, each told from the next: ("ab", "c") differs from ("a", "bc"). */
class PEMESHIOCORE_EXPORT ContentDigest
{
public:
  ContentDigest();
  ~ContentDigest();
  ContentDigest(const ContentDigest&) = delete;
  ContentDigest& operator=(const ContentDigest&) = delete;

  void Add(std::string_view text);

  /** The bytes of a file, read piece by piece; a file that cannot be read counts as such. */
  void AddFile(const std::filesystem::path& path);

  /** 32 digits. Once. */
  std::string Finish();

private:
  class Internals;
  std::unique_ptr<Internals> Implementation;
};

} // namespace pemesh

#endif
