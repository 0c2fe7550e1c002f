// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Boxes that are found again by the boxes they meet: a static tree, four children a node.
 *
 * The boxes are sorted along Morton's curve (G. M. Morton, A computer oriented geodetic data base,
 * IBM, 1966), so that boxes near one another are neighbours whatever their sizes; each node is the
 * box around four neighbours. Built in O(n log n); the same tree on every run.
 */
#ifndef pemesh_BoxTree_h
#define pemesh_BoxTree_h

#include "Point2.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace pemesh
{

struct Box
{
  double West;
  double South;
  double East;
  double North;

  /** Closed boxes with a point in common. */
  bool Meets(const Box& other) const
  {
    return this->West <= other.East && other.West <= this->East && this->South <= other.North &&
      other.South <= this->North;
  }

  void Add(const Box& other)
  {
    this->West = std::min(this->West, other.West);
    this->South = std::min(this->South, other.South);
    this->East = std::max(this->East, other.East);
    this->North = std::max(this->North, other.North);
  }
};

inline Box BoxOf(const Point2& point)
{
  return { point.x, point.y, point.x, point.y };
}

inline Box BoxOf(const Point2& a, const Point2& b)
{
  return { std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y) };
}

inline Box Inflated(const Box& box, double by)
{
  return { box.West - by, box.South - by, box.East + by, box.North + by };
}

class BoxTree
{
public:
  /** Items and their boxes; coordinates must be finite. */
  explicit BoxTree(std::vector<std::pair<int, Box>> items);

  /** Calls `visit(item)` for every item whose box meets `box`, until it answers false. */
  template <typename Visit>
  void Query(const Box& box, const Visit& visit) const
  {
    struct Node
    {
      int Level;
      std::size_t Index;
    };
    std::array<Node, 128> stack; // three siblings wait on each of at most 33 levels
    std::size_t waiting = 0;
    if (!this->Levels.empty())
    {
      stack[waiting++] = { static_cast<int>(this->Levels.size()) - 1, 0 };
    }
    while (waiting > 0)
    {
      const Node node = stack[--waiting];
      const std::vector<Box>& boxes = this->Levels[static_cast<std::size_t>(node.Level)];
      const std::size_t last = std::min(node.Index + Children, boxes.size());
      for (std::size_t i = node.Index; i < last; ++i)
      {
        if (!boxes[i].Meets(box))
        {
          continue;
        }
        if (node.Level > 0)
        {
          stack[waiting++] = { node.Level - 1, i * Children };
        }
        else if (!visit(this->Items[i]))
        {
          return;
        }
      }
    }
  }

private:
  static constexpr std::size_t Children = 4;

  std::vector<int> Items;
  /** Level 0 has the boxes of the items, the last one at most four. */
  std::vector<std::vector<Box>> Levels;
};

} // namespace pemesh

#endif
