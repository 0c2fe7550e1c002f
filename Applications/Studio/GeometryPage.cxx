// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "GeometryPage.h"

#include "ColumnLabels.h"
#include "ElementTableModel.h"
#include "GeometryPanels.h"
#include "Icons.h"
#include "LatestJob.h"
#include "MeshCanvas.h"
#include "MetricCharts.h"
#include "MetricRegistry.h"
#include "PanelView.h"
#include "ResultPanels.h"
#include "ResultSet.h"
#include "Selection.h"
#include "Study.h"
#include "StudyPreview.h"
#include "TimeBar.h"
#include "vtkPEMChart.h"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStackedWidget>
#include <QTableView>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

#include <vtkTable.h>

namespace pemesh
{

namespace
{

constexpr int LeastColumn = 92; // pixels

QString TipOf(const Metric& metric)
{
  return QStringLiteral("<p><b>%1</b> = %2</p><p>%3</p><p>%4</p>")
    .arg(QString::fromUtf8(metric.Label), QString::fromUtf8(metric.Formula).toHtmlEscaped(),
      QString::fromUtf8(metric.Description).toHtmlEscaped(),
      QString::fromUtf8(metric.Reference).toHtmlEscaped());
}

} // namespace

GeometryPage::GeometryPage(
  StudyPreview* preview, ResultSet* results, Selection* selection, QWidget* parent)
  : QWidget(parent)
  , Preview(preview)
  , Results(results)
  , Selected(selection)
{
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* bar = new QToolBar(this);
  bar->setIconSize({ 18, 18 });
  layout->addWidget(bar);
  auto* splitter = new QSplitter(this);
  splitter->setHandleWidth(1);
  splitter->addWidget(this->MakeViews());
  splitter->addWidget(this->MakeSide());
  splitter->setStretchFactor(0, 1);
  splitter->setSizes({ 800, 360 });
  layout->addWidget(splitter, 1);
  this->Cases = new TimeBar(this);
  layout->addWidget(this->Cases);
  this->MakeBar(bar);
  this->ExportJob = new LatestJob(this, 60000);
  connect(this->Cases, &TimeBar::PlaceChanged, this,
    [this](double place) { this->Selected->SetCase(static_cast<int>(place)); });
  connect(preview, &StudyPreview::PictureChanged, this, &GeometryPage::ShowPicture);
  connect(results, &ResultSet::Changed, this, &GeometryPage::ShowResults);
  connect(results, &ResultSet::PictureChanged, this, &GeometryPage::ShowPicture);
  connect(selection, &Selection::CaseChanged, this, &GeometryPage::ShowCase);
  connect(selection, &Selection::ElementChanged, this, &GeometryPage::ShowElement);
  connect(selection, &Selection::ElementsMarked, this, &GeometryPage::ShowMarks);
  connect(selection, &Selection::MetricChanged, this->Metric, &QComboBox::setCurrentText);
  this->ShowView(0);
  this->ShowResults();
}

void GeometryPage::MakeBar(QToolBar* bar)
{
  auto* group = new QActionGroup(this);
  const std::pair<const char*, QString> views[] = { { "mesh", tr("Mesh") },
    { "grid", tr("All metrics over the data set") },
    { "correlation", tr("Metric against metric") } };
  for (int i = 0; i < 3; ++i)
  {
    QAction* action = bar->addAction(MakeIcon(views[i].first), views[i].second);
    action->setCheckable(true);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, i] { this->ShowView(i); });
    this->ViewActions << action;
  }
  bar->addSeparator();
  this->MakeMetricBoxes(bar);
  this->MakeToggles(bar);
  auto* space = new QWidget(bar);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  QAction* save = bar->addAction(MakeIcon("export"), tr("Export this view"));
  connect(save, &QAction::triggered, this, &GeometryPage::Export);
  this->Source = new QLabel(bar);
  this->Source->setObjectName(QStringLiteral("muted"));
  bar->addWidget(this->Source);
}

