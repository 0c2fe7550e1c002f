// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LatestJob.h"
#include "StudioSupport.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QThread>

#include <atomic>
#include <vector>

using pemesh::LatestJob;
using studio_test::WaitFor;

namespace
{

/** Works until it is stopped, or for some time. */
LatestJob::Delivery Work(int milliseconds, const std::atomic<bool>& stop, LatestJob::Delivery done)
{
  QElapsedTimer clock;
  clock.start();
  while (!stop && clock.elapsed() < milliseconds)
  {
    QThread::msleep(2);
  }
  return done;
}

/** Holds the thread until it is so. */
void WaitUntil(const std::atomic<bool>& itIsSo)
{
  while (!itIsSo)
  {
    QThread::msleep(1);
  }
}

} // namespace

TEST(LatestJob, DeliversInItsOwnThreadAndDropsWhatWasOvertaken)
{
  LatestJob job(nullptr, 1000000);
  std::vector<int> delivered;
  std::atomic<bool> allAreAsked{ false };
  for (int i = 0; i < 20; ++i)
  {
    job.Start(
      [i, &delivered, &allAreAsked](const std::atomic<bool>&) -> LatestJob::Delivery
      {
        WaitUntil(allAreAsked);
        return [i, &delivered, thread = QThread::currentThread()]
        {
          EXPECT_NE(thread, QThread::currentThread());
          delivered.push_back(i);
        };
      });
  }
  allAreAsked = true;
  ASSERT_TRUE(WaitFor([&job] { return !job.IsBusy(); }));
  ASSERT_FALSE(delivered.empty());
  EXPECT_EQ(delivered.back(), 19);
  EXPECT_LE(delivered.size(), 2U) << "jobs that were overtaken were done all the same";
}

TEST(LatestJob, StopsAStaleJobAfterItsPatience)
{
  LatestJob job(nullptr, 50);
  bool first = false;
  bool second = false;
  job.Start([&first](const std::atomic<bool>& stop)
    { return Work(60000, stop, [&first] { first = true; }); });
  studio_test::WaitFor([] { return false; }, 30);
  QElapsedTimer clock;
  clock.start();
  job.Start([&second](const std::atomic<bool>&) -> LatestJob::Delivery
    { return [&second] { second = true; }; });
  ASSERT_TRUE(WaitFor([&second] { return second; }));
  EXPECT_LT(clock.elapsed(), 40000);
  EXPECT_FALSE(first) << "what was stopped is no result";
}

TEST(LatestJob, EndsWithItsObjectInTheMiddleOfWork)
{
  std::atomic<bool> ended{ false };
  {
    LatestJob job;
    job.Start(
      [&ended](const std::atomic<bool>& stop)
      {
        Work(60000, stop, {});
        ended = true;
        return LatestJob::Delivery();
      });
    WaitFor([] { return false; }, 30);
  }
  EXPECT_TRUE(ended);
}

TEST(LatestJob, CancellingInTheMiddleOfWorkLeavesItIdle)
{
  LatestJob job;
  bool delivered = false;
  std::atomic<bool> began{ false };
  job.Start(
    [&](const std::atomic<bool>& stop)
    {
      began = true;
      return Work(60000, stop, [&delivered] { delivered = true; });
    });
  WaitUntil(began);
  job.Cancel();
  EXPECT_TRUE(job.IsBusy()) << "the worker still stops";
  EXPECT_TRUE(WaitFor([&job] { return !job.IsBusy(); }));
  EXPECT_FALSE(delivered);
}

TEST(LatestJob, WhatWasDoneButNotDeliveredIsDroppedByCancelling)
{
  LatestJob job;
  for (int i = 0; i < 200; ++i)
  {
    bool delivered = false;
    std::atomic<bool> done{ false };
    job.Start(
      [&](const std::atomic<bool>&) -> LatestJob::Delivery
      {
        done = true;
        return [&delivered] { delivered = true; };
      });
    WaitUntil(done); // no event is handled meanwhile: the delivery waits
    job.Cancel();
    ASSERT_TRUE(WaitFor([&job] { return !job.IsBusy(); }));
    WaitFor([] { return false; }, 1);
    ASSERT_FALSE(delivered);
  }
}

TEST(LatestJob, StaysBusyWhileADeliveryAsksForMore)
{
  LatestJob job;
  std::vector<bool> busy;
  QObject::connect(
    &job, &LatestJob::BusyChanged, &job, [&busy](bool isBusy) { busy.push_back(isBusy); });
  bool second = false;
  job.Start(
    [&](const std::atomic<bool>&) -> LatestJob::Delivery
    {
      return [&]
      {
        job.Start([&](const std::atomic<bool>&) -> LatestJob::Delivery
          { return [&second] { second = true; }; });
      };
    });
  ASSERT_TRUE(WaitFor([&second] { return second; }));
  ASSERT_TRUE(WaitFor([&job] { return !job.IsBusy(); }));
  EXPECT_EQ(busy, (std::vector<bool>{ true, false }));
}

TEST(LatestJob, WhatIsAskedForAfterCancellingIsDelivered)
{
  LatestJob job;
  for (int i = 0; i < 50; ++i)
  {
    bool old = false;
    bool latest = false;
    job.Start(
      [&old](const std::atomic<bool>& stop) { return Work(60000, stop, [&old] { old = true; }); });
    job.Cancel();
    job.Start([&latest](const std::atomic<bool>&) -> LatestJob::Delivery
      { return [&latest] { latest = true; }; });
    ASSERT_TRUE(WaitFor([&job] { return !job.IsBusy(); }));
    EXPECT_TRUE(latest);
    EXPECT_FALSE(old);
  }
}
