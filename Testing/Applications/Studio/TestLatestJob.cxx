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

} // namespace

TEST(LatestJob, DeliversInItsOwnThreadAndDropsWhatWasOvertaken)
{
  LatestJob job(nullptr, 10000);
  std::vector<int> delivered;
  for (int i = 0; i < 20; ++i)
  {
    job.Start(
      [i, &delivered](const std::atomic<bool>& stop)
      {
        return Work(40, stop,
          [i, &delivered, thread = QThread::currentThread()]
          {
            EXPECT_NE(thread, QThread::currentThread());
            delivered.push_back(i);
          });
      });
  }
  ASSERT_TRUE(WaitFor([&job] { return !job.IsBusy(); }));
  ASSERT_FALSE(delivered.empty());
  EXPECT_EQ(delivered.back(), 19);
  EXPECT_LE(delivered.size(), 3U) << "jobs that were overtaken were done all the same";
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
  EXPECT_LT(clock.elapsed(), 5000);
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

TEST(LatestJob, CancellingLeavesItIdle)
{
  LatestJob job;
  for (int i = 0; i < 20; ++i)
  {
    bool delivered = false;
    job.Start([&delivered](const std::atomic<bool>& stop)
      { return Work(5, stop, [&delivered] { delivered = true; }); });
    WaitFor([] { return false; }, i % 3);
    job.Cancel();
    ASSERT_TRUE(WaitFor([&job] { return !job.IsBusy(); }, 2000));
    if (i % 3 == 0)
    {
      EXPECT_FALSE(delivered);
    }
  }
}