void GeometryPage::MakeMetricBoxes(QToolBar* bar)
{
  this->Metric = new QComboBox(bar);
  this->Against = new QComboBox(bar);
  for (const pemesh::Metric& metric : Metrics())
  {
    for (QComboBox* box : { this->Metric, this->Against })
    {
      box->addItem(QString::fromUtf8(metric.Name));
      box->setItemData(box->count() - 1, TipOf(metric), Qt::ToolTipRole);
    }
  }
  this->Metric->setMaxVisibleItems(40);
  this->Metric->setAccessibleName(tr("Metric"));
  this->Metric->setCurrentText(this->Selected->GetMetric());
  this->Against->setAccessibleName(tr("Against"));
  this->Against->setCurrentText(QStringLiteral("Area"));
  bar->addWidget(new QLabel(tr("Metric "), bar));
  bar->addWidget(this->Metric);
  QAction* label = bar->addWidget(new QLabel(tr(" against "), bar));
  QAction* box = bar->addWidget(this->Against);
  connect(this->Views, &QStackedWidget::currentChanged, this,
    [this, label, box](int view)
    {
      label->setVisible(view == 2);
      box->setVisible(view == 2);
      for (QAction* action : { this->Marked, this->FixedScale, this->LogScale })
      {
        action->setVisible(view == 0);
      }
    });
  label->setVisible(false);
  box->setVisible(false);
  connect(this->Metric, &QComboBox::currentTextChanged, this,
    [this](const QString& metric)
    {
      this->Selected->SetMetric(metric);
      this->ShowMetric();
    });
  connect(this->Against, &QComboBox::currentTextChanged, this, &GeometryPage::ShowScatter);
}

void GeometryPage::MakeToggles(QToolBar* bar)
{
  const auto addToggle = [this, bar](const char* icon, const QString& text, bool on)
  {
    QAction* action = bar->addAction(MakeIcon(icon), text);
    action->setCheckable(true);
    action->setChecked(on);
    connect(action, &QAction::toggled, this, &GeometryPage::ShowMetric);
    return action;
  };
  this->Marked = addToggle("extremes", tr("Mark the smallest and the largest value"), true);
  this->FixedScale = addToggle("palette", tr("One scale for all meshes of the data set"), true);
  this->LogScale = bar->addAction(tr("log"));
  this->LogScale->setCheckable(true);
  this->LogScale->setToolTip(tr("Logarithmic colours"));
  connect(this->LogScale, &QAction::toggled, this, &GeometryPage::ShowMetric);
}

QWidget* GeometryPage::MakeViews()
{
  this->Views = new QStackedWidget(this);
  this->Canvas = new MeshCanvas(this->Views);
  this->Canvas->SetHint(tr("There is no mesh: place polygons on the page Mesh, or open meshes."));
  connect(this->Canvas, &MeshCanvas::ElementClicked, this->Selected, &Selection::SetElement);
  connect(this->Canvas, &MeshCanvas::ElementsMarked, this->Selected, &Selection::MarkElements);
  this->Views->addWidget(this->Canvas);

  this->Charts = new MetricCharts(this->Results, this->Selected, this->Views);
  this->Views->addWidget(this->Charts);
  connect(this->Charts, &MetricCharts::RunWanted, this, &GeometryPage::RunWanted);
  connect(this->Charts, &MetricCharts::Told, this, &GeometryPage::Told);

  this->Scatter = new PanelView(this->Views);
  this->Scatter->SetHint(tr("There is no mesh with metrics to show."));
  this->Scatter->setAccessibleName(tr("Metric against metric"));
  this->Views->addWidget(this->Scatter);
  connect(this->Scatter, &PanelView::Picked, this,
    [this](int, const ChartPick& pick) { this->Selected->SetElement(pick.Row); });
  connect(this->Scatter, &PanelView::RowsSelected, this,
    [this](int, const std::vector<vtkIdType>& rows) { this->Selected->MarkElements(rows); });
  return this->Views;
}

