// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What must hold of every agglomeration, judged in rational arithmetic.
 */
#ifndef pemesh_AgglomerationChecks_h
#define pemesh_AgglomerationChecks_h

#include "Agglomeration.h"
#include "PolygonMesh.h"

#include <string>
#include <utility>
#include <vector>

namespace pemesh
{

/**
 * Empty if the new mesh is an agglomeration of the old one in which all vertices were kept: every
 * new element is simple, counter-clockwise, and has exactly the area of the old ones it is made of;
 * the new mesh is conforming and has the border and the Euler characteristic of the old one; no
 * point is unused. Else a sentence.
 */
std::string WhyNotAnAgglomeration(const PolygonMesh& before, const AgglomerationResult& after);

/** Whether the union of two elements, by exact Boolean operations, is one simple polygon. */
bool IsUnionSimple(const PolygonMesh& mesh, int a, int b);

/** V - E + F. */
int EulerCharacteristic(const PolygonMesh& mesh);

/** In exact arithmetic. */
bool IsSimpleAndCounterClockwise(PolygonView polygon);

/** Sum of the areas of all elements, as an exact fraction in decimal digits. */
std::string ExactArea(const PolygonMesh& mesh);

} // namespace pemesh

#endif
