// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Greedy merging in rounds, for rules that know which group comes first and which union is best.
 */
#ifndef pemesh_RoundMerger_h
#define pemesh_RoundMerger_h

#include "AgglomerationState.h"

#include <utility>
#include <vector>

namespace pemesh
{

/** What a rule decides by. Values are finite or infinite; the least comes first, and is best. */
class MergeCriterion
{
public:
  static const double Refused; ///< NaN

  MergeCriterion() = default;
  MergeCriterion(const MergeCriterion&) = delete;
  MergeCriterion& operator=(const MergeCriterion&) = delete;
  virtual ~MergeCriterion() = default;

  /** Of a group: the least is merged first. */
  virtual double RankOf(double value) const = 0;

  /** Of a group of one element. */
  virtual double ValueOf(int element) = 0;

  /** The neighbours that are rated next are those of this group. */
  virtual void Begin(int group) = 0;

  /** Of the union of the group and its neighbour, which becomes its value: the least is best.
   * Refused if the two must not be merged; whether they can be need not be asked. */
  virtual double Rate(int neighbor, double groupValue, double neighborValue) = 0;
};

/**
 * Merges in rounds. In each round the first group comes first, and takes the best neighbour; no
 * group takes part in two merges of a round. So groups grow evenly: without rounds a group that is
 * bad and gets no better takes one neighbour after the other, and is walked round each time. Only
 * groups that were merged in a round, and their neighbours, can do in the next what they could not
 * do before: the others are not looked at again.
 *
 * In a round that cannot reach the target every group has its turn, and the order only says which
 * of two neighbours chooses first. There ranks are rounded to two bits, and groups of equal rank
 * come in the order of the curve: what is needed next is near in memory, which halves the time.
 *
 * Cost: about that of rating each pair of neighbours twice, if no target or bound stops it earlier.
 */
class RoundMerger
{
public:
  RoundMerger(AgglomerationState& state, MergeCriterion& criterion);

  /** False if it was stopped. */
  bool Run();

private:
  bool MeasureElements();
  void SortActive();
  bool RunRound();
  void MergeWithBest(int group);
  void ListNextRound();

  AgglomerationState& State;
  ElementMerger& Merger;
  MergeCriterion& Criterion;
  std::vector<double> Values;
  std::vector<int> MergedIn; ///< round
  std::vector<int> ListedIn; ///< round
  std::vector<std::pair<double, int>> Active;
  std::vector<int> MergedGroups;
  int Round = 0;

  std::vector<int> Neighbors;
  std::vector<std::pair<double, int>> Candidates;
};

} // namespace pemesh

#endif
