// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudySweeps.h"

#include "StudyFile.h"
#include "StudyTexts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace
{

using pemesh::MakeStudyOfCase;
using pemesh::ParseStudy;
using pemesh::Study;
using pemesh::StudyScalar;
using pemesh::SweepCases;
using pemesh::SweptValue;
using testing::HasSubstr;

/** A study of two polygons and one solver with these sweeps. */
Study With(const std::string& sweeps)
{
  return ParseStudy(R"({"pemesh": 1, "polygons": [{"family": "comb"}, {"family": "star"}],
    "mesh": {"max-area": {"rule": "constant", "value": 0.1}},
    "solvers": [{"solver": "pemesh-vem", "order": 1}], "sweep": )" +
      sweeps + "}",
    "s.json");
}

std::string ComplaintOf(const std::string& sweeps)
{
  return Complaint([&] { With(sweeps); });
}

/** The values of all cases as text: "0 a; 0 b". */
std::string Show(const Study& study)
{
  std::string text;
  for (const std::vector<SweptValue>& values : SweepCases(study))
  {
    text += text.empty() ? "" : "; ";
    for (const SweptValue& value : values)
    {
      text += (&value == values.data() ? "" : " ") + pemesh::FormatScalar(value.Value);
    }
  }
  return text;
}

TEST(StudySweeps, TheLastOneRunsFastest)
{
  EXPECT_EQ(Show(With(R"([{"values": [0, 0.5]},
    {"parameter": "solvers[0].order", "from": 1, "to": 3, "count": 3}])")),
    "0 1; 0 2; 0 3; 0.5 1; 0.5 2; 0.5 3");
}

TEST(StudySweeps, ZippedOnesAdvanceTogether)
{
  EXPECT_EQ(Show(With(R"([{"parameter": "mesh.min-angle", "values": [10, 20]},
    {"parameter": "polygons[*].scale", "values": [0.5, 0.25], "zip": true},
    {"parameter": "solvers[0].problem", "values": ["franke", "linear"]}])")),
    "10 0.5 franke; 10 0.5 linear; 20 0.25 franke; 20 0.25 linear");
}

TEST(StudySweeps, GeometricSpacingHasEqualRatiosAndExactEnds)
{
  const std::vector<StudyScalar> values = pemesh::SweepValues(
    With(R"([{"parameter": "mesh.max-area.value", "from": 0.1, "to": 0.0001, "count": 4,
      "spacing": "geometric"}])")
      .Sweep[0]);
  ASSERT_EQ(values.size(), 4U);
  EXPECT_EQ(std::get<double>(values[0]), 0.1);
  EXPECT_NEAR(std::get<double>(values[1]), 0.01, 1e-17);
  EXPECT_NEAR(std::get<double>(values[2]), 0.001, 1e-18);
  EXPECT_EQ(std::get<double>(values[3]), 0.0001);
}

TEST(StudySweeps, ColumnsAreNamedAfterTheLastKey)
{
  const Study study = With(R"([{"parameter": "polygons[0].scale", "values": [1]},
    {"parameter": "polygons[1].scale", "values": [1]},
    {"parameter": "mesh.min-angle", "name": "angle", "values": [1]}])");
  EXPECT_EQ(study.Sweep[0].Name, "scale");
  EXPECT_EQ(study.Sweep[1].Name, "polygons[1].scale");
  EXPECT_EQ(study.Sweep[2].Name, "angle");
}

TEST(StudySweeps, TheStudyOfACaseHasItsValues)
{
  const Study study = With(R"([{"values": [0.5]}, {"parameter": "mesh.min-angle", "values": [12]},
    {"parameter": "polygons[*].scale", "values": [0.25]},
    {"parameter": "mesh.max-area.value", "values": [0.5]},
    {"parameter": "mesh.preserve-polygons", "values": [true]},
    {"parameter": "solvers[0].order", "values": [2]}])");
  const std::vector<SweptValue> values = SweepCases(study).at(0);
  EXPECT_EQ(pemesh::DeformationOf(values), 0.5);
  const Study ofCase = MakeStudyOfCase(study, values);
  EXPECT_EQ(ofCase.Mesh.MinimumAngle, 12.0);
  EXPECT_EQ(ofCase.Mesh.MaximumArea.Value, 0.5);
  EXPECT_TRUE(ofCase.Mesh.PreservePolygons);
  EXPECT_EQ(ofCase.Polygons[0].Scale, 0.25);
  EXPECT_EQ(ofCase.Polygons[1].Scale, 0.25);
  EXPECT_EQ(ofCase.Polygons[0].Family, "comb");
  EXPECT_EQ(ofCase.Solvers[0].Options[0].second, StudyScalar(std::int64_t{ 2 }));
  EXPECT_EQ(ofCase.Solvers[0].Name, study.Solvers[0].Name) << "columns must not change their names";
  EXPECT_TRUE(ofCase.Sweep.empty());
  EXPECT_EQ(ofCase.Folder, study.Folder);
}

