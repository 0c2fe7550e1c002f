// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RankBoard.h"

#include "CaseWorkers.h"
#include "MeshText.h"
#include "NumberText.h"
#include "RankChannel.h"
#include "RankPlace.h"
#include "RowText.h"
#include "StudyFigures.h"
#include "StudyTask.h"

#include <filesystem>
#include <stdexcept>
#include <thread>
#include <utility>

#include <vtkPolyData.h>
#include <vtkTable.h>

namespace pemesh
{

namespace
{

/** Waits, asleep, for the next message. */
std::vector<std::string> NextMessage(RankChannel& channel)
{
  for (const RankPace pace;;)
  {
    if (const std::optional<RankMessage> message = channel.Receive())
    {
      return SplitFields(message->Text);
    }
    std::this_thread::sleep_for(pace.Pause());
  }
}

/** A folder that was made just now may take a while to be seen on other machines. */
void WaitForFolder(const std::filesystem::path& folder)
{
  constexpr std::chrono::milliseconds pause{ 100 };
  constexpr int times = 100;
  for (int i = 0; i < times; ++i)
  {
    if (std::filesystem::exists(folder / "study.json"))
    {
      return;
    }
    std::this_thread::sleep_for(pause);
  }
  throw std::runtime_error("The output folder \"" + folder.string() +
    "\" is not the same for all processes (" + MachineOfProcess() +
    " does not see it); name one on a disk that all machines share with -o.");
}

void WorkOn(RankChannel& channel, const StudyTask& task)
{
  WaitForFolder(task.Options.Folder);
  const LoadedStudy loaded = LoadStudy(task);
  std::atomic<bool> stop{ false };
  const StudyFigures figures(loaded.TheStudy, loaded.Solvers, loaded.Cases);
  RankBoard board(
    channel,
    [&](int index) { return figures.Shows(loaded.Cases.at(static_cast<std::size_t>(index))); },
    stop);
  CaseWorkers workers(loaded.TheStudy, loaded.Solvers, loaded.Cases, task.Options, board, stop);
  board.Serve(workers.Start(loaded.Cases.size()));
}

} // namespace

void WorkForFirstRank(RankChannel& channel)
{
  channel.Send(0, JoinFields({ "hello", PlaceOfProcess() }));
  std::vector<std::string> fields = NextMessage(channel);
  if (fields.front() != "study")
  {
    return;
  }
  fields.erase(fields.begin());
  try
  {
    WorkOn(channel, TaskOfFields(fields));
  }
  catch (const std::exception& error)
  {
    channel.Send(0, JoinFields({ "refuse", error.what() }));
  }
  channel.Send(0, "leave");
}

RankBoard::RankBoard(RankChannel& channel, IsWanted isWanted, std::atomic<bool>& stop)
  : Channel(channel)
  , Wanted(std::move(isWanted))
  , Stop(stop)
{
}

void RankBoard::Post(const std::string& text)
{
  const std::scoped_lock lock(this->Mutex);
  this->Posted.push_back(text);
  this->Changed.notify_one();
}

std::string RankBoard::Ask(std::vector<std::string> fields)
{
  std::future<std::string> answer;
  {
    const std::scoped_lock lock(this->Mutex);
    const std::string number = std::to_string(this->NextQuestion++);
    answer = this->Questions[number].get_future();
    fields.insert(fields.begin() + 1, number);
    this->Posted.push_back(JoinFields(fields));
    this->Changed.notify_one();
  }
  return answer.get();
}

std::optional<int> RankBoard::Take()
{
  if (this->Stop)
  {
    return {};
  }
  const std::optional<long long> index = ParseInteger(this->Ask({ "take" }));
  return index ? std::optional<int>(static_cast<int>(*index)) : std::nullopt;
}

bool RankBoard::Reuse(int index, const std::string& key)
{
  return this->Ask({ "reuse", std::to_string(index), key }) == "1";
}

void RankBoard::Bring(const CaseAnswer& answer)
{
  const std::vector<std::string> columns = ColumnsOfRow(answer.Row);
  const std::vector<std::string> values = ValuesOfRow(answer.Row);
  std::vector<std::string> fields{ "bring", std::to_string(answer.Index), answer.Key,
    answer.NotWritten, this->Wanted(answer.Index) ? TextOfMesh(answer.Mesh) : std::string(),
    std::to_string(columns.size()) };
  fields.insert(fields.end(), columns.begin(), columns.end());
  fields.insert(fields.end(), values.begin(), values.end());
  this->Post(JoinFields(fields));
}

void RankBoard::Refuse(const std::string& sentence)
{
  this->Stop = true;
  this->Post(JoinFields({ "refuse", sentence }));
}

void RankBoard::Leave()
{
  const std::scoped_lock lock(this->Mutex);
  ++this->WorkersGone;
  this->Changed.notify_one();
}

void RankBoard::SendPosted()
{
  std::deque<std::string> posted;
  {
    const std::scoped_lock lock(this->Mutex);
    posted.swap(this->Posted);
  }
  for (const std::string& text : posted)
  {
    this->Channel.Send(0, text);
  }
}

void RankBoard::TakeMessage(const std::vector<std::string>& fields)
{
  if (fields.front() != "reply")
  {
    this->Stop = true; // "stop" or "end"
    return;
  }
  const std::scoped_lock lock(this->Mutex);
  const auto question = this->Questions.find(fields.at(1));
  if (question != this->Questions.end())
  {
    question->second.set_value(fields.at(2));
    this->Questions.erase(question);
  }
}

void RankBoard::Serve(std::size_t workers)
{
  RankPace pace;
  for (bool isOver = false; !isOver;)
  {
    {
      std::unique_lock lock(this->Mutex);
      this->Changed.wait_for(
        lock, pace.Pause(), [&] { return !this->Posted.empty() || this->WorkersGone == workers; });
      isOver = this->WorkersGone == workers; // what they have posted goes out below
    }
    this->SendPosted();
    while (const std::optional<RankMessage> message = this->Channel.Receive())
    {
      pace.SomethingCame();
      this->TakeMessage(SplitFields(message->Text));
    }
  }
}

} // namespace pemesh
