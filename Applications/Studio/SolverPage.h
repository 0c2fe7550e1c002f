// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   SolverPage
 * @brief   The third page: the solvers of the study, their run, and what came of it.
 */
#ifndef pemesh_SolverPage_h
#define pemesh_SolverPage_h

#include <QWidget>

class QBoxLayout;
class QComboBox;
class QListWidget;
class QTabWidget;
class QToolButton;

namespace pemesh
{

struct FormField;
class FailureList;
class OptionForm;
class PanelView;
class ResultSet;
class RunController;
class Selection;
class StudyModel;
class SurfaceWindow;
class TimeBar;

class SolverPage : public QWidget
{
  Q_OBJECT
public:
  SolverPage(StudyModel* model, ResultSet* results, RunController* controller, Selection* selection,
    QWidget* parent = nullptr);

  /** Adds a run of a solver, by its name or the file that describes it. */
  void AddSolver(const QString& solver);
  QTabWidget* GetTabs() const { return this->Tabs; }
  PanelView* GetSolutions() const { return this->Solutions; }
  PanelView* GetCharts() const { return this->Charts; }
  SurfaceWindow* GetSurface() const { return this->Surface; }
  FailureList* GetFailures() const { return this->Failures; }

signals:
  void RunWanted();
  void SomeWanted();

private:
  QWidget* MakeLeft();
  QBoxLayout* MakeSolverLine(QWidget* panel);
  QWidget* MakeRight();
  void MakeViews();
  void ShowRuns();
  void ShowResults();
  void ShowCase(int index);
  void ShowSolutions();
  void ShowCharts();
  void ShowSurfaces();
  std::vector<FormField> DescribeOptions(int run) const;

  StudyModel* Model;
  ResultSet* Results;
  RunController* Controller;
  Selection* Selected;
  QListWidget* Runs = nullptr;
  QComboBox* Known = nullptr;
  OptionForm* Form = nullptr;
  QTabWidget* Tabs = nullptr;
  QComboBox* Shown = nullptr;
  QToolButton* Surfaces = nullptr;
  SurfaceWindow* Surface = nullptr;
  PanelView* Solutions = nullptr;
  PanelView* Charts = nullptr;
  FailureList* Failures = nullptr;
  TimeBar* Cases = nullptr;
};

} // namespace pemesh

#endif
