// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * How long a frame of a chart takes.
 *
 *   BenchmarkCharts [number of points = 1e6]
 *
 * For a scatter of that many points (a density; coloured by a number; by classes), and a line: the
 * first painting, which reads the table, a frame after zooming in a little (median of nine), a pick
 * and a selection by rectangle. Painted by Cairo into a picture of 1200 x 800 pixels; milliseconds
 * of processor time.
 */
#include "ChartPick.h"
#include "vtkPEMCairoContextDevice2D.h"
#include "vtkPEMChart.h"

#include <vtkContext2D.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
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

/** Time of painting alone: not of making or encoding the page. */
double PaintOnce(vtkPEMChart* chart)
{
  vtkNew<vtkPEMCairoContextDevice2D> device;
  device->SetPageSize(1200, 800);
  chart->SetRectangle(0, 0, 1200, 800);
  chart->SetFontSize(14);
  device->Begin(nullptr);
  vtkNew<vtkContext2D> context;
  context->Begin(device);
  const auto start = std::clock();
  chart->Paint(context);
  const double time = Milliseconds(start);
  context->End();
  device->End();
  return time;
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
  const double first = PaintOnce(chart);
  std::vector<double> frames;
  for (int i = 0; i < 9; ++i)
  {
    chart->Zoom(600, 400, 1.02);
    frames.push_back(PaintOnce(chart));
  }
  std::nth_element(frames.begin(), frames.begin() + 4, frames.end());
  auto start = std::clock();
  chart->Pick(600, 400);
  const double pick = Milliseconds(start);
  start = std::clock();
  chart->SelectRectangle(500, 300, 700, 500);
  std::printf("%-22s %8.1f %8.1f %8.1f %8.1f\n", name, first, frames[4], pick, Milliseconds(start));
}

} // namespace

int main(int argc, char* argv[])
{
  const int points = argc > 1 ? static_cast<int>(std::atof(argv[1])) : 1000000;
  vtkNew<vtkTable> table;
  MakeTable(points, table);
  std::printf(
    "%-22s %8s %8s %8s %8s   (ms, %d points)\n", "", "first", "frame", "pick", "select", points);
  Measure("scatter, density", table, "scatter", "x", "");
  Measure("scatter, by a number", table, "scatter", "x", "index");
  Measure("scatter, by class", table, "scatter", "x", "family");
  Measure("line", table, "line", "index", "");
  return EXIT_SUCCESS;
}