QWidget* GeometryPage::MakeSide()
{
  auto* panel = new QFrame(this);
  panel->setObjectName(QStringLiteral("sidePanel"));
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* heading = new QLabel(tr("Elements"), panel);
  heading->setObjectName(QStringLiteral("heading"));
  heading->setContentsMargins(14, 12, 14, 2);
  layout->addWidget(heading);
  this->Elements = new ElementTableModel(this);
  this->Table = new QTableView(panel);
  this->Table->setModel(this->Elements);
  this->Table->setSortingEnabled(true);
  this->Table->sortByColumn(0, Qt::AscendingOrder);
  this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->Table->setSelectionMode(QAbstractItemView::SingleSelection);
  this->Table->verticalHeader()->hide();
  this->Table->verticalHeader()->setDefaultSectionSize(22);
  this->Table->setAlternatingRowColors(true);
  this->Table->setAccessibleName(tr("Elements"));
  this->Table->setTabKeyNavigation(false);
  layout->addWidget(this->Table, 1);
  connect(this->Table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
    [this](const QModelIndex& index)
    {
      if (index.isValid())
      {
        this->Selected->SetElement(this->Elements->GetElement(index.row()));
      }
    });
  connect(this->Table->horizontalHeader(), &QHeaderView::sectionClicked, this,
    [this](int column)
    {
      const QString metric = this->Elements->GetMetric(column);
      if (!metric.isEmpty())
      {
        this->Metric->setCurrentText(metric);
      }
    });
  connect(this->Elements, &QAbstractItemModel::modelReset, this, &GeometryPage::FitColumns);
  connect(this->Elements, &ElementTableModel::Sorted, this->Table, &QAbstractItemView::scrollToTop);
  return panel;
}

/** To their titles; the numbers below are short. */
void GeometryPage::FitColumns()
{
  QHeaderView* header = this->Table->horizontalHeader();
  QFont bold = header->font();
  bold.setBold(true);
  const QFontMetrics metrics(bold);
  for (int column = 0; column < this->Elements->columnCount(); ++column)
  {
    const QString title =
      this->Elements->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    header->resizeSection(column, std::max(LeastColumn, metrics.horizontalAdvance(title) + 34));
  }
}

QString GeometryPage::GetMetric() const
{
  return this->Metric->currentText();
}

MeshPicturePointer GeometryPage::GetPicture() const
{
  return this->Results->IsEmpty() ? this->Preview->GetPicture() : this->Results->GetPicture();
}

void GeometryPage::ShowView(int view)
{
  this->Views->setCurrentIndex(view);
  this->ViewActions[view]->setChecked(true);
}

void GeometryPage::showEvent(QShowEvent*)
{
  this->Preview->SetMeasured(this->Results->IsEmpty());
  this->ShowPicture();
}

void GeometryPage::hideEvent(QHideEvent*)
{
  this->Preview->SetMeasured(false);
}

void GeometryPage::ShowResults()
{
  const bool isEmpty = this->Results->IsEmpty();
  this->Preview->SetMeasured(isEmpty && this->isVisible());
  this->Cases->SetCount(this->Results->GetNumberOfCases());
  const QString folder = this->Results->GetFolder();
  this->Source->setText(
    isEmpty ? tr("Preview of the study") : tr("Results in %1").arg(QDir(folder).dirName()));
  this->Source->setToolTip(isEmpty ? QString() : folder);
  if (!isEmpty)
  {
    const int count = this->Results->GetNumberOfCases();
    const int wanted = this->Selected->GetCase();
    this->Selected->SetCase(wanted >= 0 && wanted < count ? wanted : count - 1);
    this->ShowCase(this->Selected->GetCase());
  }
  this->ShowPicture();
}

void GeometryPage::ShowCase(int index)
{
  this->Cases->SetPlace(index);
  this->Cases->SetText(this->Results->GetMeshName(index));
  this->Results->ShowCase(index);
}

