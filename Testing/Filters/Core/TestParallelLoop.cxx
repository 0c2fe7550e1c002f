// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ParallelLoop.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace
{

/** How often every index was visited, and from which threads. */
struct Visits
{
  explicit Visits(vtkIdType count)
    : Times(static_cast<std::size_t>(count))
  {
  }

  void Loop(vtkIdType grain)
  {
    pemesh::ParallelLoop(0, static_cast<vtkIdType>(this->Times.size()), grain,
      [this](vtkIdType first, vtkIdType last)
      {
        const std::scoped_lock lock(this->Mutex);
        this->Threads.insert(std::this_thread::get_id());
        ++this->Parts;
        for (vtkIdType i = first; i < last; ++i)
        {
          ++this->Times[static_cast<std::size_t>(i)];
        }
      });
  }

  std::vector<int> Times;
  std::set<std::thread::id> Threads;
  int Parts = 0;
  std::mutex Mutex;
};

} // namespace

TEST(ParallelLoop, VisitsEveryIndexOnceWithAndWithoutIdleCores)
{
  for (const int busy : { 0, 1, 2, 3 })
  {
    for (const vtkIdType count : { 0, 1, 7, 1000 })
    {
      for (const vtkIdType grain : { 0, 1, 3, 5000 })
      {
        const std::atomic<int> atWork{ busy };
        const pemesh::LoopShare share(atWork, 2);
        Visits visits(count);
        visits.Loop(grain);
        EXPECT_EQ(visits.Times, std::vector<int>(static_cast<std::size_t>(count), 1));
      }
    }
  }
}

TEST(ParallelLoop, StaysInItsThreadWhereAllCoresAreBusy)
{
  const std::atomic<int> atWork{ 2 };
  const pemesh::LoopShare share(atWork, 2);
  Visits visits(100000);
  visits.Loop(0);
  EXPECT_EQ(visits.Threads, std::set<std::thread::id>{ std::this_thread::get_id() });
  EXPECT_GT(visits.Parts, 100) << "a loop that is asked to stop must see it soon";
}

TEST(ParallelLoop, AShareInAShareEnds)
{
  const std::atomic<int> atWork{ 2 };
  const pemesh::LoopShare share(atWork, 2);
  {
    const pemesh::LoopShare wider(atWork, 3);
    EXPECT_TRUE(wider.HasIdleCores());
  }
  Visits visits(100000);
  visits.Loop(0);
  EXPECT_EQ(visits.Threads, std::set<std::thread::id>{ std::this_thread::get_id() });
}
