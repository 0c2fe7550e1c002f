// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Disks that are full, read only or gone. They are small ones of memory, in a name space of this
 * test alone, which any user may have; where that is forbidden the tests are skipped.
 */
#include "ProgramRun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

namespace fs = std::filesystem;
using pemesh::FileText;
using pemesh::RunProgram;
using pemesh::TestFolder;
using testing::HasSubstr;
using testing::Not;

namespace
{

class FullDisk : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Folder = TestFolder();
    fs::create_directories(this->Folder / "disk");
    fs::create_directories(this->Folder / "kept");
    if (this->Script("mount -t tmpfs -o size=1m tmpfs disk").ExitCode != 0)
    {
      GTEST_SKIP() << "no mounts of one's own here";
    }
    std::ofstream(this->Folder / "s.json") << R"({"pemesh": 1, "name": "s",
      "polygons": [{"family": "maze"}], "output": {"formats": ["vtp", "off"]},
      "sweep": [{"parameter": "t", "from": 0, "to": 0.8, "count": 16}],
      "mesh": {"target": {"quantity": "elements", "value": 500}}})";
  }

  /** Runs commands in the folder, where $pemesh is the program with a study. */
  pemesh::ProgramRun Script(const std::string& commands) const
  {
    return RunProgram("/usr/bin/unshare",
      { "--user", "--map-root-user", "--mount", "/bin/sh", "-c",
        "pemesh='" PEMESH_BINARY_DIR "/bin/pemesh run s.json -j 2'\n" + commands },
      this->Folder);
  }

  /** Meshes and tables of a folder are whole: those of an undisturbed run. */
  void ExpectWhole(const fs::path& folder) const
  {
    for (const auto& entry : fs::recursive_directory_iterator(folder))
    {
      const fs::path name = fs::relative(entry.path(), folder);
      const std::string extension = name.extension();
      if (extension == ".vtp" || extension == ".off")
      {
        EXPECT_EQ(FileText(entry.path()), FileText(this->Folder / "good" / name)) << name;
      }
      else if (extension == ".csv" || extension == ".pvd")
      {
        EXPECT_THAT(FileText(entry.path()), testing::EndsWith("\n")) << name;
      }
    }
  }

  static void ExpectNoParts(const fs::path& folder)
  {
    for (const auto& entry : fs::recursive_directory_iterator(folder))
    {
      EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
    }
  }

  fs::path Folder;
};

long Sentences(const std::string& errors)
{
  return std::count(errors.begin(), errors.end(), '\n');
}

} // namespace

TEST_F(FullDisk, WhatFitsIsWholeAndTheRestComesWhenThereIsRoom)
{
  const auto run = this->Script("$pemesh -o good >&2 || exit 9\n"
                                "mount -t tmpfs -o size=700k tmpfs disk\n"
                                "$pemesh -o disk/out; first=$?\n"
                                "cp -r disk/out kept/full\n"
                                "mount -o remount,size=60m disk\n"
                                "$pemesh -o disk/out --resume; second=$?\n"
                                "cp -r disk/out kept/resumed\n"
                                "echo codes $first $second");
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  EXPECT_THAT(run.Output, HasSubstr("codes 1 0")) << run.Errors;
  EXPECT_THAT(run.Errors, HasSubstr("No space left on device"));
  ExpectNoParts(this->Folder / "kept");
  this->ExpectWhole(this->Folder / "kept" / "full");
  this->ExpectWhole(this->Folder / "kept" / "resumed");
  EXPECT_EQ(FileText(this->Folder / "kept" / "resumed" / "results.csv"),
    FileText(this->Folder / "good" / "results.csv"));
}

TEST_F(FullDisk, FilesThatMayNotGrowAreNoKill)
{
  const auto run = this->Script("$pemesh -o good >&2 || exit 9\n"
                                "(ulimit -f 40; $pemesh -o kept/small); echo code $?\n"
                                "$pemesh -o kept/small --resume");
  ASSERT_EQ(run.ExitCode, 0) << run.Errors;
  EXPECT_THAT(run.Output, HasSubstr("code 1"));
  EXPECT_THAT(run.Errors, HasSubstr("File too large"));
  EXPECT_EQ(FileText(this->Folder / "kept" / "small" / "results.csv"),
    FileText(this->Folder / "good" / "results.csv"));
}

TEST_F(FullDisk, AReadOnlyFolderIsRefusedInOneSentence)
{
  const auto run = this->Script("mount -t tmpfs -o size=1m,ro tmpfs disk\n"
                                "$pemesh -o disk/out; echo code $?");
  EXPECT_THAT(run.Output, HasSubstr("code 2"));
  EXPECT_THAT(run.Errors, HasSubstr("Read-only file system"));
  EXPECT_EQ(Sentences(run.Errors), 1) << run.Errors;
}

TEST_F(FullDisk, AMountThatVanishesEndsTheRun)
{
  const auto run = this->Script("$pemesh -o good >&2 || exit 9\n"
                                "mount -t tmpfs tmpfs disk\n"
                                "$pemesh -o disk/out & running=$!\n"
                                "until [ -e disk/out/meshes/003*.vtp ]; do\n"
                                "  kill -0 $running || exit 9; sleep 0.01; done\n"
                                "mkdir seen; mount --bind disk seen\n"
                                "umount -l disk\n"
                                "wait $running; echo code $?\n"
                                "cp -r seen/out kept/before\n"
                                "find disk -type f");
  EXPECT_THAT(run.Output, HasSubstr("code 1\n")) << run.Errors;
  EXPECT_THAT(run.Output, testing::EndsWith("code 1\n")) << "no file in place of the lost disk";
  EXPECT_THAT(run.Errors, HasSubstr("has vanished"));
  // What was being written when the disk went stays there under its temporary name.
  this->ExpectWhole(this->Folder / "kept" / "before");
}
