// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Tilings of a rectangle by polygons with straight edges: entries of the table of tessellations.
 */
#ifndef pemesh_BoxTilings_h
#define pemesh_BoxTilings_h

#include "Tessellations.h"

namespace pemesh
{

TessellationResult MakeSquares(const TessellationInput& input);
TessellationResult MakeTriangles(const TessellationInput& input);
TessellationResult MakeOctagons(const TessellationInput& input);
TessellationResult MakeBricks(const TessellationInput& input);
TessellationResult MakeTrapezoids(const TessellationInput& input);
TessellationResult MakeDistortedQuadrilaterals(const TessellationInput& input);
TessellationResult MakeWavyQuadrilaterals(const TessellationInput& input);
TessellationResult MakeDarts(const TessellationInput& input);
TessellationResult MakeHangingSquares(const TessellationInput& input);
TessellationResult MakeHexagons(const TessellationInput& input);
TessellationResult MakeZigzag(const TessellationInput& input);
TessellationResult MakeKoch(const TessellationInput& input);

} // namespace pemesh

#endif
