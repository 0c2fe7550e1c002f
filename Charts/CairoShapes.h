// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What the device of Cairo draws: marker shapes, dashes, images. Private to this module.
 */
#ifndef pemesh_CairoShapes_h
#define pemesh_CairoShapes_h

#include <cairo.h>

#include <array>
#include <vector>

class vtkImageData;

namespace pemesh
{

using ByteColor = std::array<unsigned char, 4>; // red, green, blue, alpha

/** Element i of an array of colours with 1 to 4 components (grey, grey and alpha, RGB, RGBA). */
ByteColor ArrayColor(const unsigned char* colors, int components, int i);

void SetSource(cairo_t* cairo, const unsigned char* color);

/** Lengths of dashes and gaps for a line type of vtkPen; empty for a solid line. */
std::vector<double> DashPattern(int lineType, double width);

/** Adds a marker of VTK to the path for DrawMarkerPath. All shapes look equally large. */
void AddMarkerPath(cairo_t* cairo, int shape, double x, double y, double size);

/** Draws the path of markers of one shape and size with the source, and clears it. */
void DrawMarkerPath(cairo_t* cairo, int shape, double size);

/** Premultiplied and top row first, as Cairo wants it; null for other scalars than bytes. */
cairo_surface_t* MakeImageSurface(vtkImageData* image);

} // namespace pemesh

#endif
