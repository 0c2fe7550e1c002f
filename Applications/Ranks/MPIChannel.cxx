// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MPIChannel.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <thread>
#include <vector>

#include <unistd.h>

#include <vtkMPIController.h>

namespace pemesh
{

namespace
{

constexpr int PartTag = 1;
constexpr int LastPartTag = 2;
constexpr int EndTag = 3;

/** MPI counts bytes in an int. */
constexpr std::size_t LongestPart = std::size_t{ 1 } << 30;

/** A solver that uses MPI itself would take what the launcher has told us for its own. */
void HideLauncher()
{
  std::vector<std::string> names;
  for (char** entry = environ; entry && *entry; ++entry)
  {
    const std::string_view text(*entry);
    const auto starts = [text](std::string_view prefix) { return text.starts_with(prefix); };
    if ((starts("OMPI_") && !starts("OMPI_ALLOW")) || starts("PMIX_") || starts("PMI_"))
    {
      names.emplace_back(text.substr(0, text.find('=')));
    }
  }
  for (const std::string& name : names)
  {
    unsetenv(name.c_str());
  }
}

} // namespace

MPIChannel::MPIChannel()
{
  this->Controller->Initialize(nullptr, nullptr, 0);
  HideLauncher();
}

MPIChannel::~MPIChannel()
{
  char end = 0;
  if (this->GetRank() == 0)
  {
    for (int rank = 1; rank < this->GetSize(); ++rank)
    {
      this->Controller->Send(&end, 1, rank, EndTag);
    }
  }
  else
  {
    int has = 0;
    int source = 0;
    for (const RankPace pace; this->Controller->Iprobe(0, EndTag, &has, &source) && !has;)
    {
      std::this_thread::sleep_for(pace.Pause());
    }
    this->Controller->Receive(&end, 1, 0, EndTag);
  }
  this->Controller->Finalize();
}

int MPIChannel::GetRank() const
{
  return this->Controller->GetLocalProcessId();
}

int MPIChannel::GetSize() const
{
  return this->Controller->GetNumberOfProcesses();
}

void MPIChannel::Send(int rank, const std::string& text)
{
  for (std::size_t begin = 0; begin < text.size(); begin += LongestPart)
  {
    const std::size_t length = std::min(LongestPart, text.size() - begin);
    const bool isLast = begin + length == text.size();
    this->Controller->Send(
      text.data() + begin, static_cast<vtkIdType>(length), rank, isLast ? LastPartTag : PartTag);
  }
}

std::optional<RankMessage> MPIChannel::Receive()
{
  for (const int tag : { PartTag, LastPartTag })
  {
    int has = 0;
    int source = 0;
    int length = 0;
    constexpr int any = vtkMultiProcessController::ANY_SOURCE;
    const char* type = nullptr;
    while (this->Controller->Iprobe(any, tag, &has, &source, type, &length) && has)
    {
      std::string& text = this->Parts[source];
      const std::size_t before = text.size();
      text.resize(before + static_cast<std::size_t>(length));
      this->Controller->Receive(text.data() + before, length, source, tag);
      if (tag == LastPartTag)
      {
        RankMessage message{ source, std::move(text) };
        this->Parts.erase(source);
        return message;
      }
    }
  }
  return {};
}

} // namespace pemesh

pemesh::RankChannel* PEMeshOpenRankChannel()
{
  return new pemesh::MPIChannel;
}
