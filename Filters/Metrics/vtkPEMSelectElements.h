// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMSelectElements
 * @brief   The elements of a mesh whose metric is in a range, the worst ones, and the extreme ones.
 *
 * Input port 0 : vtkPolyData, a mesh with the cell array named (vtkPEMMetrics makes those of the
 *   metrics; any numeric cell array of one component will do).
 * Output port 0: vtkPolyData, the elements selected in the order of the mesh, with their points in
 *   double precision and no others, all point and cell arrays of the input, and
 *   OriginalElement (cells) and OriginalVertex (points) [vtkIdTypeArray], the ids in the input.
 * Output port 1: the elements that are not selected, in the same form.
 * Output port 2: the elements of the smallest and of the largest value of the mesh, whatever is
 *   selected, in the order of the mesh and in the same form, with the cell array Extreme
 *   [vtkIntArray]: -1 where the value is the smallest, 1 where it is the largest, 0 where all are
 *   the same. Of equal values the first element counts. Empty if no value is defined.
 * Elements where the metric is undefined are never selected.
 * A failed mesh is passed on as it is; one without the array fails with "no-such-array".
 *
 * vtkThreshold and vtkExtractSelection select too, but make vtkUnstructuredGrid of vtkPolyData.
 *
 * @sa vtkPEMMetrics vtkPEMMetricSummary
 */
#ifndef vtkPEMSelectElements_h
#define vtkPEMSelectElements_h

#include "pemeshFiltersMetricsModule.h" // For export macro
#include <vtkPolyDataAlgorithm.h>

#include <limits>
#include <string> // For arguments
#include <vector>

class PEMESHFILTERSMETRICS_EXPORT vtkPEMSelectElements : public vtkPolyDataAlgorithm
{
public:
  static vtkPEMSelectElements* New();
  vtkTypeMacro(vtkPEMSelectElements, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The cell array by which elements are selected. Default: "KernelAreaRatio". */
  void SetMetric(const std::string& name);
  std::string GetMetric() const { return this->Metric; }
  ///@}

  /** The output ports. */
  enum OutputPort
  {
    SelectedPort,
    OtherPort,
    ExtremePort
  };

  /** How elements are selected. */
  enum SelectionMode
  {
    Range,    ///< from Minimum to Maximum, both included
    Smallest, ///< the Count elements of the smallest values
    Largest,  ///< the Count elements of the largest values
    Worst,    ///< Smallest or Largest, as the registry says which end of the metric is good
    NotZero   ///< values other than zero, of an array that marks elements
  };
  ///@{
  /** Default: Range. Worst is an error for an array that is no metric with a good end. */
  vtkSetClampMacro(Mode, int, Range, NotZero);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /** The range. Default: from minus to plus infinity, all elements whose metric is defined. */
  vtkSetMacro(Minimum, double);
  vtkGetMacro(Minimum, double);
  vtkSetMacro(Maximum, double);
  vtkGetMacro(Maximum, double);
  ///@}

  /**
   * Metric, mode and range at once: Range as in "MinAngle:0.1:0.5" (ElementSelection.h), or NotZero
   * with the name of an array alone. A text that is neither is an error, and changes nothing.
   */
  void SetSelection(const std::string& text);

  ///@{
  /** How many extreme elements; of equal values the first ones. At least 0. Default: 10. */
  vtkSetClampMacro(Count, vtkIdType, 0, std::numeric_limits<vtkIdType>::max());
  vtkGetMacro(Count, vtkIdType);
  ///@}

protected:
  vtkPEMSelectElements();
  ~vtkPEMSelectElements() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPEMSelectElements(const vtkPEMSelectElements&) = delete;
  void operator=(const vtkPEMSelectElements&) = delete;

  int GetEffectiveMode() const;
  std::vector<vtkIdType> Select(const std::vector<double>& values, int mode) const;

  std::string Metric = "KernelAreaRatio";
  int Mode = Range;
  double Minimum = -std::numeric_limits<double>::infinity();
  double Maximum = std::numeric_limits<double>::infinity();
  vtkIdType Count = 10;
};

#endif
