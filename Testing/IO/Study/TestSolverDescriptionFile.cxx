// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverDescriptionFile.h"
#include "TestFolder.h"

#include "StudyFile.h"
#include "StudyTexts.h"
#include "TextFile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace
{

namespace fs = std::filesystem;

const char* Toy = R"({
  "name": "toy", "label": "A toy",
  "command": ["toy", "--order", "{order}", "{mesh}", "-o{output}/{stem}", "{{x}}", "{tol}", "{how}"],
  "mesh-format": "obj",
  "options": [
    {"name": "order", "type": "integer", "default": 2, "description": "Order."},
    {"name": "tol", "type": "number"},
    {"name": "how", "default": "fast", "choices": ["fast", "exact"]}],
  "performances": [{"name": "err", "label": "Error", "scale": "log"},
                   {"name": "seconds", "measured": true}],
  "time-limit": 12.5, "version-command": ["toy", "--version"]
})";

std::string ComplaintAbout(const std::string& text)
{
  return Complaint([&] { pemesh::ParseSolverDescription(text, "t.json"); });
}

TEST(SolverDescriptionFile, ReadsEveryKey)
{
  const pemesh::SolverDescription toy = pemesh::ParseSolverDescription(Toy, "x/toy.json");
  EXPECT_EQ(toy.Name, "toy");
  EXPECT_EQ(toy.Label, "A toy");
  EXPECT_EQ(toy.Command.size(), 8u);
  EXPECT_EQ(toy.MeshFormat, "obj");
  ASSERT_EQ(toy.Options.size(), 3u);
  EXPECT_EQ(toy.Options[0].Type, "integer");
  EXPECT_EQ(toy.Options[0].Default, "2");
  EXPECT_EQ(toy.Options[0].Description, "Order.");
  EXPECT_EQ(toy.Options[1].Default, "");
  EXPECT_EQ(toy.Options[2].Type, "string");
  EXPECT_EQ(toy.Options[2].Default, "fast");
  ASSERT_EQ(toy.Performances.size(), 2u);
  EXPECT_EQ(toy.Performances[0].Scale, "log");
  EXPECT_FALSE(toy.Performances[0].Measured);
  EXPECT_EQ(toy.Performances[1].Label, "seconds");
  EXPECT_TRUE(toy.Performances[1].Measured);
  EXPECT_EQ(toy.TimeLimit, 12.5);
  EXPECT_EQ(toy.VersionCommand, (std::vector<std::string>{ "toy", "--version" }));
  EXPECT_EQ(toy.Folder, "x");
  EXPECT_EQ(
    pemesh::ParseSolverDescription(pemesh::FormatSolverDescription(toy), "x/other.json"), toy);
}

TEST(SolverDescriptionFile, Defaults)
{
  const auto toy = pemesh::ParseSolverDescription(R"({"name": "a", "command": ["x"]})", "t.json");
  EXPECT_EQ(toy.Label, "a");
  EXPECT_EQ(toy.MeshFormat, "off");
  EXPECT_EQ(toy.TimeLimit, 0.0);
  EXPECT_TRUE(toy.Options.empty());
}