void GeometryPage::ShowPicture()
{
  if (!this->isVisible())
  {
    return;
  }
  const MeshPicturePointer picture = this->GetPicture();
  this->Elements->SetPicture(picture);
  if (picture)
  {
    this->Canvas->SetHomeBox(picture->GetBounds());
  }
  this->Canvas->SetPicture(picture);
  this->ShowMetric();
  this->ShowElement(this->Selected->GetElement());
  this->ShowMarks();
  emit this->PictureShown(picture);
}

void GeometryPage::ShowMetric()
{
  double range[2] = { 0.0, 0.0 };
  if (this->FixedScale->isChecked())
  {
    this->Results->GetRange(this->GetMetric(), range);
  }
  const std::string title = this->Results->GetLabels()->Title(this->GetMetric().toStdString());
  this->Canvas->SetShowExtremes(this->Marked->isChecked());
  this->Canvas->SetColors(
    this->GetMetric(), QString::fromStdString(title), range, this->LogScale->isChecked());
  const int column = this->Elements->FindColumn(this->GetMetric());
  if (column >= 0)
  {
    this->Table->scrollTo(this->Elements->index(this->Table->currentIndex().row(), column));
  }
  this->ShowScatter();
}

void GeometryPage::ShowScatter()
{
  const MeshPicturePointer picture = this->GetPicture();
  const std::string y = this->GetMetric().toStdString();
  const std::string x = this->Against->currentText().toStdString();
  if (!picture || !picture->HasArray(x) || !picture->HasArray(y))
  {
    this->Scatter->SetMaker({});
    return;
  }
  this->Scatter->SetMaker(
    [picture, x, y, labels = this->Results->GetLabels()]
    {
      const vtkSmartPointer<vtkTable> table = picture->MakeTable();
      StudyPlot plot;
      plot.Kind = "scatter";
      plot.X = x;
      plot.Y = { y };
      return PanelList{ MakeResultChart(plot, table, *labels) };
    });
}

void GeometryPage::ShowElement(qint64 element)
{
  this->Canvas->SetSelected(element);
  const int row = this->Elements->FindRow(element);
  if (row >= 0 && this->Table->currentIndex().row() != row)
  {
    const int column = std::max(0, this->Elements->FindColumn(this->GetMetric()));
    this->Table->setCurrentIndex(this->Elements->index(row, column));
  }
}

void GeometryPage::ShowMarks()
{
  const std::vector<vtkIdType> marked = this->Selected->GetMarkedElements();
  this->Canvas->SetMarked(marked);
  this->Scatter->SetHighlightedRows(marked);
  this->Elements->SetMarked(marked);
}

void GeometryPage::Export()
{
  if (this->Views->currentIndex() > 0)
  {
    (this->Views->currentIndex() == 1 ? this->Charts->GetView() : this->Scatter)->ExportAs();
    return;
  }
  const QString file = QFileDialog::getSaveFileName(this, tr("Export the mesh"),
    this->GetMetric() + QStringLiteral(".pdf"),
    tr("PDF (*.pdf);;SVG (*.svg);;PNG (*.png);;Table of the elements (*.csv)"));
  if (!file.isEmpty())
  {
    this->ExportMesh(file);
  }
}

void GeometryPage::ExportMesh(const QString& file)
{
  const MeshPicturePointer picture = this->GetPicture();
  if (!picture)
  {
    return;
  }
  this->ExportJob->Start(
    [this, picture, file = file.toStdString(), metric = this->GetMetric().toStdString(),
      labels = this->Results->GetLabels()](const std::atomic<bool>&) -> LatestJob::Delivery
    {
      const QString fault = ExportPicture(*picture, file, metric, *labels);
      return [this, fault, file]
      { emit this->Told(fault.isEmpty() ? tr("Written: %1").arg(file.c_str()) : fault); };
    });
}

} // namespace pemesh
