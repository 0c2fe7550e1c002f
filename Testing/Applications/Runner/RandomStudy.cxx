// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RandomStudy.h"

#include <array>
#include <string>

namespace
{

using Json = nlohmann::ordered_json;

constexpr std::array Families = { "comb", "convexity", "isotropy", "maze", "n-sided", "star",
  "u-like", "zeta" };

/** Any family, anywhere: some leave the square or meet others, and are refused. */
void DrawPolygons(RandomNumbers& random, Json& study)
{
  study["polygons"] = Json::array();
  const int count = 1 + random.Integer(4);
  for (int i = 0; i < count; ++i)
  {
    study["polygons"].push_back(
      { { "family", Families[static_cast<std::size_t>(random.Integer(Families.size()))] },
        { "name", "piece-" + std::to_string(i) },
        { "center", { random.Real(0.15, 0.85), random.Real(0.15, 0.85) } },
        { "scale", random.Real(0.1, 1.0) / count } });
  }
}

void DrawCounts(RandomNumbers& random, Json& study)
{
  for (Json& polygon : study["polygons"])
  {
    const std::string family = polygon["family"];
    const char* key = family == "comb" ? "teeth"
      : family == "n-sided"            ? "sides"
      : family == "star"               ? "spikes"
                                       : nullptr;
    if (key && random.OneIn(2))
    {
      polygon[key] = 3 + random.Integer(30);
    }
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
    if (random.OneIn(3))
    {
      polygon["from"] = random.Real(0.0, 1.0);
      polygon["to"] = random.Real(0.0, 1.0);
    }
  }
}

/** The ends too, where families degenerate. */
void DrawSweep(RandomNumbers& random, Json& study)
{
  Json values = Json::array();
  for (int i = 0; i < 2; ++i)
  {
    values.push_back(random.OneIn(8) ? 1.0 * random.Integer(2) : random.Real(0.0, 1.0));
  }
  study["sweep"] = { { { "parameter", "t" }, { "values", values } } };
}

void DrawArea(RandomNumbers& random, Json& study)
{
  const int rule = random.Integer(4);
  if (rule == 0)
  {
    study["mesh"]["max-area"] = { { "rule", "none" } };
  }
  else if (rule == 1)
  {
    study["mesh"]["max-area"] = { { "rule", "constant" }, { "value", random.Real(0.002, 0.2) } };
  }
  else if (rule == 2)
  {
    study["mesh"]["max-area"] = { { "rule", "diagonal" } };
  }
}

/** The shortest edge of most families asks for millions of triangles: this rule has its own
 * polygon. */
void DrawShortestEdge(RandomNumbers& random, Json& study)
{
  if (random.OneIn(8))
  {
    study["polygons"] = { { { "family", "n-sided" }, { "name", "piece-0" },
      { "sides", 4 + random.Integer(8) }, { "scale", random.Real(0.5, 1.5) } } };
    study["mesh"]["max-area"] = { { "rule", "shortest-edge" } };
  }
}

void DrawAngle(RandomNumbers& random, Json& study)
{
  study["mesh"]["min-angle"] = random.OneIn(6) ? 0.0 : random.Real(0.0, 30.0);
}

void DrawPreserve(RandomNumbers& random, Json& study)
{
  study["mesh"]["preserve-polygons"] = random.OneIn(3);
}

struct Draw
{
  const char* Name;
  void (*Function)(RandomNumbers& random, Json& study);
};

/** To add one: a function that sets keys, and an entry here; each draws numbers of its own, so
 * that an entry more leaves what the others draw as it was. */
constexpr std::array Draws = {
  Draw{ "polygons", DrawPolygons },
  Draw{ "counts", DrawCounts },
  Draw{ "rotations", DrawRotations },
  Draw{ "ranges", DrawRanges },
  Draw{ "sweep", DrawSweep },
  Draw{ "area", DrawArea },
  Draw{ "shortest edge", DrawShortestEdge },
  Draw{ "angle", DrawAngle },
  Draw{ "preserve", DrawPreserve },
};

/** FNV-1a (G. Fowler, L. C. Noll, K.-P. Vo): the same everywhere, unlike std::hash. */
std::uint64_t HashOf(const std::string& text)
{
  std::uint64_t hash = 14695981039346656037U;
  for (const char letter : text)
  {
    hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211U;
  }
  return hash;
}

} // namespace

nlohmann::ordered_json DrawStudy(std::uint64_t seed)
{
  Json study = { { "pemesh", 1 }, { "name", "random" } };
  for (const Draw& draw : Draws)
  {
    RandomNumbers random(HashOf(draw.Name) ^ (seed * 0x9E3779B97F4A7C15U));
    draw.Function(random, study);
  }
  return study;
}
