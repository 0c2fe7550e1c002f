// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseGate.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

TEST(CaseGate, TheFirstIsAloneAndThenAsManyAsFit)
{
  double peak = 100.0;
  pemesh::CaseGate gate(300.0, [&peak] { return peak; });
  EXPECT_EQ(gate.GetMost(), 1);
  gate.Enter();
  peak = 150.0;
  gate.Leave();
  EXPECT_EQ(gate.GetMost(), 4); // (300 - 100) / 50
  for (int i = 0; i < 4; ++i)
  {
    gate.Enter();
  }
  peak = 500.0; // larger ones: 100 each
  gate.Leave();
  EXPECT_EQ(gate.GetMost(), 2);
  peak = 3000.0; // more than there is, but one must go on
  gate.Leave();
  EXPECT_EQ(gate.GetMost(), 1);
}

TEST(CaseGate, WithoutABudgetNobodyWaits)
{
  pemesh::CaseGate gate(0.0, [] { return 1e12; });
  for (int i = 0; i < 100; ++i)
  {
    gate.Enter();
  }
  EXPECT_GT(gate.GetMost(), 100);
}

TEST(CaseGate, HoldsThreadsBack)
{
  std::atomic<int> inside{ 0 };
  std::atomic<int> most{ 0 };
  std::atomic<int> passed{ 0 };
  pemesh::CaseGate gate(100.0, [&inside] { return 40.0 * inside; });
  std::vector<std::jthread> threads;
  for (int i = 0; i < 8; ++i)
  {
    threads.emplace_back(
      [&]
      {
        gate.Enter();
        const int now = ++inside;
        int before = most;
        while (before < now && !most.compare_exchange_weak(before, now))
        {
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        ++passed;
        gate.Leave();
        --inside;
      });
  }
  threads.clear();
  EXPECT_EQ(passed, 8);
  EXPECT_LE(most, 3) << "two fit; a third may enter before the one that leaves has counted itself";
}
