// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * pemesh-supervise TIME CPU MEMORY FILE PROGRAM ARGUMENT...
 *
 * Runs a program, ends it with all that it has started, and reports. The four limits are seconds,
 * seconds of processors, bytes of all processes together and bytes of each file written; 0 is none.
 *
 * Descriptor 3 is the control: a byte, or its other end closed, asks to end the program. To
 * descriptor 4 go two lines, the process of the program before it starts, and its ending:
 *
 *   started PROCESS
 *   WORD NUMBER CPU-SECONDS PEAK-BYTES LEFT
 *
 * where WORD NUMBER is "exited" and a status, "signal" and its number, "time", "cpu", "memory" or
 * "asked" for what it was ended for, or "not-started" and an errno; LEFT counts the processes that
 * the program had left running when it ended by itself.
 */
#include "ProcessTree.h"
#include "SupervisorProtocol.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;
using pemesh::ControlDescriptor;
using pemesh::ReportDescriptor;

constexpr Seconds GraceAfterTerminate{ 0.5 };
constexpr Seconds LongestKilling{ 10.0 }; // a process that hangs in the kernel cannot be killed

struct Limits
{
  double Time = 0.0;
  double Processor = 0.0;
  double Memory = 0.0;
  double File = 0.0;
};

struct Usage
{
  double ProcessorSeconds = 0.0;
  double Memory = 0.0;
};

void Report(const std::string& line)
{
  if (write(ReportDescriptor, line.data(), line.size()) < 0)
  {
    return; // nobody listens any more
  }
}

