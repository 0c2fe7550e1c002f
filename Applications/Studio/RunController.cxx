// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RunController.h"

#include "vtkPEMRunner.h"

#include <atomic>
#include <filesystem>
#include <thread>

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

namespace pemesh
{

namespace fs = std::filesystem;

struct RunController::Run
{
  RunController* Self;
  vtkNew<vtkPEMRunner> Runner;
  std::thread Thread;
  std::atomic<bool> IsCancelled{ false };
  std::atomic<bool> IsStopped{ false };
  fs::path Output;

  fs::path GetWorkFolder() const { return this->Output.string() + ".running"; }

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
  QString KeepResults() const;
};

/** The new folder in place of the old one; an old one that is no result of a study stays. */
QString RunController::Run::KeepResults() const
{
  const fs::path work = this->GetWorkFolder();
  if (fs::exists(this->Output) && !fs::is_empty(this->Output) &&
    !fs::exists(this->Output / "study.json"))
  {
    return QString::fromStdString(work.string());
  }
  fs::remove_all(this->Output);
  fs::rename(work, this->Output);
  return QString::fromStdString(this->Output.string());
}

void RunController::Run::Work()
{
  QStringList messages;
  QString folder;
  bool isGood = false;
  try
  {
    if (fs::exists(this->GetWorkFolder() / "study.json"))
    {
      fs::remove_all(this->GetWorkFolder()); // of a run that did not end
    }
    isGood = this->Runner->Run();
    for (const std::string& message : this->Runner->GetMessages())
    {
      messages << QString::fromStdString(message);
    }
    if (this->IsCancelled)
    {
      fs::remove_all(this->GetWorkFolder());
    }
    else if (!this->Runner->GetRefused())
    {
      folder = this->KeepResults();
    }
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

void RunController::Start(
  const std::string& text, const std::string& studyFolder, const QString& output)
{
  if (this->Running)
  {
    return;
  }
  this->Running = true;
  this->Clock.start();
  this->Current = std::make_unique<Run>();
  Run* run = this->Current.get();
  run->Self = this;
  run->Output = output.toStdString();
  run->Runner->SetStudyText(text, studyFolder);
  run->Runner->SetOutputDirectory(run->GetWorkFolder().string());
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
  emit this->Started();
  run->Thread = std::thread([run] { run->Work(); });
}

void RunController::Stop()
{
  if (this->Current)
  {
    this->Current->IsStopped = true;
    this->Current->Runner->RequestStop();
  }
}

void RunController::Cancel()
{
  if (this->Current)
  {
    this->Current->IsCancelled = true;
    this->Stop();
  }
}

void RunController::Finish(bool isGood, const QString& folder, const QStringList& messages)
{
  this->Current->Thread.join();
  this->Current.reset();
  this->Running = false;
  emit this->Finished(isGood, folder, messages);
}

} // namespace pemesh
