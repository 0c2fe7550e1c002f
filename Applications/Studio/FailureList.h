// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   FailureList
 * @brief   What went wrong in a run, with what the solvers said.
 *
 * Selecting a failure selects its mesh.
 */
#ifndef pemesh_FailureList_h
#define pemesh_FailureList_h

#include <QWidget>

class QLabel;
class QPlainTextEdit;
class QTableWidget;

namespace pemesh
{

class ResultSet;
class Selection;

class FailureList : public QWidget
{
  Q_OBJECT
public:
  FailureList(ResultSet* results, Selection* selection, QWidget* parent = nullptr);

  QTableWidget* GetTable() const { return this->Table; }
  int GetCount() const;
  /** The end of what the solver of the selected failure wrote. */
  QString GetLog() const;

private:
  void Show();
  void ShowFailure(int row);

  ResultSet* Results;
  Selection* Selected;
  QTableWidget* Table;
  QLabel* Message;
  QPlainTextEdit* Log;
};

} // namespace pemesh

#endif
