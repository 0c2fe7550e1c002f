// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   EditCommand
 * @brief   One change of the document of a study: the value of a path before and after.
 *
 * Changes of one gesture (a drag, a slider) to one path are one command.
 */
#ifndef pemesh_EditCommand_h
#define pemesh_EditCommand_h

#include "JsonValue.h"

#include <QUndoCommand>

#include <optional>
#include <string>

namespace pemesh
{

class StudyModel;

class EditCommand : public QUndoCommand
{
public:
  /** Nothing for `after` takes the value out. Gesture 0 is never merged. */
  EditCommand(StudyModel* model, const std::string& path, std::optional<JsonValue> after,
    const QString& text, int gesture);

  void undo() override;
  void redo() override;
  int id() const override { return this->Gesture > 0 ? 1 : -1; }
  bool mergeWith(const QUndoCommand* other) override;

private:
  StudyModel* Model;
  std::string Path;
  std::string Missing; // the first part of the path that there was not, which undo takes out
  std::optional<JsonValue> Before;
  std::optional<JsonValue> After;
  int Gesture;
};

} // namespace pemesh

#endif
