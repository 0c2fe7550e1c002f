// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshChoiceDialog.h"

#include "StudyCases.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <stdexcept>

namespace pemesh
{

namespace
{

std::vector<StudyCase> CasesOf(const Study& study)
{
  try
  {
    return MakeStudyCases(study);
  }
  catch (const std::exception&) // a run will say what is wrong
  {
    return {};
  }
}

/** One row a mesh: its name and what is swept. */
void Fill(QTableWidget* table, const std::vector<StudyCase>& cases)
{
  QStringList titles{ MeshChoiceDialog::tr("Mesh") };
  for (const SweptValue& value : cases.empty() ? std::vector<SweptValue>() : cases.front().Values)
  {
    titles << QString::fromStdString(value.Name);
  }
  table->setColumnCount(static_cast<int>(titles.size()));
  table->setHorizontalHeaderLabels(titles);
  table->setRowCount(static_cast<int>(cases.size()));
  for (int row = 0; row < table->rowCount(); ++row)
  {
    const StudyCase& studyCase = cases[static_cast<std::size_t>(row)];
    table->setItem(row, 0, new QTableWidgetItem(QString::fromStdString(studyCase.Name)));
    for (int i = 1; i < table->columnCount(); ++i)
    {
      table->setItem(row, i,
        new QTableWidgetItem(QString::fromStdString(
          FormatScalar(studyCase.Values[static_cast<std::size_t>(i - 1)].Value))));
    }
  }
}

} // namespace

MeshChoiceDialog::MeshChoiceDialog(const Study& study, const QStringList& chosen, QWidget* parent)
  : QDialog(parent)
  , Table(new QTableWidget(this))
{
  this->setWindowTitle(tr("Run some meshes"));
  this->resize(460, 520);
  auto* layout = new QVBoxLayout(this);
  auto* words = new QLabel(
    tr("Select the meshes to run (with Ctrl or Shift several). The results hold these alone."),
    this);
  words->setWordWrap(true);
  layout->addWidget(words);
  Fill(this->Table, CasesOf(study));
  this->Table->setAccessibleName(tr("Meshes"));
  this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->Table->setSelectionMode(QAbstractItemView::ExtendedSelection);
  this->Table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->Table->setTabKeyNavigation(false);
  this->Table->verticalHeader()->hide();
  this->Table->verticalHeader()->setDefaultSectionSize(24);
  this->Table->horizontalHeader()->setStretchLastSection(true);
  this->Table->setColumnWidth(0, 180);
  layout->addWidget(this->Table, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  QPushButton* run = buttons->addButton(QString(), QDialogButtonBox::AcceptRole);
  run->setObjectName(QStringLiteral("primary"));
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  const auto show = [this, run]
  {
    const auto count = static_cast<int>(this->Table->selectionModel()->selectedRows().size());
    run->setEnabled(count > 0);
    run->setText(count == 1 ? tr("Run one mesh") : tr("Run %1 meshes").arg(count));
  };
  connect(this->Table, &QTableWidget::itemSelectionChanged, this, show);
  for (int row = 0; row < this->Table->rowCount(); ++row)
  {
    if (chosen.contains(this->Table->item(row, 0)->text()))
    {
      this->Table->selectionModel()->select(this->Table->model()->index(row, 0),
        QItemSelectionModel::Select | QItemSelectionModel::Rows);
    }
  }
  show();
}

std::vector<int> MeshChoiceDialog::GetCases() const
{
  std::vector<int> cases;
  for (const QModelIndex& index : this->Table->selectionModel()->selectedRows())
  {
    cases.push_back(index.row());
  }
  std::sort(cases.begin(), cases.end());
  return cases;
}

} // namespace pemesh
