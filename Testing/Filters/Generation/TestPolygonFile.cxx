// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Polygons from files of every form, and what is said about files that hold none.
 */
#include "PolygonFile.h"

#include "MeshFormats.h"
#include "TestMeshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace
{

using pemesh::ParsePolygonPoints;
using pemesh::Point2;
using pemesh::ReadPolygonFile;
using Polygons = std::vector<std::vector<Point2>>;

const std::vector<Point2> Triangle = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.25, 0.5 } };

std::string MessageOf(std::string_view text)
{
  try
  {
    ParsePolygonPoints(text, "p.csv");
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "no error";
}

std::string MessageOfFile(const std::filesystem::path& path)
{
  try
  {
    ReadPolygonFile(path);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "no error";
}

} // namespace

TEST(PolygonFile, ReadsPointsWithEverySeparator)
{
  for (const char* text : { "0,0\n1,0\n0.25,0.5\n", "x,y\n0,0\n1,0\n0.25,0.5", "0;0\n1;0\n.25;.5\n",
         "0 0\n1   0\n\t0.25\t0.5 \n", "# a triangle\n\nX , Y\n0, 0 # origin\n#\n1, 0\n0.25, 0.5",
         "\xEF\xBB\xBF\"x\",\"y\"\r\n0,0\r\n1e0,0\r\n25e-2,0.5\r\n0,0\r\n" })
  {
    EXPECT_EQ(ParsePolygonPoints(text, "p.csv"), Polygons{ Triangle }) << text;
  }
}

TEST(PolygonFile, EmptyLinesSeparatePolygonsAndCommentsDoNot)
{
  const Polygons polygons =
    ParsePolygonPoints("\n\n0,0\n1,0\n# still the first\n0.25,0.5\n \n\n2 0\n3 0\n3 1\n", "p.csv");
  EXPECT_EQ(polygons, (Polygons{ Triangle, { { 2.0, 0.0 }, { 3.0, 0.0 }, { 3.0, 1.0 } } }));
}

TEST(PolygonFile, ClockwisePointsAreTurnedRound)
{
  EXPECT_EQ(ParsePolygonPoints("0,0\n0.25,0.5\n1,0\n", "p.csv"), Polygons{ Triangle });
}

TEST(PolygonFile, ErrorsNameFileAndLine)
{
  EXPECT_EQ(MessageOf("x,y\n0,0\n1,zero\n"), "\"p.csv\", line 3: \"zero\" is not a finite number.");
  EXPECT_EQ(MessageOf("0,0\n1,nan\n"), "\"p.csv\", line 2: \"nan\" is not a finite number.");
  EXPECT_EQ(MessageOf("0,0\n1,\n"), "\"p.csv\", line 2: \"\" is not a finite number.");
  EXPECT_EQ(MessageOf("0;0\n0,5;1\n"),
    "\"p.csv\", line 2: \"0,5\" is not a finite number; write decimals with a point.");
  EXPECT_EQ(MessageOf("0,0,0\n"),
    "\"p.csv\", line 1: 3 values where x and y are expected, with a comma, a semicolon or a blank "
    "between.");
  EXPECT_THAT(MessageOf("7\n"), testing::HasSubstr("line 1: 1 value where"));
  EXPECT_THAT(MessageOf("a,b\n0,0\n"), testing::HasSubstr("line 1: \"a\" is not"));
  EXPECT_THAT(MessageOf("0,0\n1,0\n0,1\n\n4,4\n5,5\n4,4\n"),
    testing::HasSubstr("line 5: the polygon that begins here has fewer than three vertices"));
  EXPECT_EQ(
    MessageOf("x,y\n# nothing\n"), "\"p.csv\" holds no polygon: write one vertex a line, x,y.");
}

TEST(PolygonFile, ElementsOfMeshFilesInTheirOrder)
{
  const auto mesh = pemesh::MakeHouse();
  const Polygons expected = { { { 0, 0 }, { 0.5, 0 }, { 0.5, 1 }, { 0, 1 } },
    { { 0.5, 0 }, { 1, 0 }, { 0.5, 1 } }, { { 1, 0 }, { 1, 1 }, { 0.5, 1 } } };
  const std::filesystem::path folder = pemesh::TestFolder();
  for (const char* name : { "house.off", "house.OBJ", "house.vtp", "house.node" })
  {
    pemesh::WriteMesh(folder / name, mesh);
    EXPECT_EQ(ReadPolygonFile(folder / name), expected) << name;
  }
  pemesh::WriteBytes(folder / "p.XY", "0 0\n1 0\n0.25 0.5");
  EXPECT_EQ(ReadPolygonFile(folder / "p.XY"), Polygons{ Triangle });
}

TEST(PolygonFile, FilesThatCannotBeReadAreNamed)
{
  const std::filesystem::path folder = pemesh::TestFolder();
  EXPECT_THAT(MessageOfFile(folder / "none.csv"), testing::HasSubstr("none.csv"));
  EXPECT_THAT(MessageOfFile(folder / "polygon.svg"), testing::HasSubstr("known are .csv"));
  pemesh::WriteBytes(folder / "short.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n");
  EXPECT_THAT(MessageOfFile(folder / "short.off"), testing::HasSubstr("line 5"));
  pemesh::WriteMesh(folder / "empty.vtp", vtkNew<vtkPolyData>());
  EXPECT_THAT(MessageOfFile(folder / "empty.vtp"), testing::HasSubstr("holds no polygon"));
}
