// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CorrelationPage.h"

#include "ColumnLabels.h"
#include "CorrelationModel.h"
#include "EmptyState.h"
#include "Findings.h"
#include "Icons.h"
#include "PanelView.h"
#include "ResultPanels.h"
#include "ResultSet.h"
#include "Selection.h"
#include "Study.h"
#include "vtkPEMChart.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTableView>
#include <QToolBar>
#include <QVBoxLayout>

#include <vtkTable.h>

namespace pemesh
{

namespace
{
constexpr int MostFindings = 300;
constexpr int XRole = Qt::UserRole;
constexpr int YRole = Qt::UserRole + 1;
}

CorrelationPage::CorrelationPage(ResultSet* results, Selection* selection, QWidget* parent)
  : QWidget(parent)
  , Results(results)
  , Selected(selection)
{
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  this->Stack = new QStackedWidget(this);
  layout->addWidget(this->Stack);
  auto* empty = new EmptyState("correlation", tr("What drives what?"),
    tr("Run a study with a solver: every metric of the meshes is then set against every "
       "performance of the solver, and the strongest relations are listed here in words."),
    tr("Run with a solver"), this->Stack);
  connect(empty, &EmptyState::Clicked, this, &CorrelationPage::RunWanted);
  this->Stack->addWidget(empty);

  auto* content = new QWidget(this->Stack);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(this->MakeBar());
  auto* splitter = new QSplitter(content);
  splitter->setHandleWidth(1);
  this->Chart = new PanelView(splitter);
  this->Chart->SetFontSize(14.0);
  splitter->addWidget(this->Chart);
  splitter->addWidget(this->MakeSide());
  splitter->setStretchFactor(0, 1);
  splitter->setSizes({ 720, 400 });
  column->addWidget(splitter, 1);
  this->Stack->addWidget(content);
  connect(results, &ResultSet::Changed, this, &CorrelationPage::ShowResults);
  connect(this->Chart, &PanelView::DoubleClicked, this, &CorrelationPage::MeshWanted);
  connect(this->Chart, &PanelView::Picked, this,
    [this](int, const ChartPick& pick)
    {
      if (pick.Row >= 0)
      {
        this->Selected->SetCase(static_cast<int>(pick.Row));
        emit this->Told(tr("%1: double click to see the mesh").arg(pick.Text.c_str()));
      }
    });
  connect(selection, &Selection::CaseChanged, this,
    [this](int index)
    {
      this->Chart->SetHighlightedRows(
        index < 0 ? std::vector<vtkIdType>() : std::vector<vtkIdType>{ index });
    });
  this->ShowResults();
}

QWidget* CorrelationPage::MakeBar()
{
  auto* bar = new QToolBar(this);
  bar->setIconSize({ 18, 18 });
  const auto addBox = [this, bar](const QString& text)
  {
    bar->addWidget(new QLabel(text, bar));
    auto* box = new QComboBox(bar);
    box->setMaxVisibleItems(30);
    box->setMinimumWidth(190);
    box->setAccessibleName(text);
    bar->addWidget(box);
    connect(box, &QComboBox::currentTextChanged, this, &CorrelationPage::ShowChart);
    return box;
  };
  const auto addLog = [this, bar](const QString& tip)
  {
    QAction* action = bar->addAction(tr("log"));
    action->setCheckable(true);
    action->setToolTip(tip);
    connect(action, &QAction::toggled, this, &CorrelationPage::ShowChart);
    return action;
  };
  this->X = addBox(tr("X "));
  this->LogX = addLog(tr("Logarithmic x axis"));
  this->Y = addBox(tr("  Y "));
  this->LogY = addLog(tr("Logarithmic y axis"));
  this->Color = addBox(tr("  Colour "));
  auto* space = new QWidget(bar);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  QAction* save = bar->addAction(MakeIcon("export"), tr("Export the chart"));
  connect(save, &QAction::triggered, this, [this] { this->Chart->ExportAs(); });
  return bar;
}

QWidget* CorrelationPage::MakeSide()
{
  auto* panel = new QFrame(this);
  panel->setObjectName(QStringLiteral("sidePanel"));
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* tabs = new QTabWidget(panel);
  tabs->setDocumentMode(true);
  layout->addWidget(tabs);
  auto* words = new QWidget(tabs);
  auto* column = new QVBoxLayout(words);
  column->setContentsMargins(0, 10, 0, 0);
  this->Filter = new QLineEdit(panel);
  this->Filter->setPlaceholderText(tr("Only those that mention …"));
  this->Filter->setClearButtonEnabled(true);
  this->Filter->setAccessibleName(tr("Filter of the relations"));
  this->Findings = new QListWidget(panel);
  this->Findings->setWordWrap(true);
  this->Findings->setSpacing(4);
  this->Findings->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  this->Findings->setAccessibleName(tr("Strongest relations"));
  auto* box = new QHBoxLayout;
  box->setContentsMargins(12, 0, 12, 0);
  box->addWidget(this->Filter);
  column->addLayout(box);
  column->addWidget(this->Findings, 1);
  this->Matrix = new CorrelationModel(this);
  auto* matrix = new QTableView(tabs);
  matrix->setModel(this->Matrix);
  matrix->horizontalHeader()->setDefaultSectionSize(74);
  matrix->verticalHeader()->setDefaultSectionSize(22);
  matrix->setAccessibleName(tr("Matrix of correlations"));
  connect(matrix, &QTableView::clicked, this,
    [this](const QModelIndex& index)
    {
      this->SetColumns(
        this->Matrix->GetRowName(index.row()), this->Matrix->GetColumnName(index.column()));
    });
  tabs->addTab(words, tr("Strongest relations"));
  tabs->addTab(matrix, tr("Matrix"));
  connect(this->Filter, &QLineEdit::textChanged, this, &CorrelationPage::ShowFindings);
  connect(this->Findings, &QListWidget::currentItemChanged, this,
    [this](QListWidgetItem* item)
    {
      if (item)
      {
        this->SetColumns(item->data(XRole).toString(), item->data(YRole).toString());
      }
    });
  return panel;
}

void CorrelationPage::SetColumns(const QString& x, const QString& y)
{
  {
    const QSignalBlocker blockX(this->X);
    this->X->setCurrentText(x);
    this->Y->setCurrentText(y);
  }
  this->ShowChart();
}

void CorrelationPage::ShowResults()
{
  const bool isEmpty = this->Results->IsEmpty();
  this->Stack->setCurrentIndex(isEmpty ? 0 : 1);
  const QStringList columns = this->Results->GetNumberColumns();
  for (QComboBox* box : { this->X, this->Y, this->Color })
  {
    const QSignalBlocker blocker(box);
    const QString before = box->currentText();
    box->clear();
    box->addItems(columns);
    box->setCurrentText(before);
  }
  {
    const QSignalBlocker blocker(this->Color);
    this->Color->insertItem(0, QString());
    this->Color->setCurrentIndex(0);
  }
  this->Matrix->SetTable(this->Results->GetCorrelation());
  this->ShowFindings();
  if (this->Findings->count() > 0)
  {
    this->Findings->setCurrentRow(0);
  }
  this->ShowChart();
}

void CorrelationPage::ShowChart()
{
  if (this->Results->IsEmpty() || this->X->currentText().isEmpty())
  {
    this->Chart->SetMaker({});
    return;
  }
  StudyPlot plot;
  plot.Kind = "scatter";
  plot.X = this->X->currentText().toStdString();
  plot.Y = { this->Y->currentText().toStdString() };
  plot.ColorBy = this->Color->currentText().toStdString();
  plot.Log = std::string(this->LogX->isChecked() ? "x" : "") + (this->LogY->isChecked() ? "y" : "");
  this->Chart->SetMaker([plot, table = vtkSmartPointer<vtkTable>(this->Results->GetTable()),
                          labels = this->Results->GetLabels()]
    { return PanelList{ MakeResultChart(plot, table, *labels) }; });
}

void CorrelationPage::ShowFindings()
{
  const QSignalBlocker blocker(this->Findings);
  this->Findings->clear();
  const QString wanted = this->Filter->text();
  for (const Finding& finding :
    RankFindings(this->Results->GetCorrelation(), *this->Results->GetLabels()))
  {
    const QString text = QString::fromStdString(finding.Sentence);
    if (!wanted.isEmpty() && !text.contains(wanted, Qt::CaseInsensitive))
    {
      continue;
    }
    auto* item = new QListWidgetItem(text, this->Findings);
    item->setData(XRole, QString::fromStdString(finding.X));
    item->setData(YRole, QString::fromStdString(finding.Y));
    item->setToolTip(QString::fromStdString(finding.X + " – " + finding.Y));
    if (this->Findings->count() >= MostFindings)
    {
      break;
    }
  }
}

} // namespace pemesh
