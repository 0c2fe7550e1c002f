// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Collects the findings of one check after the other: counts all, keeps the first of each.
 */
#ifndef pemesh_FindingList_h
#define pemesh_FindingList_h

#include "MeshChecks.h"

#include <initializer_list>

namespace pemesh
{

class FindingList
{
public:
  FindingList(MeshReport& report, int elements, int mostExamples);

  /** The check that the next findings are of. */
  void StartCheck(std::size_t index);

  /** `makeMessage()` gives the sentence; it is not called for findings that are only counted. */
  template <typename MakeMessage>
  void Add(std::span<const int> elements, std::span<const int> vertices, const Point2& place,
    const MakeMessage& makeMessage)
  {
    if (this->Count(elements))
    {
      this->Keep(elements, vertices, place, makeMessage());
    }
  }

  template <typename MakeMessage>
  void Add(std::initializer_list<int> elements, std::initializer_list<int> vertices,
    const Point2& place, const MakeMessage& makeMessage)
  {
    this->Add(std::span<const int>(elements.begin(), elements.size()),
      std::span<const int>(vertices.begin(), vertices.size()), place, makeMessage);
  }

private:
  /** Whether there is room for another example. */
  bool Count(std::span<const int> elements);
  void Keep(std::span<const int> elements, std::span<const int> vertices, const Point2& place,
    std::string message);

  MeshReport& Report;
  std::int64_t MostExamples;
  std::size_t Check = 0;
};

} // namespace pemesh

#endif
