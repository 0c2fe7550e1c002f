// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The values of metrics of a mesh, whether they have been measured or not.
 */
#ifndef pemesh_MeshValues_h
#define pemesh_MeshValues_h

#include "MeshMeasurer.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace pemesh
{

class MeshValues
{
public:
  explicit MeshValues(vtkPolyData* mesh);

  /**
   * Measures these metrics, if the mesh has no arrays of them. Nothing for a mesh that cannot be
   * measured, or for a name that is neither an array nor a metric.
   */
  void Provide(const std::vector<std::string>& metrics);

  /** The array of that name, or what Provide measured; empty if there is neither. */
  std::span<const double> Get(const std::string& metric) const;

  /** Null where they cannot be found. */
  const MeshNeighbours* GetNeighbours();

private:
  vtkPolyData* Mesh;
  bool IsUsable;
  MeshMeasurer Measurer;
  std::map<std::string, std::vector<double>> Measured; // and copies of arrays of other types
};

} // namespace pemesh

#endif
