// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Reads numbers of any type and byte order from the bytes of a file; never beyond its end.
 */
#ifndef pemesh_BinaryScanner_h
#define pemesh_BinaryScanner_h

#include "MeshText.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace pemesh
{

enum class NumberType
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  Float32,
  Float64
};

/** In bytes. */
std::size_t SizeOf(NumberType type);

/** What a format calls a type. */
struct NumberTypeName
{
  const char* Name;
  NumberType Type;
};

/** The type that the next word of the line names; an error that says `unknown` if it names none. */
NumberType ReadNumberType(
  LineScanner& file, std::span<const NumberTypeName> names, const char* unknown);

class BinaryScanner
{
public:
  BinaryScanner(std::string_view data, std::filesystem::path path, bool isBigEndian)
    : Data(data)
    , Path(std::move(path))
    , IsBigEndian(isBigEndian)
  {
  }

  std::size_t BytesLeft() const { return this->Data.size(); }

  void Skip(std::size_t bytes) { this->Take(bytes); }

  double Number(NumberType type);

  /** A whole number, whatever its type; else an error. */
  std::int64_t Integer(NumberType type);

  /** An error about the file. */
  [[noreturn]] void Fail(const std::string& what) const { FailMeshFile(this->Path, what); }

private:
  std::string_view Take(std::size_t bytes);

  template <typename Value>
  Value Read();

  std::string_view Data;
  std::filesystem::path Path;
  bool IsBigEndian;
};

} // namespace pemesh

#endif
