// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverQueue.h"

#include <algorithm>

namespace pemesh
{

SolverQueue::SolverQueue(int workers, int atWork)
  : Free(std::max(1, atWork))
  , Workers(workers)
{
}

void SolverQueue::Leave()
{
  const std::scoped_lock lock(this->Mutex);
  --this->Workers;
  this->Changed.notify_all();
}

SolverQueue::Worker::Worker(SolverQueue& queue)
  : Queue(queue)
{
  std::unique_lock lock(queue.Mutex);
  queue.BeginWork(lock);
}

SolverQueue::Worker::~Worker()
{
  const std::scoped_lock lock(this->Queue.Mutex);
  --this->Queue.Workers;
  this->Queue.EndWork();
}

void SolverQueue::BeginWork(std::unique_lock<std::mutex>& lock)
{
  this->Changed.wait(lock, [this] { return this->Free > 0; });
  --this->Free;
}

void SolverQueue::EndWork()
{
  ++this->Free;
  this->Changed.notify_all();
}

void SolverQueue::Ask(const std::string& key, std::size_t most, void* request, const Answer& answer)
{
  std::unique_lock lock(this->Mutex);
  std::shared_ptr<Call>& open = this->Open[key];
  if (!open)
  {
    open = std::make_shared<Call>();
  }
  const std::shared_ptr<Call> call = open;
  call->Members.push_back(request);
  ++this->Pending;
  if (call->Members.size() >= std::max<std::size_t>(1, most))
  {
    this->Open.erase(key); // who comes from now on opens another one
  }
  this->EndWork();
  const auto mayStart = [&]
  {
    const auto found = this->Open.find(key);
    const bool isFull = found == this->Open.end() || found->second != call;
    return !call->IsTaken && (isFull || this->Pending == this->Workers);
  };
  this->Changed.wait(lock, [&] { return call->IsDone || (this->Free > 0 && mayStart()); });
  if (!call->IsDone)
  {
    call->IsTaken = true;
    this->Pending -= static_cast<int>(call->Members.size());
    if (const auto found = this->Open.find(key); found != this->Open.end() && found->second == call)
    {
      this->Open.erase(found);
    }
    this->BeginWork(lock);
    lock.unlock();
    answer(call->Members);
    lock.lock();
    call->IsDone = true;
    this->EndWork();
  }
  this->BeginWork(lock);
}

} // namespace pemesh
