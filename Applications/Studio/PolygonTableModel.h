// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   PolygonTableModel
 * @brief   The placed polygons of the document as a table whose numbers can be edited.
 */
#ifndef pemesh_PolygonTableModel_h
#define pemesh_PolygonTableModel_h

#include <QAbstractTableModel>

namespace pemesh
{

class StudyModel;

class PolygonTableModel : public QAbstractTableModel
{
  Q_OBJECT
public:
  explicit PolygonTableModel(StudyModel* study, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

private:
  void Refresh();

  StudyModel* Study;
  int Count = 0;
};

} // namespace pemesh

#endif
