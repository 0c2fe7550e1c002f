// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The rules that bound the area of the triangles which fill the domain, one table.
 */
#ifndef pemesh_AreaRules_h
#define pemesh_AreaRules_h

#include "Point2.h"
#include "pemeshFiltersGenerationModule.h" // For export macro

#include <span>
#include <string_view>
#include <vector>

namespace pemesh
{

/** What a rule may look at. */
struct AreaRuleInput
{
  const std::vector<std::vector<Point2>>& Polygons; ///< as placed in the domain
  double MinimumAngle;                              ///< degrees
  double Constant;                                  ///< the user's own bound
};

struct AreaRule
{
  const char* Name; ///< "diagonal"
  const char* Label;
  const char* Formula;
  double (*MaximumArea)(const AreaRuleInput& input); ///< infinity: no bound
};

/** All rules: none, shortest-edge, diagonal, constant. */
PEMESHFILTERSGENERATION_EXPORT std::span<const AreaRule> AreaRules();

/** The position of the rule of that name in the table, or -1. */
PEMESHFILTERSGENERATION_EXPORT int FindAreaRule(std::string_view name);

} // namespace pemesh

#endif
