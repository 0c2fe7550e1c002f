// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMDomainMesher.h"

#include "CaseStatus.h"
#include "MeshInvariants.h"
#include "PolygonFamilies.h"
#include "vtkPEMPolygonLayout.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <random>
#include <thread>
#include <vector>

namespace
{

/** A random layout without faults at the time of `GetTime`, the same for the same seed. */
class RandomLayout
{
public:
  explicit RandomLayout(std::uint64_t seed)
    : Bits(seed)
  {
    this->Time = 0.97 * this->Uniform();
    const int wanted = 1 + static_cast<int>(this->Bits() % 5);
    for (int trial = 0; trial < 100 && static_cast<int>(this->Polygons.size()) < wanted; ++trial)
    {
      const bool upright = this->Bits() % 4 == 0;
      this->Polygons.push_back({ static_cast<int>(this->Bits() % 9), 0.1 + 0.8 * this->Uniform(),
        0.1 + 0.8 * this->Uniform(), 0.2 + 0.8 * this->Uniform(),
        upright ? 90.0 * static_cast<double>(this->Bits() % 4) : 360.0 * this->Uniform() });
      vtkNew<vtkPEMPolygonLayout> layout;
      this->Fill(layout);
      if (!layout->FindFault(this->Time).empty())
      {
        this->Polygons.pop_back();
      }
    }
  }

  double GetTime() const { return this->Time; }

  void Fill(vtkPEMPolygonLayout* layout) const
  {
    for (const Polygon& polygon : this->Polygons)
    {
      const int index = layout->AddPolygon(
        pemesh::PolygonFamilies()[polygon.Family].Name, polygon.CenterX, polygon.CenterY);
      layout->SetPolygonScale(index, polygon.Scale);
      layout->SetPolygonRotation(index, polygon.Rotation);
    }
  }

private:
  struct Polygon
  {
    int Family;
    double CenterX, CenterY, Scale, Rotation;
  };

  double Uniform() { return static_cast<double>(this->Bits() >> 11) * 0x1p-53; }

  std::mt19937_64 Bits;
  double Time = 0.0;
  std::vector<Polygon> Polygons;
};

/** Everything about a mesh, to the bit. */
std::vector<std::uint64_t> FingerprintOf(std::uint64_t seed, bool preserve)
{
  const RandomLayout random(seed);
  vtkNew<vtkPEMPolygonLayout> layout;
  random.Fill(layout);
  vtkNew<vtkPEMDomainMesher> mesher;
  mesher->SetInputConnection(layout->GetOutputPort());
  mesher->SetPreservePolygons(preserve);
  mesher->UpdateTimeStep(random.GetTime());
  std::vector<std::uint64_t> words;
  vtkDataArray* points = mesher->GetOutput()->GetPoints()->GetData();
  for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      const double coordinate = points->GetComponent(i, j);
      std::uint64_t word;
      std::memcpy(&word, &coordinate, sizeof word);
      words.push_back(word);
    }
  }
  vtkDataArray* cells = mesher->GetOutput()->GetPolys()->GetConnectivityArray();
  for (vtkIdType i = 0; i < cells->GetNumberOfTuples(); ++i)
  {
    words.push_back(static_cast<std::uint64_t>(cells->GetTuple1(i)));
  }
  return words;
}

class RandomLayouts : public testing::TestWithParam<int>
{
};

TEST_P(RandomLayouts, AreMeshedSplitAndPreserved)
{
  const RandomLayout random(static_cast<std::uint64_t>(GetParam()));
  vtkNew<vtkPEMPolygonLayout> layout;
  random.Fill(layout);
  ASSERT_GT(layout->GetNumberOfPolygons(), 0);
  vtkNew<vtkPEMDomainMesher> mesher;
  mesher->SetInputConnection(layout->GetOutputPort());
  mesher->UpdateTimeStep(random.GetTime());
  vtkPolyData* mesh = mesher->GetOutput();
  ASSERT_EQ(pemesh::GetCaseStatusMessage(mesh), "");
  EXPECT_EQ(WhyNotAMesh(mesh), "");
  EXPECT_EQ(WhyNotConstrainedDelaunay(mesh), "");
  EXPECT_EQ(WhyNotConforming(mesh), "");
  double own = 360.0;
  for (int i = 0; i < layout->GetNumberOfPolygons(); ++i)
  {
    own = std::min(own, SmallestOuterAngle(VerticesOf(layout->GetOutput(), i)));
  }
  EXPECT_GE(pemesh::GetFieldNumber(mesh, "AttainedMinimumAngle"), std::min(20.0, own) - 1e-9);

  mesher->PreservePolygonsOn();
  mesher->UpdateTimeStep(random.GetTime());
  mesh = mesher->GetOutput();
  ASSERT_EQ(pemesh::GetCaseStatusMessage(mesh), "");
  EXPECT_EQ(WhyNotAMesh(mesh), "");
  EXPECT_EQ(WhyNotConstrainedDelaunay(mesh), "");
  for (int i = 0; i < layout->GetNumberOfPolygons(); ++i)
  {
    EXPECT_EQ(VerticesOf(mesh, i), VerticesOf(layout->GetOutput(), i));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomLayouts, testing::Range(1, 61));

TEST(DomainMesherDeterminism, SameBitsInEveryThreadAndEveryRun)
{
  constexpr int Count = 8;
  std::vector<std::vector<std::uint64_t>> first(Count), second(Count);
  const auto work = [](std::vector<std::vector<std::uint64_t>>& results, bool backwards)
  {
    for (int i = 0; i < Count; ++i)
    {
      const int seed = backwards ? Count - 1 - i : i;
      results[seed] = FingerprintOf(100 + seed, seed % 2 == 0);
    }
  };
  std::thread one(work, std::ref(first), false);
  std::thread two(work, std::ref(second), true);
  one.join();
  two.join();
  EXPECT_EQ(first, second);
  // Again, with the heap in another state.
  std::vector<std::vector<char>> ballast;
  for (int i = 0; i < 1000; ++i)
  {
    ballast.emplace_back(17 * i + 1);
  }
  for (int i = 0; i < Count; ++i)
  {
    EXPECT_EQ(FingerprintOf(100 + i, i % 2 == 0), first[i]);
    EXPECT_GT(first[i].size(), 50u);
  }
}

} // namespace
