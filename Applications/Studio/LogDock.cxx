// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LogDock.h"

#include "Appearance.h"
#include "MetricRegistry.h"
#include "NumberText.h"
#include "Selection.h"

#include <QFontDatabase>
#include <QHeaderView>
#include <QPlainTextEdit>
#include <QTabWidget>
#include <QTableWidget>
#include <QTime>

#include <cmath>

#include <vtkAbstractArray.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>
#include <vtkVariant.h>

namespace pemesh
{

namespace
{
constexpr int MostLines = 20000;
}

LogDock::LogDock(Selection* selection, QWidget* parent)
  : QDockWidget(tr("Log and values"), parent)
  , Selected(selection)
  , Tabs(new QTabWidget(this))
  , Log(new QPlainTextEdit(this))
  , Values(new QTableWidget(0, 2, this))
{
  this->setObjectName(QStringLiteral("logDock"));
  this->Log->setReadOnly(true);
  this->Log->setTabChangesFocus(true);
  this->Log->setMaximumBlockCount(MostLines);
  this->Log->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  this->Log->setAccessibleName(tr("Log"));
  this->Values->setHorizontalHeaderLabels({ tr("Value"), tr("Of the mesh in view") });
  this->Values->horizontalHeader()->setStretchLastSection(true);
  this->Values->setColumnWidth(0, 260);
  this->Values->verticalHeader()->hide();
  this->Values->verticalHeader()->setDefaultSectionSize(22);
  this->Values->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->Values->setAlternatingRowColors(true);
  this->Values->setTabKeyNavigation(false);
  this->Values->setAccessibleName(tr("Values"));
  this->Tabs->setDocumentMode(true);
  this->Tabs->addTab(this->Log, tr("Log"));
  this->Tabs->addTab(this->Values, tr("Values"));
  this->setWidget(this->Tabs);
  connect(selection, &Selection::ElementChanged, this, &LogDock::ShowValues);
}

void LogDock::Tell(const QString& line, bool isFault)
{
  const QString text = QTime::currentTime().toString(QStringLiteral("HH:mm:ss  ")) + line;
  if (isFault)
  {
    this->Log->appendHtml(QStringLiteral("<span style=\"color:%1; white-space:pre\">%2</span>")
                            .arg(CurrentTheme().Danger.name(), text.toHtmlEscaped()));
    return;
  }
  this->Log->appendPlainText(text);
}

QString LogDock::GetText() const
{
  return this->Log->toPlainText();
}

void LogDock::ShowLog()
{
  this->show();
  this->Tabs->setCurrentWidget(this->Log);
}

void LogDock::SetPicture(const MeshPicturePointer& picture)
{
  if (this->Picture != picture)
  {
    this->Picture = picture;
    this->ShowValues();
  }
}

void LogDock::ShowValues()
{
  QList<std::pair<QString, QString>> rows;
  const qint64 element = this->Selected->GetElement();
  if (this->Picture)
  {
    vtkPolyData* mesh = this->Picture->GetMesh();
    rows << std::pair(tr("Elements"), QString::number(mesh->GetNumberOfCells()))
         << std::pair(tr("Vertices"), QString::number(mesh->GetNumberOfPoints()));
    vtkFieldData* fields = mesh->GetFieldData();
    for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = fields->GetAbstractArray(i);
      if (array && array->GetNumberOfValues() == 1)
      {
        rows << std::pair(QString::fromUtf8(array->GetName()),
          QString::fromStdString(array->GetVariantValue(0).ToString()));
      }
    }
    const bool inMesh = element >= 0 && element < this->Picture->GetNumberOfElements();
    for (const Metric& metric : Metrics())
    {
      const double value = inMesh ? this->Picture->GetValue(metric.Name, element) : std::nan("");
      if (inMesh && !std::isnan(value))
      {
        rows << std::pair(tr("Element %1: %2").arg(element).arg(QString::fromUtf8(metric.Label)),
          QString::fromStdString(FormatNumber(value)));
      }
    }
  }
  this->Values->setRowCount(static_cast<int>(rows.size()));
  for (int i = 0; i < rows.size(); ++i)
  {
    this->Values->setItem(i, 0, new QTableWidgetItem(rows[i].first));
    this->Values->setItem(i, 1, new QTableWidgetItem(rows[i].second));
  }
}

} // namespace pemesh
