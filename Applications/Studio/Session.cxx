// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Session.h"

#include "MeshFormats.h"
#include "Preferences.h"
#include "StudyModel.h"
#include "TextFile.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLockFile>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <QStandardPaths>
#include <QTimer>
#include <QUuid>
#include <QWidget>

namespace pemesh
{

namespace
{

constexpr const char* RecentKey = "recentFiles";

/** A lock that belongs to a program that has ended, on this machine; null if it still runs. */
std::unique_ptr<QLockFile> TakeOver(const QString& lockFile)
{
  auto lock = std::make_unique<QLockFile>(lockFile);
  lock->setStaleLockTime(0); // however old, it counts while its program runs
  return lock->tryLock(0) ? std::move(lock) : nullptr;
}

QString MeshFilter()
{
  return Session::tr("Meshes (%1)").arg(QString::fromStdString(ListMeshExtensions("*")));
}

} // namespace

Session::Session(StudyModel* model, QWidget* window)
  : QObject(window)
  , Model(model)
  , Window(window)
  , AutosaveTimer(new QTimer(this))
  , Identity(QUuid::createUuid().toString(QUuid::Id128))
{
  this->AutosaveTimer->setSingleShot(true);
  connect(this->AutosaveTimer, &QTimer::timeout, this, &Session::Autosave);
  connect(model, &StudyModel::Changed, this,
    [this] { this->AutosaveTimer->start(1000 * GetPreference(AutosavePreference)); });
}

Session::~Session()
{
  this->RemoveAutosave();
}

/** The study, the name of its file, or the lock that says whose they are. */
QString Session::GetAutosaveFile(const char* ending) const
{
  return QStringLiteral("%1/studio-%2.%3")
    .arg(Session::GetAutosaveFolder(), this->Identity, QLatin1String(ending));
}

QString Session::GetAutosaveFolder()
{
  return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
    QStringLiteral("/unsaved");
}

QString Session::GetOutputFolder() const
{
  const QString name = QString::fromStdString(this->Model->GetStudy().Name);
  const QString folder = this->Model->GetFile().isEmpty()
    ? QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
      QStringLiteral("/results")
    : QString::fromStdString(this->Model->GetFolder());
  return folder + QLatin1Char('/') + (name.isEmpty() ? QStringLiteral("results") : name);
}

void Session::Autosave()
{
  if (!this->Model->IsModified())
  {
    this->RemoveAutosave();
    return;
  }
  try
  {
    if (!this->Lock)
    {
      QDir().mkpath(GetAutosaveFolder());
      this->Lock = TakeOver(this->GetAutosaveFile("lock"));
    }
    WriteTextFile(this->GetAutosaveFile("txt").toStdString(), this->Model->GetFile().toStdString());
    WriteTextFile(this->GetAutosaveFile("json").toStdString(), this->Model->GetText());
  }
  catch (const std::exception&) // a full disk must not disturb the work; saving will tell
  {
  }
}

void Session::RemoveAutosave()
{
  QFile::remove(this->GetAutosaveFile("json"));
  QFile::remove(this->GetAutosaveFile("txt"));
  this->Lock.reset();
}

void Session::OfferRecovery()
{
  const QDir folder(GetAutosaveFolder());
  for (const QFileInfo& kept :
    folder.entryInfoList({ QStringLiteral("studio-*.json") }, QDir::Files, QDir::Time))
  {
    const QString base = kept.path() + QLatin1Char('/') + kept.completeBaseName();
    const std::unique_ptr<QLockFile> lock = TakeOver(base + QStringLiteral(".lock"));
    if (!lock)
    {
      continue; // its program still runs
    }
    const bool isTaken = this->Recover(kept);
    QFile::remove(kept.filePath());
    QFile::remove(base + QStringLiteral(".txt"));
    if (isTaken)
    {
      return;
    }
  }
}

/** Whether the user wants it. */
bool Session::Recover(const QFileInfo& kept)
{
  const QString pathFile = kept.path() + QLatin1Char('/') + kept.completeBaseName() + ".txt";
  try
  {
    const std::string text = ReadTextFile(kept.filePath().toStdString());
    const QString file = QFileInfo::exists(pathFile)
      ? QString::fromStdString(ReadTextFile(pathFile.toStdString()))
      : QString();
    const auto answer = QMessageBox::question(this->Window, tr("Unsaved study"),
      tr("PEMesh Studio ended without saving %1, last changed on %2. Bring it back?")
        .arg(file.isEmpty() ? tr("a new study") : file,
          QLocale().toString(kept.lastModified(), QLocale::ShortFormat)));
    if (answer != QMessageBox::Yes)
    {
      return false;
    }
    this->Model->Recover(text, file);
    this->Autosave(); // before what it comes from goes
    emit this->Opened();
    return true;
  }
  catch (const std::exception&) // not readable, so nothing to bring back
  {
    return false;
  }
}

bool Session::ConfirmDiscard()
{
  if (!this->Model->IsModified())
  {
    return true;
  }
  const auto answer = QMessageBox::question(this->Window, tr("Unsaved changes"),
    tr("%1 has changes that are not saved.").arg(this->Model->GetTitle()),
    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && this->Save());
}

void Session::MakeNew()
{
  if (this->ConfirmDiscard())
  {
    this->Model->MakeNew();
    emit this->Opened();
  }
}

bool Session::OpenFiles(const QStringList& files)
{
  if (files.isEmpty() || !this->ConfirmDiscard())
  {
    return false;
  }
  try
  {
    if (files.front().endsWith(QLatin1String(".json"), Qt::CaseInsensitive))
    {
      this->Model->Open(files.front());
      this->Remember(this->Model->GetFile());
    }
    else
    {
      this->Model->MakeFromMeshes(files);
    }
  }
  catch (const std::exception& error)
  {
    QMessageBox::warning(this->Window, tr("Open"), QString::fromUtf8(error.what()));
    return false;
  }
  emit this->Opened();
  return true;
}

void Session::Open()
{
  const QString file = QFileDialog::getOpenFileName(this->Window, tr("Open study"),
    QString::fromStdString(this->Model->GetFolder()), tr("Studies (*.json);;All files (*)"));
  if (!file.isEmpty())
  {
    this->OpenFiles({ file });
  }
}

void Session::OpenMeshes()
{
  this->OpenFiles(QFileDialog::getOpenFileNames(this->Window, tr("Open meshes"),
    QString::fromStdString(this->Model->GetFolder()), MeshFilter() + tr(";;All files (*)")));
}

bool Session::SaveTo(const QString& file)
{
  try
  {
    this->Model->Save(file);
  }
  catch (const std::exception& error)
  {
    QMessageBox::warning(this->Window, tr("Save"), QString::fromUtf8(error.what()));
    return false;
  }
  this->RemoveAutosave();
  this->Remember(this->Model->GetFile());
  return true;
}

bool Session::Save()
{
  return this->Model->GetFile().isEmpty() ? this->SaveAs() : this->SaveTo(this->Model->GetFile());
}

bool Session::SaveAs()
{
  const QString proposed = this->Model->GetFile().isEmpty()
    ? QString::fromStdString(
        this->Model->GetFolder() + "/" + this->Model->GetStudy().Name + ".json")
    : this->Model->GetFile();
  QString file =
    QFileDialog::getSaveFileName(this->Window, tr("Save study"), proposed, tr("Studies (*.json)"));
  if (file.isEmpty())
  {
    return false;
  }
  if (QFileInfo(file).suffix().isEmpty())
  {
    file += QStringLiteral(".json");
  }
  return this->SaveTo(file);
}

void Session::Remember(const QString& file)
{
  QSettings settings;
  QStringList files = settings.value(QLatin1String(RecentKey)).toStringList();
  files.removeAll(file);
  files.prepend(file);
  settings.setValue(QLatin1String(RecentKey), files.mid(0, GetPreference(RecentPreference)));
}

void Session::FillRecentMenu(QMenu* menu)
{
  menu->clear();
  const QStringList files = QSettings()
                              .value(QLatin1String(RecentKey))
                              .toStringList()
                              .mid(0, GetPreference(RecentPreference));
  for (const QString& file : files)
  {
    QAction* action = menu->addAction(
      QFileInfo(file).fileName() + QStringLiteral("   ") + QFileInfo(file).absolutePath());
    action->setEnabled(QFileInfo::exists(file));
    connect(action, &QAction::triggered, this, [this, file] { this->OpenFiles({ file }); });
  }
  if (files.isEmpty())
  {
    menu->addAction(tr("None yet"))->setEnabled(false);
  }
}

} // namespace pemesh
