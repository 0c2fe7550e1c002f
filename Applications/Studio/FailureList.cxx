// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "FailureList.h"

#include "ResultSet.h"
#include "Selection.h"

#include <QFile>
#include <QFontDatabase>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

#include <vtkTable.h>
#include <vtkVariant.h>

namespace pemesh
{

namespace
{

constexpr qint64 MostOfLog = 20000; // bytes from its end

QString EndOf(const QString& path)
{
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly))
  {
    return {};
  }
  file.seek(std::max<qint64>(0, file.size() - MostOfLog));
  return QString::fromUtf8(file.readAll()).trimmed();
}

} // namespace

FailureList::FailureList(ResultSet* results, Selection* selection, QWidget* parent)
  : QWidget(parent)
  , Results(results)
  , Selected(selection)
  , Table(new QTableWidget(0, 4, this))
  , Message(new QLabel(this))
  , Log(new QPlainTextEdit(this))
{
  this->Table->setHorizontalHeaderLabels(
    { tr("Mesh"), tr("Stage"), tr("Status"), tr("What happened") });
  this->Table->horizontalHeader()->setStretchLastSection(true);
  this->Table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->Table->setTabKeyNavigation(false);
  this->Table->verticalHeader()->hide();
  this->Table->setAccessibleName(tr("Failures"));
  this->Message->setWordWrap(true);
  this->Message->setTextInteractionFlags(Qt::TextSelectableByMouse);
  this->Message->setMargin(12);
  this->Log->setReadOnly(true);
  this->Log->setTabChangesFocus(true);
  this->Log->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  this->Log->setPlaceholderText(tr("The solver wrote nothing."));
  this->Log->setAccessibleName(tr("What the solver wrote"));
  this->Log->hide();
  auto* below = new QWidget(this);
  auto* column = new QVBoxLayout(below);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(this->Message);
  column->addWidget(this->Log, 1);
  auto* splitter = new QSplitter(Qt::Vertical, this);
  splitter->setHandleWidth(1);
  splitter->addWidget(this->Table);
  splitter->addWidget(below);
  splitter->setStretchFactor(0, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(splitter);
  connect(results, &ResultSet::Changed, this, &FailureList::Show);
  connect(this->Table, &QTableWidget::currentCellChanged, this, &FailureList::ShowFailure);
  this->Show();
}

int FailureList::GetCount() const
{
  return this->Table->rowCount();
}

QString FailureList::GetLog() const
{
  return this->Log->toPlainText();
}

void FailureList::Show()
{
  vtkTable* failures = this->Results->GetFailures();
  const int count = failures ? static_cast<int>(failures->GetNumberOfRows()) : 0;
  this->Table->setRowCount(count);
  const char* columns[] = { "Mesh", "Stage", "Status", "Message" };
  for (int row = 0; row < count; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      this->Table->setItem(row, column,
        new QTableWidgetItem(
          QString::fromStdString(failures->GetValueByName(row, columns[column]).ToString())));
    }
  }
  this->Log->hide();
  this->Message->setText(count == 0 ? tr("No failures.") : tr("Select a failure to read it."));
}

void FailureList::ShowFailure(int row)
{
  if (row < 0 || row >= this->GetCount() || !this->Table->item(row, 3))
  {
    return;
  }
  const QString mesh = this->Table->item(row, 0)->text();
  const QString folder =
    QStringLiteral("/solvers/%1/%2/").arg(this->Table->item(row, 1)->text(), mesh);
  const QString path = this->Results->GetFolder() + folder;
  const bool ofSolver = QFile::exists(path);
  this->Message->setText(this->Table->item(row, 3)->text() +
    (ofSolver ? tr("\n\nIts files are in %1").arg(folder.mid(1)) : QString()));
  this->Message->setToolTip(ofSolver ? path : QString());
  this->Log->setPlainText((EndOf(path + QStringLiteral("stderr.log")) + QLatin1Char('\n') +
    EndOf(path + QStringLiteral("stdout.log")))
                            .trimmed());
  this->Log->setVisible(ofSolver);
  const int index = this->Results->FindMesh(mesh);
  if (index >= 0)
  {
    this->Selected->SetCase(index);
  }
}

} // namespace pemesh
