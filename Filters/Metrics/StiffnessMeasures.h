// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What the matrices of the lowest-order virtual element method say about an element.
 */
#ifndef pemesh_StiffnessMeasures_h
#define pemesh_StiffnessMeasures_h

#include "Point2.h"
#include "pemeshFiltersMetricsModule.h" // For export macro

namespace pemesh
{

struct StiffnessMeasures
{
  double StabilityRatio = 0.0;      ///< second smallest over largest eigenvalue of the stiffness
  double ProjectionCondition = 0.0; ///< largest over smallest singular value of the projection
};

/**
 * Of a counter-clockwise polygon. The projection keeps the mean of the values at the vertices, the
 * stabilisation is dofi-dofi, not scaled (see VirtualElementMethodElement.h).
 *
 * With m the n x 3 values of 1 and the scaled monomials at the vertices and C the coefficients of
 * the projections, the stiffness matrix is K = (I - m C')' (I - m C') + c (g_x g_x' + g_y g_y'),
 * which is the identity on all vectors orthogonal to the columns of m and C. So its eigenvalues
 * are one, and those of K restricted to the span of these six columns: linear cost in n.
 */
PEMESHFILTERSMETRICS_EXPORT StiffnessMeasures MeasureStiffness(PolygonView polygon);

} // namespace pemesh

#endif
