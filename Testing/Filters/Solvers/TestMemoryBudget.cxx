// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MemoryBudget.h"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

using pemesh::MemoryBudget;

namespace
{

bool Always()
{
  return true;
}

bool Never()
{
  return false;
}

} // namespace

TEST(MemoryBudget, AKnownLimitIsTheNeed)
{
  MemoryBudget budget(100.0);
  EXPECT_EQ(budget.Take("a", 40.0, Always), 40.0);
  EXPECT_EQ(budget.Take("a", 60.0, Always), 60.0);
  EXPECT_LT(budget.Take("a", 1.0, Never), 0.0); // full
  budget.GiveBack("a", 40.0, 10.0);
  EXPECT_LT(budget.Take("a", 41.0, Never), 0.0);
  EXPECT_EQ(budget.Take("a", 40.0, Never), 40.0); // nobody is asked where there is room
}

TEST(MemoryBudget, AnUnknownNeedRunsAloneAndIsLearnt)
{
  MemoryBudget budget(100.0);
  EXPECT_EQ(budget.Take("a", 0.0, Always), 100.0);
  EXPECT_LT(budget.Take("b", 1.0, Never), 0.0);
  budget.GiveBack("a", 100.0, 16.0);
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_EQ(budget.Take("a", 0.0, Always), 20.0);
  }
  EXPECT_LT(budget.Take("a", 0.0, Never), 0.0);
  for (int i = 0; i < 5; ++i)
  {
    budget.GiveBack("a", 20.0, 80.0);
  }
  EXPECT_EQ(budget.Take("a", 0.0, Always), 100.0);
  budget.GiveBack("a", 100.0, 0.0);
  EXPECT_EQ(budget.Take("b", 500.0, Always), 100.0); // larger than all there is: alone
}

TEST(MemoryBudget, NeverMoreThanThereIs)
{
  MemoryBudget budget(100.0);
  std::atomic<int> used{ 0 };
  std::atomic<int> most{ 0 };
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t)
  {
    threads.emplace_back(
      [&, t]
      {
        for (int i = 0; i < 10; ++i)
        {
          const int need = 10 + 13 * ((t + i) % 6); // up to 75
          const double taken = budget.Take("s", need, Always);
          const int now = used += need;
          int before = most;
          while (now > before && !most.compare_exchange_weak(before, now))
          {
          }
          std::this_thread::sleep_for(std::chrono::microseconds(300));
          used -= need;
          budget.GiveBack("s", taken, need);
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_LE(most, 100);
  EXPECT_GT(most, 75); // several at a time
}

TEST(MemoryBudget, NothingIsLearntFromARunThatWasNotMeasured)
{
  MemoryBudget budget(100.0);
  EXPECT_EQ(budget.Take("a", 0.0, Always), 100.0);
  budget.GiveBack("a", 100.0, 0.0);
  EXPECT_EQ(budget.Take("a", 0.0, Always), 100.0); // not 0, which would let all of them run
}

TEST(MemoryBudget, WhoIsInterruptedHoldsNobodyUp)
{
  MemoryBudget budget(100.0);
  const double taken = budget.Take("a", 100.0, Always);
  EXPECT_THROW(budget.Take("b", 50.0, []() -> bool { throw std::runtime_error("enough"); }),
    std::runtime_error);
  budget.GiveBack("a", taken, 1.0);
  EXPECT_EQ(budget.Take("c", 100.0, Never), 100.0);
}
