// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CorrelationPage.h"

#include "ChartOptions.h"
#include "ColumnLabels.h"
#include "ColumnRoles.h"
#include "CorrelationModel.h"
#include "EmptyState.h"
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
#include <QToolButton>
#include <QVBoxLayout>

#include <vtkTable.h>
#include <vtkVariant.h>

namespace pemesh
{

namespace
{
constexpr int XRole = Qt::UserRole;
constexpr int YRole = Qt::UserRole + 1;
constexpr const char* FitOption = "fit";

/** The curves that charts can fit. */
QStringList FitChoices()
{
  QStringList choices;
  for (const auto& field : ChartOptionFields())
  {
    if (field.Name == FitOption)
    {
      for (const std::string& choice : field.Choices)
      {
        choices << QString::fromStdString(choice);
      }
    }
  }
  return choices;
}

} // namespace

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
  connect(this->Chart, &PanelView::RowsSelected, this,
    [this](int, const std::vector<vtkIdType>& rows) { this->Selected->MarkCases(rows); });
  connect(selection, &Selection::CasesMarked, this,
    [this] { this->Chart->SetHighlightedRows(this->Selected->GetMarkedCases()); });
  this->ShowResults();
}

QWidget* CorrelationPage::MakeBar()
{
  auto* bar = new QFrame(this);
  bar->setObjectName(QStringLiteral("barAbove"));
  auto* line = new QHBoxLayout(bar);
  line->setContentsMargins(12, 6, 8, 6);
  const auto addBox = [this, bar, line](const QString& text, int stretch)
  {
    auto* label = new QLabel(text, bar);
    auto* box = new QComboBox(bar);
    label->setBuddy(box);
    box->setMaxVisibleItems(30);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(9);
    box->setAccessibleName(text);
    line->addWidget(label);
    line->addWidget(box, stretch);
    connect(box, &QComboBox::currentTextChanged, this, &CorrelationPage::ShowChart);
    connect(box, &QComboBox::activated, this, [this] { this->IsChosen = true; });
    return box;
  };
  const auto addLog = [this, bar, line](const QString& tip)
  {
    auto* button = new QToolButton(bar);
    button->setText(tr("log"));
    button->setCheckable(true);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    line->addWidget(button);
    connect(button, &QToolButton::toggled, this, &CorrelationPage::ShowChart);
    return button;
  };
  this->X = addBox(tr("X"), 1);
  this->LogX = addLog(tr("Logarithmic x axis"));
  this->Y = addBox(tr("Y"), 1);
  this->LogY = addLog(tr("Logarithmic y axis"));
  this->Color = addBox(tr("Colour"), 1);
  this->Fit = addBox(tr("Fit"), 0);
  {
    const QSignalBlocker blocker(this->Fit);
    this->Fit->addItems(FitChoices());
  }
  auto* save = new QToolButton(bar);
  save->setIcon(MakeIcon("export"));
  save->setToolTip(tr("Export the chart"));
  save->setAccessibleName(tr("Export the chart"));
  line->addWidget(save);
  connect(save, &QToolButton::clicked, this, [this] { this->Chart->ExportAs(); });
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
  this->NoFindings = new QLabel(words);
  this->NoFindings->setObjectName(QStringLiteral("emptyText"));
  this->NoFindings->setAlignment(Qt::AlignCenter);
  this->NoFindings->setWordWrap(true);
  this->NoFindings->setMargin(24);
  column->addWidget(this->Findings, 1);
  column->addWidget(this->NoFindings, 1);
  this->Matrix = new CorrelationModel(this);
  auto* matrix = new QTableView(tabs);
  matrix->setModel(this->Matrix);
  matrix->horizontalHeader()->setDefaultSectionSize(74);
  matrix->verticalHeader()->setDefaultSectionSize(22);
  matrix->setTabKeyNavigation(false);
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
  connect(this->Findings, &QListWidget::itemClicked, this, [this] { this->IsChosen = true; });
  connect(matrix, &QTableView::clicked, this, [this] { this->IsChosen = true; });
  connect(this->Findings, &QListWidget::currentItemChanged, this,
    [this](QListWidgetItem* item)
    {
      if (item && item->data(XRole).isValid())
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
    const QSignalBlocker blockY(this->Y);
    this->X->setCurrentText(x);
    this->Y->setCurrentText(y);
  }
  this->ShowChart();
}

void CorrelationPage::ShowResults()
{
  const bool isEmpty = this->Results->IsEmpty();
  this->Stack->setCurrentIndex(isEmpty ? 0 : 1);
  this->IsChosen = this->IsChosen && !isEmpty;
  const QStringList columns = this->Results->GetNumberColumns();
  for (QComboBox* box : { this->X, this->Y, this->Color })
  {
    const QSignalBlocker blocker(box);
    const QString before = box->currentText();
    box->clear();
    box->addItems(box == this->Color ? QStringList{ tr("none") } + columns : columns);
    box->setCurrentText(before);
  }
  this->Matrix->SetTable(this->Results->GetCorrelation());
  this->ShowFindings();
  if (!this->IsChosen)
  {
    this->ChooseColumns();
  }
  this->ShowChart();
}

/** The first finding; while there is none, the metric that is looked at and a performance. */
void CorrelationPage::ChooseColumns()
{
  for (int row = 0; row < this->Findings->count(); ++row)
  {
    if (this->Findings->item(row)->flags() & Qt::ItemIsSelectable)
    {
      this->Findings->setCurrentRow(row);
      return;
    }
  }
  if (vtkTable* table = this->Results->GetTable())
  {
    const std::vector<std::string> performances = PerformanceColumns(table);
    this->SetColumns(this->Selected->GetMetric() + QStringLiteral("_min"),
      performances.empty() ? this->Selected->GetMetric() + QStringLiteral("_max")
                           : QString::fromStdString(performances.front()));
  }
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
  plot.ColorBy =
    this->Color->currentIndex() > 0 ? this->Color->currentText().toStdString() : std::string();
  plot.Log = std::string(this->LogX->isChecked() ? "x" : "") + (this->LogY->isChecked() ? "y" : "");
  if (this->Fit->currentIndex() > 0)
  {
    plot.Options[FitOption] = this->Fit->currentText().toStdString();
  }
  this->Chart->SetMaker([plot, table = vtkSmartPointer<vtkTable>(this->Results->GetTable()),
                          labels = this->Results->GetLabels()]
    { return PanelList{ MakeResultChart(plot, table, *labels) }; });
}

/** What a person reads and does not choose. */
void CorrelationPage::AddWords(const QString& text, bool isHeading)
{
  auto* item = new QListWidgetItem(text, this->Findings);
  item->setFlags(Qt::NoItemFlags);
  QFont font = item->font();
  font.setBold(isHeading);
  item->setFont(font);
}

/** As the run wrote them: by performance, the metric that goes with it best first. */
void CorrelationPage::ShowFindings()
{
  const QSignalBlocker blocker(this->Findings);
  this->Findings->clear();
  vtkTable* findings = this->Results->GetFindings();
  const QString wanted = this->Filter->text();
  const auto cell = [findings](vtkIdType row, const char* column)
  { return QString::fromStdString(findings->GetValueByName(row, column).ToString()); };
  QString performance;
  QString joint; // in the first row of each performance
  for (vtkIdType row = 0; findings && row < findings->GetNumberOfRows(); ++row)
  {
    joint = cell(row, "Joint").isEmpty() ? joint : cell(row, "Joint");
    const QString sentence = cell(row, "Sentence");
    const QString title = QString::fromStdString(
      this->Results->GetLabels()->Title(cell(row, "Performance").toStdString()));
    const bool isWanted = wanted.isEmpty() || sentence.contains(wanted, Qt::CaseInsensitive) ||
      title.contains(wanted, Qt::CaseInsensitive);
    if (findings->GetValueByName(row, "Rank").ToInt() == 0 || !isWanted)
    {
      continue;
    }
    if (cell(row, "Performance") != performance)
    {
      performance = cell(row, "Performance");
      this->AddWords(title, true);
      this->AddWords(joint, false);
    }
    auto* item =
      new QListWidgetItem(cell(row, "Rank") + QStringLiteral(". ") + sentence, this->Findings);
    item->setData(XRole, cell(row, "Metric"));
    item->setData(YRole, performance);
    item->setToolTip(
      QString::fromStdString(this->Results->GetLabels()->Title(cell(row, "Metric").toStdString())));
  }
  const bool isEmpty = this->Findings->count() == 0;
  this->NoFindings->setVisible(isEmpty);
  this->Findings->setVisible(!isEmpty);
  this->NoFindings->setText(!wanted.isEmpty()
      ? tr("No relation mentions \"%1\".").arg(wanted)
      : tr("There is nothing to say yet: relations are found between the metrics of three meshes "
           "or more and the performances of a solver."));
}

} // namespace pemesh
