// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyFile.h"
#include "TestFolder.h"

#include "StudyTexts.h"
#include "TextFile.h"

#include <gtest/gtest.h>

#include <clocale>
#include <filesystem>

namespace
{

using pemesh::FormatStudy;
using pemesh::ParseStudy;
using pemesh::Study;
using pemesh::StudyScalar;

TEST(StudyFile, ReadsEveryKey)
{
  const Study study = ParseStudy(FullStudy, "folder/full.json");
  EXPECT_EQ(study.Folder, "folder");
  EXPECT_EQ(study.Name, "comb and star");
  EXPECT_EQ(study.WrittenBy, "PEMesh 0.1.0");
  ASSERT_EQ(study.Polygons.size(), 3u);
  const pemesh::StudyPolygon& comb = study.Polygons[0];
  EXPECT_EQ(comb.Family, "comb");
  EXPECT_EQ(comb.Name, "left");
  EXPECT_EQ(comb.Center, (std::array<double, 2>{ 0.3, 0.25 }));
  EXPECT_EQ(comb.Scale, 0.8);
  EXPECT_EQ(comb.Rotation, 15.5);
  using Parameters = std::vector<std::pair<std::string, double>>;
  EXPECT_EQ(comb.Parameters, (Parameters{ { "teeth", 7 } }));
  EXPECT_EQ(comb.From, 0.1);
  EXPECT_EQ(comb.To, 0.95);
  EXPECT_EQ(study.Polygons[1].Parameters, (Parameters{ { "spikes", 9 } }));
  EXPECT_EQ(study.Polygons[2].Parameters, Parameters());
  EXPECT_EQ(TimesOf(study), (std::vector<double>{ 0.25, 0.5, 0.75 }));
  EXPECT_EQ(study.Mesh.MaximumArea.Rule, "constant");
  EXPECT_EQ(study.Mesh.MaximumArea.Value, 0.01);
  EXPECT_EQ(study.Mesh.MinimumAngle, 25.5);
  EXPECT_TRUE(study.Mesh.PreservePolygons);
  EXPECT_EQ(study.Metrics.Names, (std::vector<std::string>{ "MinAngle", "Area" }));
  ASSERT_EQ(study.Solvers.size(), 2u);
  EXPECT_EQ(study.Solvers[0].Name, "plain");
  EXPECT_EQ(study.Solvers[0].TimeLimit, 60.0);
  EXPECT_EQ(study.Solvers[0].Options[0].second, StudyScalar(std::int64_t{ 1 }));
  EXPECT_EQ(study.Solvers[0].Options[1].second, StudyScalar(std::string("franke")));
  EXPECT_EQ(study.Solvers[1].Name, "other");
  EXPECT_EQ(study.Solvers[1].Options[0].second, StudyScalar(1e-10));
  EXPECT_EQ(study.Solvers[1].Options[1].second, StudyScalar(true));
  EXPECT_EQ(study.Solvers[1].Options[2].second, StudyScalar(2.0));
  EXPECT_FALSE(study.Solvers[1].TimeLimit);
  ASSERT_EQ(study.Plots.size(), 4u);
  EXPECT_EQ(study.Plots[0].Y.size(), 2u);
  EXPECT_EQ(study.Plots[0].Log, "xy");
  EXPECT_EQ(study.Plots[0].File, "line-MinAngle-vs-t.png");
  EXPECT_EQ(study.Plots[1].File, "s.svg");
  EXPECT_EQ(study.Plots[1].ColorBy, "t");
  EXPECT_EQ(study.Plots[2].Highlight, "both");
  EXPECT_EQ(study.Plots[2].Case, 0);
  EXPECT_EQ(study.Plots[3].Case, -2);
  EXPECT_EQ(study.Output.Formats, (std::vector<std::string>{ "vtp", "off" }));
}

TEST(StudyFile, DefaultsOfAShortStudy)
{
  const Study study = ParseStudy(
    R"({"pemesh": 1, "polygons": [{"family": "star"}], "plots": [{"kind": "line", "y": "Area"}]})",
    "my-study.json");
  EXPECT_EQ(study.Name, "my-study");
  EXPECT_EQ(study.Polygons[0].Parameters.at(0).second, 40) << "the family's own";
  EXPECT_EQ(study.Polygons[0].Scale, 1.0);
  EXPECT_EQ(study.Polygons[0].To, 1.0);
  const std::vector<double> times = TimesOf(study);
  ASSERT_EQ(times.size(), 20u);
  EXPECT_EQ(times.front(), 0.0);
  EXPECT_EQ(times[9], 9 * 0.9 / 19);
  EXPECT_EQ(times.back(), 0.9);
  EXPECT_EQ(study.Mesh.MinimumAngle, 20.0);
  EXPECT_EQ(study.Mesh.MaximumArea.Rule, "diagonal");
  EXPECT_FALSE(study.Mesh.PreservePolygons);
  EXPECT_EQ(study.Metrics, pemesh::StudyMetrics());
  EXPECT_TRUE(study.Solvers.empty());
  EXPECT_EQ(study.Plots[0].X, "t");
  EXPECT_EQ(study.Output.Formats, std::vector<std::string>{ "vtp" });
}

TEST(StudyFile, StudyOfMeshFiles)
{
  const Study one = ParseStudy(
    R"({"pemesh": 1, "meshes": "a/*.off", "plots": [{"kind": "line", "y": "Area"}]})", "s.json");
  EXPECT_TRUE(pemesh::HasMeshFiles(one));
  EXPECT_EQ(one.Meshes, std::vector<std::string>{ "a/*.off" });
  EXPECT_TRUE(one.Sweep.empty());
  EXPECT_TRUE(TimesOf(one).empty());
  EXPECT_EQ(one.Plots[0].X, "Index");
  const Study two = ParseStudy(R"({"pemesh": 1, "meshes": ["a.off", "b.obj"]})", "s.json");
  EXPECT_EQ(two.Meshes.size(), 2u);
  for (const Study& study : { one, two })
  {
    EXPECT_EQ(ParseStudy(FormatStudy(study), "s.json"), study);
  }
}

TEST(StudyFile, MetricsInLongAndShortForm)
{
  const auto MetricsOf = [](const std::string& metrics)
  {
    const Study study =
      ParseStudy(R"({"pemesh": 1, "polygons": [], "metrics": )" + metrics + "}", "s.json");
    EXPECT_EQ(ParseStudy(FormatStudy(study), "s.json"), study) << metrics;
    return study.Metrics;
  };
  EXPECT_EQ(MetricsOf(R"("all")"), pemesh::StudyMetrics());
  EXPECT_EQ(MetricsOf("{}"), pemesh::StudyMetrics());
  EXPECT_EQ(MetricsOf(R"(["Area"])"), MetricsOf(R"({"names": "Area"})"));
  EXPECT_TRUE(MetricsOf("[]").Names.empty()) << "nothing is measured";
  const pemesh::StudyMetrics full = MetricsOf(R"({"names": ["all", "jumps"], "mesh": ["MeshRho"],
    "statistics": ["area-mean"], "groups": ["all", "selected"], "quantiles": [0.05, 0.5],
    "histogram": 4, "selection": "MinAngle::0.5"})");
  const pemesh::StudyMetrics expected{ { "all", "jumps" }, { "MeshRho" }, { "area-mean" },
    { "all", "selected" }, { 0.05, 0.5 }, 4, "MinAngle::0.5" };
  EXPECT_EQ(full, expected);
}

TEST(StudyFile, BareSquareIsOneMesh)
{
  const Study study = ParseStudy(R"({"pemesh": 1, "polygons": []})", "s.json");
  EXPECT_TRUE(study.Sweep.empty());
  EXPECT_EQ(ParseStudy(FormatStudy(study), "s.json"), study);
}

TEST(StudyFile, MeshesFromAnySource)
{
  const Study koch = ParseStudy(
    R"({"pemesh": 1, "domain": {"shape": "disc"}, "mesh": {"source": "koch", "depth": 2, "tile": 3,
      "agglomerate": {"rule": "quality", "metric": "CircleRatio", "percentage": 12.5}}})",
    "s.json");
  EXPECT_EQ(koch.Mesh.Source, "koch");
  ASSERT_EQ(koch.Mesh.Parameters.size(), 3U) << "all of the source";
  EXPECT_EQ(koch.Mesh.Tile, (std::array<int, 2>{ 3, 3 }));
  EXPECT_EQ(koch.Mesh.Agglomeration.Percentage, 12.5);
  EXPECT_TRUE(koch.Sweep.empty());
  const Study files = ParseStudy(
    R"({"pemesh": 1, "meshes": "*.off", "mesh": {"mirror": 1, "agglomerate": {"rule": "metis"}}})",
    "s.json");
  EXPECT_EQ(files.Mesh.Mirror, 1);
  for (const Study& study : { koch, files })
  {
    EXPECT_EQ(ParseStudy(FormatStudy(study), "s.json"), study);
  }
}

TEST(StudyFile, ListsOfTimes)
{
  const Study study = ParseStudy(
    R"({"pemesh": 1, "polygons": [{"family": "zeta"}], "sweep": [{"values": [0.5, 0, 1]}]})",
    "s.json");
  EXPECT_EQ(TimesOf(study), (std::vector<double>{ 0.5, 0.0, 1.0 }));
  EXPECT_EQ(ParseStudy(FormatStudy(study), "s.json"), study);
  const Study still =
    ParseStudy(R"({"pemesh": 1, "polygons": [{"family": "zeta"}], "sweep": []})", "s.json");
  EXPECT_TRUE(still.Sweep.empty());
  EXPECT_EQ(ParseStudy(FormatStudy(still), "s.json"), still);
}

TEST(StudyFile, FormattingGivesBackTheStudy)
{
  const Study study = ParseStudy(FullStudy, "folder/full.json");
  const std::string text = FormatStudy(study);
  EXPECT_EQ(ParseStudy(text, "folder/other.json"), study);
  EXPECT_EQ(FormatStudy(ParseStudy(text, "folder/other.json")), text);
}

TEST(StudyFile, FormattingWritesEveryDefault)
{
  const Study study = ParseStudy(
    R"({"pemesh": 1, "polygons": [{"family": "comb"}, {"family": "n-sided"}]})", "s.json");
  EXPECT_EQ(FormatStudy(study), R"({
  "pemesh": 1,
  "name": "s",
  "domain": {"shape": "rectangle", "width": 1, "height": 1},
  "polygons": [
    {
      "family": "comb",
      "center": [0.5, 0.5],
      "scale": 1,
      "rotation": 0,
      "from": 0,
      "to": 1,
      "teeth": 10
    },
    {
      "family": "n-sided",
      "center": [0.5, 0.5],
      "scale": 1,
      "rotation": 0,
      "from": 0,
      "to": 1,
      "sides": 40
    }
  ],
  "sweep": [
    {
      "parameter": "t",
      "name": "t",
      "from": 0,
      "to": 0.9,
      "count": 20,
      "spacing": "linear",
      "zip": false
    }
  ],
  "mesh": {
    "source": "triangulation",
    "max-area": {"rule": "diagonal"},
    "min-angle": 20,
    "preserve-polygons": false,
    "preserve-domain": false,
    "gradation": 0,
    "size-at-polygons": 0,
    "target": {"quantity": "none"},
    "max-elements": 20000000,
    "mirror": 0,
    "tile": [1, 1],
    "agglomerate": {"rule": "none"}
  },
  "metrics": {
    "names": ["all"],
    "mesh": ["usual"],
    "statistics": ["min", "max", "mean"],
    "groups": ["all"],
    "quantiles": [],
    "histogram": 0
  },
  "solvers": [],
  "statistics": {
    "coefficient": "spearman",
    "given": [],
    "independent": false,
    "permutations": 999,
    "bootstrap": 0,
    "level": 0.95,
    "seed": 1
  },
  "plots": [],
  "output": {"formats": ["vtp"]}
}
)");
}

TEST(StudyFile, NumbersSurviveToTheLastBit)
{
  Study study = ParseStudy(R"({"pemesh": 1, "polygons": [{"family": "zeta"}]})", "s.json");
  for (const double value : { 0.1 + 0.2, 1e-300, 123456789.123456789, 1e300, 5e-324, 1e15, 1e16 })
  {
    study.Polygons[0].Scale = value;
    study.Polygons[0].Rotation = -value;
    EXPECT_EQ(ParseStudy(FormatStudy(study), "s.json"), study) << value;
  }
}

TEST(StudyFile, TextsSurvive)
{
  Study study = ParseStudy(R"({"pemesh": 1, "polygons": [{"family": "zeta"}]})", "s.json");
  for (const char* text : { "quote \" backslash \\ slash / tab \t line \n", "\xC3\xA9 \xE2\x82\xAC",
         "\x01", "{}", "null" })
  {
    study.Polygons[0].Name = text;
    EXPECT_EQ(ParseStudy(FormatStudy(study), "s.json"), study) << text;
  }
}

TEST(StudyFile, IgnoresTheLocale)
{
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : { "de_DE.UTF-8", "fr_FR.UTF-8", "C" })
  {
    std::setlocale(LC_ALL, name);
    const Study study = ParseStudy(FullStudy, "s.json");
    EXPECT_EQ(study.Polygons[0].Rotation, 15.5);
    EXPECT_EQ(ParseStudy(FormatStudy(study), "s.json"), study);
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST(StudyFile, RunsAreNamed)
{
  const auto names = [](const std::string& solvers)
  {
    std::string text;
    for (const auto& run :
      ParseStudy(R"({"pemesh": 1, "polygons": [], "solvers": [)" + solvers + "]}", "s.json")
        .Solvers)
    {
      text += run.Name + " ";
    }
    return text;
  };
  EXPECT_EQ(names(R"({"solver": "vem"})"), "vem ");
  EXPECT_EQ(names(R"({"solver": "vem", "order": 1}, {"solver": "vem", "order": 2},
    {"solver": "vem", "order": 3}, {"solver": "dg", "order": 2})"),
    "vem vem-k2 vem-k3 dg ");
  EXPECT_EQ(
    names(R"({"solver": "vem"}, {"solver": "vem"}, {"solver": "vem"})"), "vem vem-2 vem-3 ");
  EXPECT_EQ(names(R"({"solver": "vem"}, {"solver": "a/b.json", "name": "vem-2"},
    {"solver": "vem"})"),
    "vem vem-2 vem-3 ");
  EXPECT_EQ(names(R"({"solver": "x/my.json"}, {"solver": "vem", "name": "my"})"), "my-2 my ");
}

TEST(StudyFile, FiguresAreNamed)
{
  const Study study = ParseStudy(R"({"pemesh": 1, "polygons": [], "plots": [
    {"kind": "line", "y": "a_b"}, {"kind": "line", "y": "a_b"}, {"kind": "mesh"},
    {"kind": "mesh", "color-by": "x/y z", "file": "mesh"}, {"kind": "mesh", "file": "m.pdf"}]})",
    "s.json");
  std::vector<std::string> files;
  for (const pemesh::StudyPlot& plot : study.Plots)
  {
    files.push_back(plot.File);
  }
  EXPECT_EQ(files,
    (std::vector<std::string>{
      "line-a_b-vs-Index.png", "line-a_b-vs-Index-2.png", "mesh-2.png", "mesh.png", "m.pdf" }));
}

TEST(StudyFile, ReadsAFile)
{
  const std::filesystem::path folder = pemesh::TestFolder();
  pemesh::WriteTextFile(folder / "full.json", FullStudy);
  EXPECT_EQ(pemesh::ReadStudy(folder / "full.json"), ParseStudy(FullStudy, folder / "full.json"));
  pemesh::WriteTextFile(folder / "empty.json", "");
  EXPECT_NE(Complaint([&] { pemesh::ReadStudy(folder / "empty.json"); }).find("line 1, column 1"),
    std::string::npos);
  EXPECT_NE(Complaint([&] { pemesh::ReadStudy(folder / "none.json"); }).find("none.json"),
    std::string::npos);
  EXPECT_NE(Complaint([&] { pemesh::ReadStudy(folder); }).find("folder"), std::string::npos);
}

TEST(StudyFile, MovedStudyNamesTheSameFiles)
{
  Study study = ParseStudy(R"({"pemesh": 1, "meshes": ["m/*.off", "/abs/x.off"],
    "solvers": [{"solver": "s/mine.json"}, {"solver": "pemesh-vem"}]})",
    "/a/b/study.json");
  const Study moved = pemesh::MoveStudy(study, "/a/results/run");
  EXPECT_EQ(moved.Folder, "/a/results/run");
  EXPECT_EQ(moved.Meshes, (std::vector<std::string>{ "../../b/m/*.off", "/abs/x.off" }));
  EXPECT_EQ(moved.Solvers[0].Solver, "../../b/s/mine.json");
  EXPECT_EQ(moved.Solvers[1].Solver, "pemesh-vem");
  EXPECT_EQ(pemesh::MoveStudy(moved, "/a/b"), study);
}

TEST(StudyFile, RandomPolygonsFilesAndPoints)
{
  const Study study = ParseStudy(R"({"pemesh": 1, "polygons": [
    {"family": "random", "seed": 9007199254740991, "vertices": 30, "tangle": 1},
    {"family": "file", "file": "shapes/a.off", "center": [3, -4]},
    {"family": "points", "points": [[0.1, 0.1], [0.7, 0.2], [0.3, 0.9]]},
    {"family": "points", "points": [[0, 0], [3, 0], [0, 4]], "scale": 1}]})",
    "a/s.json");
  const std::vector<std::pair<std::string, double>> expected = { { "seed", 9007199254740991.0 },
    { "vertices", 30 }, { "irregularity", 0.5 }, { "spikiness", 0.5 }, { "tangle", 1 } };
  EXPECT_EQ(study.Polygons[0].Parameters, expected);
  EXPECT_EQ(study.Polygons[1].File, "shapes/a.off");
  EXPECT_EQ(study.Polygons[1].Center, (std::array<double, 2>{ 3.0, -4.0 }));
  EXPECT_NEAR(study.Polygons[2].Scale, 2.0, 1e-15) << "as it stands";
  EXPECT_NEAR(study.Polygons[2].Center[0], 0.4, 1e-15);
  EXPECT_EQ(study.Polygons[3].Scale, 1.0);
  EXPECT_EQ(study.Polygons[3].Center, (std::array<double, 2>{ 1.5, 2.0 }));
  EXPECT_EQ(ParseStudy(FormatStudy(study), "a/s.json"), study);
  const Study moved = pemesh::MoveStudy(study, "b");
  EXPECT_EQ(moved.Polygons[1].File, "../a/shapes/a.off");
  EXPECT_EQ(moved.Polygons[0].File, "");
}

TEST(StudyFile, ScatteredPolygons)
{
  const Study study = ParseStudy(
    R"({"pemesh": 1, "scatter": {"count": 30, "seed": 7, "families": "comb"}})", "s.json");
  ASSERT_TRUE(study.Scatter);
  EXPECT_EQ(study.Scatter->Count, 30);
  EXPECT_EQ(study.Scatter->Families, std::vector<std::string>{ "comb" });
  EXPECT_EQ(study.Scatter->Gap, 0.01);
  EXPECT_EQ(TimesOf(study).size(), 20u) << "they deform";
  EXPECT_EQ(ParseStudy(FormatStudy(study), "s.json"), study);
  const Study all = ParseStudy(
    R"({"pemesh": 1, "polygons": [], "scatter": {"order": "random", "smallest-scale": 0.1,
      "largest-scale": 0.3, "largest-rotation": 0, "gap": 0, "from": 0.5, "to": 0.25}})",
    "s.json");
  EXPECT_EQ(ParseStudy(FormatStudy(all), "s.json"), all);
}

TEST(StudyFile, PolygonsFromATable)
{
  const std::filesystem::path folder = pemesh::TestFolder();
  pemesh::WriteTextFile(folder / "sub/p.csv", "family,file,scale\nfile,a.off,0.3\nmaze,,\n");
  const Study study = ParseStudy(R"({"pemesh": 1, "polygons": "sub/p.csv"})", folder / "s.json");
  ASSERT_EQ(study.Polygons.size(), 2u);
  EXPECT_EQ(study.Polygons[0].File, "sub/a.off") << "relative to the study";
  EXPECT_EQ(study.Polygons[0].Scale, 0.3);
  EXPECT_NE(FormatStudy(study).find("\"family\": \"maze\""), std::string::npos) << "as a list";
  EXPECT_EQ(ParseStudy(FormatStudy(study), folder / "s.json"), study);
  EXPECT_NE(Complaint([&] { ParseStudy(R"({"pemesh": 1, "polygons": "no.csv"})", "s.json"); })
              .find("polygons names a table that cannot be read: "),
    std::string::npos);
}

TEST(StudyFile, EveryKeyIsExplained)
{
  const std::string text = pemesh::DescribeStudyKeys();
  for (const char* line :
    { "\npolygons[].teeth: integer between 1 and 100000, default 10. Extra teeth at t = 1.",
      "\npolygons[].spikes", "\nmesh.min-angle: number between 0 and 33, default 20.",
      "\nmesh.max-area.rule: one of none, shortest-edge, diagonal, constant, default \"diagonal\"",
      "\nsweep[].count: integer between 1 and 10000000, default 20.",
      "\nplots[].log: ", "\nsolvers[].solver: text, required.", "\noutput.formats: " })
  {
    EXPECT_NE(text.find(line), std::string::npos) << line;
  }
}

TEST(StudyFile, TheReadmeListsTheKeys)
{
  const std::string readme =
    pemesh::ReadTextFile(std::string(PEMESH_SOURCE_DIR) + "/IO/Study/README.md");
  EXPECT_NE(readme.find(pemesh::DescribeStudyKeys()), std::string::npos)
    << "put this into IO/Study/README.md:\n"
    << pemesh::DescribeStudyKeys();
}

} // namespace
