// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The functions behind the table of checks, and the mesh as they see it: private to this module.
 */
#ifndef pemesh_CheckFunctions_h
#define pemesh_CheckFunctions_h

#include "FindingList.h"
#include "MeshSides.h"
#include "NormalForm.h"

#include <optional>

namespace pemesh
{

/** What several checks need is computed when first asked for. */
class MeshUnderCheck
{
public:
  MeshUnderCheck(const RawMesh& raw, const CheckOptions& options)
    : Raw(raw)
    , Options(options)
  {
  }

  const PolygonMesh& GetMesh() const { return this->Raw.Mesh; }
  const std::vector<double>& GetHeights() const { return this->Raw.Heights; }
  const CheckOptions& GetOptions() const { return this->Options; }
  const NormalForm& GetNormalForm();
  const MeshSides& GetSides();
  bool HasSides() const { return this->Sides.has_value(); }

  bool IsInRange(int vertex) const
  {
    return vertex >= 0 && vertex < static_cast<int>(this->Raw.Mesh.Points.size());
  }

  /** The mean of the vertices that can be used; the origin if there are none. */
  Point2 PlaceOfElement(int element);

private:
  const RawMesh& Raw;
  const CheckOptions& Options;
  std::optional<NormalForm> Form;
  std::optional<MeshSides> Sides;
};

/** The elements that have one of some vertices. */
class ElementsAround
{
public:
  /** `isWanted` has an entry for each point. */
  ElementsAround(const PolygonMesh& mesh, const std::vector<unsigned char>& isWanted);

  /** Ascending, each once. */
  std::vector<int> Get(int vertex) const;

private:
  std::vector<std::pair<int, int>> Pairs; // a vertex and an element
};

void CheckVertexIds(MeshUnderCheck& mesh, FindingList& findings);
void CheckFinite(MeshUnderCheck& mesh, FindingList& findings);
void CheckPlanar(MeshUnderCheck& mesh, FindingList& findings);
void CheckDegenerate(MeshUnderCheck& mesh, FindingList& findings);
void CheckSimple(MeshUnderCheck& mesh, FindingList& findings);
void CheckOrientation(MeshUnderCheck& mesh, FindingList& findings);
void CheckSlivers(MeshUnderCheck& mesh, FindingList& findings);
void CheckDuplicateVertices(MeshUnderCheck& mesh, FindingList& findings);
void CheckNearVertices(MeshUnderCheck& mesh, FindingList& findings);
void CheckUnusedPoints(MeshUnderCheck& mesh, FindingList& findings);
void CheckSides(MeshUnderCheck& mesh, FindingList& findings);
void CheckTJunctions(MeshUnderCheck& mesh, FindingList& findings);
void CheckPinchedVertices(MeshUnderCheck& mesh, FindingList& findings);
void CheckOverlaps(MeshUnderCheck& mesh, FindingList& findings);
void CheckConnected(MeshUnderCheck& mesh, FindingList& findings);
void CheckHoles(MeshUnderCheck& mesh, FindingList& findings);
void CheckCoverage(MeshUnderCheck& mesh, FindingList& findings);

} // namespace pemesh

#endif
