// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartSupport.h"
#include "FontFiles.h"
#include "vtkPEMChart.h"
#include "vtkPEMFigure.h"
#include "vtkPEMMeshView.h"

#include <vtkNew.h>
#include <vtkTestErrorObserver.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

namespace
{

using testing::HasSubstr;

vtkSmartPointer<vtkPEMFigure> MakeFigure()
{
  auto table = ChartSupport::MakeTable({ { "t", { 0, 0.3, 0.6, 0.9 } },
    { "KernelAreaRatio_min", { 1, 0.5, 0.1, 0.02 } }, { "condition", { 10, 90, 1e3, 5e5 } } });
  vtkNew<vtkPEMChart> chart;
  chart->SetTable(table);
  chart->SetXColumn("t");
  chart->SetYColumns({ "KernelAreaRatio_min", "condition" }, { "smallest A_K / A", "κ₁(K)" });
  chart->LogYOn();
  chart->SetXTitle("deformation t");
  chart->SetTitle("Comb & Star < 1");
  vtkNew<vtkPEMMeshView> view;
  view->SetMesh(ChartSupport::MakeSquares(8));
  view->SetColorArray("Wave");
  view->SetColorTitle("u (1)");
  view->SetTitle("Solution");
  auto figure = vtkSmartPointer<vtkPEMFigure>::New();
  figure->SetTitle("Überblick ‖ρ‖");
  figure->SetSizeInCentimeters(16, 7);
  figure->AddPanel(chart);
  figure->AddPanel(view);
  return figure;
}

std::string ReadBytes(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), {} };
}

TEST(Figure, TheThreeFormatsShowTheSame)
{
  auto figure = MakeFigure();
  figure->SetDPI(150);
  const std::string stem = pemesh::TestPath("Same");
  for (const char* ending : { ".png", ".svg", ".pdf" })
  {
    ASSERT_TRUE(figure->Write(stem + ending)) << figure->GetErrorMessage();
  }
  const auto png = ChartSupport::ReadPng(stem + ".png");
  EXPECT_EQ(png.Width, figure->GetWidthInPixels());
  EXPECT_EQ(png.Height, figure->GetHeightInPixels());
  EXPECT_EQ(png.Width, 945); // 16 cm at 150 dpi
  for (const char* ending : { ".svg", ".pdf" })
  {
    const auto other = ChartSupport::Rasterise(stem + ending, png.Width);
    EXPECT_LT(ChartSupport::MeanDifference(png, other), 3.0) << ending;
  }
}

TEST(Figure, TextIsText)
{
  auto figure = MakeFigure();
  const std::string pdf = pemesh::TestPath("Text.pdf");
  const std::string svg = pemesh::TestPath("Text.svg");
  ASSERT_TRUE(figure->Write(pdf));
  ASSERT_TRUE(figure->Write(svg));
  ASSERT_TRUE(ChartSupport::Run("pdftotext \"" + pdf + "\" \"" + pdf + ".txt\""));
  const std::string words = ReadBytes(pdf + ".txt");
  for (const char* word :
    { "Überblick ‖ρ‖", "Comb & Star < 1", "κ₁(K)", "deformation t", "10⁴", "Solution" })
  {
    EXPECT_THAT(words, HasSubstr(word));
  }
  const std::string xml = ReadBytes(svg);
  EXPECT_THAT(xml, HasSubstr(">Überblick ‖ρ‖</text>"));
  EXPECT_THAT(xml, HasSubstr(">Comb &amp; Star &lt; 1</text>"));
  EXPECT_THAT(xml, HasSubstr("DejaVu Sans"));
}

TEST(Figure, TheSameBytesTwiceAndInThreads)
{
  for (const std::string ending : { ".png", ".svg", ".pdf" })
  {
    const std::string first = pemesh::TestPath("First" + ending);
    ASSERT_TRUE(MakeFigure()->Write(first));
    const std::string bytes = ReadBytes(first);
    ASSERT_GT(bytes.size(), 1000u);
    std::vector<std::thread> threads;
    for (int i = 0; i < 3; ++i)
    {
      threads.emplace_back([&ending, i]()
        { MakeFigure()->Write(pemesh::TestPath("Thread" + std::to_string(i) + ending)); });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_TRUE(ReadBytes(pemesh::TestPath("Thread" + std::to_string(i) + ending)) == bytes)
        << ending;
    }
    EXPECT_THAT(bytes, testing::Not(HasSubstr("CreationDate")));
  }
}

TEST(Figure, LeavesNoTemporaryFiles)
{
  const std::filesystem::path folder = pemesh::TestPath("Whole/New");
  std::filesystem::remove_all(folder);
  ASSERT_TRUE(MakeFigure()->Write((folder / "figure.png").string()));
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    EXPECT_EQ(entry.path().filename(), "figure.png");
    ++files;
  }
  EXPECT_EQ(files, 1);
}

TEST(Figure, WhatCannotBeWrittenIsSaidInOneSentence)
{
  const auto why = [](vtkPEMFigure* figure, const std::string& path)
  {
    vtkNew<vtkTest::ErrorObserver> observer;
    figure->AddObserver(vtkCommand::ErrorEvent, observer);
    EXPECT_FALSE(figure->Write(path));
    EXPECT_TRUE(observer->GetError());
    return figure->GetErrorMessage();
  };
  auto figure = MakeFigure();
  EXPECT_THAT(
    why(figure, pemesh::TestPath("figure.gif")), HasSubstr("must end in .png, .svg or .pdf"));
  EXPECT_THAT(why(figure, "/proc/no/figure.png"), HasSubstr("/proc/no"));
  auto* chart = vtkPEMChart::SafeDownCast(figure->GetPanel(0));
  chart->SetYColumns({ "Condition" });
  EXPECT_THAT(why(figure, pemesh::TestPath("bad.png")),
    HasSubstr("no column \"Condition\"; the nearest is \"condition\""));
  EXPECT_FALSE(std::filesystem::exists(pemesh::TestPath("bad.png")));
  vtkNew<vtkPEMFigure> empty;
  EXPECT_THAT(why(empty, pemesh::TestPath("empty.png")), HasSubstr("has no panels"));
}

TEST(Figure, NumbersDoNotDependOnTheLocale)
{
  const std::string before = pemesh::TestPath("Locale.svg");
  ASSERT_TRUE(MakeFigure()->Write(before));
  EXPECT_THAT(ReadBytes(before), testing::Not(HasSubstr("font-size=\"7,")));
  EXPECT_THAT(ReadBytes(before), HasSubstr("font-size=\"7.2\""));
}

TEST(Figure, SaysWhichFontIsDrawnInPlaceOfOneThatIsNotThere)
{
  const vtkSmartPointer<vtkPEMFigure> figure = MakeFigure();
  vtkNew<vtkTest::ErrorObserver> observer;
  figure->AddObserver(vtkCommand::WarningEvent, observer);
  const std::string file = pemesh::TestPath("font.svg");
  ASSERT_TRUE(figure->Write(file));
  EXPECT_FALSE(observer->GetWarning()) << observer->GetWarningMessage();
  pemesh::ChartStyle style;
  style.FontFamily = "No Such Font";
  figure->SetStyle(style);
  ASSERT_TRUE(figure->Write(file)) << "it is drawn all the same";
  EXPECT_THAT(observer->GetWarningMessage(),
    HasSubstr("The font \"No Such Font\" is not installed, so that text is drawn in \""));
  EXPECT_EQ(pemesh::WhyOtherFont("dejavu sans"), "") << "whatever the case";
  EXPECT_EQ(pemesh::WhyOtherFont("serif"), "");
}

} // namespace
