// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RandomStudy.h"

#include "AgglomerationRules.h"
#include "DomainShapes.h"
#include "MetricRegistry.h"
#include "Tessellations.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

using Json = nlohmann::ordered_json;

/** Any shape, of any size; one in six is from a file. */
void DrawDomain(RandomNumbers& random, Json& study)
{
  Json& domain = study["domain"];
  if (random.OneIn(6))
  {
    domain = { { "shape", "file" }, { "file", random.OneIn(2) ? "kite.csv" : "holes.csv" } };
    return;
  }
  const bool isSquare = random.OneIn(2);
  const pemesh::DomainShape& shape =
    isSquare ? pemesh::DomainShapes()[0] : random.AnyOf(pemesh::DomainShapes());
  domain = { { "shape", shape.Name } };
  if (isSquare)
  {
    return;
  }
  DrawParameters(random, shape.Parameters, domain);
  const double factor = random.OneIn(8) ? (random.OneIn(2) ? 1e-5 : 1e5) : 1.0;
  for (const pemesh::Parameter& parameter : shape.Parameters)
  {
    const bool isLength = !parameter.IsInteger && parameter.Greatest > 1e5;
    if (isLength)
    {
      domain[parameter.Name] = factor * domain[parameter.Name].get<double>();
    }
  }
}

/** One in four is a tessellation, without polygons. */
void DrawSource(RandomNumbers& random, Json& study)
{
  study["mesh"] = Json::object();
  if (random.OneIn(4))
  {
    const pemesh::Tessellation& tessellation = random.AnyOf(pemesh::Tessellations());
    study["mesh"]["source"] = tessellation.Name;
    DrawParameters(random, tessellation.Parameters, study["mesh"]);
  }
}

void DrawArea(RandomNumbers& random, Json& study)
{
  const int rule = random.Integer(4);
  Json& area = study["mesh"]["max-area"];
  area = { { "rule", rule == 0 ? "none" : rule == 1 ? "constant" : "diagonal" } };
  if (rule == 1)
  {
    area["value"] = random.Real(0.002, 0.2) * pemesh::DomainArea(DomainOf(study));
  }
}

void DrawAngle(RandomNumbers& random, Json& study)
{
  study["mesh"]["min-angle"] = random.OneIn(6) ? 0.0 : random.Real(0.0, 30.0);
}

void DrawPreserve(RandomNumbers& random, Json& study)
{
  study["mesh"]["preserve-polygons"] = random.OneIn(3);
  study["mesh"]["preserve-domain"] = random.OneIn(4);
}

void DrawGradation(RandomNumbers& random, Json& study)
{
  if (random.OneIn(4))
  {
    study["mesh"]["gradation"] = random.Real(0.1, 1.0);
    study["mesh"]["size-at-polygons"] = random.OneIn(2)
      ? 0.0
      : random.Real(0.02, 0.2) * std::sqrt(pemesh::DomainArea(DomainOf(study)));
  }
}

/** Some are below what the polygons force, or above what merging leaves, and are refused. */
void DrawTarget(RandomNumbers& random, Json& study)
{
  if (random.OneIn(6))
  {
    const int quantity = random.Integer(3);
    Json& target = study["mesh"]["target"];
    target = { { "quantity",
                 quantity == 0     ? "elements"
                   : quantity == 1 ? "vertices"
                                   : "dofs" },
      { "value", 50 + random.Integer(1500) } };
    if (quantity == 2)
    {
      target["order"] = 1 + random.Integer(4);
    }
  }
}

/** What is for triangulations only. */
template <void (*Function)(RandomNumbers&, Json&)>
void IfTriangulated(RandomNumbers& random, Json& study)
{
  if (IsTriangulated(study))
  {
    Function(random, study);
  }
}

void DrawRepetition(RandomNumbers& random, Json& study)
{
  const int kind = random.Integer(10);
  if (kind < 2)
  {
    study["mesh"]["mirror"] = 1 + random.Integer(1 + kind);
  }
  if (kind == 1 || kind == 2)
  {
    study["mesh"]["tile"] = { 1 + random.Integer(3), 1 + random.Integer(3) };
  }
  else if (kind == 3)
  {
    study["mesh"]["tile"] = 2 + random.Integer(2);
  }
}

Json DrawMetric(RandomNumbers& random)
{
  std::string name;
  while (!pemesh::FindElementMetric(name)) // merging cannot go by what an element is to others
  {
    name = random.AnyOf(pemesh::Metrics()).Name;
  }
  return name;
}

