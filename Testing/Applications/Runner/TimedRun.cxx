// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TimedRun.h"

#include "vtkPEMRunner.h"

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <thread>

bool RunInTime(vtkPEMRunner* runner, const std::string& name)
{
  using namespace std::chrono_literals;
  std::mutex mutex;
  std::condition_variable changed;
  bool isDone = false;
  bool isLate = false;
  std::thread watch(
    [&]
    {
      std::unique_lock lock(mutex);
      if (changed.wait_for(lock, 180s, [&] { return isDone; }))
      {
        return;
      }
      isLate = true;
      runner->RequestStop();
      if (!changed.wait_for(lock, 60s, [&] { return isDone; }))
      {
        std::cerr << "The study \"" << name << "\" hangs, and does not stop when asked.\n";
        std::quick_exit(EXIT_FAILURE);
      }
    });
  runner->Run();
  {
    const std::lock_guard lock(mutex);
    isDone = true;
  }
  changed.notify_one();
  watch.join();
  return !isLate;
}
