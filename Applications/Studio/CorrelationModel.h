// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   CorrelationModel
 * @brief   Spearman's coefficients of the results as a coloured table: metrics by performances.
 */
#ifndef pemesh_CorrelationModel_h
#define pemesh_CorrelationModel_h

#include <QAbstractTableModel>
#include <QStringList>

#include <map>

class vtkTable;

namespace pemesh
{

class CorrelationModel : public QAbstractTableModel
{
  Q_OBJECT
public:
  using QAbstractTableModel::QAbstractTableModel;

  /** A table of vtkPEMCorrelation, or null. Without performances the columns are the metrics. */
  void SetTable(vtkTable* correlation);
  QString GetRowName(int row) const { return this->Rows.value(row); }
  QString GetColumnName(int column) const { return this->Columns.value(column); }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
  double GetValue(const QModelIndex& index) const;

  QStringList Rows;
  QStringList Columns;
  std::map<std::pair<QString, QString>, double> Values;
};

} // namespace pemesh

#endif
