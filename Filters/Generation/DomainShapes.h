// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The shapes of domains, one table.
 *
 * Every shape is placed so that the lower left corner of its bounding box is exactly (0, 0); its
 * first vertex is the right end of its bottom edge or, of a shape with right angles, (0, 0).
 * Adding a shape is adding one entry to the table in DomainShapes.cxx.
 */
#ifndef pemesh_DomainShapes_h
#define pemesh_DomainShapes_h

#include "Domain.h"
#include "Parameter.h"
#include "pemeshFiltersGenerationModule.h" // For export macro

#include <span>
#include <string_view>

namespace pemesh
{

struct DomainShape
{
  const char* Name;        ///< "l-shape": the word of studies and the command line
  const char* Label;       ///< "L": what a person reads
  const char* Description; ///< one sentence
  std::span<const Parameter> Parameters;
  Domain (*Make)(const ParameterValues& values); ///< valid for all values in range
};

/** All shapes: rectangle, regular-polygon, l-shape, disc. */
PEMESHFILTERSGENERATION_EXPORT std::span<const DomainShape> DomainShapes();

/** The shape of that name, or null. */
PEMESHFILTERSGENERATION_EXPORT const DomainShape* FindDomainShape(std::string_view name);

} // namespace pemesh

#endif
