// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RowFamilies.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace pemesh
{

RowFamilies GroupRows(std::span<const std::string> labels)
{
  RowFamilies families;
  std::map<std::string, std::size_t> known;
  for (std::size_t row = 0; row < labels.size(); ++row)
  {
    const auto [place, isNew] = known.emplace(labels[row], families.size());
    if (isNew)
    {
      families.emplace_back();
    }
    families[place->second].push_back(row);
  }
  return families;
}

RowFamilies SingleRows(std::size_t rows)
{
  RowFamilies families(rows);
  for (std::size_t row = 0; row < rows; ++row)
  {
    families[row] = { row };
  }
  return families;
}

FamilyShuffle::FamilyShuffle(const RowFamilies& families, int most, std::uint64_t seed)
  : Families(families)
  , Bits(seed)
{
  std::map<std::size_t, std::vector<std::size_t>> byLength;
  for (std::size_t i = 0; i < families.size(); ++i)
  {
    byLength[families[i].size()].push_back(i);
  }
  double arrangements = 1.0;
  for (auto& [length, members] : byLength)
  {
    for (std::size_t k = 2; k <= members.size(); ++k)
    {
      arrangements *= static_cast<double>(k);
    }
    std::vector<std::size_t>& places = this->Places.emplace_back(members.size());
    std::iota(places.begin(), places.end(), 0);
    this->Classes.push_back(std::move(members));
  }
  this->Exact = arrangements <= 1.0 + most;
  this->Count = this->Exact ? static_cast<int>(arrangements) - 1 : most;
}

bool FamilyShuffle::Advance()
{
  for (std::vector<std::size_t>& places : this->Places)
  {
    if (std::next_permutation(places.begin(), places.end()))
    {
      return true;
    }
  }
  return false;
}

void FamilyShuffle::Draw()
{
  for (std::vector<std::size_t>& places : this->Places)
  {
    for (std::size_t i = places.size(); i > 1; --i)
    {
      // Not std::shuffle, whose result depends on the library. The bias is below n / 2^64.
      std::swap(places[i - 1], places[this->Bits() % i]);
    }
  }
}

bool FamilyShuffle::Next(std::vector<std::size_t>& rows)
{
  if (this->Given >= this->Count)
  {
    return false;
  }
  ++this->Given;
  if (this->Exact)
  {
    this->Advance();
  }
  else
  {
    this->Draw();
  }
  std::iota(rows.begin(), rows.end(), 0);
  for (std::size_t c = 0; c < this->Classes.size(); ++c)
  {
    for (std::size_t place = 0; place < this->Places[c].size(); ++place)
    {
      const auto& to = this->Families[this->Classes[c][place]];
      const auto& from = this->Families[this->Classes[c][this->Places[c][place]]];
      for (std::size_t i = 0; i < to.size(); ++i)
      {
        rows[to[i]] = from[i];
      }
    }
  }
  return true;
}

std::vector<int> DrawFamilies(const RowFamilies& families, std::size_t rows, std::mt19937_64& bits)
{
  std::vector<int> times(rows, 0);
  for (std::size_t draw = 0; draw < families.size(); ++draw)
  {
    for (const std::size_t row : families[bits() % families.size()])
    {
      ++times[row];
    }
  }
  return times;
}

} // namespace pemesh
