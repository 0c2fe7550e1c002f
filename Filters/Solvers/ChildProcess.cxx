// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChildProcess.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace pemesh
{

namespace
{

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;
using Ending = ChildProcessResult::Ending;

constexpr int PollMilliseconds = 20;
constexpr Seconds ReportInterval{ 0.1 };
constexpr Seconds GraceAfterTerminate{ 0.5 };

[[noreturn]] void FailWithErrno(const std::string& what)
{
  throw std::runtime_error("Cannot " + what + ": " + std::strerror(errno) + ".");
}

/** An open file, closed at the end of its life. */
class Descriptor
{
public:
  explicit Descriptor(int number = -1)
    : Number(number)
  {
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { this->Reset(); }

  void Reset(int number = -1)
  {
    if (this->Number >= 0)
    {
      close(this->Number);
    }
    this->Number = number;
  }
  int Get() const { return this->Number; }
  bool IsOpen() const { return this->Number >= 0; }

private:
  int Number;
};

/** A pipe whose ends no other child inherits, above the three standard descriptors. */
void OpenPipe(Descriptor& readEnd, Descriptor& writeEnd)
{
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
  {
    FailWithErrno("make a pipe");
  }
  const Descriptor read(ends[0]);
  const Descriptor write(ends[1]);
  constexpr int firstAboveStandard = 3;
  readEnd.Reset(fcntl(read.Get(), F_DUPFD_CLOEXEC, firstAboveStandard));
  writeEnd.Reset(fcntl(write.Get(), F_DUPFD_CLOEXEC, firstAboveStandard));
  if (!readEnd.IsOpen() || !writeEnd.IsOpen() || fcntl(readEnd.Get(), F_SETFL, O_NONBLOCK) != 0)
  {
    FailWithErrno("make a pipe");
  }
}

/** Takes one output of the child: the first bytes into a file, the last ones into memory. */
class OutputLog
{
public:
  OutputLog(const std::filesystem::path& path, std::size_t limit)
    : Room(limit)
  {
    if (!path.empty())
    {
      this->File.Reset(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
      if (!this->File.IsOpen())
      {
        FailWithErrno("write \"" + path.string() + '"');
      }
    }
    OpenPipe(this->ReadEnd, this->WriteEnd);
  }

  int GetWriteEnd() const { return this->WriteEnd.Get(); }
  int GetReadEnd() const { return this->ReadEnd.Get(); }
  void CloseWriteEnd() { this->WriteEnd.Reset(); }

  /** Reads what there is; bounded, because a child may write without end. */
  void Drain()
  {
    constexpr int mostReads = 256;
    std::array<char, 16384> buffer;
    for (int i = 0; i < mostReads && this->ReadEnd.IsOpen(); ++i)
    {
      const ssize_t got = read(this->ReadEnd.Get(), buffer.data(), buffer.size());
      if (got > 0)
      {
        this->Keep({ buffer.data(), static_cast<std::size_t>(got) });
      }
      else if (got == 0)
      {
        this->ReadEnd.Reset();
      }
      else if (errno != EINTR)
      {
        return; // nothing more for now
      }
    }
  }

  /** The last line that is not blank, without control characters, shortened. */
  std::string LastLine() const
  {
    constexpr std::string_view blanks = " \t\r\n";
    std::string_view text = this->Tail;
    text = text.substr(0, text.find_last_not_of(blanks) + 1);
    text = text.substr(text.find_last_of("\r\n") + 1); // npos + 1 is 0
    text = text.substr(std::min(text.size(), text.find_first_not_of(blanks)));
    std::string line;
    constexpr std::size_t longest = 300;
    for (const char c : text.substr(0, longest))
    {
      line += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    while (!line.empty() && text.size() > longest && (line.back() & 0xC0) == 0x80)
    {
      line.pop_back(); // half a character of UTF-8
    }
    return line;
  }

private:
  void Keep(std::string_view bytes)
  {
    constexpr std::size_t tailSize = 4096;
    this->Tail.append(bytes.substr(bytes.size() - std::min(bytes.size(), tailSize)));
    this->Tail.erase(0, this->Tail.size() - std::min(this->Tail.size(), tailSize));
    if (!this->File.IsOpen())
    {
      return;
    }
    this->Write(bytes.substr(0, this->Room));
    if (bytes.size() > this->Room)
    {
      this->Write("\n[The output goes on; only its beginning is kept.]\n");
      this->File.Reset();
      return;
    }
    this->Room -= bytes.size();
  }

  void Write(std::string_view bytes)
  {
    while (!bytes.empty())
    {
      const ssize_t written = write(this->File.Get(), bytes.data(), bytes.size());
      if (written < 0 && errno != EINTR)
      {
        return; // a full disk must not end the run: the log is a courtesy
      }
      bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(0, written)));
    }
  }

  Descriptor File;
  Descriptor ReadEnd;
  Descriptor WriteEnd;
  std::size_t Room;
  std::string Tail;
};

/** The environment of this program with the changes for the child. */
std::vector<std::string> MakeEnvironment(const ChildProcess& child)
{
  std::vector<std::pair<std::string, std::string>> changes = child.Environment;
  changes.emplace_back("LC_NUMERIC", "C");
  // LC_ALL would win over LC_NUMERIC: its other effect that matters, the character set, is kept.
  if (const char* all = std::getenv("LC_ALL"); all && *all)
  {
    changes.emplace_back("LC_CTYPE", all);
  }
  std::vector<std::string> environment;
  for (char** entry = environ; entry && *entry; ++entry)
  {
    const std::string_view text(*entry);
    const std::string_view name = text.substr(0, text.find('='));
    const bool changed = name == "LC_ALL" ||
      std::any_of(
        changes.begin(), changes.end(), [&](const auto& change) { return change.first == name; });
    if (!changed)
    {
      environment.emplace_back(text);
    }
  }
  for (const auto& [name, value] : changes)
  {
    environment.push_back(name + '=' + value);
  }
  return environment;
}

std::vector<char*> MakePointers(const std::vector<std::string>& strings)
{
  std::vector<char*> pointers;
  for (const std::string& string : strings)
  {
    pointers.push_back(const_cast<char*>(string.c_str())); // C's interface; nobody writes
  }
  pointers.push_back(nullptr);
  return pointers;
}

/** What posix_spawn wants to know, freed at the end. */
class SpawnSettings
{
public:
  SpawnSettings(const std::filesystem::path& folder, int output, int errors)
  {
    posix_spawn_file_actions_init(&this->Actions);
    posix_spawnattr_init(&this->Attributes);
    posix_spawn_file_actions_addopen(&this->Actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&this->Actions, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&this->Actions, errors, STDERR_FILENO);
    if (!folder.empty())
    {
      posix_spawn_file_actions_addchdir_np(&this->Actions, folder.c_str());
    }
    posix_spawnattr_setflags(
      &this->Attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    posix_spawnattr_setpgroup(&this->Attributes, 0); // a group of its own
    sigset_t signals;
    sigfillset(&signals); // signals that this program ignores are not ignored in the child
    posix_spawnattr_setsigdefault(&this->Attributes, &signals);
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&this->Attributes, &signals);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  ~SpawnSettings()
  {
    posix_spawn_file_actions_destroy(&this->Actions);
    posix_spawnattr_destroy(&this->Attributes);
  }

  posix_spawn_file_actions_t Actions;
  posix_spawnattr_t Attributes;
};

/** A process that runs. Dies, with its whole group, at the end of the life of this object. */
class RunningProcess
{
public:
  explicit RunningProcess(pid_t process)
    : Process(process)
  {
  }
  RunningProcess(const RunningProcess&) = delete;
  RunningProcess& operator=(const RunningProcess&) = delete;
  ~RunningProcess() { this->Finish(); }

  /** Leaves the process unreaped, so that its number, and that of its group, stay its own. */
  bool HasEnded() const
  {
    siginfo_t information = {};
    const int error =
      waitid(P_PID, static_cast<id_t>(this->Process), &information, WEXITED | WNOHANG | WNOWAIT);
    return error == 0 ? information.si_pid != 0 : errno == ECHILD;
  }

  void Kill(int signal) const
  {
    kill(-this->Process, signal);
    kill(this->Process, signal);
  }

  /** Kills what is left of the group and returns the status as waitpid has it. */
  int Finish()
  {
    if (this->Process > 0)
    {
      this->Kill(SIGKILL);
      // Where the host program ignores SIGCHLD there is no status: taken for 0, because what the
      // program has written is checked anyway.
      while (waitpid(this->Process, &this->Status, 0) < 0 && errno == EINTR)
      {
      }
      this->Process = 0;
    }
    return this->Status;
  }

private:
  pid_t Process;
  int Status = 0;
};

ChildProcessResult NotStarted(const std::string& reason, bool missing)
{
  ChildProcessResult result;
  result.Reason = reason;
  result.IsMissing = missing;
  return result;
}

/** Waits until the child has ended, by itself or by force, and says which. */
Ending WaitForEnd(
  const ChildProcess& child, const RunningProcess& process, OutputLog& output, OutputLog& errors)
{
  const Clock::time_point start = Clock::now();
  Clock::time_point nextReport = start;
  Clock::time_point terminated;
  Ending ending = Ending::Exited;
  for (;;)
  {
    std::array<pollfd, 2> pipes{ pollfd{ output.GetReadEnd(), POLLIN, 0 },
      pollfd{ errors.GetReadEnd(), POLLIN, 0 } }; // poll skips negative descriptors
    const bool silent = pipes[0].fd < 0 && pipes[1].fd < 0;
    poll(pipes.data(), pipes.size(), silent ? PollMilliseconds / 10 : PollMilliseconds);
    output.Drain();
    errors.Drain();
    if (process.HasEnded())
    {
      return ending;
    }
    const Clock::time_point now = Clock::now();
    if (ending != Ending::Exited)
    {
      if (now - terminated > GraceAfterTerminate)
      {
        process.Kill(SIGKILL);
      }
      continue;
    }
    const double seconds = Seconds(now - start).count();
    if (child.TimeLimit > 0.0 && seconds > child.TimeLimit)
    {
      ending = Ending::TimeLimit;
    }
    else if (now >= nextReport && child.GoOn && !child.GoOn(seconds))
    {
      ending = Ending::Cancelled;
    }
    nextReport = now >= nextReport
      ? now + std::chrono::duration_cast<Clock::duration>(ReportInterval)
      : nextReport;
    if (ending != Ending::Exited)
    {
      terminated = now;
      process.Kill(SIGTERM);
    }
  }
}

} // namespace

ChildProcessResult RunChildProcess(const ChildProcess& child)
{
  if (child.Arguments.empty() || child.Arguments[0].empty())
  {
    return NotStarted("no program is given", true);
  }
  if (!child.WorkingDirectory.empty() && !std::filesystem::is_directory(child.WorkingDirectory))
  {
    return NotStarted("the folder \"" + child.WorkingDirectory.string() + "\" is missing", false);
  }
  OutputLog output(child.OutputFile, child.OutputLimit);
  OutputLog errors(child.ErrorFile, child.OutputLimit);
  const std::vector<std::string> environment = MakeEnvironment(child);
  const SpawnSettings settings(child.WorkingDirectory, output.GetWriteEnd(), errors.GetWriteEnd());
  pid_t id = 0;
  const int error = posix_spawn(&id, child.Arguments[0].c_str(), &settings.Actions,
    &settings.Attributes, MakePointers(child.Arguments).data(), MakePointers(environment).data());
  if (error != 0)
  {
    return NotStarted(std::strerror(error), error == ENOENT || error == ENOTDIR);
  }
  RunningProcess process(id);
  output.CloseWriteEnd();
  errors.CloseWriteEnd();

  ChildProcessResult result;
  result.How = WaitForEnd(child, process, output, errors);
  const int status = process.Finish();
  output.Drain();
  errors.Drain();
  result.LastErrorLine = errors.LastLine();
  if (result.How == Ending::Exited && WIFSIGNALED(status))
  {
    result.How = Ending::Signal;
    const char* name = sigabbrev_np(WTERMSIG(status));
    const char* words = sigdescr_np(WTERMSIG(status));
    result.Reason =
      name && words ? "SIG" + std::string(name) + ", " + words : std::to_string(WTERMSIG(status));
  }
  result.ExitStatus = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  return result;
}

} // namespace pemesh
