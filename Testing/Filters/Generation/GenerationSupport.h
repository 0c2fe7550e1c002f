// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A mesher with what it needs, for the tests of generation.
 */
#ifndef pemesh_GenerationSupport_h
#define pemesh_GenerationSupport_h

#include "MeshInvariants.h"
#include "vtkPEMDomainMesher.h"
#include "vtkPEMPolygonLayout.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

/** A layout and a mesher behind it. */
struct Generation
{
  vtkNew<vtkPEMPolygonLayout> Layout;
  vtkNew<vtkPEMDomainMesher> Mesher;

  Generation() { this->Mesher->SetInputConnection(this->Layout->GetOutputPort()); }

  vtkPolyData* MeshAt(double t)
  {
    this->Mesher->UpdateTimeStep(t);
    return this->Mesher->GetOutput();
  }
};

/** The input of a mesher: plain polygons, or the loops of a domain. */
inline vtkSmartPointer<vtkPolyData> MakeLayout(const std::vector<PolygonVertices>& polygons)
{
  auto layout = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const PolygonVertices& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<int>(polygon.size()));
    for (const pemesh::Point2& point : polygon)
    {
      cells->InsertCellPoint(points->InsertNextPoint(point.x, point.y, 0.0));
    }
  }
  layout->SetPoints(points);
  layout->SetPolys(cells);
  return layout;
}

inline double LargestFiller(vtkPolyData* mesh)
{
  double largest = 0.0;
  for (int cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    if (mesh->GetCellData()->GetArray("PolygonId")->GetTuple1(cell) < 0)
    {
      largest = std::max(largest, SignedArea(VerticesOf(mesh, cell)));
    }
  }
  return largest;
}

/** Edges with an element on one side only. */
inline int NumberOfBorderEdges(vtkPolyData* mesh)
{
  std::set<std::pair<vtkIdType, vtkIdType>> edges;
  vtkNew<vtkIdList> ids;
  for (int cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      edges.insert({ ids->GetId(i), ids->GetId((i + 1) % ids->GetNumberOfIds()) });
    }
  }
  return static_cast<int>(std::count_if(edges.begin(), edges.end(),
    [&edges](const auto& edge) {
      return !edges.count({ edge.second, edge.first });
    }));
}

#endif
