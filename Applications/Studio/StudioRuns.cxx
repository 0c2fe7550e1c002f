// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// The runs of the window: from their beginning to the results that are shown.
#include "StudioWindow.h"

#include "LogDock.h"
#include "MeshChoiceDialog.h"
#include "ResultSet.h"
#include "RunController.h"
#include "Selection.h"
#include "Session.h"
#include "SolverPage.h"
#include "StudyModel.h"
#include "StudyPreview.h"

#include <QAction>
#include <QCloseEvent>
#include <QFileInfo>
#include <QLabel>
#include <QProgressBar>
#include <QSettings>
#include <QTimer>

#include <cmath>
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

void StudioWindow::ConnectRuns()
{
  connect(this->Results, &ResultSet::Changed, this, &StudioWindow::KeepSelection);
  connect(this->Selected, &Selection::CaseChanged, this,
    [this](int index) { this->MeshInView = this->Results->GetMeshName(index); });
  connect(this->Files, &Session::Opened, this, &StudioWindow::LoadKeptResults);
  connect(this->Controller, &RunController::Started, this, &StudioWindow::ShowRunning);
  connect(this->Controller, &RunController::StateChanged, this, &StudioWindow::ShowRunning);
  connect(this->Controller, &RunController::Finished, this, &StudioWindow::FinishRun);
  connect(this->Controller, &RunController::Told, this,
    [this](const QString& line) { this->Log->Tell(line); });
  connect(this->Controller, &RunController::Progressed, this,
    [this](double fraction)
    { this->Progress->setValue(static_cast<int>(std::lround(fraction * 1000.0))); });
  this->HalfWayTimer = new QTimer(this);
  this->HalfWayTimer->setInterval(HalfWayMilliseconds);
  connect(this->HalfWayTimer, &QTimer::timeout, this, &StudioWindow::ShowHalfWay);
  connect(
    this->Controller, &RunController::Started, this->HalfWayTimer, qOverload<>(&QTimer::start));
}

void StudioWindow::ShowRunning()
{
  const bool running = this->Controller->IsRunning();
  const bool paused = this->Controller->IsPaused();
  this->RunAction->setEnabled(!running);
  this->RunAction->setText(paused ? tr("Continue") : tr("Run study"));
  this->RunAction->setToolTip(
    paused ? tr("Continue the run that was paused (F5)") : tr("Run study (F5)"));
  this->RunSomeAction->setEnabled(!running && !paused); // it would give up what is paused
  this->PauseAction->setEnabled(running);
  this->PauseAction->setVisible(running);
  for (QAction* action : { this->StopAction, this->CancelAction })
  {
    action->setEnabled(running || paused);
    action->setVisible(running || paused);
  }
  this->Progress->setVisible(running);
  this->Status->setText(running ? tr("Running …")
      : this->Preview->IsBusy() ? tr("Meshing …")
      : paused                  ? tr("Paused")
                                : QString());
}

/** What was paused goes on; the meshes that are done are not made again. */
void StudioWindow::Run()
{
  this->StartRun({}, this->Controller->IsPaused());
}

void StudioWindow::StartRun(const std::vector<int>& cases, bool continues)
{
  if (this->Controller->IsRunning())
  {
    return;
  }
  if (!this->Model->GetFault().isEmpty())
  {
    this->Log->ShowLog();
    this->Log->Tell(this->Model->GetFault(), true);
    return;
  }
  this->Progress->setValue(0);
  const QString title = this->Model->GetTitle();
  this->Log->Tell(continues ? tr("Continuing %1").arg(title)
      : cases.empty()       ? tr("Running %1").arg(title)
                            : tr("Running %1, meshes chosen: %2").arg(title).arg(cases.size()));
  this->IsRunOfOtherStudy = false;
  const QString output = continues ? this->Controller->GetOutput() : this->Files->GetOutputFolder();
  this->Controller->Start(
    { this->Model->GetText(), this->Model->GetFolder(), output, cases, continues });
}

void StudioWindow::RunSome()
{
  QStringList marked;
  for (const vtkIdType row : this->Selected->GetMarkedCases())
  {
    marked << this->Results->GetMeshName(static_cast<int>(row));
  }
  MeshChoiceDialog dialog(this->Model->GetStudy(), marked, this);
  if (dialog.exec() == QDialog::Accepted && !dialog.GetCases().empty())
  {
    this->StartRun(dialog.GetCases(), false);
  }
}

