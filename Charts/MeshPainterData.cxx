// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
// The first half of MeshPainter: what is read from the mesh before anything is drawn.
#include "MeshPainter.h"

#include "ElementAccess.h"
#include "ExtremeElements.h"

#include <vtkDataArray.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace pemesh
{

void MeshPainter::ReadElements()
{
  this->FirstOf.push_back(0);
  if (!this->Mesh || this->Mesh->GetNumberOfPolys() == 0)
  {
    return;
  }
  ElementAccess access(this->Mesh);
  std::vector<Point2> vertices;
  std::vector<vtkIdType> ids;
  for (vtkIdType element = 0; element < access.GetNumberOfElements(); ++element)
  {
    access.GetVertices(element, vertices);
    access.GetVertexIds(element, ids);
    this->Vertices.insert(this->Vertices.end(), vertices.begin(), vertices.end());
    this->PointIds.insert(this->PointIds.end(), ids.begin(), ids.end());
    this->FirstOf.push_back(this->Vertices.size());
  }
}

void MeshPainter::ReadBounds()
{
  double bounds[4] = { NAN, NAN, NAN, NAN };
  for (const Point2& vertex : this->Vertices)
  {
    bounds[0] = std::fmin(bounds[0], vertex.x);
    bounds[1] = std::fmax(bounds[1], vertex.x);
    bounds[2] = std::fmin(bounds[2], vertex.y);
    bounds[3] = std::fmax(bounds[3], vertex.y);
  }
  if (std::isfinite(bounds[1] - bounds[0]) && std::isfinite(bounds[3] - bounds[2]))
  {
    std::copy_n(bounds, 4, this->Bounds);
  }
}

vtkIdType MeshPainter::NumberOfElements() const
{
  return static_cast<vtkIdType>(this->FirstOf.size()) - 1;
}

double MeshPainter::CellValue(vtkIdType element) const
{
  return this->Style.CellValues->GetComponent(element, 0);
}

void MeshPainter::FindClasses()
{
  constexpr std::size_t mostClasses = 8; // more cannot be told apart by colours
  vtkDataArray* values = this->Style.CellValues;
  if (!values || values->GetDataType() == VTK_DOUBLE || values->GetDataType() == VTK_FLOAT)
  {
    return;
  }
  std::set<int> classes;
  for (vtkIdType element = 0; element < this->NumberOfElements(); ++element)
  {
    const auto value = static_cast<int>(this->CellValue(element));
    if (value >= 0)
    {
      classes.insert(value);
    }
    if (classes.size() > mostClasses)
    {
      return;
    }
  }
  this->Classes.assign(classes.begin(), classes.end());
}

void MeshPainter::MakeColorScale()
{
  vtkDataArray* values = this->Style.CellValues ? this->Style.CellValues : this->Style.PointValues;
  if (!values)
  {
    return;
  }
  const bool logarithmic = this->Style.Logarithmic && !this->Style.Diverging;
  double low = NAN;
  double high = NAN;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    if (!std::isfinite(value) || (logarithmic && value <= 0.0))
    {
      ++this->Uncoloured;
      continue;
    }
    low = std::fmin(low, value);
    high = std::fmax(high, value);
  }
  const double* range = this->Style.Range;
  if (std::isfinite(range[0]) && std::isfinite(range[1]) && range[0] < range[1] &&
    (!logarithmic || range[0] > 0.0))
  {
    low = range[0];
    high = range[1];
  }
  else if (this->Style.Diverging)
  {
    const double size = std::fmax(std::fabs(low), std::fabs(high));
    high = size > 0.0 ? size : 1.0;
    low = -high;
  }
  this->HasColorBar = !std::isnan(low);
  this->Colors.Map = FindColorMap(this->Style.Diverging ? "red-blue" : this->Style.MapName.c_str());
  this->Colors.Low = this->HasColorBar ? low : 1.0;
  this->Colors.High = this->HasColorBar ? high : 1.0;
  this->Colors.Logarithmic = logarithmic;
}

void MeshPainter::FindExtremes()
{
  if (!this->Style.CellValues)
  {
    return;
  }
  const ExtremeElements extremes = FindExtremeElements(this->Style.CellValues);
  this->Smallest = this->Style.MarkSmallest ? extremes.Smallest : -1;
  this->Largest = this->Style.MarkLargest ? extremes.Largest : -1;
}

} // namespace pemesh
