// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What can be wrong with a mesh: one table of checks (MeshChecks.cxx), and the function that makes
 * them.
 *
 * Filter, command line and documentation read the table; adding a check is adding an entry.
 *
 * Every fault is reported once, under its cause. The checks of a mesh as a whole look at it as it
 * would be after the repairs that are safe: equal vertices are one, vertices repeated in a row are
 * dropped, clockwise elements are turned. Where an element is faulty itself (crosses itself, has no
 * area, has vertices that cannot be used), what that does to the sides around it is not reported
 * again: mend it and check once more.
 */
#ifndef pemesh_MeshChecks_h
#define pemesh_MeshChecks_h

#include "Domain.h"
#include "Point2.h"
#include "PolygonMesh.h"
#include "pemeshFiltersCheckModule.h" // For export macro

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pemesh
{

class FindingList;
class MeshUnderCheck;

enum class CheckSeverity
{
  Warning, ///< a solver may live with it
  Error    ///< not a conforming mesh of simple counter-clockwise polygons
};

struct MeshCheck
{
  const char* Name;        ///< "t-junctions"
  const char* Label;       ///< "T-junctions"
  const char* Description; ///< what is found, as one phrase
  CheckSeverity Severity;
  bool IsRepairable; ///< MeshRepair.h mends it
  void (*Function)(MeshUnderCheck& mesh, FindingList& findings);
};

/** All checks, in the order in which they are made and reported. At most 32. */
PEMESHFILTERSCHECK_EXPORT std::span<const MeshCheck> MeshChecks();

/** By its name, or null. */
PEMESHFILTERSCHECK_EXPORT const MeshCheck* FindMeshCheck(std::string_view name);

/** One sentence for a name that is not in the table, which tells the nearest one that is. */
PEMESHFILTERSCHECK_EXPORT std::string DescribeUnknownMeshCheck(std::string_view name);

/**
 * A mesh as it was found: vertex numbers and coordinates may be anything, elements may have any
 * number of vertices.
 */
struct RawMesh
{
  PolygonMesh Mesh;
  std::vector<double> Heights; ///< the third coordinate of each point; empty if all are zero
};

struct CheckOptions
{
  /** An element is a sliver if twice its area is less than this times its diameter squared; for a
   * triangle that is its smallest height over its longest side. */
  double SliverThickness = 1e-6;
  /** What counts as rounding: a distance relative to the diagonal of the mesh's bounding box. */
  double Tolerance = 1e-12;
  /** How far the area may be from that of the expected domain, relative. */
  double AreaTolerance = 1e-9;
  /** Findings kept for each check; all are counted. */
  int MostExamples = 100;
  /** What the mesh should cover; without it the border is taken as it is. */
  std::optional<Domain> ExpectedDomain;
  /** Names; empty for all. Unknown names are ignored (DescribeUnknownMeshCheck). */
  std::vector<std::string> Checks;
  /** Told the fraction done after each check; answers whether to go on. */
  std::function<bool(double)> Progress;
};

struct MeshFinding
{
  const MeshCheck* Check = nullptr;
  std::vector<int> Elements; ///< those at fault, ascending; perhaps none
  std::vector<int> Vertices; ///< perhaps none
  Point2 Place;              ///< of the vertex, or in the middle of the side or the element
  std::string Message;       ///< one sentence
};

struct MeshReport
{
  /** The first of each check, in the order of the table. */
  std::vector<MeshFinding> Findings;
  /** All of each check: as many as MeshChecks(). */
  std::vector<std::int64_t> Counts;
  /** For each element the number of findings that name it. */
  std::vector<int> Faults;
  /** For each element bit i says whether check i names it. */
  std::vector<std::uint32_t> FaultBits;
  /** Pieces of elements joined by sides, and holes; -1 unless a check needed them. */
  int NumberOfComponents = -1;
  int NumberOfHoles = -1;
  /** Whether Progress asked to stop; the rest is incomplete then. */
  bool IsStopped = false;

  PEMESHFILTERSCHECK_EXPORT std::int64_t GetCount(CheckSeverity severity) const;
  /** 0 for an unknown name. */
  PEMESHFILTERSCHECK_EXPORT std::int64_t GetCount(std::string_view check) const;
};

/**
 * Makes the checks. Near linear in the number of sides, but for elements of very many vertices and
 * for overlaps of concave elements; the same report for any number of threads.
 */
PEMESHFILTERSCHECK_EXPORT MeshReport CheckMesh(const RawMesh& mesh, const CheckOptions& options);

} // namespace pemesh

#endif
