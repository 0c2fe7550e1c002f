// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SurfacePicture.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <thread>

namespace pemesh
{

namespace
{

constexpr float Ambient = 0.35F;
constexpr float Diffuse = 0.65F;
constexpr float Rounding = 1e-4F; // of a triangle: its edges must not gape
constexpr QRgb UndefinedColor = 0xff808080;

/** A vertex on the image; Color is a place among the colours, NaN without a value. */
struct ScreenPoint
{
  float X;
  float Y;
  float Depth;
  float Color;
};

/** Twice the area of a, b and the point, by its sign the side of the line. */
float Side(const ScreenPoint& a, const ScreenPoint& b, float x, float y)
{
  return (b.X - a.X) * (y - a.Y) - (b.Y - a.Y) * (x - a.X);
}

QRgb Shade(QRgb color, float light)
{
  const auto part = [light](int channel)
  { return static_cast<int>(light * static_cast<float>(channel)); };
  return qRgb(part(qRed(color)), part(qGreen(color)), part(qBlue(color)));
}

class SurfacePainter
{
public:
  SurfacePainter(const SurfaceShape& shape, const SurfaceField& field, const SurfaceView& view)
    : Shape(shape)
    , Field(field)
    , View(view)
    , Image(view.Size, QImage::Format_ARGB32_Premultiplied)
    , Pixels(reinterpret_cast<QRgb*>(this->Image.bits()))
    , Depths(
        static_cast<std::size_t>(view.Size.width()) * static_cast<std::size_t>(view.Size.height()),
        2.0F) // behind all
  {
    this->Image.fill(Qt::transparent);
  }

  void Paint(const std::atomic<bool>& stop)
  {
    this->Project();
    for (std::size_t i = 0; i < this->Shape.Triangles.size(); ++i)
    {
      if (i % 8192 == 0 && stop)
      {
        return;
      }
      this->FillTriangle(this->Shape.Triangles[i]);
    }
  }

  QImage TakeImage() { return this->Image; }

private:
  double HeightOf(std::size_t point) const
  {
    const double value = this->Field.Values[point];
    return std::isfinite(value) ? this->View.ZScale * value : 0.0;
  }

  void Project()
  {
    const std::array<double, 16>& m = this->View.Matrix;
    const double span = this->View.Range[1] - this->View.Range[0];
    const double perColor =
      span > 0.0 ? (static_cast<double>(this->View.Colors.size()) - 1.0) / span : 0.0;
    const double halfWidth = 0.5 * this->View.Size.width();
    const double halfHeight = 0.5 * this->View.Size.height();
    this->Points.resize(this->Shape.Points.size());
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      const auto [x, y] = this->Shape.Points[i];
      const double z = this->HeightOf(i);
      const double w = m[12] * x + m[13] * y + m[14] * z + m[15];
      const double scale = w > 0.0 ? 1.0 / w : std::nan(""); // behind the camera
      this->Points[i] = { static_cast<float>(
                            halfWidth * (1.0 + scale * (m[0] * x + m[1] * y + m[2] * z + m[3]))),
        static_cast<float>(halfHeight * (1.0 - scale * (m[4] * x + m[5] * y + m[6] * z + m[7]))),
        static_cast<float>(scale * (m[8] * x + m[9] * y + m[10] * z + m[11])),
        static_cast<float>((this->Field.Values[i] - this->View.Range[0]) * perColor) };
    }
  }

  /** The same from either side. */
  float LightOf(const std::array<std::uint32_t, 3>& corners) const
  {
    const auto& [ax, ay] = this->Shape.Points[corners[0]];
    const auto& [bx, by] = this->Shape.Points[corners[1]];
    const auto& [cx, cy] = this->Shape.Points[corners[2]];
    const double az = this->HeightOf(corners[0]);
    const double u[3] = { bx - ax, by - ay, this->HeightOf(corners[1]) - az };
    const double v[3] = { cx - ax, cy - ay, this->HeightOf(corners[2]) - az };
    const double n[3] = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
      u[0] * v[1] - u[1] * v[0] };
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const std::array<double, 3>& light = this->View.Light;
    const double cosine =
      length > 0.0 ? (n[0] * light[0] + n[1] * light[1] + n[2] * light[2]) / length : 1.0;
    return Ambient + Diffuse * static_cast<float>(std::fabs(cosine));
  }

