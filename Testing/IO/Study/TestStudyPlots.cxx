// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartKinds.h"
#include "ChartStyle.h"
#include "ChartStyleFile.h"
#include "Study.h"
#include "StudyFile.h"
#include "TestFolder.h"
#include "TextFile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

pemesh::StudyPlot Read(const std::string& plot)
{
  const pemesh::Study study =
    pemesh::ParseStudy(R"({"pemesh": 1, "polygons": [], "plots": [)" + plot + "]}", "s.json");
  // What is written is read back as the same.
  EXPECT_EQ(pemesh::ParseStudy(pemesh::FormatStudy(study), "s.json").Plots, study.Plots)
    << pemesh::FormatStudy(study);
  return study.Plots.at(0);
}

std::string Complaint(const std::string& plot)
{
  try
  {
    Read(plot);
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return "";
}

TEST(StudyPlots, EveryKindOfTheTableIsAKind)
{
  for (const pemesh::ChartKind& kind : pemesh::ChartKinds())
  {
    const auto plot =
      Read(std::string(R"({"kind": ")") + kind.Name + R"(", "y": ["a", "b"], "data": true})");
    EXPECT_EQ(plot.Kind, kind.Name);
    EXPECT_TRUE(plot.Data);
    EXPECT_EQ(plot.X.empty(), !kind.UsesX || kind.OfElements || plot.Kind == "correlation-matrix");
    EXPECT_THAT(plot.File, HasSubstr(kind.Name));
  }
  EXPECT_EQ(Read(R"({"kind": "correlation-matrix"})").Y.size(), 0u); // all columns
}

TEST(StudyPlots, OptionsAreThoseOfTheKind)
{
  const auto plot = Read(R"({"kind": "scatter", "y": "a", "fit": "power", "confidence": 0.9,
    "x-min": 0.5})");
  EXPECT_EQ(plot.Options.at("fit"), "power");
  EXPECT_EQ(plot.Options.at("confidence"), "0.9");
  EXPECT_EQ(plot.Options.at("x-min"), "0.5");
  EXPECT_EQ(Complaint(R"({"kind": "scatter", "y": "a", "fit": "cubic"})"),
    "\"s.json\": plots[0].fit is \"cubic\"; it must be one of none, linear, power, exponential, "
    "best; the nearest is \"none\".");
  EXPECT_EQ(Complaint(R"({"kind": "scatter", "y": "a", "bins": 4})"),
    "\"s.json\": plots[0].bins does not apply here: it is a key of the kind histogram.");
  EXPECT_EQ(Complaint(R"({"kind": "histogram", "y": "a", "bins": 4.5})"),
    "\"s.json\": plots[0].bins is \"4.5\"; it must be an integer from 0 to 1000.");
  EXPECT_THAT(
    Complaint(R"({"kind": "histogram", "y": "a", "binz": 4})"), HasSubstr("did you mean bins?"));
}

TEST(StudyPlots, ElementsComeFromCases)
{
  EXPECT_THAT(Read(R"({"kind": "violin", "y": "MinAngle", "cases": [0, 5, -1]})").Cases,
    ElementsAre(0, 5, -1));
  EXPECT_THAT(Complaint(R"({"kind": "line", "y": "a", "cases": [0]})"),
    HasSubstr("it is a key of the kinds histogram, box, violin and element-scatter"));
}

TEST(StudyPlots, StylesAreFilesOrKeys)
{
  EXPECT_EQ(Read(R"({"kind": "line", "y": "a", "style": "paper.json"})").Style.File, "paper.json");
  const auto plot = Read(
    R"({"kind": "line", "y": "a", "style": {"from": "paper.json", "font-size": 9, "frame": true}})");
  EXPECT_EQ(plot.Style.File, "paper.json");
  EXPECT_EQ(plot.Style.Settings.at("font-size"), "9");
  EXPECT_EQ(plot.Style.Settings.at("frame"), "true");
  EXPECT_EQ(Complaint(R"({"kind": "line", "y": "a", "style": {"pallete": "ibm"}})"),
    "\"s.json\": plots[0].style.pallete is not a key; did you mean palette?");
  EXPECT_EQ(Complaint(R"({"kind": "line", "y": "a", "style": {"font-size": 900}})"),
    "\"s.json\": plots[0].style.font-size is \"900\"; it must be a number from 3 to 72.");
  EXPECT_THAT(Complaint(R"({"kind": "line", "y": "a", "style": {"ink": "black"}})"),
    HasSubstr("must be a colour like #1f77b4"));
}

TEST(StudyPlots, AStudyHasAStyleForAllItsPlots)
{
  const pemesh::Study study = pemesh::ParseStudy(
    R"({"pemesh": 1, "polygons": [], "style": {"from": "paper.json", "palette": "ibm"}})",
    "s.json");
  EXPECT_EQ(study.Style.File, "paper.json");
  EXPECT_EQ(study.Style.Settings.at("palette"), "ibm");
  EXPECT_EQ(pemesh::ParseStudy(pemesh::FormatStudy(study), "s.json").Style, study.Style);
  EXPECT_THROW(
    pemesh::ParseStudy(R"({"pemesh": 1, "polygons": [], "style": {"palette": "no"}})", "s.json"),
    std::exception);
}

TEST(StudyPlots, StyleFilesKeepEverySetting)
{
  const std::filesystem::path folder = pemesh::TestFolder();
  pemesh::ChartStyle style;
  style.Palette = "muted";
  style.Ink = "#102030";
  style.FontFamily = "DejaVu \"Serif\"";
  style.LineWidth = 0.1;
  style.Frame = true;
  style.Width = 8.5;
  pemesh::WriteChartStyleFile(folder / "style.json", style);
  EXPECT_EQ(pemesh::ReadChartStyleFile(folder / "style.json"), style);
  const auto changed = pemesh::MakeChartStyle(folder, { { "style.json", { { "width", "17" } } } });
  EXPECT_EQ(changed.Width, 17.0);
  EXPECT_EQ(changed.Palette, "muted");
  // A file on top of another style changes only what it names.
  const auto layered = pemesh::MakeChartStyle(
    folder, { { "", { { "palette", "ibm" }, { "legend", "right" } } }, { "style.json", {} } });
  EXPECT_EQ(layered.Palette, "muted");
  EXPECT_EQ(layered.Legend, "right");
  pemesh::WriteChartStyleFile(folder / "standard.json", pemesh::ChartStyle());
  EXPECT_EQ(pemesh::ReadTextFile(folder / "standard.json"), "{\n}\n"); // only what differs
  pemesh::WriteTextFile(folder / "wrong.json", "{\"grid\": \"mayor\"}");
  try
  {
    pemesh::ReadChartStyleFile(folder / "wrong.json");
    FAIL();
  }
  catch (const std::exception& error)
  {
    EXPECT_THAT(error.what(), HasSubstr("wrong.json\": grid is \"mayor\""));
    EXPECT_THAT(error.what(), HasSubstr("nearest is \"major\""));
  }
}

} // namespace
