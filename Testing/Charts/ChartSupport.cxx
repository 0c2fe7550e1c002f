// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartSupport.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <cairo.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>

namespace ChartSupport
{

vtkSmartPointer<vtkTable> MakeTable(
  const std::vector<std::pair<std::string, std::vector<double>>>& columns)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  for (const auto& [name, values] : columns)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name.c_str());
    for (const double value : values)
    {
      column->InsertNextValue(value);
    }
    table->AddColumn(column);
  }
  return table;
}

vtkSmartPointer<vtkPolyData> MakeMesh(const std::vector<Polygon>& polygons)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Polygon& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<int>(polygon.size()));
    for (const auto& vertex : polygon)
    {
      cells->InsertCellPoint(points->InsertNextPoint(vertex[0], vertex[1], 0.0));
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

vtkSmartPointer<vtkPolyData> MakeSquares(int n)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> wave;
  wave->SetName("Wave");
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      const double x = static_cast<double>(j) / n;
      const double y = static_cast<double>(i) / n;
      points->InsertNextPoint(x, y, 0.0);
      wave->InsertNextValue(
        std::sin(2.0 * std::numbers::pi * x) * std::sin(2.0 * std::numbers::pi * y));
    }
  }
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkDoubleArray> number;
  number->SetName("Number");
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const vtkIdType corner = i * (n + 1) + j;
      const vtkIdType ids[4] = { corner, corner + 1, corner + n + 2, corner + n + 1 };
      cells->InsertNextCell(4, ids);
      number->InsertNextValue(i * n + j + 1);
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  mesh->GetCellData()->AddArray(number);
  mesh->GetPointData()->AddArray(wave);
  return mesh;
}

Polygon MakeStar()
{
  Polygon star;
  for (int i = 0; i < 14; ++i)
  {
    const double angle = std::numbers::pi * i / 7.0 + std::numbers::pi / 2.0;
    const double radius = i % 2 == 0 ? 0.45 : 0.12;
    star.push_back({ 0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle) });
  }
  return star;
}

double Area(const Polygon& polygon)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const auto& a = polygon[i];
    const auto& b = polygon[(i + 1) % polygon.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * twice;
}

bool Run(const std::string& command, const std::string& outputFile)
{
  const std::string target = outputFile.empty() ? "" : " > \"" + outputFile + "\"";
  return std::system((command + target).c_str()) == 0;
}

const std::array<unsigned char, 3>& Picture::At(int column, int row) const
{
  return this->Pixels.at(static_cast<std::size_t>(row) * this->Width + column);
}

bool Picture::IsWhite(int column, int row) const
{
  const auto& pixel = this->At(column, row);
  return pixel[0] > 250 && pixel[1] > 250 && pixel[2] > 250;
}

Picture ReadPng(const std::string& path)
{
  Picture picture;
  cairo_surface_t* surface = cairo_image_surface_create_from_png(path.c_str());
  if (cairo_surface_status(surface) == CAIRO_STATUS_SUCCESS)
  {
    picture.Width = cairo_image_surface_get_width(surface);
    picture.Height = cairo_image_surface_get_height(surface);
    const unsigned char* data = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    for (int row = 0; row < picture.Height; ++row)
    {
      for (int column = 0; column < picture.Width; ++column)
      {
        const unsigned char* pixel = data + row * stride + 4 * column;
        picture.Pixels.push_back({ pixel[2], pixel[1], pixel[0] });
      }
    }
  }
  cairo_surface_destroy(surface);
  return picture;
}

Picture WriteAndRead(const std::string& png, const std::string& name)
{
  const std::string path = pemesh::TestPath(name);
  std::ofstream(path, std::ios::binary) << png;
  return ReadPng(path);
}

Picture Rasterise(const std::string& path, int width)
{
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".png")
  {
    return ReadPng(path);
  }
  const std::string target = path + "-raster";
  const std::string size = std::to_string(width);
  const std::string command = ending == ".svg"
    ? "rsvg-convert -w " + size + " -o \"" + target + ".png\" \"" + path + "\""
    : "pdftoppm -png -singlefile -scale-to-x " + size + " -scale-to-y -1 \"" + path + "\" \"" +
      target + "\"";
  return Run(command) ? ReadPng(target + ".png") : Picture();
}

double MeanDifference(const Picture& a, const Picture& b)
{
  if (a.Pixels.empty() || std::abs(a.Width - b.Width) > 1 || std::abs(a.Height - b.Height) > 1)
  {
    return 255.0;
  }
  const int width = std::min(a.Width, b.Width);
  const int height = std::min(a.Height, b.Height);
  double sum = 0.0;
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        sum += std::abs(a.At(column, row)[channel] - b.At(column, row)[channel]);
      }
    }
  }
  return sum / (3.0 * width * height);
}

} // namespace ChartSupport
