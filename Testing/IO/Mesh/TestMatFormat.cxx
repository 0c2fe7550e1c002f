// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshFormats.h"

#include "TestMeshes.h"

#include <cmath>

#include <gmock/gmock.h>

#include <matio.h>

using namespace pemesh;

namespace
{

struct Matrix
{
  std::size_t Rows;
  std::vector<double> Values; // column by column
};

matvar_t* Make(const char* name, Matrix matrix)
{
  std::size_t dimensions[2] = { matrix.Rows, matrix.Values.size() / matrix.Rows };
  return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dimensions, matrix.Values.data(), 0);
}

matvar_t* MakeCells(const char* name, const std::vector<Matrix>& matrices)
{
  std::vector<matvar_t*> cells;
  for (const Matrix& matrix : matrices)
  {
    cells.push_back(Make(nullptr, matrix));
  }
  std::size_t dimensions[2] = { 1, cells.size() };
  return Mat_VarCreate(name, MAT_C_CELL, MAT_T_CELL, 2, dimensions, cells.data(), 0);
}

std::filesystem::path WriteFile(
  const std::vector<matvar_t*>& variables, matio_compression compression)
{
  std::filesystem::path path = TestFolder() / "mesh.mat";
  mat_t* file = Mat_CreateVer(path.c_str(), nullptr, MAT_FT_MAT5);
  for (matvar_t* variable : variables)
  {
    Mat_VarWrite(file, variable, compression);
    Mat_VarFree(variable);
  }
  Mat_Close(file);
  return path;
}

const Matrix Vertices{ 5, { 0, 1, 1, 0, 0.1, 0, 0, 1, 1, 1.0 / 3.0 } };

vtkSmartPointer<vtkPolyData> Expected()
{
  return MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 0.1, 1.0 / 3.0 } },
    { { 0, 1, 2, 4 }, { 4, 2, 3 } });
}

} // namespace

TEST(MatFormat, ReadsTheNamesOfTheField)
{
  const std::vector<Matrix> elements{ { 1, { 1, 2, 3, 5 } }, { 3, { 5, 3, 4 } } }; // row, column
  for (const auto compression : { MAT_COMPRESSION_NONE, MAT_COMPRESSION_ZLIB })
  {
    for (const auto& [first, second] :
      { std::pair("vertices", "elements"), { "node", "elem" }, { "Node", "Element" } })
    {
      ExpectSameMesh(ReadMesh(WriteFile({ Make("other", { 1, { 7 } }), Make(first, Vertices),
                                          MakeCells(second, elements) },
                       compression)),
        Expected());
    }
  }
}

TEST(MatFormat, ElementsMayBeAMatrixFilledUpWithNaN)
{
  const double nan = std::nan("");
  const Matrix elements{ 2, { 1, 5, 2, 3, 3, 4, 5, nan } };
  ExpectSameMesh(
    ReadMesh(WriteFile({ Make("node", Vertices), Make("elem", elements) }, MAT_COMPRESSION_NONE)),
    Expected());
}

TEST(MatFormat, WritesBothForms)
{
  const std::filesystem::path folder = TestFolder();
  FindMeshFormat("mat")->Write(folder / "a.mat", MakeHouse());
  FindMeshFormat("mat-node-elem")->Write(folder / "b.mat", MakeHouse());
  mat_t* a = Mat_Open((folder / "a.mat").c_str(), MAT_ACC_RDONLY);
  matvar_t* boundary = Mat_VarRead(a, "boundary");
  ASSERT_TRUE(boundary);
  EXPECT_EQ(boundary->dims[0], 6U); // all vertices, as a column
  EXPECT_EQ(boundary->dims[1], 1U);
  EXPECT_EQ(static_cast<const double*>(boundary->data)[5], 6.0);
  matvar_t* elements = Mat_VarRead(a, "elements");
  ASSERT_TRUE(elements);
  EXPECT_EQ(elements->class_type, MAT_C_CELL);
  EXPECT_EQ(elements->dims[0], 3U);
  const matvar_t* second = Mat_VarGetCell(elements, 1);
  EXPECT_EQ(second->dims[1], 3U);
  EXPECT_EQ(static_cast<const double*>(second->data)[1], 5.0);
  Mat_VarFree(elements);
  Mat_VarFree(boundary);
  Mat_Close(a);
  mat_t* b = Mat_Open((folder / "b.mat").c_str(), MAT_ACC_RDONLY);
  matvar_t* node = Mat_VarRead(b, "node");
  ASSERT_TRUE(node);
  EXPECT_EQ(node->dims[0], 6U);
  EXPECT_EQ(static_cast<const double*>(node->data)[6 + 2], 1.0); // y of the third vertex
  Mat_VarFree(node);
  Mat_Close(b);
}

TEST(MatFormat, RefusesWhatIsNoMesh)
{
  const auto fails = [](const std::vector<matvar_t*>& variables, const std::string& why)
  {
    const std::filesystem::path path = WriteFile(variables, MAT_COMPRESSION_ZLIB);
    EXPECT_THAT([&] { ReadMesh(path); },
      testing::ThrowsMessage<std::runtime_error>(
        testing::AllOf(testing::HasSubstr(path.string()), testing::HasSubstr(why))));
  };
  const std::vector<Matrix> good{ { 1, { 1, 2, 3 } } };
  fails({ Make("node", Vertices) }, "holds no mesh");
  fails({ Make("node", Vertices), MakeCells("elem", { { 1, { 1, 2, 6 } } }) }, "none of 1 to 5");
  fails({ Make("node", Vertices), MakeCells("elem", { { 1, { 0, 1, 2 } } }) }, "none of 1 to 5");
  fails({ Make("node", Vertices), MakeCells("elem", { { 1, { 1, 2, 2.5 } } }) }, "none of 1 to 5");
  fails({ Make("node", Vertices), MakeCells("elem", { { 1, { 1, 2 } } }) }, "fewer than three");
  fails({ Make("node", Vertices), MakeCells("elem", { { 2, { 1, 2, 3, 4 } } }) }, "no vector");
  fails({ Make("node", { 1, { 0, 1, 2, 3 } }), MakeCells("elem", good) }, "two columns");
  fails({ Make("node", { 2, { 0, 1, NAN, 3 } }), MakeCells("elem", good) }, "row 1 is no finite");
  fails({ Make("node", { 1, { 0, 1, 2 } }), MakeCells("elem", good) }, "row 1 is no finite");
}
