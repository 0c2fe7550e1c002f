// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshPicture.h"

#include "ArrayValues.h"
#include "ColorMaps.h"
#include "ElementAccess.h"
#include "ExtremeElements.h"
#include "PointLocation.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

namespace pemesh
{

namespace
{

constexpr double SmallestDrawn = 1.2;    // pixels; below an element is a dot
constexpr double SmallestOutlined = 4.0; // pixels, of elements on average
constexpr double FaintOpacity = 0.25;
constexpr int MostSmoothed = 150000; // elements with smooth edges

vtkDataArray* FindCellArray(vtkPolyData* mesh, const std::string& name)
{
  return name.empty() ? nullptr : mesh->GetCellData()->GetArray(name.c_str());
}

QRgb Blend(const ChartColor& color, QRgb behind, double opacity)
{
  const auto mix = [opacity](int front, int back)
  { return static_cast<int>(std::lround(opacity * front + (1.0 - opacity) * back)); };
  return qRgb(
    mix(color[0], qRed(behind)), mix(color[1], qGreen(behind)), mix(color[2], qBlue(behind)));
}

/** What is not marked comes near the colour behind it. */
void FadeOthers(std::vector<QRgb>& colors, const std::vector<vtkIdType>& marked, QRgb behind)
{
  auto next = marked.begin();
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    if (next != marked.end() && *next == static_cast<vtkIdType>(i))
    {
      ++next;
      continue;
    }
    const QColor color(colors[i]);
    colors[i] =
      Blend({ static_cast<unsigned char>(color.red()), static_cast<unsigned char>(color.green()),
              static_cast<unsigned char>(color.blue()) },
        behind, FaintOpacity);
  }
}

} // namespace

MeshPicture::MeshPicture(vtkPolyData* mesh)
  : Mesh(mesh)
  , Begins(1, 0)
{
  if (!ElementAccess::WhyUnusable(mesh).empty())
  {
    return;
  }
  ElementAccess elements(mesh);
  std::vector<Point2> vertices;
  for (vtkIdType i = 0; i < elements.GetNumberOfElements(); ++i)
  {
    elements.GetVertices(i, vertices);
    double box[4] = { INFINITY, INFINITY, -INFINITY, -INFINITY };
    for (const Point2& point : vertices)
    {
      box[0] = std::min(box[0], point.x);
      box[1] = std::min(box[1], point.y);
      box[2] = std::max(box[2], point.x);
      box[3] = std::max(box[3], point.y);
    }
    this->Points.insert(this->Points.end(), vertices.begin(), vertices.end());
    this->Begins.push_back(this->Points.size());
    this->Boxes.emplace_back(QPointF(box[0], box[1]), QPointF(box[2], box[3]));
    this->Bounds = i == 0 ? this->Boxes.back() : this->Bounds.united(this->Boxes.back());
  }
}

MeshPicture::~MeshPicture() = default;

vtkPolyData* MeshPicture::GetMesh() const
{
  return this->Mesh;
}

PolygonView MeshPicture::GetElement(vtkIdType element) const
{
  const auto i = static_cast<std::size_t>(element);
  return { this->Points.data() + this->Begins[i], this->Begins[i + 1] - this->Begins[i] };
}

vtkIdType MeshPicture::FindElement(const Point2& point) const
{
  for (std::size_t i = 0; i < this->Boxes.size(); ++i)
  {
    const QRectF& box = this->Boxes[i];
    if (point.x < box.left() || point.x > box.right() || point.y < box.top() ||
      point.y > box.bottom())
    {
      continue;
    }
    if (ContainsPoint(this->GetElement(static_cast<vtkIdType>(i)), point))
    {
      return static_cast<vtkIdType>(i);
    }
  }
  return -1;
}

std::vector<vtkIdType> MeshPicture::FindElements(const Point2& a, const Point2& b) const
{
  const QRectF area = QRectF(QPointF(a.x, a.y), QPointF(b.x, b.y)).normalized();
  std::vector<vtkIdType> elements;
  for (std::size_t i = 0; i < this->Boxes.size(); ++i)
  {
    if (area.contains(this->Boxes[i].center()))
    {
      elements.push_back(static_cast<vtkIdType>(i));
    }
  }
  return elements;
}

MeshPicture::Extremes MeshPicture::FindExtremes(const std::string& array) const
{
  Extremes extremes;
  vtkDataArray* values = FindCellArray(this->Mesh, array);
  const auto [smallest, largest] = FindExtremeElements(values);
  if (smallest >= 0)
  {
    extremes = { { ValueOf(values, smallest), ValueOf(values, largest) }, { smallest, largest } };
  }
  return extremes;
}

