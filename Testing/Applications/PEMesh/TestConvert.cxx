// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * `pemesh convert`, run as a user runs it.
 */
#include "MeshFormats.h"
#include "ProgramRun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>

namespace fs = std::filesystem;
using pemesh::FileText;
using pemesh::RunProgram;
using pemesh::TestFolder;
using testing::HasSubstr;

namespace
{

/** The unit square as a clockwise pentagon and a triangle. */
const std::string Square = "OFF\n5 2 0\n0 0 0\n0.5 0 0\n1 0 0\n1 1 0\n0 1 0\n3 1 2 3\n4 0 4 3 1\n";

std::string Write(const fs::path& path, const std::string& text)
{
  std::ofstream(path) << text;
  return path;
}

} // namespace

TEST(Convert, OneFileToOne)
{
  const fs::path folder = TestFolder("convert-one");
  const std::string mesh = Write(folder / "m.off", Square);
  const std::string to = folder / "new" / "m.obj";
  const auto run = RunProgram("pemesh", { "convert", mesh, "-o", to });
  EXPECT_EQ(run.ExitCode, 0);
  EXPECT_EQ(run.Output, to + ": 2 elements, 5 vertices\n");
  EXPECT_EQ(run.Errors, "");
  EXPECT_EQ(FileText(to), "v 0 0 0\nv 0.5 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 2 3 4\nf 1 2 4 5\n");
  RunProgram("pemesh", { "convert", mesh, "--as-stored", "-o", to });
  EXPECT_THAT(FileText(to), HasSubstr("f 2 3 4\nf 1 5 4 2\n"));
}

TEST(Convert, SeveralToAFolder)
{
  const fs::path folder = TestFolder("convert-several");
  fs::create_directories(folder / "other");
  const std::string a = Write(folder / "m.off", Square);
  const std::string b = Write(folder / "other" / "m.off", Square);
  const std::string bad = Write(folder / "bad.off", "OFF\n3 1 0\n0 0 0\n");
  const auto run =
    RunProgram("pemesh", { "convert", a, bad, b, "--to", "node-plain", "-o", folder / "out" });
  EXPECT_EQ(run.ExitCode, 1); // one of them is no mesh, the others are done
  EXPECT_THAT(run.Errors, HasSubstr("bad.off\", line 4"));
  EXPECT_EQ(FileText(folder / "out" / "m.ele"), "2\n3 2 3 4\n4 1 2 4 5\n");
  EXPECT_EQ(FileText(folder / "out" / "m.ele"), FileText(folder / "out" / "m-2.ele"));
  EXPECT_FALSE(fs::exists(folder / "out" / "bad.node"));
}

TEST(Convert, SaysWhatIsLost)
{
  const fs::path folder = TestFolder("convert-lost");
  const std::string mesh = Write(folder / "m.off", Square);
  const auto stl = RunProgram("pemesh", { "convert", mesh, "-o", folder / "m.stl" });
  EXPECT_EQ(stl.ExitCode, 0);
  EXPECT_THAT(stl.Output, HasSubstr("stl holds triangles only: 1 larger element is cut into"));
  EXPECT_EQ(pemesh::ReadMesh(folder / "m.stl")->GetNumberOfPolys(), 3);
}

TEST(Convert, TriangulatesOnRequest)
{
  const fs::path folder = TestFolder("convert-triangles");
  const std::string mesh = Write(folder / "m.off", Square);
  const std::string to = folder / "m.vtp";
  const auto run = RunProgram("pemesh", { "convert", mesh, "--triangulate", "-o", to });
  EXPECT_EQ(run.ExitCode, 0);
  EXPECT_EQ(run.Output, to + ": 3 elements, 5 vertices\n");
  const auto triangles = pemesh::ReadMesh(to);
  vtkDataArray* element = triangles->GetCellData()->GetArray("OriginalElement");
  ASSERT_NE(element, nullptr);
  EXPECT_EQ(element->GetTuple1(0), 0.0);
  EXPECT_EQ(element->GetTuple1(1), 1.0);
  EXPECT_EQ(element->GetTuple1(2), 1.0);
}

TEST(Convert, RefusesWhatMakesNoSense)
{
  const fs::path folder = TestFolder("convert-refuses");
  const std::string mesh = Write(folder / "m.off", Square);
  const std::string other = Write(folder / "n.off", Square);
  const auto refused = [&](std::vector<std::string> arguments, const std::string& why)
  {
    arguments.insert(arguments.begin(), "convert");
    const auto run = RunProgram("pemesh", arguments);
    EXPECT_EQ(run.ExitCode, 2);
    EXPECT_THAT(run.Errors, HasSubstr(why));
  };
  refused({ mesh }, "--output is required");
  refused({ mesh, "-o", folder / "m.xyz" }, "is no mesh file");
  refused({ mesh, other, "-o", folder / "x.obj" }, "need a format");
  refused({ mesh, other, "--to", "obj", "-o", mesh }, "is a file, not a folder");
  refused({ mesh, "--to", "ply2", "-o", folder }, "ply2");
  refused({ mesh, "--to", "obj", "-o", folder / "x.stl" }, "does not end as");
  refused({ mesh, "-o", mesh }, "written over");
  refused({ mesh, "--to", "off", "-o", folder }, "written over");
  EXPECT_EQ(FileText(mesh), Square);
}

TEST(Convert, TheFormatsAreListed)
{
  const auto list = RunProgram("pemesh", { "list", "formats" });
  EXPECT_EQ(list.ExitCode, 0);
  for (const std::string& name : pemesh::MeshFormatNames())
  {
    EXPECT_THAT(list.Output, HasSubstr(name));
  }
}
