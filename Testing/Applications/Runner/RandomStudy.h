// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Study documents drawn at random: one table of draws, each of which sets some keys.
 *
 * Families, shapes of domains, tessellations, agglomeration rules and their parameters are drawn
 * from the tables of the filters: what is added there is drawn without an edit here.
 */
#ifndef pemesh_RandomStudy_h
#define pemesh_RandomStudy_h

#include "Domain.h"
#include "Parameter.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <random>
#include <span>
#include <string>

/** The same numbers for the same seed, everywhere. */
class RandomNumbers
{
public:
  explicit RandomNumbers(std::uint64_t seed)
    : Bits(seed)
  {
  }

  /** From `low` to `high`. */
  double Real(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->Bits() >> 11) * 0x1p-53);
  }
  /** 0 to count - 1. */
  int Integer(int count)
  {
    return static_cast<int>(((this->Bits() >> 32) * static_cast<std::uint64_t>(count)) >> 32);
  }
  /** True once in `count` times. */
  bool OneIn(int count) { return this->Integer(count) == 0; }

  template <typename Table>
  auto& AnyOf(Table&& table)
  {
    return table[static_cast<std::size_t>(this->Integer(static_cast<int>(std::size(table))))];
  }

private:
  std::mt19937_64 Bits;
};

/** The document of a seed: every draw of the table, in its order. */
nlohmann::ordered_json DrawStudy(std::uint64_t seed);

/** Writes the files that drawn studies name, into the folder that they are relative to. */
void WriteDrawnFiles(const std::filesystem::path& folder);

/** The domain in such a file. */
pemesh::Domain DomainOfDrawnFile(const std::string& name);

/** What placed polygons are called: piece-0, piece-1, ... */
inline constexpr const char* PolygonNamePrefix = "piece-";

///@{
/** Steps of the draws, each in a file of its own. */
nlohmann::ordered_json DrawParameter(RandomNumbers& random, const pemesh::Parameter& parameter);
void DrawParameters(RandomNumbers& random, std::span<const pemesh::Parameter> parameters,
  nlohmann::ordered_json& object);
pemesh::Domain DomainOf(const nlohmann::ordered_json& study);
bool IsTriangulated(const nlohmann::ordered_json& study);

struct StudyDraw
{
  const char* Name;
  void (*Function)(RandomNumbers& random, nlohmann::ordered_json& study);
};
std::span<const StudyDraw> PolygonDraws(); ///< placed and scattered polygons
std::span<const StudyDraw> SweepDraws();   ///< what was drawn before is swept
///@}

#endif
