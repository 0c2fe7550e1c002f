// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "GeometryPanels.h"

#include "ColumnLabels.h"
#include "CsvTable.h"
#include "ResultPanels.h"
#include "Study.h"
#include "vtkPEMChart.h"
#include "vtkPEMFigure.h"
#include "vtkPEMMeshView.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

namespace pemesh
{

std::string AbscissaOf(const Study& study)
{
  return study.Sweep.size() == 1 ? study.Sweep.front().Name : "Index";
}

vtkSmartPointer<vtkPEMPanel> MakeMetricChart(const std::string& metric, const std::string& x,
  vtkTable* table, const ColumnLabels& labels, bool isSmall)
{
  StudyPlot plot;
  plot.Kind = "line";
  plot.X = x;
  plot.Y = { metric };
  const vtkSmartPointer<vtkPEMChart> chart = MakeResultChart(plot, table, labels);
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
