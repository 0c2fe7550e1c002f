// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartSupport.h"
#include "vtkPEMFigure.h"
#include "vtkPEMMeshView.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace
{

constexpr double PixelsAUnit = 300.0 / 72.0 / 20.0;

ChartSupport::Picture Paint(vtkPEMMeshView* view, const std::string& name)
{
  vtkNew<vtkPEMFigure> figure;
  figure->AddPanel(view);
  const std::string path = pemesh::TestPath(name + ".png");
  EXPECT_TRUE(figure->Write(path)) << figure->GetErrorMessage();
  return ChartSupport::ReadPng(path);
}

std::array<unsigned char, 3> ColorAt(
  const ChartSupport::Picture& picture, const vtkPEMMeshView* view, double x, double y)
{
  return picture.At(static_cast<int>(view->GetDeviceX(x) * PixelsAUnit),
    picture.Height - 1 - static_cast<int>(view->GetDeviceY(y) * PixelsAUnit));
}

int Distance(const std::array<unsigned char, 3>& a, const std::array<unsigned char, 3>& b)
{
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

TEST(MeshView, AConcaveStarHasItsOwnArea)
{
  const ChartSupport::Polygon star = ChartSupport::MakeStar();
  vtkNew<vtkPEMMeshView> view;
  view->SetMesh(ChartSupport::MakeMesh({ star }));
  view->SetOutlines(vtkPEMMeshView::OUTLINES_OFF);
  const auto picture = Paint(view, "Star");
  double covered = 0.0; // by how dark the pixels are: plain elements are a pale blue grey
  for (const auto& pixel : picture.Pixels)
  {
    covered += (255.0 - pixel[0]) / (255.0 - 236.0);
  }
  const double pixelsALength = (view->GetDeviceX(1.0) - view->GetDeviceX(0.0)) * PixelsAUnit;
  const double area = covered / (pixelsALength * pixelsALength);
  // The thin line that hides seams adds its half outside: perimeter 14 * .343, half width .0006.
  EXPECT_NEAR(area, ChartSupport::Area(star), 0.01 * ChartSupport::Area(star) + 0.004);
  // In a notch, between two spikes.
  const double notch = std::numbers::pi / 2.0 + std::numbers::pi / 7.0;
  EXPECT_EQ(ColorAt(picture, view, 0.5 + 0.3 * std::cos(notch), 0.5 + 0.3 * std::sin(notch)),
    (std::array<unsigned char, 3>{ 255, 255, 255 }));
  EXPECT_NE(ColorAt(picture, view, 0.5, 0.85), (std::array<unsigned char, 3>{ 255, 255, 255 }));
}

TEST(MeshView, CellsHaveTheirColours)
{
  auto mesh = ChartSupport::MakeSquares(2);
  vtkNew<vtkPEMMeshView> view;
  view->SetMesh(mesh);
  view->SetColorArray("Number"); // 1 2 below, 3 4 above
  auto picture = Paint(view, "Cells");
  const std::array<unsigned char, 3> purple = { 0x44, 0x01, 0x54 };
  const std::array<unsigned char, 3> yellow = { 0xFD, 0xE7, 0x25 };
  EXPECT_LT(Distance(ColorAt(picture, view, 0.25, 0.25), purple), 8);
  EXPECT_LT(Distance(ColorAt(picture, view, 0.75, 0.75), yellow), 8);
  EXPECT_NEAR(view->GetDeviceX(1) - view->GetDeviceX(0), view->GetDeviceY(1) - view->GetDeviceY(0),
    1e-9); // to scale

  mesh->GetCellData()->GetArray("Number")->SetComponent(0, 0, std::nan(""));
  picture = Paint(view, "Undefined");
  EXPECT_EQ(ColorAt(picture, view, 0.25, 0.25), (std::array<unsigned char, 3>{ 205, 205, 205 }));
}

TEST(MeshView, PointArraysAreInterpolatedAndDivergingColoursAreCentred)
{
  vtkNew<vtkPEMMeshView> view;
  view->SetMesh(ChartSupport::MakeSquares(16));
  view->SetColorArray("Wave");
  view->DivergingOn();
  view->SetOutlines(vtkPEMMeshView::OUTLINES_OFF);
  const auto picture = Paint(view, "Wave");
  const auto middle = ColorAt(picture, view, 0.505, 0.26); // value near 0
  EXPECT_GT(middle[0], 225);
  EXPECT_GT(middle[2], 225);
  const auto high = ColorAt(picture, view, 0.25, 0.25);
  EXPECT_GT(high[0], high[2] + 50); // red
  const auto low = ColorAt(picture, view, 0.75, 0.25);
  EXPECT_GT(low[2], low[0] + 50); // blue
}

TEST(MeshView, ClassesAndExtremesAreTold)
{
  auto mesh = ChartSupport::MakeSquares(3);
  vtkNew<vtkIntArray> family;
  family->SetName("ElementFamily");
  for (int i = 0; i < 9; ++i)
  {
    family->InsertNextValue(i == 4 ? 0 : -1);
  }
  mesh->GetCellData()->AddArray(family);
  vtkNew<vtkPEMMeshView> view;
  view->SetMesh(mesh);
  view->SetColorArray("ElementFamily");
  view->SetClassLabels({ "comb" });
  auto picture = Paint(view, "Families");
  EXPECT_EQ(ColorAt(picture, view, 0.5, 0.5), (std::array<unsigned char, 3>{ 0, 0x72, 0xB2 }));
  EXPECT_EQ(ColorAt(picture, view, 0.15, 0.15), (std::array<unsigned char, 3>{ 238, 238, 238 }));

  view->SetColorArray("Number");
  ASSERT_TRUE(view->SetHighlightByName("both"));
  vtkNew<vtkPEMFigure> figure;
  figure->AddPanel(view);
  const std::string path = pemesh::TestPath("Extremes.pdf");
  ASSERT_TRUE(figure->Write(path));
  ASSERT_TRUE(ChartSupport::Run("pdftotext \"" + path + "\" \"" + path + ".txt\""));
  ASSERT_TRUE(ChartSupport::Run("grep -q 'min 1 (element 0)' \"" + path + ".txt\""));
  EXPECT_TRUE(ChartSupport::Run("grep -q 'max 9 (element 8)' \"" + path + ".txt\""));
}

TEST(MeshView, MarkedElementsAreFramedAndSaid)
{
  vtkNew<vtkPEMMeshView> view;
  view->SetMesh(ChartSupport::MakeSquares(3));
  view->SetMarkedElements({ 4, 7, -1, 9 }, "Framed: 2 of 9 elements.");
  auto picture = Paint(view, "Marked");
  const std::array<unsigned char, 3> frame = { 220, 0, 130 };
  const std::array<unsigned char, 3> fill = { 252, 212, 233 };
  EXPECT_EQ(ColorAt(picture, view, 0.5, 1.0 / 3.0), frame);
  EXPECT_EQ(ColorAt(picture, view, 0.5, 0.5), fill) << "element 4";
  EXPECT_EQ(ColorAt(picture, view, 0.5, 0.85), fill) << "element 7";
  EXPECT_NE(ColorAt(picture, view, 0.5, 0.15), fill);
  EXPECT_NE(ColorAt(picture, view, 0.15, 1.0 / 3.0), frame);
  vtkNew<vtkPEMFigure> figure;
  figure->AddPanel(view);
  const std::string path = pemesh::TestPath("Marked.pdf");
  ASSERT_TRUE(figure->Write(path));
  ASSERT_TRUE(ChartSupport::Run("pdftotext \"" + path + "\" \"" + path + ".txt\""));
  EXPECT_TRUE(ChartSupport::Run("grep -q 'Framed: 2 of 9 elements.' \"" + path + ".txt\""));
}

/** However many elements are marked, the extremes keep the rings that they are found by. */
TEST(MeshView, ManyMarkedElementsLeaveTheRingsOfTheExtremes)
{
  vtkNew<vtkPEMMeshView> view;
  view->SetMesh(ChartSupport::MakeSquares(60));
  view->SetColorArray("Number");
  view->SetHighlightByName("both");
  // In the colour of the largest element: its frame, its ring and its entry in the legend.
  const auto countInk = [](const ChartSupport::Picture& picture)
  {
    return std::count_if(picture.Pixels.begin(), picture.Pixels.end(),
      [](const auto& c) { return c[0] > 190 && c[1] < 130 && c[1] > 70 && c[2] < 60; });
  };
  const auto alone = countInk(Paint(view, "ExtremesAlone"));
  std::vector<vtkIdType> many;
  for (vtkIdType element = 0; element < 100; ++element)
  {
    many.push_back(1500 + 7 * element);
  }
  view->SetMarkedElements(many, "Framed: 100 elements.");
  EXPECT_GT(alone, 60);
  EXPECT_GT(countInk(Paint(view, "ExtremesAmongMany")), alone * 8 / 10);
}

TEST(MeshView, BadInputIsNamed)
{
  vtkNew<vtkPEMMeshView> view;
  EXPECT_EQ(view->WhyNotDrawable(), "The mesh view has no mesh.");
  auto mesh = ChartSupport::MakeSquares(2);
  view->SetMesh(mesh);
  view->SetColorArray("Wawe");
  EXPECT_EQ(
    view->WhyNotDrawable(), "The mesh has no array of numbers \"Wawe\"; the nearest is \"Wave\".");
  EXPECT_FALSE(view->SetColorMap("jet"));
  EXPECT_FALSE(view->SetHighlightByName("most"));
}

TEST(MeshView, MeshesThatCannotBeSeenAreNoError)
{
  vtkNew<vtkPEMMeshView> view;
  view->SetMesh(vtkSmartPointer<vtkPolyData>::New());
  view->SetColorArray("Area"); // its case failed before there was one
  EXPECT_GT(Paint(view, "NoMesh").Width, 0);
  const double nan = std::nan("");
  view->SetColorArray("");
  view->SetMesh(ChartSupport::MakeMesh(
    { { { 0, 0 }, { 1, 0 }, { nan, 1 } }, { { 0, 0 }, { 0, 0 }, { 0, 0 } } }));
  EXPECT_GT(Paint(view, "NaNMesh").Width, 0);
}

} // namespace
