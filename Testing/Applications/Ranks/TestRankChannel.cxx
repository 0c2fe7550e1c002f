// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What processes of a run say to each other, with threads in place of processes: no MPI is needed.
 */
#include "RankBoard.h"
#include "RankChannel.h"
#include "TestFolder.h"
#include "vtkPEMRunner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkTable.h>

namespace fs = std::filesystem;
using pemesh::RankMessage;
using pemesh::TestFolder;
using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

/** The letter boxes of all. */
struct Post
{
  explicit Post(int size)
    : Boxes(static_cast<std::size_t>(size))
  {
  }

  std::mutex Mutex;
  std::vector<std::deque<RankMessage>> Boxes;
  std::map<int, int> Brought; // how many cases each has brought
};

class ThreadChannel : public pemesh::RankChannel
{
public:
  ThreadChannel(Post& post, int rank)
    : ThePost(post)
    , Rank(rank)
  {
  }

  int GetRank() const override { return this->Rank; }
  int GetSize() const override { return static_cast<int>(this->ThePost.Boxes.size()); }

  void Send(int rank, const std::string& text) override
  {
    const std::scoped_lock lock(this->ThePost.Mutex);
    this->ThePost.Boxes[static_cast<std::size_t>(rank)].push_back({ this->Rank, text });
    this->ThePost.Brought[this->Rank] += text.starts_with("bring\t") ? 1 : 0;
  }

  std::optional<RankMessage> Receive() override
  {
    const std::scoped_lock lock(this->ThePost.Mutex);
    auto& box = this->ThePost.Boxes[static_cast<std::size_t>(this->Rank)];
    if (box.empty())
    {
      return {};
    }
    const RankMessage message = box.front();
    box.pop_front();
    return message;
  }

private:
  Post& ThePost;
  int Rank;
};

std::string Study(int count)
{
  return R"({"pemesh": 1, "name": "s", "polygons": [{"family": "maze"}],
             "sweep": [{"parameter": "t", "from": 0, "to": 0.8, "count": )" +
    std::to_string(count) + R"(}, {"parameter": "mesh.min-angle", "values": [20, 25]}],
             "output": {"formats": ["off"]},
             "plots": [{"kind": "mesh", "case": -1, "color-by": "MinAngle", "file": "last.svg"}]})";
}

std::string FileText(const fs::path& path)
{
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void ExpectSameFiles(const fs::path& a, const fs::path& b)
{
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(a))
  {
    const fs::path name = fs::relative(entry.path(), a);
    if (entry.is_regular_file() && name != "journal.tsv" && name != "timings.csv")
    {
      EXPECT_EQ(FileText(entry.path()), FileText(b / name)) << name;
      ++count;
    }
  }
  EXPECT_GT(count, 10U);
}

} // namespace

class RankChannelTest : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Folder = TestFolder();
    this->Runner->SetStudyText(Study(10), this->Folder.string());
    this->Runner->SetNumberOfWorkers(1);
  }

  bool RunAlone(const std::string& output)
  {
    this->Runner->SetOutputDirectory(this->Folder / output);
    this->Runner->SetRankChannel(nullptr);
    return this->Runner->Run();
  }

  bool RunOver(int ranks, const std::string& output)
  {
    Post post(ranks);
    std::vector<std::jthread> others;
    for (int rank = 1; rank < ranks; ++rank)
    {
      others.emplace_back(
        [&post, rank]
        {
          ThreadChannel channel(post, rank);
          pemesh::WorkForFirstRank(channel);
        });
    }
    ThreadChannel first(post, 0);
    this->Runner->SetOutputDirectory(this->Folder / output);
    this->Runner->SetRankChannel(&first);
    const bool done = this->Runner->Run();
    others.clear(); // hangs where they are not told the end
    this->Brought = post.Brought;
    return done;
  }

  fs::path Folder;
  vtkNew<vtkPEMRunner> Runner;
  std::map<int, int> Brought;
};

TEST_F(RankChannelTest, ResultsAreThoseOfOneProcess)
{
  ASSERT_TRUE(this->RunAlone("alone"));
  ASSERT_TRUE(this->RunOver(3, "over"));
  EXPECT_GT(this->Brought[1], 0);
  EXPECT_GT(this->Brought[2], 0);
  EXPECT_LT(this->Brought[1] + this->Brought[2], 20) << "the first process has not worked";
  ExpectSameFiles(this->Folder / "alone", this->Folder / "over");
}

TEST_F(RankChannelTest, MoreProcessesThanCases)
{
  this->Runner->SetSelectedCases({ 19 });
  ASSERT_TRUE(this->RunOver(4, "over"));
  EXPECT_EQ(this->Runner->GetResults()->GetNumberOfRows(), 1);
}

TEST_F(RankChannelTest, GoesOnFromWhatIsThere)
{
  this->Runner->SetSelectedCases({ 0, 5, 19 });
  ASSERT_TRUE(this->RunAlone("over"));
  this->Runner->SetSelectedCases({});
  this->Runner->SetResume(true);
  ASSERT_TRUE(this->RunOver(3, "over"));
  // The last one is in a figure, and without a .vtp its mesh is made again.
  EXPECT_EQ(this->Runner->GetNumberOfReusedCases(), 2);
  this->Runner->SetResume(false);
  ASSERT_TRUE(this->RunAlone("alone"));
  ExpectSameFiles(this->Folder / "alone", this->Folder / "over");
}

TEST_F(RankChannelTest, AStudyThatIsRefusedEndsAll)
{
  this->Runner->SetStudyText(R"({"pemesh": 1, "rubbish": 1})", this->Folder.string());
  EXPECT_FALSE(this->RunOver(3, "over"));
  EXPECT_TRUE(this->Runner->GetRefused());
}

TEST_F(RankChannelTest, WhatIsWrongForEveryCaseEndsAll)
{
  this->Runner->AddSetting("mesh.agglomerate={\"rule\": \"no-such-rule\"}");
  EXPECT_FALSE(this->RunOver(3, "over"));
  EXPECT_TRUE(this->Runner->GetRefused());
  EXPECT_THAT(this->Runner->GetMessages(), ElementsAre(HasSubstr("no-such-rule")));
}

TEST_F(RankChannelTest, AStopKeepsWhatIsDone)
{
  this->Runner->SetStudyText(Study(100), this->Folder.string());
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* runner, unsigned long, void*, void*)
    { static_cast<vtkPEMRunner*>(runner)->RequestStop(); });
  const unsigned long observer =
    this->Runner->AddObserver(vtkCommand::ProgressEvent, stop); // after the first case
  EXPECT_FALSE(this->RunOver(3, "over"));
  EXPECT_THAT(this->Runner->GetMessages(), testing::Contains(HasSubstr("--resume goes on")));
  this->Runner->RemoveObserver(observer);
  this->Runner->SetResume(true);
  EXPECT_TRUE(this->RunOver(2, "over"));
  EXPECT_GT(this->Runner->GetNumberOfReusedCases(), 0);
}