/** Any rule, with any way to say where to stop. */
void DrawAgglomeration(RandomNumbers& random, Json& study)
{
  if (!random.OneIn(3))
  {
    return;
  }
  const pemesh::AgglomerationRule& rule = random.AnyOf(pemesh::AgglomerationRules());
  Json merging = { { "rule", rule.Name } };
  DrawParameters(random, rule.Parameters, merging);
  if (rule.Metric == pemesh::RuleMetric::WorstFirst)
  {
    merging["metric"] = rule.DefaultMetric;
  }
  if (rule.Metric == pemesh::RuleMetric::Weight && random.OneIn(2))
  {
    merging["metric"] = DrawMetric(random);
  }
  const int stop = random.Integer(3);
  if (stop == 0)
  {
    merging["elements"] = 1 + random.Integer(200);
  }
  else if (stop == 1)
  {
    merging["percentage"] = random.Real(0.1, 100.0);
  }
  merging["keep-polygons"] = !random.OneIn(4);
  const int straight = random.Integer(3);
  merging["straight-vertices"] = straight == 0 ? "keep"
    : straight == 1                            ? "remove-exact"
                                               : "remove-rounded";
  study["mesh"]["agglomerate"] = merging;
}

constexpr std::array FirstDraws = {
  StudyDraw{ "domain", DrawDomain },
  StudyDraw{ "source", DrawSource },
  StudyDraw{ "area", IfTriangulated<DrawArea> },
};

/** To add one: a function that sets keys, and an entry here or in the tables of the other files;
 * each draws numbers of its own, so that an entry more leaves what the others draw as it was. */
constexpr std::array LastDraws = {
  StudyDraw{ "angle", IfTriangulated<DrawAngle> },
  StudyDraw{ "preserve", IfTriangulated<DrawPreserve> },
  StudyDraw{ "gradation", IfTriangulated<DrawGradation> },
  StudyDraw{ "target", IfTriangulated<DrawTarget> },
  StudyDraw{ "repetition", DrawRepetition },
  StudyDraw{ "agglomeration", DrawAgglomeration },
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

Json DrawInteger(RandomNumbers& random, const pemesh::Parameter& parameter)
{
  const bool isSeed = parameter.Default <= 1.0 && parameter.Greatest > 1e9;
  // Up to the default, which keeps the meshes small.
  const double most = isSeed ? 1000.0 : std::max(parameter.Default, parameter.Least + 1.0);
  const double greatest = std::min(most, parameter.Greatest);
  return static_cast<std::int64_t>(parameter.Least) +
    random.Integer(static_cast<int>(greatest - parameter.Least) + 1);
}

} // namespace

Json DrawParameter(RandomNumbers& random, const pemesh::Parameter& parameter)
{
  if (parameter.IsInteger)
  {
    return DrawInteger(random, parameter);
  }
  const double width = parameter.Greatest - parameter.Least;
  if (width <= 10.0)
  {
    return random.OneIn(8) ? parameter.Least
      : random.OneIn(8)    ? parameter.Greatest
                           : random.Real(parameter.Least, parameter.Greatest);
  }
  if (parameter.Default == 0.0)
  {
    return random.OneIn(2) ? 0.0 : random.Real(0.0, 0.5);
  }
  return std::clamp(
    parameter.Default * std::exp2(random.Real(-2.0, 2.0)), parameter.Least, parameter.Greatest);
}

void DrawParameters(
  RandomNumbers& random, std::span<const pemesh::Parameter> parameters, Json& object)
{
  for (const pemesh::Parameter& parameter : parameters)
  {
    object[parameter.Name] = DrawParameter(random, parameter);
  }
}

pemesh::Domain DomainOf(const Json& study)
{
  const Json& domain = study["domain"];
  const pemesh::DomainShape* shape = pemesh::FindDomainShape(domain["shape"].get<std::string>());
  if (!shape)
  {
    return DomainOfDrawnFile(domain["file"]);
  }
  pemesh::ParameterValues values(shape->Parameters);
  for (const pemesh::Parameter& parameter : shape->Parameters)
  {
    values.Set(parameter.Name, domain.value(parameter.Name, parameter.Default));
  }
  return shape->Make(values);
}

bool IsTriangulated(const Json& study)
{
  return !study["mesh"].contains("source");
}

Json DrawStudy(std::uint64_t seed)
{
  Json study = { { "pemesh", 1 }, { "name", "random" } };
  const std::span<const StudyDraw> tables[] = { FirstDraws, PolygonDraws(), LastDraws,
    SweepDraws() };
  for (const std::span<const StudyDraw>& table : tables)
  {
    for (const StudyDraw& draw : table)
    {
      RandomNumbers random(HashOf(draw.Name) ^ (seed * 0x9E3779B97F4A7C15U));
      draw.Function(random, study);
    }
  }
  return study;
}
