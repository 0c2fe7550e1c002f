// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyFile.h"

#include "StudyTexts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace
{

using pemesh::ApplySetting;

pemesh::Study With(const std::string& setting)
{
  return pemesh::ParseStudy(ApplySetting(FullStudy, setting), "s.json");
}

TEST(StudySettings, ChangeOneValue)
{
  EXPECT_EQ(With("mesh.min-angle=12.5").Mesh.MinimumAngle, 12.5);
  EXPECT_EQ(With("polygons.0.scale=0.5").Polygons[0].Scale, 0.5);
  EXPECT_EQ(With("polygons[0].scale=0.5").Polygons[0].Scale, 0.5);
  EXPECT_EQ(With("polygons[1].center[0]=0.6").Polygons[1].Center[0], 0.6);
  EXPECT_EQ(With("polygons.1.center=[0.6, 0.5]").Polygons[1].Center[1], 0.5);
  EXPECT_EQ(With("name=other study").Name, "other study");
  EXPECT_EQ(With("name=\"quoted\"").Name, "quoted");
  EXPECT_EQ(With("mesh.preserve-polygons=false").Mesh.PreservePolygons, false);
  EXPECT_EQ(With("solvers.0.problem=a=b").Solvers[0].Options[1].second,
    pemesh::StudyScalar(std::string("a=b")));
  EXPECT_EQ(With("output={\"formats\": []}").Output.Formats.size(), 0u);
}

TEST(StudySettings, OfMetricsWriteOutTheShortForm)
{
  const pemesh::StudyMetrics metrics = With("metrics.quantiles=[0.05, 0.95]").Metrics;
  EXPECT_EQ(metrics.Names, (std::vector<std::string>{ "MinAngle", "Area" }));
  EXPECT_EQ(metrics.Quantiles, (std::vector<double>{ 0.05, 0.95 }));
  EXPECT_EQ(With("metrics.quantiles=0.5").Metrics.Quantiles, std::vector<double>{ 0.5 });
  EXPECT_EQ(With("metrics=all").Metrics, pemesh::StudyMetrics());
  EXPECT_EQ(With("metrics[0]=Diameter").Metrics.Names.front(), "Diameter");
  const std::string groups = ApplySetting(FullStudy, "metrics.groups=[\"all\", \"selected\"]");
  const std::string both = ApplySetting(groups, "metrics.selection=MinAngle::0.5");
  EXPECT_EQ(pemesh::ParseStudy(both, "s.json").Metrics.Selection, "MinAngle::0.5");
  const char* bare = R"({"pemesh": 1, "polygons": []})";
  EXPECT_EQ(pemesh::ParseStudy(ApplySetting(bare, "metrics.histogram=4"), "s.json").Metrics.Names,
    std::vector<std::string>{ "all" });
}

TEST(StudySettings, OfTheStatistics)
{
  EXPECT_EQ(
    With("statistics.given=MeshSize").Statistics.Given, (std::vector<std::string>{ "MeshSize" }));
  const pemesh::Study study = With(R"(statistics={"family": "family", "coefficient": "distance",
    "bootstrap": 500, "permutations": 99, "seed": 7, "level": 0.9, "independent": true})");
  EXPECT_EQ(study.Statistics.Family, "family");
  EXPECT_EQ(study.Statistics.Coefficient, "distance");
  EXPECT_EQ(study.Statistics.Bootstrap, 500);
  EXPECT_EQ(study.Statistics.Permutations, 99);
  EXPECT_EQ(study.Statistics.Seed, 7);
  EXPECT_EQ(study.Statistics.Level, 0.9);
  EXPECT_TRUE(study.Statistics.IndependentRows);
  EXPECT_EQ(pemesh::ParseStudy(pemesh::FormatStudy(study), "s.json"), study);
  for (const char* wrong : { "statistics.coefficient=spaerman", "statistics.level=1",
         "statistics.permutations=0", "statistics.bootstraps=3" })
  {
    EXPECT_THAT(Complaint([&] { With(wrong); }), testing::HasSubstr("statistics")) << wrong;
  }
}

TEST(StudySettings, LeaveTheRestAlone)
{
  pemesh::Study expected = pemesh::ParseStudy(FullStudy, "s.json");
  expected.Mesh.MinimumAngle = 12.5;
  EXPECT_EQ(With("mesh.min-angle=12.5"), expected);
}

TEST(StudySettings, MakeWhatIsMissing)
{
  const char* text = R"({"pemesh": 1, "polygons": []})";
  const std::string changed =
    ApplySetting(ApplySetting(text, "mesh.max-area.rule=constant"), "mesh.max-area.value=0.25");
  EXPECT_EQ(pemesh::ParseStudy(changed, "s.json").Mesh.MaximumArea.Value, 0.25);
}

TEST(StudySettings, AreCheckedWithTheStudy)
{
  EXPECT_EQ(Complaint([] { With("mesh.min-angel=25"); }),
    "\"s.json\": mesh.min-angel is not a key; did you mean min-angle?");
  EXPECT_EQ(Complaint([] { With("mesh.min-angle=steep"); }),
    "\"s.json\": mesh.min-angle is \"steep\" where a number is expected.");
  EXPECT_EQ(Complaint([] { With("mesh.min-angle="); }),
    "\"s.json\": mesh.min-angle is \"\" where a number is expected.");
}

TEST(StudySettings, Messages)
{
  for (const char* setting : { "mesh.min-angle", "=5", "" })
  {
    EXPECT_THAT(Complaint([&] { ApplySetting(FullStudy, setting); }),
      testing::HasSubstr("is not PATH=VALUE"));
  }
  for (const char* setting : { "mesh..min-angle=5", ".=5", "polygons[].scale=5", "mesh.=5" })
  {
    EXPECT_THAT(Complaint([&] { ApplySetting(FullStudy, setting); }),
      testing::HasSubstr("has no proper path"));
  }
  EXPECT_EQ(Complaint([&] { ApplySetting(FullStudy, "polygons.3.scale=1"); }),
    "The setting \"polygons.3.scale=1\" names item \"3\" of a list of 3: items count from 0.");
  EXPECT_THAT(Complaint([&] { ApplySetting(FullStudy, "polygons.-1.scale=1"); }),
    testing::HasSubstr("names item \"-1\""));
  EXPECT_THAT(Complaint([&] { ApplySetting(FullStudy, "polygons.first.scale=1"); }),
    testing::HasSubstr("names item \"first\""));
  EXPECT_EQ(Complaint([&] { ApplySetting(FullStudy, "name.x=1"); }),
    "The setting \"name.x=1\" looks for \"x\" in \"comb and star\", which has no members.");
  EXPECT_THAT(
    Complaint([&] { ApplySetting("{", "name=1"); }), testing::HasSubstr("line 1, column 2"));
}

} // namespace
