// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MatFileCheck.h"

#include "BinaryScanner.h"
#include "MeshText.h"
#include "TextFile.h"

#include <algorithm>
#include <string>
#include <string_view>

#include <zlib.h>

namespace pemesh
{

namespace
{

// "MAT-File Format", The MathWorks, chapter 1: the types of data elements and classes of arrays.
constexpr std::uint32_t TypeMatrix = 14;
constexpr std::uint32_t TypeCompressed = 15;
constexpr std::int64_t ClassCell = 1;
constexpr std::int64_t ClassFirstNumeric = 6; // double, single, then the integers
constexpr std::int64_t ClassLastNumeric = 15;
constexpr std::int64_t ClassChar = 4;
constexpr int DeepestCell = 20;

/** A tag and the bytes that it announces. */
struct DataElement
{
  std::uint32_t Type = 0;
  std::string_view Bytes;
};

class MatFileChecker
{
public:
  MatFileChecker(const std::filesystem::path& path, bool isBigEndian)
    : Path(path)
    , IsBigEndian(isBigEndian)
  {
  }

  void CheckAll(std::string_view data) const
  {
    while (!data.empty())
    {
      const DataElement element = this->Take(data);
      if (element.Type == TypeCompressed)
      {
        const std::string inflated = this->Inflate(element.Bytes);
        std::string_view inside = inflated;
        this->CheckArray(this->Take(inside), 0);
      }
      else
      {
        this->CheckArray(element, 0);
      }
    }
  }

private:
  [[noreturn]] void Fail() const
  {
    FailMeshFile(this->Path, "is a damaged MAT file: its parts do not have the sizes announced");
  }

  std::uint32_t Number(std::string_view data, std::size_t at) const
  {
    if (data.size() < at + 4)
    {
      this->Fail();
    }
    BinaryScanner scanner(data.substr(at), this->Path, this->IsBigEndian);
    return static_cast<std::uint32_t>(scanner.Integer(NumberType::UInt32));
  }

  /** Takes the next element off the data. */
  DataElement Take(std::string_view& data) const
  {
    const std::uint32_t first = this->Number(data, 0);
    const bool isSmall = first >> 16 != 0; // size and type in one number, then up to four bytes
    const std::size_t start = isSmall ? 4 : 8;
    const std::size_t size = isSmall ? first >> 16 : this->Number(data, 4);
    if ((isSmall && size > 4) || data.size() < start + size)
    {
      this->Fail();
    }
    const DataElement element{ isSmall ? first & 0xffffU : first, data.substr(start, size) };
    const std::size_t padded = isSmall ? 8 : 8 + (size + 7) / 8 * 8;
    const std::size_t whole = element.Type == TypeCompressed ? start + size : padded;
    data.remove_prefix(std::min(whole, data.size()));
    return element;
  }

  void CheckArray(const DataElement& array, int depth) const
  {
    if (array.Type != TypeMatrix || depth > DeepestCell)
    {
      this->Fail();
    }
    if (array.Bytes.empty())
    {
      return; // an empty array may be nothing but its tag
    }
    std::string_view rest = array.Bytes;
    const DataElement flags = this->Take(rest);
    const DataElement dimensions = this->Take(rest);
    this->Take(rest); // the name
    const std::int64_t kind = this->Number(flags.Bytes, 0) & 0xffU;
    std::size_t values = 1;
    for (std::size_t at = 0; at + 4 <= dimensions.Bytes.size(); at += 4)
    {
      const std::size_t length = this->Number(dimensions.Bytes, at);
      if (length > 0 && values > array.Bytes.size() / length)
      {
        this->Fail(); // a value takes a byte at least
      }
      values *= length;
    }
    this->CheckValues(kind, values, rest, depth);
  }

  void CheckValues(std::int64_t kind, std::size_t values, std::string_view rest, int depth) const
  {
    if (kind == ClassCell)
    {
      for (std::size_t i = 0; i < values; ++i)
      {
        this->CheckArray(this->Take(rest), depth + 1);
      }
    }
    else if (kind == ClassChar || (kind >= ClassFirstNumeric && kind <= ClassLastNumeric))
    {
      if (values > 0 && this->Take(rest).Bytes.size() < values && kind != ClassChar)
      {
        this->Fail();
      }
    }
    else
    {
      FailMeshFile(this->Path,
        "holds more than matrices and cell arrays (structures, sparse matrices or functions); "
        "save the mesh's variables alone");
    }
  }

  /** The whole of a compressed element: its size, or that of the file, bounds it. */
  std::string Inflate(std::string_view bytes) const
  {
    constexpr std::size_t mostCompression = 1032; // of zlib
    std::string head(8, '\0');
    if (InflateInto(bytes, head) != head.size())
    {
      this->Fail();
    }
    const std::size_t size = this->Number(head, 4);
    if (size / mostCompression > bytes.size())
    {
      this->Fail();
    }
    std::string all(size + 8, '\0');
    if (InflateInto(bytes, all) != all.size())
    {
      this->Fail();
    }
    return all;
  }

  /** Fills `to` as far as the bytes go; returns how far. */
  static std::size_t InflateInto(std::string_view bytes, std::string& to)
  {
    z_stream stream = {};
    if (inflateInit(&stream) != Z_OK)
    {
      return 0;
    }
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(to.data());
    stream.avail_out = static_cast<uInt>(to.size());
    inflate(&stream, Z_SYNC_FLUSH);
    const std::size_t filled = to.size() - stream.avail_out;
    inflateEnd(&stream);
    return filled;
  }

  const std::filesystem::path& Path;
  bool IsBigEndian;
};

} // namespace

void CheckMatFile(const std::filesystem::path& path)
{
  const std::string text = ReadTextFile(path);
  constexpr std::size_t headSize = 128;
  if (text.rfind("# Created by Octave", 0) == 0)
  {
    FailMeshFile(path, "is in Octave's own text format; save it with the option -v7");
  }
  if (text.size() >= headSize && text.rfind("MATLAB 7.3", 0) == 0)
  {
    FailMeshFile(path, "is in MATLAB's format 7.3 (HDF5); save it with the option -v7");
  }
  const std::string_view order =
    text.size() >= headSize ? std::string_view(text).substr(126, 2) : "";
  if (order != "IM" && order != "MI")
  {
    FailMeshFile(path, "is no MAT file of MATLAB's version 5 to 7; save it with the option -v7");
  }
  MatFileChecker(path, order == "MI").CheckAll(std::string_view(text).substr(headSize));
}

} // namespace pemesh
