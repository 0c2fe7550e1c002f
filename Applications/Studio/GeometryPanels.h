// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The metrics of meshes as charts, and a mesh coloured by one as a file.
 */
#ifndef pemesh_GeometryPanels_h
#define pemesh_GeometryPanels_h

#include "MeshPicture.h"

#include <QString>

#include <string>

class vtkPEMPanel;

namespace pemesh
{

class ColumnLabels;
struct Study;

/** The column that the meshes of a study are drawn over. */
std::string AbscissaOf(const Study& study);

/** Smallest, mean and largest value of a metric; a small chart has no title of its y axis. */
vtkSmartPointer<vtkPEMPanel> MakeMetricChart(const std::string& metric, const std::string& x,
  vtkTable* table, const ColumnLabels& labels, bool isSmall);

/**
 * Writes a mesh coloured by a metric as PNG, SVG or PDF, or the table of its elements as CSV.
 * Answers with a fault, or "".
 */
QString ExportPicture(const MeshPicture& picture, const std::string& file,
  const std::string& metric, const ColumnLabels& labels);

} // namespace pemesh

#endif
