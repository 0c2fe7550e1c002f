// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "InscribedCircle.h"

#include "PlaneVectors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pemesh
{

/** Goes up from a point of the polygon to a local maximum of the distance to the boundary. */
void InscribedCircleFinder::Climb(Point2 point)
{
  double distance = this->SeeAll(point, this->ClimbSites);
  constexpr int MaximumSteps = 50; // converges quadratically at a circle that three edges hold
  for (int step = 0; step < MaximumSteps && this->ClimbStep(point, distance); ++step)
  {
  }
  if (distance > this->Best.Radius)
  {
    this->Best = { point, distance };
  }
  this->AddDisc(point, distance);
}

/**
 * To the highest point below the tangent planes of all distances. Those are convex functions, so
 * the true distance there is at least the height. The step stays in the circle around the point,
 * which is inside the polygon. False if nothing was gained.
 */
bool InscribedCircleFinder::ClimbStep(Point2& point, double& distance)
{
  const double reach = 0.7 * distance;
  this->Program.Clear();
  this->Program.AddSide({ 1.0, 0.0 }, reach);
  this->Program.AddSide({ 0.0, 1.0 }, reach);
  this->Program.AddSide({ -1.0, 0.0 }, reach);
  this->Program.AddSide({ 0.0, -1.0 }, reach);
  for (const Site& site : this->ClimbSites)
  {
    if (site.Distance <= 3.0 * distance && site.Distance > 0.0)
    {
      this->Program.AddBound(
        site.Distance, { site.Away.x / site.Distance, site.Away.y / site.Distance });
    }
  }
  const SmallLinearProgram::Solution solution = this->Program.Solve(1e-16 * this->Scale);
  if (!solution.Optimal)
  {
    return false;
  }
  const Point2 next = point + solution.Position;
  const double nextDistance = this->SeeAll(next, this->NextSites);
  if (!(nextDistance > distance))
  {
    return false;
  }
  point = next;
  distance = nextDistance;
  std::swap(this->ClimbSites, this->NextSites);
  return true;
}

/**
 * The disc around a local maximum in which nothing better can be: with unit vectors u_i from the
 * edges touched, the distance at an offset d is at most r + min u_i.d + |d|^2 / 2r, and the
 * minimum is at most -k |d|. For unit vectors k is the cosine of half the widest gap.
 */
void InscribedCircleFinder::AddDisc(const Point2& point, double distance)
{
  const double touching = distance + 0.5 * this->Tolerance(distance);
  this->Angles.clear();
  for (const Site& site : this->ClimbSites)
  {
    if (site.Distance <= touching)
    {
      this->Angles.push_back(std::atan2(site.Away.y, site.Away.x));
    }
  }
  std::sort(this->Angles.begin(), this->Angles.end());
  double gap = this->Angles.front() + 2.0 * std::numbers::pi - this->Angles.back();
  for (std::size_t i = 1; i < this->Angles.size(); ++i)
  {
    gap = std::max(gap, this->Angles[i] - this->Angles[i - 1]);
  }
  const double cosine = std::cos(0.5 * gap);
  this->Discs.push_back({ point, std::max(0.0, 2.0 * cosine * distance * (1.0 - 1e-9)) });
}

} // namespace pemesh
