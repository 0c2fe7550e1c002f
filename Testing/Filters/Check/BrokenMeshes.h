// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Meshes to be broken on purpose, and short names for what the checks say of them.
 */
#ifndef pemesh_BrokenMeshes_h
#define pemesh_BrokenMeshes_h

#include "MeshChecks.h"

#include <map>
#include <string>
#include <vector>

namespace pemesh
{

using Elements = std::vector<std::vector<int>>;

inline RawMesh MakeRawMesh(const std::vector<Point2>& points, const Elements& elements)
{
  RawMesh raw;
  raw.Mesh.Points = points;
  for (const std::vector<int>& element : elements)
  {
    raw.Mesh.AddElement(element);
  }
  return raw;
}

inline Elements ElementsOf(const PolygonMesh& mesh)
{
  Elements elements;
  for (int element = 0; element < mesh.NumberOfElements(); ++element)
  {
    const auto vertices = mesh.Element(element);
    elements.emplace_back(vertices.begin(), vertices.end());
  }
  return elements;
}

/** The number of a point of a grid of n x n squares. */
inline int GridPoint(int n, int i, int j)
{
  return j * (n + 1) + i;
}

inline std::vector<Point2> GridPoints(int n, double spacing = 1.0)
{
  std::vector<Point2> points;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      points.push_back({ spacing * i, spacing * j });
    }
  }
  return points;
}

/** Squares, row by row. */
inline Elements GridSquares(int n)
{
  Elements elements;
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      elements.push_back({ GridPoint(n, i, j), GridPoint(n, i + 1, j), GridPoint(n, i + 1, j + 1),
        GridPoint(n, i, j + 1) });
    }
  }
  return elements;
}

/** The checks that found something, and how much. */
using Fired = std::map<std::string, int>;

inline Fired FiredChecks(const MeshReport& report)
{
  Fired fired;
  for (const MeshCheck& check : MeshChecks())
  {
    if (const auto count = report.GetCount(check.Name); count > 0)
    {
      fired[check.Name] = static_cast<int>(count);
    }
  }
  return fired;
}

inline Fired FiredChecks(const RawMesh& mesh, const CheckOptions& options = {})
{
  return FiredChecks(CheckMesh(mesh, options));
}

} // namespace pemesh

#endif
