// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMMetrics
 * @brief   Measures every element of a mesh.
 *
 * Input port 0 : vtkPolyData of simple polygons in the plane (z is ignored), either orientation.
 * Output port 0: the same mesh and one vtkDoubleArray of cell data a metric, named as in the
 *   registry (MetricRegistry.h), which tells formula, unit, range and reference of each.
 * Time: passed through.  Threads: the same bits for any number.
 * Cost: each shared kernel (circles, kernel, angles, ...) once an element, and only if a chosen
 *   metric needs it; linear in the number of elements. Metrics that need neighbours use some 20
 *   bytes an edge of an element and 24 a vertex while they are computed.
 * Undefined: an element with fewer than three distinct vertices, without area, with edges that
 *   cross or run along each other, or with coordinates that are not finite has NaN for every
 *   metric; a warning tells how many there are. A repeated vertex is ignored, also with a warning.
 * Metrics that the mesh brings as arrays are measured anew even if they are not asked for: it may
 *   have been scaled or moved since, and no summary should mix old values with new ones.
 * A mesh that has failed already is passed on as it is; one with cells other than polygons
 *   fails with the status "unusable-mesh".
 *
 * @sa vtkPEMMetricSummary
 */
#ifndef vtkPEMMetrics_h
#define vtkPEMMetrics_h

#include "pemeshFiltersMetricsModule.h" // For export macro
#include <vtkPolyDataAlgorithm.h>

#include <string> // For arguments
#include <vector> // For arguments

namespace pemesh
{
enum class ElementCondition : unsigned char;
}

class PEMESHFILTERSMETRICS_EXPORT vtkPEMMetrics : public vtkPolyDataAlgorithm
{
public:
  static vtkPEMMetrics* New();
  vtkTypeMacro(vtkPEMMetrics, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The metrics to compute, by name or alias, or by a word that stands for several: "all" (the
   * default: every metric of the shape of an element), "neighbourhood", "jumps", "solver".
   * Arrays are made in the order of the registry whatever the order here. A name that is unknown
   * is an error that tells the nearest known one, and changes nothing.
   */
  void SetMetrics(const std::vector<std::string>& names);
  void AddMetric(const std::string& name);
  void RemoveAllMetrics();
  void SelectAllMetrics();
  std::vector<std::string> GetMetrics() const;
  ///@}

  /** The names that "all" stands for, in the order of the registry. */
  static std::vector<std::string> GetAvailableMetrics();

protected:
  vtkPEMMetrics();
  ~vtkPEMMetrics() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPEMMetrics(const vtkPEMMetrics&) = delete;
  void operator=(const vtkPEMMetrics&) = delete;

  void WarnOfElements(const std::vector<pemesh::ElementCondition>& conditions);

  std::vector<std::string> Metrics;
};

#endif