/** Of all that has ended and been waited for. */
double ReapedProcessorSeconds()
{
  rusage reaped = {};
  getrusage(RUSAGE_CHILDREN, &reaped);
  const auto seconds = [](const timeval& time)
  { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
  return seconds(reaped.ru_utime) + seconds(reaped.ru_stime);
}

void ReportNotStarted(int error)
{
  Report(std::string(pemesh::NotStartedWord) + ' ' + std::to_string(error) + " 0 0 0\n");
}

/** In the child; comes back only if it cannot. */
void BecomeProgram(char** arguments, const Limits& limits)
{
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  rlimit limit = { 0, 0 };
  setrlimit(RLIMIT_CORE, &limit); // the memory of a crashed solver is no result
  if (limits.File > 0.0)
  {
    limit.rlim_cur = limit.rlim_max = static_cast<rlim_t>(limits.File);
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  for (const int number : { SIGTERM, SIGINT, SIGHUP, SIGPIPE })
  {
    std::signal(number, SIG_DFL);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  // Said by the program's own process, because it may kill this program first of all.
  Report(std::string(pemesh::StartedWord) + ' ' + std::to_string(getpid()) + '\n');
  execv(arguments[0], arguments);
}

/** The process of the program; where there is none, the reason is reported and 0 returned. */
pid_t Start(char** arguments, const Limits& limits)
{
  int failure[2];
  if (pipe2(failure, O_CLOEXEC) != 0)
  {
    ReportNotStarted(errno);
    return 0;
  }
  const pid_t child = fork();
  if (child == 0)
  {
    BecomeProgram(arguments, limits);
    const int error = errno;
    const ssize_t ignored = write(failure[1], &error, sizeof(error));
    _exit(ignored < 0 ? 126 : 127);
  }
  int error = child < 0 ? errno : 0;
  close(failure[1]);
  const ssize_t got = child < 0 ? 0 : read(failure[0], &error, sizeof(error));
  close(failure[0]);
  if (child < 0 || got > 0)
  {
    ReportNotStarted(error);
    return 0;
  }
  return child;
}

class Supervision
{
public:
  Supervision(pid_t program, const Limits& limits, int children)
    : Program(program)
    , Bounds(limits)
    , Children(children)
  {
  }

  void Run()
  {
    while (!this->Reap() && !(this->Ending && Clock::now() - this->Asked > LongestKilling))
    {
      this->Wait();
      if (this->Ending)
      {
        this->End();
        continue;
      }
      this->Measure();
      this->Ending = this->WhyEnd();
      if (this->Ending)
      {
        this->Asked = Clock::now();
        this->Signal(SIGTERM);
      }
    }
    this->EndTheRest();
    this->Tell();
  }

private:
  /** Waits for all that has ended, but for the program: its number stays its own; whether it has.
   */
  bool Reap()
  {
    siginfo_t ended = {};
    while (!this->HasEnded && waitid(P_ALL, 0, &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
      ended.si_pid != 0)
    {
      this->HasEnded = ended.si_pid == this->Program;
      if (!this->HasEnded)
      {
        waitpid(ended.si_pid, nullptr, WNOHANG);
      }
      ended = {};
    }
    return this->HasEnded;
  }

  /** Until a child ends, the control speaks, or it is time to measure again. */
  void Wait()
  {
    const auto left = this->NextMeasure - Clock::now();
    const auto milliseconds = std::chrono::duration_cast<std::chrono::milliseconds>(left).count();
    std::array<pollfd, 2> descriptors{ pollfd{ this->Ending ? -1 : ControlDescriptor, POLLIN, 0 },
      pollfd{ this->Children, POLLIN, 0 } };
    constexpr long long shortest = 1;
    constexpr long long longest = 20;
    poll(descriptors.data(), descriptors.size(),
      static_cast<int>(std::clamp<long long>(milliseconds, shortest, longest)));
    this->IsAsked = this->IsAsked || descriptors[0].revents != 0;
    signalfd_siginfo information;
    while (read(this->Children, &information, sizeof(information)) > 0)
    {
    }
  }

  /** Not more often than costs a fiftieth of a processor. */
  void Measure()
  {
    const Clock::time_point start = Clock::now();
    if (start < this->NextMeasure)
    {
      return;
    }
    Usage usage{ ReapedProcessorSeconds(), 0.0 };
    for (const pid_t process : pemesh::Descendants())
    {
      const pemesh::ProcessUsage of = pemesh::UsageOf(process);
      usage.ProcessorSeconds += of.ProcessorSeconds;
      usage.Memory += static_cast<double>(of.Memory);
    }
    this->Now = usage;
    this->Peak = std::max(this->Peak, usage.Memory);
    constexpr int rarity = 50;
    constexpr std::chrono::milliseconds least{ 20 };
    const Clock::time_point end = Clock::now();
    this->NextMeasure = end + std::max<Clock::duration>(least, rarity * (end - start));
  }

  const char* WhyEnd() const
  {
    if (this->IsAsked)
    {
      return pemesh::AskedWord;
    }
    if (this->Bounds.Memory > 0.0 && this->Now.Memory > this->Bounds.Memory)
    {
      return pemesh::MemoryWord;
    }
    if (this->Bounds.Processor > 0.0 && this->Now.ProcessorSeconds > this->Bounds.Processor)
    {
      return pemesh::ProcessorWord;
    }
    const bool isLate =
      this->Bounds.Time > 0.0 && Seconds(Clock::now() - this->Begin).count() > this->Bounds.Time;
    return isLate ? pemesh::TimeWord : nullptr;
  }

  /** The group as well, because a process that forks meanwhile may be missed among the others. */
  void Signal(int number) const
  {
    kill(-this->Program, number);
    for (const pid_t process : pemesh::Descendants())
    {
      kill(process, number);
    }
  }

  /** A launcher such as mpirun may clean up first; memory that grows cannot wait for that. */
  void End() const
  {
    const bool isUrgent = this->Ending == std::string_view(pemesh::MemoryWord);
    if (isUrgent || Clock::now() - this->Asked > GraceAfterTerminate)
    {
      this->Signal(SIGKILL);
    }
  }

  void EndTheRest()
  {
    for (const pid_t process : pemesh::Descendants())
    {
      this->Left += pemesh::UsageOf(process).IsAlive ? 1 : 0;
    }
    const Clock::time_point start = Clock::now();
    for (bool isAlone = false; !isAlone && Clock::now() - start < LongestKilling;)
    {
      this->Signal(SIGKILL);
      isAlone = true;
      for (const pid_t process : pemesh::Descendants())
      {
        if (process != this->Program)
        {
          waitpid(process, nullptr, WNOHANG);
          isAlone = false;
        }
      }
      constexpr useconds_t aMoment = 1000;
      usleep(isAlone ? 0 : aMoment);
    }
    waitpid(this->Program, &this->Status, WNOHANG);
  }

  void Tell()
  {
    rusage reaped = {};
    getrusage(RUSAGE_CHILDREN, &reaped); // the peak of the largest process, exact
    this->Peak = std::max(this->Peak, 1024.0 * static_cast<double>(reaped.ru_maxrss));
    std::string how = this->Ending ? this->Ending + std::string(" 0")
      : WIFSIGNALED(this->Status)
      ? std::string(pemesh::SignalWord) + ' ' + std::to_string(WTERMSIG(this->Status))
      : std::string(pemesh::ExitedWord) + ' ' + std::to_string(WEXITSTATUS(this->Status));
    constexpr int room = 128;
    char numbers[room];
    std::snprintf(
      numbers, room, " %.6f %.0f %d\n", ReapedProcessorSeconds(), this->Peak, this->Left);
    Report(how + numbers);
  }

  pid_t Program;
  Limits Bounds;
  int Children; // tells of SIGCHLD
  Clock::time_point Begin = Clock::now();
  Clock::time_point NextMeasure = Begin;
  Clock::time_point Asked;
  const char* Ending = nullptr; // why it is being ended
  bool IsAsked = false;
  bool HasEnded = false;
  int Status = 0;
  int Left = 0;
  Usage Now;
  double Peak = 0.0;
};

/** Ends all descendants, wherever they hide. */
void EndDescendants()
{
  const Clock::time_point start = Clock::now();
  while (Clock::now() - start < LongestKilling)
  {
    for (const pid_t process : pemesh::Descendants())
    {
      kill(process, SIGKILL);
    }
    while (waitpid(-1, nullptr, WNOHANG) > 0)
    {
    }
    siginfo_t information;
    if (waitid(P_ALL, 0, &information, WEXITED | WNOHANG | WNOWAIT) != 0)
    {
      return; // no child is left
    }
    constexpr useconds_t aMoment = 1000;
    usleep(aMoment);
  }
}

/**
 * Stays behind as the parent of the process that keeps watch, which the program can name and so
 * may kill: what the program has started falls to this one then, and is ended. In the process that
 * keeps watch it comes back.
 */
void LeaveGuard()
{
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  const pid_t watch = fork();
  if (watch <= 0) // where there is no room for another process it has to do without
  {
    return;
  }
  close_range(STDIN_FILENO, ~0U, 0); // the host waits for the end of the report
  int status = 0;
  while (waitpid(watch, &status, 0) < 0 && errno == EINTR)
  {
  }
  EndDescendants();
  _exit(WIFEXITED(status) ? WEXITSTATUS(status) : 1);
}

} // namespace

int main(int argc, char** argv)
{
  constexpr int firstArgument = 5;
  if (argc <= firstArgument || fcntl(ControlDescriptor, F_SETFD, FD_CLOEXEC) != 0 ||
    fcntl(ReportDescriptor, F_SETFD, FD_CLOEXEC) != 0)
  {
    std::fputs("pemesh-supervise is run by PEMesh, to keep watch over solvers.\n", stderr);
    return 2;
  }
  close_range(ReportDescriptor + 1, ~0U, 0); // what the host has left open is not the solver's
  const Limits limits{ std::strtod(argv[1], nullptr), std::strtod(argv[2], nullptr),
    std::strtod(argv[3], nullptr), std::strtod(argv[4], nullptr) };
  for (const int number : { SIGTERM, SIGINT, SIGHUP, SIGPIPE })
  {
    std::signal(number, SIG_IGN); // it ends when the solver has
  }
  LeaveGuard();
  prctl(PR_SET_CHILD_SUBREAPER, 1); // which is not inherited
  sigset_t child;
  sigemptyset(&child);
  sigaddset(&child, SIGCHLD);
  sigprocmask(SIG_BLOCK, &child, nullptr);
  const int children = signalfd(-1, &child, SFD_CLOEXEC | SFD_NONBLOCK);
  const pid_t program = Start(argv + firstArgument, limits);
  if (program == 0)
  {
    return 1;
  }
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDOUT_FILENO); // the solver alone holds the pipes of its output
  dup2(nowhere, STDERR_FILENO);
  Supervision(program, limits, children).Run();
  return 0;
}
