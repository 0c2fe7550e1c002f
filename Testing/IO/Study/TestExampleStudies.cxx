// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonFamilies.h"
#include "SolverDescriptionFile.h"
#include "StudyFile.h"
#include "StudyTexts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

namespace
{

namespace fs = std::filesystem;

struct Box
{
  double Least[2] = { 1e300, 1e300 };
  double Greatest[2] = { -1e300, -1e300 };

  void Add(double x, double y)
  {
    this->Least[0] = std::min(this->Least[0], x);
    this->Least[1] = std::min(this->Least[1], y);
    this->Greatest[0] = std::max(this->Greatest[0], x);
    this->Greatest[1] = std::max(this->Greatest[1], y);
  }
};

/** Of a placed polygon: diagonal 0.5 times the scale, then rotated, then its middle at the center.
 */
Box PlacedBox(const pemesh::StudyPolygon& polygon, double time)
{
  const auto* family = pemesh::FindPolygonFamily(polygon.Family);
  const double t = polygon.From + time * (polygon.To - polygon.From);
  pemesh::ParameterValues values(family->Parameters);
  for (const auto& [name, value] : polygon.Parameters)
  {
    values.Set(name, value);
  }
  const auto vertices = family->Vertices(t, values);
  Box plain;
  for (const pemesh::Point2& p : vertices)
  {
    plain.Add(p.x, p.y);
  }
  const double diagonal =
    std::hypot(plain.Greatest[0] - plain.Least[0], plain.Greatest[1] - plain.Least[1]);
  const double factor = 0.5 * polygon.Scale / diagonal;
  const double angle = polygon.Rotation * std::numbers::pi / 180;
  Box turned;
  for (const pemesh::Point2& p : vertices)
  {
    turned.Add(factor * (std::cos(angle) * p.x - std::sin(angle) * p.y),
      factor * (std::sin(angle) * p.x + std::cos(angle) * p.y));
  }
  Box placed;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double half = (turned.Greatest[axis] - turned.Least[axis]) / 2;
    placed.Least[axis] = polygon.Center[static_cast<std::size_t>(axis)] - half;
    placed.Greatest[axis] = polygon.Center[static_cast<std::size_t>(axis)] + half;
  }
  return placed;
}

bool AreApart(const Box& a, const Box& b)
{
  return a.Greatest[0] < b.Least[0] || b.Greatest[0] < a.Least[0] || a.Greatest[1] < b.Least[1] ||
    b.Greatest[1] < a.Least[1];
}

std::vector<fs::path> Examples()
{
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(PEMESH_SOURCE_DIR) / "Data/Studies"))
  {
    if (entry.path().extension() == ".json")
    {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(ExampleStudies, CanAllBeReadWithTheirSolversAndMeshes)
{
  const std::vector<fs::path> files = Examples();
  EXPECT_GE(files.size(), 2u);
  for (const fs::path& file : files)
  {
    pemesh::Study study = pemesh::ReadStudy(file);
    EXPECT_EQ(pemesh::FindStudySolvers(study).size(), study.Solvers.size()) << file;
    EXPECT_EQ(study.Name, file.stem());
    EXPECT_EQ(pemesh::ParseStudy(pemesh::FormatStudy(study), file), study);
    if (pemesh::HasMeshFiles(study))
    {
      EXPECT_GT(pemesh::FindStudyMeshes(study).size(), 1u) << file;
    }
  }
}

TEST(ExampleStudies, QuickstartIsWhatTheReadmePromises)
{
  pemesh::Study study =
    pemesh::ReadStudy(fs::path(PEMESH_SOURCE_DIR) / "Data/Studies/quickstart.json");
  pemesh::FindStudySolvers(study);
  ASSERT_EQ(study.Polygons.size(), 2u);
  EXPECT_EQ(study.Polygons[0].Family, "comb");
  EXPECT_EQ(study.Polygons[1].Family, "star");
  const std::vector<double> times = TimesOf(study);
  ASSERT_EQ(times.size(), 20u);
  EXPECT_EQ(times.back(), 0.9);
  EXPECT_EQ(study.Metrics, pemesh::StudyMetrics());
  ASSERT_EQ(study.Solvers.size(), 1u);
  EXPECT_EQ(study.Solvers[0].Name, "pemesh-vem");
}

TEST(ExampleStudies, PolygonsNeverTouchEachOtherOrTheBorder)
{
  constexpr int steps = 400;
  constexpr double gap = 0.02;
  for (const fs::path& file : Examples())
  {
    const pemesh::Study study = pemesh::ReadStudy(file);
    for (int step = 0; step <= steps; ++step)
    {
      std::vector<Box> boxes;
      for (const pemesh::StudyPolygon& polygon : study.Polygons)
      {
        Box box = PlacedBox(polygon, 0.9 * step / steps);
        for (int axis = 0; axis < 2; ++axis)
        {
          box.Least[axis] -= gap;
          box.Greatest[axis] += gap;
          ASSERT_GT(box.Least[axis], 0.0) << file << " step " << step;
          ASSERT_LT(box.Greatest[axis], 1.0) << file << " step " << step;
        }
        for (const Box& other : boxes)
        {
          ASSERT_TRUE(AreApart(box, other)) << file << " step " << step;
        }
        boxes.push_back(box);
      }
    }
  }
}

} // namespace
