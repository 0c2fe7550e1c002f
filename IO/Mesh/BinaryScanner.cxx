// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BinaryScanner.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace pemesh
{

std::size_t SizeOf(NumberType type)
{
  constexpr std::array<std::size_t, 9> sizes{ 1, 1, 2, 2, 4, 4, 8, 4, 8 };
  return sizes[static_cast<std::size_t>(type)];
}

NumberType ReadNumberType(
  LineScanner& file, std::span<const NumberTypeName> names, const char* unknown)
{
  const std::string_view word = file.Word();
  const auto found = std::find_if(
    names.begin(), names.end(), [&](const NumberTypeName& type) { return word == type.Name; });
  if (found == names.end())
  {
    file.Fail(unknown);
  }
  return found->Type;
}

std::string_view BinaryScanner::Take(std::size_t bytes)
{
  if (bytes > this->Data.size())
  {
    this->Fail("ends before all that its header announces");
  }
  const std::string_view taken = this->Data.substr(0, bytes);
  this->Data.remove_prefix(bytes);
  return taken;
}

template <typename Value>
Value BinaryScanner::Read()
{
  std::array<char, sizeof(Value)> bytes{};
  this->Take(sizeof(Value)).copy(bytes.data(), sizeof(Value));
  if (this->IsBigEndian != (std::endian::native == std::endian::big))
  {
    std::reverse(bytes.begin(), bytes.end());
  }
  return std::bit_cast<Value>(bytes);
}

double BinaryScanner::Number(NumberType type)
{
  switch (type)
  {
    case NumberType::Float64:
      return this->Read<double>();
    case NumberType::Float32:
      return this->Read<float>();
    default:
      return static_cast<double>(this->Integer(type));
  }
}

std::int64_t BinaryScanner::Integer(NumberType type)
{
  switch (type)
  {
    case NumberType::Int8:
      return this->Read<std::int8_t>();
    case NumberType::UInt8:
      return this->Read<std::uint8_t>();
    case NumberType::Int16:
      return this->Read<std::int16_t>();
    case NumberType::UInt16:
      return this->Read<std::uint16_t>();
    case NumberType::Int32:
      return this->Read<std::int32_t>();
    case NumberType::UInt32:
      return this->Read<std::uint32_t>();
    case NumberType::Int64:
      return this->Read<std::int64_t>();
    default:
      break;
  }
  const double value = this->Number(type);
  constexpr double largest = 9007199254740992.0; // 2^53, up to which doubles are whole numbers
  if (!(std::abs(value) <= largest) || value != std::trunc(value))
  {
    this->Fail("has a number that is no whole one where a vertex or a count is expected");
  }
  return static_cast<std::int64_t>(value);
}

} // namespace pemesh
