// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Thousands of good files with a few bytes changed: each is read as a mesh that can be used, or
 * refused with a std::runtime_error. Anything else ends the test program.
 */
#include "MeshFormats.h"

#include "ElementAccess.h"
#include "TestMeshes.h"

#include <algorithm>
#include <cstdlib>
#include <random>

using namespace pemesh;

namespace
{

/** Pieces that are more likely to hurt than single bytes. */
const std::string Splinters[] = { "1000000000000000000", "-1", "0", "nan", "inf", "1e999", "1e-999",
  "\n", "\r", " ", "#", "\\\n", "/", "//", "+", "-", ".", "OFF", "solid", "f ", "v ", "endsolid\n",
  std::string(1, '\0'), "\xff\xff\xff\xff", "9223372036854775807", "-9223372036854775808",
  "6 6 6" };

class Mutator
{
public:
  explicit Mutator(std::uint64_t seed)
    : Engine(seed)
  {
  }

  std::string operator()(std::string text)
  {
    const std::size_t changes = 1 + this->Below(4);
    for (std::size_t i = 0; i < changes; ++i)
    {
      const std::size_t at = this->Below(text.size() + 1);
      const std::size_t length = this->Below(8);
      switch (this->Below(6))
      {
        case 0:
          text.resize(at);
          break;
        case 1:
          text.erase(at, length);
          break;
        case 2:
          text.insert(at, Splinters[this->Below(std::size(Splinters))]);
          break;
        case 3:
          text.replace(at, length, Splinters[this->Below(std::size(Splinters))]);
          break;
        case 4:
          text.insert(at, text.substr(this->Below(text.size() + 1), 20));
          break;
        default:
          if (at < text.size())
          {
            text[at] = static_cast<char>(this->Engine());
          }
      }
    }
    return text;
  }

private:
  std::size_t Below(std::size_t bound) { return this->Engine() % bound; }

  std::mt19937_64 Engine;
};

/** Returns whether the file was taken for a mesh, having checked that it is one. */
bool ReadsAsMesh(const std::filesystem::path& path)
{
  try
  {
    const auto mesh = ReadMesh(path);
    if (mesh->GetNumberOfPoints() > 0)
    {
      EXPECT_EQ(ElementAccess::WhyUnusable(mesh), "") << path;
    }
    return true;
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()), "");
    return false;
  }
}

/** Enough for a daily run; PEMESH_FUZZ_ROUNDS asks for more. */
int Rounds()
{
  const char* rounds = std::getenv("PEMESH_FUZZ_ROUNDS");
  return rounds ? std::atoi(rounds) : 2000;
}

} // namespace

class MeshFuzz : public testing::TestWithParam<std::string>
{
};

TEST_P(MeshFuzz, NothingButMeshesAndRefusals)
{
  const MeshFormat* format = FindMeshFormat(GetParam());
  const std::filesystem::path folder = TestFolder();
  const std::filesystem::path path = folder / ("mesh" + std::string(format->Extensions[0]));
  format->Write(path, MakeJitteredGrid(2, 11));
  // Of a pair of files now the one, now the other is damaged.
  std::vector<std::filesystem::path> files{ path };
  if (format->Extensions.size() > 1)
  {
    files.push_back(std::filesystem::path(path).replace_extension(format->Extensions[1]));
  }
  std::vector<std::string> originals;
  for (const auto& file : files)
  {
    originals.push_back(ReadBytes(file));
  }
  Mutator mutate(2026);
  int read = 0;
  for (int round = 0; round < Rounds(); ++round)
  {
    const std::size_t which = static_cast<std::size_t>(round) % files.size();
    WriteBytes(files[which], mutate(originals[which]));
    read += ReadsAsMesh(path) ? 1 : 0;
    WriteBytes(files[which], originals[which]);
  }
  EXPECT_LT(read, Rounds()); // some were refused, so that the files were really damaged
  EXPECT_GT(read, 0);        // and some survived
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshFuzz, testing::ValuesIn(MeshFormatNames()),
  [](const auto& test)
  {
    std::string name = test.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  });

TEST(MeshFuzz, BinaryStl)
{
  std::string text(80, ' ');
  text += std::string("\2\0\0\0", 4);
  const float triangles[2][12] = { { 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0 },
    { 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 0 } };
  for (const auto& triangle : triangles)
  {
    text.append(reinterpret_cast<const char*>(triangle), sizeof(triangle));
    text.append(2, '\0');
  }
  const std::filesystem::path path = TestFolder() / "mesh.stl";
  WriteBytes(path, text);
  EXPECT_EQ(ReadMesh(path)->GetNumberOfPoints(), 4);
  Mutator mutate(84);
  for (int round = 0; round < Rounds(); ++round)
  {
    WriteBytes(path, mutate(text));
    ReadsAsMesh(path);
  }
}
