// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   StudyModel
 * @brief   The document of a study, which is the model of the whole window.
 *
 * Every edit is a change of the document that can be undone; saving is writing it, running is
 * giving it to vtkPEMRunner. The keys stay as they were written: defaults are not put in. While the
 * document says something impossible, GetFault() tells it and GetStudy() is the last good one.
 */
#ifndef pemesh_StudyModel_h
#define pemesh_StudyModel_h

#include "JsonValue.h"
#include "Study.h"

#include <QObject>
#include <QString>

#include <optional>
#include <string>

class QUndoStack;

namespace pemesh
{

class StudyModel : public QObject
{
  Q_OBJECT
public:
  explicit StudyModel(QObject* parent = nullptr);
  ~StudyModel() override;

  const JsonValue& GetDocument() const { return this->Document; }
  const Study& GetStudy() const { return this->LastStudy; }
  /** One sentence, or empty. */
  QString GetFault() const { return this->Fault; }
  QUndoStack* GetUndoStack() const { return this->Stack; }

  /** The text of the document as it is saved. */
  std::string GetText() const;

  ///@{
  /** Edits. Those of one gesture (a number that is not 0) are undone together. */
  void SetValue(
    const std::string& path, const JsonValue& value, const QString& text, int gesture = 0);
  void RemoveValue(const std::string& path, const QString& text);
  void AddItem(const std::string& list, const JsonValue& item, const QString& text);
  void MoveItem(const std::string& list, int from, int to, const QString& text);
  static int NewGesture();
  ///@}

  ///@{
  /** Files. They throw std::runtime_error with one sentence. */
  void MakeNew();
  void MakeFromMeshes(const QStringList& files);
  void Open(const QString& file);
  void Save(const QString& file);
  /** The text of a document that was not saved, belonging to a file or to none. */
  void Recover(const std::string& text, const QString& file);
  ///@}

  /** Empty for a study that was never saved. */
  QString GetFile() const { return this->File; }
  /** Its name, for titles. */
  QString GetTitle() const;
  bool IsModified() const;
  /** Where relative paths start from. */
  std::string GetFolder() const;

signals:
  void Changed();
  void FileChanged();

private:
  friend class EditCommand;
  void Apply(const std::string& path, const std::optional<JsonValue>& value);
  void Reset(JsonValue document, const QString& file);
  void EnsureList(const std::string& path);
  JsonValue::List GetItems(const std::string& list) const;
  void Parse();

  JsonValue Document;
  Study LastStudy;
  QString Fault;
  QString File;
  bool IsRecovered = false;
  QUndoStack* Stack;
};

} // namespace pemesh

#endif