TEST(StudySweeps, WhatIsNotAllowedThereIsTold)
{
  const auto complaint = [](const std::string& sweep)
  {
    const Study study = With("[" + sweep + "]");
    return Complaint([&] { MakeStudyOfCase(study, SweepCases(study).at(0)); });
  };
  EXPECT_EQ(complaint(R"({"parameter": "mesh.min-angle", "values": [50]})"),
    "\"sweep of mesh.min-angle at 50\": mesh.min-angle is 50; it must be between 0 and 33.");
  EXPECT_THAT(complaint(R"({"parameter": "mesh.min-angel", "values": [5]})"),
    HasSubstr("mesh.min-angel is not a key; did you mean min-angle?"));
  EXPECT_THAT(complaint(R"({"parameter": "polygons[2].scale", "values": [5]})"),
    HasSubstr("The sweep of polygons[2].scale at 5 names item \"2\" of a list of 2"));
  EXPECT_THAT(complaint(R"({"parameter": "mesh.min-angle", "values": ["steep"]})"),
    HasSubstr("is \"steep\" where a number is expected"));
}

TEST(StudySweeps, ChoicesCanBeSweptWhateverElseTheyTake)
{
  const Study study =
    With(R"([{"parameter": "domain.shape", "values": ["rectangle", "disc", "l-shape"]},
    {"parameter": "mesh.max-area.rule", "values": ["diagonal", "constant", "none"], "zip": true}])");
  for (const std::vector<SweptValue>& values : SweepCases(study))
  {
    const Study ofCase = MakeStudyOfCase(study, values);
    EXPECT_EQ(ofCase.Domain.Shape, pemesh::FormatScalar(values[0].Value));
    EXPECT_EQ(ofCase.Domain.Parameters.size(), ofCase.Domain.Shape == "l-shape" ? 3U : 2U);
    EXPECT_EQ(ofCase.Mesh.MaximumArea.Rule, pemesh::FormatScalar(values[1].Value));
  }
}

TEST(StudySweeps, ASweptSourceHasItsOwnDefaults)
{
  const auto cells = [](const std::string& mesh)
  {
    const Study study = ParseStudy(R"({"pemesh": 1, "mesh": )" + mesh +
        R"(, "sweep": [{"parameter": "mesh.source", "values": ["hexagons"]}]})",
      "s.json");
    return MakeStudyOfCase(study, SweepCases(study).at(0)).Mesh.Parameters.at(0).second;
  };
  EXPECT_EQ(cells(R"({"source": "voronoi"})"), 10.0);
  EXPECT_EQ(cells(R"({"source": "voronoi", "cells": 23})"), 23.0);
}

TEST(StudySweeps, AKeyThatDoesNotApplyIsNotSweptInSilence)
{
  const Study study = With(R"([{"parameter": "domain.shape", "values": ["disc"]},
    {"parameter": "domain.width", "values": [2]}])");
  EXPECT_THAT(Complaint([&] { MakeStudyOfCase(study, SweepCases(study).at(0)); }),
    HasSubstr("would change nothing: domain.width does not apply there"));
}

TEST(StudySweeps, ImpossibleOnesAreRefused)
{
  EXPECT_THAT(ComplaintOf(R"([{"parameter": "angle", "values": [1]}])"),
    HasSubstr("sweep[0].parameter is \"angle\", which cannot be swept"));
  EXPECT_THAT(ComplaintOf(R"([{"parameter": "mesh.min-angle", "to": 1}])"),
    HasSubstr("sweep[0].from is missing"));
  EXPECT_THAT(ComplaintOf(R"([{"values": [1], "zip": true}])"), HasSubstr("no sweep before it"));
  EXPECT_THAT(ComplaintOf(R"([{"values": [0, 1]},
    {"parameter": "mesh.min-angle", "values": [1, 2, 3], "zip": true}])"),
    HasSubstr("it has 3 values and the sweep before it 2"));
  EXPECT_THAT(ComplaintOf(R"([{"values": [0]}, {"values": [1]}])"), HasSubstr("swept already"));
  EXPECT_THAT(
    ComplaintOf(R"([{"parameter": "mesh.min-angle", "name": "Elements", "values": [1]}])"),
    HasSubstr("the name of another column"));
  EXPECT_THAT(ComplaintOf(R"([{"parameter": "mesh.min-angle", "from": 0, "to": 1,
    "spacing": "geometric"}])"),
    HasSubstr("spacing is \"geometric\", which needs"));
  EXPECT_THAT(ComplaintOf(R"([{"count": 10000},
    {"parameter": "mesh.min-angle", "from": 0, "to": 1, "count": 10000}])"),
    HasSubstr("more than 10000000"));
  EXPECT_THAT(
    Complaint(
      [] { ParseStudy(R"({"pemesh": 1, "meshes": "*.off", "sweep": [{"values": [0]}]})", "s"); }),
    HasSubstr("mesh files have none"));
}

TEST(StudySweeps, MeshFilesCanSweepTheSolver)
{
  const Study study = ParseStudy(R"({"pemesh": 1, "meshes": "*.off",
    "solvers": [{"solver": "pemesh-vem"}],
    "sweep": [{"parameter": "solvers[0].order", "values": [1, 2]}]})",
    "s.json");
  EXPECT_EQ(Show(study), "1; 2");
}

TEST(StudySweeps, TheyAreWrittenBack)
{
  const Study study = With(R"([{"parameter": "mesh.min-angle", "values": [1, 2]},
    {"parameter": "solvers[0].problem", "values": ["a", "b"], "zip": true},
    {"parameter": "mesh.max-area.value", "from": 0.1, "to": 0.01, "spacing": "geometric"}])");
  EXPECT_EQ(ParseStudy(pemesh::FormatStudy(study), "s.json"), study);
}

} // namespace
