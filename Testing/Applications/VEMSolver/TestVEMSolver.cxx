// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The program `pemesh-vem` as a user or another program calls it.
 */
#include "NumberText.h"
#include "ProgramRun.h"
#include "TestProblems.h"
#include "VirtualElementMethod.h"
#include "VirtualElementOptions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using pemesh::FileText;
using pemesh::ProgramRun;
using pemesh::TestFolder;
using testing::HasSubstr;

const std::filesystem::path Meshes = std::filesystem::path(PEMESH_TEST_DATA) / "Meshes";
const std::string Jenga = (Meshes / "vem_quality_2d/Jenga1.off").string();

ProgramRun RunSolver(
  const std::vector<std::string>& arguments, const std::filesystem::path& folder = {})
{
  return pemesh::RunProgram("pemesh-vem", arguments, folder);
}

double NumberIn(const std::filesystem::path& path)
{
  const std::string text = FileText(path);
  EXPECT_EQ(text.find('\n'), text.size() - 1) << path << " holds " << text;
  return pemesh::ParseNumber(text).value_or(-1.0);
}

std::vector<double> NumbersIn(const std::filesystem::path& path)
{
  std::vector<double> numbers;
  std::istringstream lines(FileText(path));
  for (std::string line; std::getline(lines, line);)
  {
    const std::optional<double> number = pemesh::ParseNumber(line);
    EXPECT_TRUE(number.has_value()) << line;
    numbers.push_back(number.value_or(0.0));
  }
  return numbers;
}

std::set<std::string> FilesIn(const std::filesystem::path& folder)
{
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    names.insert(entry.path().filename().string());
  }
  return names;
}

// One sentence on standard error, and nothing written.
void ExpectRefused(const ProgramRun& run, int exitCode, const std::string& words)
{
  EXPECT_EQ(run.ExitCode, exitCode);
  EXPECT_EQ(run.Output, "");
  EXPECT_THAT(run.Errors, testing::StartsWith("pemesh-vem: "));
  EXPECT_THAT(run.Errors, HasSubstr(words));
  EXPECT_EQ(std::count(run.Errors.begin(), run.Errors.end(), '\n'), 1) << run.Errors;
}

TEST(VEMSolver, LeavesTheFilesOfTheContract)
{
  const auto folder = TestFolder("contract") / "made" / "here";
  const ProgramRun run =
    RunSolver({ "--mesh", Jenga, "--output", folder.string(), "--problem", "franke-1979" });
  EXPECT_EQ(run.ExitCode, 0) << run.Errors;
  EXPECT_EQ(run.Output + run.Errors, "");
  std::set<std::string> expected = { "Jenga1-solution.txt", "Jenga1-ground-truth.txt" };
  for (const auto& performance : pemesh::VirtualElementPerformances())
  {
    expected.insert(std::string("Jenga1-") + performance.Name + ".txt");
  }
  expected.insert({ "Jenga1-ErrorL2.txt", "Jenga1-ErrorH1.txt" });
  EXPECT_EQ(FilesIn(folder), expected);
  EXPECT_EQ(NumbersIn(folder / "Jenga1-solution.txt").size(), 37u);
  EXPECT_EQ(NumbersIn(folder / "Jenga1-ground-truth.txt").size(), 37u);
  EXPECT_EQ(NumberIn(folder / "Jenga1-dofs.txt"), 21.0);
  EXPECT_NEAR(NumberIn(folder / "Jenga1-condition-number.txt"), 31.16358027, 1.0e-6);
  EXPECT_NEAR(NumberIn(folder / "Jenga1-relative-error-energy.txt"), 0.4319933752, 1.0e-9);
  EXPECT_NEAR(NumberIn(folder / "Jenga1-relative-error-inf.txt"), 0.1976247986, 1.0e-9);
  EXPECT_NEAR(NumberIn(folder / "Jenga1-relative-error-l2.txt"), 0.1979098257, 1.0e-9);
  EXPECT_NEAR(NumberIn(folder / "Jenga1-relative-error-h1.txt"), 0.6593891584, 1.0e-9);
  EXPECT_GE(NumberIn(folder / "Jenga1-solve-seconds.txt"), 0.0);
  EXPECT_EQ(FileText(folder / "Jenga1-condition-number-2.txt"), "nan\n"); // a detail
  double square = 0.0;
  for (const double error : NumbersIn(folder / "Jenga1-ErrorL2.txt"))
  {
    square += error * error;
  }
  EXPECT_NEAR(std::sqrt(square), NumberIn(folder / "Jenga1-absolute-error-l2.txt"), 1.0e-12);
}

