// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Lays out and draws a mesh. Private to this module.
 */
#ifndef pemesh_MeshPainter_h
#define pemesh_MeshPainter_h

#include "ContourBands.h"
#include "PanelPainter.h"

#include <vtkType.h> // For vtkIdType

#include <limits>
#include <span>
#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace pemesh
{

struct MeshStyle
{
  std::string Title;
  std::string ColorTitle;
  vtkDataArray* CellValues = nullptr;
  vtkDataArray* PointValues = nullptr; // where there are no cell values
  std::string MapName = "viridis";
  bool Logarithmic = false;
  bool Diverging = false;
  double Range[2] = { std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN() }; // NaN: of the values
  std::vector<std::string> ClassLabels;
  bool Outlines = true;
  bool OutlinesAreAutomatic = true;
  bool MarkSmallest = false;
  bool MarkLargest = false;
  std::vector<vtkIdType> Marked;      // framed, beneath the smallest and the largest
  std::string MarkNote;               // a sentence about them
  std::vector<vtkIdType> Highlighted; // elements
};

class MeshPainter
{
public:
  /** The mesh is one that ElementAccess can use, or has no polygons. */
  MeshPainter(vtkContext2D* context, double em, vtkPolyData* mesh, const MeshStyle& style,
    const ChartStyle& look = {});

  void Paint(const Box& box);

  /** Device = offset + scale * (x, y): of the last painting. */
  Point2 Offset() const { return { this->OffsetX, this->OffsetY }; }
  double Scale() const { return this->ScaleFactor; }

private:
  void ReadBounds();
  void ReadElements();
  void FindClasses();
  void MakeColorScale();
  void FindExtremes();
  std::vector<LegendEntry> MakeLegend() const;
  std::string MakeNote() const;
  void FitIntoBox(Box box);
  void PlaceLegend(const std::vector<LegendEntry>& legend, const Box& box, double top);
  void FillByCells();
  void FillByPoints();
  void FillPlain();
  void FillBatches(const std::vector<PolygonBatch>& batches, const std::vector<ChartColor>& colors,
    double seamWidth);
  void FillBatch(const PolygonBatch& batch, const ChartColor& color, double seamWidth);
  void DrawOutlines();
  void DrawElementOutline(vtkIdType element, double ems, const ChartColor& color);
  /** Frames an element, with a ring around one that would be overlooked. */
  void MarkElement(vtkIdType element, const ChartColor& color, bool mayHaveRing);
  bool IsElement(vtkIdType element) const;
  Point2 ToDevice(const Point2& point) const;
  std::span<const Point2> ElementInDevice(vtkIdType element) const;
  vtkIdType NumberOfElements() const;
  double CellValue(vtkIdType element) const;
  ChartColor ClassColor(int value) const;

  PanelPainter Painter;
  vtkPolyData* Mesh;
  const MeshStyle& Style;
  double Em;
  std::vector<Point2> Vertices;     // of all elements, one after the other
  std::vector<Point2> Placed;       // the same in the device
  std::vector<vtkIdType> PointIds;  // of the same
  std::vector<std::size_t> FirstOf; // of every element, and the end
  double Bounds[4] = { 0.0, 1.0, 0.0, 1.0 };
  double OffsetX = 0.0;
  double OffsetY = 0.0;
  double ScaleFactor = 1.0;
  Box Picture;
  bool HasColorBar = false;
  ColorScale Colors;
  std::vector<int> Classes; // the values of a cell array of classes; empty otherwise
  long Uncoloured = 0;
  vtkIdType Smallest = -1;
  vtkIdType Largest = -1;
};

} // namespace pemesh

#endif
