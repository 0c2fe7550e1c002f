// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChildProcess.h"

#include "NumberText.h"
#include "OutputLog.h"
#include "ProcessPipe.h"
#include "SolverCommand.h"
#include "SupervisorProtocol.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
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

constexpr const char* Supervisor = "pemesh-supervise";
constexpr Seconds ReportInterval{ 0.1 };

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
  SpawnSettings(const std::filesystem::path& folder)
  {
    posix_spawn_file_actions_init(&this->Actions);
    posix_spawnattr_init(&this->Attributes);
    posix_spawn_file_actions_addopen(&this->Actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (!folder.empty())
    {
      posix_spawn_file_actions_addchdir_np(&this->Actions, folder.c_str());
    }
    posix_spawnattr_setflags(
      &this->Attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    posix_spawnattr_setpgroup(&this->Attributes, 0); // Ctrl-C at the terminal is not for it
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

  void Give(const FileDescriptor& descriptor, int number)
  {
    posix_spawn_file_actions_adddup2(&this->Actions, descriptor.Get(), number);
  }

  posix_spawn_file_actions_t Actions;
  posix_spawnattr_t Attributes;
};

ChildProcessResult NotStarted(const std::string& reason, bool missing)
{
  ChildProcessResult result;
  result.Reason = reason;
  result.IsMissing = missing;
  return result;
}

ChildProcessResult NotStarted(int error)
{
  return NotStarted(std::strerror(error), error == ENOENT || error == ENOTDIR);
}

/** One child under supervision, from its start to what the supervisor reports of it. */
class SupervisedProcess
{
public:
  explicit SupervisedProcess(const ChildProcess& child)
    : Child(child)
    , Output(child.OutputFile, child.OutputLimit)
    , Errors(child.ErrorFile, child.OutputLimit)
  {
  }
  SupervisedProcess(const SupervisedProcess&) = delete;
  SupervisedProcess& operator=(const SupervisedProcess&) = delete;
  /** An exception of GoOn leaves nobody behind. */
  ~SupervisedProcess()
  {
    this->Control.WriteEnd.Reset();
    this->Finish();
  }

  /** 0, or the errno that kept the supervisor itself from starting. */
  int Start(const std::filesystem::path& supervisor)
  {
    SpawnSettings settings(this->Child.WorkingDirectory);
    settings.Give(this->Output.GetPipe().WriteEnd, STDOUT_FILENO);
    settings.Give(this->Errors.GetPipe().WriteEnd, STDERR_FILENO);
    settings.Give(this->Control.ReadEnd, ControlDescriptor);
    settings.Give(this->Report.WriteEnd, ReportDescriptor);
    std::vector<std::string> arguments{ supervisor.string() };
    for (const double limit : { this->Child.TimeLimit, this->Child.ProcessorLimit,
           this->Child.MemoryLimit, this->Child.FileLimit })
    {
      arguments.push_back(FormatNumber(limit));
    }
    arguments.insert(arguments.end(), this->Child.Arguments.begin(), this->Child.Arguments.end());
    const std::vector<std::string> environment = MakeEnvironment(this->Child);
    const int error = posix_spawn(&this->Process, supervisor.c_str(), &settings.Actions,
      &settings.Attributes, MakePointers(arguments).data(), MakePointers(environment).data());
    for (ProcessPipe* pipe : { &this->Output.GetPipe(), &this->Errors.GetPipe(), &this->Report })
    {
      pipe->WriteEnd.Reset();
    }
    this->Control.ReadEnd.Reset();
    return error;
  }

  /** Until the supervisor has said its last word; whether that is because GoOn said so. */
  bool WaitForEnd()
  {
    const Clock::time_point start = Clock::now();
    Clock::time_point nextReport = start;
    bool isCancelled = false;
    while (this->Report.ReadEnd.IsOpen())
    {
      std::array<pollfd, 3> pipes{ pollfd{ this->Output.GetPipe().ReadEnd.Get(), POLLIN, 0 },
        pollfd{ this->Errors.GetPipe().ReadEnd.Get(), POLLIN, 0 },
        pollfd{ this->Report.ReadEnd.Get(), POLLIN, 0 } }; // poll skips negative descriptors
      constexpr int milliseconds = 20;
      poll(pipes.data(), pipes.size(), milliseconds);
      this->Drain();
      const Clock::time_point now = Clock::now();
      if (now < nextReport || isCancelled)
      {
        continue;
      }
      nextReport = now + std::chrono::duration_cast<Clock::duration>(ReportInterval);
      if (this->Child.GoOn && !this->Child.GoOn(Seconds(now - start).count()))
      {
        isCancelled = true;
        this->Control.WriteEnd.Reset();
      }
    }
    return isCancelled;
  }

  /** Waits for the supervisor, and ends what it could not if it was killed. */
  void Finish()
  {
    while (this->Process > 0 && waitpid(this->Process, nullptr, 0) < 0 && errno == EINTR)
    {
    }
    this->Process = 0;
    this->Drain();
    pid_t program = 0;
    if (IsStart(this->Words) && this->LastWords().empty())
    {
      std::istringstream(this->Words.substr(this->Words.find(' '))) >> program;
    }
    if (program > 0)
    {
      kill(-program, SIGKILL);
    }
  }

  /** The line about the ending. */
  std::string LastWords() const
  {
    const std::size_t end = this->Words.rfind('\n');
    if (end == std::string::npos)
    {
      return {};
    }
    const std::size_t before = end == 0 ? end : this->Words.rfind('\n', end - 1);
    const std::string line = this->Words.substr(before + 1, end - before - 1); // npos + 1 is 0
    return IsStart(line) ? std::string() : line;
  }

  std::string LastErrorLine() const { return this->Errors.LastLine(); }

private:
  static bool IsStart(const std::string& line)
  {
    return line.rfind(std::string(StartedWord) + ' ', 0) == 0;
  }

  void Drain()
  {
    this->Output.Drain();
    this->Errors.Drain();
    constexpr std::size_t most = 256;
    this->Words += this->Report.Read(most);
  }

  const ChildProcess& Child;
  OutputLog Output;
  OutputLog Errors;
  ProcessPipe Control;
  ProcessPipe Report;
  std::string Words; // of the supervisor
  pid_t Process = 0; // the supervisor
};

std::string DescribeSignal(int number)
{
  const char* name = sigabbrev_np(number);
  const char* words = sigdescr_np(number);
  return name && words ? "SIG" + std::string(name) + ", " + words : std::to_string(number);
}

/** The words of the supervisor's report for an ending that is more than a status. */
struct EndingWord
{
  const char* Word;
  Ending How;
};
constexpr std::array<EndingWord, 6> EndingWords{ { { ExitedWord, Ending::Exited },
  { SignalWord, Ending::Signal }, { TimeWord, Ending::TimeLimit },
  { ProcessorWord, Ending::ProcessorLimit }, { MemoryWord, Ending::MemoryLimit },
  { AskedWord, Ending::Cancelled } } };

ChildProcessResult ReadReport(const std::string& line)
{
  std::istringstream stream(line);
  std::string word;
  int number = 0;
  ChildProcessResult result;
  stream >> word >> number >> result.ProcessorSeconds >> result.PeakMemory >> result.ProcessesLeft;
  if (word == NotStartedWord)
  {
    return NotStarted(number);
  }
  result.How = Ending::Signal;
  result.Reason = "SIGKILL, Killed, together with its supervisor";
  for (const EndingWord& known : EndingWords)
  {
    if (word == known.Word)
    {
      result.How = known.How;
      result.Reason = result.How == Ending::Signal ? DescribeSignal(number) : std::string();
    }
  }
  result.IsFileTooLarge = result.How == Ending::Signal && number == SIGXFSZ;
  result.ExitStatus = result.How == Ending::Exited ? number : 0;
  return result;
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
  const std::filesystem::path supervisor = FindSolverProgram(Supervisor, {});
  if (supervisor.empty())
  {
    return NotStarted(std::string(Supervisor) +
        ", the program of PEMesh that keeps watch over solvers, is not beside pemesh nor in PATH",
      false);
  }
  SupervisedProcess process(child);
  const int error = process.Start(supervisor);
  if (error != 0)
  {
    return NotStarted(error);
  }
  const bool isCancelled = process.WaitForEnd();
  process.Finish();
  ChildProcessResult result = ReadReport(process.LastWords());
  // A program that ends by itself while it is being cancelled has been cancelled.
  result.How = isCancelled && result.How != Ending::NotStarted ? Ending::Cancelled : result.How;
  result.LastErrorLine = process.LastErrorLine();
  return result;
}

} // namespace pemesh
