// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   GeometryPage
 * @brief   The second page: what the elements of the meshes measure.
 *
 * Before a run it shows the mesh of the preview; afterwards the meshes of the results.
 */
#ifndef pemesh_GeometryPage_h
#define pemesh_GeometryPage_h

#include "MeshPicture.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QStackedWidget;
class QTableView;
class QToolBar;

namespace pemesh
{

class ElementTableModel;
class LatestJob;
class MeshCanvas;
class MetricCharts;
class PanelView;
class ResultSet;
class Selection;
class StudyPreview;
class TimeBar;

class GeometryPage : public QWidget
{
  Q_OBJECT
public:
  GeometryPage(
    StudyPreview* preview, ResultSet* results, Selection* selection, QWidget* parent = nullptr);

  MeshCanvas* GetCanvas() const { return this->Canvas; }
  QTableView* GetTable() const { return this->Table; }
  MetricCharts* GetCharts() const { return this->Charts; }
  PanelView* GetScatter() const { return this->Scatter; }
  /** 0: mesh, 1: charts of all metrics, 2: scatter. */
  void ShowView(int view);
  MeshPicturePointer GetPicture() const;

  /** Writes the mesh as PNG, SVG or PDF, its elements as CSV; Told says how it went. */
  void ExportMesh(const QString& file);

signals:
  void RunWanted();
  void PictureShown(const pemesh::MeshPicturePointer& picture);
  void Told(const QString& line);

protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  void MakeBar(QToolBar* bar);
  void MakeMetricBoxes(QToolBar* bar);
  void MakeToggles(QToolBar* bar);
  QWidget* MakeViews();
  QWidget* MakeSide();
  void ShowResults();
  void ShowPicture();
  void ShowMetric();
  void ShowScatter();
  void ShowElement(qint64 element);
  void ShowMarks();
  void FitColumns();
  void ShowCase(int index);
  void Export();
  QString GetMetric() const;

  StudyPreview* Preview;
  ResultSet* Results;
  Selection* Selected;
  QComboBox* Metric = nullptr;
  QComboBox* Against = nullptr;
  QAction* FixedScale = nullptr;
  QAction* LogScale = nullptr;
  QAction* Marked = nullptr;
  QStackedWidget* Views = nullptr;
  QList<QAction*> ViewActions;
  MeshCanvas* Canvas = nullptr;
  MetricCharts* Charts = nullptr;
  PanelView* Scatter = nullptr;
  ElementTableModel* Elements = nullptr;
  QTableView* Table = nullptr;
  TimeBar* Cases = nullptr;
  LatestJob* ExportJob = nullptr;
  QLabel* Source = nullptr;
};

} // namespace pemesh

#endif
