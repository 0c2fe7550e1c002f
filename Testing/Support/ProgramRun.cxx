// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ProgramRun.h"

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <sys/wait.h>
#include <unistd.h>

namespace pemesh
{

namespace
{

std::string Quoted(const std::string& word)
{
  std::string quoted = "'";
  for (const char c : word)
  {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

} // namespace

std::string FileText(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

ProgramRun RunProgram(const std::string& program, const std::vector<std::string>& arguments,
  const std::filesystem::path& folder)
{
  static std::atomic<int> counter{ 0 };
  const std::filesystem::path captured = std::filesystem::path(PEMESH_TEST_OUTPUT) /
    ("run-" + std::to_string(getpid()) + "-" + std::to_string(counter++));
  const std::string path =
    program.find('/') == std::string::npos ? PEMESH_BINARY_DIR "/bin/" + program : program;
  std::string line = folder.empty() ? std::string() : "cd " + Quoted(folder.string()) + " && ";
  line += "env -u DISPLAY " + Quoted(path);
  for (const std::string& argument : arguments)
  {
    line += " " + Quoted(argument);
  }
  line += " >" + Quoted(captured.string() + ".out") + " 2>" + Quoted(captured.string() + ".err") +
    " </dev/null";
  const int status = std::system(line.c_str());
  ProgramRun run;
  run.ExitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.Output = FileText(captured.string() + ".out");
  run.Errors = FileText(captured.string() + ".err");
  std::filesystem::remove(captured.string() + ".out");
  std::filesystem::remove(captured.string() + ".err");
  return run;
}

} // namespace pemesh
