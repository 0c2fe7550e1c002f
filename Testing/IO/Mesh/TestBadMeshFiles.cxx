// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Files that are no meshes: each gives one sentence that names the file, the line where there is
 * one, and the reason; none is taken for a mesh, none ends the program, none takes memory.
 */
#include "MeshFormats.h"

#include "TestMeshes.h"

#include <gmock/gmock.h>

using namespace pemesh;

namespace
{

struct BadFile
{
  const char* Label;
  const char* FileName;
  std::string Text;
  const char* Where;  // "" where the file as a whole is wrong
  const char* Reason; // a part of the sentence
};

void PrintTo(const BadFile& file, std::ostream* stream)
{
  *stream << file.Label;
}

const std::string Vertices = "0 0 0\n1 0 0\n0 1 0\n";
using std::string_literals::operator""s;

const BadFile BadFiles[] = {
  { "Empty", "m.off", "", "line 1", "the word OFF is expected" },
  { "OnlyBlankLines", "m.off", "\n\r\n  \t\n# nothing\n", "line 5", "the word OFF is expected" },
  { "NoHeader", "m.off", "3 1 0\n" + Vertices + "3 0 1 2\n", "line 1", "must begin with" },
  { "FourDimensions", "m.off", "4OFF\n3 1 0\n", "line 1", "must begin with" },
  { "OtherFormat", "m.off", "ply\nformat ascii 1.0\n", "line 1", "must begin with" },
  { "BinaryOff", "m.off", "OFF BINARY\n\1\2\3", "line 1", "binary OFF" },
  { "HeaderAlone", "m.off", "OFF\n", "line 2", "number of vertices" },
  { "OneCount", "m.off", "OFF\n3\n" + Vertices, "line 2", "number of faces" },
  { "CountsOfText", "m.off", "OFF\nthree one 0\n", "line 2", "\"three\" is not the number" },
  { "NegativeCount", "m.off", "OFF\n-3 1 0\n", "line 2", "-3 vertices" },
  { "NoFaces", "m.off", "OFF\n3 0 0\n" + Vertices, "line 2", "0 faces" },
  { "HugeVertexCount", "m.off", "OFF\n1000000000000000000 1 0\n0 0 0\n", "line 4", "1 vertex of" },
  { "HugeFaceCount", "m.off", "OFF\n3 1000000000000000000 0\n" + Vertices + "3 0 1 2\n", "line 7",
    "1 face of" },
  { "CountBeyondIntegers", "m.off", "OFF\n100000000000000000000 1 0\n", "line 2", "is not" },
  { "HugeFace", "m.off", "OFF\n3 1 0\n" + Vertices + "1000000000000000000 0 1 2\n", "line 6",
    "the line ends" },
  { "TruncatedInVertices", "m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n", "line 5", "2 vertices of the 3" },
  { "TruncatedInLine", "m.off", "OFF\n3 1 0\n0 0 0\n1 0", "line 4", "the line ends" },
  { "TruncatedInFaces", "m.off", "OFF\n3 2 0\n" + Vertices + "3 0 1 2\n", "line 7", "1 face of" },
  { "TooManyFaces", "m.off", "OFF\n3 1 0\n" + Vertices + "3 0 1 2\n3 0 2 1\n", "line 7",
    "goes on" },
  { "FewerVerticesThanAnnounced", "m.off", "OFF\n4 1 0\n" + Vertices + "3 0 1 2\n", "line 6",
    "third coordinate" },
  { "Rubbish", "m.off", "OFF\n3 1 0\n" + Vertices + "3 0 1 2\nrubbish\n", "line 7", "goes on" },
  { "RubbishAfterFace", "m.off", "OFF\n3 1 0\n" + Vertices + "3 0 1 2 red\n", "line 6", "\"red\"" },
  { "WrongIndex", "m.off", "OFF\n3 1 0\n" + Vertices + "3 0 1 3\n", "line 6",
    "vertices are 0 to 2" },
  { "NegativeIndex", "m.off", "OFF\n3 1 0\n" + Vertices + "3 0 1 -1\n", "line 6", "vertex -1" },
  { "FractionalIndex", "m.off", "OFF\n3 1 0\n" + Vertices + "3 0 1 1.5\n", "line 6", "\"1.5\"" },
  { "TwoVertices", "m.off", "OFF\n3 1 0\n" + Vertices + "2 0 1\n", "line 6",
    "2 vertices and needs" },
  { "OneVertex", "m.off", "OFF\n3 1 0\n" + Vertices + "1 0\n", "line 6", "1 vertex and needs" },
  { "NaN", "m.off", "OFF\n3 1 0\n0 0 0\nnan 0 0\n", "line 4", "finite" },
  { "Infinity", "m.off", "OFF\n3 1 0\n0 0 0\n0 -inf 0\n", "line 4", "finite" },
  { "BeyondDoubles", "m.off", "OFF\n3 1 0\n0 0 0\n0 1e999 0\n", "line 4", "\"1e999\"" },
  { "DecimalComma", "m.off", "OFF\n3 1 0\n0,5 0 0\n", "line 3", "\"0,5\"" },
  { "Spatial", "m.off", "OFF\n3 1 0\n0 0 0.25\n", "line 3", "\"0.25\"" },
  { "TwoCoordinates", "m.off", "OFF\n3 1 0\n0 0\n1 0\n0 1\n3 0 1 2\n", "line 3", "the line ends" },
  { "ZeroBytes", "m.off", "OFF\n3 1 0\n0 0 0\n\0\0\0\0 1 0"s, "line 4", "\"????\"" },
  { "LongWord", "m.off", "OFF\n3 1 0\n" + std::string(100000, 'x'), "line 3", "xxx…" },
  { "ObjEmpty", "m.obj", "", "", "no face" },
  { "ObjWithoutFaces", "m.obj", "v 0 0 0\nv 1 0 0\n", "", "2 vertices and no face" },
  { "ObjWrongIndex", "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n# end\n", "line 4", "vertex 4" },
  { "ObjIndexZero", "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "line 4", "count from 1" },
  { "ObjBackTooFar", "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n", "line 4", "vertex -4" },
  { "ObjTwoVertices", "m.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", "line 3", "2 vertices and needs" },
  { "ObjBadCorner", "m.obj", "v 0 0 0\nf 1/x 1 1\n", "line 2", "\"1/x\"" },
  { "ObjFourParts", "m.obj", "v 0 0 0\nf 1/1/1/1 1 1\n", "line 2", "\"1/1/1/1\"" },
  { "ObjUnknownStatement", "m.obj", "v 0 0 0\nface 1 2 3\n", "line 2", "no statement" },
  { "ObjSpatial", "m.obj", "v 0 0 1\n", "line 1", "planar" },
  { "ObjSmallestInteger", "m.obj", "v 0 0 0\nf -9223372036854775808 1 1\n", "line 2", "known" },
  { "ObjLargestInteger", "m.obj", "v 0 0 0\nf 9223372036854775807 1 1\n", "line 2",
    "vertex 92233" },
  { "ObjBinary", "m.obj", "\x89PNG\r\n\x1a\n", "line 1", "no statement" },
  { "StlEmpty", "m.stl", "", "", "neither" },
  { "StlNoTriangles", "m.stl", "solid x\nendsolid x\n", "", "no triangles" },
  { "StlTruncated", "m.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "line 5",
    "the file ends" },
  { "StlFourCorners", "m.stl",
    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 "
    "0\n",
    "line 7", "endloop" },
  { "StlBinaryTruncated", "m.stl", std::string(80, ' ') + "\x02\0\0\0"s + std::string(60, '\0'), "",
    "neither" },
  { "StlBinaryHuge", "m.stl", std::string(80, ' ') + "\xff\xff\xff\xff", "", "neither" },
  { "StlBinarySpatial", "m.stl", std::string(80, ' ') + "\1\0\0\0"s + std::string(50, '@'), "",
    "triangle 1" },
  { "VtpEmpty", "m.vtp", "", "", "cannot be read as VTP" },
  { "VtpText", "m.vtp", "OFF\n3 1 0\n", "", "cannot be read as VTP" },
  { "VtpOtherXml", "m.vtp", "<?xml version=\"1.0\"?><html><body/></html>", "",
    "cannot be read as VTP" },
  { "VtpOtherData", "m.vtp",
    "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\"><UnstructuredGrid/></VTKFile>", "",
    "cannot be read as VTP" },
  { "UnknownExtension", "m.ply", "ply\n", "", "no extension of a mesh file" },
};

} // namespace

class BadMeshFiles : public testing::TestWithParam<BadFile>
{
};

TEST_P(BadMeshFiles, AreRefusedInOneSentence)
{
  const BadFile& bad = GetParam();
  const std::filesystem::path path = TestFolder() / bad.FileName;
  WriteBytes(path, bad.Text);
  std::string message = "nothing";
  try
  {
    ReadMesh(path);
  }
  catch (const std::runtime_error& error)
  {
    message = error.what();
  }
  EXPECT_THAT(message, testing::HasSubstr(path.string()));
  EXPECT_THAT(message, testing::HasSubstr(bad.Where));
  EXPECT_THAT(message, testing::HasSubstr(bad.Reason));
  EXPECT_THAT(message, testing::EndsWith("."));
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_LT(message.size(), path.string().size() + 300);
}

INSTANTIATE_TEST_SUITE_P(Files, BadMeshFiles, testing::ValuesIn(BadFiles),
  [](const auto& test) { return test.param.Label; });

TEST(BadMeshFiles, MissingFilesAndFoldersAreNamed)
{
  const std::filesystem::path folder = TestFolder();
  for (const char* name :
    { "missing.off", "missing.obj", "missing.node", "missing.stl", "missing.vtp" })
  {
    EXPECT_THAT([&] { ReadMesh(folder / name); },
      testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr(name)));
    std::filesystem::create_directories(folder / "folder" / name);
    EXPECT_THAT([&] { ReadMesh(folder / "folder" / name); },
      testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("is a folder")));
  }
}
