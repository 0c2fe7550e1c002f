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
#include "vtkPEMMeshCheck.h"
#include "vtkPEMRunner.h"

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <map>

#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

namespace fs = std::filesystem;
using pemesh::FileText;
using pemesh::FreshFolder;

namespace
{

using Json = nlohmann::ordered_json;
using Rational = CGAL::Exact_rational;

/** The name of every file of a folder, and its bytes. */
std::map<std::string, std::string> BytesOf(const fs::path& folder)
{
  std::map<std::string, std::string> bytes;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    if (entry.is_regular_file() && entry.path().filename() != "timings.csv")
    {
      bytes[entry.path().filename()] = FileText(entry.path());
    }
  }
  return bytes;
}

/** Twice the sum of the areas of all elements, without rounding. */
Rational ExactDoubleArea(vtkPolyData* mesh)
{
  Rational sum = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      double a[3];
      double b[3];
      mesh->GetPoint(ids->GetId(i), a);
      mesh->GetPoint(ids->GetId((i + 1) % ids->GetNumberOfIds()), b);
      sum += Rational(a[0]) * Rational(b[1]) - Rational(b[0]) * Rational(a[1]);
    }
  }
  return sum;
}

/** Empty, or what is wrong with the mesh of a file. */
std::string WhyBad(const fs::path& file)
{
  const auto mesh = pemesh::ReadMesh(file, pemesh::ElementOrientation::AsStored);
  if (mesh->GetNumberOfCells() == 0)
  {
    return "no elements";
  }
  vtkNew<vtkPEMMeshCheck> check;
  check->SetInputData(0, mesh);
  check->Update();
  auto* table = vtkTable::SafeDownCast(check->GetOutputDataObject(2));
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const std::string name = table->GetValueByName(row, "Check").ToString();
    // A mesher leaves neither holes nor unused points; thin and short it may be asked for.
    if (name != "slivers" && name != "near-vertices")
    {
      return table->GetValueByName(row, "Message").ToString();
    }
  }
  return ExactDoubleArea(mesh) == 2 ? "" : "the areas do not add up to exactly 1";
}

/** The meshes of a study are good, or refused by the name of a polygon. */
class StudyRun
{
public:
  StudyRun(std::uint64_t seed, const fs::path& folder, int workers)
    : Document(DrawStudy(seed))
    , Output(folder)
  {
    this->Runner->SetStudyText(this->Document.dump(), folder.parent_path().string());
    this->Runner->SetOutputDirectory(folder.string());
    this->Runner->SetNumberOfWorkers(workers);
    this->Runner->SetMeshesOnly(true);
    this->Runner->Run();
  }

  void Judge()
  {
    SCOPED_TRACE(this->Document.dump());
    const auto messages = this->Runner->GetMessages();
    ASSERT_FALSE(this->Runner->GetRefused()) << testing::PrintToString(messages);
    ASSERT_EQ(this->Runner->GetNumberOfCases(), 2);
    const fs::path failures = this->Output / "failures.csv";
    if (fs::exists(failures))
    {
      this->JudgeFailures(pemesh::ReadCsvFile(failures));
    }
    for (const auto& entry : fs::directory_iterator(this->Output))
    {
      const std::string name = entry.path().stem().string();
      if (entry.path().extension() == ".vtp" && !this->Failed.count(name))
      {
        EXPECT_EQ(WhyBad(entry.path()), "") << name;
        ++this->Meshes;
      }
    }
    EXPECT_EQ(this->Meshes + static_cast<int>(this->Failed.size()), 2)
      << "every case is a mesh or a failure";
  }

  int GetNumberOfMeshes() const { return this->Meshes; }

private:
  void JudgeFailures(vtkTable* table)
  {
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      const std::string status = table->GetValueByName(row, "Status").ToString();
      const std::string sentence = table->GetValueByName(row, "Message").ToString();
      this->Failed[table->GetValueByName(row, "Mesh").ToString()] = status;
      EXPECT_EQ(status, "invalid-layout") << sentence;
      EXPECT_NE(sentence.find("piece-"), std::string::npos) << sentence;
      EXPECT_EQ(sentence.back(), '.') << sentence;
    }
  }

  Json Document;
  fs::path Output;
  vtkNew<vtkPEMRunner> Runner;
  std::map<std::string, std::string> Failed;
  int Meshes = 0;
};

class RandomStudies : public testing::TestWithParam<int>
{
};

} // namespace

TEST_P(RandomStudies, AreMeshedOrRefusedByName)
{
  const fs::path folder = FreshFolder("random-studies-" + std::to_string(GetParam()));
  int meshes = 0;
  for (int i = 0; i < PEMESH_RANDOM_PART; ++i)
  {
    const auto seed = static_cast<std::uint64_t>(GetParam() * PEMESH_RANDOM_PART + i);
    SCOPED_TRACE(seed);
    const fs::path one = folder / (std::to_string(seed) + "-1");
    StudyRun study(seed, one, 1);
    study.Judge();
    meshes += study.GetNumberOfMeshes();
    if (i % 5 == 0)
    {
      const fs::path two = folder / (std::to_string(seed) + "-2");
      const StudyRun again(seed, two, 2);
      EXPECT_TRUE(BytesOf(one) == BytesOf(two)) << "one and two workers give other files";
    }
    if (HasFailure())
    {
      return; // and leaves the files
    }
  }
  EXPECT_GE(meshes, PEMESH_RANDOM_PART / 2) << "enough layouts can be meshed";
  fs::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(
  Seeds, RandomStudies, testing::Range(0, PEMESH_RANDOM_STUDIES / PEMESH_RANDOM_PART));
