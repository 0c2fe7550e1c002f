// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshFormats.h"

#include "CaseStatus.h"
#include "TestMeshes.h"

#include <limits>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <gmock/gmock.h>

using namespace pemesh;

namespace
{

/** A file as other programs write it, in text. */
std::string TextVtp(const std::string& points, const std::string& connectivity,
  const std::string& offsets, const std::string& type = "Float32")
{
  return "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n<PolyData>\n"
         "<Piece NumberOfPoints=\"4\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
         "NumberOfPolys=\"2\">\n<Points><DataArray type=\"" +
    type + "\" NumberOfComponents=\"3\" format=\"ascii\">" + points +
    "</DataArray></Points>\n<Polys><DataArray type=\"Int64\" Name=\"connectivity\" "
    "format=\"ascii\">" +
    connectivity + "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" +
    offsets + "</DataArray></Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

constexpr const char* SquarePoints = "0 0 0 1 0 0 1 1 0 0 1 -0";

std::string Failure(const std::string& text)
{
  const std::filesystem::path path = TestFolder() / "mesh.vtp";
  WriteBytes(path, text);
  try
  {
    ReadMesh(path);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "no failure";
}

} // namespace

TEST(VtpFormat, KeepsAllArrays)
{
  const auto mesh = MakeHouse();
  vtkNew<vtkDoubleArray> metric;
  metric->SetName("Area");
  for (const double value : { 0.1, std::numeric_limits<double>::quiet_NaN(), -0.0 })
  {
    metric->InsertNextValue(value);
  }
  mesh->GetCellData()->AddArray(metric);
  vtkNew<vtkStringArray> labels;
  labels->SetName("PolygonName");
  for (const char* label : { "polygon 1 (comb)", "größe <&>", "" })
  {
    labels->InsertNextValue(label);
  }
  mesh->GetCellData()->AddArray(labels);
  vtkNew<vtkIntArray> ids;
  ids->SetName("Id");
  for (int i = 0; i < 6; ++i)
  {
    ids->InsertNextValue(-i);
  }
  mesh->GetPointData()->AddArray(ids);
  SetFieldNumber(mesh, "t", 1.0 / 3.0);
  SetFieldText(mesh, "Mesh", "000_0");
  AddToFieldList(mesh, ParametersList, "t");

  const std::filesystem::path path = TestFolder() / "mesh.vtp";
  WriteMesh(path, mesh);
  const auto again = ReadMesh(path);
  ExpectSameMesh(again, mesh);
  auto* area = vtkDoubleArray::SafeDownCast(again->GetCellData()->GetArray("Area"));
  ASSERT_TRUE(area);
  EXPECT_EQ(area->GetValue(0), 0.1);
  EXPECT_TRUE(std::isnan(area->GetValue(1)));
  EXPECT_TRUE(std::signbit(area->GetValue(2)));
  auto* names = vtkStringArray::SafeDownCast(again->GetCellData()->GetAbstractArray("PolygonName"));
  ASSERT_TRUE(names);
  EXPECT_EQ(names->GetValue(1), "größe <&>");
  EXPECT_EQ(again->GetPointData()->GetArray("Id")->GetTuple1(5), -5.0);
  EXPECT_EQ(GetFieldNumber(again, "t"), 1.0 / 3.0);
  EXPECT_EQ(GetFieldText(again, "Mesh"), "000_0");
  EXPECT_TRUE(IsInFieldList(again, ParametersList, "t"));
}

TEST(VtpFormat, TheTimeOfTheRequestIsNoPartOfTheFile)
{
  const std::filesystem::path folder = TestFolder();
  const auto mesh = MakeHouse();
  WriteMesh(folder / "a.vtp", mesh);
  mesh->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), 0.5);
  WriteMesh(folder / "b.vtp", mesh);
  EXPECT_EQ(ReadBytes(folder / "a.vtp"), ReadBytes(folder / "b.vtp"));
  EXPECT_TRUE(mesh->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP())); // left alone
}

TEST(VtpFormat, HasNoAppendedDataWhichParaViewCannotRead)
{
  using testing::HasSubstr;
  const auto path = TestFolder() / "square.vtp";
  WriteMesh(path, MakeHouse());
  const std::string bytes = ReadBytes(path);
  EXPECT_THAT(bytes, HasSubstr("format=\"binary\""));
  EXPECT_THAT(bytes, testing::Not(HasSubstr("appended")));
}

