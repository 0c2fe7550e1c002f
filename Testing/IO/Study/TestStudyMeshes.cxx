// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Study.h"
#include "TestFolder.h"

#include "StudyTexts.h"
#include "TextFile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace
{

namespace fs = std::filesystem;

class StudyMeshes : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Folder = pemesh::TestFolder();
    for (const char* name : { "m10.off", "m2.off", "m1.off", "m02.off", "other.obj", ".m3.off",
           "a/x.off", "b/x.off", "b/y.off", "[1].off" })
    {
      pemesh::WriteTextFile(this->Folder / name, "OFF");
    }
    fs::create_directories(this->Folder / "folder.off");
  }

  std::vector<std::string> Find(const std::vector<std::string>& patterns) const
  {
    pemesh::Study study;
    study.Folder = this->Folder;
    study.Meshes = patterns;
    std::vector<std::string> names;
    for (const fs::path& path : pemesh::FindStudyMeshes(study))
    {
      EXPECT_TRUE(fs::is_regular_file(path)) << path;
      names.push_back(path.lexically_relative(this->Folder).string());
    }
    return names;
  }

  fs::path Folder;
};

using Names = std::vector<std::string>;

TEST_F(StudyMeshes, OneFile)
{
  EXPECT_EQ(this->Find({ "a/x.off" }), Names{ "a/x.off" });
  EXPECT_EQ(this->Find({ "a/../a/./x.off" }), Names{ "a/x.off" });
  EXPECT_EQ(this->Find({ (this->Folder / "a/x.off").string() }), Names{ "a/x.off" });
  EXPECT_EQ(this->Find({ "[1].off" }), Names{ "[1].off" });
}

TEST_F(StudyMeshes, PatternsSortNumbersByValue)
{
  EXPECT_EQ(this->Find({ "m*.off" }), (Names{ "m1.off", "m02.off", "m2.off", "m10.off" }));
  EXPECT_EQ(this->Find({ "m?.off" }), (Names{ "m1.off", "m2.off" }));
  EXPECT_EQ(this->Find({ "*/x.off" }), (Names{ "a/x.off", "b/x.off" }));
  EXPECT_EQ(this->Find({ "?/?.off" }), (Names{ "a/x.off", "b/x.off", "b/y.off" }));
  EXPECT_EQ(this->Find({ "*th*r.*" }), Names{ "other.obj" });
  EXPECT_EQ(this->Find({ ".m*.off" }), Names{ ".m3.off" });
}

TEST_F(StudyMeshes, PatternsKeepTheirOrderAndEachFileComesOnce)
{
  EXPECT_EQ(this->Find({ "m2.off", "m*.off", "b/../m2.off" }),
    (Names{ "m2.off", "m1.off", "m02.off", "m10.off" }));
}

TEST_F(StudyMeshes, NothingFoundIsTold)
{
  EXPECT_THAT(Complaint(
                [this] {
                  this->Find({ "m1.off", "n*.off" });
                }),
    testing::StartsWith("No mesh file matches \"n*.off\" (looked for "));
  EXPECT_THAT(Complaint([this] { this->Find({ "none/*.off" }); }),
    testing::StartsWith("No mesh file matches"));
  EXPECT_THAT(Complaint([this] { this->Find({ "none.off" }); }),
    testing::StartsWith("The mesh file \"none.off\" does not exist"));
  EXPECT_THAT(
    Complaint([this] { this->Find({ "a" }); }), testing::HasSubstr("such as \"a/*.off\""));
  EXPECT_THAT(Complaint([this] { this->Find({ "folder.off/*" }); }),
    testing::StartsWith("No mesh file matches"));
}

TEST(StudyScalars, AsTextAndNumber)
{
  EXPECT_EQ(pemesh::FormatScalar(true), "true");
  EXPECT_EQ(pemesh::FormatScalar(std::int64_t{ -3 }), "-3");
  EXPECT_EQ(pemesh::FormatScalar(0.1), "0.1");
  EXPECT_EQ(pemesh::FormatScalar(std::string("franke")), "franke");
  EXPECT_EQ(pemesh::ScalarToNumber(std::int64_t{ 4 }), 4.0);
  EXPECT_TRUE(std::isnan(pemesh::ScalarToNumber(std::string("4"))));
}

} // namespace
