// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudioSupport.h"
#include "StudyModel.h"
#include "TestFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QUndoStack>

#include <filesystem>
#include <fstream>

using namespace pemesh;
using testing::HasSubstr;

namespace
{

JsonValue Star()
{
  return { JsonValue::Object{ { "family", { std::string("star") } } } };
}

} // namespace

TEST(StudyModel, BeginsWithAnEmptyStudyThatIsValid)
{
  const StudyModel model;
  EXPECT_TRUE(model.GetFault().isEmpty()) << model.GetFault().toStdString();
  EXPECT_FALSE(model.IsModified());
  EXPECT_TRUE(model.GetStudy().Polygons.empty());
}

TEST(StudyModel, EveryKindOfEditIsUndoneToTheByte)
{
  StudyModel model;
  std::vector<std::string> texts{ model.GetText() };
  const auto keep = [&] { texts.push_back(model.GetText()); };
  model.AddItem("polygons", Star(), "add");
  keep();
  model.AddItem("polygons", Star(), "add");
  keep();
  model.SetValue("polygons[1].scale", JsonNumber(0.25), "scale");
  keep();
  model.SetValue("mesh.agglomerate.rule", { std::string("metis") }, "rule"); // makes two objects
  keep();
  model.MoveItem("polygons", 0, 1, "move");
  keep();
  model.RemoveValue("polygons[0]", "delete");
  keep();
  EXPECT_EQ(model.GetStudy().Polygons.size(), 1U);
  EXPECT_EQ(model.GetStudy().Mesh.Agglomeration.Rule, "metis");
  for (std::size_t i = texts.size(); i-- > 0;)
  {
    EXPECT_EQ(model.GetText(), texts[i]) << i;
    model.GetUndoStack()->undo();
  }
  for (const std::string& text : texts)
  {
    EXPECT_EQ(model.GetText(), text);
    model.GetUndoStack()->redo();
  }
}

TEST(StudyModel, OneGestureIsOneUndo)
{
  StudyModel model;
  model.AddItem("polygons", Star(), "add");
  const int gesture = StudyModel::NewGesture();
  for (int i = 1; i <= 50; ++i)
  {
    model.SetValue("polygons[0].rotation", JsonNumber(i), "turn", gesture);
  }
  EXPECT_EQ(model.GetUndoStack()->count(), 2);
  model.SetValue("polygons[0].rotation", JsonNumber(90), "turn", StudyModel::NewGesture());
  EXPECT_EQ(model.GetUndoStack()->count(), 3);
  model.GetUndoStack()->undo();
  EXPECT_EQ(model.GetStudy().Polygons[0].Rotation, 50.0);
  model.GetUndoStack()->undo();
  EXPECT_EQ(model.GetStudy().Polygons[0].Rotation, 0.0);
}

TEST(StudyModel, KeepsTheLastGoodStudyWhileTheDocumentIsWrong)
{
  StudyModel model;
  model.AddItem("polygons", Star(), "add");
  model.SetValue("mesh.min-angle", JsonNumber(50), "angle");
  EXPECT_THAT(model.GetFault().toStdString(), HasSubstr("mesh.min-angle"));
  EXPECT_EQ(model.GetStudy().Mesh.MinimumAngle, 20.0);
  model.GetUndoStack()->undo();
  EXPECT_TRUE(model.GetFault().isEmpty());
}

TEST(StudyModel, AnItemOfAListThatTheDocumentDoesNotGiveCanBeChanged)
{
  StudyModel model;
  model.AddItem("polygons", Star(), "add");
  ASSERT_EQ(model.GetStudy().Sweep.size(), 1U) << "t is swept by default";
  model.SetValue("sweep[0].count", JsonNumber(5), "count");
  EXPECT_TRUE(model.GetFault().isEmpty()) << model.GetFault().toStdString();
  EXPECT_EQ(model.GetStudy().Sweep[0].Count, 5);
  EXPECT_EQ(model.GetStudy().Sweep[0].Parameter, "t");
}

TEST(StudyModel, SavedElsewhereItNamesTheSameFiles)
{
  const std::filesystem::path folder = pemesh::TestFolder("model-files");
  std::filesystem::create_directories(folder / "deep");
  std::ofstream(folder / "heart.csv") << "0,0\n1,0\n0,1\n";
  std::ofstream(folder / "study.json")
    << R"({"pemesh": 1, "polygons": [{"family": "file", "file": "heart.csv"}]})";
  StudyModel model;
  model.Open(QString::fromStdString((folder / "study.json").string()));
  model.Save(QString::fromStdString((folder / "deep" / "moved.json").string()));
  EXPECT_THAT(
    studio_test::ReadFile((folder / "deep" / "moved.json").string()), HasSubstr("../heart.csv"));
  EXPECT_EQ(model.GetStudy().Folder, folder / "deep");
  EXPECT_FALSE(model.IsModified());
}

TEST(StudyModel, AFileThatIsNoStudyChangesNothing)
{
  const std::filesystem::path folder = pemesh::TestFolder("model-bad");
  std::ofstream(folder / "bad.json") << R"({"pemesh": 1, "polygon": []})";
  StudyModel model;
  model.AddItem("polygons", Star(), "add");
  EXPECT_THROW(
    model.Open(QString::fromStdString((folder / "bad.json").string())), std::runtime_error);
  EXPECT_EQ(model.GetStudy().Polygons.size(), 1U);
  EXPECT_TRUE(model.IsModified());
}
