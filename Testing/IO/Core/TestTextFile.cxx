// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestFolder.h"
#include "TextFile.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <vector>

#include <sys/stat.h>

#include <gmock/gmock.h>

using namespace pemesh;

namespace
{

std::size_t CountFiles(const std::filesystem::path& folder)
{
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    count += entry.path().empty() ? 0 : 1;
  }
  return count;
}

} // namespace

TEST(TextFile, GivesBackWhatWasWritten)
{
  const std::filesystem::path folder = pemesh::TestFolder("round trip – ü");
  std::string bytes;
  for (int i = 0; i < 100000; ++i)
  {
    bytes += static_cast<char>(i * 7);
  }
  for (const std::string& text : { std::string(), std::string("x"), bytes })
  {
    WriteTextFile(folder / "deep" / "er" / "file", text);
    EXPECT_EQ(ReadTextFile(folder / "deep" / "er" / "file"), text);
    EXPECT_EQ(ReadTextFile(folder / "deep" / "er" / "file", 3), text.substr(0, 3));
  }
  EXPECT_EQ(CountFiles(folder / "deep" / "er"), 1U); // no temporary file is left
}

TEST(TextFile, ReadsAPipe)
{
  const std::filesystem::path pipe = pemesh::TestFolder("pipe") / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string text(200000, 'x');
  std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << text; });
  EXPECT_EQ(ReadTextFile(pipe), text);
  writer.join();
}

TEST(TextFile, ReadsFilesThatDoNotKnowTheirSize)
{
  EXPECT_THAT(ReadTextFile("/proc/self/status"), testing::HasSubstr("Pid:"));
}

TEST(TextFile, NamesTheFileThatCannotBeRead)
{
  const std::filesystem::path folder = pemesh::TestFolder("unreadable");
  const auto message = [](const std::string& part)
  { return testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr(part)); };
  EXPECT_THAT([&] { ReadTextFile(folder / "none"); }, message("none\": No such file"));
  EXPECT_THAT([&] { ReadTextFile(folder); }, message("is a folder"));
  EXPECT_THAT([&] { ReadTextFile(""); }, message("Cannot read \"\""));
}

TEST(TextFile, NamesTheFileThatCannotBeWritten)
{
  const std::filesystem::path folder = pemesh::TestFolder("unwritable");
  WriteTextFile(folder / "file", "x");
  std::filesystem::create_directories(folder / "folder");
  const auto message = [](const std::string& part)
  { return testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr(part)); };
  EXPECT_THAT(
    [&] { WriteTextFile(folder / "file" / "x", "y"); }, message("Cannot make the folder"));
  EXPECT_THAT([&] { WriteTextFile(folder / "folder", "y"); }, message("Cannot write"));
  EXPECT_THAT([&] { WriteTextFile("/dev/full/x", "y"); }, message("/dev/full"));
  EXPECT_EQ(CountFiles(folder), 2U);
}

TEST(TextFile, AFailedWriterLeavesTheOldFile)
{
  const std::filesystem::path folder = pemesh::TestFolder("safe");
  WriteTextFile(folder / "file", "old");
  EXPECT_THROW(WriteFileSafely(folder / "file",
                 [](const std::filesystem::path& temporary)
                 {
                   std::ofstream(temporary) << "half";
                   throw std::runtime_error("disk full");
                 }),
    std::runtime_error);
  EXPECT_EQ(ReadTextFile(folder / "file"), "old");
  EXPECT_EQ(CountFiles(folder), 1U);
}

TEST(TextFile, ManyWritersOfOneFileNeverMix)
{
  const std::filesystem::path file = pemesh::TestFolder("many") / "file";
  std::vector<std::thread> writers;
  for (int t = 0; t < 8; ++t)
  {
    writers.emplace_back(
      [&, t]
      {
        for (int i = 0; i < 20; ++i)
        {
          WriteTextFile(file, std::string(5000, static_cast<char>('a' + t)));
        }
      });
  }
  for (std::thread& writer : writers)
  {
    writer.join();
  }
  const std::string text = ReadTextFile(file);
  EXPECT_EQ(text, std::string(5000, text[0]));
}
