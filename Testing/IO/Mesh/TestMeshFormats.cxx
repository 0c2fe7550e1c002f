// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshFormats.h"

#include "TestMeshes.h"

#include <algorithm>
#include <clocale>

#include <gmock/gmock.h>

using namespace pemesh;

namespace
{

vtkSmartPointer<vtkPolyData> ReadText(const std::string& name, const std::string& text)
{
  const std::filesystem::path path = TestFolder() / name;
  WriteBytes(path, text);
  return ReadMesh(path);
}

} // namespace

/** The names of the formats that hold any mesh: every bit of it comes back. */
std::vector<std::string> FaithfulFormats()
{
  std::vector<std::string> names;
  for (const MeshFormat& format : MeshFormats())
  {
    if (format.KeepsVertices && format.MostCorners == 0)
    {
      names.emplace_back(format.Name);
    }
  }
  return names;
}

std::string TestName(const testing::TestParamInfo<std::string>& test)
{
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

class RoundTrip : public testing::TestWithParam<std::string>
{
protected:
  void Check(vtkPolyData* mesh)
  {
    const MeshFormat* format = FindMeshFormat(GetParam());
    ASSERT_TRUE(format && format->KeepsVertices);
    const std::filesystem::path folder = TestFolder();
    const std::filesystem::path path = folder / ("mesh" + std::string(format->Extensions[0]));
    format->Write(path, mesh);
    ExpectSameMesh(ReadMesh(path), mesh);
    // The second writing is the same to the byte.
    const std::filesystem::path again = folder / ("again" + std::string(format->Extensions[0]));
    format->Write(again, ReadMesh(path));
    EXPECT_EQ(ReadBytes(again), ReadBytes(path));
  }
};

TEST_P(RoundTrip, House)
{
  this->Check(MakeHouse());
}

TEST_P(RoundTrip, AwkwardNumbers)
{
  this->Check(MakeAwkwardMesh());
}

TEST_P(RoundTrip, JitteredGrid)
{
  this->Check(MakeJitteredGrid(40, 7));
}

TEST_P(RoundTrip, OneTriangle)
{
  this->Check(MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 0, 1 } }, { { 2, 0, 1 } }));
}

TEST_P(RoundTrip, ElementOfManyVertices)
{
  std::vector<Point2> circle;
  std::vector<vtkIdType> polygon;
  constexpr int sides = 10000;
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * i / sides;
    circle.push_back({ std::cos(angle), std::sin(angle) });
    polygon.push_back(i);
  }
  this->Check(MakeTestMesh(circle, { polygon }));
}

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip, testing::ValuesIn(FaithfulFormats()), TestName);

TEST(MeshFormats, AreListedInTheReadme)
{
  EXPECT_THAT(ReadBytes(std::filesystem::path(PEMESH_SOURCE_DIR) / "IO" / "Mesh" / "README.md"),
    testing::HasSubstr(DescribeMeshFormats()));
}

TEST(MeshFormats, SayHowManyElementsTheyCut)
{
  EXPECT_EQ(CountElementsToCut(*FindMeshFormat("stl"), MakeHouse()), 1); // of three
  EXPECT_EQ(CountElementsToCut(*FindMeshFormat("off"), MakeHouse()), 0);
}

TEST(MeshFormats, AreFoundByNameAndByExtension)
{
  EXPECT_STREQ(FindMeshFormatOfFile("a/b.c/M.OFF")->Name, "off");
  EXPECT_STREQ(FindMeshFormatOfFile("M.ele")->Name, "node");
  EXPECT_STREQ(FindMeshFormatOfFile("M.node")->Name, "node");
  EXPECT_STREQ(FindMeshFormat("node-plain")->Name, "node-plain");
  EXPECT_EQ(FindMeshFormatOfFile("off"), nullptr);
  EXPECT_EQ(FindMeshFormatOfFile("M.of"), nullptr);
  EXPECT_EQ(FindMeshFormat("OFF"), nullptr);
  EXPECT_EQ(FindMeshFormat(""), nullptr);
}

