// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LatestJob.h"

#include <QTimer>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include <sys/resource.h>
#include <unistd.h>

namespace pemesh
{

namespace
{
using Clock = std::chrono::steady_clock;

/** This thread, and those that it starts, step back where there are more than processors. */
void YieldToWindow()
{
  constexpr int niceness = 5;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), niceness); // of a thread, on Linux
}
}

struct LatestJob::Shared
{
  std::mutex Mutex;
  std::condition_variable Changed;
  Work Next;
  long NextNumber = 0;
  bool Quit = false;
  long Running = 0; // the number of the job in the worker, 0 if there is none
  Clock::time_point Since;
  std::atomic<bool> Stop{ false };
  std::thread Thread;
};

LatestJob::LatestJob(QObject* parent, int patienceMilliseconds)
  : QObject(parent)
  , Worker(std::make_unique<Shared>())
  , Patience(patienceMilliseconds)
{
}

LatestJob::~LatestJob()
{
  {
    const std::scoped_lock lock(this->Worker->Mutex);
    this->Worker->Quit = true;
    this->Worker->Stop = true;
  }
  this->Worker->Changed.notify_one();
  if (this->Worker->Thread.joinable())
  {
    this->Worker->Thread.join();
  }
}

void LatestJob::Start(Work work)
{
  Shared& worker = *this->Worker;
  {
    const std::scoped_lock lock(worker.Mutex);
    worker.Next = std::move(work);
    worker.NextNumber = this->Awaited = ++this->Started;
  }
  worker.Changed.notify_one();
  if (!worker.Thread.joinable())
  {
    worker.Thread = std::thread([this] { this->RunJobs(); });
  }
  this->SetBusy(true);
  this->StopIfStale();
}

void LatestJob::RunJobs()
{
  YieldToWindow();
  Shared& worker = *this->Worker;
  std::unique_lock lock(worker.Mutex);
  while (true)
  {
    worker.Changed.wait(lock, [&worker] { return worker.Quit || worker.Next; });
    if (worker.Quit)
    {
      return;
    }
    const Work job = std::exchange(worker.Next, {});
    const long number = worker.Running = worker.NextNumber;
    worker.Since = Clock::now();
    worker.Stop = false;
    lock.unlock();
    Delivery delivery = job(worker.Stop);
    lock.lock();
    worker.Running = 0;
    delivery = worker.Stop ? Delivery() : std::move(delivery);
    QMetaObject::invokeMethod(
      this, [this, delivery, number] { this->Deliver(delivery, number); }, Qt::QueuedConnection);
  }
}

void LatestJob::StopIfStale()
{
  Shared& worker = *this->Worker;
  const std::scoped_lock lock(worker.Mutex);
  if (worker.Running == 0 || !worker.Next)
  {
    return;
  }
  const auto ran =
    std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - worker.Since);
  if (ran.count() >= this->Patience)
  {
    worker.Stop = true;
    return;
  }
  QTimer::singleShot(
    this->Patience - static_cast<int>(ran.count()), this, [this] { this->StopIfStale(); });
}

void LatestJob::Cancel()
{
  this->Cancelled = this->Started;
  {
    const std::scoped_lock lock(this->Worker->Mutex);
    this->Worker->Next = {};
    this->Worker->Stop = true;
    this->Awaited = this->Worker->Running;
  }
  if (this->Awaited == 0)
  {
    this->SetBusy(false);
  }
}

void LatestJob::Deliver(const Delivery& delivery, long number)
{
  if (delivery && number > this->Cancelled)
  {
    delivery(); // may ask for more
  }
  if (number == this->Awaited)
  {
    this->SetBusy(false);
  }
}

void LatestJob::SetBusy(bool busy)
{
  if (std::exchange(this->Busy, busy) != busy)
  {
    emit this->BusyChanged(busy);
  }
}

} // namespace pemesh
