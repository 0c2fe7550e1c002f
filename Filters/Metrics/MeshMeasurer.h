// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Measures the elements of a mesh with several threads: what the filters of this module share.
 */
#ifndef pemesh_MeshMeasurer_h
#define pemesh_MeshMeasurer_h

#include "MetricRegistry.h"

#include <functional>
#include <memory>
#include <vector>

class vtkPolyData;

namespace pemesh
{

class MeshNeighbours;

enum class ElementCondition : unsigned char
{
  Measured,
  Repeated,  // a vertex was repeated and ignored
  Degenerate // everything is undefined
};

/** A metric and where its values go: one an element. */
struct MetricColumn
{
  const Metric* Definition;
  double* Values;
};

class MeshMeasurer
{
public:
  /** A mesh in which ElementAccess::WhyUnusable finds no fault. */
  explicit MeshMeasurer(vtkPolyData* mesh);
  ~MeshMeasurer();

  /**
   * Fills the columns. Those that need the mesh take the values of their base metric from the
   * columns too, or measure it on the side. `goOn` is told the fraction done, from one thread, and
   * answers whether to go on; the answer here is the same. Throws std::length_error if neighbours
   * are needed and the mesh has more than 2^31 - 1 points or edges.
   */
  bool Measure(const std::vector<MetricColumn>& columns, const std::function<bool(double)>& goOn);

  /** Of each element, after Measure. */
  const std::vector<ElementCondition>& GetConditions() const { return this->Conditions; }

  /** Found when first asked for. */
  const MeshNeighbours& GetNeighbours();

private:
  bool MeasureAlone(
    const std::vector<MetricColumn>& columns, const std::function<bool(double)>& goOn);
  bool MeasureInMesh(const std::vector<MetricColumn>& columns, const MetricColumn& column,
    const std::function<bool(double)>& goOn);

  vtkPolyData* Mesh;
  std::vector<ElementCondition> Conditions;
  std::unique_ptr<MeshNeighbours> Neighbours;
};

} // namespace pemesh

#endif
