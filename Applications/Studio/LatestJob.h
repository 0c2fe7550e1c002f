// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   LatestJob
 * @brief   Work in a thread of its own, of which only the latest is of interest.
 *
 * A slider that moves asks for a hundred meshes: the one that is being made is finished if that
 * takes no longer than the patience, else it is told to stop; the one asked for last is made next;
 * those between are never begun. Results are delivered in the thread of the object, in the order
 * they were asked for.
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

  /** Stops what is running and forgets what is waiting. */
  void Cancel();

  bool IsBusy() const { return this->Busy; }

signals:
  void BusyChanged(bool busy);

private:
  void Deliver(const Delivery& delivery, bool isLast);
  void StopIfStale();

  struct Shared;
  std::unique_ptr<Shared> Worker;
  int Patience;
  bool Busy = false;
};

} // namespace pemesh

#endif