TEST(MeshFormats, OffWithEverythingThatGeomviewAllows)
{
  const auto mesh = ReadText("mesh.off",
    "# a comment\r\n\r\nOFF 4\t2 5 # counts on the line of the header\r\n"
    "0 0 0\r\n   1.0 0.0 -0   # a vertex\r\n\r\n#\r\n+1 1e0 0\n0 1 0.0\n"
    "3 0 1 2 255 0 0\n\n3\t0  2 3 0.1 0.2 0.3 1\r# old ends of lines\r");
  ExpectSameMesh(
    mesh, MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, { { 0, 1, 2 }, { 0, 2, 3 } }));
}

TEST(MeshFormats, OffWithCountsOnTheNextLineOrWithoutEdges)
{
  const auto expected = MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 0, 1 } }, { { 0, 1, 2 } });
  ExpectSameMesh(ReadText("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2"), expected);
  ExpectSameMesh(ReadText("b.off", "OFF\n\n3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2"), expected);
}

TEST(MeshFormats, OffWithCountsOnLinesOfTheirOwn)
{
  const auto expected = MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 0, 1 } }, { { 0, 1, 2 } });
  const std::string rest = "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2";
  ExpectSameMesh(ReadText("a.off", "OFF\n3\n1\n0" + rest), expected);
  ExpectSameMesh(ReadText("b.off", "OFF 3\n# faces\n1" + rest), expected);
  ExpectSameMesh(ReadText("c.off", "OFF\n3 1\n\n0" + rest), expected);
}

TEST(MeshFormats, OffWithOtherHeadsOrNone)
{
  const auto expected = MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 0, 1 } }, { { 0, 1, 2 } });
  const std::string plain = "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string many = "3 1 0\n0 0 0 .1 .2 .3 1 0 0 1 0 1\n1 0 0 1 1 1 1 0 0 1 1 1\n"
                           "0 1 0 0 0 0 0 0 0 1 0.5 0.5\n3 0 1 2 7\n";
  ExpectSameMesh(ReadText("a.off", plain), expected);
  ExpectSameMesh(ReadText("b.off", "\xEF\xBB\xBFoff\n" + plain), expected);
  for (const std::string head : { "STOFF", "STCNOFF", "CNOFF" })
  {
    ExpectSameMesh(ReadText("c.off", head + "\n" + many), expected);
  }
}

TEST(MeshFormats, OffWithColoursAndNormalsOfVertices)
{
  const auto expected = MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 0, 1 } }, { { 0, 1, 2 } });
  ExpectSameMesh(
    ReadText("a.off", "COFF 3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 0 0 0\n0 1 0 1 1 1 1\n3 0 1 2\n"),
    expected);
  ExpectSameMesh(
    ReadText("b.off", "NOFF 3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n"), expected);
}

TEST(MeshFormats, ObjWithEverythingThatIsCommon)
{
  const auto mesh = ReadText("mesh.obj",
    "# made by hand\nmtllib a.mtl\no square\nv 0 0 0\nv 1 0 0 1.0\nvt 0 0\nvn 0 0 1\n"
    "v 1 1 0 0.5 0.5 0.5\nv 0 1 0\ng one\nusemtl red\ns off\n"
    "f 1//1 2//1 3//1\nf -4/1/1 -2/1 \\\n  -1\nl 1 2\n");
  ExpectSameMesh(
    mesh, MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, { { 0, 1, 2 }, { 0, 2, 3 } }));
}

TEST(MeshFormats, ObjFacesMayComeBeforeTheirVertices)
{
  ExpectSameMesh(ReadText("mesh.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"),
    MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 0, 1 } }, { { 0, 1, 2 } }));
}

TEST(MeshFormats, ClockwiseElementsAreReversedAndOthersNot)
{
  const auto mesh =
    ReadText("mesh.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 2 1\n3 2 3 0\n");
  EXPECT_EQ(PolygonsOf(mesh), (TestPolygons{ { 0, 1, 2 }, { 2, 3, 0 } }));
}

