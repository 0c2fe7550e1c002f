// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RandomStudy.h"

#include "PolygonFamilies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>

namespace
{

using Json = nlohmann::ordered_json;
using pemesh::Point2;

constexpr const char* ShapeFile = "shape.csv";

struct Box
{
  Point2 Low;
  Point2 High;
  double Side() const { return std::min(this->High.x - this->Low.x, this->High.y - this->Low.y); }
};

Box BoxOf(const pemesh::Domain& domain)
{
  Box box = { domain.Outer[0], domain.Outer[0] };
  for (const Point2& point : domain.Outer)
  {
    box.Low = { std::min(box.Low.x, point.x), std::min(box.Low.y, point.y) };
    box.High = { std::max(box.High.x, point.x), std::max(box.High.y, point.y) };
  }
  return box;
}

const pemesh::PolygonFamily& FamilyOf(const Json& polygon)
{
  return *pemesh::FindPolygonFamily(polygon["family"].get<std::string>());
}

/** Any family, anywhere: some leave the domain or meet others, and are refused. */
void DrawPolygons(RandomNumbers& random, Json& study)
{
  study["polygons"] = Json::array();
  if (!IsTriangulated(study))
  {
    return;
  }
  std::vector<const char*> families;
  for (const pemesh::PolygonFamily& family : pemesh::PolygonFamilies())
  {
    if (!family.IsFixed())
    {
      families.push_back(family.Name);
    }
  }
  const Box box = BoxOf(DomainOf(study));
  const int count = random.OneIn(12) ? 0 : 1 + random.Integer(4);
  for (int i = 0; i < count; ++i)
  {
    study["polygons"].push_back(
      { { "family", random.AnyOf(families) }, { "name", PolygonNamePrefix + std::to_string(i) },
        { "center",
          { box.Low.x + random.Real(0.15, 0.85) * (box.High.x - box.Low.x),
            box.Low.y + random.Real(0.15, 0.85) * (box.High.y - box.Low.y) } },
        { "scale", random.Real(0.1, 1.0) / count * box.Side() } });
  }
}

void DrawFamilyParameters(RandomNumbers& random, Json& study)
{
  for (Json& polygon : study["polygons"])
  {
    if (random.OneIn(2))
    {
      DrawParameters(random, FamilyOf(polygon).Parameters, polygon);
    }
  }
}

/** Mostly star-shaped; one in four is 1e-9 thin, and convex: between thin spikes there would be
 * room for millions of triangles. */
Json DrawPoints(RandomNumbers& random, const Json& polygon)
{
  const bool isThin = random.OneIn(4);
  const double thinness = isThin ? 1e-9 : 1.0;
  const double radius = 0.25 * polygon["scale"].get<double>();
  const int count = 3 + random.Integer(10);
  Json points = Json::array();
  for (int i = 0; i < count; ++i)
  {
    const double angle = (i + random.Real(0.0, 0.9)) * 2.0 * std::numbers::pi / count;
    const double reach = radius * (isThin ? 1.0 : random.Real(0.2, 1.0));
    points.push_back({ polygon["center"][0].get<double>() + reach * std::cos(angle),
      polygon["center"][1].get<double>() + thinness * reach * std::sin(angle) });
  }
  return points;
}

void DrawFixedPolygons(RandomNumbers& random, Json& study)
{
  for (Json& polygon : study["polygons"])
  {
    const int kind = random.Integer(12);
    if (kind > 1)
    {
      continue;
    }
    Json fixed = { { "family", kind == 0 ? pemesh::FileFamilyName : pemesh::PointsFamilyName },
      { "name", polygon["name"] } };
    if (kind == 0)
    {
      fixed["file"] = ShapeFile;
      fixed["center"] = polygon["center"];
      fixed["scale"] = polygon["scale"];
    }
    else
    {
      fixed["points"] = DrawPoints(random, polygon);
    }
    polygon = fixed;
  }
}

/** Right angles bring collinear vertices and equal coordinates. */
void DrawRotations(RandomNumbers& random, Json& study)
{
  for (Json& polygon : study["polygons"])
  {
    polygon["rotation"] = random.OneIn(3) ? 90.0 * random.Integer(4) : random.Real(-360.0, 360.0);
  }
}

void DrawRanges(RandomNumbers& random, Json& study)
{
  for (Json& polygon : study["polygons"])
  {
    if (random.OneIn(3) && !FamilyOf(polygon).IsFixed())
    {
      polygon["from"] = random.Real(0.0, 1.0);
      polygon["to"] = random.Real(0.0, 1.0);
    }
  }
}

/** Besides placed polygons; too many find no room, and are refused. */
void DrawScatter(RandomNumbers& random, Json& study)
{
  if (!IsTriangulated(study) || !random.OneIn(6))
  {
    return;
  }
  const double side = BoxOf(DomainOf(study)).Side();
  const double smallest = random.Real(0.1, 0.3) * side;
  study["scatter"] = { { "count", 1 + random.Integer(12) }, { "seed", random.Integer(1000) },
    { "order", random.OneIn(2) ? "cycle" : "random" }, { "smallest-scale", smallest },
    { "largest-scale", smallest * random.Real(1.0, 2.0) },
    { "largest-rotation", random.OneIn(2) ? 0.0 : random.Real(0.0, 360.0) },
    { "gap", random.OneIn(2) ? 0.0 : random.Real(0.0, 0.05) * side },
    { "from", random.Real(0.0, 1.0) }, { "to", random.Real(0.0, 1.0) } };
}

/** The shortest edge of most families asks for millions of triangles: this rule has its own
 * polygon. */
void DrawShortestEdge(RandomNumbers& random, Json& study)
{
  if (IsTriangulated(study) && random.OneIn(8))
  {
    const Box box = BoxOf(DomainOf(study));
    study.erase("scatter");
    study["polygons"] = { { { "family", "n-sided" },
      { "name", PolygonNamePrefix + std::string("0") }, { "sides", 4 + random.Integer(8) },
      { "center", { 0.5 * (box.Low.x + box.High.x), 0.5 * (box.Low.y + box.High.y) } },
      { "scale", random.Real(0.5, 1.5) * box.Side() } } };
    study["mesh"]["max-area"] = { { "rule", "shortest-edge" } };
  }
}

constexpr std::array Draws = {
  StudyDraw{ "polygons", DrawPolygons },
  StudyDraw{ "family parameters", DrawFamilyParameters },
  StudyDraw{ "fixed polygons", DrawFixedPolygons },
  StudyDraw{ "rotations", DrawRotations },
  StudyDraw{ "ranges", DrawRanges },
  StudyDraw{ "scatter", DrawScatter },
  StudyDraw{ "shortest edge", DrawShortestEdge },
};

void WriteLoops(const std::filesystem::path& path, const std::vector<std::vector<Point2>>& loops)
{
  std::ofstream file(path);
  file.precision(17);
  file << "x,y\n";
  for (const std::vector<Point2>& loop : loops)
  {
    for (const Point2& point : loop)
    {
      file << point.x << "," << point.y << "\n";
    }
    file << "\n";
  }
}

} // namespace

