// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RankDesk.h"

#include "CaseBoard.h"
#include "MeshText.h"
#include "NumberText.h"
#include "RankChannel.h"
#include "RankPlace.h"
#include "RowText.h"
#include "StudyTask.h"

#include <stdexcept>
#include <thread>

#include <vtkPolyData.h>
#include <vtkTable.h>

namespace pemesh
{

namespace
{

CaseAnswer AnswerOf(const std::vector<std::string>& fields)
{
  constexpr std::size_t head = 6; // what comes before the columns
  CaseAnswer answer;
  answer.Index = static_cast<int>(ParseInteger(fields.at(1)).value_or(-1));
  answer.Key = fields.at(2);
  answer.NotWritten = fields.at(3);
  answer.Mesh = fields.at(4).empty() ? nullptr : MeshOfText(fields.at(4));
  const auto columns = static_cast<std::size_t>(ParseInteger(fields.at(5)).value_or(0));
  const auto middle = fields.begin() + static_cast<std::ptrdiff_t>(head + columns);
  if (fields.size() != head + 2 * columns)
  {
    throw std::runtime_error("A process has sent half a row.");
  }
  answer.Row = MakeRow({ fields.begin() + head, middle }, { middle, fields.end() });
  return answer;
}

/** Takes cases where nobody is left who wants answers. */
class ClosedBoard : public CaseBoard
{
public:
  std::optional<int> Take() override { return {}; }
  bool Reuse(int, const std::string&) override { return true; }
  void Bring(const CaseAnswer&) override {}
  void Refuse(const std::string&) override {}
  void Leave() override {}
};

} // namespace

RankDesk::RankDesk(RankChannel& channel)
  : Channel(channel)
{
}

RankDesk::~RankDesk()
{
  try
  {
    this->Tell("end");
    ClosedBoard closed;
    for (RankPace pace; !this->HaveAllLeft(); std::this_thread::sleep_for(pace.Pause()))
    {
      if (this->Serve(closed))
      {
        pace.SomethingCame();
      }
    }
  }
  catch (const std::exception&)
  {
    return; // nobody is left to be told
  }
}

void RankDesk::Tell(const std::string& text)
{
  for (int rank = 1; rank < this->Channel.GetSize(); ++rank)
  {
    this->Channel.Send(rank, text);
  }
}

void RankDesk::Begin(StudyTask& task)
{
  const auto others = static_cast<std::size_t>(this->Channel.GetSize() - 1);
  ClosedBoard closed;
  for (RankPace pace; this->Places.size() < others; std::this_thread::sleep_for(pace.Pause()))
  {
    this->Serve(closed);
  }
  const std::string place = PlaceOfProcess();
  std::map<int, std::string> places = this->Places;
  places[0] = place;
  for (const auto& [rank, own] : this->Places)
  {
    StudyTask share = task;
    ShareTask(share, own, places);
    std::vector<std::string> fields = FieldsOfTask(share);
    fields.insert(fields.begin(), "study");
    this->Channel.Send(rank, JoinFields(fields));
    ++this->Working;
  }
  ShareTask(task, place, places);
}

void RankDesk::Answer(int rank, const std::vector<std::string>& fields, CaseBoard& board)
{
  const auto reply = [&](const std::string& value) {
    this->Channel.Send(rank, JoinFields({ "reply", fields.at(1), value }));
  };
  const std::string& what = fields.front();
  if (what == "take")
  {
    const std::optional<int> index = board.Take();
    reply(index ? std::to_string(*index) : std::string());
  }
  else if (what == "reuse")
  {
    const auto index = static_cast<int>(ParseInteger(fields.at(2)).value_or(-1));
    reply(board.Reuse(index, fields.at(3)) ? "1" : "0");
  }
  else if (what == "bring")
  {
    board.Bring(AnswerOf(fields));
  }
  else if (what == "refuse")
  {
    board.Refuse(fields.at(1));
  }
  else if (what == "hello")
  {
    this->Places[rank] = fields.at(1);
  }
  else if (what == "leave")
  {
    --this->Working;
  }
}

bool RankDesk::Serve(CaseBoard& board)
{
  bool hasServed = false;
  while (const std::optional<RankMessage> message = this->Channel.Receive())
  {
    this->Answer(message->Rank, SplitFields(message->Text), board);
    hasServed = true;
  }
  return hasServed;
}

bool RankDesk::HaveAllLeft() const
{
  return this->Working == 0;
}

void RankDesk::Stop()
{
  if (!this->HasStopped)
  {
    this->HasStopped = true;
    this->Tell("stop");
  }
}

} // namespace pemesh