TEST(VtpFormat, ArraysMayHoldInfinity)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const auto mesh = MakeHouse();
  for (const int components : { 1, 2 })
  {
    vtkNew<vtkDoubleArray> values;
    values->SetName(components == 1 ? "number" : "vector");
    values->SetNumberOfComponents(components);
    values->SetNumberOfTuples(3);
    values->Fill(1e300); // whose square is infinite
    values->SetValue(0, infinity);
    mesh->GetCellData()->AddArray(values);
  }
  for (const char* name : { "mesh.vtp", "mesh.vtu" })
  {
    const std::filesystem::path path = TestFolder() / name;
    WriteMesh(path, mesh);
    const auto again = ReadMesh(path);
    EXPECT_EQ(again->GetCellData()->GetArray("number")->GetTuple1(0), infinity);
    EXPECT_EQ(again->GetCellData()->GetArray("vector")->GetComponent(2, 1), 1e300);
  }
}

TEST(VtpFormat, AFailedCaseKeepsItsStatus)
{
  vtkNew<vtkPolyData> mesh;
  SetCaseFailed(mesh, "meshing-failed", "It did not work.");
  const std::filesystem::path path = TestFolder() / "mesh.vtp";
  WriteMesh(path, mesh);
  const auto again = ReadMesh(path);
  EXPECT_EQ(again->GetNumberOfCells(), 0);
  EXPECT_EQ(GetCaseStatus(again), "meshing-failed");
  EXPECT_EQ(GetCaseStatusMessage(again), "It did not work.");
}

TEST(VtpFormat, ReadsFloatsOfOtherProgramsAsDoublesCounterClockwise)
{
  const std::filesystem::path path = TestFolder() / "mesh.vtp";
  WriteBytes(path, TextVtp(SquarePoints, "0 2 1 0 2 3", "3 6"));
  ExpectSameMesh(ReadMesh(path),
    MakeTestMesh({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, { { 0, 1, 2 }, { 0, 2, 3 } }));
}

TEST(VtpFormat, RefusesWhatIsNoPlanarMesh)
{
  using testing::HasSubstr;
  EXPECT_THAT(Failure(TextVtp("0 0 0 1 0 0 1 1 0 0 1 1", "0 1 2 0 2 3", "3 6")),
    HasSubstr("vertex, 3, that is not"));
  EXPECT_THAT(Failure(TextVtp("0 0 0 1 nan 0 1 1 0 0 1 0", "0 1 2 0 2 3", "3 6", "Float64")),
    testing::Not(HasSubstr("no failure")));
  EXPECT_THAT(Failure(TextVtp(SquarePoints, "0 1 2 0 2 4", "3 6")), HasSubstr("vertex 4"));
  EXPECT_THAT(Failure(TextVtp(SquarePoints, "0 1 2 0 2 -3", "3 6")), HasSubstr("vertex -3"));
  EXPECT_THAT(Failure(TextVtp(SquarePoints, "0 1 2 0 2 3", "3 60")), HasSubstr("mesh.vtp"));
  EXPECT_THAT(Failure(TextVtp(SquarePoints, "0 1 2 0 2 3", "4 3")), HasSubstr("mesh.vtp"));
  EXPECT_THAT(Failure(TextVtp(SquarePoints, "0 1 2 3 0 1", "2 6")), HasSubstr("fewer than three"));
  const std::string whole = TextVtp(SquarePoints, "0 1 2 0 2 3", "3 6");
  EXPECT_THAT(Failure(whole.substr(0, whole.size() / 2)), HasSubstr("cannot be read as VTP"));
}

TEST(VtpFormat, RefusesATruncatedFileOfItsOwn)
{
  const std::filesystem::path path = TestFolder() / "mesh.vtp";
  WriteMesh(path, MakeJitteredGrid(4, 1));
  const std::string whole = ReadBytes(path);
  for (std::size_t size = 0; size + 40 < whole.size(); size += 97)
  {
    WriteBytes(path, std::string_view(whole).substr(0, size));
    EXPECT_THROW(ReadMesh(path), std::runtime_error) << size;
  }
}
