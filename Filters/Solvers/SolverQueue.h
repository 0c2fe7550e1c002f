// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Brings meshes of many workers together, for solvers that take a list of meshes a call.
 */
#ifndef pemesh_SolverQueue_h
#define pemesh_SolverQueue_h

#include "pemeshFiltersSolversModule.h" // For export macro

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace pemesh
{

/**
 * A worker (a thread) joins, brings one request at a time and waits for its answer. Requests of the
 * same key are answered together, by one of the workers that brought them: as soon as there are as
 * many as wanted, or when nobody is left who could bring another. A worker that waits lets another
 * one work: no more than so many are at work at a time.
 */
class PEMESHFILTERSSOLVERS_EXPORT SolverQueue
{
public:
  /** So many workers will come, of which so many may work at a time, at least one. */
  SolverQueue(int workers, int atWork);

  /** One of them will not come, or bring no more requests. */
  void Leave();

  /** One of them, from the time when it may work until it has no more requests. */
  class PEMESHFILTERSSOLVERS_EXPORT Worker
  {
  public:
    explicit Worker(SolverQueue& queue);
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    ~Worker();

  private:
    SolverQueue& Queue;
  };

  /** What the requests are is known to those who bring and answer them. */
  using Requests = std::vector<void*>;
  using Answer = std::function<void(const Requests&)>;

  /**
   * Comes back when the request has been answered, alone or together with others of its key, `most`
   * at the most. `answer` must not throw.
   */
  void Ask(const std::string& key, std::size_t most, void* request, const Answer& answer);

private:
  /** Requests that are answered together. */
  struct Call
  {
    Requests Members;
    bool IsTaken = false; // by the worker that answers
    bool IsDone = false;
  };

  void BeginWork(std::unique_lock<std::mutex>& lock);
  void EndWork();

  int Free;        // places to work
  int Workers;     // who may bring requests
  int Pending = 0; // of them, those whose requests wait for others to come
  std::map<std::string, std::shared_ptr<Call>> Open;
  std::mutex Mutex;
  std::condition_variable Changed;
};

} // namespace pemesh

#endif