TEST(MeshFormats, NeedlesAreTurnedOnlyIfTheyAreClockwise)
{
  // One bit beside the line through (12, 12) and (24, 24), where differences round to a straight
  // line (Kettner et al., Classroom examples of robustness problems, Comput. Geom. 40 (2008)).
  const double above = std::nextafter(0.5, 1.0);
  const std::filesystem::path path = TestFolder() / "needle.off";
  const auto left = MakeTestMesh({ { 0.5, above }, { 12, 12 }, { 24, 24 } }, { { 0, 1, 2 } });
  WriteMesh(path, left);
  ExpectSameMesh(ReadMesh(path), left);
  const auto right = MakeTestMesh({ { above, 0.5 }, { 12, 12 }, { 24, 24 } }, { { 0, 1, 2 } });
  WriteMesh(path, right);
  EXPECT_EQ(PolygonsOf(ReadMesh(path)), (TestPolygons{ { 0, 2, 1 } }));

  // Without an area there is nothing to turn.
  const auto flat = MakeTestMesh({ { 0, 0 }, { 1, 1 }, { 0.5, 0.5 } }, { { 0, 1, 2 } });
  WriteMesh(path, flat);
  ExpectSameMesh(ReadMesh(path), flat);
}

TEST(MeshFormats, DoNotDependOnTheLocale)
{
  // Whichever of these is installed has a decimal comma; the default one is compared in any case.
  const char* const locales[] = { "", "de_DE.UTF-8", "fr_FR.UTF-8", "it_IT.UTF-8" };
  const std::filesystem::path folder = TestFolder();
  const auto mesh = MakeAwkwardMesh();
  WriteMesh(folder / "before.off", mesh);
  for (const char* locale : locales)
  {
    std::setlocale(LC_ALL, locale);
    WriteMesh(folder / "after.off", mesh);
    const auto again = ReadMesh(folder / "after.off");
    std::setlocale(LC_ALL, "C");
    EXPECT_EQ(ReadBytes(folder / "after.off"), ReadBytes(folder / "before.off"));
    ExpectSameMesh(again, mesh);
  }
}

TEST(MeshFormats, PathsMayHoldBlanksQuotesAndUnicode)
{
  const std::filesystem::path folder = TestFolder() / "a b'c\"d" / "größe – 网格";
  for (const char* name : { "m x.off", "m.x.obj", "m'.node", "\"m\".vtp" })
  {
    WriteMesh(folder / name, MakeHouse());
    ExpectSameMesh(ReadMesh(folder / name), MakeHouse());
  }
}

TEST(MeshFormats, RefuseToWriteWhatIsNoMesh)
{
  const std::filesystem::path path = TestFolder() / "mesh.off";
  const auto fails = [&](vtkPolyData* mesh, const std::string& reason)
  {
    EXPECT_THAT([&] { WriteMesh(path, mesh); },
      testing::ThrowsMessage<std::runtime_error>(
        testing::AllOf(testing::HasSubstr(path.string()), testing::HasSubstr(reason))));
    EXPECT_FALSE(std::filesystem::exists(path));
  };
  fails(vtkSmartPointer<vtkPolyData>::New(), "no polygons");
  fails(MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 0, 1 } }, { { 0, 1, 3 } }), "vertex 3");
  fails(MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 0, 1 } }, { { 0, 1 } }), "fewer than three");
  fails(MakeTestMesh({ { 0, 0 }, { NAN, 0 }, { 0, 1 } }, { { 0, 1, 2 } }), "vertex 1");
  const auto spatial = MakeHouse();
  spatial->GetPoints()->SetPoint(4, 1.0, 0.0, 1e-9);
  fails(spatial, "vertex 4");
  EXPECT_THAT([] { WriteMesh("mesh.xyz", MakeHouse()); },
    testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr(".off .obj .node .ele")));
}

TEST(MeshFormats, SayWhenTheDiskRefuses)
{
  const std::filesystem::path folder = TestFolder();
  WriteBytes(folder / "file", "in the way");
  for (const char* name : { "file/mesh.off", "file/mesh.vtp" })
  {
    EXPECT_THAT([&] { WriteMesh(folder / name, MakeHouse()); },
      testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("file")));
  }
  std::filesystem::create_directories(folder / "folder.off");
  EXPECT_THROW(WriteMesh(folder / "folder.off", MakeHouse()), std::runtime_error);
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    files += entry.exists() ? 1 : 0;
  }
  EXPECT_EQ(files, 2); // nothing half-written is left behind
}
