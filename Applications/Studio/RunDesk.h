// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   RunDesk
 * @brief   The runs of the window: from their beginning to the results that are shown.
 */
#ifndef pemesh_RunDesk_h
#define pemesh_RunDesk_h

#include <QDateTime>
#include <QObject>
#include <QString>

#include <vector>

class QAction;
class QKeySequence;
class QTimer;
class QWidget;

namespace pemesh
{

class LogDock;
class ResultSet;
class RunController;
class Selection;
class Session;
class StudyModel;
class StudyPreview;

/** What runs are about, and where they tell. */
struct RunSurroundings
{
  StudyModel* Model;
  StudyPreview* Preview;
  ResultSet* Results;
  Selection* Selected;
  Session* Files;
  LogDock* Log;
};

class RunDesk : public QObject
{
  Q_OBJECT
public:
  RunDesk(const RunSurroundings& around, QWidget* window);

  enum ActionType
  {
    RunAll,
    RunSolver, ///< with the default solver where the study names none
    RunSome,
    Pause,
    Stop,
    Cancel,
    NumberOfActions
  };
  QAction* GetAction(ActionType type) const { return this->Actions[type]; }
  RunController* GetController() const { return this->Controller; }

  /** What goes on, for the status bar. */
  QString GetState() const;

  /**
   * Whether nothing runs. What runs is paused, or ended where the study has no file, and Ended is
   * sent when that is done.
   */
  bool EndForClosing();

public slots:
  /** Runs the study as it stands, or continues the run that is paused. */
  void Run();
  void RunWithSolver();
  /** Asks which meshes. */
  void RunChosen();
  /** Shows what is enabled. */
  void ShowState();

signals:
  void StateChanged();
  /** The study should name a solver; its page should be seen. */
  void SolverWanted(const QString& name);
  void SolverPageWanted();
  /** After EndForClosing. */
  void Ended();

private:
  void MakeActions(QWidget* window);
  void Connect();
  void StartRun(const std::vector<int>& cases, bool continues);
  void FinishRun(bool isGood, const QString& folder, const QStringList& messages);
  void TellEnd(bool isGood, const QString& folder, const QStringList& messages);
  void ShowHalfWay();
  void KeepSelection();
  void LoadKeptResults();
  void LoadResultsOf(const QString& folder);

  RunSurroundings Around;
  QWidget* Window;
  RunController* Controller;
  QAction* Actions[NumberOfActions] = {};
  QString MeshInView; // its name, which stays when its row does not
  QTimer* HalfWayTimer = nullptr;
  QDateTime HalfWayTime; // of the table that is shown while a run goes on
  bool ClosesAfterRun = false;
  bool IsHalfWay = false;         // what is shown comes from a run that did not end
  bool IsRunOfOtherStudy = false; // another one was opened since it began
};

} // namespace pemesh

#endif
