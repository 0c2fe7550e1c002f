// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ContentDigest.h"

#include <algorithm>
#include <array>
#include <fstream>

#include <vtksys/MD5.h>

namespace pemesh
{

class ContentDigest::Internals
{
public:
  Internals()
    : Sum(vtksysMD5_New())
  {
    vtksysMD5_Initialize(this->Sum);
  }
  Internals(const Internals&) = delete;
  Internals& operator=(const Internals&) = delete;
  ~Internals() { vtksysMD5_Delete(this->Sum); }

  void Append(std::string_view bytes)
  {
    if (!bytes.empty())
    {
      vtksysMD5_Append(this->Sum, reinterpret_cast<const unsigned char*>(bytes.data()),
        static_cast<int>(bytes.size()));
    }
  }

  vtksysMD5* Sum;
};

ContentDigest::ContentDigest()
  : Implementation(std::make_unique<Internals>())
{
}

ContentDigest::~ContentDigest() = default;

void ContentDigest::Add(std::string_view text)
{
  this->Implementation->Append("text " + std::to_string(text.size()) + ':');
  constexpr std::size_t piece = 1 << 20; // its length is an int
  for (; !text.empty(); text.remove_prefix(std::min(piece, text.size())))
  {
    this->Implementation->Append(text.substr(0, piece));
  }
}

void ContentDigest::AddFile(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::array<char, 65536> bytes;
  unsigned long long size = 0;
  do
  {
    stream.read(bytes.data(), bytes.size());
    size += static_cast<unsigned long long>(stream.gcount());
    this->Implementation->Append({ bytes.data(), static_cast<std::size_t>(stream.gcount()) });
  } while (stream);
  const char* kind = stream.eof() ? "file " : "unreadable ";
  this->Implementation->Append(kind + std::to_string(size) + ':');
}

std::string ContentDigest::Finish()
{
  constexpr std::size_t digits = 32;
  std::string text(digits, '0');
  vtksysMD5_FinalizeHex(this->Implementation->Sum, text.data());
  return text;
}

} // namespace pemesh
