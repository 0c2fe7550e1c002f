// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ProgramRun.h"
#include "vtkPEMRunner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <vtkNew.h>
#include <vtkTable.h>
#include <vtkVariant.h>

namespace fs = std::filesystem;
using pemesh::TestFolder;
using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

/** The study run into a folder of its own. */
struct StudyRun
{
  explicit StudyRun(const std::string& keys, int workers = 2)
  {
    static int number = 0;
    this->Folder = TestFolder("sweep-" + std::to_string(number++));
    this->Runner->SetStudyText(
      R"({"pemesh": 1, "name": "s", )" + keys + "}", this->Folder.string());
    this->Runner->SetOutputDirectory(this->Folder / "out");
    this->Runner->SetNumberOfWorkers(workers);
    this->Done = this->Runner->Run();
  }

  std::vector<double> Numbers(const char* column) const
  {
    std::vector<double> numbers;
    vtkTable* table = this->Runner->GetResults();
    for (vtkIdType row = 0; table && row < table->GetNumberOfRows(); ++row)
    {
      numbers.push_back(table->GetValueByName(row, column).ToDouble());
    }
    return numbers;
  }

  std::vector<std::string> Texts(const char* column) const
  {
    std::vector<std::string> texts;
    vtkTable* table = this->Runner->GetResults();
    for (vtkIdType row = 0; table && row < table->GetNumberOfRows(); ++row)
    {
      texts.push_back(table->GetValueByName(row, column).ToString());
    }
    return texts;
  }

  std::string Messages() const { return testing::PrintToString(this->Runner->GetMessages()); }

  fs::path Folder;
  vtkNew<vtkPEMRunner> Runner;
  bool Done = false;
};

} // namespace

TEST(StudySweepRuns, EverySweptValueIsAColumn)
{
  const StudyRun run(R"("polygons": [{"family": "zeta"}], "metrics": [],
    "sweep": [{"values": [0.25, 0.5]}, {"parameter": "mesh.max-area.rule", "values": ["none", "diagonal"]},
      {"parameter": "polygons[*].scale", "values": [1, 0.5], "zip": true}])");
  ASSERT_TRUE(run.Done) << run.Messages();
  EXPECT_THAT(run.Numbers("t"), ElementsAre(0.25, 0.25, 0.5, 0.5));
  EXPECT_THAT(run.Texts("rule"), ElementsAre("none", "diagonal", "none", "diagonal"));
  EXPECT_THAT(run.Numbers("scale"), ElementsAre(1.0, 0.5, 1.0, 0.5));
  EXPECT_TRUE(fs::exists(run.Folder / "out" / "meshes" / "003_0.500000.vtp"));
}

TEST(StudySweepRuns, ASweepIsWhatSeparateStudiesAre)
{
  const std::string keys = R"("polygons": [{"family": "comb", "scale": 0.8}],
    "solvers": [{"solver": "pemesh-vem", "problem": "linear"}], "metrics": ["MinAngle"], )";
  const StudyRun swept(keys + R"("sweep": [{"values": [0.5]},
    {"parameter": "mesh.min-angle", "values": [0, 30]},
    {"parameter": "solvers[0].problem", "values": ["linear", "franke"]}])");
  ASSERT_TRUE(swept.Done) << swept.Messages();
  int row = 0;
  for (const char* angle : { "0", "30" })
  {
    for (const char* problem : { "linear", "franke" })
    {
      vtkNew<vtkPEMRunner> one;
      one->SetStudyText(
        R"({"pemesh": 1, "name": "one", )" + keys + R"("sweep": [{"values": [0.5]}]})",
        swept.Folder.string());
      one->AddSetting(std::string("mesh.min-angle=") + angle);
      one->AddSetting(std::string("solvers[0].problem=") + problem);
      one->SetOutputDirectory(swept.Folder / "one" / (std::string(angle) + problem));
      ASSERT_TRUE(one->Run()) << testing::PrintToString(one->GetMessages());
      for (const char* column : { "Elements", "MinAngle_min", "pemesh-vem_condition-number",
             "pemesh-vem_relative-error-l2" })
      {
        EXPECT_EQ(one->GetResults()->GetValueByName(0, column).ToDouble(),
          swept.Runner->GetResults()->GetValueByName(row, column).ToDouble())
          << column << " of row " << row;
      }
      ++row;
    }
  }
}

TEST(StudySweepRuns, TheNumberOfUnknownsCanBeHeld)
{
  const StudyRun run(R"("polygons": [{"family": "maze"}], "metrics": [],
    "sweep": [{"values": [0, 0.45, 0.9]}],
    "solvers": [{"solver": "pemesh-vem", "problem": "linear"}],
    "mesh": {"target": {"quantity": "dofs", "value": 700}})");
  ASSERT_TRUE(run.Done) << run.Messages();
  for (const double dofs : run.Numbers("pemesh-vem_dofs")) // counted by the solver
  {
    EXPECT_NEAR(dofs, 700, 14);
  }
}

TEST(StudySweepRuns, TheTargetCountsTheFinalMesh)
{
  const StudyRun run(R"("polygons": [{"family": "zeta", "scale": 0.5}], "metrics": [],
    "sweep": [{"values": [0.5]}, {"parameter": "mesh.mirror", "values": [0, 1, 2]}],
    "mesh": {"target": {"quantity": "elements", "value": 4000}})");
  ASSERT_TRUE(run.Done) << run.Messages();
  for (const double elements : run.Numbers("Elements"))
  {
    EXPECT_NEAR(elements, 4000, 80);
  }
}

