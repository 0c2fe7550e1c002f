// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RunDesk.h"

#include "Icons.h"
#include "LogDock.h"
#include "MeshChoiceDialog.h"
#include "ResultSet.h"
#include "RunController.h"
#include "Selection.h"
#include "Session.h"
#include "StudyModel.h"
#include "StudyPreview.h"

#include <QAction>
#include <QFileInfo>
#include <QTimer>

#include <utility>

namespace pemesh
{

namespace
{

constexpr int HalfWayMilliseconds = 500; // between two looks at what a run has done
constexpr const char* DefaultSolver = "pemesh-vem";

QString TableOf(const QString& folder)
{
  return folder + QStringLiteral("/results.csv");
}

} // namespace

RunDesk::RunDesk(const RunSurroundings& around, QWidget* window)
  : QObject(window)
  , Around(around)
  , Window(window)
  , Controller(new RunController(this))
{
  this->MakeActions(window);
  this->Connect();
  this->ShowState();
}

void RunDesk::MakeActions(QWidget* window)
{
  const auto add = [this, window](ActionType type, const char* icon, const QString& text,
                     const char* key, auto* receiver, auto slot)
  {
    auto* action = new QAction(MakeIcon(icon), text, window);
    action->setShortcut(QKeySequence(QLatin1String(key)));
    action->setToolTip(
      QStringLiteral("%1 (%2)").arg(QString(text).remove('&'), QLatin1String(key)));
    connect(action, &QAction::triggered, receiver, slot);
    window->addAction(action);
    this->Actions[type] = action;
  };
  RunController* controller = this->Controller;
  add(RunAll, "run", tr("Run study"), "F5", this, &RunDesk::Run);
  add(RunSolver, "solver", tr("Run the &solver"), "Ctrl+R", this, &RunDesk::RunWithSolver);
  add(RunSome, "run", tr("Run some &meshes …"), "Alt+F5", this, &RunDesk::RunChosen);
  add(Pause, "pause", tr("Pause the run"), "Ctrl+Shift+F5", controller, &RunController::Pause);
  add(Stop, "stop", tr("Stop and keep what is done"), "Shift+F5", controller, &RunController::Stop);
  add(Cancel, "cancel", tr("Cancel the run"), "Ctrl+F5", controller, &RunController::Cancel);
  this->Actions[RunSolver]->setToolTip(
    tr("Run the study, with the solver %1 where it names none (Ctrl+R)")
      .arg(QLatin1String(DefaultSolver)));
}

void RunDesk::Connect()
{
  connect(this->Around.Results, &ResultSet::Changed, this, &RunDesk::KeepSelection);
  connect(this->Around.Selected, &Selection::CaseChanged, this,
    [this](int index) { this->MeshInView = this->Around.Results->GetMeshName(index); });
  connect(this->Around.Files, &Session::Opened, this, &RunDesk::LoadKeptResults);
  connect(this->Controller, &RunController::Started, this, &RunDesk::ShowState);
  connect(this->Controller, &RunController::StateChanged, this, &RunDesk::ShowState);
  connect(this->Controller, &RunController::Finished, this, &RunDesk::FinishRun);
  connect(this->Controller, &RunController::Told, this,
    [this](const QString& line) { this->Around.Log->Tell(line); });
  connect(this->Around.Preview, &StudyPreview::BusyChanged, this, &RunDesk::ShowState);
  this->HalfWayTimer = new QTimer(this);
  this->HalfWayTimer->setInterval(HalfWayMilliseconds);
  connect(this->HalfWayTimer, &QTimer::timeout, this, &RunDesk::ShowHalfWay);
  connect(
    this->Controller, &RunController::Started, this->HalfWayTimer, qOverload<>(&QTimer::start));
}

void RunDesk::ShowState()
{
  const bool running = this->Controller->IsRunning();
  const bool paused = this->Controller->IsPaused();
  this->Actions[RunAll]->setEnabled(!running);
  this->Actions[RunAll]->setText(paused ? tr("Continue") : tr("Run study"));
  this->Actions[RunAll]->setToolTip(
    paused ? tr("Continue the run that was paused (F5)") : tr("Run study (F5)"));
  this->Actions[RunSolver]->setEnabled(!running);
  this->Actions[RunSome]->setEnabled(!running && !paused); // it would give up what is paused
  this->Actions[Pause]->setEnabled(running);
  this->Actions[Pause]->setVisible(running);
  for (const ActionType type : { Stop, Cancel })
  {
    this->Actions[type]->setEnabled(running || paused);
    this->Actions[type]->setVisible(running || paused);
  }
  emit this->StateChanged();
}

QString RunDesk::GetState() const
{
  return this->Controller->IsRunning() ? tr("Running …")
    : this->Around.Preview->IsBusy()   ? tr("Meshing …")
    : this->Controller->IsPaused()     ? tr("Paused")
                                       : QString();
}

/** What was paused goes on; the meshes that are done are not made again. */
void RunDesk::Run()
{
  this->StartRun({}, this->Controller->IsPaused());
}

void RunDesk::StartRun(const std::vector<int>& cases, bool continues)
{
  if (this->Controller->IsRunning())
  {
    return;
  }
  if (!this->Around.Model->GetFault().isEmpty())
  {
    this->Around.Log->ShowLog();
    this->Around.Log->Tell(this->Around.Model->GetFault(), true);
    return;
  }
  const QString title = this->Around.Model->GetTitle();
  this->Around.Log->Tell(continues ? tr("Continuing %1").arg(title)
      : cases.empty()              ? tr("Running %1").arg(title)
                      : tr("Running %1, meshes chosen: %2").arg(title).arg(cases.size()));
  this->IsRunOfOtherStudy = false;
  const QString output =
    continues ? this->Controller->GetOutput() : this->Around.Files->GetOutputFolder();
  this->Controller->Start(
    { this->Around.Model->GetText(), this->Around.Model->GetFolder(), output, cases, continues });
}

void RunDesk::RunChosen()
{
  QStringList marked;
  for (const vtkIdType row : this->Around.Selected->GetMarkedCases())
  {
    marked << this->Around.Results->GetMeshName(static_cast<int>(row));
  }
  MeshChoiceDialog dialog(this->Around.Model->GetStudy(), marked, this->Window);
  if (dialog.exec() == QDialog::Accepted && !dialog.GetCases().empty())
  {
    this->StartRun(dialog.GetCases(), false);
  }
}

void RunDesk::RunWithSolver()
{
  if (this->Around.Model->GetStudy().Solvers.empty())
  {
    emit this->SolverWanted(QString::fromLatin1(DefaultSolver));
  }
  emit this->SolverPageWanted();
  this->Run();
}

/** The tables are saved while the study runs, rarely enough to cost nothing. */
void RunDesk::ShowHalfWay()
{
  const QString folder = this->Controller->GetWorkFolder();
  const QFileInfo table(TableOf(folder));
  if (this->Controller->IsRunning() && !this->IsRunOfOtherStudy && table.exists() &&
    table.lastModified() != this->HalfWayTime)
  {
    this->HalfWayTime = table.lastModified();
    this->IsHalfWay = true;
    this->Around.Results->Load(folder);
  }
}

void RunDesk::TellEnd(bool isGood, const QString& folder, const QStringList& messages)
{
  for (const QString& message : messages)
  {
    this->Around.Log->Tell(message, true);
  }
  const double seconds = this->Controller->GetSeconds();
  this->Around.Log->Tell(this->Controller->IsPaused()
      ? tr("Paused after %1 s: Run continues it, now or when the study is opened again.")
          .arg(seconds, 0, 'f', 1)
      : folder.isEmpty() ? tr("The run was ended and nothing was kept.")
                         : tr("Done in %1 s: %2").arg(seconds, 0, 'f', 1).arg(folder));
  if (!isGood && folder.isEmpty() && !messages.isEmpty())
  {
    this->Around.Log->ShowLog();
  }
}

void RunDesk::FinishRun(bool isGood, const QString& folder, const QStringList& messages)
{
  this->TellEnd(isGood, folder, messages);
  this->HalfWayTime = {};
  this->HalfWayTimer->stop();
  if (this->ClosesAfterRun)
  {
    emit this->Ended();
    return;
  }
  if (this->IsRunOfOtherStudy)
  {
    this->IsRunOfOtherStudy = false;
    this->Controller->FindUnfinished(this->Around.Files->GetOutputFolder());
  }
  else if (!folder.isEmpty() && QFileInfo::exists(TableOf(folder)))
  {
    this->IsHalfWay = this->Controller->IsPaused();
    this->Around.Results->Load(folder);
  }
  else if (std::exchange(this->IsHalfWay, false))
  {
    this->LoadResultsOf(this->Controller->GetOutput()); // those of the run before
  }
  this->ShowState();
}

void RunDesk::LoadResultsOf(const QString& folder)
{
  QFileInfo::exists(TableOf(folder)) ? this->Around.Results->Load(folder)
                                     : this->Around.Results->Clear();
}

/** Of the study that was opened, where it was run before; nothing runs unasked. */
void RunDesk::LoadKeptResults()
{
  this->Around.Selected->SetCase(-1);
  this->Around.Results->Clear();
  if (this->Controller->IsRunning())
  {
    this->IsRunOfOtherStudy = true;
    this->Controller->Pause();
  }
  if (this->Around.Model->GetFile().isEmpty())
  {
    this->Controller->Forget();
    return;
  }
  const QString folder = this->Around.Files->GetOutputFolder();
  const bool isUnfinished = this->Controller->FindUnfinished(folder);
  this->IsHalfWay = isUnfinished;
  if (isUnfinished)
  {
    this->Around.Log->Tell(
      tr("A run of this study did not end: Run continues it, Cancel gives it up."));
  }
  const QString work = this->Controller->GetWorkFolder();
  this->LoadResultsOf(isUnfinished && QFileInfo::exists(TableOf(work)) ? work : folder);
}

/** The mesh in view stays so when there are more results of it. */
void RunDesk::KeepSelection()
{
  if (this->Around.Results->IsEmpty() || this->MeshInView.isEmpty() ||
    this->Around.Results->GetMeshName(this->Around.Selected->GetCase()) == this->MeshInView)
  {
    return;
  }
  const int index = this->Around.Results->FindMesh(this->MeshInView);
  if (index >= 0)
  {
    this->Around.Selected->SetCase(index);
  }
}

bool RunDesk::EndForClosing()
{
  if (!this->Controller->IsRunning())
  {
    return true;
  }
  this->ClosesAfterRun = true;
  this->Around.Model->GetFile().isEmpty() ? this->Controller->Cancel() : this->Controller->Pause();
  return false;
}

} // namespace pemesh
