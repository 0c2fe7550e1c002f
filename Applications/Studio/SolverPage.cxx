// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverPage.h"

#include "Icons.h"
#include "OptionForm.h"
#include "PanelView.h"
#include "ResultSet.h"
#include "RunController.h"
#include "Selection.h"
#include "SolutionPanels.h"
#include "SolverDescriptionFile.h"
#include "StudyModel.h"
#include "SurfaceWindow.h"
#include "TimeBar.h"

#include <QComboBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QTabWidget>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

#include <vtkTable.h>
#include <vtkVariant.h>

namespace pemesh
{

namespace
{

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
  connect(controller, &RunController::Started, this, &SolverPage::ShowRunning);
  connect(controller, &RunController::Finished, this, &SolverPage::ShowRunning);
  connect(controller, &RunController::Progressed, this,
    [this](double fraction)
    {
      this->Progress->setValue(static_cast<int>(std::lround(fraction * 1000.0)));
      this->State->setText(tr("Running, %1 s").arg(this->Controller->GetSeconds(), 0, 'f', 1));
    });
  this->ShowRuns();
  this->ShowResults();
  this->ShowRunning();
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
  auto* add = new QPushButton(MakeIcon("add"), tr("Add"), panel);
  connect(
    add, &QPushButton::clicked, this, [this] { this->AddSolver(this->Known->currentText()); });
  auto* file = new QToolButton(panel);
  file->setIcon(MakeIcon("open"));
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
  layout->addLayout(line);
  this->Form = new OptionForm(this->Model, panel);
  this->Form->SetHiddenKeys({ "version" });
  this->Form->SetOtherFields([this] { return this->DescribeOptions(this->Runs->currentRow()); });
  auto* scroll = new QScrollArea(panel);
  scroll->setWidget(this->Form);
  scroll->setWidgetResizable(true);
  layout->addWidget(scroll, 1);
  layout->addWidget(this->MakeRunBox());
  connect(this->Runs, &QListWidget::currentRowChanged, this,
    [this](int row)
    { this->Form->SetPath(row < 0 ? std::string() : "solvers[" + std::to_string(row) + "]"); });
  return panel;
}

QWidget* SolverPage::MakeRunBox()
{
  auto* box = new QWidget(this);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  this->RunButton = new QPushButton(tr("Run all meshes"), box);
  this->RunButton->setObjectName(QStringLiteral("primary"));
  this->StopButton = new QPushButton(tr("Stop and keep"), box);
  this->StopButton->setToolTip(tr("End the run and keep the meshes that are done"));
  this->CancelButton = new QPushButton(tr("Cancel"), box);
  this->CancelButton->setToolTip(tr("End the run and keep the results of the run before"));
  this->Progress = new QProgressBar(box);
  this->Progress->setRange(0, 1000);
  this->Progress->setTextVisible(false);
  this->State = new QLabel(box);
  this->State->setObjectName(QStringLiteral("muted"));
  layout->addWidget(this->State);
  layout->addWidget(this->Progress);
  layout->addWidget(this->RunButton);
  auto* line = new QHBoxLayout;
  line->addWidget(this->StopButton);
  line->addWidget(this->CancelButton);
  layout->addLayout(line);
  connect(this->RunButton, &QPushButton::clicked, this, &SolverPage::RunWanted);
  connect(this->StopButton, &QPushButton::clicked, this->Controller, &RunController::Stop);
  connect(this->CancelButton, &QPushButton::clicked, this->Controller, &RunController::Cancel);
  return box;
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
  this->Solutions = new PanelView(this->Tabs);
  this->Solutions->SetHint(tr("Add a solver and run the study: the solution, the ground truth and "
                              "the error of each mesh are shown here."));
  this->Solutions->SetLinked(true);
  connect(this->Selected, &Selection::MetricChanged, this, &SolverPage::ShowSolutions);
  this->Charts = new PanelView(this->Tabs);
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
  auto* failures = new QWidget(this->Tabs);
  auto* column = new QVBoxLayout(failures);
  column->setContentsMargins(0, 0, 0, 0);
  this->Failures = new QTableWidget(0, 4, failures);
  this->Failures->setHorizontalHeaderLabels(
    { tr("Mesh"), tr("Stage"), tr("Status"), tr("What happened") });
  this->Failures->horizontalHeader()->setStretchLastSection(true);
  this->Failures->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->Failures->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->Failures->verticalHeader()->hide();
  this->Failures->setAccessibleName(tr("Failures"));
  this->FailureLog = new QLabel(failures);
  this->FailureLog->setWordWrap(true);
  this->FailureLog->setTextInteractionFlags(Qt::TextSelectableByMouse);
  this->FailureLog->setMargin(12);
  column->addWidget(this->Failures, 1);
  column->addWidget(this->FailureLog);
  this->Tabs->addTab(this->Solutions, tr("Solution"));
  this->Tabs->addTab(this->Charts, tr("Performances"));
  this->Tabs->addTab(failures, tr("Failures"));
  this->Cases = new TimeBar(panel);
  layout->addWidget(this->Tabs, 1);
  layout->addWidget(this->Cases);
  connect(this->Shown, &QComboBox::currentTextChanged, this,
    [this]
    {
      this->ShowSolutions();
      this->ShowCharts();
    });
  connect(this->Failures, &QTableWidget::currentCellChanged, this, &SolverPage::ShowFailureLog);
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
                                                 : ValueForm::Text;
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

void SolverPage::ShowRunning()
{
  const bool running = this->Controller->IsRunning();
  this->RunButton->setEnabled(!running);
  this->StopButton->setEnabled(running);
  this->CancelButton->setEnabled(running);
  this->Progress->setVisible(running);
  this->Progress->setValue(0);
  this->State->setText(running ? tr("Running") : QString());
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
  this->ShowFailures();
  this->ShowCharts();
  this->ShowSolutions();
}

void SolverPage::ShowCase(int index)
{
  this->Cases->SetPlace(index);
  this->Cases->SetText(this->Results->GetMeshName(index));
  this->Results->ShowCase(index);
  this->Charts->SetHighlightedRows(
    index < 0 ? std::vector<vtkIdType>() : std::vector<vtkIdType>{ index });
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
  this->Charts->SetMaker([run, kept = vtkSmartPointer<vtkTable>(table),
                           study = *this->Results->GetStudy(), labels = this->Results->GetLabels()]
    { return MakePerformancePanels(study, run, kept, *labels); });
}

void SolverPage::ShowFailures()
{
  vtkTable* failures = this->Results->GetFailures();
  const int count = failures ? static_cast<int>(failures->GetNumberOfRows()) : 0;
  this->Failures->setRowCount(count);
  const char* columns[] = { "Mesh", "Stage", "Status", "Message" };
  for (int row = 0; row < count; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      this->Failures->setItem(row, column,
        new QTableWidgetItem(
          QString::fromStdString(failures->GetValueByName(row, columns[column]).ToString())));
    }
  }
  this->FailureLog->setText(count == 0 ? tr("No failures.") : tr("Select a failure to read it."));
  this->Tabs->setTabText(2, count == 0 ? tr("Failures") : tr("Failures (%1)").arg(count));
}

void SolverPage::ShowFailureLog(int row)
{
  QTableWidgetItem* mesh = this->Failures->item(row, 0);
  QTableWidgetItem* stage = this->Failures->item(row, 1);
  QTableWidgetItem* message = this->Failures->item(row, 3);
  if (mesh && stage && message)
  {
    this->FailureLog->setText(
      tr("%1\n\nFiles of the solver: %2/solvers/%3/%4")
        .arg(message->text(), this->Results->GetFolder(), stage->text(), mesh->text()));
  }
}

} // namespace pemesh
