// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   CorrelationPage
 * @brief   The fourth page: any column of the results against any other, and what goes with what.
 */
#ifndef pemesh_CorrelationPage_h
#define pemesh_CorrelationPage_h

#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QStackedWidget;
class QToolButton;

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
  QComboBox* GetFit() const { return this->Fit; }
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
  void AddWords(const QString& text, bool isHeading);
  void ChooseColumns();

  ResultSet* Results;
  Selection* Selected;
  QStackedWidget* Stack = nullptr;
  QComboBox* X = nullptr;
  QComboBox* Y = nullptr;
  QComboBox* Color = nullptr;
  QComboBox* Fit = nullptr;
  QToolButton* LogX = nullptr;
  QToolButton* LogY = nullptr;
  PanelView* Chart = nullptr;
  QLineEdit* Filter = nullptr;
  QListWidget* Findings = nullptr;
  QLabel* NoFindings = nullptr;
  CorrelationModel* Matrix = nullptr;
  bool IsChosen = false; // by the user what is set against what
};

} // namespace pemesh

#endif
