// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "FakeSolver.h"
#include "SolverQueue.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <set>
#include <thread>

using namespace pemesh;

namespace
{

SolverDescription ListSolver(int meshesPerCall)
{
  SolverDescription description = FakeSolver("ok");
  description.Command = { "./fake-list.sh", "{list}" };
  description.MeshesPerCall = meshesPerCall;
  return description;
}

/** The status of each mesh, solved by a worker each. */
std::map<std::string, std::string> SolveAll(const SolverDescription& description,
  const std::filesystem::path& folder, const std::vector<std::string>& names)
{
  SolverQueue queue(static_cast<int>(names.size()), 2);
  std::map<std::string, std::string> statuses;
  std::vector<std::string> found(names.size());
  std::vector<std::jthread> threads;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    threads.emplace_back(
      [&, i]
      {
        const SolverQueue::Worker worker(queue);
        auto solver = vtkSmartPointer<vtkPEMExternalSolver>::New();
        solver->SetDescription(description);
        solver->SetInputData(NamedHouse(names[i]));
        solver->SetRunName("run");
        solver->SetWorkDirectory(folder.string());
        solver->SetQueue(&queue);
        solver->Update();
        found[i] = GetFieldText(solver->GetOutput(), "run_Status");
        if (found[i] == "ok")
        {
          // The solver's answer is the first coordinate of each vertex.
          const auto values = PointValues(solver->GetOutput(), "run_Solution");
          const vtkIdType points = solver->GetOutput()->GetNumberOfPoints();
          ASSERT_EQ(static_cast<vtkIdType>(values.size()), points);
          for (vtkIdType id = 0; id < points; ++id)
          {
            EXPECT_EQ(values[static_cast<std::size_t>(id)], solver->GetOutput()->GetPoint(id)[0]);
          }
        }
      });
  }
  threads.clear();
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    statuses[names[i]] = found[i];
  }
  return statuses;
}

/** How many meshes the calls had, sorted. */
std::vector<int> Calls(const std::filesystem::path& folder)
{
  std::istringstream text(ReadBytes(folder / "calls.txt"));
  std::vector<int> calls;
  for (int count = 0; text >> count;)
  {
    calls.push_back(count);
  }
  std::sort(calls.begin(), calls.end());
  return calls;
}

} // namespace

TEST(SolverLists, MeshesOfManyWorkersShareCalls)
{
  const std::filesystem::path folder = TestFolder();
  std::vector<std::string> names;
  for (int i = 0; i < 10; ++i)
  {
    names.push_back("mesh " + std::to_string(i));
  }
  for (const auto& [name, status] : SolveAll(ListSolver(4), folder, names))
  {
    EXPECT_EQ(status, "ok") << name;
    EXPECT_THAT(ReadBytes(folder / name / "stdout.log"), testing::HasSubstr(name));
  }
  EXPECT_THAT(Calls(folder), testing::ElementsAre(2, 4, 4));
}

TEST(SolverLists, OneMeshDoesNotTakeTheOthersWithIt)
{
  const std::filesystem::path folder = TestFolder();
  const std::vector<std::string> names{ "a", "crash", "b", "omit", "c" };
  const auto statuses = SolveAll(ListSolver(5), folder, names);
  EXPECT_EQ(statuses.at("a"), "ok");
  EXPECT_EQ(statuses.at("b"), "ok");
  EXPECT_EQ(statuses.at("c"), "ok");
  EXPECT_EQ(statuses.at("crash"), "crashed");
  EXPECT_EQ(statuses.at("omit"), "bad-output");
  EXPECT_THAT(Calls(folder), testing::ElementsAre(1, 1, 1, 1, 1, 5));
}

TEST(SolverLists, TheTimeLimitIsThatOfOneMesh)
{
  const std::filesystem::path folder = TestFolder();
  SolverDescription description = ListSolver(3);
  description.TimeLimit = 1.0;
  const auto statuses = SolveAll(description, folder, { "a", "hang", "b" });
  EXPECT_EQ(statuses.at("a"), "ok");
  EXPECT_EQ(statuses.at("hang"), "time-out");
  EXPECT_EQ(statuses.at("b"), "ok");
}

TEST(SolverLists, AFilterAloneMakesAListOfOne)
{
  auto solver = MakeSolver("ok");
  solver->SetDescription(ListSolver(4));
  solver->Update();
  EXPECT_EQ(GetFieldText(solver->GetOutput(), "run_Status"), "ok");
}

TEST(SolverQueue, NoMoreThanSoManyWorkAtATime)
{
  constexpr int workers = 12;
  SolverQueue queue(workers, 3);
  std::atomic<int> atWork{ 0 };
  std::atomic<int> most{ 0 };
  std::atomic<int> answered{ 0 };
  const auto work = [&]
  {
    const int now = ++atWork;
    int before = most;
    while (now > before && !most.compare_exchange_weak(before, now))
    {
    }
    std::this_thread::sleep_for(std::chrono::microseconds(200));
    --atWork;
  };
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < workers; ++i)
    {
      threads.emplace_back(
        [&, i]
        {
          const SolverQueue::Worker worker(queue);
          for (int j = 0; j < 20; ++j)
          {
            work();
            const std::string key = (i + j) % 3 == 0 ? "a" : "b";
            queue.Ask(key, 5, &queue,
              [&](const SolverQueue::Requests& requests)
              {
                EXPECT_LE(requests.size(), 5u);
                work();
                answered += static_cast<int>(requests.size());
              });
          }
        });
    }
  }
  EXPECT_EQ(answered, workers * 20);
  EXPECT_LE(most, 3);
}

TEST(SolverQueue, NobodyWaitsForWhoHasLeft)
{
  SolverQueue queue(2, 1);
  std::jthread other(
    [&]
    {
      const SolverQueue::Worker worker(queue);
      queue.Ask("a", 2, nullptr,
        [](const SolverQueue::Requests& requests) { EXPECT_EQ(requests.size(), 1u); });
    });
  queue.Leave();
}