TEST(SolverDescriptionFile, Messages)
{
  EXPECT_EQ(ComplaintAbout("{}"), "\"t.json\": name is missing (text).");
  EXPECT_EQ(ComplaintAbout(R"({"name": "a"})"), "\"t.json\": command is missing (list of texts).");
  EXPECT_EQ(ComplaintAbout(R"({"name": "a", "command": []})"),
    "\"t.json\": command is empty: name the program and its arguments.");
  EXPECT_THAT(ComplaintAbout(R"({"name": "a", "command": "a b"})"),
    testing::StartsWith("\"t.json\": command is one text where a list of arguments is expected"));
  EXPECT_EQ(ComplaintAbout(R"({"name": "a", "comand": ["x"]})"),
    "\"t.json\": comand is not a key; did you mean command?");
  EXPECT_EQ(ComplaintAbout(R"({"name": "a", "command": ["x", "{meshh}"]})"),
    "\"t.json\": command[1] uses the placeholder {meshh}, which is no option; did you mean "
    "{mesh}?");
  EXPECT_THAT(ComplaintAbout(R"({"name": "a", "command": ["x", "{mesh"]})"),
    testing::HasSubstr("command[1] is \"{mesh\", with a brace that is not paired"));
  EXPECT_THAT(ComplaintAbout(R"({"name": "a", "command": ["x", "mesh}"]})"),
    testing::HasSubstr("not paired"));
  EXPECT_THAT(ComplaintAbout(R"({"name": "a", "command": ["x"], "mesh-format": "of"})"),
    testing::HasSubstr("mesh-format is \"of\"; did you mean \"off\"?"));
  EXPECT_THAT(ComplaintAbout(R"({"name": "a", "command": ["x"], "mesh-format": "stl"})"),
    testing::HasSubstr("mesh-format is \"stl\""));
  EXPECT_THAT(ComplaintAbout(R"({"name": "a/b", "command": ["x"]})"),
    testing::HasSubstr("cannot name a file"));
  EXPECT_THAT(ComplaintAbout(R"({"name": "a", "command": ["x"], "options": [{"name": "mesh"}]})"),
    testing::HasSubstr("options[0].name is \"mesh\", which has a meaning already"));
  EXPECT_THAT(
    ComplaintAbout(R"({"name": "a", "command": ["x"], "options": [{"name": "o"}, {"name": "o"}]})"),
    testing::HasSubstr("options[1].name is \"o\", which is taken."));
  EXPECT_THAT(
    ComplaintAbout(
      R"({"name": "a", "command": ["x"], "options": [{"name": "o", "type": "integer", "default": 1.5}]})"),
    testing::HasSubstr("options[0].default is 1.5 where an integer is expected."));
  EXPECT_THAT(
    ComplaintAbout(R"({"name": "a", "command": ["x"], "performances": [{"name": "../e"}]})"),
    testing::HasSubstr("performances[0].name"));
}

/** Two search folders with descriptions. */
class SolverSearch : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Root = pemesh::TestFolder();
    pemesh::WriteTextFile(this->Root / "one/toy.json", Toy);
    pemesh::WriteTextFile(this->Root / "one/broken.json", "{");
    pemesh::WriteTextFile(
      this->Root / "two/toy.json", R"({"name": "toy", "label": "Hidden", "command": ["x"]})");
    pemesh::WriteTextFile(this->Root / "two/file.json", R"({"name": "alpha", "command": ["x"]})");
    this->Folders = { this->Root / "one", this->Root / "missing", this->Root / "two" };
  }

  fs::path Root;
  std::vector<fs::path> Folders;
};

TEST_F(SolverSearch, ListsByNameTheFirstWins)
{
  const std::vector<pemesh::FoundSolver> all = pemesh::ListSolvers(this->Folders);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].Description.Name, "alpha");
  EXPECT_EQ(all[1].Description.Name, "broken");
  EXPECT_NE(all[1].Error, "");
  EXPECT_EQ(all[2].Description.Label, "A toy");
  EXPECT_EQ(all[2].File, this->Root / "one/toy.json");
}

TEST_F(SolverSearch, TheBundledSolverComesFirst)
{
  pemesh::WriteTextFile(
    this->Root / "two/last.json", R"({"name": "pemesh-vem", "command": ["x"]})");
  const std::vector<pemesh::FoundSolver> all = pemesh::ListSolvers(this->Folders);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].Description.Name, "pemesh-vem");
  EXPECT_EQ(all[1].Description.Name, "alpha");
}

TEST_F(SolverSearch, FindsByNameAndByFile)
{
  EXPECT_EQ(pemesh::FindSolver("alpha", {}, this->Folders).Folder, this->Root / "two");
  EXPECT_EQ(pemesh::FindSolver("two/toy.json", this->Root, {}).Label, "Hidden");
  EXPECT_EQ(
    pemesh::FindSolver((this->Root / "two/toy.json").string(), "/else", {}).Label, "Hidden");
  EXPECT_THAT(Complaint([this] { pemesh::FindSolver("alpah", {}, this->Folders); }),
    testing::StartsWith("No solver is called \"alpah\"; did you mean \"alpha\"?"));
  EXPECT_THAT(Complaint([this] { pemesh::FindSolver("broken", {}, this->Folders); }),
    testing::HasSubstr("broken.json\", line 1"));
  EXPECT_THAT(Complaint([this] { pemesh::FindSolver("none.json", this->Root, this->Folders); }),
    testing::HasSubstr("none.json"));
  EXPECT_THAT(Complaint([] { pemesh::FindSolver("x", {}, {}); }),
    testing::StartsWith("No solver is called \"x\" (looked in no folder"));
}

