// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartSupport.h"
#include "vtkPEMCairoContextDevice2D.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkContextScene.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkTextProperty.h>
#include <vtkTransform2D.h>

#include <gtest/gtest.h>

#include <fstream>
#include <functional>

namespace
{

constexpr const char* Endings[] = { ".png", ".svg", ".pdf" };

/** Paints on a page of 200 x 100 points, a pixel a point, and returns the path of the file. */
std::string PaintTo(
  const std::string& name, int format, const std::function<void(vtkContext2D*)>& paint)
{
  vtkNew<vtkPEMCairoContextDevice2D> device;
  device->SetFormat(format);
  device->SetPageSize(200, 100);
  device->Begin(nullptr);
  vtkNew<vtkContext2D> context;
  context->Begin(device);
  paint(context);
  context->End();
  device->End();
  EXPECT_EQ(device->GetErrorMessage(), "");
  const std::string path = pemesh::TestPath(name + Endings[format]);
  std::ofstream(path, std::ios::binary) << device->GetContents();
  return path;
}

ChartSupport::Picture PaintPng(
  const std::string& name, const std::function<void(vtkContext2D*)>& paint)
{
  return ChartSupport::ReadPng(PaintTo(name, vtkPEMCairoContextDevice2D::FORMAT_PNG, paint));
}

void AllCalls(vtkContext2D* context)
{
  context->GetPen()->SetColor(200, 0, 0);
  context->GetPen()->SetWidth(2);
  context->DrawLine(5, 5, 60, 20);
  context->GetPen()->SetLineType(vtkPen::DASH_LINE);
  context->DrawLine(5, 15, 60, 30);
  context->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  context->GetBrush()->SetColor(0, 0, 200, 128);
  context->DrawRect(70, 5, 20, 20);
  context->DrawEllipse(110, 15, 15, 10);
  context->DrawWedge(145, 15, 12, 6, 20, 300);
  context->DrawArc(180, 15, 10, 0, 270);
  float strip[12] = { 5, 40, 5, 60, 25, 45, 25, 55, 45, 40, 45, 60 };
  context->DrawQuadStrip(strip, 6);
  context->DrawQuad(60, 40, 80, 40, 85, 60, 65, 60);
  context->GetPen()->SetWidth(10);
  float points[4] = { 100, 50, 120, 50 };
  context->DrawPoints(points, 2);
  for (int shape = VTK_MARKER_CROSS; shape <= VTK_MARKER_DIAMOND; ++shape)
  {
    float point[2] = { 125.0f + 12.0f * static_cast<float>(shape), 50 };
    context->DrawMarkers(shape, false, point, 1);
  }
  context->GetTextProp()->SetFontSize(12);
  context->GetTextProp()->SetColor(0, 0, 0);
  context->DrawString(5, 80, "κ₁ ≈ 10⁻³ ‖u‖");
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 12, 90);
  context->DrawImage(vtkRectf(150, 75, 20, 20), image);
}

TEST(CairoDevice, TheThreeFormatsShowTheSame)
{
  const auto png = ChartSupport::ReadPng(PaintTo("AllCalls", 0, AllCalls));
  ASSERT_EQ(png.Width, 200);
  ASSERT_EQ(png.Height, 100);
  EXPECT_FALSE(png.IsWhite(110, 85)); // an ellipse is filled, here with half-transparent blue
  for (const int format : { 1, 2 })
  {
    const std::string path = PaintTo("AllCalls", format, AllCalls);
    EXPECT_LT(ChartSupport::MeanDifference(png, ChartSupport::Rasterise(path, 200)), 3.0) << path;
  }
}

TEST(CairoDevice, AConcavePolygonKeepsItsNotch)
{
  // A U, drawn the way round that a fan of triangles would fill.
  const auto picture = PaintPng("Notch",
    [](vtkContext2D* context)
    {
      context->GetBrush()->SetColor(0, 0, 0, 255);
      float points[16] = { 50, 10, 150, 10, 150, 90, 120, 90, 120, 40, 80, 40, 80, 90, 50, 90 };
      context->DrawPolygon(points, 8);
    });
  EXPECT_TRUE(picture.IsWhite(100, 30));
  EXPECT_FALSE(picture.IsWhite(60, 30));
  EXPECT_FALSE(picture.IsWhite(140, 30));
  EXPECT_FALSE(picture.IsWhite(100, 80));
}

