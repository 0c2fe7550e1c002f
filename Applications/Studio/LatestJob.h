// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   LatestJob
 * @brief   Work in a thread of its own, of which only the latest is of interest.
 *
 * A slider that moves asks for a hundred meshes: the one that is being made is finished if that
 * takes no longer than the patience, else it is told to stop; the one asked for last is made next;
 * those between are never begun. Results are delivered in the thread of the object, in the order
 * they were asked for; nothing that was asked for before a Cancel() is delivered after it.
 */
#ifndef pemesh_LatestJob_h
#define pemesh_LatestJob_h

#include <QObject>

#include <atomic>
#include <functional>
#include <memory>

namespace pemesh
{

class LatestJob : public QObject
{
  Q_OBJECT
public:
  /** What to do with a result, in the thread of the object; may be empty. */
  using Delivery = std::function<void()>;
  /** Runs in the worker. It must end soon once `stop` is true; what it answers is then dropped. */
  using Work = std::function<Delivery(const std::atomic<bool>& stop)>;

  explicit LatestJob(QObject* parent = nullptr, int patienceMilliseconds = 250);
  /** Stops what is running and waits for it. */
  ~LatestJob() override;

  void Start(Work work);

  /** Stops what is running, forgets what is waiting, and drops what is done but not delivered. */
  void Cancel();

  /** From Start() until the delivery of what was asked for last, or the end of what was cancelled.
   */
  bool IsBusy() const { return this->Busy; }

signals:
  void BusyChanged(bool busy);

private:
  void RunJobs();
  void Deliver(const Delivery& delivery, long number);
  void SetBusy(bool busy);
  void StopIfStale();

  struct Shared;
  std::unique_ptr<Shared> Worker;
  int Patience;
  long Started = 0;   // jobs are numbered from 1
  long Awaited = 0;   // the job whose end is the end of being busy
  long Cancelled = 0; // no job up to this one is delivered any more
  bool Busy = false;
};

} // namespace pemesh

#endif
