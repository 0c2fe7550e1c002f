// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The generation as a whole: studies drawn at random are run, every mesh is judged, and what cannot
 * be meshed must be refused by name. PEMESH_RANDOM_STUDIES says how many studies, in parts of
 * PEMESH_RANDOM_PART, each a test of its own.
 */
#include "CsvTable.h"
#include "MeshFormats.h"
#include "ProgramRun.h"
#include "RandomStudy.h"
#include "StudyFile.h"
#include "StudyJudge.h"
#include "StudySweeps.h"
#include "TimedRun.h"
#include "vtkPEMRunner.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

namespace fs = std::filesystem;
using pemesh::FileText;
using pemesh::TestFolder;

namespace
{

/** The name of every file of a folder, and its bytes. */
/** Of all but what depends on the machine: times, and the order in which cases were done. */
std::map<std::string, std::string> BytesOf(const fs::path& folder)
{
  std::map<std::string, std::string> bytes;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    if (entry.is_regular_file() && entry.path().filename() != "timings.csv" &&
      entry.path().filename() != "journal.tsv")
    {
      bytes[entry.path().filename()] = FileText(entry.path());
    }
  }
  return bytes;
}

/** The meshes of a study are good, or refused by the name of the culprit. */
class StudyRun
{
public:
  StudyRun(std::uint64_t seed, const fs::path& folder, int workers)
    : Document(DrawStudy(seed).dump())
    , Output(folder)
  {
    this->Runner->SetStudyText(this->Document, folder.parent_path().string());
    this->Runner->SetOutputDirectory(folder.string());
    this->Runner->SetNumberOfWorkers(workers);
    this->Runner->SetMeshesOnly(true);
    this->IsInTime = RunInTime(this->Runner, this->Document);
  }

  void Judge()
  {
    SCOPED_TRACE(this->Document);
    ASSERT_TRUE(this->IsInTime) << "the study takes too long";
    const auto messages = this->Runner->GetMessages();
    ASSERT_FALSE(this->Runner->GetRefused()) << testing::PrintToString(messages);
    const pemesh::Study study =
      pemesh::ParseStudy(this->Document, this->Output.parent_path() / "study.json");
    const auto cases = pemesh::SweepCases(study);
    ASSERT_EQ(this->Runner->GetNumberOfCases(), static_cast<int>(cases.size()));
    if (fs::exists(this->Output / "failures.csv"))
    {
      this->JudgeFailures(pemesh::ReadCsvFile(this->Output / "failures.csv"));
    }
    int meshes = 0;
    for (const auto& entry : fs::directory_iterator(this->Output))
    {
      const std::string name = entry.path().stem().string();
      if (entry.path().extension() == ".vtp" && !this->Failed.count(name))
      {
        const auto& values = cases.at(std::stoul(name)); // names begin with the number of the case
        const auto mesh = pemesh::ReadMesh(entry.path(), pemesh::ElementOrientation::AsStored);
        EXPECT_EQ(
          WhyBad(mesh, pemesh::MakeStudyOfCase(study, values), pemesh::DeformationOf(values)), "")
          << name;
        ++meshes;
      }
    }
    EXPECT_EQ(static_cast<std::size_t>(meshes) + this->Failed.size(), cases.size())
      << "every case is a mesh or a failure";
    this->ShareOfMeshes = meshes / static_cast<double>(cases.size());
  }

  double GetShareOfMeshes() const { return this->ShareOfMeshes; }

private:
  void JudgeFailures(vtkTable* table)
  {
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      const std::string status = table->GetValueByName(row, "Status").ToString();
      const std::string sentence = table->GetValueByName(row, "Message").ToString();
      this->Failed.insert(table->GetValueByName(row, "Mesh").ToString());
      EXPECT_EQ(WhyBadRefusal(status, sentence), "");
    }
  }

  std::string Document;
  fs::path Output;
  vtkNew<vtkPEMRunner> Runner;
  bool IsInTime = false;
  std::set<std::string> Failed;
  double ShareOfMeshes = 0.0;
};

class RandomStudies : public testing::TestWithParam<int>
{
};

} // namespace

TEST_P(RandomStudies, AreMeshedOrRefusedByName)
{
  const fs::path folder = TestFolder("random-studies-" + std::to_string(GetParam()));
  WriteDrawnFiles(folder);
  double meshes = 0.0;
  for (int i = 0; i < PEMESH_RANDOM_PART; ++i)
  {
    const auto seed = static_cast<std::uint64_t>(GetParam() * PEMESH_RANDOM_PART + i);
    SCOPED_TRACE(seed);
    const fs::path one = folder / (std::to_string(seed) + "-1");
    StudyRun study(seed, one, 1);
    study.Judge();
    meshes += study.GetShareOfMeshes();
    if (i % 5 == 0)
    {
      const fs::path two = folder / (std::to_string(seed) + "-2");
      const StudyRun again(seed, two, 2);
      EXPECT_TRUE(BytesOf(one) == BytesOf(two)) << "one and two workers give other files";
    }
    if (!HasFailure()) // else leaves the files
    {
      fs::remove_all(one);
    }
  }
  EXPECT_GE(meshes, 0.4 * PEMESH_RANDOM_PART) << "enough studies can be meshed";
}

INSTANTIATE_TEST_SUITE_P(
  Seeds, RandomStudies, testing::Range(0, PEMESH_RANDOM_STUDIES / PEMESH_RANDOM_PART));