TEST(VEMSolver, TheFormatOfTheMeshDoesNotMatter)
{
  const auto folder = TestFolder("formats");
  // The same two squares and two triangles, one vertex inside.
  std::ofstream(folder / "m.off") << "OFF\n5 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 .4 0\n"
                                     "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";
  std::ofstream(folder / "n.obj") << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .4 0\n"
                                     "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
  std::ofstream(folder / "o.node") << "5 0\n0 0\n1 0\n1 1\n0 1\n.5 .4\n";
  std::ofstream(folder / "o.ele") << "4\n3 1 2 5\n3 2 3 5\n3 3 4 5\n3 4 1 5\n";
  for (const char* name : { "m.off", "n.obj" })
  {
    EXPECT_EQ(RunSolver({ "--mesh", name, "--output", "." }, folder).ExitCode, 0);
  }
  EXPECT_EQ(
    RunSolver({ "--mesh", "o.node", "--ele", "o.ele", "--output", "." }, folder).ExitCode, 0);
  const std::string solution = FileText(folder / "m-solution.txt");
  EXPECT_NE(solution, "");
  EXPECT_EQ(FileText(folder / "n-solution.txt"), solution);
  EXPECT_EQ(FileText(folder / "o-solution.txt"), solution);
}

TEST(VEMSolver, ThreadsAndRepetitionChangeNothing)
{
  const auto folder = TestFolder("threads");
  const std::string mesh = (Meshes / "vem_quality_2d/Triangle3.off").string();
  for (const char* threads : { "1", "2", "0" })
  {
    ASSERT_EQ(
      RunSolver({ "--mesh", mesh, "--output", (folder / threads).string(), "--threads", threads })
        .ExitCode,
      0);
  }
  for (const std::string& name : FilesIn(folder / "1"))
  {
    if (name.find("-seconds") == std::string::npos && name.find("-mega") == std::string::npos)
    {
      EXPECT_EQ(FileText(folder / "1" / name), FileText(folder / "2" / name)) << name;
      EXPECT_EQ(FileText(folder / "1" / name), FileText(folder / "0" / name)) << name;
    }
  }
}

TEST(VEMSolver, TheOptionsOfTheMethodAreHeard)
{
  const auto folder = TestFolder("options");
  const std::vector<std::vector<std::string>> choices = { {}, { "--p0", "vertex" },
    { "--load", "pinabla" }, { "--problem", "trigonometric" }, { "--order", "3" },
    { "--stabilisation", "none" }, { "--reaction", "1+x" }, { "--advection-x", "2" },
    { "--solution", "exp(x)*y" }, { "--source", "1", "--dirichlet", "0" },
    { "--neumann", "x-0.999" } };
  std::set<std::string> solutions;
  for (const auto& choice : choices)
  {
    std::vector<std::string> arguments = { "--mesh", Jenga, "--output", folder.string() };
    arguments.insert(arguments.end(), choice.begin(), choice.end());
    EXPECT_EQ(RunSolver(arguments).ExitCode, 0);
    solutions.insert(FileText(folder / "Jenga1-solution.txt"));
  }
  EXPECT_EQ(solutions.size(), choices.size());
}

TEST(VEMSolver, AllDetailsAreNumbers)
{
  const auto folder = TestFolder("details");
  const ProgramRun run =
    RunSolver({ "--mesh", Jenga, "--output", folder.string(), "--order", "2", "--details", "all" });
  EXPECT_EQ(run.ExitCode, 0);
  EXPECT_EQ(run.Errors, "");
  for (const auto& performance : pemesh::VirtualElementPerformances())
  {
    EXPECT_TRUE(
      std::isfinite(NumberIn(folder / (std::string("Jenga1-") + performance.Name + ".txt"))))
      << performance.Name;
  }
  for (const double condition : NumbersIn(folder / "Jenga1-ProjectionCondition.txt"))
  {
    EXPECT_GE(condition, 1.0);
  }
}

