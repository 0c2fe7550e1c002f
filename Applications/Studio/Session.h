// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   Session
 * @brief   The file of the study: new, open, save, recent files, and what a crash would lose.
 *
 * A study that is not saved is written to a folder of the user some seconds after every change;
 * what a session that did not end left there is offered the next time.
 */
#ifndef pemesh_Session_h
#define pemesh_Session_h

#include <QObject>
#include <QString>
#include <QStringList>

#include <memory>

class QLockFile;
class QFileInfo;
class QMenu;
class QTimer;
class QWidget;

namespace pemesh
{

class StudyModel;

class Session : public QObject
{
  Q_OBJECT
public:
  Session(StudyModel* model, QWidget* window);
  ~Session() override;

  /** Studies by their ending .json, else mesh files; asks before anything is lost. */
  bool OpenFiles(const QStringList& files);
  /** True if nothing is lost by going on: saved, or the user does not mind. */
  bool ConfirmDiscard();
  /**
   * Studies that were not saved when a program ended, one after the other until the user takes one;
   * those behind it are offered the next time.
   */
  void OfferRecovery();
  void FillRecentMenu(QMenu* menu);
  /** Where results of the study go. */
  QString GetOutputFolder() const;

  ///@{
  /** Where unsaved studies are kept; tests have a folder of their own. */
  static QString GetAutosaveFolder();
  ///@}

public slots:
  void MakeNew();
  void Open();
  void OpenMeshes();
  bool Save();
  bool SaveAs();
  void Autosave();

signals:
  /** A study or meshes were opened, or all is new. */
  void Opened();

private:
  void Remember(const QString& file);
  QString GetAutosaveFile(const char* ending) const;
  void RemoveAutosave();
  bool Recover(const QFileInfo& kept);
  bool SaveTo(const QString& file);

  StudyModel* Model;
  QWidget* Window;
  QTimer* AutosaveTimer;
  QString Identity;                // of what is kept, among those of other windows
  std::unique_ptr<QLockFile> Lock; // held while there is something kept
};

} // namespace pemesh

#endif