TEST_F(SolverSearch, RunsGetTheDefaultsOfTheirSolver)
{
  pemesh::Study study = pemesh::ParseStudy(R"({"pemesh": 1, "polygons": [], "solvers": [
    {"solver": "toy", "tol": 1, "order": 3}, {"solver": "alpha", "time-limit": 4}]})",
    this->Root / "s.json");
  const auto descriptions = pemesh::FindStudySolvers(study, this->Folders);
  ASSERT_EQ(descriptions.size(), 2u);
  EXPECT_EQ(descriptions[0].Name, "toy");
  using Option = std::pair<std::string, pemesh::StudyScalar>;
  EXPECT_EQ(study.Solvers[0].Options,
    (std::vector<Option>{
      { "order", std::int64_t{ 3 } }, { "tol", 1.0 }, { "how", std::string("fast") } }));
  EXPECT_EQ(study.Solvers[0].TimeLimit, 12.5);
  EXPECT_EQ(study.Solvers[1].TimeLimit, 4.0);
  EXPECT_EQ(pemesh::ParseStudy(pemesh::FormatStudy(study), this->Root / "s.json"), study);
}

TEST_F(SolverSearch, OptionsOfRunsAreChecked)
{
  const auto complaint = [this](const std::string& options)
  {
    pemesh::Study study = pemesh::ParseStudy(
      R"({"pemesh": 1, "name": "s", "polygons": [], "solvers": [{"solver": "toy", )" + options +
        "}]}",
      "s.json");
    return Complaint([&] { pemesh::FindStudySolvers(study, this->Folders); });
  };
  EXPECT_EQ(complaint(R"("tol": 1, "oder": 2)"),
    "\"s\": solvers[0].oder is not an option of the solver toy; did you mean order?");
  EXPECT_EQ(complaint(R"("tol": 1, "nam": "x")"),
    "\"s\": solvers[0].nam is not an option of the solver toy; did you mean name?");
  EXPECT_EQ(complaint(R"("order": 2)"),
    "\"s\": solvers[0].tol is missing: the solver toy has no default for it.");
  EXPECT_EQ(complaint(R"("tol": 1, "order": "2")"),
    "\"s\": solvers[0].order is \"2\" where an integer is expected.");
  EXPECT_EQ(complaint(R"("tol": "small")"),
    "\"s\": solvers[0].tol is \"small\" where a number is expected.");
  EXPECT_EQ(
    complaint(R"("tol": 1, "how": 7)"), "\"s\": solvers[0].how is 7 where a text is expected.");
  EXPECT_EQ(complaint(R"("tol": 1, "how": "exakt")"),
    "\"s\": solvers[0].how is \"exakt\"; did you mean \"exact\"? (one of fast, exact)");
  EXPECT_EQ(complaint(R"("tol": 1, "how": "exact")"), "nothing thrown");
}

TEST(SolverFolders, EnvironmentComesFirst)
{
  setenv("PEMESH_SOLVERS", "/nowhere/one::/nowhere/two", 1);
  const std::vector<fs::path> folders = pemesh::SolverFolders();
  unsetenv("PEMESH_SOLVERS");
  ASSERT_GE(folders.size(), 3u) << "the source tree comes last";
  EXPECT_EQ(folders[0], "/nowhere/one");
  EXPECT_EQ(folders[1], "/nowhere/two");
  EXPECT_TRUE(fs::exists(folders[2]));
}

TEST(SolverFolders, TheBundledDescriptionsAreGood)
{
  const std::vector<pemesh::FoundSolver> all = pemesh::ListSolvers();
  EXPECT_FALSE(all.empty());
  for (const pemesh::FoundSolver& found : all)
  {
    EXPECT_EQ(found.Error, "") << found.File;
  }
}

} // namespace
