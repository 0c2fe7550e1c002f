// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * How long a frame of a chart takes, as the window paints it: by Cairo, into pixels.
 *
 *   BenchmarkCharts [number of points = 1e6]
 *
 * For a scatter of that many points (a density; coloured by a number; by classes), lines, and a
 * scatter of 10^4 points, the most that are drawn one by one: the first frame, which reads the
 * table, a frame after zooming in a little (median of nine), how much quicker that is than drawing
 * every point as a dot, a pick and a selection by rectangle. Pictures of
 * 1200 x 800 pixels; milliseconds of processor time, with making and handing over the pixels.
 */
#include "ChartPick.h"
#include "vtkPEMCairoContextDevice2D.h"
#include "vtkPEMChart.h"

#include <vtkContext2D.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <string>
#include <vector>

namespace
{

/** Of processor time, which other programs do not change much. */
double Milliseconds(std::clock_t start)
{
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

void MakeTable(int points, vtkTable* table)
{
  std::mt19937 random(1);
  const auto uniform = [&random] { return std::ldexp(static_cast<double>(random()), -32); };
  vtkNew<vtkDoubleArray> index;
  vtkNew<vtkDoubleArray> x;
  vtkNew<vtkDoubleArray> y;
  vtkNew<vtkStringArray> family;
  index->SetName("index");
  x->SetName("x");
  y->SetName("y");
  family->SetName("family");
  for (int i = 0; i < points; ++i)
  {
    const double bell = uniform() + uniform() + uniform();
    index->InsertNextValue(i);
    x->InsertNextValue(std::exp(bell));
    y->InsertNextValue(std::pow(bell, 3.0) * std::exp(uniform()));
    family->InsertNextValue(i % 3 == 0 ? "comb" : "star");
  }
  table->AddColumn(index);
  table->AddColumn(x);
  table->AddColumn(y);
  table->AddColumn(family);
}

/** Time of a frame from nothing to pixels. */
template <typename Painting>
double TimeFrame(Painting paint)
{
  const auto start = std::clock();
  vtkNew<vtkPEMCairoContextDevice2D> device;
  device->SetPageSize(1200, 800);
  device->SetFormat(vtkPEMCairoContextDevice2D::FORMAT_PIXELS);
  device->Begin(nullptr);
  vtkNew<vtkContext2D> context;
  context->Begin(device);
  paint(context.Get());
  context->End();
  device->End();
  const std::string pixels = device->GetContents();
  return pixels.empty() ? std::nan("") : Milliseconds(start);
}

double TimeChart(vtkPEMChart* chart)
{
  chart->SetRectangle(0, 0, 1200, 800);
  chart->SetFontSize(14);
  return TimeFrame([chart](vtkContext2D* context) { chart->Paint(context); });
}

/** Every row as a dot, without axes and without any thinning. */
double TimePlain(vtkTable* table, const char* x)
{
  auto* xs = vtkDoubleArray::SafeDownCast(table->GetColumnByName(x));
  auto* ys = vtkDoubleArray::SafeDownCast(table->GetColumnByName("y"));
  const double* rangeX = xs->GetRange();
  const double* rangeY = ys->GetRange();
  std::vector<float> points;
  for (vtkIdType i = 0; i < xs->GetNumberOfValues(); ++i)
  {
    points.push_back(
      static_cast<float>(1200 * (xs->GetValue(i) - rangeX[0]) / (rangeX[1] - rangeX[0])));
    points.push_back(
      static_cast<float>(800 * (ys->GetValue(i) - rangeY[0]) / (rangeY[1] - rangeY[0])));
  }
  return TimeFrame(
    [&](vtkContext2D* context)
    {
      context->GetPen()->SetWidth(4.0F);
      context->DrawPoints(points.data(), static_cast<int>(points.size() / 2));
    });
}

void Measure(const char* name, vtkTable* table, const char* kind, const char* x, const char* color)
{
  vtkNew<vtkPEMChart> chart;
  chart->SetTable(table);
  chart->SetKindByName(kind);
  chart->SetXColumn(x);
  chart->AddYColumn("y");
  chart->SetLogAxes(kind == std::string("scatter") ? "xy" : "");
  chart->SetColorColumn(color);
  const double first = TimeChart(chart);
  std::vector<double> frames;
  for (int i = 0; i < 9; ++i)
  {
    chart->Zoom(600, 400, 1.02);
    frames.push_back(TimeChart(chart));
  }
  std::nth_element(frames.begin(), frames.begin() + 4, frames.end());
  const double frame = frames[4];
  auto start = std::clock();
  chart->Pick(600, 400);
  const double pick = Milliseconds(start);
  start = std::clock();
  chart->SelectRectangle(500, 300, 700, 500);
  const double select = Milliseconds(start);
  const double plain = TimePlain(table, x);
  std::printf("%-22s %8.1f %8.1f %8.1f %8.1f %8.1f %8.1f\n", name, first, frame, plain,
    plain / frame, pick, select);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char* argv[])
{
  const int points = argc > 1 ? static_cast<int>(std::atof(argv[1])) : 1000000;
  vtkNew<vtkTable> table;
  MakeTable(points, table);
  std::printf("%-22s %8s %8s %8s %8s %8s %8s   (ms, %d points)\n", "", "first", "frame", "plain",
    "ratio", "pick", "select", points);
  Measure("scatter, density", table, "scatter", "x", "");
  Measure("scatter, by a number", table, "scatter", "x", "index");
  Measure("scatter, by class", table, "scatter", "x", "family");
  Measure("line", table, "line", "index", "");
  vtkNew<vtkTable> few;
  MakeTable(10000, few);
  Measure("scatter, 10^4", few, "scatter", "x", "");
  Measure("scatter, 10^4, number", few, "scatter", "x", "index");
  vtkNew<vtkTable> line;
  MakeTable(std::min(points, 100000), line);
  Measure("line to and fro, 10^5", line, "line", "x", "");
  return EXIT_SUCCESS;
}
