// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The metrics of meshes as charts, and a mesh coloured by one as a file.
 */
#ifndef pemesh_GeometryPanels_h
#define pemesh_GeometryPanels_h

#include "MeshPicture.h"

#include <QString>

#include <memory>
#include <string>
#include <vector>

class vtkPEMPanel;
class vtkTable;

namespace pemesh
{

class ColumnLabels;
struct Study;

/** The column that the meshes of a study are drawn over. */
std::string AbscissaOf(const Study& study);

/** The rows of a table in order of a column of numbers, those without a value last. */
std::vector<vtkIdType> RowsInOrder(vtkTable* table, const std::string& column);

/** What charts of metrics are made of. */
struct MetricChartTable
{
  vtkSmartPointer<vtkTable> Table;
  std::shared_ptr<const ColumnLabels> Labels;
  std::vector<vtkIdType> Rows; ///< in the order of the chart; empty: as they are
  std::string X;               ///< the abscissae, where the order is that of the table
  std::string XTitle;          ///< "": that of the column

  /** With the rows in that order, over their places in it from 1. */
  MetricChartTable Arrange() const;
};

/** Smallest, mean and largest value of a metric; a small chart has no title of its y axis. */
vtkSmartPointer<vtkPEMPanel> MakeMetricChart(
  const std::string& metric, const MetricChartTable& data, bool isSmall);

/**
 * Writes a mesh coloured by a metric as PNG, SVG or PDF, or the table of its elements as CSV.
 * Answers with a fault, or "".
 */
QString ExportPicture(const MeshPicture& picture, const std::string& file,
  const std::string& metric, const ColumnLabels& labels);

} // namespace pemesh

#endif
