// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonTableModel.h"

#include "NumberText.h"
#include "StudyModel.h"

#include <array>

namespace pemesh
{

namespace
{

/** One column: how a number of a polygon is read from the study and put into the document. */
struct Column
{
  const char* Header;
  const char* Key;
  double (*Read)(const StudyPolygon& polygon);
  int Item = -1; // of the list at the key
};

const std::array<Column, 6> Columns{ {
  { QT_TRANSLATE_NOOP("pemesh::PolygonTableModel", "x"), "center",
    [](const StudyPolygon& polygon) { return polygon.Center[0]; }, 0 },
  { QT_TRANSLATE_NOOP("pemesh::PolygonTableModel", "y"), "center",
    [](const StudyPolygon& polygon) { return polygon.Center[1]; }, 1 },
  { QT_TRANSLATE_NOOP("pemesh::PolygonTableModel", "Scale"), "scale",
    [](const StudyPolygon& polygon) { return polygon.Scale; } },
  { QT_TRANSLATE_NOOP("pemesh::PolygonTableModel", "Turn"), "rotation",
    [](const StudyPolygon& polygon) { return polygon.Rotation; } },
  { QT_TRANSLATE_NOOP("pemesh::PolygonTableModel", "From"), "from",
    [](const StudyPolygon& polygon) { return polygon.From; } },
  { QT_TRANSLATE_NOOP("pemesh::PolygonTableModel", "To"), "to",
    [](const StudyPolygon& polygon) { return polygon.To; } },
} };

} // namespace

PolygonTableModel::PolygonTableModel(StudyModel* study, QObject* parent)
  : QAbstractTableModel(parent)
  , Study(study)
{
  connect(study, &StudyModel::Changed, this, &PolygonTableModel::Refresh);
  this->Refresh();
}

void PolygonTableModel::Refresh()
{
  const int count = static_cast<int>(this->Study->GetStudy().Polygons.size());
  if (count != this->Count)
  {
    this->beginResetModel();
    this->Count = count;
    this->endResetModel();
  }
  else if (count > 0)
  {
    emit this->dataChanged(this->index(0, 0), this->index(count - 1, this->columnCount() - 1));
  }
}

int PolygonTableModel::rowCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : this->Count;
}

int PolygonTableModel::columnCount(const QModelIndex& parent) const
{
  return parent.isValid() ? 0 : 1 + static_cast<int>(Columns.size());
}

QVariant PolygonTableModel::data(const QModelIndex& index, int role) const
{
  const bool isText = role == Qt::DisplayRole || role == Qt::EditRole;
  if (!index.isValid() || index.row() >= this->Count || !isText)
  {
    return {};
  }
  const StudyPolygon& polygon =
    this->Study->GetStudy().Polygons[static_cast<std::size_t>(index.row())];
  if (index.column() == 0)
  {
    return QString::fromStdString(polygon.Name.empty() ? polygon.Family : polygon.Name);
  }
  const double value = Columns[static_cast<std::size_t>(index.column() - 1)].Read(polygon);
  return QString::fromStdString(FormatNumber(value));
}

QVariant PolygonTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
  if (role != Qt::DisplayRole)
  {
    return {};
  }
  if (orientation == Qt::Vertical)
  {
    return section + 1;
  }
  return section == 0 ? tr("Name") : tr(Columns[static_cast<std::size_t>(section - 1)].Header);
}

Qt::ItemFlags PolygonTableModel::flags(const QModelIndex& index) const
{
  return QAbstractTableModel::flags(index) | Qt::ItemIsEditable;
}

bool PolygonTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
  if (role != Qt::EditRole || !index.isValid())
  {
    return false;
  }
  const std::string row = "polygons[" + std::to_string(index.row()) + "].";
  const std::string text = value.toString().toStdString();
  if (index.column() == 0)
  {
    text.empty() ? this->Study->RemoveValue(row + "name", tr("Name polygon"))
                 : this->Study->SetValue(row + "name", { text }, tr("Name polygon"));
    return true;
  }
  const std::optional<double> number = ParseNumber(text);
  const Column& column = Columns[static_cast<std::size_t>(index.column() - 1)];
  if (!number)
  {
    return false;
  }
  JsonValue changed = JsonNumber(*number);
  if (column.Item >= 0)
  {
    std::array<double, 2> center =
      this->Study->GetStudy().Polygons[static_cast<std::size_t>(index.row())].Center;
    center[static_cast<std::size_t>(column.Item)] = *number;
    changed = { JsonValue::List{ JsonNumber(center[0]), JsonNumber(center[1]) } };
  }
  this->Study->SetValue(
    row + column.Key, changed, tr("Change %1").arg(QString::fromUtf8(column.Key)));
  return true;
}

} // namespace pemesh