void StudioWindow::RunWithSolver()
{
  if (this->Model->GetStudy().Solvers.empty())
  {
    this->Solver->AddSolver(QString::fromLatin1(DefaultSolver));
  }
  this->ShowPage(SolverPageIndex);
  this->Run();
}

/** The tables are saved while the study runs, rarely enough to cost nothing. */
void StudioWindow::ShowHalfWay()
{
  const QString folder = this->Controller->GetWorkFolder();
  const QFileInfo table(TableOf(folder));
  if (this->Controller->IsRunning() && !this->IsRunOfOtherStudy && table.exists() &&
    table.lastModified() != this->HalfWayTime)
  {
    this->HalfWayTime = table.lastModified();
    this->IsHalfWay = true;
    this->Results->Load(folder);
  }
}

void StudioWindow::FinishRun(bool isGood, const QString& folder, const QStringList& messages)
{
  for (const QString& message : messages)
  {
    this->Log->Tell(message, true);
  }
  const double seconds = this->Controller->GetSeconds();
  this->Log->Tell(this->Controller->IsPaused()
      ? tr("Paused after %1 s: Run continues it, now or when the study is opened again.")
          .arg(seconds, 0, 'f', 1)
      : folder.isEmpty() ? tr("The run was ended and nothing was kept.")
                         : tr("Done in %1 s: %2").arg(seconds, 0, 'f', 1).arg(folder));
  if (!isGood && folder.isEmpty() && !messages.isEmpty())
  {
    this->Log->ShowLog();
  }
  this->HalfWayTime = {};
  this->HalfWayTimer->stop();
  if (this->ClosesAfterRun)
  {
    this->close();
    return;
  }
  if (this->IsRunOfOtherStudy)
  {
    this->IsRunOfOtherStudy = false;
    this->Controller->FindUnfinished(this->Files->GetOutputFolder());
  }
  else if (!folder.isEmpty() && QFileInfo::exists(TableOf(folder)))
  {
    this->IsHalfWay = this->Controller->IsPaused();
    this->Results->Load(folder);
  }
  else if (std::exchange(this->IsHalfWay, false))
  {
    this->LoadResultsOf(this->Controller->GetOutput()); // those of the run before
  }
  this->ShowRunning();
}

void StudioWindow::LoadResultsOf(const QString& folder)
{
  QFileInfo::exists(TableOf(folder)) ? this->Results->Load(folder) : this->Results->Clear();
}

/** Of the study that was opened, where it was run before; nothing runs unasked. */
void StudioWindow::LoadKeptResults()
{
  this->Selected->SetCase(-1);
  this->Results->Clear();
  if (this->Controller->IsRunning())
  {
    this->IsRunOfOtherStudy = true;
    this->Controller->Pause();
  }
  if (this->Model->GetFile().isEmpty())
  {
    this->Controller->Forget();
    return;
  }
  const QString folder = this->Files->GetOutputFolder();
  const bool isUnfinished = this->Controller->FindUnfinished(folder);
  this->IsHalfWay = isUnfinished;
  if (isUnfinished)
  {
    this->Log->Tell(tr("A run of this study did not end: Run continues it, Cancel gives it up."));
  }
  const QString work = this->Controller->GetWorkFolder();
  this->LoadResultsOf(isUnfinished && QFileInfo::exists(TableOf(work)) ? work : folder);
}

/** The mesh in view stays so when there are more results of it. */
void StudioWindow::KeepSelection()
{
  if (this->Results->IsEmpty() || this->MeshInView.isEmpty() ||
    this->Results->GetMeshName(this->Selected->GetCase()) == this->MeshInView)
  {
    return;
  }
  const int index = this->Results->FindMesh(this->MeshInView);
  if (index >= 0)
  {
    this->Selected->SetCase(index);
  }
}

/** A run that goes on is paused, so that nothing is lost; that of a study without a file ends. */
void StudioWindow::closeEvent(QCloseEvent* event)
{
  if (!this->ClosesAfterRun && !this->Files->ConfirmDiscard())
  {
    event->ignore();
    return;
  }
  if (this->Controller->IsRunning())
  {
    this->ClosesAfterRun = true;
    this->Model->GetFile().isEmpty() ? this->Controller->Cancel() : this->Controller->Pause();
    event->ignore(); // FinishRun closes the window
    return;
  }
  QSettings().setValue(QStringLiteral("geometry"), this->saveGeometry());
  event->accept();
}

} // namespace pemesh
