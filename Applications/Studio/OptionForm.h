// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   OptionForm
 * @brief   Editors for one object of the document, made from the tables of its keys.
 *
 * Which editors there are, their ranges, choices and explanations come from DescribeStudyForm: a
 * key that is added to a table appears here by itself. A value in force that the document does not
 * give is a default; the button beside one that it gives takes it out again.
 */
#ifndef pemesh_OptionForm_h
#define pemesh_OptionForm_h

#include "StudyForm.h"

#include <QWidget>

#include <functional>
#include <string>
#include <vector>

class QFormLayout;
class QToolButton;

namespace pemesh
{

class StudyModel;

class OptionForm : public QWidget
{
  Q_OBJECT
public:
  explicit OptionForm(StudyModel* model, QWidget* parent = nullptr);

  /** The object: "mesh", "polygons[2]"; empty for none. */
  void SetPath(const std::string& path);
  std::string GetPath() const { return this->Path; }

  /** Fields that no table knows, put behind those of the table. */
  void SetOtherFields(std::function<std::vector<FormField>()> other);

  /** Keys that another widget edits. */
  void SetHiddenKeys(const std::vector<std::string>& keys);

private:
  /** One row: how to put a value into its editor. */
  struct Row
  {
    FormField Field;
    std::function<void(const JsonValue& value)> Show;
    std::function<void()> ShowUnset; // where the value may be left out
    QToolButton* Reset = nullptr;
  };

  void Refresh();
  void Rebuild(const std::vector<FormField>& fields);
  std::vector<FormField> ReadFields() const;
  QWidget* AddRow(const FormField& field);
  QWidget* MakeEditor(Row& row);
  QWidget* MakeNumber(Row& row);
  QWidget* MakePair(Row& row);
  QWidget* MakeChoice(Row& row);
  QWidget* MakeTruth(Row& row);
  QWidget* MakeText(Row& row);
  void Set(const FormField& field, const JsonValue& value);
  void Unset(const FormField& field);
  void Choose(const FormField& field, const std::string& choice);
  int GestureOf(const std::string& path);
  QFormLayout* GetLayout() const;

  StudyModel* Model;
  std::string Path;
  std::function<std::vector<FormField>()> Other;
  std::vector<std::string> HiddenKeys;
  std::vector<Row> Rows;
  bool IsShowing = false; // while values go into editors
  std::string GesturePath;
  int Gesture = 0;
};

} // namespace pemesh

#endif
