// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// What is marked in one place stands out in all others.
#include "CorrelationPage.h"
#include "GeometryPage.h"
#include "MeshCanvas.h"
#include "MetricCharts.h"
#include "PanelView.h"
#include "ResultSet.h"
#include "Selection.h"
#include "SolverPage.h"
#include "StudioFixture.h"
#include "StudioSupport.h"

#include <gmock/gmock.h>

#include <QComboBox>
#include <QListWidget>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTest>

#include <algorithm>

#include <vtkDataArray.h>
#include <vtkTable.h>

using namespace pemesh;
using studio_test::Drag;
using studio_test::Keep;
using studio_test::WaitFor;
using testing::ElementsAre;

namespace
{

class StudioSelection : public studio_test::Studio
{
protected:
  bool WaitForPanels(const PanelView* view)
  {
    return WaitFor([view] { return !view->IsBusy() && !view->GetPainted().Image.isNull(); });
  }
};

} // namespace

TEST(Selection, MarksAreForgottenWithAMeshThatHasNone)
{
  Selection selection;
  QSignalSpy marked(&selection, &Selection::CasesMarked);
  selection.SetCase(7);
  selection.MarkCases({ 2, 4, 9 });
  EXPECT_EQ(selection.GetCase(), 2) << "the first comes into view";
  EXPECT_THAT(selection.GetMarkedCases(), ElementsAre(2, 4, 9));
  selection.SetCase(4);
  EXPECT_THAT(selection.GetMarkedCases(), ElementsAre(2, 4, 9)) << "one of them";
  selection.MarkElements({ 5, 6 });
  EXPECT_EQ(selection.GetElement(), 5);
  selection.SetCase(1);
  EXPECT_THAT(selection.GetMarkedCases(), ElementsAre(1));
  EXPECT_THAT(selection.GetMarkedElements(), ElementsAre()) << "of another mesh";
  EXPECT_GE(marked.count(), 4);
}

TEST_F(StudioSelection, ARectangleInAChartMarksMeshesEverywhere)
{
  this->MakeStudy("rectangle", 6);
  ASSERT_TRUE(this->Run()) << this->GetLogText();
  this->Window.ShowPage(StudioWindow::CorrelationPageIndex);
  auto* correlation = this->Find<CorrelationPage>();
  ASSERT_TRUE(this->WaitForPanels(correlation->GetChart()));
  const QRect all = correlation->GetChart()->rect();
  Drag(correlation->GetChart(), all.topLeft() + QPoint(60, 20), all.bottomRight() - QPoint(20, 60));
  const std::vector<vtkIdType> marked = this->Window.GetSelection()->GetMarkedCases();
  EXPECT_EQ(marked.size(), 6U) << "all of them are in the chart";
  EXPECT_EQ(correlation->GetChart()->GetHighlightedRows(), marked);
  EXPECT_EQ(this->Find<SolverPage>()->GetCharts()->GetHighlightedRows(), marked);
  EXPECT_EQ(this->Find<GeometryPage>()->GetCharts()->GetView()->GetHighlightedRows(), marked);
}

TEST_F(StudioSelection, ARectangleOnTheMeshMarksElementsEverywhere)
{
  this->MakeStudy("elements", 3);
  ASSERT_TRUE(this->Run()) << this->GetLogText();
  this->Window.ShowPage(StudioWindow::GeometryPageIndex);
  auto* geometry = this->Find<GeometryPage>();
  ASSERT_TRUE(WaitFor([=] { return geometry->GetCanvas()->GetPicture() != nullptr; }));
  QTest::qWait(50);
  MeshCanvas* canvas = geometry->GetCanvas();
  const PlaneTransform& transform = canvas->GetTransform();
  Drag(canvas, transform.ToScreen({ -0.02, 1.02 }).toPoint(),
    transform.ToScreen({ 0.5, -0.02 }).toPoint());
  const std::vector<vtkIdType> marked = this->Window.GetSelection()->GetMarkedElements();
  ASSERT_GT(marked.size(), 1U);
  ASSERT_LT(static_cast<vtkIdType>(marked.size()), canvas->GetPicture()->GetNumberOfElements());
  for (const vtkIdType element : marked)
  {
    double left = 1.0;
    for (const Point2& point : canvas->GetPicture()->GetElement(element))
    {
      left = std::min(left, point.x);
    }
    EXPECT_LT(left, 0.5) << element;
  }
  EXPECT_EQ(geometry->GetScatter()->GetHighlightedRows(), marked);
  EXPECT_EQ(this->Find<SolverPage>()->GetSolutions()->GetHighlightedRows(), marked);
  ASSERT_NE(canvas->GetColoring().Marked, nullptr);
  EXPECT_EQ(*canvas->GetColoring().Marked, marked);
  Keep(&this->Window, "marked");
  QTest::mouseClick(canvas, Qt::LeftButton, {}, QPoint(3, canvas->height() - 3));
  EXPECT_EQ(this->Window.GetSelection()->GetElement(), -1);
  EXPECT_EQ(canvas->GetColoring().Marked, nullptr) << "a click beside the mesh forgets them";
}

