// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The ends of all families, where polygons degenerate, and elements that are thinner than anything
 * a family makes, through the whole pipeline.
 */
#include "CsvTable.h"
#include "MeshFormats.h"
#include "PolygonFamilies.h"
#include "ProgramRun.h"
#include "StudyFile.h"
#include "StudyJudge.h"
#include "StudySweeps.h"
#include "TimedRun.h"
#include "vtkPEMRunner.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

namespace fs = std::filesystem;

namespace
{

using Json = nlohmann::ordered_json;

/** Runs a study with all metrics; every mesh must be good, or refused by the name of a polygon. */
int JudgeStudy(const Json& document, const std::string& name)
{
  const fs::path folder = pemesh::TestFolder(name);
  const std::string text = document.dump();
  vtkNew<vtkPEMRunner> runner;
  runner->SetStudyText(text, folder.string());
  runner->SetOutputDirectory((folder / "results").string());
  runner->SetNumberOfWorkers(1);
  EXPECT_TRUE(RunInTime(runner, text));
  EXPECT_FALSE(runner->GetRefused()) << testing::PrintToString(runner->GetMessages());
  const fs::path failures = folder / "results" / "failures.csv";
  if (fs::exists(failures))
  {
    const auto table = pemesh::ReadCsvFile(failures);
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      EXPECT_EQ(WhyBadRefusal(table->GetValueByName(row, "Status").ToString(),
                  table->GetValueByName(row, "Message").ToString()),
        "");
    }
  }
  const pemesh::Study study = pemesh::ParseStudy(text, folder / "study.json");
  int meshes = 0;
  for (const auto& values : pemesh::SweepCases(study))
  {
    const std::string number = "00" + std::to_string(meshes);
    for (const auto& entry : fs::directory_iterator(folder / "results" / "meshes"))
    {
      if (entry.path().filename().string().rfind(number, 0) == 0)
      {
        const auto mesh = pemesh::ReadMesh(entry.path(), pemesh::ElementOrientation::AsStored);
        EXPECT_EQ(
          WhyBad(mesh, pemesh::MakeStudyOfCase(study, values), pemesh::DeformationOf(values)), "")
          << entry.path();
      }
    }
    ++meshes;
  }
  const int made = meshes - runner->GetNumberOfFailures();
  fs::remove_all(folder);
  return made;
}

std::vector<const char*> DeformedFamilies()
{
  std::vector<const char*> names;
  for (const pemesh::PolygonFamily& family : pemesh::PolygonFamilies())
  {
    if (!family.IsFixed())
    {
      names.push_back(family.Name);
    }
  }
  return names;
}

class Ends : public testing::TestWithParam<std::tuple<const char*, bool>>
{
};

class ThinPolygon : public testing::TestWithParam<const char*>
{
};

/** Letters and digits, as names of tests must be. */
std::string TestName(std::string name)
{
  std::erase_if(name, [](unsigned char letter) { return !std::isalnum(letter); });
  return name;
}

} // namespace

TEST_P(Ends, AreMeshedThroughTheWholePipeline)
{
  const auto [family, isPreserved] = GetParam();
  const Json study = { { "pemesh", 1 }, { "name", "ends" },
    { "polygons", { { { "family", family }, { "name", "piece-0" }, { "rotation", 17.0 } } } },
    { "sweep", { { { "parameter", "t" }, { "values", { 0, 1 } } } } },
    { "mesh", { { "preserve-polygons", isPreserved } } } };
  const std::string name = TestName(family) + (isPreserved ? "Preserved" : "Split");
  EXPECT_EQ(JudgeStudy(study, "ends-" + name), 2) << "none needs to be refused";
}

INSTANTIATE_TEST_SUITE_P(Families, Ends,
  testing::Combine(testing::ValuesIn(DeformedFamilies()), testing::Bool()),
  [](const auto& test) {
    return TestName(std::get<0>(test.param)) + (std::get<1>(test.param) ? "Preserved" : "Split");
  });

/** A rectangle of 0.4 times 1e-9, turned or not, keeps its area whatever follows. */
TEST_P(ThinPolygon, KeepsItsArea)
{
  Json study = { { "pemesh", 1 }, { "name", "thin" },
    { "polygons",
      { { { "family", "points" }, { "name", "piece-0" },
        { "points",
          { { 0.3, 0.45 }, { 0.7, 0.45 }, { 0.7, 0.450000001 }, { 0.3, 0.450000001 } } } } } },
    { "sweep",
      { { { "parameter", "mesh.preserve-polygons" }, { "values", { false, true } } },
        { { "parameter", "polygons[0].rotation" }, { "values", { 0, 30 } } } } } };
  study["mesh"] = Json::parse(GetParam());
  EXPECT_EQ(JudgeStudy(study, "thin"), 4);
}

INSTANTIATE_TEST_SUITE_P(Pipelines, ThinPolygon,
  testing::Values(R"({})", R"({ "mirror": 2 })", R"({ "tile": [3, 2] })",
    R"({ "agglomerate": { "rule": "random", "straight-vertices": "remove-rounded" } })",
    R"({ "mirror": 1, "tile": 3, "agglomerate": { "rule": "regular" } })"));
