// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   MeshChoiceDialog
 * @brief   Asks which meshes of a study are to be run.
 */
#ifndef pemesh_MeshChoiceDialog_h
#define pemesh_MeshChoiceDialog_h

#include <QDialog>

#include <vector>

class QTableWidget;

namespace pemesh
{

struct Study;

class MeshChoiceDialog : public QDialog
{
  Q_OBJECT
public:
  /** `chosen` are the names of the meshes that are selected to begin with. */
  MeshChoiceDialog(const Study& study, const QStringList& chosen, QWidget* parent = nullptr);

  /** The numbers of the meshes, from 0, ascending. */
  std::vector<int> GetCases() const;

private:
  QTableWidget* Table;
};

} // namespace pemesh

#endif
