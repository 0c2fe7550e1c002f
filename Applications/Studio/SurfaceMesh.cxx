// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SurfaceMesh.h"

#include "ArrayValues.h"
#include "ElementAccess.h"
#include "TriangulatePolygon.h"

#include <algorithm>
#include <cmath>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

constexpr vtkIdType ElementsOfBlock = 8192;

/** Some elements; points on the border of two blocks are in both. */
class BlockMaker
{
public:
  BlockMaker(vtkPolyData* mesh, vtkDataArray* values)
    : Elements(mesh)
    , Values(values)
    , PointsOfBlock(static_cast<std::size_t>(mesh->GetNumberOfPoints()), -1)
  {
  }

  vtkSmartPointer<vtkPolyData> Make(vtkIdType first, vtkIdType last)
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(VTK_DOUBLE);
    vtkNew<vtkCellArray> triangles;
    vtkNew<vtkDoubleArray> heights;
    heights->SetName("Height");
    std::vector<vtkIdType> used;
    for (vtkIdType element = first; element < last; ++element)
    {
      this->Elements.GetVertices(element, this->Vertices);
      this->Elements.GetVertexIds(element, this->Ids);
      for (std::size_t i = 0; i < this->Ids.size(); ++i)
      {
        vtkIdType& point = this->PointsOfBlock[static_cast<std::size_t>(this->Ids[i])];
        if (point < 0)
        {
          const double value = ValueOf(this->Values, this->Ids[i]);
          point = points->InsertNextPoint(
            this->Vertices[i].x, this->Vertices[i].y, std::isfinite(value) ? value : 0.0);
          heights->InsertNextValue(value);
          used.push_back(this->Ids[i]);
        }
        this->Ids[i] = point;
      }
      this->AddTriangles(triangles);
    }
    for (const vtkIdType id : used)
    {
      this->PointsOfBlock[static_cast<std::size_t>(id)] = -1;
    }
    auto block = vtkSmartPointer<vtkPolyData>::New();
    block->SetPoints(points);
    block->SetPolys(triangles);
    block->GetPointData()->SetScalars(heights);
    return block;
  }

private:
  void AddTriangles(vtkCellArray* triangles)
  {
    for (const PolygonTriangle& triangle : this->Triangulator.Triangulate(this->Vertices))
    {
      const vtkIdType corners[3] = { this->Ids[triangle[0]], this->Ids[triangle[1]],
        this->Ids[triangle[2]] };
      triangles->InsertNextCell(3, corners);
    }
  }

  ElementAccess Elements;
  vtkDataArray* Values;
  PolygonTriangulator Triangulator;
  std::vector<vtkIdType> PointsOfBlock; // by the points of the mesh; -1: not in it
  std::vector<Point2> Vertices;         // of an element
  std::vector<vtkIdType> Ids;
};

} // namespace

SurfaceMesh MakeSurface(
  const MeshPicture& picture, const std::string& array, const std::atomic<bool>& stop)
{
  SurfaceMesh surface;
  vtkPolyData* mesh = picture.GetMesh();
  vtkDataArray* values = mesh->GetPointData()->GetArray(array.c_str());
  if (!values)
  {
    return surface;
  }
  double range[2] = { INFINITY, -INFINITY };
  if (ExtendRange(values, range))
  {
    std::copy_n(range, 2, surface.Range);
  }
  const vtkIdType count = picture.GetNumberOfElements();
  BlockMaker maker(mesh, values);
  for (vtkIdType first = 0; first < count && !stop; first += ElementsOfBlock)
  {
    surface.Blocks.push_back(maker.Make(first, std::min(first + ElementsOfBlock, count)));
  }
  return surface;
}

} // namespace pemesh