double MeshPicture::GetValue(const std::string& array, vtkIdType element) const
{
  vtkDataArray* values = FindCellArray(this->Mesh, array);
  return values && element >= 0 && element < values->GetNumberOfTuples() ? ValueOf(values, element)
                                                                         : std::nan("");
}

bool MeshPicture::HasArray(const std::string& array) const
{
  return FindCellArray(this->Mesh, array) != nullptr;
}

vtkSmartPointer<vtkTable> MeshPicture::MakeTable() const
{
  auto table = vtkSmartPointer<vtkTable>::New();
  vtkCellData* data = this->Mesh->GetCellData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    table->AddColumn(data->GetAbstractArray(i));
  }
  return table;
}

std::vector<QRgb> MeshPicture::MakeColors(const MeshColoring& coloring) const
{
  const auto count = static_cast<std::size_t>(this->GetNumberOfElements());
  std::vector<QRgb> colors(count, coloring.Plain);
  vtkDataArray* values = FindCellArray(this->Mesh, coloring.Array);
  const bool classes = coloring.Array == "ElementFamily";
  ColorScale scale{ FindColorMap("viridis"), coloring.Range[0], coloring.Range[1],
    coloring.Logarithmic };
  if (values && !classes && scale.Low == scale.High)
  {
    const Extremes extremes = this->FindExtremes(coloring.Array);
    scale.Low = extremes.Values[0];
    scale.High = extremes.Values[1];
  }
  for (std::size_t i = 0; values && i < count; ++i)
  {
    const double value = ValueOf(values, static_cast<vtkIdType>(i));
    if (!classes)
    {
      const ChartColor color = scale.ColorOf(value);
      colors[i] = qRgb(color[0], color[1], color[2]);
    }
    else if (value >= 0)
    {
      colors[i] = Blend(SeriesColor(static_cast<int>(value)), coloring.Plain, coloring.Opacity);
    }
  }
  if (coloring.Marked)
  {
    FadeOthers(colors, *coloring.Marked, coloring.Plain);
  }
  return colors;
}

QImage MeshPicture::Paint(const PlaneTransform& transform, const QSizeF& size, double pixelRatio,
  const MeshColoring& coloring, const std::atomic<bool>& stop) const
{
  const QSize pixels = (size * pixelRatio).toSize();
  QImage image(pixels, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  const std::vector<QRgb> colors = this->MakeColors(coloring);
  const Point2 low = transform.ToPlane({ 0.0, size.height() });
  const Point2 high = transform.ToPlane({ size.width(), 0.0 });
  const QRectF view(QPointF(low.x, low.y), QPointF(high.x, high.y));
  const double scale = transform.Scale * pixelRatio;
  const double typical = scale *
    std::sqrt(this->Bounds.width() * this->Bounds.height() / std::max<double>(1.0, colors.size()));
  const bool outlined = typical > SmallestOutlined;
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing, outlined && colors.size() < MostSmoothed);
  QColor line(coloring.Line);
  line.setAlphaF(static_cast<float>(std::clamp((typical - SmallestOutlined) / 12.0, 0.25, 1.0)));
  painter.setPen(outlined ? QPen(line, pixelRatio) : QPen(Qt::NoPen));
  std::vector<QPointF> corners;
  QRgb last = 0;
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    if (i % 4096 == 0 && stop)
    {
      break;
    }
    const QRectF& box = this->Boxes[i];
    if (box.right() < view.left() || box.left() > view.right() || box.bottom() < view.top() ||
      box.top() > view.bottom())
    {
      continue;
    }
    if (std::max(box.width(), box.height()) * scale < SmallestDrawn)
    {
      const QPoint dot =
        (transform.ToScreen({ box.center().x(), box.center().y() }) * pixelRatio).toPoint();
      if (image.rect().contains(dot))
      {
        reinterpret_cast<QRgb*>(image.scanLine(dot.y()))[dot.x()] = colors[i] | 0xff000000U;
      }
      continue;
    }
    if (colors[i] != last || i == 0)
    {
      painter.setBrush(QColor(colors[i]));
      last = colors[i];
    }
    corners.clear();
    for (const Point2& point : this->GetElement(static_cast<vtkIdType>(i)))
    {
      corners.push_back(transform.ToScreen(point) * pixelRatio);
    }
    painter.drawPolygon(corners.data(), static_cast<int>(corners.size()), Qt::OddEvenFill);
  }
  painter.end();
  image.setDevicePixelRatio(pixelRatio);
  return image;
}

} // namespace pemesh
