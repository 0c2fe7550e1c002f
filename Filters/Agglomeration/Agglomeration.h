// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Coarser meshes: neighbouring elements are merged by one of the rules of AgglomerationRules.h.
 *
 * Whatever the rule, every element of the result is a simple polygon without hole, the mesh is
 * conforming, and the work ends. The same bits on every run.
 */
#ifndef pemesh_Agglomeration_h
#define pemesh_Agglomeration_h

#include "AgglomerationRules.h"
#include "Parameter.h"
#include "PolygonMesh.h"
#include "StraightVertices.h"
#include "pemeshFiltersAgglomerationModule.h" // For export macro

#include <functional>
#include <string>
#include <vector>

namespace pemesh
{

struct Metric;

struct PEMESHFILTERSAGGLOMERATION_EXPORT AgglomerationOptions
{
  /** The defaults of the rule. */
  explicit AgglomerationOptions(const AgglomerationRule& rule);

  const AgglomerationRule* Rule;
  ParameterValues Parameters; ///< of the rule

  const pemesh::Metric* Metric; ///< see RuleMetric; null for none

  ///@{
  /** Where to stop, at most one of them: a number of elements, or a percentage (0, 100] of those
   * of the input. Kept elements count. 0: the DefaultPercentage of the rule. */
  int TargetElements = 0;
  double TargetPercentage = 0.0;
  ///@}

  std::vector<bool> Placed; ///< an element each: of a placed polygon; empty: none is
  bool KeepPlaced = true;   ///< placed polygons are never merged

  pemesh::StraightVertices StraightVertices = pemesh::StraightVertices::Keep;
};

enum class AgglomerationStatus
{
  Done,
  Stopped,        ///< by the progress function
  Misconfigured,  ///< the options contradict each other or the rule
  NotAgglomerable ///< the mesh: see WhyNotAgglomerable; or it has nothing that the rule needs
};

struct AgglomerationResult
{
  AgglomerationStatus Status = AgglomerationStatus::Done;
  std::string Message; ///< one sentence, unless Done or Stopped

  PolygonMesh Mesh;
  std::vector<int> Group; ///< an old element each: the new element that it is part of

  /** Area that changed sides where vertices straight but for rounding were removed. Every element
   * has exactly the area of its parts if it is 0, as with StraightVertices::Keep. */
  double MovedArea = 0.0;
};

/**
 * New elements come in the order of the first old element of each, its points in their old order;
 * points that no element uses are left out. `progress`, if any, gets the fraction done and answers
 * whether to go on.
 */
PEMESHFILTERSAGGLOMERATION_EXPORT AgglomerationResult Agglomerate(const PolygonMesh& mesh,
  const AgglomerationOptions& options, const std::function<bool(double)>& progress = {});

} // namespace pemesh

#endif
