// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverPage.h"

#include "FailureList.h"
#include "GeometryPanels.h"
#include "Icons.h"
#include "OptionForm.h"
#include "PanelView.h"
#include "ResultSet.h"
#include "RunBox.h"
#include "Selection.h"
#include "SolutionPanels.h"
#include "SolverDescriptionFile.h"
#include "StudyModel.h"
#include "SurfaceWindow.h"
#include "TimeBar.h"

#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

#include <vtkTable.h>

namespace pemesh
{

namespace
{

constexpr int ChartColumns = 3;
constexpr int ChartHeight = 210; // pixels, at least
constexpr const char* DefaultSolver = "pemesh-vem";

QLabel* MakeHeading(const QString& text, QWidget* parent)
{
  auto* label = new QLabel(text, parent);
  label->setObjectName(QStringLiteral("heading"));
  return label;
}

} // namespace

SolverPage::SolverPage(StudyModel* model, ResultSet* results, RunController* controller,
  Selection* selection, QWidget* parent)
  : QWidget(parent)
  , Model(model)
  , Results(results)
  , Controller(controller)
  , Selected(selection)
{
  auto* splitter = new QSplitter(this);
  splitter->setHandleWidth(1);
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(this->MakeLeft());
  splitter->addWidget(this->MakeRight());
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({ 330, 800 });
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(splitter);
  connect(model, &StudyModel::Changed, this, &SolverPage::ShowRuns);
  connect(results, &ResultSet::Changed, this, &SolverPage::ShowResults);
  connect(results, &ResultSet::PictureChanged, this, &SolverPage::ShowSolutions);
  connect(selection, &Selection::CaseChanged, this, &SolverPage::ShowCase);
  connect(selection, &Selection::CasesMarked, this,
    [this] { this->Charts->SetHighlightedRows(this->Selected->GetMarkedCases()); });
  connect(selection, &Selection::ElementsMarked, this,
    [this] { this->Solutions->SetHighlightedRows(this->Selected->GetMarkedElements()); });
  this->ShowRuns();
  this->ShowResults();
}

/** Which solvers there are, to add one and to remove one. */
QBoxLayout* SolverPage::MakeSolverLine(QWidget* panel)
{
  auto* line = new QHBoxLayout;
  this->Known = new QComboBox(panel);
  this->Known->setAccessibleName(tr("Known solvers"));
  for (const FoundSolver& found : ListSolvers())
  {
    if (found.Error.empty())
    {
      this->Known->addItem(QString::fromStdString(found.Description.Name));
      this->Known->setItemData(
        this->Known->count() - 1, QString::fromStdString(found.Description.Label), Qt::ToolTipRole);
    }
  }
  this->Known->setCurrentText(QString::fromLatin1(DefaultSolver));
  auto* add = new QPushButton(MakeIcon("add"), tr("Add"), panel);
  add->setObjectName(QStringLiteral("addSolver"));
  connect(
    add, &QPushButton::clicked, this, [this] { this->AddSolver(this->Known->currentText()); });
  auto* file = new QToolButton(panel);
  file->setIcon(MakeIcon("open"));
  file->setAccessibleName(tr("Add from a file"));
  file->setToolTip(tr("Add a solver described by a file"));
  connect(file, &QToolButton::clicked, this,
    [this]
    {
      const QString path = QFileDialog::getOpenFileName(
        this, tr("Description of a solver"), {}, tr("Descriptions (*.json)"));
      if (!path.isEmpty())
      {
        this->AddSolver(path);
      }
    });
  auto* remove = new QToolButton(panel);
  remove->setIcon(MakeIcon("delete"));
  remove->setAccessibleName(tr("Remove solver"));
  remove->setToolTip(tr("Remove the selected solver"));
  connect(remove, &QToolButton::clicked, this,
    [this]
    {
      if (this->Runs->currentRow() >= 0)
      {
        this->Model->RemoveValue(
          "solvers[" + std::to_string(this->Runs->currentRow()) + "]", tr("Remove solver"));
      }
    });
  line->addWidget(this->Known, 1);
  line->addWidget(add);
  line->addWidget(file);
  line->addWidget(remove);
  return line;
}

QWidget* SolverPage::MakeLeft()
{
  auto* panel = new QFrame(this);
  panel->setObjectName(QStringLiteral("leftPanel"));
  panel->setMinimumWidth(300);
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(14, 12, 14, 14);
  layout->setSpacing(8);
  layout->addWidget(MakeHeading(tr("Solvers"), panel));
  this->Runs = new QListWidget(panel);
  this->Runs->setMaximumHeight(130);
  this->Runs->setAccessibleName(tr("Runs of solvers"));
  layout->addWidget(this->Runs);
  layout->addLayout(this->MakeSolverLine(panel));
  this->Form = new OptionForm(this->Model, panel);
  this->Form->SetHiddenKeys({ "version" });
  this->Form->SetOtherFields([this] { return this->DescribeOptions(this->Runs->currentRow()); });
  auto* scroll = new QScrollArea(panel);
  scroll->setWidget(this->Form);
  scroll->setWidgetResizable(true);
  layout->addWidget(scroll, 1);
  auto* run = new RunBox(this->Controller, panel);
  connect(run, &RunBox::RunWanted, this, &SolverPage::RunWanted);
  connect(run, &RunBox::SomeWanted, this, &SolverPage::SomeWanted);
  layout->addWidget(run);
  connect(this->Runs, &QListWidget::currentRowChanged, this,
    [this](int row)
    { this->Form->SetPath(row < 0 ? std::string() : "solvers[" + std::to_string(row) + "]"); });
  return panel;
}

void SolverPage::MakeViews()
{
  this->Solutions = new PanelView(this->Tabs);
  this->Solutions->SetHint(tr("Add a solver and run the study: the solution, the ground truth and "
                              "the error of each mesh are shown here."));
  this->Solutions->SetLinked(true);
  connect(this->Selected, &Selection::MetricChanged, this,
    [this]
    {
      this->ShowSolutions();
      this->ShowCharts();
    });
  this->Solutions->setAccessibleName(tr("Solution, ground truth and error"));
  connect(this->Solutions, &PanelView::Picked, this,
    [this](int, const ChartPick& pick) { this->Selected->SetElement(pick.Element); });
  connect(this->Solutions, &PanelView::RowsSelected, this,
    [this](int, const std::vector<vtkIdType>& rows) { this->Selected->MarkElements(rows); });
  this->Charts = new PanelView(this->Tabs);
  this->Charts->setAccessibleName(tr("Charts of the performances"));
  connect(this->Charts, &PanelView::RowsSelected, this,
    [this](int, const std::vector<vtkIdType>& rows) { this->Selected->MarkCases(rows); });
  connect(this->Charts, &PanelView::Picked, this,
    [this](int, const ChartPick& pick)
    {
      if (pick.Row >= 0)
      {
        this->Selected->SetCase(static_cast<int>(pick.Row));
      }
    });
  this->Charts->SetHint(
    tr("Run the study with a solver: its performances over the meshes are shown "
       "here."));
}

QWidget* SolverPage::MakeRight()
{
  auto* panel = new QWidget(this);
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  this->Tabs = new QTabWidget(panel);
  this->Tabs->setDocumentMode(true);
  this->Shown = new QComboBox(this->Tabs);
  this->Shown->setAccessibleName(tr("Run that is shown"));
  auto* corner = new QWidget(this->Tabs);
  auto* line = new QHBoxLayout(corner);
  line->setContentsMargins(0, 2, 8, 2);
  this->Surfaces = new QToolButton(corner);
  this->Surfaces->setText(tr("Surfaces …"));
  this->Surfaces->setToolTip(tr("Solution and ground truth as surfaces, in a window of their own"));
  line->addWidget(this->Shown);
  line->addWidget(this->Surfaces);
  this->Tabs->setCornerWidget(corner);
  connect(this->Surfaces, &QToolButton::clicked, this, &SolverPage::ShowSurfaces);
  this->MakeViews();
  this->Failures = new FailureList(this->Results, this->Selected, this->Tabs);
  this->Tabs->addTab(this->Solutions, tr("Solution"));
  auto* scroll = new QScrollArea(this->Tabs);
  scroll->setWidget(this->Charts);
  scroll->setWidgetResizable(true);
  connect(this->Charts, &PanelView::Repainted, this,
    [this]
    {
      const int rows = (this->Charts->GetNumberOfPanels() + ChartColumns - 1) / ChartColumns;
      this->Charts->setMinimumHeight(rows * ChartHeight);
    });
  this->Tabs->addTab(scroll, tr("Performances"));
  this->Tabs->addTab(this->Failures, tr("Failures"));
  this->Cases = new TimeBar(panel);
  layout->addWidget(this->Tabs, 1);
  layout->addWidget(this->Cases);
  connect(this->Shown, &QComboBox::currentTextChanged, this,
    [this]
    {
      this->ShowSolutions();
      this->ShowCharts();
    });
  connect(this->Cases, &TimeBar::PlaceChanged, this,
    [this](double place) { this->Selected->SetCase(static_cast<int>(place)); });
  return panel;
}

void SolverPage::AddSolver(const QString& solver)
{
  if (!solver.isEmpty())
  {
    this->Model->AddItem(
      "solvers", { JsonValue::Object{ { "solver", { solver.toStdString() } } } }, tr("Add solver"));
    this->Runs->setCurrentRow(this->Runs->count() - 1);
  }
}

/** The options that the description of the solver offers, with the values in force. */
std::vector<FormField> SolverPage::DescribeOptions(int run) const
{
  const Study& study = this->Model->GetStudy();
  std::vector<FormField> fields;
  if (run < 0 || run >= static_cast<int>(study.Solvers.size()))
  {
    return fields;
  }
  const StudySolver& solver = study.Solvers[static_cast<std::size_t>(run)];
  try
  {
    const SolverDescription description = FindSolver(solver.Solver, study.Folder);
    for (const SolverOption& option : description.Options)
    {
      FormField field{ "solvers[" + std::to_string(run) + "]." + option.Name, option.Name,
        option.Type, option.Description, {}, {}, false };
      std::string value = option.Default;
      for (const auto& [name, given] : solver.Options)
      {
        value = name == option.Name ? FormatScalar(given) : value;
      }
      const bool isNumber = option.Type == "integer" || option.Type == "number";
      field.Form.Kind = option.Type == "integer" ? ValueForm::Integer
        : isNumber                               ? ValueForm::Number
        : option.Choices.empty()                 ? ValueForm::Text
                                                 : ValueForm::Choice;
      field.Form.Choices = option.Choices;
      field.Value = isNumber ? ParseJson(value, option.Name) : JsonValue{ value };
      fields.push_back(field);
    }
  }
  catch (const std::exception&) // the run will say which description is missing
  {
  }
  return fields;
}

void SolverPage::ShowRuns()
{
  const auto& solvers = this->Model->GetStudy().Solvers;
  const int row = this->Runs->currentRow();
  if (this->Runs->count() != static_cast<int>(solvers.size()))
  {
    this->Runs->clear();
    for (std::size_t i = 0; i < solvers.size(); ++i)
    {
      this->Runs->addItem(QString());
    }
    this->Runs->setCurrentRow(std::clamp(row, 0, static_cast<int>(solvers.size()) - 1));
  }
  for (std::size_t i = 0; i < solvers.size(); ++i)
  {
    this->Runs->item(static_cast<int>(i))->setText(QString::fromStdString(solvers[i].Name));
  }
}

void SolverPage::ShowResults()
{
  this->Shown->clear();
  if (const Study* study = this->Results->GetStudy())
  {
    for (const StudySolver& solver : study->Solvers)
    {
      this->Shown->addItem(QString::fromStdString(solver.Name));
    }
  }
  this->Shown->setVisible(this->Shown->count() > 1);
  this->Cases->SetCount(this->Results->GetNumberOfCases());
  this->ShowCase(this->Selected->GetCase());
  const int failures = this->Failures->GetCount();
  this->Tabs->setTabText(2, failures == 0 ? tr("Failures") : tr("Failures (%1)").arg(failures));
  this->ShowCharts();
  this->ShowSolutions();
}

void SolverPage::ShowCase(int index)
{
  this->Cases->SetPlace(index);
  this->Cases->SetText(this->Results->GetMeshName(index));
  this->Results->ShowCase(index);
}

void SolverPage::ShowSolutions()
{
  const MeshPicturePointer picture = this->Results->GetPicture();
  const std::string run = this->Shown->currentText().toStdString();
  this->Surfaces->setEnabled(picture && !run.empty());
  if (!picture || run.empty())
  {
    this->Solutions->SetMaker({});
    return;
  }
  if (this->Surface && this->Surface->isVisible())
  {
    this->Surface->SetMesh(picture, this->Shown->currentText());
  }
  this->Solutions->SetMaker([picture, run, metric = this->Selected->GetMetric().toStdString(),
                              labels = this->Results->GetLabels()]
    { return MakeSolutionPanels(picture, run, metric, *labels); });
}

/** The window is made when it is first asked for: only it needs OpenGL. */
void SolverPage::ShowSurfaces()
{
  if (!this->Surface)
  {
    this->Surface = new SurfaceWindow(this);
  }
  this->Surface->show();
  this->Surface->raise();
  this->ShowSolutions();
}

void SolverPage::ShowCharts()
{
  const std::string run = this->Shown->currentText().toStdString();
  vtkTable* table = this->Results->GetTable();
  if (!table || run.empty())
  {
    this->Charts->SetMaker({});
    return;
  }
  this->Charts->SetMaker(
    [run, kept = vtkSmartPointer<vtkTable>(table), study = *this->Results->GetStudy(),
      labels = this->Results->GetLabels(), metric = this->Selected->GetMetric().toStdString()]
    {
      PanelList panels = MakePerformancePanels(study, run, kept, *labels);
      panels.push_back(MakeMetricChart(metric, { kept, labels, {}, AbscissaOf(study), {} }, false));
      return panels;
    },
    ChartColumns);
}

} // namespace pemesh
