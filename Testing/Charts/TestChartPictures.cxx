// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// One picture of every kind of chart, in a column of a paper and on a full screen, in all formats.
// They are left in ChartsOutput: look at them.
#include "ChartKinds.h"
#include "ChartOptions.h"
#include "ChartSupport.h"
#include "RandomNumbers.h"
#include "vtkPEMChart.h"
#include "vtkPEMFigure.h"

#include <vtkNew.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

namespace
{

/** Two solvers on thirty meshes that get worse with t. */
vtkSmartPointer<vtkTable> MakeMeshTable()
{
  std::vector<double> t;
  std::vector<double> size;
  std::map<std::string, std::vector<double>> columns;
  pemesh::RandomNumbers random(3);
  for (int i = 0; i < 30; ++i)
  {
    const double noise = 1.1 * (random.Uniform() - 0.5);
    t.push_back(0.03 * i);
    size.push_back(0.4 * std::pow(0.82, 0.5 * i));
    const double angle = 1.02 - 0.95 * t.back() + 0.05 * noise;
    columns["MinAngle_min"].push_back(0.5 * angle);
    columns["MinAngle_mean"].push_back(angle);
    columns["MinAngle_max"].push_back(1.25 * angle + 0.1);
    columns["KernelAreaRatio_min"].push_back(std::pow(1.0 - t.back(), 2) + 0.05);
    columns["condition"].push_back(12.0 * std::pow(angle, -1.9) * std::exp(noise));
    columns["errorL2"].push_back(0.8 * std::pow(size.back(), 2.0) * std::exp(noise));
    columns["Elements"].push_back(std::floor(400.0 + 300.0 * random.Uniform()));
    columns["AspectRatio_max"].push_back(2.0 + t.back() + 2.0 * random.Uniform());
    columns["errorH1"].push_back(1.9 * size.back() * std::exp(0.5 * noise));
  }
  std::vector<std::pair<std::string, std::vector<double>>> all{ { "t", t }, { "h", size } };
  all.insert(all.end(), columns.begin(), columns.end());
  auto table = ChartSupport::MakeTable(all);
  vtkNew<vtkStringArray> families;
  families->SetName("family");
  for (int i = 0; i < 30; ++i)
  {
    families->InsertNextValue(i % 3 == 0 ? "comb" : i % 3 == 1 ? "star" : "zeta");
  }
  table->AddColumn(families);
  return table;
}

/** Elements of four meshes. */
vtkSmartPointer<vtkTable> MakeElementTable(int elements)
{
  std::vector<double> angle;
  std::vector<double> area;
  std::vector<double> error;
  vtkNew<vtkStringArray> meshes;
  meshes->SetName("Mesh");
  pemesh::RandomNumbers random(5);
  for (int i = 0; i < elements; ++i)
  {
    const int mesh = i % 4;
    const double bell = random.Uniform() + random.Uniform() + random.Uniform() - 1.5;
    angle.push_back(0.6 - 0.12 * mesh + 0.22 * bell + (i % 11 == 0 ? 0.5 : 0.0));
    area.push_back(1e-3 * std::exp(1.3 * bell));
    error.push_back(1e-4 * std::pow(area.back() * 1e3, 1.5) * std::exp(2.0 * random.Uniform()));
    meshes->InsertNextValue("00" + std::to_string(mesh) + "_0." + std::to_string(3 * mesh));
  }
  auto table =
    ChartSupport::MakeTable({ { "MinAngle", angle }, { "Area", area }, { "ErrorL2", error } });
  table->AddColumn(meshes);
  return table;
}

struct Example
{
  std::string Name;
  std::string Kind;
  std::string X;
  std::vector<std::string> Y;
  std::string Log;
  std::string Color;
  std::vector<std::pair<std::string, std::string>> Options;
  int Elements = 0; // 0: the table of meshes
};

void PrintTo(const Example& one, std::ostream* stream)
{
  *stream << one.Name;
}

const std::vector<Example>& Examples()
{
  static const std::vector<Example> examples = {
    { "line", "line", "t", { "MinAngle", "KernelAreaRatio_min" }, "", "", {} },
    { "scatter", "scatter", "MinAngle_mean", { "condition" }, "y", "", { { "fit", "best" } } },
    { "classes", "scatter", "MinAngle_mean", { "condition" }, "xy", "family", {} },
    { "coloured", "scatter", "MinAngle_mean", { "errorL2" }, "y", "t", {} },
    { "small-multiples", "small-multiples", "t",
      { "MinAngle", "KernelAreaRatio_min", "condition", "errorL2", "errorH1" }, "", "", {} },
    { "scatter-matrix", "scatter-matrix", "",
      { "MinAngle_mean", "KernelAreaRatio_min", "condition", "errorL2" }, "", "family", {} },
    { "correlation-matrix", "correlation-matrix", "",
      { "t", "h", "MinAngle_min", "AspectRatio_max", "Elements", "condition", "errorL2" }, "", "",
      {} },
    { "histogram", "histogram", "", { "MinAngle" }, "", "", {}, 4000 },
    { "histogram-classes", "histogram", "", { "Area" }, "x", "", { { "group-by", "Mesh" } }, 4000 },
    { "box", "box", "", { "MinAngle" }, "", "", { { "group-by", "Mesh" } }, 4000 },
    { "violin", "violin", "", { "MinAngle" }, "", "", { { "group-by", "Mesh" } }, 4000 },
    { "convergence", "convergence", "h", { "errorL2", "errorH1" }, "", "", {} },
    { "element-scatter", "element-scatter", "Area", { "ErrorL2" }, "xy", "", {}, 3000 },
    { "density", "element-scatter", "Area", { "ErrorL2" }, "xy", "", {}, 60000 },
    { "density-classes", "element-scatter", "Area", { "ErrorL2" }, "xy", "Mesh", {}, 60000 },
    { "density-coloured", "element-scatter", "Area", { "ErrorL2" }, "xy", "MinAngle", {}, 60000 },
    // The most points that are drawn one by one.
    { "cloud", "element-scatter", "Area", { "ErrorL2" }, "xy", "", {}, 10000 },
    { "cloud-classes", "element-scatter", "Area", { "ErrorL2" }, "xy", "Mesh", {}, 10000 },
    { "cloud-coloured", "element-scatter", "Area", { "ErrorL2" }, "xy", "MinAngle", {}, 10000 },
  };
  return examples;
}

vtkSmartPointer<vtkPEMChart> MakeChart(const Example& example)
{
  auto chart = vtkSmartPointer<vtkPEMChart>::New();
  chart->SetTable(example.Elements > 0 ? MakeElementTable(example.Elements) : MakeMeshTable());
  EXPECT_TRUE(chart->SetKindByName(example.Kind));
  const std::pair<const char*, const char*> titles[] = { { "t", "deformation t" },
    { "h", "mesh size h" }, { "MinAngle", "minimum angle (rad)" },
    { "MinAngle_mean", "mean minimum angle (rad)" }, { "condition", "condition number κ₁(K)" },
    { "KernelAreaRatio_min", "smallest kernel area ratio" }, { "errorL2", "L² error" },
    { "errorH1", "H¹ error" }, { "ErrorL2", "local L² error" }, { "Area", "area" },
    { "Mesh", "mesh" } };
  for (const auto& [column, title] : titles)
  {
    chart->SetColumnTitle(column, title);
  }
  chart->SetXColumn(example.X);
  for (const std::string& y : example.Y)
  {
    if (y == "MinAngle" && example.Elements == 0)
    {
      chart->AddBand("MinAngle_min", "MinAngle_max", "MinAngle_mean", "minimum angle (rad)");
    }
    else
    {
      chart->AddYColumn(y);
    }
  }
  chart->SetLogAxes(example.Log);
  chart->SetColorColumn(example.Color);
  for (const auto& [name, value] : example.Options)
  {
    EXPECT_EQ(chart->SetOption(name, value), "");
  }
  EXPECT_EQ(chart->WhyNotDrawable(), "");
  return chart;
}

class ChartPictures : public testing::TestWithParam<Example>
{
};

TEST_P(ChartPictures, AreAlikeInAllFormatsAndSmall)
{
  auto chart = MakeChart(GetParam());
  vtkNew<vtkPEMFigure> figure;
  figure->AddPanel(chart);
  figure->SetSizeInCentimeters(8.0, 0.0);
  figure->SetDPI(180);
  const std::string stem = pemesh::TestPath("kind-" + GetParam().Name);
  for (const char* ending : { ".png", ".svg", ".pdf" })
  {
    ASSERT_TRUE(figure->Write(stem + ending)) << figure->GetErrorMessage();
    EXPECT_LT(std::filesystem::file_size(stem + ending), 1000000u) << ending;
  }
  const auto png = ChartSupport::ReadPng(stem + ".png");
  for (const char* ending : { ".svg", ".pdf" })
  {
    const auto other = ChartSupport::Rasterise(stem + ending, png.Width);
    EXPECT_LT(ChartSupport::MeanDifference(png, other), 6.0) << ending;
  }
}

TEST_P(ChartPictures, FillAScreen)
{
  auto chart = MakeChart(GetParam());
  vtkNew<vtkPEMFigure> figure;
  figure->AddPanel(chart);
  figure->SetDPI(96);
  figure->SetFontSize(11);
  figure->SetSizeInPixels(1920, 1080);
  ASSERT_TRUE(figure->Write(pemesh::TestPath("screen-" + GetParam().Name + ".png")));
}

INSTANTIATE_TEST_SUITE_P(Kinds, ChartPictures, testing::ValuesIn(Examples()),
  [](const auto& example)
  {
    std::string name = example.param.Name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  });

TEST(ChartPicturesOfAllKinds, AreMade)
{
  for (const pemesh::ChartKind& kind : pemesh::ChartKinds())
  {
    EXPECT_TRUE(std::any_of(Examples().begin(), Examples().end(),
      [&kind](const Example& example) { return example.Kind == kind.Name; }))
      << kind.Name;
  }
}

/** Where two classes are apart a density has their colours, and between where they overlap. */
TEST(ChartPicturesOfAllKinds, ClassesOfADensityAreMixed)
{
  vtkNew<vtkStringArray> classes;
  classes->SetName("class");
  std::vector<double> x;
  std::vector<double> y;
  pemesh::RandomNumbers random(7);
  for (int i = 0; i < 40000; ++i)
  {
    x.push_back(2.0 * random.Uniform() + (i % 2));
    y.push_back(random.Uniform());
    classes->InsertNextValue(i % 2 == 0 ? "left" : "right");
  }
  auto table = ChartSupport::MakeTable({ { "x", x }, { "y", y } });
  table->AddColumn(classes);
  vtkNew<vtkPEMChart> chart;
  chart->SetTable(table);
  chart->SetKindByName("scatter");
  chart->SetXColumn("x");
  chart->AddYColumn("y");
  chart->SetColorColumn("class");
  vtkNew<vtkPEMFigure> figure;
  figure->AddPanel(chart);
  figure->SetSizeInCentimeters(8.0, 0.0);
  figure->SetDPI(144);
  const std::string path = pemesh::TestPath("MixedClasses.png");
  ASSERT_TRUE(figure->Write(path));
  const auto picture = ChartSupport::ReadPng(path);
  const auto blueLessRed = [&](double from)
  {
    // Units are a twentieth of a point, and a point is two pixels.
    const auto column = [&](double at) { return static_cast<int>(chart->GetDeviceX(at) / 10.0); };
    const int row = picture.Height - static_cast<int>(chart->GetDeviceY(0.5) / 10.0);
    double sum = 0.0;
    for (int at = column(from); at < column(from + 0.5); ++at)
    {
      sum += picture.At(at, row)[2] - picture.At(at, row)[0];
    }
    return sum / (column(from + 0.5) - column(from));
  };
  const double left = blueLessRed(0.25);
  const double both = blueLessRed(1.25);
  const double right = blueLessRed(2.25);
  EXPECT_GT(left, 60.0);   // blue
  EXPECT_LT(right, -60.0); // vermilion or orange
  EXPECT_GT(left, both + 30.0);
  EXPECT_LT(right, both - 30.0);
  EXPECT_NE(chart->GetNote().find("mixed colours"), std::string::npos);
}

/** The sheet of the documentation: Data/Pictures/charts.png is a copy. */
TEST(ChartPicturesOfAllKinds, FillASheet)
{
  vtkNew<vtkPEMFigure> figure;
  for (const Example& example : Examples())
  {
    if (example.Name.starts_with("cloud"))
    {
      continue;
    }
    auto chart = MakeChart(example);
    chart->SetTitle(example.Kind);
    figure->AddPanel(chart);
  }
  figure->SetColumns(4);
  figure->SetDPI(90);
  figure->SetSizeInCentimeters(34.0, 31.0);
  ASSERT_TRUE(figure->Write(pemesh::TestPath("charts.png")));
}

} // namespace
