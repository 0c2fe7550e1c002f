// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMMeshWriter.h"

#include "ErrorLog.h"
#include "MeshFormats.h"
#include "TestMeshes.h"
#include "vtkPEMMeshReader.h"

#include <sstream>

#include <gmock/gmock.h>

using namespace pemesh;

TEST(MeshWriter, WritesInTheFormatOfTheExtension)
{
  const std::filesystem::path folder = TestFolder();
  for (const char* name : { "mesh.off", "mesh.obj", "mesh.node", "mesh.vtp" })
  {
    vtkNew<vtkPEMMeshWriter> writer;
    writer->SetInputData(MakeHouse());
    writer->SetFileName((folder / name).string());
    EXPECT_EQ(writer->Write(), 1);
    ExpectSameMesh(ReadMesh(folder / name), MakeHouse());
  }
}

TEST(MeshWriter, UpdatesItsPipeline)
{
  const std::filesystem::path folder = TestFolder();
  WriteMesh(folder / "in.off", MakeHouse());
  vtkNew<vtkPEMMeshReader> reader;
  reader->SetFileName((folder / "in.off").string());
  vtkNew<vtkPEMMeshWriter> writer;
  writer->SetInputConnection(reader->GetOutputPort());
  writer->SetFileName((folder / "out.obj").string());
  EXPECT_EQ(writer->Write(), 1);
  ExpectSameMesh(ReadMesh(folder / "out.obj"), MakeHouse());
}

TEST(MeshWriter, SaysWhatIsWrong)
{
  vtkNew<vtkPEMMeshWriter> writer;
  ErrorLog errors(writer);
  writer->SetInputData(MakeHouse());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_THAT(errors.GetText(), testing::HasSubstr("No file name"));
  errors.Clear();
  writer->SetFileName("mesh.xyz");
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_THAT(errors.GetText(), testing::HasSubstr("mesh.xyz"));
  errors.Clear();
  writer->SetFileName((TestFolder() / "mesh.off").string());
  writer->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_THAT(errors.GetText(), testing::HasSubstr("no polygons"));
  writer->SetInputData(MakeHouse());
  EXPECT_EQ(writer->Write(), 1); // an error of the past does not stay
}

TEST(MeshWriter, PrintsItsFile)
{
  vtkNew<vtkPEMMeshWriter> writer;
  writer->SetFileName("some.off");
  std::ostringstream text;
  writer->Print(text);
  EXPECT_THAT(text.str(), testing::HasSubstr("some.off"));
  EXPECT_EQ(writer->GetFileName(), "some.off");
}
