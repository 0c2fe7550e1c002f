// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The folder of one run of a solver on one mesh; private to SolverRun.
 */
#ifndef pemesh_SolverFolder_h
#define pemesh_SolverFolder_h

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace pemesh
{

class SolverFolder
{
public:
  /**
   * The folder `stem` in the user's folder, or in one of its own that is removed at the end where
   * that is empty. Throws std::runtime_error where it cannot be made.
   */
  SolverFolder(const std::filesystem::path& workDirectory, const std::string& stem);
  SolverFolder(const SolverFolder&) = delete;
  SolverFolder& operator=(const SolverFolder&) = delete;
  ~SolverFolder();

  const std::filesystem::path& GetPath() const { return this->Path; }

  /** Makes it, also again. Throws std::runtime_error where it cannot, or a link is in its place. */
  void Make() const;

  /** Whether it is there, as a folder of its own: a solver may put a link in its place. */
  bool IsThere() const;

  /** Removes files of an earlier run, which must not be taken for new ones. Throws. */
  void Remove(const std::vector<std::filesystem::path>& files);

  /** Remembers what is there, for FindNew. */
  void NoteNames();

  /** The names that were not there, and are not `expected`, sorted. */
  std::vector<std::string> FindNew(const std::vector<std::filesystem::path>& expected) const;

  /** Bytes of all files in it; links are not followed. */
  std::uintmax_t GetSize() const;

private:
  std::set<std::string> Names() const;

  std::filesystem::path Path;
  std::filesystem::path Temporary;
  std::set<std::string> Noted;
};

} // namespace pemesh

#endif
