// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   ElementTableModel
 * @brief   The elements of a mesh with all their metrics, sorted in a worker by any of them.
 */
#ifndef pemesh_ElementTableModel_h
#define pemesh_ElementTableModel_h

#include "MeshPicture.h"

#include <QAbstractTableModel>

#include <vector>

namespace pemesh
{

class LatestJob;
struct Metric;

class ElementTableModel : public QAbstractTableModel
{
  Q_OBJECT
public:
  explicit ElementTableModel(QObject* parent = nullptr);
  ~ElementTableModel() override;

  void SetPicture(const MeshPicturePointer& picture);
  /** Elements that stand out. */
  void SetMarked(const std::vector<vtkIdType>& elements);
  /** The element of a row, and the row of an element (or -1). */
  qint64 GetElement(int row) const;
  int FindRow(qint64 element) const;
  /** The column of a metric, or -1. */
  int FindColumn(const QString& metric) const;
  /** The metric of a column; empty for that of the numbers of the elements. */
  QString GetMetric(int column) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  void sort(int column, Qt::SortOrder order) override;

signals:
  void Sorted();

private:
  void Arrange(const std::vector<vtkIdType>& rows, const std::vector<vtkIdType>& rowsOfElements);

  MeshPicturePointer Picture;
  std::vector<const Metric*> Columns;
  std::vector<vtkIdType> Rows;           // the elements in order; empty: by number
  std::vector<vtkIdType> RowsOfElements; // the other way round
  std::vector<bool> Marked;              // of the elements
  int SortColumn = -1;
  Qt::SortOrder SortOrder = Qt::AscendingOrder;
  LatestJob* SortJob;
};

} // namespace pemesh

#endif
