// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Where a test writes. Each test is a process of its own and runs beside others of its program, so
 * that a name without the test's in front of it is a file of several: everything goes through here.
 */
#ifndef pemesh_TestFolder_h
#define pemesh_TestFolder_h

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace pemesh
{

/** PEMESH_TEST_OUTPUT; the environment may name another for a program that a test runs again. */
inline std::filesystem::path TestOutput()
{
  const char* other = std::getenv("PEMESH_TEST_OUTPUT");
  return other ? other : PEMESH_TEST_OUTPUT;
}

/** The folder, or a file in it, of the running test alone. The folder is there; nothing is emptied.
 */
inline std::filesystem::path TestPath(const std::string& name = {})
{
  const testing::UnitTest* program = testing::UnitTest::GetInstance();
  const testing::TestSuite* suite = program->current_test_suite();
  const testing::TestInfo* test = program->current_test_info();
  std::string own = suite ? suite->name() : "program";
  own += test ? std::string(".") + test->name() : std::string();
  std::replace(own.begin(), own.end(), '/', '-');
  const std::filesystem::path folder = TestOutput() / own;
  std::filesystem::create_directories(folder);
  return name.empty() ? folder : folder / name;
}

/** An empty folder of the running test alone. */
inline std::filesystem::path TestFolder(const std::string& name = {})
{
  const std::filesystem::path folder = TestPath(name);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

} // namespace pemesh

#endif
