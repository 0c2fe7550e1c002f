// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   RunController
 * @brief   Runs a study with vtkPEMRunner in a thread of its own.
 *
 * The results are made in a folder beside the final one and take its place when the run is done or
 * stopped: cancelling leaves the results of the run before as they were. A run that is paused
 * leaves that folder, and goes on from it later, even after the program was ended: meshes that are
 * done are taken as they are, as far as the study still says the same of them.
 */
#ifndef pemesh_RunController_h
#define pemesh_RunController_h

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QStringList>

#include <memory>
#include <string>
#include <vector>

namespace pemesh
{

/** What is to be run. */
struct RunRequest
{
  std::string Text;       ///< the study as JSON
  std::string Folder;     ///< that its paths are relative to
  QString Output;         ///< where the results go
  std::vector<int> Cases; ///< the meshes, by their numbers from 0; none: all
  bool Continues = false; ///< goes on from what was paused
};

class RunController : public QObject
{
  Q_OBJECT
public:
  explicit RunController(QObject* parent = nullptr);
  /** Cancels what is running and waits for it. */
  ~RunController() override;

  /** A run that is paused is given up, unless the request continues it. */
  void Start(const RunRequest& request);

  bool IsRunning() const { return this->Now == State::Running; }
  bool IsPaused() const { return this->Now == State::Paused; }
  double GetSeconds() const { return static_cast<double>(this->Clock.elapsed()) / 1000.0; }
  /** What is done so far of a run that runs or is paused; else empty. */
  QString GetWorkFolder() const;

  /** Where the results of the last run go. */
  QString GetOutput() const { return this->Output; }

  /** What is paused stays in its folder. */
  void Forget();

  /** Is paused from now on if a run with these results did not end, else idle. */
  bool FindUnfinished(const QString& output);

public slots:
  /** Ends soon, to be continued. */
  void Pause();
  /** Ends soon and keeps the meshes that are done. */
  void Stop();
  /** Ends soon and keeps nothing. */
  void Cancel();

signals:
  void Started();
  void Progressed(double fraction);
  /** What a log should say. */
  void Told(const QString& line);
  /** `folder` holds the results, so far if the run is paused now; empty where there are none. */
  void Finished(bool isGood, const QString& folder, const QStringList& messages);
  /** Without a run: see FindUnfinished. */
  void StateChanged();

private:
  struct Run;
  enum class State
  {
    Idle,
    Running,
    Paused
  };

  void Launch();
  void StopRunner();
  void EndPaused(bool discards);
  void Finish(bool isGood, const QString& folder, const QStringList& messages);

  std::unique_ptr<Run> Current;
  QElapsedTimer Clock;
  QString Output;
  State Now = State::Idle;
};

} // namespace pemesh

#endif
