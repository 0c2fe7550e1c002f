// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Cuts a triangle with linearly varying values into bands between levels: smooth colours made of
 * flat polygons, which every kind of file holds and which stay sharp at any size.
 */
#ifndef pemesh_ContourBands_h
#define pemesh_ContourBands_h

#include "Point2.h"
#include "pemeshChartsModule.h" // For export macro

#include <array>
#include <span>
#include <vector>

namespace pemesh
{

/** Polygons one after the other, by the number of vertices of each. */
struct PEMESHCHARTS_EXPORT PolygonBatch
{
  std::vector<double> Points; // x0 y0 x1 y1 …
  std::vector<int> Sizes;
  /** A polygon with coordinates that are not finite is left out. */
  void Add(std::span<const Point2> polygon);
};

struct ValuedPoint
{
  Point2 Position;
  double Value = 0.0;
};

class PEMESHCHARTS_EXPORT ContourBands
{
public:
  /**
   * Band i lies between levels[i] and levels[i + 1]; the first and last reach to infinity. Its
   * parts reach under those of the next band, up to levels[i + 2]: drawn in this order they leave
   * no seam.
   */
  explicit ContourBands(std::vector<double> levels);

  int GetNumberOfBands() const { return static_cast<int>(this->Levels.size()) - 1; }

  /** Adds the parts of a triangle (values not NaN) to `bands`, one batch a band. */
  void Cut(const std::array<ValuedPoint, 3>& triangle, std::vector<PolygonBatch>& bands);

private:
  int BandOf(double value) const;

  std::vector<double> Levels;
  std::vector<ValuedPoint> Rest;
  std::vector<ValuedPoint> Part;
  std::vector<Point2> Positions;
};

} // namespace pemesh

#endif
