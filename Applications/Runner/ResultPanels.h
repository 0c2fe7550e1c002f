// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Charts of a table of results and views of a mesh, with the titles that a reader expects.
 */
#ifndef pemesh_ResultPanels_h
#define pemesh_ResultPanels_h

#include "pemeshRunnerModule.h" // For export macro

#include <string>

#include <vtkSmartPointer.h> // For return types

class vtkPEMChart;
class vtkPEMMeshView;
class vtkPolyData;
class vtkTable;

namespace pemesh
{

class ColumnLabels;
struct StudyPlot;

/**
 * The chart that a plot asks for, of a table of results or of elements. A metric named as it is
 * (MinAngle) stands, in results, for the band from its smallest to its largest value with the mean
 * in it. Throws std::runtime_error with one sentence for an unknown kind or option.
 */
PEMESHRUNNER_EXPORT vtkSmartPointer<vtkPEMChart> MakeResultChart(
  const StudyPlot& plot, vtkTable* results, const ColumnLabels& labels);

/** A view of a mesh coloured by an array; errors diverge from zero, families are classes. */
PEMESHRUNNER_EXPORT vtkSmartPointer<vtkPEMMeshView> MakeMeshView(
  vtkPolyData* mesh, const std::string& array, const ColumnLabels& labels);

} // namespace pemesh

#endif
