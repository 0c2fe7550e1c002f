// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   StudioWindow
 * @brief   The window of PEMesh Studio: four pages over one study, one preview and one result.
 */
#ifndef pemesh_StudioWindow_h
#define pemesh_StudioWindow_h

#include <QDateTime>
#include <QMainWindow>

#include <vector>

class QAction;
class QButtonGroup;
class QLabel;
class QMenu;
class QProgressBar;
class QStackedWidget;
class QTimer;

namespace pemesh
{

class CorrelationPage;
class GeometryPage;
class LogDock;
class MeshPage;
class ResultSet;
class RunController;
class Selection;
class Session;
class SolverPage;
class StudyModel;
class StudyPreview;

class StudioWindow : public QMainWindow
{
  Q_OBJECT
public:
  explicit StudioWindow(QWidget* parent = nullptr);
  ~StudioWindow() override;

  enum Page
  {
    MeshPageIndex,
    GeometryPageIndex,
    SolverPageIndex,
    CorrelationPageIndex
  };

  StudyModel* GetModel() const { return this->Model; }
  StudyPreview* GetPreview() const { return this->Preview; }
  ResultSet* GetResults() const { return this->Results; }
  RunController* GetController() const { return this->Controller; }
  Selection* GetSelection() const { return this->Selected; }
  Session* GetSession() const { return this->Files; }
  LogDock* GetLog() const { return this->Log; }
  MeshPage* GetMeshPage() const { return this->Meshes; }

  /** A study, or meshes. */
  bool OpenFiles(const QStringList& files);
  void ShowPage(int page);

public slots:
  /** Runs the study as it stands, or continues the run that is paused. */
  void Run();
  /** With the default solver where the study names none. */
  void RunWithSolver();
  /** Asks which meshes. */
  void RunSome();

protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  void MakePages();
  void MakeNavigation();
  void MakeMenus();
  void MakeFileMenu();
  void MakeViewMenu();
  void MakeHelpMenu();
  void MakeToolBar();
  void MakeStatusBar();
  void MakeReachable();
  QAction* AddAction(QMenu* menu, const char* icon, const QString& text, const QKeySequence& key);
  void ShowTitle();
  void ShowRunning();
  void FinishRun(bool isGood, const QString& folder, const QStringList& messages);
  void SaveMesh();
  void SavePolygons();
  void ShowPlotSettings();
  void ShowReference(const QString& title, const QString& markdown);
  void OpenResults();
  void ConnectRuns();
  void StartRun(const std::vector<int>& cases, bool continues);
  void ShowHalfWay();
  void KeepSelection();
  void LoadKeptResults();
  void LoadResultsOf(const QString& folder);
  void ShowAbout();

  StudyModel* Model;
  StudyPreview* Preview;
  ResultSet* Results;
  RunController* Controller;
  Selection* Selected;
  Session* Files;
  LogDock* Log = nullptr;
  QStackedWidget* Pages = nullptr;
  QButtonGroup* Navigation = nullptr;
  MeshPage* Meshes = nullptr;
  GeometryPage* Geometry = nullptr;
  SolverPage* Solver = nullptr;
  CorrelationPage* Correlation = nullptr;
  QAction* SaveAction = nullptr;
  QAction* SaveMeshAction = nullptr;
  QAction* UndoAction = nullptr;
  QAction* RedoAction = nullptr;
  QAction* RunAction = nullptr;
  QAction* RunSomeAction = nullptr;
  QAction* PauseAction = nullptr;
  QAction* StopAction = nullptr;
  QAction* CancelAction = nullptr;
  QProgressBar* Progress = nullptr;
  QLabel* Status = nullptr;
  QString MeshInView; // its name, which stays when its row does not
  QTimer* HalfWayTimer = nullptr;
  QDateTime HalfWayTime; // of the table that is shown while a run goes on
  bool ClosesAfterRun = false;
  bool IsHalfWay = false;         // what is shown comes from a run that did not end
  bool IsRunOfOtherStudy = false; // another one was opened since it began
};

} // namespace pemesh

#endif
