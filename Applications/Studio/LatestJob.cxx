// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LatestJob.h"

#include <QTimer>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace pemesh
{

namespace
{
using Clock = std::chrono::steady_clock;
}

struct LatestJob::Shared
{
  std::mutex Mutex;
  std::condition_variable Changed;
  Work Next;
  bool Quit = false;
  bool Running = false;
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
  }
  worker.Changed.notify_one();
  if (!worker.Thread.joinable())
  {
    worker.Thread = std::thread(
      [this, &worker]
      {
        std::unique_lock lock(worker.Mutex);
        while (true)
        {
          worker.Changed.wait(lock, [&worker] { return worker.Quit || worker.Next; });
          if (worker.Quit)
          {
            return;
          }
          const Work job = std::exchange(worker.Next, {});
          worker.Running = true;
          worker.Since = Clock::now();
          worker.Stop = false;
          lock.unlock();
          Delivery delivery = job(worker.Stop);
          lock.lock();
          worker.Running = false;
          const bool isLast = !worker.Next;
          delivery = worker.Stop ? Delivery() : std::move(delivery);
          QMetaObject::invokeMethod(
            this, [this, delivery, isLast] { this->Deliver(delivery, isLast); },
            Qt::QueuedConnection);
        }
      });
  }
  if (!std::exchange(this->Busy, true))
  {
    emit this->BusyChanged(true);
  }
  this->StopIfStale();
}

void LatestJob::StopIfStale()
{
  Shared& worker = *this->Worker;
  const std::scoped_lock lock(worker.Mutex);
  if (!worker.Running || !worker.Next)
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
  bool isIdle = false;
  {
    const std::scoped_lock lock(this->Worker->Mutex);
    this->Worker->Next = {};
    this->Worker->Stop = true;
    isIdle = !this->Worker->Running; // then nothing will be delivered any more
  }
  if (isIdle && std::exchange(this->Busy, false))
  {
    emit this->BusyChanged(false);
  }
}

void LatestJob::Deliver(const Delivery& delivery, bool isLast)
{
  if (delivery)
  {
    delivery();
  }
  if (isLast && std::exchange(this->Busy, false))
  {
    emit this->BusyChanged(false);
  }
}

} // namespace pemesh
