// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Data for the tests of charts, and pictures read back as pixels.
 */
#ifndef ChartSupport_h
#define ChartSupport_h

#include "TestFolder.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace ChartSupport
{

using Polygon = std::vector<std::array<double, 2>>;

/** A table of columns of numbers. */
vtkSmartPointer<vtkTable> MakeTable(
  const std::vector<std::pair<std::string, std::vector<double>>>& columns);

/** A mesh of separate polygons: no vertex is shared. */
vtkSmartPointer<vtkPolyData> MakeMesh(const std::vector<Polygon>& polygons);

/** The unit square as n x n squares that share their vertices, with a cell array and a point array.
 */
vtkSmartPointer<vtkPolyData> MakeSquares(int n);

/** A star of 7 spikes around the middle of the unit square, and its area by the shoelace formula.
 */
Polygon MakeStar();
double Area(const Polygon& polygon);

/** Runs a program, true if it ended with 0. Its output goes to a file, unless that is empty. */
bool Run(const std::string& command, const std::string& outputFile = std::string());

struct Picture
{
  int Width = 0;
  int Height = 0;
  std::vector<std::array<unsigned char, 3>> Pixels; // top row first

  /** Column from the left, row from the top. */
  const std::array<unsigned char, 3>& At(int column, int row) const;
  bool IsWhite(int column, int row) const;
};

Picture ReadPng(const std::string& path);

/** A PNG in memory, left among the output files. */
Picture WriteAndRead(const std::string& png, const std::string& name);

/** The file as a picture of this width: PNG as it is, SVG by rsvg-convert, PDF by pdftoppm. */
Picture Rasterise(const std::string& path, int width);

/** Mean absolute difference of all channels, 0 to 255; 255 where the sizes differ. */
double MeanDifference(const Picture& a, const Picture& b);

} // namespace ChartSupport

#endif
