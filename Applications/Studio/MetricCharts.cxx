// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MetricCharts.h"

#include "ColumnLabels.h"
#include "EmptyState.h"
#include "PanelView.h"
#include "ResultSet.h"
#include "Selection.h"
#include "vtkPEMPanel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStackedWidget>

#include <algorithm>

#include <vtkTable.h>

namespace pemesh
{

namespace
{

constexpr int Columns = 4;
constexpr int ChartHeight = 190;
constexpr double ChartFont = 10.0;
constexpr double DetachedFont = 18.0;
constexpr const char* Statistics[] = { "", "_min", "_mean", "_max" };

} // namespace

MetricCharts::MetricCharts(ResultSet* results, Selection* selection, QWidget* parent)
  : QWidget(parent)
  , Results(results)
  , Selected(selection)
  , Stack(new QStackedWidget(this))
  , Order(new QComboBox(this))
  , View(new PanelView(this))
{
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Stack);
  auto* empty = new EmptyState("grid", tr("All metrics over the data set"),
    tr("Run the study to measure every mesh of it. The charts then show the smallest, mean and "
       "largest value of each metric."),
    tr("Run the study"), this->Stack);
  connect(empty, &EmptyState::Clicked, this, &MetricCharts::RunWanted);
  this->Stack->addWidget(empty);
  auto* content = new QWidget(this->Stack);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* bar = new QFrame(content);
  bar->setObjectName(QStringLiteral("barAbove"));
  auto* line = new QHBoxLayout(bar);
  line->setContentsMargins(12, 4, 12, 4);
  auto* label = new QLabel(tr("Meshes in the order of"), bar);
  label->setBuddy(this->Order);
  this->Order->setAccessibleName(tr("Order of the meshes"));
  line->addWidget(label);
  line->addWidget(this->Order);
  line->addStretch(1);
  column->addWidget(bar);
  auto* scroll = new QScrollArea(content);
  scroll->setWidget(this->View);
  scroll->setWidgetResizable(true);
  column->addWidget(scroll, 1);
  this->Stack->addWidget(content);
  this->View->SetFontSize(ChartFont);
  this->View->setAccessibleName(tr("Charts of all metrics"));
  this->ShowOrders();
  this->Connect();
  this->Show();
}

void MetricCharts::Connect()
{
  connect(this->Order, &QComboBox::currentIndexChanged, this, &MetricCharts::Show);
  connect(this->View, &PanelView::DoubleClicked, this, &MetricCharts::Detach);
  connect(this->View, &PanelView::RowsSelected, this,
    [this](int, const std::vector<vtkIdType>& places)
    {
      std::vector<vtkIdType> rows;
      std::transform(places.begin(), places.end(), std::back_inserter(rows),
        [this](vtkIdType place) { return this->RowAt(place); });
      std::sort(rows.begin(), rows.end());
      this->Selected->MarkCases(rows);
    });
  connect(this->View, &PanelView::Picked, this,
    [this](int panel, const ChartPick& pick)
    {
      if (pick.Row >= 0)
      {
        this->Selected->SetCase(static_cast<int>(this->RowAt(pick.Row)));
        emit this->Told(QString::fromStdString(pick.Text));
      }
      this->Selected->SetMetric(this->Results->GetMetrics().value(panel));
    });
  connect(this->Results, &ResultSet::Changed, this, &MetricCharts::Show);
  connect(this->Selected, &Selection::CasesMarked, this, &MetricCharts::ShowMarks);
  connect(this->Selected, &Selection::MetricChanged, this,
    [this]
    {
      this->ShowOrders();
      if (this->Order->currentIndex() > 0)
      {
        this->Show();
      }
    });
}

void MetricCharts::ShowOrders()
{
  const QSignalBlocker blocker(this->Order);
  const QString metric = this->Selected->GetMetric();
  const int chosen = std::max(0, this->Order->currentIndex());
  this->Order->clear();
  this->Order->addItems({ tr("the study"), tr("the smallest %1").arg(metric),
    tr("the mean %1").arg(metric), tr("the largest %1").arg(metric) });
  this->Order->setCurrentIndex(chosen);
}

vtkIdType MetricCharts::RowAt(vtkIdType place) const
{
  return this->Rows.empty() ? place : this->Rows[static_cast<std::size_t>(place)];
}

std::vector<vtkIdType> MetricCharts::PlacesOf(const std::vector<vtkIdType>& rows) const
{
  if (this->Rows.empty())
  {
    return rows;
  }
  std::vector<vtkIdType> places;
  for (std::size_t place = 0; place < this->Rows.size(); ++place)
  {
    if (std::binary_search(rows.begin(), rows.end(), this->Rows[place]))
    {
      places.push_back(static_cast<vtkIdType>(place));
    }
  }
  return places;
}

MetricChartTable MetricCharts::GetTable() const
{
  const std::string abscissa = AbscissaOf(*this->Results->GetStudy());
  return { this->Results->GetTable(), this->Results->GetLabels(), this->Rows, abscissa,
    this->Rows.empty() ? std::string()
                       : tr("meshes by %1").arg(this->Order->currentText()).toStdString() };
}

void MetricCharts::Show()
{
  const bool isEmpty = this->Results->IsEmpty();
  this->Stack->setCurrentIndex(isEmpty ? 0 : 1);
  this->Rows.clear();
  if (isEmpty)
  {
    this->View->SetMaker({});
    return;
  }
  if (const int order = this->Order->currentIndex(); order > 0)
  {
    this->Rows = RowsInOrder(
      this->Results->GetTable(), this->Selected->GetMetric().toStdString() + Statistics[order]);
  }
  const QStringList metrics = this->Results->GetMetrics();
  const int rows = (static_cast<int>(metrics.size()) + Columns - 1) / Columns;
  this->View->setMinimumHeight(rows * ChartHeight);
  this->View->SetMaker(
    [metrics, table = this->GetTable()]
    {
      PanelList panels;
      const MetricChartTable arranged = table.Arrange();
      for (const QString& metric : metrics)
      {
        panels.push_back(MakeMetricChart(metric.toStdString(), arranged, true));
      }
      return panels;
    },
    Columns);
  this->ShowMarks();
}

void MetricCharts::ShowMarks()
{
  this->View->SetHighlightedRows(this->PlacesOf(this->Selected->GetMarkedCases()));
}

/** One chart in a window of its own. */
void MetricCharts::Detach(int panel)
{
  const QString metric = this->Results->GetMetrics().value(panel);
  if (metric.isEmpty())
  {
    return;
  }
  auto* view = new PanelView(this);
  view->setWindowFlag(Qt::Window);
  view->setAttribute(Qt::WA_DeleteOnClose);
  view->setObjectName(QStringLiteral("detached"));
  view->setWindowTitle(metric);
  view->SetFontSize(DetachedFont);
  view->SetMaker([metric = metric.toStdString(), table = this->GetTable()]
    { return PanelList{ MakeMetricChart(metric, table.Arrange(), false) }; });
  connect(view, &PanelView::DoubleClicked, view, &QWidget::close);
  connect(view, &PanelView::EscapePressed, view, &QWidget::close);
  view->showFullScreen();
}

} // namespace pemesh