  /**
   * Every pixel whose middle is in it, edges included, so that nothing shines through. Of a fine
   * mesh few triangles have one, and only these are worth their light.
   */
  void FillTriangle(const std::array<std::uint32_t, 3>& corners)
  {
    const ScreenPoint& a = this->Points[corners[0]];
    const ScreenPoint& b = this->Points[corners[1]];
    const ScreenPoint& c = this->Points[corners[2]];
    const auto [lowX, highX] = std::minmax({ a.X, b.X, c.X });
    const auto [lowY, highY] = std::minmax({ a.Y, b.Y, c.Y });
    const auto width = static_cast<float>(this->View.Size.width());
    const auto height = static_cast<float>(this->View.Size.height());
    if (!(lowX < width && highX > 0.0F && lowY < height && highY > 0.0F)) // also NaN
    {
      return;
    }
    const int left = static_cast<int>(std::ceil(std::max(lowX, 0.0F) - 0.5F));
    const int right = static_cast<int>(std::floor(std::min(highX, width) - 0.5F));
    const int top = static_cast<int>(std::ceil(std::max(lowY, 0.0F) - 0.5F));
    const int bottom = static_cast<int>(std::floor(std::min(highY, height) - 0.5F));
    const float area = left > right || top > bottom ? 0.0F : Side(a, b, c.X, c.Y);
    if (area == 0.0F || !std::isfinite(area))
    {
      return;
    }
    const float perArea = 1.0F / area;
    const float light = this->LightOf(corners);
    for (int row = top; row <= bottom; ++row)
    {
      for (int column = left; column <= right; ++column)
      {
        const float x = static_cast<float>(column) + 0.5F;
        const float y = static_cast<float>(row) + 0.5F;
        const float partA = Side(b, c, x, y) * perArea;
        const float partB = Side(c, a, x, y) * perArea;
        const float partC = 1.0F - partA - partB;
        if (std::min({ partA, partB, partC }) >= -Rounding)
        {
          const float depth = partA * a.Depth + partB * b.Depth + partC * c.Depth;
          const float place = partA * a.Color + partB * b.Color + partC * c.Color;
          this->SetPixel(column, row, depth, place, light);
        }
      }
    }
  }

  void SetPixel(int column, int row, float depth, float place, float light)
  {
    const std::size_t at =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(this->View.Size.width()) +
      static_cast<std::size_t>(column);
    if (!(depth >= -1.0F && depth < this->Depths[at]))
    {
      return;
    }
    this->Depths[at] = depth;
    const auto last = static_cast<float>(this->View.Colors.size() - 1);
    const QRgb color = std::isnan(place)
      ? UndefinedColor
      : this->View.Colors[static_cast<std::size_t>(std::clamp(place + 0.5F, 0.0F, last))];
    this->Pixels[at] = Shade(color, light);
  }

  const SurfaceShape& Shape;
  const SurfaceField& Field;
  const SurfaceView& View;
  QImage Image;
  QRgb* Pixels;
  std::vector<float> Depths;
  std::vector<ScreenPoint> Points;
};

} // namespace

QImage PaintSurface(const SurfaceShape& shape, const SurfaceField& field, const SurfaceView& view,
  const std::atomic<bool>& stop)
{
  if (view.Size.isEmpty() || view.Colors.empty() || field.Values.size() != shape.Points.size())
  {
    return {};
  }
  SurfacePainter painter(shape, field, view);
  painter.Paint(stop);
  return painter.TakeImage();
}

QImage PaintSurfacePair(
  const SurfacePair& pair, const std::array<SurfaceView, 2>& views, const std::atomic<bool>& stop)
{
  QImage images[2];
  const auto paint = [&](std::size_t side)
  { images[side] = PaintSurface(pair.Shape, pair.Fields[side], views[side], stop); };
  std::thread other([&paint] { paint(1); });
  paint(0);
  other.join();
  QImage both(views[1].Left + views[1].Size.width(), views[0].Size.height(),
    QImage::Format_ARGB32_Premultiplied);
  both.fill(Qt::transparent);
  QPainter painter(&both);
  for (std::size_t side = 0; side < 2; ++side)
  {
    painter.drawImage(views[side].Left, 0, images[side]);
  }
  painter.end();
  return both;
}

} // namespace pemesh
