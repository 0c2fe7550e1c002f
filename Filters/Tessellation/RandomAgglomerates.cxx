// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Agglomeration.h"
#include "RandomSites.h"
#include "TilingLattice.h"
#include "VoronoiMesh.h"

namespace pemesh
{

TessellationResult MakeRandomAgglomerates(const TessellationInput& input)
{
  const double cells = input.Values.Get("cells");
  const double fineCells = cells * input.Values.Get("fineness");
  if (fineCells > input.MaximumElements)
  {
    return TooManyElements(fineCells, input.MaximumElements);
  }
  const double seed = input.Values.Get("seed");
  std::vector<Point2> sites;
  ClippedMesh fine;
  std::string why = RandomSites(input.Region, static_cast<int>(fineCells), 0.0, seed, sites);
  why = !why.empty()
    ? why
    : VoronoiMesh(
        sites, input.Region, [&](double done) { return input.Progress(0.5 * done); }, fine);
  if (!why.empty())
  {
    return { TessellationStatus::Failed, std::move(why), {} };
  }
  AgglomerationOptions options(*FindAgglomerationRule("random"));
  options.Parameters.Set("seed", seed);
  options.TargetElements = static_cast<int>(cells);
  AgglomerationResult result =
    Agglomerate(fine.Mesh, options, [&](double done) { return input.Progress(0.5 + 0.5 * done); });
  const bool isDone = result.Status == AgglomerationStatus::Done;
  return { isDone ? TessellationStatus::Done : TessellationStatus::Failed,
    std::move(result.Message), std::move(result.Mesh) };
}

} // namespace pemesh