TEST(CairoDevice, TransformsMovePointsAndClippingCuts)
{
  const auto picture = PaintPng("Transform",
    [](vtkContext2D* context)
    {
      context->GetPen()->SetLineType(vtkPen::NO_PEN);
      context->GetBrush()->SetColor(0, 0, 0, 255);
      vtkNew<vtkTransform2D> transform;
      transform->Translate(100, 0);
      transform->Scale(2, 2);
      context->PushMatrix();
      context->AppendTransform(transform);
      context->DrawRect(10, 10, 10, 10); // at 120..140, 20..40
      context->PopMatrix();
      int clip[4] = { 0, 0, 20, 100 };
      context->GetDevice()->SetClipping(clip);
      context->GetDevice()->EnableClipping(true);
      context->DrawRect(10, 10, 50, 50);
      context->GetDevice()->EnableClipping(false);
    });
  EXPECT_FALSE(picture.IsWhite(121, 78));
  EXPECT_FALSE(picture.IsWhite(138, 62));
  EXPECT_TRUE(picture.IsWhite(118, 70));
  EXPECT_TRUE(picture.IsWhite(142, 70));
  EXPECT_FALSE(picture.IsWhite(15, 60));
  EXPECT_TRUE(picture.IsWhite(25, 60));
}

TEST(CairoDevice, TextStandsWhereItsJustificationSays)
{
  const auto count = [](int horizontal, bool left)
  {
    const auto picture = PaintPng("Justified" + std::to_string(horizontal),
      [horizontal](vtkContext2D* context)
      {
        context->GetTextProp()->SetFontSize(20);
        context->GetTextProp()->SetColor(0, 0, 0);
        context->GetTextProp()->SetJustification(horizontal);
        context->DrawString(100, 40, "HHHH");
      });
    int dark = 0;
    for (int row = 0; row < 100; ++row)
    {
      for (int column = left ? 0 : 100; column < (left ? 100 : 200); ++column)
      {
        dark += picture.IsWhite(column, row) ? 0 : 1;
      }
    }
    return dark;
  };
  EXPECT_EQ(count(VTK_TEXT_LEFT, true), 0);
  EXPECT_GT(count(VTK_TEXT_LEFT, false), 50);
  EXPECT_EQ(count(VTK_TEXT_RIGHT, false), 0);
  EXPECT_NEAR(count(VTK_TEXT_CENTERED, true), count(VTK_TEXT_CENTERED, false), 30);
}

TEST(CairoDevice, BoundsOfTextGrowWithSizeAndTurn)
{
  vtkNew<vtkPEMCairoContextDevice2D> device;
  device->GetTextProp()->SetFontSize(10);
  float small[4];
  device->ComputeStringBounds(vtkStdString("condition number"), small);
  device->GetTextProp()->SetFontSize(20);
  float large[4];
  device->ComputeStringBounds(vtkStdString("condition number"), large);
  EXPECT_NEAR(large[2], 2.0f * small[2], 1e-3f);
  EXPECT_NEAR(large[3], 2.0f * small[3], 1e-3f);
  device->GetTextProp()->SetOrientation(90);
  float turned[4];
  device->ComputeJustifiedStringBounds("condition number", turned);
  EXPECT_NEAR(turned[2], large[3], 1e-3f);
  EXPECT_NEAR(turned[3], large[2], 1e-3f);
}

TEST(CairoDevice, PaintsAChartOfVTK)
{
  auto table = ChartSupport::MakeTable({ { "x", { 0, 1, 2, 3 } }, { "y", { 0, 1, 4, 9 } } });
  ChartSupport::Picture pictures[3];
  for (int format = 0; format < 3; ++format)
  {
    vtkNew<vtkPEMCairoContextDevice2D> device;
    device->SetFormat(format);
    device->SetPageSize(400, 300);
    vtkNew<vtkContextScene> scene;
    vtkNew<vtkChartXY> chart;
    scene->AddItem(chart);
    scene->SetGeometry(400, 300);
    for (const int kind : { vtkChart::LINE, vtkChart::POINTS, vtkChart::BAR })
    {
      vtkPlot* plot = chart->AddPlot(kind);
      plot->SetInputData(table, "x", "y");
      plot->SetColor(200, 0, 0, 255);
    }
    chart->SetShowLegend(true);
    device->Begin(nullptr);
    vtkNew<vtkContext2D> context;
    context->Begin(device);
    scene->Paint(context);
    context->End();
    device->End();
    const std::string path = pemesh::TestPath(std::string("ChartXY") + Endings[format]);
    std::ofstream(path, std::ios::binary) << device->GetContents();
    pictures[format] = ChartSupport::Rasterise(path, 400);
  }
  int red = 0;
  for (const auto& pixel : pictures[0].Pixels)
  {
    red += pixel[0] > 150 && pixel[1] < 60 ? 1 : 0;
  }
  EXPECT_GT(red, 500);
  EXPECT_LT(ChartSupport::MeanDifference(pictures[0], pictures[1]), 3.0);
  EXPECT_LT(ChartSupport::MeanDifference(pictures[0], pictures[2]), 3.0);
}

} // namespace
