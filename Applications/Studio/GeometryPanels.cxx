// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "GeometryPanels.h"

#include "ArrayValues.h"
#include "ColumnLabels.h"
#include "CsvTable.h"
#include "ResultPanels.h"
#include "Study.h"
#include "vtkPEMChart.h"
#include "vtkPEMFigure.h"
#include "vtkPEMMeshView.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

namespace pemesh
{

namespace
{
constexpr const char* PlaceColumn = "Place"; // of a mesh in an order
}

std::string AbscissaOf(const Study& study)
{
  return study.Sweep.size() == 1 ? study.Sweep.front().Name : "Index";
}

std::vector<vtkIdType> RowsInOrder(vtkTable* table, const std::string& column)
{
  std::vector<vtkIdType> rows(static_cast<std::size_t>(table->GetNumberOfRows()));
  std::iota(rows.begin(), rows.end(), vtkIdType{ 0 });
  if (auto* values = vtkDataArray::SafeDownCast(table->GetColumnByName(column.c_str())))
  {
    const auto key = [values](vtkIdType row)
    {
      const double value = ValueOf(values, row);
      return std::isnan(value) ? INFINITY : value;
    };
    std::stable_sort(
      rows.begin(), rows.end(), [&key](vtkIdType a, vtkIdType b) { return key(a) < key(b); });
  }
  return rows;
}

MetricChartTable MetricChartTable::Arrange() const
{
  if (this->Rows.empty())
  {
    return *this;
  }
  vtkNew<vtkIdList> rows;
  vtkNew<vtkIntArray> places;
  places->SetName(PlaceColumn);
  for (const vtkIdType row : this->Rows)
  {
    rows->InsertNextId(row);
    places->InsertNextValue(static_cast<int>(rows->GetNumberOfIds()));
  }
  vtkNew<vtkTable> arranged;
  for (vtkIdType i = 0; i < this->Table->GetNumberOfColumns(); ++i)
  {
    vtkAbstractArray* column = this->Table->GetColumn(i);
    const auto copy = vtkSmartPointer<vtkAbstractArray>::Take(column->NewInstance());
    copy->SetName(column->GetName());
    copy->SetNumberOfTuples(rows->GetNumberOfIds());
    column->GetTuples(rows, copy);
    arranged->AddColumn(copy);
  }
  arranged->AddColumn(places);
  return { arranged, this->Labels, {}, PlaceColumn, this->XTitle };
}

vtkSmartPointer<vtkPEMPanel> MakeMetricChart(
  const std::string& metric, const MetricChartTable& data, bool isSmall)
{
  StudyPlot plot;
  plot.Kind = "line";
  plot.X = data.X;
  plot.Y = { metric };
  const vtkSmartPointer<vtkPEMChart> chart = MakeResultChart(plot, data.Table, *data.Labels);
  chart->SetXTitle(data.XTitle.empty() ? data.Labels->Title(data.X) : data.XTitle);
  if (isSmall)
  {
    chart->SetTitle(metric);
    chart->SetYTitle(" ");
  }
  return chart;
}

QString ExportPicture(const MeshPicture& picture, const std::string& file,
  const std::string& metric, const ColumnLabels& labels)
{
  try
  {
    if (file.ends_with(".csv"))
    {
      WriteCsvFile(file, picture.MakeTable());
      return {};
    }
  }
  catch (const std::exception& error)
  {
    return QString::fromUtf8(error.what());
  }
  const vtkSmartPointer<vtkPEMMeshView> view = MakeMeshView(picture.GetMesh(), metric, labels);
  view->SetHighlight(vtkPEMMeshView::HIGHLIGHT_BOTH);
  vtkNew<vtkPEMFigure> figure;
  vtkNew<vtkCallbackCommand> quiet; // the sentence is in GetErrorMessage
  figure->AddObserver(vtkCommand::ErrorEvent, quiet);
  figure->AddPanel(view);
  return figure->Write(file) ? QString() : QString::fromStdString(figure->GetErrorMessage());
}

} // namespace pemesh
