// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CorrelationModel.h"

#include "ColorMaps.h"
#include "ColumnRoles.h"

#include <QBrush>

#include <cmath>

#include <vtkTable.h>
#include <vtkVariant.h>

namespace pemesh
{

void CorrelationModel::SetTable(vtkTable* correlation)
{
  this->beginResetModel();
  this->Rows.clear();
  this->Columns.clear();
  this->Values.clear();
  QStringList metrics;
  for (vtkIdType row = 0; correlation && row < correlation->GetNumberOfRows(); ++row)
  {
    const std::string x = correlation->GetValueByName(row, "X").ToString();
    const std::string y = correlation->GetValueByName(row, "Y").ToString();
    const QString names[2] = { QString::fromStdString(x), QString::fromStdString(y) };
    this->Values[{ names[0], names[1] }] = correlation->GetValueByName(row, "Spearman").ToDouble();
    for (int i = 0; i < 2; ++i)
    {
      QStringList& list = IsMetricColumn(i == 0 ? x : y) ? metrics : this->Columns;
      if (!list.contains(names[i]))
      {
        list << names[i];
      }
    }
  }
  this->Rows = metrics;
  this->Columns = this->Columns.isEmpty() ? metrics : this->Columns;
  this->endResetModel();
}

double CorrelationModel::GetValue(const QModelIndex& index) const
{
  const QString x = this->GetRowName(index.row());
  const QString y = this->GetColumnName(index.column());
  for (const auto& key : { std::pair(x, y), std::pair(y, x) })
  {
    const auto found = this->Values.find(key);
    if (found != this->Values.end())
    {
      return found->second;
    }
  }
  return x == y ? 1.0 : std::nan("");
}

int CorrelationModel::rowCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : static_cast<int>(this->Rows.size());
}

int CorrelationModel::columnCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : static_cast<int>(this->Columns.size());
}

QVariant CorrelationModel::data(const QModelIndex& index, int role) const
{
  const double value = index.isValid() ? this->GetValue(index) : std::nan("");
  if (std::isnan(value))
  {
    return {};
  }
  switch (role)
  {
    case Qt::DisplayRole:
      return QString::number(value, 'f', 2);
    case Qt::TextAlignmentRole:
      return QVariant::fromValue(Qt::Alignment(Qt::AlignCenter));
    case Qt::BackgroundRole:
    {
      const ChartColor color = MapColor(*FindColorMap("red-blue"), 0.5 * (value + 1.0));
      return QBrush(QColor(color[0], color[1], color[2]));
    }
    case Qt::ForegroundRole:
      return QBrush(std::abs(value) > 0.6 ? Qt::white : Qt::black);
    case Qt::ToolTipRole:
      return tr("%1 and %2: Spearman %3")
        .arg(this->GetRowName(index.row()), this->GetColumnName(index.column()))
        .arg(value, 0, 'f', 3);
    default:
      return {};
  }
}

QVariant CorrelationModel::headerData(int section, Qt::Orientation orientation, int role) const
{
  const QString name =
    orientation == Qt::Horizontal ? this->GetColumnName(section) : this->GetRowName(section);
  if (role == Qt::ToolTipRole)
  {
    return name;
  }
  // Every column of one run begins with its name.
  return role == Qt::DisplayRole
    ? QVariant(name.section(
        QLatin1Char('_'), orientation == Qt::Horizontal && this->Rows != this->Columns ? 1 : 0))
    : QVariant();
}

} // namespace pemesh