TEST(VEMSolver, SaysWhatItIsAndWhatItSolves)
{
  const ProgramRun version = RunSolver({ "--version" });
  EXPECT_EQ(version.ExitCode, 0);
  EXPECT_THAT(version.Output, testing::MatchesRegex("pemesh-vem [0-9]+\\.[0-9]+\\.[0-9]+\n"));
  const ProgramRun problems = RunSolver({ "--list-problems" });
  EXPECT_EQ(problems.ExitCode, 0);
  EXPECT_THAT(problems.Output, HasSubstr("franke-1979"));
  const ProgramRun help = RunSolver({ "--help" });
  EXPECT_EQ(help.ExitCode, 0);
  EXPECT_THAT(help.Output, HasSubstr("--order"));
}

TEST(VEMSolver, WrongUsageIsToldInASentence)
{
  const std::string out = TestFolder("usage").string();
  ExpectRefused(RunSolver({ "--output", out }), 2, "--mesh");
  ExpectRefused(RunSolver({ "--mesh", Jenga }), 2, "--output");
  ExpectRefused(RunSolver({ "--mesh", Jenga, "--output", out, "--order", "7" }), 2, "Order 7");
  ExpectRefused(
    RunSolver({ "--mesh", Jenga, "--output", out, "--solution", "sin(x" }), 2, "solution");
  ExpectRefused(
    RunSolver({ "--mesh", Jenga, "--output", out, "--problem", "frank" }), 2, "\"franke\"");
  ExpectRefused(
    RunSolver({ "--mesh", "a.node", "--ele", "b.ele", "--output", out }), 2, "not a pair");
  for (const auto& wrong : std::vector<std::vector<std::string>>{ { "--p0", "corner" },
         { "--load", "x" }, { "--threads", "-1" }, { "--order", "one" }, { "--frobnicate" } })
  {
    std::vector<std::string> arguments = { "--mesh", Jenga, "--output", out };
    arguments.insert(arguments.end(), wrong.begin(), wrong.end());
    const ProgramRun run = RunSolver(arguments);
    EXPECT_EQ(run.ExitCode, 2) << wrong[0];
    EXPECT_THAT(run.Output + run.Errors, HasSubstr(wrong[0]));
  }
  EXPECT_TRUE(FilesIn(out).empty());
}

