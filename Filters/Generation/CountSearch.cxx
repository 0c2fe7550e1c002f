// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CountSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pemesh
{

namespace
{

constexpr int MostTrials = 40;

/** Bounds nearer than this give the same mesh, or the count jumps between them. */
constexpr double NearestBounds = 1e-9;

} // namespace

CountSearch::CountSearch(double target, double tolerance, double firstBound, double greatestBound)
  : Target(target)
  , Tolerance(tolerance)
  , GreatestBound(greatestBound)
  , Bound(std::min(firstBound, greatestBound))
  , NearestBound(this->Bound)
  , LastWidth(std::numeric_limits<double>::infinity())
  , WidthBefore(this->LastWidth)
{
}

void CountSearch::Finish(bool reached)
{
  this->Searching = false;
  this->Reached = reached;
  this->Bound = this->NearestBound;
}

void CountSearch::Report(double count)
{
  const double excess = std::log(count / this->Target);
  const bool isNearest =
    this->Trials == 0 || std::abs(excess) < std::abs(std::log(this->NearestCount / this->Target));
  if (isNearest)
  {
    this->NearestCount = count;
    this->NearestBound = this->Bound;
  }
  ++this->Trials;
  if (std::abs(count - this->Target) <= this->Tolerance * this->Target)
  {
    this->Finish(true);
    return;
  }
  Trial& trial = excess > 0.0 ? this->TooMany : this->TooFew;
  trial = { std::log(this->Bound), excess, true };
  if (excess > 0.0 && this->Bound >= this->GreatestBound)
  {
    this->TargetTooSmall = true;
    this->Finish(false);
    return;
  }
  const bool isBracketed = this->TooMany.IsKnown && this->TooFew.IsKnown;
  const double next = isBracketed ? this->NextBetween() : this->NextOutwards(trial);
  const bool isUseless =
    isBracketed && std::abs(this->TooFew.Bound - this->TooMany.Bound) < NearestBounds;
  if (isUseless || this->Trials == MostTrials || !(next > std::numeric_limits<double>::min()))
  {
    this->Finish(false);
    return;
  }
  this->Bound = next;
}

/** In proportion, then two, four, ... times as far. */
double CountSearch::NextOutwards(const Trial& trial)
{
  const double least = std::copysign(0.02, trial.Excess);
  const double step = (trial.Excess + least) * this->Reach;
  this->Reach *= 2.0;
  return std::min(this->GreatestBound, std::exp(trial.Bound + step));
}

/**
 * The secant, kept off the ends of the bracket; the middle if two steps have not halved the
 * bracket. Counts that are not monotone may turn the bracket round, which does not matter.
 */
double CountSearch::NextBetween()
{
  const double width = std::abs(this->TooFew.Bound - this->TooMany.Bound);
  const bool isSlow = width > 0.5 * this->WidthBefore;
  this->WidthBefore = this->LastWidth;
  this->LastWidth = width;
  const double share = this->TooMany.Excess / (this->TooMany.Excess - this->TooFew.Excess);
  const double place = isSlow ? 0.5 : std::clamp(share, 0.02, 0.98);
  return std::exp(this->TooMany.Bound + place * (this->TooFew.Bound - this->TooMany.Bound));
}

} // namespace pemesh
