// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "AgglomerationRules.h"
#include "AreaRules.h"
#include "DomainShapes.h"
#include "MetricRegistry.h"
#include "ParameterFields.h"
#include "StraightVertices.h"
#include "StudyFields.h"
#include "Tessellations.h"

namespace pemesh
{

namespace
{

constexpr const char* Triangulation = "triangulation";
constexpr const char* FilesSource = "files";
constexpr const char* FileShape = "file";
constexpr const char* None = "none";
constexpr int MostElements = 700'000'000;

/** `first` where it is not empty, the names of a table, `last` likewise. */
template <typename Table>
std::vector<std::string> ChoicesOf(
  const Table& table, const std::string& first, const std::string& last = {})
{
  std::vector<std::string> names = NamesOf(table);
  if (!first.empty())
  {
    names.insert(names.begin(), first);
  }
  if (!last.empty())
  {
    names.push_back(last);
  }
  return names;
}

// --- max-area, target
// -----------------------------------------------------------------------------

FieldTable<StudyMaximumArea> MaximumAreaFields()
{
  const auto isConstant = [](const StudyMaximumArea& area) { return area.Rule == "constant"; };
  FieldTable<StudyMaximumArea> table;
  table.Fields = { ChoiceField("rule", &StudyMaximumArea::Rule, NamesOf(AreaRules()),
                     "What bounds the area of the triangles around the polygons."),
    NumberField("value", &StudyMaximumArea::Value, { .Least = 0.0, .ExcludesLeast = true },
      "The bound itself.")
      .Required()
      .Only(isConstant, "the rule constant") };
  return table;
}

FieldTable<StudyTarget> TargetFields()
{
  const auto isSet = [](const StudyTarget& target) { return target.Quantity != None; };
  FieldTable<StudyTarget> table;
  table.Fields = { ChoiceField("quantity", &StudyTarget::Quantity,
                     { None, "elements", "vertices", "dofs" },
                     "What every mesh is to have the same number of, within 2 %: the maximum area "
                     "is adjusted. dofs are the unknowns of a virtual element method."),
    IntegerField("value", &StudyTarget::Value, 1, MostElements, "How many.")
      .Required()
      .Only(isSet, "the quantities elements, vertices and dofs"),
    IntegerField("order", &StudyTarget::Order, 1, 20, "Of the method whose unknowns are counted.")
      .Only(
        [](const StudyTarget& target) { return target.Quantity == "dofs"; }, "the quantity dofs") };
  return table;
}

// --- tile, agglomerate
// ----------------------------------------------------------------------------

Field<StudyMesh> TileField()
{
  constexpr int most = 10000;
  return { "tile", "integer or [columns, rows], each between 1 and " + std::to_string(most),
    "Copies of the mesh side by side, scaled to fit the domain's box.",
    [](const JsonValue& json, const DocumentPlace& place, StudyMesh& mesh)
    {
      const auto* list = json.As<JsonValue::List>();
      if (list && list->size() != 2)
      {
        place.Fail("is " + ShowValue(json) + " where two integers [columns, rows] are expected.");
      }
      for (std::size_t i = 0; i < 2; ++i)
      {
        mesh.Tile[i] = list ? ReadInteger((*list)[i], place.Item(i), { 1.0, most })
                            : ReadInteger(json, place, { 1.0, most });
      }
    },
    [](const StudyMesh& mesh)
    {
      return JsonValue{ JsonValue::List{
        { std::int64_t{ mesh.Tile[0] } }, { std::int64_t{ mesh.Tile[1] } } } };
    } };
}

bool Merges(const StudyAgglomeration& agglomeration)
{
  return agglomeration.Rule != None;
}

/** The metrics of "all" that need nothing but the element. */
std::vector<std::string> MetricsOfElements()
{
  std::vector<std::string> names = MetricNames();
  std::erase_if(names, [](const std::string& name) { return !FindElementMetric(name); });
  return names;
}

FieldTable<StudyAgglomeration> AgglomerationFields()
{
  const std::vector<ParameterizedEntry> rules = EntriesOf(AgglomerationRules());
  const std::string which = "rules other than none";
  const auto usesMetric = [](const StudyAgglomeration& agglomeration)
  {
    const AgglomerationRule* rule = FindAgglomerationRule(agglomeration.Rule);
    return rule && rule->Metric != RuleMetric::None;
  };
  FieldTable<StudyAgglomeration> table;
  table.Fields = { ChoiceField("rule", &StudyAgglomeration::Rule,
    ChoicesOf(AgglomerationRules(), None), "Which elements are merged.") };
  AppendFields(table,
    ParameterFields<StudyAgglomeration>(
      rules, { &StudyAgglomeration::Rule, &StudyAgglomeration::Parameters }, "the rule"));
  AppendFields<StudyAgglomeration>(table,
    { ChoiceField("metric", &StudyAgglomeration::Metric, MetricsOfElements(),
        "The metric that the rule goes by; by default the rule's own.")
        .Only(usesMetric, "rules that look at a metric"),
      IntegerField("elements", &StudyAgglomeration::Elements, 0, MostElements,
        "Where to stop; 0: see percentage.")
        .Only(Merges, which),
      NumberField("percentage", &StudyAgglomeration::Percentage, { 0.0, 100.0 },
        "Of the elements, where to stop; 0: what is usual for the rule.")
        .Only(Merges, which),
      BooleanField("keep-polygons", &StudyAgglomeration::KeepPolygons,
        "Whether placed polygons are left alone.")
        .Only(Merges, which),
      ChoiceField("straight-vertices", &StudyAgglomeration::StraightVertices,
        { std::begin(StraightVerticesNames), std::end(StraightVerticesNames) },
        "Whether vertices of two elements that lie on a straight side are removed: those exactly "
        "on it, or those that only rounding keeps off it too.")
        .Only(Merges, which) });
  table.Finish = [rules](const DocumentPlace& place, StudyAgglomeration& agglomeration)
  {
    CompleteParameters(ParametersOf(rules, agglomeration.Rule), agglomeration.Parameters);
    if (agglomeration.Elements > 0 && agglomeration.Percentage > 0.0)
    {
      place.Member("percentage").Fail("and elements are both given; say one of them.");
    }
  };
  return table;
}

Field<StudyMesh> SourceField()
{
  Field<StudyMesh> field = ChoiceField("source", &StudyMesh::Source,
    ChoicesOf(Tessellations(), Triangulation, FilesSource),
    "Where the meshes come from: triangles around the polygons, a tessellation of the domain "
    "without polygons, or mesh files.");
  const auto read = field.Read;
  field.Read = [read](const JsonValue& json, const DocumentPlace& place, StudyMesh& mesh)
  {
    const bool isFiles = mesh.Source == FilesSource; // the study names mesh files
    read(json, place, mesh);
    if (isFiles != (mesh.Source == FilesSource))
    {
      place.Fail("is " + ShowValue(json) +
        ": the source files belongs to a study with meshes, and "
        "no other source does.");
    }
  };
  return field;
}

} // namespace

FieldTable<StudyDomain> DomainFields()
{
  const std::vector<ParameterizedEntry> shapes = EntriesOf(DomainShapes());
  FieldTable<StudyDomain> table;
  table.Fields = { ChoiceField("shape", &StudyDomain::Shape,
    ChoicesOf(DomainShapes(), {}, FileShape),
    "Its shape; of a file the outer loop and the holes.") };
  AppendFields(table,
    ParameterFields<StudyDomain>(
      shapes, { &StudyDomain::Shape, &StudyDomain::Parameters }, "the shape"));
  table.Fields.push_back(
    TextField("file", &StudyDomain::File,
      "A mesh file or a table of points (.csv) that holds the loops, relative to the study.")
      .Required()
      .Only([](const StudyDomain& domain) { return domain.Shape == FileShape; },
        std::string("the shape ") + FileShape));
  table.Finish = [shapes](const DocumentPlace&, StudyDomain& domain)
  { CompleteParameters(ParametersOf(shapes, domain.Shape), domain.Parameters); };
  return table;
}

FieldTable<StudyMesh> MeshFields()
{
  const std::string which = std::string("the source ") + Triangulation;
  FieldTable<StudyMesh> table;
  const std::vector<ParameterizedEntry> sources = EntriesOf(Tessellations());
  table.Fields = { SourceField() };
  AppendFields(table,
    ParameterFields<StudyMesh>(
      sources, { &StudyMesh::Source, &StudyMesh::Parameters }, "the source"));
  AppendFields<StudyMesh>(table,
    { ObjectField("max-area", &StudyMesh::MaximumArea, MaximumAreaFields(),
        "Bound on the area of the triangles.")
        .Only(IsTriangulated, which),
      NumberField("min-angle", &StudyMesh::MinimumAngle, { 0.0, 33.0 },
        "Degrees; above 33 refinement may never end.")
        .Only(IsTriangulated, which),
      BooleanField("preserve-polygons", &StudyMesh::PreservePolygons,
        "Whether the edges of the polygons may not be split.")
        .Only(IsTriangulated, which),
      BooleanField("preserve-domain", &StudyMesh::PreserveDomain,
        "Whether the edges of the domain may not be split.")
        .Only(IsTriangulated, which),
      NumberField("gradation", &StudyMesh::Gradation, { .Least = 0.0 },
        "How fast edges grow with the distance from the polygons; 0: the maximum area alone "
        "counts.")
        .Only(IsTriangulated, which),
      NumberField("size-at-polygons", &StudyMesh::SizeAtPolygons, { .Least = 0.0 },
        "Length of the edges at the polygons, with gradation; 0: that of the polygon's own.")
        .Only(IsTriangulated, which),
      ObjectField("target", &StudyMesh::Target, TargetFields(),
        "Holds a number fixed, so that it does not confound what is swept.")
        .Only(IsTriangulated, which),
      IntegerField("max-elements", &StudyMesh::MaximumElements, 10, MostElements,
        "A mesh that would have more is refused before it fills the memory."),
      IntegerField("mirror", &StudyMesh::Mirror, 0, 12,
        "How often the mesh is reflected in x, in y and in both: four times the elements each."),
      TileField(),
      ObjectField("agglomerate", &StudyMesh::Agglomeration, AgglomerationFields(),
        "Which elements are merged in the end.") });
  table.Finish = [sources](const DocumentPlace&, StudyMesh& mesh)
  { CompleteParameters(ParametersOf(sources, mesh.Source), mesh.Parameters); };
  return table;
}

} // namespace pemesh
