// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementTableModel.h"

#include "LatestJob.h"
#include "MetricRegistry.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <vtkCellData.h>
#include <vtkPolyData.h>

namespace pemesh
{

ElementTableModel::ElementTableModel(QObject* parent)
  : QAbstractTableModel(parent)
  , SortJob(new LatestJob(this, 0))
{
}

ElementTableModel::~ElementTableModel()
{
  delete this->SortJob;
}

void ElementTableModel::SetPicture(const MeshPicturePointer& picture)
{
  if (this->Picture == picture)
  {
    return;
  }
  this->beginResetModel();
  this->Picture = picture;
  this->Rows.clear();
  this->Columns.clear();
  for (const Metric& metric : Metrics())
  {
    if (picture && picture->GetMesh()->GetCellData()->GetArray(metric.Name))
    {
      this->Columns.push_back(&metric);
    }
  }
  this->endResetModel();
  this->sort(this->SortColumn, this->SortOrder);
}

qint64 ElementTableModel::GetElement(int row) const
{
  if (row < 0 || row >= this->rowCount())
  {
    return -1;
  }
  return this->Rows.empty() ? row : this->Rows[static_cast<std::size_t>(row)];
}

int ElementTableModel::FindRow(qint64 element) const
{
  if (element < 0 || element >= this->rowCount())
  {
    return -1;
  }
  const auto found = std::find(this->Rows.begin(), this->Rows.end(), element);
  return static_cast<int>(this->Rows.empty() ? element : found - this->Rows.begin());
}

int ElementTableModel::FindColumn(const QString& metric) const
{
  for (std::size_t i = 0; i < this->Columns.size(); ++i)
  {
    if (metric == QLatin1String(this->Columns[i]->Name))
    {
      return static_cast<int>(i) + 1;
    }
  }
  return -1;
}

QString ElementTableModel::GetMetric(int column) const
{
  return column > 0 && column < this->columnCount()
    ? QString::fromUtf8(this->Columns[static_cast<std::size_t>(column - 1)]->Name)
    : QString();
}

int ElementTableModel::rowCount(const QModelIndex& parent) const
{
  return parent.isValid() || !this->Picture
    ? 0
    : static_cast<int>(this->Picture->GetNumberOfElements());
}

int ElementTableModel::columnCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : 1 + static_cast<int>(this->Columns.size());
}

QVariant ElementTableModel::data(const QModelIndex& index, int role) const
{
  if (role == Qt::TextAlignmentRole)
  {
    return QVariant::fromValue(Qt::Alignment(Qt::AlignRight | Qt::AlignVCenter));
  }
  if (role != Qt::DisplayRole || !index.isValid())
  {
    return {};
  }
  const qint64 element = this->GetElement(index.row());
  if (index.column() == 0)
  {
    return element;
  }
  const Metric* metric = this->Columns[static_cast<std::size_t>(index.column() - 1)];
  return QString::number(this->Picture->GetValue(metric->Name, element), 'g', 6);
}

QVariant ElementTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
  if (orientation == Qt::Vertical || section >= this->columnCount())
  {
    return {};
  }
  if (section == 0)
  {
    return role == Qt::DisplayRole ? QVariant(tr("Element")) : QVariant();
  }
  const Metric* metric = this->Columns[static_cast<std::size_t>(section - 1)];
  if (role == Qt::ToolTipRole)
  {
    return QStringLiteral("<p><b>%1</b> = %2</p><p>%3</p><p>%4</p>")
      .arg(QString::fromUtf8(metric->Label), QString::fromUtf8(metric->Formula).toHtmlEscaped(),
        QString::fromUtf8(metric->Description).toHtmlEscaped(),
        QString::fromUtf8(metric->Reference).toHtmlEscaped());
  }
  return role == Qt::DisplayRole ? QVariant(QString::fromUtf8(metric->Name)) : QVariant();
}

void ElementTableModel::sort(int column, Qt::SortOrder order)
{
  this->SortColumn = column;
  this->SortOrder = order;
  const QString metric = this->GetMetric(column);
  if (!this->Picture || (column != 0 && metric.isEmpty()))
  {
    return;
  }
  this->SortJob->Start(
    [this, picture = this->Picture, name = metric.toStdString(), order](
      const std::atomic<bool>&) -> LatestJob::Delivery
    {
      std::vector<vtkIdType> rows(static_cast<std::size_t>(picture->GetNumberOfElements()));
      std::iota(rows.begin(), rows.end(), vtkIdType{ 0 });
      const bool down = order == Qt::DescendingOrder;
      // NaN last in either order
      const auto key = [&](vtkIdType element)
      {
        const double value =
          name.empty() ? static_cast<double>(element) : picture->GetValue(name, element);
        return std::isnan(value) ? INFINITY : down ? -value : value;
      };
      std::stable_sort(
        rows.begin(), rows.end(), [&key](vtkIdType a, vtkIdType b) { return key(a) < key(b); });
      return [this, picture, rows]
      {
        if (this->Picture == picture)
        {
          emit this->layoutAboutToBeChanged();
          this->Rows = rows;
          emit this->layoutChanged();
          emit this->Sorted();
        }
      };
    });
}

} // namespace pemesh
