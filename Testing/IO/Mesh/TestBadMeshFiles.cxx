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

std::string PlyHead(const std::string& form, const std::string& vertices, const std::string& faces)
{
  return "ply\nformat " + form + " 1.0\nelement vertex " + vertices +
    "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
    "\nproperty list uchar uchar vertex_indices\nend_header\n";
}

const std::string Gmsh2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string GmshNodes = "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n";
const std::string VtkHead = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n";
const std::string MatHead = "MATLAB 5.0 MAT-file" + std::string(105, ' ') + "\0\1IM"s;

const BadFile BadFiles[] = {
  { "Empty", "m.off", "", "line 1", "the word OFF is expected" },
  { "OnlyBlankLines", "m.off", "\n\r\n  \t\n# nothing\n", "line 5", "the word OFF is expected" },
  { "NoHeader", "m.off", "3.0 1 0\n" + Vertices + "3 0 1 2\n", "line 1", "must begin with" },
  { "FourDimensions", "m.off", "4OFF\n3 1 0\n", "line 1", "must begin with" },
  { "OtherFormat", "m.off", "ply\nformat ascii 1.0\n", "line 1", "must begin with" },
  { "BinaryOff", "m.off", "OFF BINARY\n\1\2\3", "line 1", "binary OFF" },
  { "HeaderAlone", "m.off", "OFF\n", "line 2", "number of vertices" },
  { "OneCount", "m.off", "OFF\n3\n0.5 0 0\n", "line 3", "number of faces" },
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
  { "StlBinaryNaN", "m.stl",
    std::string(80, ' ') + "\1\0\0\0"s + std::string(12, '\0') + "\0\0\xc0\x7f"s +
      std::string(34, '\0'),
    "", "triangle 1" },
  { "VtpEmpty", "m.vtp", "", "", "cannot be read as VTP" },
  { "VtpText", "m.vtp", "OFF\n3 1 0\n", "", "cannot be read as VTP" },
  { "VtpOtherXml", "m.vtp", "<?xml version=\"1.0\"?><html><body/></html>", "",
    "cannot be read as VTP" },
  { "VtpOtherData", "m.vtp",
    "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\"><UnstructuredGrid/></VTKFile>", "",
    "cannot be read as VTP" },
  { "VtpHuge", "m.vtp",
    "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"1000000000000\"/>", "",
    "more than it can hold" },
  { "VtuEmpty", "m.vtu", "", "", "cannot be read as VTU" },
  { "VtuOtherData", "m.vtu", "<VTKFile type=\"PolyData\" version=\"1.0\"><PolyData/></VTKFile>", "",
    "cannot be read as VTU" },
  { "VtuHuge", "m.vtu", "<VTKFile type=\"UnstructuredGrid\"><Piece NumberOfCells='99999999999'/>",
    "", "more than it can hold" },
  { "VtuBeyondIntegers", "m.vtu", "<VTKFile><Piece NumberOfCells='99999999999999999999'/>", "",
    "more than it can hold" },
  { "PlyEmpty", "m.ply", "", "line 1", "the word ply" },
  { "PlyOther", "m.ply", "OFF\n", "line 1", "begin with the word ply" },
  { "PlyForm", "m.ply", "ply\nformat utf8 1.0\n", "line 2", "none of ascii" },
  { "PlyType", "m.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\n", "line 4",
    "type that PLY" },
  { "PlyStatement", "m.ply", "ply\nformat ascii 1.0\nvertices 3\n", "line 3", "no statement" },
  { "PlyNoEnd", "m.ply", PlyHead("ascii", "3", "1").substr(0, 55), "",
    "line end_header is expected" },
  { "PlyNegative", "m.ply", PlyHead("ascii", "-3", "1"), "line 3", "negative" },
  { "PlyNoFaces", "m.ply", PlyHead("ascii", "3", "0") + Vertices, "", "declares no faces" },
  { "PlyHuge", "m.ply", PlyHead("ascii", "1000000000000", "1") + Vertices, "line 13",
    "the file ends" },
  { "PlyHugeFaces", "m.ply", PlyHead("ascii", "3", "1000000000000") + Vertices + "3 0 1 2\n",
    "line 14", "the file ends" },
  { "PlyNaN", "m.ply", PlyHead("ascii", "3", "1") + "0 nan 0\n", "line 10", "finite" },
  { "PlySpatial", "m.ply", PlyHead("ascii", "3", "1") + "0 0 1\n", "line 10", "z = 0" },
  { "PlyIndex", "m.ply", PlyHead("ascii", "3", "1") + Vertices + "3 0 1 3\n", "line 13", "0 to 2" },
  { "PlyNegativeIndex", "m.ply", PlyHead("ascii", "3", "1") + Vertices + "3 0 1 -1\n", "line 13",
    "vertex -1" },
  { "PlyGoesOn", "m.ply", PlyHead("ascii", "3", "1") + Vertices + "3 0 1 2\n3 0 1 2\n", "line 14",
    "goes on" },
  { "PlyBinaryTruncated", "m.ply", PlyHead("binary_little_endian", "3", "1") + "abc", "", "ends" },
  { "PlyBinaryHuge", "m.ply",
    PlyHead("binary_big_endian", "1000000000000", "1") + std::string(100, '\0'), "", "ends" },
  { "PlyBinaryNaN", "m.ply",
    PlyHead("binary_little_endian", "3", "1") + "\0\0\xc0\x7f"s + std::string(100, '\0'), "",
    "not finite" },
  { "PlyBinaryCorners", "m.ply",
    PlyHead("binary_little_endian", "3", "1") + std::string(36, '\0') + "\xff\1\1", "", "ends" },
  { "GmshEmpty", "m.msh", "", "line 1", "$MeshFormat" },
  { "GmshOther", "m.msh", "$NOD\n3\n", "line 1", "must begin" },
  { "GmshVersion", "m.msh", "$MeshFormat\n4 0 8\n", "line 2", "none of 2.2" },
  { "GmshBinary", "m.msh", "$MeshFormat\n4.1 1 8\n\1\0\0\0\n"s, "line 2", "binary" },
  { "GmshHuge", "m.msh", Gmsh2 + "$Nodes\n1000000000000\n1 0 0 0\n", "line 7", "the file ends" },
  { "GmshNegative", "m.msh", Gmsh2 + "$Nodes\n-4\n", "line 5", "negative" },
  { "GmshTwice", "m.msh", Gmsh2 + "$Nodes\n2\n1 0 0 0\n1 1 0 0\n$EndNodes\n", "line 7",
    "the number 1" },
  { "GmshUnknownNode", "m.msh", Gmsh2 + GmshNodes + "$Elements\n1\n1 2 0 1 2 4\n", "line 12",
    "node 4" },
  { "GmshVolume", "m.msh", Gmsh2 + GmshNodes + "$Elements\n1\n1 4 0 1 2 3 3\n", "line 12",
    "type 4" },
  { "GmshLinesOnly", "m.msh", Gmsh2 + GmshNodes + "$Elements\n1\n1 1 0 1 2\n$EndElements\n", "",
    "no triangles" },
  { "GmshNaN", "m.msh", Gmsh2 + "$Nodes\n1\n1 nan 0 0\n", "line 6", "finite" },
  { "GmshSpatial", "m.msh", Gmsh2 + "$Nodes\n1\n1 0 0 3\n", "line 6", "planar" },
  { "GmshUnfinished", "m.msh", Gmsh2 + "$Comments\nx\n", "line 6", "$EndComments" },
  { "GmshRubbish", "m.msh", Gmsh2 + "rubbish\n", "line 4", "should begin with $" },
  { "VtkEmpty", "m.vtk", "", "", "does not begin" },
  { "VtkForm", "m.vtk", "# vtk DataFile Version 3.0\nt\nTEXT\n", "line 3", "ASCII or BINARY" },
  { "VtkOtherData", "m.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET RECTILINEAR_GRID\n",
    "line 4", "POLYDATA" },
  { "VtkHuge", "m.vtk", VtkHead + "POINTS 1000000000000 double\n", "line 5", "does not hold" },
  { "VtkBinaryHuge", "m.vtk",
    "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET POLYDATA\nPOINTS 9 double\nabcdefghijkl",
    "line 6", "ends before" },
  { "VtkNegative", "m.vtk", VtkHead + "POINTS -1 double\n", "line 5", "-1" },
  { "VtkType", "m.vtk", VtkHead + "POINTS 1 quad\n0 0 0\n", "line 5", "not known" },
  { "VtkNaN", "m.vtk", VtkHead + "POINTS 1 double\n0 nan 0\n", "line 6", "finite" },
  { "VtkSpatial", "m.vtk", VtkHead + "POINTS 1 double\n0 0 1\n", "", "third coordinate" },
  { "VtkIndex", "m.vtk", VtkHead + "POINTS 3 double\n" + Vertices + "POLYGONS 1 4\n3 0 1 3\n", "",
    "0 to 2" },
  { "VtkSize", "m.vtk", VtkHead + "POINTS 3 double\n" + Vertices + "POLYGONS 1 4\n4 0 1 2 2\n", "",
    "do not fit" },
  { "VtkOffsets", "m.vtk",
    VtkHead + "POINTS 3 double\n" + Vertices +
      "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2\n",
    "", "offsets are wrong" },
  { "VtkFieldHuge", "m.vtk", VtkHead + "FIELD FieldData 1\nx 99 99 double\n", "line 6",
    "not hold" },
  { "VtkWord", "m.vtk", VtkHead + "SHAPES 3\n", "line 5", "no word" },
  { "MatEmpty", "m.mat", "", "", "no MAT file" },
  { "MatOctaveText", "m.mat", "# Created by Octave 7.3.0\n# name: node\n", "", "option -v7" },
  { "MatHdf5", "m.mat", "MATLAB 7.3 MAT-file" + std::string(500, ' '), "", "7.3 (HDF5)" },
  { "MatNothing", "m.mat", MatHead, "", "holds no mesh" },
  { "MatTruncated", "m.mat", MatHead + "\x0e\0\0\0\xff\xff\0\0"s, "", "damaged" },
  { "MatHuge", "m.mat",
    MatHead + "\x0e\0\0\0\x30\0\0\0\6\0\0\0\x08\0\0\0\6\0\0\0\0\0\0\0"s +
      "\5\0\0\0\x08\0\0\0\xff\xff\xff\x7f\xff\xff\xff\x7f\1\0\4\0node\x09\0\0\0\0\0\0\0"s,
    "", "damaged" },
  { "MatManyCells", "m.mat",
    MatHead + "\x0e\0\0\0\x28\0\0\0\6\0\0\0\x08\0\0\0\1\0\0\0\0\0\0\0"s +
      "\5\0\0\0\x08\0\0\0\xff\xff\xff\x3f\1\0\0\0\1\0\4\0elem"s,
    "", "damaged" },
  { "MatDimensionsOverflow", "m.mat", // four times 2^16
    MatHead + "\x0e\0\0\0\x38\0\0\0\6\0\0\0\x08\0\0\0\6\0\0\0\0\0\0\0"s +
      "\5\0\0\0\x10\0\0\0\0\0\1\0\0\0\1\0\0\0\1\0\0\0\1\0\1\0\4\0node\x09\0\0\0\0\0\0\0"s,
    "", "damaged" },
  { "MatBadZip", "m.mat", MatHead + "\x0f\0\0\0\x08\0\0\0abcdefgh"s, "", "damaged" },
  { "UnknownExtension", "m.xyz", "0 0 0\n", "", "no extension of a mesh file" },
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
  for (const char* name : { "missing.off", "missing.obj", "missing.node", "missing.stl",
         "missing.vtp", "missing.vtu", "missing.vtk", "missing.ply", "missing.msh", "missing.mat" })
  {
    EXPECT_THAT([&] { ReadMesh(folder / name); },
      testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr(name)));
    std::filesystem::create_directories(folder / "folder" / name);
    EXPECT_THAT([&] { ReadMesh(folder / "folder" / name); },
      testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("is a folder")));
  }
}