TEST(VEMSolver, BadMeshesAreToldInASentence)
{
  const auto folder = TestFolder("bad");
  const std::string out = (folder / "out").string();
  const auto refuse = [&](const std::string& name, const std::string& text, const char* words)
  {
    SCOPED_TRACE(name);
    std::ofstream(folder / name) << text;
    ExpectRefused(RunSolver({ "--mesh", (folder / name).string(), "--output", out }), 1, words);
  };
  ExpectRefused(
    RunSolver({ "--mesh", (folder / "missing.off").string(), "--output", out }), 1, "missing.off");
  refuse("empty.off", "", "empty.off");
  refuse("truncated.off", FileText(Jenga).substr(0, 400), "truncated.off");
  refuse("index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n", "9");
  refuse("nan.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", "nan.off");
  refuse("words.off", "OFF\n3 1 0\n0 0 0\nhello\n0 1 0\n3 0 1 2\n", "words.off");
  refuse("mesh.xyz", "whatever", "mesh.xyz");
  refuse("single.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "no vertex inside");
  refuse("twice.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n.2 .2 0\n3 0 1 2\n3 0 1 3\n", "overlap");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(VEMSolver, AFolderThatCannotBeWrittenIsToldInASentence)
{
  const auto folder = TestFolder("unwritable");
  std::ofstream(folder / "file") << "in the way";
  const ProgramRun run = RunSolver({ "--mesh", Jenga, "--output", (folder / "file").string() });
  ExpectRefused(run, 1, "file");
}

TEST(VEMSolver, UndefinedAndMeaninglessNumbersAreMentioned)
{
  const auto folder = TestFolder("notes");
  const ProgramRun undefined =
    RunSolver({ "--mesh", (Meshes / "vem_quality_2d/Jenga0.off").string(), "--output",
      folder.string(), "--problem", "trigonometric" });
  EXPECT_EQ(undefined.ExitCode, 0);
  EXPECT_THAT(undefined.Errors, HasSubstr("relative-error-energy, "));
  EXPECT_THAT(undefined.Errors, HasSubstr("undefined on this mesh"));
  EXPECT_EQ(FileText(folder / "Jenga0-relative-error-energy.txt"), "nan\n");

  // A vertex so near the boundary that one diagonal entry is 1e18 times the other.
  std::ofstream(folder / "flat.off")
    << "OFF\n6 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 1e-18 0\n.5 .5 0\n"
       "3 0 1 4\n3 0 4 5\n3 4 1 5\n3 1 2 5\n3 2 3 5\n3 3 0 5\n";
  const ProgramRun flat =
    RunSolver({ "--mesh", (folder / "flat.off").string(), "--output", folder.string() });
  EXPECT_EQ(flat.ExitCode, 0) << flat.Errors;
  EXPECT_THAT(flat.Errors, HasSubstr("beyond double precision"));
}

/** The names of a table. */
template <typename Table>
std::vector<std::string> NamesIn(const Table& table)
{
  std::vector<std::string> names;
  for (const auto& entry : table)
  {
    names.emplace_back(entry.Name);
  }
  return names;
}

TEST(VEMSolver, TheDescriptionOffersWhatThereIsToChoose)
{
  std::ifstream file(PEMESH_SOURCE_DIR "/Applications/Solvers/pemesh-vem.json");
  std::map<std::string, std::vector<std::string>> choices;
  const nlohmann::json description = nlohmann::json::parse(file);
  for (const nlohmann::json& option : description["options"])
  {
    choices[option["name"]] = option.value("choices", std::vector<std::string>());
  }
  EXPECT_EQ(choices["problem"], NamesIn(pemesh::TestProblems()));
  EXPECT_EQ(choices["basis"], NamesIn(pemesh::BasisRules()));
  EXPECT_EQ(choices["stabilisation"], NamesIn(pemesh::StabilisationRules()));
  EXPECT_EQ(choices["p0"], NamesIn(pemesh::ProjectionConstants()));
  EXPECT_EQ(choices["load"], NamesIn(pemesh::LoadProjections()));
  EXPECT_EQ(choices["linear-solver"], NamesIn(pemesh::SolverKinds()));
}

TEST(VEMSolver, TheDescriptionNamesWhatTheProgramWrites)
{
  std::ifstream file(PEMESH_SOURCE_DIR "/Applications/Solvers/pemesh-vem.json");
  const nlohmann::json description = nlohmann::json::parse(file);
  EXPECT_EQ(description.at("name"), "pemesh-vem");
  const auto table = pemesh::VirtualElementPerformances();
  const auto& performances = description.at("performances");
  ASSERT_EQ(performances.size(), table.size());
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    EXPECT_EQ(performances[i].at("name"), table[i].Name);
    EXPECT_EQ(performances[i].at("label"), table[i].Label);
    EXPECT_EQ(performances[i].at("scale"), table[i].Logarithmic ? "log" : "linear");
    EXPECT_EQ(performances[i].value("measured", false), table[i].Measured);
  }
  const auto arrays = pemesh::VirtualElementArrays();
  ASSERT_EQ(description.at("elements").size(), arrays.size());
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    EXPECT_EQ(description.at("elements")[i].at("name"), arrays[i].Name);
    EXPECT_EQ(description.at("elements")[i].at("label"), arrays[i].Label);
  }
}

// The command of the description, its placeholders filled in, is a command that the program takes.
TEST(VEMSolver, TheCommandOfTheDescriptionRuns)
{
  std::ifstream file(PEMESH_SOURCE_DIR "/Applications/Solvers/pemesh-vem.json");
  const nlohmann::json description = nlohmann::json::parse(file);
  const auto folder = TestFolder("description");
  std::vector<std::pair<std::string, std::string>> values = { { "{mesh}", Jenga },
    { "{output}", folder.string() }, { "{threads}", "1" } };
  for (const auto& option : description.at("options"))
  {
    const auto& value = option.at("default");
    values.emplace_back("{" + option.at("name").get<std::string>() + "}",
      value.is_string() ? value.get<std::string>() : value.dump());
  }
  std::vector<std::string> arguments;
  for (const auto& word : description.at("command"))
  {
    std::string argument = word;
    for (const auto& [placeholder, value] : values)
    {
      argument = argument == placeholder ? value : argument;
    }
    EXPECT_EQ(argument.find('{'), std::string::npos) << argument;
    arguments.push_back(argument);
  }
  ASSERT_EQ(arguments.front(), "pemesh-vem");
  arguments.erase(arguments.begin());
  const ProgramRun run = RunSolver(arguments);
  EXPECT_EQ(run.ExitCode, 0) << run.Errors;
  EXPECT_TRUE(std::filesystem::exists(folder / "Jenga1-condition-number.txt"));
}

} // namespace
