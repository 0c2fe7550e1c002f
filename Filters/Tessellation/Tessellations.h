// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Polygonal meshes of the literature that need no placed polygons, one table.
 *
 * Every entry covers every domain: what is not made for the domain itself is made for the least
 * axis-parallel rectangle around it and cut off at its boundary (see ClipMesh.h). Meshes of
 * rectangles (four vertices, no holes) are never cut.
 */
#ifndef pemesh_Tessellations_h
#define pemesh_Tessellations_h

#include "Domain.h"
#include "Parameter.h"
#include "PolygonMesh.h"
#include "pemeshFiltersTessellationModule.h" // For export macro

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace pemesh
{

enum class TessellationStatus
{
  Done,
  Failed,
  TooManyElements,
  Stopped
};

struct TessellationResult
{
  TessellationStatus Status = TessellationStatus::Done;
  std::string Message; ///< one sentence if failed or too many
  PolygonMesh Mesh;    ///< elements simple and counter-clockwise, conforming, no unused points
};

struct TessellationInput
{
  ParameterValues Values;
  Domain Region = UnitSquare();
  /** More elements, or sixteen times as many sides, are refused before they are made. */
  double MaximumElements = 2e7;
  /** Takes the fraction done; false means stop. */
  std::function<bool(double)> Progress = [](double) { return true; };
};

struct Tessellation
{
  const char* Name; ///< "voronoi"
  const char* Label;
  const char* Description;
  const char* Reference; ///< a paper that uses such meshes
  std::span<const Parameter> Parameters;
  TessellationResult (*Make)(const TessellationInput& input); ///< see MakeTessellation
};

/** All of them: voronoi, centroidal-voronoi, hexagons, squares, ... */
PEMESHFILTERSTESSELLATION_EXPORT std::span<const Tessellation> Tessellations();

/** The position of the tessellation of that name in the table, or -1. */
PEMESHFILTERSTESSELLATION_EXPORT int FindTessellation(std::string_view name);

/**
 * Makes a mesh and checks it: a mesh with an element that is not simple after rounding to doubles,
 * decided exactly, is refused. Nothing is thrown. The same bits on every run and any number of
 * threads.
 */
PEMESHFILTERSTESSELLATION_EXPORT TessellationResult MakeTessellation(
  const Tessellation& tessellation, const TessellationInput& input);

} // namespace pemesh

#endif