TEST_F(StudioSelection, LinePlotsAreSortedByAMetric)
{
  this->MakeStudy("sorted", 5);
  ASSERT_TRUE(this->Run()) << this->GetLogText();
  this->Window.ShowPage(StudioWindow::GeometryPageIndex);
  auto* geometry = this->Find<GeometryPage>();
  geometry->ShowView(1);
  MetricCharts* charts = geometry->GetCharts();
  this->Window.GetSelection()->SetMetric("MinAngle");
  this->Window.GetSelection()->SetCase(0);
  charts->GetOrder()->setCurrentIndex(1);
  auto* values = vtkDataArray::SafeDownCast(
    this->Window.GetResults()->GetTable()->GetColumnByName("MinAngle_min"));
  ASSERT_NE(values, nullptr);
  for (vtkIdType place = 1; place < 5; ++place)
  {
    EXPECT_LE(values->GetComponent(charts->RowAt(place - 1), 0),
      values->GetComponent(charts->RowAt(place), 0));
  }
  EXPECT_NE(charts->RowAt(0), 0) << "the angle shrinks with t, so the order is another one";
  ASSERT_EQ(charts->GetView()->GetHighlightedRows().size(), 1U);
  EXPECT_EQ(charts->RowAt(charts->GetView()->GetHighlightedRows()[0]), 0) << "the same mesh";
  ASSERT_TRUE(this->WaitForPanels(charts->GetView()));
  Keep(&this->Window, "sorted");
}

TEST_F(StudioSelection, FindingsAreThoseOfTheRunInItsWords)
{
  const std::filesystem::path folder = this->MakeStudy("words", 6);
  ASSERT_TRUE(this->Run()) << this->GetLogText();
  const QString text =
    QString::fromStdString(studio_test::ReadFile((folder / "words" / "findings.txt").string()));
  const QListWidget* findings = this->Find<CorrelationPage>()->GetFindings();
  int sentences = 0;
  for (int row = 0; row < findings->count(); ++row)
  {
    const QListWidgetItem* item = findings->item(row);
    if (!(item->flags() & Qt::ItemIsSelectable))
    {
      continue;
    }
    ++sentences;
    const int rank = item->text().section('.', 0, 0).toInt();
    if (rank <= 10) // the text has the ten best of each performance
    {
      EXPECT_TRUE(text.contains("  " + item->text() + "\n")) << item->text().toStdString();
    }
  }
  EXPECT_GT(sentences, 20);
}

TEST_F(StudioSelection, AFitIsDrawnThroughAScatter)
{
  this->MakeStudy("fit", 6);
  ASSERT_TRUE(this->Run()) << this->GetLogText();
  this->Window.ShowPage(StudioWindow::CorrelationPageIndex);
  auto* correlation = this->Find<CorrelationPage>();
  correlation->SetColumns("MinAngle_min", "pemesh-vem_condition-number");
  ASSERT_TRUE(this->WaitForPanels(correlation->GetChart()));
  std::vector<QImage> images{ correlation->GetChart()->GetPainted().Image };
  for (const char* form : { "linear", "power", "exponential" })
  {
    QSignalSpy painted(correlation->GetChart(), &PanelView::Repainted);
    ASSERT_GE(correlation->GetFit()->findText(form), 0) << form;
    correlation->GetFit()->setCurrentText(form);
    ASSERT_TRUE(WaitFor([&] { return painted.count() > 0 && !correlation->GetChart()->IsBusy(); }));
    for (const QImage& before : images)
    {
      EXPECT_NE(correlation->GetChart()->GetPainted().Image, before) << form;
    }
    images.push_back(correlation->GetChart()->GetPainted().Image);
  }
  Keep(&this->Window, "fit");
}
