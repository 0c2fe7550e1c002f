// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The search for the area bound that gives a mesh of a wanted number of elements.
 *
 * The number of elements falls with the bound, roughly as its inverse, but in steps, not quite
 * monotonically, and never below what the geometry forces. So the search looks at logarithms: it
 * steps outwards until it has a bound with too many and one with too few elements, then takes
 * secants of the two, or halves the distance where secants make it shrink too slowly. What counts
 * as an element, and how a mesh is made of a bound, is up to the caller:
 *
 *   CountSearch search(1000, 0.02, 1.2e-3, 1.0);
 *   while (search.IsSearching())
 *   {
 *     search.Report(CountElements(MakeMesh(search.GetBound())));
 *   }
 *
 * If the target was reached, the last mesh is the one. The same numbers give the same search.
 */
#ifndef pemesh_CountSearch_h
#define pemesh_CountSearch_h

#include "pemeshFiltersGenerationModule.h" // For export macro

namespace pemesh
{

class PEMESHFILTERSGENERATION_EXPORT CountSearch
{
public:
  /**
   * Target and bounds are positive; the tolerance is relative. Bounds beyond `greatestBound` make
   * no difference to the mesh and are not tried.
   */
  CountSearch(double target, double tolerance, double firstBound, double greatestBound);

  /** Whether there is a bound to try. */
  bool IsSearching() const { return this->Searching; }
  bool IsReached() const { return this->Reached; }

  /** The bound to try next, or, in the end, that of the nearest count. */
  double GetBound() const { return this->Bound; }

  /** The number of elements that the bound gave, 1 or more; more than so many will do as well. */
  void Report(double count);

  /** Of all counts reported the nearest to the target, in ratio. */
  double GetNearestCount() const { return this->NearestCount; }

  /** Whether even the greatest bound gave too many elements: that was the last count. */
  bool IsTargetTooSmall() const { return this->TargetTooSmall; }

private:
  /** A bound and its count over the target, as logarithms. */
  struct Trial
  {
    double Bound;
    double Excess;
    bool IsKnown = false;
  };

  double NextOutwards(const Trial& trial);
  double NextBetween();
  void Finish(bool reached);

  double Target;
  double Tolerance;
  double GreatestBound;
  double Bound;
  double NearestBound;
  double NearestCount = 0.0;
  Trial TooMany;      ///< the greatest bound tried that gave too many elements
  Trial TooFew;       ///< the least bound tried that gave too few
  double Reach = 1.0; ///< how much farther than proportional the next step outwards goes
  double LastWidth;   ///< of the bracket, two steps ago and one step ago
  double WidthBefore;
  int Trials = 0;
  bool Searching = true;
  bool Reached = false;
  bool TargetTooSmall = false;
};

} // namespace pemesh

#endif
