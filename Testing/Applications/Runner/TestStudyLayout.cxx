// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * From the polygons of a study to those of a layout, and that nothing is done twice.
 */
#include "StudyLayout.h"
#include "TestFolder.h"

#include "StudyFile.h"
#include "TextFile.h"
#include "vtkPEMPolygonLayout.h"

#include <vtkNew.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <stdexcept>

namespace
{

using pemesh::ConfigureLayout;
using pemesh::Study;
using testing::HasSubstr;

Study ReadText(const std::string& members)
{
  return pemesh::ParseStudy("{\"pemesh\": 1, " + members + "}", pemesh::TestPath() / "s.json");
}

/** Polygons of every kind, and scattered ones; `more` are further members of the first polygon. */
Study EveryKind(const std::string& more = "")
{
  pemesh::WriteTextFile(pemesh::TestPath() / "shapes/t.csv", "0 0\n4 0\n0 3\n");
  return ReadText(R"("polygons": [
    {"family": "comb", "center": [0.2, 0.2], "scale": 0.4, "rotation": 30,
     "name": "c", "from": 0.25, "to": 0.5)" +
    more + R"(},
    {"family": "random", "center": [0.8, 0.2], "scale": 0.4, "seed": 3},
    {"family": "file", "file": "shapes/t.csv", "center": [0.2, 0.8], "scale": 0.5},
    {"family": "points", "points": [[0.7, 0.7], [0.9, 0.7], [0.7, 0.9]]}],
    "scatter": {"count": 3, "smallest-scale": 0.1, "largest-scale": 0.1, "from": 0.5})");
}

std::string Complaint(const Study& study, vtkPEMPolygonLayout* layout)
{
  try
  {
    ConfigureLayout(study, layout);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "nothing thrown";
}

} // namespace

TEST(StudyLayout, PlacesPolygonsOfEveryKindAndScattersOthers)
{
  vtkNew<vtkPEMPolygonLayout> layout;
  ConfigureLayout(EveryKind(", \"teeth\": 4"), layout);
  ASSERT_EQ(layout->GetNumberOfPolygons(), 7);
  EXPECT_EQ(layout->GetPolygonFamily(0), "comb");
  EXPECT_EQ(layout->GetPolygonName(0), "c");
  EXPECT_EQ(layout->GetPolygonCenterX(0), 0.2);
  EXPECT_EQ(layout->GetPolygonScale(0), 0.4);
  EXPECT_EQ(layout->GetPolygonRotation(0), 30.0);
  EXPECT_EQ(layout->GetPolygonParameter(0, "teeth"), 4);
  EXPECT_EQ(layout->GetPolygonFrom(0), 0.25);
  EXPECT_EQ(layout->GetPolygonTo(0), 0.5);
  EXPECT_EQ(layout->GetPolygonName(1), "polygon 2 (random)");
  EXPECT_EQ(layout->GetPolygonParameter(1, "seed"), 3);
  EXPECT_EQ(layout->GetPolygonFile(2), (pemesh::TestPath() / "shapes/t.csv").string());
  EXPECT_EQ(layout->GetPolygonScale(2), 0.5);
  EXPECT_THAT(layout->GetPolygonPoints(3), testing::ElementsAre(0.7, 0.7, 0.9, 0.7, 0.7, 0.9));
  EXPECT_EQ(layout->GetPolygonFrom(6), 0.5);
  EXPECT_THAT(layout->FindFaults(), testing::IsEmpty());
}

TEST(StudyLayout, AnEqualStudyModifiesNothingAndAnotherDoes)
{
  vtkNew<vtkPEMPolygonLayout> layout;
  const Study study = EveryKind();
  ConfigureLayout(study, layout);
  vtkMTimeType last = layout->GetMTime();
  ConfigureLayout(study, layout);
  EXPECT_EQ(layout->GetMTime(), last);
  ConfigureLayout(EveryKind(), layout);
  EXPECT_EQ(layout->GetMTime(), last);
  const std::function<void(Study&)> changes[] = { [](Study& s) { s.Polygons[0].Scale = 0.41; },
    [](Study& s) { s.Polygons[0].Parameters[0].second = 5; },
    [](Study& s) { s.Polygons[1].Parameters[0].second = 5; },
    [](Study& s) { s.Polygons[0].Name = ""; }, [](Study& s) { s.Polygons[0].To = 0.6; },
    [](Study& s) { s.Polygons[3].Points[0][0] = 0.71; }, [](Study& s) { s.Polygons.pop_back(); },
    [](Study& s) { s.Scatter->Seed = 1; }, [](Study& s) { s.Scatter->Count = 4; },
    [](Study& s) { s.Scatter.reset(); },
    [](Study&) { pemesh::WriteTextFile(pemesh::TestPath() / "shapes/t.csv", "0 0\n4 0\n0 2\n"); } };
  for (const auto& change : changes)
  {
    Study changed = study;
    change(changed);
    ConfigureLayout(changed, layout);
    EXPECT_GT(layout->GetMTime(), last);
    last = layout->GetMTime();
    ConfigureLayout(changed, layout);
    EXPECT_EQ(layout->GetMTime(), last);
    ConfigureLayout(study, layout);
    last = layout->GetMTime();
  }
}

TEST(StudyLayout, WhatCannotBePlacedIsSaidAndNothingChanges)
{
  vtkNew<vtkPEMPolygonLayout> layout;
  layout->AddPolygon("zeta", 0.5, 0.5);
  const vtkMTimeType before = layout->GetMTime();
  EXPECT_THAT(
    Complaint(ReadText(R"("polygons": [{"family": "file", "file": "none.off"}])"), layout),
    HasSubstr("none.off"));
  EXPECT_THAT(
    Complaint(ReadText(R"("scatter": {"count": 1000})"), layout), testing::StartsWith("Only "));
  EXPECT_EQ(layout->GetMTime(), before);
  EXPECT_EQ(layout->GetNumberOfPolygons(), 1);
}
