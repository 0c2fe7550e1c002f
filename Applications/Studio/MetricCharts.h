// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   MetricCharts
 * @brief   A small chart of every metric over the meshes, in the order of the study or of a metric.
 *
 * A click selects a mesh and a metric, a rectangle marks meshes, a double click opens a chart on
 * the whole screen.
 */
#ifndef pemesh_MetricCharts_h
#define pemesh_MetricCharts_h

#include "GeometryPanels.h"

#include <QWidget>

class QComboBox;
class QStackedWidget;

namespace pemesh
{

class PanelView;
class ResultSet;
class Selection;

class MetricCharts : public QWidget
{
  Q_OBJECT
public:
  MetricCharts(ResultSet* results, Selection* selection, QWidget* parent = nullptr);

  PanelView* GetView() const { return this->View; }
  /** 0: as in the study; 1, 2, 3: by the smallest, mean, largest value of the selected metric. */
  QComboBox* GetOrder() const { return this->Order; }
  /** The row of the results that a place of the charts shows, and the other way round. */
  vtkIdType RowAt(vtkIdType place) const;
  std::vector<vtkIdType> PlacesOf(const std::vector<vtkIdType>& rows) const;

signals:
  void RunWanted();
  void Told(const QString& line);

private:
  void Show();
  void Connect();
  void ShowOrders();
  void ShowMarks();
  void Detach(int panel);
  /** The table in the order chosen, for the makers of charts. */
  MetricChartTable GetTable() const;

  ResultSet* Results;
  Selection* Selected;
  QStackedWidget* Stack;
  QComboBox* Order;
  PanelView* View;
  std::vector<vtkIdType> Rows; // in the order of the charts; empty: as they are
};

} // namespace pemesh

#endif
