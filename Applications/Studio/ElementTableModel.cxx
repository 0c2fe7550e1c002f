// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementTableModel.h"

#include "Appearance.h"
#include "ArrayValues.h"
#include "LatestJob.h"
#include "MetricRegistry.h"

#include <QBrush>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

/** The elements in order of a metric (none: of their numbers), those without a value last. */
std::vector<vtkIdType> SortElements(
  const MeshPicture& picture, const std::string& metric, Qt::SortOrder order)
{
  std::vector<vtkIdType> rows(static_cast<std::size_t>(picture.GetNumberOfElements()));
  std::iota(rows.begin(), rows.end(), vtkIdType{ 0 });
  vtkDataArray* values = picture.GetMesh()->GetCellData()->GetArray(metric.c_str());
  std::vector<double> keys(rows.begin(), rows.end());
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    const double key = values ? ValueOf(values, rows[i]) : keys[i];
    keys[i] = std::isnan(key) ? INFINITY : order == Qt::DescendingOrder ? -key : key;
  }
  std::stable_sort(rows.begin(), rows.end(),
    [&keys](vtkIdType a, vtkIdType b)
    { return keys[static_cast<std::size_t>(a)] < keys[static_cast<std::size_t>(b)]; });
  return rows;
}

std::vector<vtkIdType> Inverse(const std::vector<vtkIdType>& permutation)
{
  std::vector<vtkIdType> inverse(permutation.size());
  for (std::size_t i = 0; i < permutation.size(); ++i)
  {
    inverse[static_cast<std::size_t>(permutation[i])] = static_cast<vtkIdType>(i);
  }
  return inverse;
}

} // namespace

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
  this->Marked.clear();
  this->Rows.clear();
  this->RowsOfElements.clear();
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

void ElementTableModel::SetMarked(const std::vector<vtkIdType>& elements)
{
  const auto count = static_cast<std::size_t>(this->rowCount());
  this->Marked.assign(count, false);
  for (const vtkIdType element : elements)
  {
    if (element < static_cast<vtkIdType>(count))
    {
      this->Marked[static_cast<std::size_t>(element)] = true;
    }
  }
  if (count > 0)
  {
    emit this->dataChanged(this->index(0, 0),
      this->index(this->rowCount() - 1, this->columnCount() - 1), { Qt::BackgroundRole });
  }
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
  return static_cast<int>(this->RowsOfElements.empty()
      ? element
      : this->RowsOfElements[static_cast<std::size_t>(element)]);
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
  const qint64 element = this->GetElement(index.row());
  if (role == Qt::BackgroundRole && element >= 0 &&
    element < static_cast<qint64>(this->Marked.size()) &&
    this->Marked[static_cast<std::size_t>(element)])
  {
    return QBrush(CurrentTheme().AccentSoft);
  }
  if (role != Qt::DisplayRole || !index.isValid())
  {
    return {};
  }
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
      const std::vector<vtkIdType> rows = SortElements(*picture, name, order);
      return [this, picture, rows, inverse = Inverse(rows)]
      {
        if (this->Picture == picture)
        {
          this->Arrange(rows, inverse);
        }
      };
    });
}

/** What is selected or current stays with its element. */
void ElementTableModel::Arrange(
  const std::vector<vtkIdType>& rows, const std::vector<vtkIdType>& rowsOfElements)
{
  emit this->layoutAboutToBeChanged({}, QAbstractItemModel::VerticalSortHint);
  const QModelIndexList before = this->persistentIndexList();
  std::vector<qint64> elements;
  for (const QModelIndex& index : before)
  {
    elements.push_back(this->GetElement(index.row()));
  }
  this->Rows = rows;
  this->RowsOfElements = rowsOfElements;
  QModelIndexList after;
  for (qsizetype i = 0; i < before.size(); ++i)
  {
    after << this->index(this->FindRow(elements[static_cast<std::size_t>(i)]), before[i].column());
  }
  this->changePersistentIndexList(before, after);
  emit this->layoutChanged({}, QAbstractItemModel::VerticalSortHint);
  emit this->Sorted();
}

} // namespace pemesh
