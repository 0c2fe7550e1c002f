// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   StudioWindow
 * @brief   The window of PEMesh Studio: four pages over one study, one preview and one result.
 */
#ifndef pemesh_StudioWindow_h
#define pemesh_StudioWindow_h

#include <QMainWindow>

class QAction;
class QButtonGroup;
class QLabel;
class QProgressBar;
class QStackedWidget;

namespace pemesh
{

class CorrelationPage;
class GeometryPage;
class LogDock;
class MeshPage;
class ResultSet;
class RunController;
class RunDesk;
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
  RunController* GetController() const;
  RunDesk* GetRuns() const { return this->Runs; }
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
  void MakeToolBar();
  void MakeStatusBar();
  void MakeReachable();
  void ConnectRuns();
  void ShowTitle();
  void ShowRunning();

  StudyModel* Model;
  StudyPreview* Preview;
  ResultSet* Results;
  Selection* Selected;
  Session* Files;
  RunDesk* Runs = nullptr;
  LogDock* Log = nullptr;
  QStackedWidget* Pages = nullptr;
  QButtonGroup* Navigation = nullptr;
  MeshPage* Meshes = nullptr;
  GeometryPage* Geometry = nullptr;
  SolverPage* Solver = nullptr;
  CorrelationPage* Correlation = nullptr;
  QAction* SaveAction = nullptr;
  QProgressBar* Progress = nullptr;
  QLabel* Status = nullptr;
  bool IsClosing = false; // when what runs has ended
};

} // namespace pemesh

#endif
