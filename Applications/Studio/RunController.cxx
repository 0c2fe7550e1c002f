// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RunController.h"

#include "Preferences.h"
#include "vtkPEMRunner.h"

#include <atomic>
#include <filesystem>
#include <thread>

#include <vtkCallbackCommand.h>
#include <vtkNew.h>

namespace pemesh
{

namespace fs = std::filesystem;

namespace
{

/** Where results are made until they take the place of those before. */
fs::path WorkFolderOf(const fs::path& output)
{
  return output.string() + ".running";
}

/** Of a run that did not end: only what a study has left, and something to go on from. */
bool HasUnfinished(const fs::path& output)
{
  const fs::path work = WorkFolderOf(output);
  return fs::exists(work / "study.json") && fs::exists(work / "journal.tsv");
}

/** The new folder in place of the old one; an old one that is no result of a study stays. */
QString KeepResults(const fs::path& output)
{
  const fs::path work = WorkFolderOf(output);
  if (fs::exists(output) && !fs::is_empty(output) && !fs::exists(output / "study.json"))
  {
    return QString::fromStdString(work.string());
  }
  fs::remove_all(output);
  fs::rename(work, output);
  return QString::fromStdString(output.string());
}

} // namespace

struct RunController::Run
{
  enum class Ending
  {
    Keep,
    Discard,
    Pause
  };

  RunController* Self;
  vtkNew<vtkPEMRunner> Runner;
  std::thread Thread;
  std::atomic<Ending> End{ Ending::Keep };
  std::atomic<bool> IsStopped{ false };
  bool Runs = true; // or only ends what was paused
  bool Continues = false;
  fs::path Output;

  void Observe(unsigned long event, void (*callback)(vtkObject*, unsigned long, void*, void*))
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(callback);
    this->Runner->AddObserver(event, command);
  }

  /** A stop that came before the runner had begun. */
  void StopIfAsked()
  {
    if (this->IsStopped)
    {
      this->Runner->RequestStop();
    }
  }

  void Work();
  bool Execute(QStringList& messages);
  QString Finish() const;
};

bool RunController::Run::Execute(QStringList& messages)
{
  if (!this->Continues && fs::exists(WorkFolderOf(this->Output) / "study.json"))
  {
    fs::remove_all(WorkFolderOf(this->Output)); // of a run that did not end
  }
  const bool isGood = this->Runner->Run();
  for (const std::string& message : this->Runner->GetMessages())
  {
    messages << QString::fromStdString(message);
  }
  return isGood;
}

/** The folder with the results; empty where there are none. */
QString RunController::Run::Finish() const
{
  switch (this->End)
  {
    case Ending::Discard:
      fs::remove_all(WorkFolderOf(this->Output));
      return {};
    case Ending::Pause:
      return QString::fromStdString(WorkFolderOf(this->Output).string());
    default:
      return this->Runs && this->Runner->GetRefused() ? QString() : KeepResults(this->Output);
  }
}

void RunController::Run::Work()
{
  QStringList messages;
  QString folder;
  bool isGood = false;
  try
  {
    isGood = !this->Runs || this->Execute(messages);
    folder = this->Finish();
  }
  catch (const std::exception& error)
  {
    isGood = false;
    messages << QString::fromUtf8(error.what());
  }
  QMetaObject::invokeMethod(
    this->Self,
    [self = this->Self, isGood, folder, messages] { self->Finish(isGood, folder, messages); },
    Qt::QueuedConnection);
}

RunController::RunController(QObject* parent)
  : QObject(parent)
{
}

RunController::~RunController()
{
  if (this->Current)
  {
    this->Cancel();
    this->Current->Thread.join();
  }
}

void RunController::Start(const RunRequest& request)
{
  if (this->IsRunning())
  {
    return;
  }
  this->Current = std::make_unique<Run>();
  Run* run = this->Current.get();
  run->Self = this;
  run->Output = request.Output.toStdString();
  run->Continues = request.Continues;
  run->Runner->SetStudyText(request.Text, request.Folder);
  run->Runner->SetSelectedCases(request.Cases);
  run->Runner->SetOutputDirectory(WorkFolderOf(run->Output).string());
  run->Runner->SetResume(request.Continues);
  run->Runner->SetNumberOfWorkers(GetPreference(WorkersPreference));
  run->Observe(vtkCommand::ProgressEvent,
    [](vtkObject*, unsigned long, void* client, void* data)
    {
      auto* self = static_cast<Run*>(client);
      self->StopIfAsked();
      const double fraction = *static_cast<const double*>(data);
      QMetaObject::invokeMethod(
        self->Self, [controller = self->Self, fraction] { emit controller->Progressed(fraction); },
        Qt::QueuedConnection);
    });
  run->Observe(vtkPEMRunner::LogEvent,
    [](vtkObject*, unsigned long, void* client, void* data)
    {
      auto* self = static_cast<Run*>(client);
      const QString line = QString::fromUtf8(static_cast<const char*>(data));
      QMetaObject::invokeMethod(
        self->Self, [controller = self->Self, line] { emit controller->Told(line); },
        Qt::QueuedConnection);
    });
  this->Launch();
}

void RunController::Launch()
{
  Run* run = this->Current.get();
  this->Output = QString::fromStdString(run->Output.string());
  this->Now = State::Running;
  this->Clock.start();
  emit this->Started();
  run->Thread = std::thread([run] { run->Work(); });
}

bool RunController::FindUnfinished(const QString& output)
{
  if (this->IsRunning())
  {
    return false;
  }
  const bool found = HasUnfinished(output.toStdString());
  this->Output = output;
  this->Now = found ? State::Paused : State::Idle;
  emit this->StateChanged();
  return found;
}

void RunController::Forget()
{
  if (this->IsPaused())
  {
    this->Now = State::Idle;
    emit this->StateChanged();
  }
}

QString RunController::GetWorkFolder() const
{
  return this->Now == State::Idle
    ? QString()
    : QString::fromStdString(WorkFolderOf(this->Output.toStdString()).string());
}

void RunController::Pause()
{
  if (this->Current && this->Current->Runs)
  {
    this->Current->End = Run::Ending::Pause;
    this->StopRunner();
  }
}

void RunController::Stop()
{
  if (this->Current)
  {
    this->StopRunner();
    return;
  }
  this->EndPaused(false);
}

void RunController::Cancel()
{
  if (this->Current)
  {
    this->Current->End = Run::Ending::Discard;
    this->StopRunner();
    return;
  }
  this->EndPaused(true);
}

void RunController::StopRunner()
{
  this->Current->IsStopped = true;
  this->Current->Runner->RequestStop();
}

/** In a thread as well: a folder of many files takes its time. */
void RunController::EndPaused(bool discards)
{
  if (this->Now != State::Paused)
  {
    return;
  }
  this->Current = std::make_unique<Run>();
  this->Current->Self = this;
  this->Current->Output = this->Output.toStdString();
  this->Current->Runs = false;
  this->Current->End = discards ? Run::Ending::Discard : Run::Ending::Keep;
  this->Launch();
}

void RunController::Finish(bool isGood, const QString& folder, const QStringList& messages)
{
  const Run& run = *this->Current;
  const bool isPaused = run.End == Run::Ending::Pause && HasUnfinished(run.Output);
  this->Current->Thread.join();
  this->Current.reset();
  this->Now = isPaused ? State::Paused : State::Idle;
  emit this->Finished(isGood, folder, messages);
}

} // namespace pemesh
