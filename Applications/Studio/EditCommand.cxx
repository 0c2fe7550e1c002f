// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "EditCommand.h"

#include "DocumentPath.h"
#include "StudyModel.h"

namespace pemesh
{

namespace
{

/** The shortest beginning of a path that the document does not have; empty if it has it all. */
std::string FirstMissing(const JsonValue& document, const std::string& path)
{
  for (std::size_t end = path.find_first_of(".[", 1); end != std::string::npos;
       end = path.find_first_of(".[", end + 1))
  {
    if (!HasPath(document, path.substr(0, end)))
    {
      return path.substr(0, end);
    }
  }
  return HasPath(document, path) ? std::string() : path;
}

} // namespace

EditCommand::EditCommand(StudyModel* model, const std::string& path, std::optional<JsonValue> after,
  const QString& text, int gesture)
  : QUndoCommand(text)
  , Model(model)
  , Path(path)
  , Missing(FirstMissing(model->GetDocument(), path))
  , After(std::move(after))
  , Gesture(gesture)
{
  if (const JsonValue* before = FindAtPath(model->GetDocument(), path))
  {
    this->Before = *before;
  }
}

void EditCommand::undo()
{
  this->Before ? this->Model->Apply(this->Path, this->Before)
               : this->Model->Apply(this->Missing, std::nullopt);
}

void EditCommand::redo()
{
  this->Model->Apply(this->Path, this->After);
}

bool EditCommand::mergeWith(const QUndoCommand* other)
{
  const auto* next = dynamic_cast<const EditCommand*>(other);
  if (!next || next->Gesture != this->Gesture || next->Path != this->Path)
  {
    return false;
  }
  this->After = next->After;
  return true;
}

} // namespace pemesh
