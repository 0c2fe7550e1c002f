// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What a solver made of a study, as panels: the fields on one mesh, the performances over all.
 */
#ifndef pemesh_SolutionPanels_h
#define pemesh_SolutionPanels_h

#include "MeshPicture.h"
#include "PanelScene.h"

#include <string>

class vtkTable;

namespace pemesh
{

class ColumnLabels;
struct Study;

/** Solution and ground truth on one scale, the errors, and a metric beside them; what there is. */
PanelList MakeSolutionPanels(const MeshPicturePointer& picture, const std::string& run,
  const std::string& metric, const ColumnLabels& labels);

/** A chart of every performance of a run, over what is swept. */
PanelList MakePerformancePanels(
  const Study& study, const std::string& run, vtkTable* results, const ColumnLabels& labels);

} // namespace pemesh

#endif
