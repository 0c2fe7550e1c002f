// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The batch script of a study: run here without Slurm, by stand-ins for what it calls.
 */
#include "ProgramRun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

void WriteFile(const fs::path& path, const std::string& text)
{
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

class SlurmTest : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Folder = TestFolder() / "it's \"odd\" $(x)"; // and all the rest that shells trip over
    WriteFile(this->Folder / "s.json",
      R"({"pemesh": 1, "name": "my study", "polygons": [{"family": "zeta"}], "metrics": ["Area"],
          "sweep": [{"parameter": "t", "values": [0, 0.5]}]})");
  }

  pemesh::ProgramRun Write(std::vector<std::string> more) const
  {
    std::vector<std::string> arguments{ "slurm", "s.json", "--script", "job.slurm" };
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunProgram("pemesh", arguments, this->Folder);
  }

  /** Runs the script as Slurm would, with further variables. */
  pemesh::ProgramRun RunScript(std::vector<std::string> arguments) const
  {
    arguments.insert(arguments.begin(), "-C");
    arguments.insert(arguments.begin() + 1, "/");
    arguments.insert(arguments.end(), { "bash", this->Folder / "job.slurm" });
    return RunProgram("/usr/bin/env", arguments);
  }

  fs::path Folder;
};

} // namespace

TEST_F(SlurmTest, TheScriptRunsTheStudyAndGoesOn)
{
  const auto written = this->Write({ "--set", "sweep[0].values=[0, 0.25, 0.5]", "--retry", "2" });
  ASSERT_EQ(written.ExitCode, 0) << written.Errors;
  EXPECT_THAT(written.Errors, HasSubstr("3 meshes. Queue them: sbatch"));
  EXPECT_EQ(RunProgram("/bin/bash", { "-n", this->Folder / "job.slurm" }).ExitCode, 0);
  const auto run = this->RunScript({});
  EXPECT_EQ(run.ExitCode, 0) << run.Errors;
  EXPECT_THAT(run.Output, HasSubstr("3 meshes, 0 failures"));
  EXPECT_TRUE(fs::exists(this->Folder / "my study" / "results.csv"));
  EXPECT_THAT(this->RunScript({}).Output, HasSubstr("3 meshes (3 as they were), 0 failures"));
}

TEST_F(SlurmTest, OptionsAreThoseOfSbatch)
{
  ASSERT_EQ(this
              ->Write({ "--nodes", "2", "--ntasks", "8", "--cpus-per-task", "4", "--time",
                "12:00:00", "--mem", "32G", "--partition", "long" })
              .ExitCode,
    0);
  const std::string text = FileText(this->Folder / "job.slurm");
  EXPECT_THAT(text,
    HasSubstr("#SBATCH --job-name=my-study\n#SBATCH --nodes=2\n#SBATCH --ntasks=8\n"
              "#SBATCH --cpus-per-task=4\n#SBATCH --time=12:00:00\n#SBATCH --mem=32G\n"
              "#SBATCH --partition=long\n"));
  EXPECT_THAT(text, Not(HasSubstr("--account")));
  // Nothing stands between the first line and these: Slurm reads them up to the first command.
  const std::string head = text.substr(0, text.rfind("#SBATCH"));
  EXPECT_THAT(head, Not(HasSubstr("\n\n")));
  // With several tasks mpiexec starts them.
  WriteFile(this->Folder / "bin" / "mpiexec", "#!/bin/sh\nprintf '%s ' \"$@\"\n");
  fs::permissions(this->Folder / "bin" / "mpiexec", fs::perms::owner_all);
  const auto run = this->RunScript({ "PATH=" + (this->Folder / "bin").string() + ":/usr/bin:/bin",
    "SLURM_NTASKS=8", "SLURM_CPUS_PER_TASK=4" });
  EXPECT_EQ(run.ExitCode, 0) << run.Errors;
  EXPECT_THAT(run.Output, HasSubstr("-n 8 --bind-to none " PEMESH_BINARY_DIR "/bin/pemesh run "));
  EXPECT_THAT(run.Output, HasSubstr("-j 4 --resume "));
}

TEST_F(SlurmTest, WhenTheTimeIsOverTheJobIsQueuedAgain)
{
  ASSERT_EQ(this->Write({ "--ntasks", "2" }).ExitCode, 0);
  // What mpiexec does with SIGUSR1, and pemesh with it: end soon, and say that it is not done.
  WriteFile(this->Folder / "bin" / "mpiexec",
    "#!/bin/bash\ntrap 'echo stopping; exit 1' USR1\nkill -USR1 $PPID\n"
    "for i in 1 2 3 4 5 6 7 8 9 10; do sleep 0.2; done\necho 'not told'\n");
  WriteFile(this->Folder / "bin" / "scontrol", "#!/bin/sh\necho scontrol \"$@\"\n");
  for (const char* name : { "mpiexec", "scontrol" })
  {
    fs::permissions(this->Folder / "bin" / name, fs::perms::owner_all);
  }
  const auto run = this->RunScript({ "PATH=" + (this->Folder / "bin").string() + ":/usr/bin:/bin",
    "SLURM_NTASKS=2", "SLURM_JOB_ID=42" });
  EXPECT_EQ(run.ExitCode, 1) << run.Errors;
  EXPECT_THAT(run.Output, HasSubstr("stopping\n"));
  EXPECT_THAT(run.Output, HasSubstr("scontrol requeue 42\n"));
}

TEST_F(SlurmTest, WhatWouldFailInTheQueueIsRefusedAtOnce)
{
  const auto wrong = this->Write({ "--set", "mesh.no-such-key=1" });
  EXPECT_EQ(wrong.ExitCode, 2);
  EXPECT_THAT(wrong.Errors, HasSubstr("no-such-key"));
  const auto injected = this->Write({ "--partition", "a\n#SBATCH --mail-user=b" });
  EXPECT_EQ(injected.ExitCode, 2);
  EXPECT_THAT(injected.Errors, HasSubstr("--partition"));
  EXPECT_FALSE(fs::exists(this->Folder / "job.slurm"));
}