TEST(StudySweepRuns, ATargetOutOfReachIsTheFailureOfItsCase)
{
  const StudyRun run(R"("polygons": [{"family": "star"}], "metrics": [],
    "sweep": [{"values": [0.9]}, {"parameter": "mesh.target.value", "values": [20, 2000]}],
    "mesh": {"target": {"quantity": "elements", "value": 1}})");
  EXPECT_FALSE(run.Done);
  EXPECT_THAT(run.Texts("Status"), ElementsAre("target-not-reached", "ok"));
  EXPECT_THAT(run.Messages(), HasSubstr("cannot have 20 elements within 2 %; the least is"));
  EXPECT_EQ(run.Numbers("Elements").at(0), 0.0);
  EXPECT_THAT(run.Numbers("value"), ElementsAre(20, 2000));
}

TEST(StudySweepRuns, PolygonsThatFindNoRoomFailTheirCaseAlone)
{
  const StudyRun run(R"("scatter": {"families": ["n-sided"], "smallest-scale": 0.3,
    "largest-scale": 0.3}, "metrics": [],
    "sweep": [{"values": [0.5]}, {"parameter": "scatter.count", "values": [4, 4000, 5]}])",
    1);
  EXPECT_FALSE(run.Done);
  EXPECT_THAT(run.Texts("Status"), ElementsAre("ok", "invalid-layout", "ok"));
  EXPECT_THAT(run.Numbers("count"), ElementsAre(4, 4000, 5));
}

TEST(StudySweepRuns, TilingKeepsTheAreaAndMultipliesTheElements)
{
  const StudyRun run(R"("polygons": [{"family": "u-like"}], "metrics": ["Area"],
    "sweep": [{"values": [0.5]}, {"parameter": "mesh.tile", "values": [1, 2, 3]}])");
  ASSERT_TRUE(run.Done) << run.Messages();
  const std::vector<double> elements = run.Numbers("Elements");
  const std::vector<double> means = run.Numbers("Area_mean");
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(elements[i], (i + 1) * (i + 1) * elements[0]);
    EXPECT_NEAR(means[i] * elements[i], 1.0, 1e-12);
  }
}

TEST(StudySweepRuns, SourcesAndRulesCanBeSwept)
{
  const StudyRun run(R"("mesh": {"source": "voronoi", "agglomerate": {"rule": "none"}},
    "metrics": ["Area"], "domain": {"shape": "l-shape"},
    "sweep": [{"parameter": "mesh.source", "values": ["voronoi", "koch", "hexagons"]},
      {"parameter": "mesh.agglomerate.rule", "values": ["none", "metis"]}])");
  ASSERT_TRUE(run.Done) << run.Messages();
  EXPECT_THAT(
    run.Texts("source"), ElementsAre("voronoi", "voronoi", "koch", "koch", "hexagons", "hexagons"));
  const std::vector<double> elements = run.Numbers("Elements");
  const std::vector<double> means = run.Numbers("Area_mean");
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    EXPECT_NEAR(means[i] * elements[i], 0.75, 1e-12);
  }
  EXPECT_LT(elements[1], 0.3 * elements[0]);
}

TEST(StudySweepRuns, MeshFilesCanBeAgglomeratedAndSweepTheSolver)
{
  const StudyRun run(
    R"("meshes": ")" + std::string(PEMESH_SOURCE_DIR) + R"(/Data/Meshes/wave-[01].off",
    "metrics": []})");
  EXPECT_FALSE(run.Done) << "brackets are no pattern";
  const StudyRun good(R"("meshes": [")" + std::string(PEMESH_SOURCE_DIR) +
    R"(/Data/Meshes/wave-0.off", ")" + std::string(PEMESH_SOURCE_DIR) +
    R"(/Data/Meshes/wave-7.off"], "metrics": [], "mesh": {"agglomerate": {"rule": "random"}},
    "sweep": [{"parameter": "mesh.agglomerate.elements", "values": [90, 30]}])");
  ASSERT_TRUE(good.Done) << good.Messages();
  EXPECT_THAT(good.Numbers("Elements"), ElementsAre(90, 30, 90, 30));
  EXPECT_THAT(
    good.Texts("Mesh"), ElementsAre("wave-0_000", "wave-0_001", "wave-7_000", "wave-7_001"));
}

TEST(StudySweepRuns, AreTheSameForAnyNumberOfWorkers)
{
  const std::string keys = R"("scatter": {"count": 5, "seed": 3}, "metrics": ["MinAngle"],
    "sweep": [{"values": [0.2, 0.7]}, {"parameter": "scatter.seed", "values": [1, 2, 3]},
      {"parameter": "mesh.agglomerate.rule", "values": ["none", "metis"]}])";
  const StudyRun one(keys, 1);
  const StudyRun two(keys, 2);
  ASSERT_TRUE(one.Done && two.Done) << one.Messages() << two.Messages();
  EXPECT_EQ(pemesh::FileText(one.Folder / "out" / "results.csv"),
    pemesh::FileText(two.Folder / "out" / "results.csv"));
  EXPECT_EQ(pemesh::FileText(one.Folder / "out" / "meshes" / "011_0.700000.vtp"),
    pemesh::FileText(two.Folder / "out" / "meshes" / "011_0.700000.vtp"));
}
