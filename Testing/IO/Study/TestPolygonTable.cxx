// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Tables of polygons: both forms read, one written, and the place named where something is wrong.
 */
#include "PolygonTable.h"
#include "TestFolder.h"

#include "StudyTexts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

namespace
{

using pemesh::FormatPolygonTable;
using pemesh::ParsePolygonTable;
using pemesh::StudyPolygon;
using Parameters = std::vector<std::pair<std::string, double>>;

std::string ComplaintAbout(const std::string& text)
{
  return Complaint([&] { ParsePolygonTable(text, "p.csv"); });
}

TEST(PolygonTable, ReadsTheFormWithAHeader)
{
  const std::vector<StudyPolygon> polygons =
    ParsePolygonTable("\xEF\xBB\xBF"
                      "family,file,name,center_x,center_y,scale,rotation,from,to,teeth,seed\r\n"
                      "comb,,\"the \"\"left\"\", first\",0.3,.25,0.8,15.5,0.1,0.95,7,\r\n"
                      "\r\n"
                      "random,,007,,,,,,,,12\r\n"
                      "file,\"a, b.off\",,2,-1,3,,,,,\r\n",
      "p.csv");
  ASSERT_EQ(polygons.size(), 3u);
  EXPECT_EQ(polygons[0].Family, "comb");
  EXPECT_EQ(polygons[0].Name, "the \"left\", first");
  EXPECT_EQ(polygons[0].Center, (std::array<double, 2>{ 0.3, 0.25 }));
  EXPECT_EQ(polygons[0].Scale, 0.8);
  EXPECT_EQ(polygons[0].Rotation, 15.5);
  EXPECT_EQ(polygons[0].From, 0.1);
  EXPECT_EQ(polygons[0].To, 0.95);
  EXPECT_EQ(polygons[0].Parameters, (Parameters{ { "teeth", 7 } }));
  EXPECT_EQ(polygons[1].Name, "007");
  EXPECT_EQ(polygons[1].Center, (std::array<double, 2>{ 0.5, 0.5 }));
  EXPECT_EQ(polygons[1].Parameters.at(0), (std::pair<std::string, double>{ "seed", 12 }));
  EXPECT_EQ(polygons[1].Parameters.size(), 5u);
  EXPECT_EQ(polygons[2].File, "a, b.off");
  EXPECT_EQ(polygons[2].Center, (std::array<double, 2>{ 2.0, -1.0 }));
}

TEST(PolygonTable, ColumnsInAnyOrderAndFewOfThem)
{
  const std::vector<StudyPolygon> polygons =
    ParsePolygonTable("center_y,family,center_x\n0.25,zeta,0.75\n", "p.csv");
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_EQ(polygons[0].Center, (std::array<double, 2>{ 0.75, 0.25 }));
  EXPECT_TRUE(ParsePolygonTable("family\n", "p.csv").empty());
  EXPECT_TRUE(ParsePolygonTable("", "p.csv").empty());
}

TEST(PolygonTable, ReadsThePredecessorsForm)
{
  const std::vector<StudyPolygon> polygons = ParsePolygonTable(
    "Comb NONE 0.25 0.25 0 1\nN-Sided NONE 0.75 0.25 1.5707963267948966 0.5\r\n\n"
    "U-Like  NONE 0.25\t0.75 -0.1 1.2\nRandom my shapes/a b.off 0.75 0.75 0 0.8\n",
    "old.csv");
  ASSERT_EQ(polygons.size(), 4u);
  EXPECT_EQ(polygons[0].Family, "comb");
  EXPECT_EQ(polygons[0].Parameters, (Parameters{ { "teeth", 10 } }));
  EXPECT_EQ(polygons[1].Family, "n-sided");
  EXPECT_EQ(polygons[1].Rotation, 90.0);
  EXPECT_EQ(polygons[1].Scale, 0.5);
  EXPECT_EQ(polygons[2].Family, "u-like");
  EXPECT_EQ(polygons[2].Center, (std::array<double, 2>{ 0.25, 0.75 }));
  EXPECT_NEAR(polygons[2].Rotation, -18.0 / std::numbers::pi, 1e-15);
  EXPECT_EQ(polygons[3].Family, "file");
  EXPECT_EQ(polygons[3].File, "my shapes/a b.off");
  EXPECT_EQ(polygons[3].Scale, 0.8);
}

TEST(PolygonTable, WhatIsWrittenComesBack)
{
  std::vector<StudyPolygon> polygons = ParsePolygonTable("family,name,scale,rotation,sides,file\n"
                                                         "n-sided,\"two\nlines\",0.1,1e-300,12,\n"
                                                         "file,\"a \"\"b\"\"\",3,,,x y.csv\n"
                                                         "random,,,,,\nmaze, ,,,,\n",
    "p.csv");
  polygons[0].Center = { 1.0 / 3.0, -0.1 - 0.2 };
  EXPECT_EQ(ParsePolygonTable(FormatPolygonTable(polygons), "q.csv"), polygons);
  StudyPolygon drawn;
  drawn.Family = "points";
  drawn.Points = { { 0.1, 1.0 / 3.0 }, { 0.7, 1e-17 }, { -5, 22 } };
  polygons.push_back(drawn);
  EXPECT_EQ(ParsePolygonTable(FormatPolygonTable(polygons), "q.csv"), polygons);

  const std::filesystem::path file = pemesh::TestPath("round.csv");
  pemesh::WritePolygonTable(file, polygons);
  EXPECT_EQ(pemesh::ReadPolygonTable(file), polygons);
}

TEST(PolygonTable, HeaderAsDocumented)
{
  const std::string text = FormatPolygonTable(ParsePolygonTable("family\ncomb\nstar\n", "p.csv"));
  EXPECT_EQ(text,
    "family,file,name,center_x,center_y,scale,rotation,from,to,teeth,spikes\n"
    "comb,,,0.5,0.5,1,0,0,1,10,\nstar,,,0.5,0.5,1,0,0,1,,40\n");
}

TEST(PolygonTable, ErrorsNameFileLineAndColumn)
{
  EXPECT_EQ(ComplaintAbout("family,scale\ncomb,1\n\ncomb,-1\n"),
    "\"p.csv\": line 4, column scale is -1; it must be greater than 0.");
  EXPECT_EQ(ComplaintAbout("family,center_x,center_y\ncomb,a,0\n"),
    "\"p.csv\": line 2, column center_x is \"a\" where a number is expected.");
  EXPECT_EQ(ComplaintAbout("family,center_x,center_y\ncomb,,0\n"),
    "\"p.csv\": line 2, column center_x or center_y is empty: a center needs both.");
  EXPECT_EQ(ComplaintAbout("family,teeth\n\"comb\",2.5\n"),
    "\"p.csv\": line 2, column teeth is 2.5 where an integer is expected.");
  EXPECT_EQ(ComplaintAbout("family,teeth\nmaze,2\n"),
    "\"p.csv\": line 2, column teeth does not apply here: it is a key of the family comb.");
  EXPECT_EQ(ComplaintAbout("family,points\npoints,0 0; 1 0; 0 one\n"),
    "\"p.csv\": line 2, column points[2] is \"one\" where a number is expected.");
  EXPECT_NE(ComplaintAbout("family,name\n,x\n").find("line 2, column family is missing"),
    std::string::npos);
  EXPECT_EQ(ComplaintAbout("family,scal\ncomb,1\n"),
    "\"p.csv\", line 1, has the column \"scal\"; did you mean scale?.");
  EXPECT_EQ(
    ComplaintAbout("family,family\n"), "\"p.csv\", line 1, names the column \"family\" twice.");
  EXPECT_EQ(ComplaintAbout("family,scale\ncomb\n"),
    "\"p.csv\", line 2, has 1 fields where the header has 2.");
  EXPECT_EQ(ComplaintAbout("Comb NONE 0.5 0.5 0 1\nComb NONE 0.5 0.5 zero 1\n"),
    "\"p.csv\": line 2, column rotation is \"zero\" where a number is expected.");
  EXPECT_EQ(ComplaintAbout("Comb NONE 0.5\n"),
    "\"p.csv\": line 1 has 3 words where a header, or class, file or NONE, centre x, centre y, "
    "rotation and scale are expected.");
  EXPECT_EQ(ComplaintAbout("Random NONE 0.5 0.5 0 1\n"),
    "\"p.csv\": line 1, column class is Random without a file.");
  EXPECT_NE(ComplaintAbout("Kite NONE 0.5 0.5 0 1\n").find("class is Kite, which is none of"),
    std::string::npos);
}

} // namespace