std::span<const StudyDraw> PolygonDraws()
{
  return Draws;
}

pemesh::Domain DomainOfDrawnFile(const std::string& name)
{
  if (name == "kite.csv") // slanted sides, not at the origin
  {
    return { { { -0.3, 0.1 }, { 0.7, -0.45 }, { 1.9, 0.2 }, { 0.6, 1.3 } }, {} };
  }
  return { { { 0.0, 0.0 }, { 2.0, 0.0 }, { 2.0, 1.0 }, { 0.0, 1.0 } },
    { { { 0.2, 0.3 }, { 0.45, 0.35 }, { 0.3, 0.7 } },
      { { 1.6, 0.1 }, { 1.8, 0.1 }, { 1.8, 0.3 }, { 1.6, 0.3 } } } };
}

void WriteDrawnFiles(const std::filesystem::path& folder)
{
  for (const char* name : { "kite.csv", "holes.csv" })
  {
    const pemesh::Domain domain = DomainOfDrawnFile(name);
    std::vector<std::vector<Point2>> loops = { domain.Outer };
    loops.insert(loops.end(), domain.Holes.begin(), domain.Holes.end());
    WriteLoops(folder / name, loops);
  }
  WriteLoops(folder / ShapeFile, // a hook with a straight vertex
    { { { 0.0, 0.0 }, { 1.0, 0.0 }, { 2.0, 0.0 }, { 2.1, 1.5 }, { 1.2, 0.4 }, { -0.2, 0.9 } } });
}
