// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   CorrelationPage
 * @brief   The fourth page: any column of the results against any other, and what goes with what.
 */
#ifndef pemesh_CorrelationPage_h
#define pemesh_CorrelationPage_h

#include <QWidget>

class QAction;
class QComboBox;
class QLineEdit;
class QListWidget;
class QStackedWidget;

namespace pemesh
{

class CorrelationModel;
class PanelView;
class ResultSet;
class Selection;

class CorrelationPage : public QWidget
{
  Q_OBJECT
public:
  CorrelationPage(ResultSet* results, Selection* selection, QWidget* parent = nullptr);

  PanelView* GetChart() const { return this->Chart; }
  QListWidget* GetFindings() const { return this->Findings; }
  void SetColumns(const QString& x, const QString& y);

signals:
  void RunWanted();
  void Told(const QString& line);
  /** A point was double clicked: its mesh is wanted elsewhere. */
  void MeshWanted();

private:
  QWidget* MakeBar();
  QWidget* MakeSide();
  void ShowResults();
  void ShowChart();
  void ShowFindings();

  ResultSet* Results;
  Selection* Selected;
  QStackedWidget* Stack = nullptr;
  QComboBox* X = nullptr;
  QComboBox* Y = nullptr;
  QComboBox* Color = nullptr;
  QAction* LogX = nullptr;
  QAction* LogY = nullptr;
  PanelView* Chart = nullptr;
  QLineEdit* Filter = nullptr;
  QListWidget* Findings = nullptr;
  CorrelationModel* Matrix = nullptr;
};

} // namespace pemesh

#endif
