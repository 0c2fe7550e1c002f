// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PanelExport.h"

#include "CsvTable.h"
#include "ElementTable.h"
#include "TableRows.h"
#include "vtkPEMChart.h"
#include "vtkPEMFigure.h"
#include "vtkPEMMeshView.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

namespace pemesh
{

namespace
{

/** Where the vertices are, and what they are coloured by. */
vtkSmartPointer<vtkTable> MakeVertexTable(vtkPolyData* mesh, vtkDataArray* values)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  const char* names[] = { "X", "Y" };
  for (int axis = 0; axis < 2; ++axis)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(names[axis]);
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      column->InsertNextValue(mesh->GetPoint(i)[axis]);
    }
    table->AddColumn(column);
  }
  table->AddColumn(values);
  return table;
}

vtkSmartPointer<vtkTable> TableOf(vtkPEMPanel* panel)
{
  if (auto* chart = vtkPEMChart::SafeDownCast(panel))
  {
    return chart->MakeDataTable();
  }
  auto* view = vtkPEMMeshView::SafeDownCast(panel);
  vtkPolyData* mesh = view ? view->GetMesh() : nullptr;
  if (!mesh)
  {
    return vtkSmartPointer<vtkTable>::New();
  }
  const std::string array = view->GetColorArray();
  vtkDataArray* values = mesh->GetPointData()->GetArray(array.c_str());
  return values && !mesh->GetCellData()->HasArray(array.c_str())
    ? MakeVertexTable(mesh, values)
    : MakeElementTable({ { panel->GetTitle(), mesh } });
}

/** Of several panels a column says which. */
vtkSmartPointer<vtkTable> TableOfAll(const PanelList& panels)
{
  if (panels.size() == 1)
  {
    return TableOf(panels.front());
  }
  auto all = vtkSmartPointer<vtkTable>::New();
  for (std::size_t i = 0; i < panels.size(); ++i)
  {
    const vtkSmartPointer<vtkTable> own = TableOf(panels[i]);
    const std::string title = panels[i]->GetTitle();
    vtkNew<vtkStringArray> names;
    names->SetName("Chart");
    for (vtkIdType row = 0; row < own->GetNumberOfRows(); ++row)
    {
      names->InsertNextValue(title.empty() ? std::to_string(i + 1) : title);
    }
    vtkNew<vtkTable> named;
    named->AddColumn(names);
    for (vtkIdType column = 0; column < own->GetNumberOfColumns(); ++column)
    {
      named->AddColumn(own->GetColumn(column));
    }
    AppendTableRows(all, named);
  }
  return all;
}

QString WriteFigure(
  const PanelList& panels, int columns, const ChartStyle& style, const QString& file)
{
  vtkNew<vtkPEMFigure> figure;
  vtkNew<vtkCallbackCommand> quiet; // the sentence is in GetErrorMessage
  figure->AddObserver(vtkCommand::ErrorEvent, quiet);
  for (const auto& panel : panels)
  {
    panel->SetStyle(style);
    figure->AddPanel(panel);
  }
  figure->SetColumns(columns);
  return figure->Write(file.toStdString()) ? QString()
                                           : QString::fromStdString(figure->GetErrorMessage());
}

} // namespace

QString WritePanels(
  const PanelList& panels, int columns, const ChartStyle& style, const QString& file)
{
  if (!file.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive))
  {
    return WriteFigure(panels, columns, style, file);
  }
  try
  {
    WriteCsvFile(file.toStdString(), TableOfAll(panels));
    return {};
  }
  catch (const std::exception& error)
  {
    return QString::fromUtf8(error.what());
  }
}

} // namespace pemesh
