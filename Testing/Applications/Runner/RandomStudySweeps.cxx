// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RandomStudy.h"

#include "AgglomerationRules.h"
#include "DomainShapes.h"
#include "PolygonFamilies.h"
#include "Tessellations.h"

#include <array>
#include <cmath>

namespace
{

using Json = nlohmann::ordered_json;

/** The paths that may be swept in a study, each with two values. */
class Sweepables
{
public:
  Sweepables(RandomNumbers& random, const Json& study)
    : Random(random)
    , Study(study)
  {
    this->AddDomain();
    this->AddPolygons();
    this->AddMesh();
    this->AddAgglomeration();
  }

  /** Takes one out. */
  Json Take()
  {
    const auto place =
      this->List.begin() + this->Random.Integer(static_cast<int>(this->List.size()));
    Json sweep = *place;
    this->List.erase(place);
    return sweep;
  }
  bool IsEmpty() const { return this->List.empty(); }

private:
  void Add(const std::string& path, const Json& values)
  {
    this->List.push_back({ { "parameter", path }, { "values", values } });
  }

  void AddParameters(const std::string& path, std::span<const pemesh::Parameter> parameters)
  {
    for (const pemesh::Parameter& parameter : parameters)
    {
      this->Add(path + parameter.Name,
        { DrawParameter(this->Random, parameter), DrawParameter(this->Random, parameter) });
    }
  }

  void AddDomain()
  {
    const auto& shape = this->Study["domain"]["shape"].get<std::string>();
    const pemesh::DomainShape* entry = pemesh::FindDomainShape(shape);
    const double size = std::sqrt(pemesh::DomainArea(DomainOf(this->Study)));
    const bool isUsual = size > 0.01 && size < 100.0; // else one side might be 1e5 times the other
    if (entry && isUsual)
    {
      this->AddParameters("domain.", entry->Parameters);
    }
  }

  void AddPolygons()
  {
    if (!this->Study.contains("polygons") || this->Study["polygons"].empty())
    {
      return;
    }
    const Json& polygon = this->Study["polygons"][0];
    this->AddParameters(
      "polygons[0].", pemesh::FindPolygonFamily(polygon["family"].get<std::string>())->Parameters);
    this->Add("polygons[*].rotation", { this->Random.Real(0.0, 360.0), 90.0 });
    if (polygon.contains("scale"))
    {
      const double scale = polygon["scale"];
      this->Add("polygons[0].scale", { 0.7 * scale, scale });
    }
    if (this->Study.contains("scatter"))
    {
      this->Add("scatter.seed", { this->Random.Integer(1000), this->Random.Integer(1000) });
      this->Add("scatter.count", { 1, 5 });
    }
  }

  void AddMesh()
  {
    if (!IsTriangulated(this->Study))
    {
      const auto source = this->Study["mesh"]["source"].get<std::string>();
      this->AddParameters(
        "mesh.", pemesh::Tessellations()[pemesh::FindTessellation(source)].Parameters);
      return;
    }
    this->Add("mesh.min-angle", { 0.0, this->Random.Real(0.0, 30.0) });
    this->Add("mesh.preserve-polygons", { false, true });
    this->Add("mesh.preserve-domain", { false, true });
    this->Add("mesh.mirror", { 0, 1 });
  }

  void AddAgglomeration()
  {
    if (!this->Study["mesh"].contains("agglomerate"))
    {
      return;
    }
    const Json& agglomeration = this->Study["mesh"]["agglomerate"];
    this->AddParameters("mesh.agglomerate.",
      pemesh::FindAgglomerationRule(agglomeration["rule"].get<std::string>())->Parameters);
    this->Add("mesh.agglomerate.keep-polygons", { false, true });
    this->Add("mesh.agglomerate.straight-vertices", { "keep", "remove-rounded" });
  }

  RandomNumbers& Random;
  const Json& Study;
  std::vector<Json> List;
};

/** The ends too, where families degenerate. */
Json DeformationSweep(RandomNumbers& random)
{
  Json values = Json::array();
  for (int i = 0; i < 2; ++i)
  {
    values.push_back(random.OneIn(8) ? 1.0 * random.Integer(2) : random.Real(0.0, 1.0));
  }
  return { { "parameter", "t" }, { "values", values } };
}

/** The deformation, another path, or both: zipped, or each with each. */
void DrawSweep(RandomNumbers& random, Json& study)
{
  Sweepables sweepables(random, study);
  const int kind = random.Integer(6);
  study["sweep"] = Json::array();
  if (kind != 0 || sweepables.IsEmpty())
  {
    study["sweep"].push_back(DeformationSweep(random));
  }
  if (kind < 3 && !sweepables.IsEmpty())
  {
    study["sweep"].push_back(sweepables.Take());
    if (kind == 1)
    {
      study["sweep"].back()["zip"] = true;
    }
  }
}

constexpr std::array Draws = { StudyDraw{ "sweep", DrawSweep } };

} // namespace

std::span<const StudyDraw> SweepDraws()
{
  return Draws;
}
