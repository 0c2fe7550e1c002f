// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A mesh as it is shown: its outlines ready to draw, at any place and size, and the element at a
 * point. Made and painted in workers; once made it does not change.
 */
#ifndef pemesh_MeshPicture_h
#define pemesh_MeshPicture_h

#include "Point2.h"

#include <QImage>
#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include <vtkSmartPointer.h>
#include <vtkType.h>

class vtkPolyData;
class vtkTable;

namespace pemesh
{

/** From the plane to the screen, y upwards to y downwards. */
struct PlaneTransform
{
  double Scale = 400.0; ///< pixels a unit
  QPointF Origin;       ///< where (0, 0) is on the screen

  QPointF ToScreen(const Point2& p) const
  {
    return { this->Origin.x() + this->Scale * p.x, this->Origin.y() - this->Scale * p.y };
  }
  Point2 ToPlane(const QPointF& p) const
  {
    return { (p.x() - this->Origin.x()) / this->Scale, (this->Origin.y() - p.y()) / this->Scale };
  }
};

/** How the elements are coloured. */
struct MeshColoring
{
  std::string Array; ///< a cell array; "ElementFamily" gives classes; empty: no colours
  double Range[2] = { 0.0, 0.0 }; ///< equal: that of the mesh
  bool Logarithmic = false;
  QRgb Line = 0xff5a6470;
  QRgb Plain = 0xffffffff; ///< of elements of no class
  double Opacity = 1.0;    ///< of the colours of classes
  /** Ascending; the others are faint. Null: none is. */
  std::shared_ptr<const std::vector<vtkIdType>> Marked = nullptr;

  bool operator==(const MeshColoring&) const = default;
};

class MeshPicture
{
public:
  explicit MeshPicture(vtkPolyData* mesh);
  ~MeshPicture();

  vtkPolyData* GetMesh() const;
  vtkIdType GetNumberOfElements() const { return static_cast<vtkIdType>(this->Begins.size()) - 1; }
  /** In the plane; y upwards, so its top is the smallest y. */
  QRectF GetBounds() const { return this->Bounds; }

  /** The vertices of an element. */
  PolygonView GetElement(vtkIdType element) const;

  /** The element that holds a point, or -1. */
  vtkIdType FindElement(const Point2& point) const;

  /** Those with the middle of their box between two corners of a rectangle, ascending. */
  std::vector<vtkIdType> FindElements(const Point2& a, const Point2& b) const;

  /** Smallest and largest finite value of a cell array, and the elements that have them (or -1). */
  struct Extremes
  {
    double Values[2] = { 0.0, 0.0 };
    vtkIdType Elements[2] = { -1, -1 };
  };
  Extremes FindExtremes(const std::string& array) const;

  /** Whether there is a cell array of that name. */
  bool HasArray(const std::string& array) const;

  /** The value of a cell array, NaN where there is none. */
  double GetValue(const std::string& array, vtkIdType element) const;

  /** The cell arrays as a table, a row an element; no values are copied. */
  vtkSmartPointer<vtkTable> MakeTable() const;

  /** On a transparent image of that many pixels; `pixelRatio` of them make one of the transform. */
  QImage Paint(const PlaneTransform& transform, const QSizeF& size, double pixelRatio,
    const MeshColoring& coloring, const std::atomic<bool>& stop) const;

private:
  std::vector<QRgb> MakeColors(const MeshColoring& coloring) const;

  vtkSmartPointer<vtkPolyData> Mesh;
  std::vector<Point2> Points; // of one element after the other
  std::vector<std::size_t> Begins;
  std::vector<QRectF> Boxes;
  QRectF Bounds;
};

using MeshPicturePointer = std::shared_ptr<const MeshPicture>;

} // namespace pemesh

#endif
