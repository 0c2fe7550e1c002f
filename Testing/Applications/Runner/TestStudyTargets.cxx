// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/** Targets of studies whose elements are merged. */
#include "ProgramRun.h"
#include "vtkPEMRunner.h"

#include <gtest/gtest.h>

#include <string>

#include <vtkNew.h>

namespace
{

/** What a study with an agglomeration says of a target of 1000 elements; empty if it is reached. */
std::string MessageFor(const std::string& agglomeration)
{
  const auto folder = pemesh::TestFolder();
  vtkNew<vtkPEMRunner> runner;
  runner->SetStudyText(
    R"({ "pemesh": 1, "name": "target", "polygons": [{ "family": "star", "to": 0.1 }], "sweep": [],
         "mesh": { "target": { "quantity": "elements", "value": 1000 }, "agglomerate": )" +
      agglomeration + " } }",
    folder.string());
  runner->SetOutputDirectory((folder / "results").string());
  runner->SetMeshesOnly(true);
  runner->SetNumberOfWorkers(1);
  runner->Run();
  return runner->GetMessages().empty() ? "" : runner->GetMessages()[0];
}

} // namespace

TEST(StudyTargets, AreReachedBehindMergingThatFollowsThem)
{
  EXPECT_EQ(MessageFor(R"({ "rule": "random", "percentage": 5 })"), "");
  EXPECT_EQ(MessageFor(R"({ "rule": "regular" })"), "");
}

/** However fine the mesh is: it must not be refined until memory ends. */
TEST(StudyTargets, AreRefusedByNameBehindMergingToAnotherNumber)
{
  const std::string message = MessageFor(R"({ "rule": "random", "elements": 110 })");
  EXPECT_NE(message.find("merging leaves 110 where there are"), std::string::npos) << message;
  EXPECT_NE(message.find("mesh.agglomerate"), std::string::npos) << message;
}
