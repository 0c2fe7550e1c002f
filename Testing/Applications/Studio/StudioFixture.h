// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The window of the tests, and what they do with it again and again.
 */
#ifndef StudioFixture_h
#define StudioFixture_h

#include "StudioWindow.h"

#include <gtest/gtest.h>

#include <QString>

#include <filesystem>
#include <string>

namespace studio_test
{

class Studio : public testing::Test
{
protected:
  Studio();
  ~Studio() override;

  template <typename Widget>
  Widget* Find(const char* name = nullptr) const
  {
    return this->Window.findChild<Widget*>(name ? QString::fromLatin1(name) : QString());
  }

  void AddFamily(const char* family);
  bool WaitForMesh();

  /** A study of a star in few steps with the bundled solver, saved into a folder of its own. */
  std::filesystem::path MakeStudy(const std::string& name, int count);

  /**
   * The same with a solver that does the first two meshes at once and each of the others when it is
   * let through.
   */
  std::filesystem::path MakeGatedStudy(const std::string& name, int count);
  static void LetThrough(const std::filesystem::path& folder, int mesh);
  static void LetAllThrough(const std::filesystem::path& folder, int count);

  /** Until the results are there. */
  bool Run();
  /** Begins and waits for so many meshes. */
  bool RunUntil(int meshes);
  bool WaitForEnd();
  /** The log, for a test that fails. */
  std::string GetLogText() const;

  pemesh::StudioWindow Window;
};

} // namespace studio_test

#endif
