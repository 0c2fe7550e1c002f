// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   RunController
 * @brief   Runs a study with vtkPEMRunner in a thread of its own.
 *
 * The results are made in a folder beside the final one and take its place when the run is done or
 * stopped: cancelling leaves the results of the run before as they were.
 */
#ifndef pemesh_RunController_h
#define pemesh_RunController_h

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QStringList>

#include <memory>
#include <string>

namespace pemesh
{

class RunController : public QObject
{
  Q_OBJECT
public:
  explicit RunController(QObject* parent = nullptr);
  /** Cancels what is running and waits for it. */
  ~RunController() override;

  /** The study as JSON text, the folder that its paths are relative to, and where results go. */
  void Start(const std::string& text, const std::string& studyFolder, const QString& output);

  bool IsRunning() const { return this->Running; }
  double GetSeconds() const { return static_cast<double>(this->Clock.elapsed()) / 1000.0; }

public slots:
  /** Ends soon and keeps the meshes that are done. */
  void Stop();
  /** Ends soon and keeps nothing. */
  void Cancel();

signals:
  void Started();
  void Progressed(double fraction);
  /** What a log should say. */
  void Told(const QString& line);
  /** `folder` holds the results; empty where there are none. */
  void Finished(bool isGood, const QString& folder, const QStringList& messages);

private:
  struct Run;
  void Finish(bool isGood, const QString& folder, const QStringList& messages);

  std::unique_ptr<Run> Current;
  QElapsedTimer Clock;
  bool Running = false;
};

} // namespace pemesh

#endif
