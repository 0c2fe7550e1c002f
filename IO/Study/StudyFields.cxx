// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyFields.h"

#include "AreaRules.h"
#include "MeshFormats.h"
#include "MetricRegistry.h"

#include <set>

namespace pemesh
{

namespace
{

constexpr const char* AllMetrics = "all";

// --- sweep ---------------------------------------------------------------------------------------

Field<StudySweep> ParameterField()
{
  Field<StudySweep> field =
    TextField("parameter", &StudySweep::Parameter, "What is swept: t, the deformation.");
  field.Read = [](const JsonValue& json, const DocumentPlace& place, StudySweep& sweep)
  {
    sweep.Parameter = ReadText(json, place);
    if (sweep.Parameter != "t")
    {
      place.Fail("is \"" + sweep.Parameter +
        "\"; only \"t\", the deformation of the polygons, can be swept so far.");
    }
  };
  return field;
}

Field<StudySweep> ValuesField()
{
  return { "values", "list of numbers between 0 and 1",
    "The values themselves, in place of from, to and count.",
    [](const JsonValue& json, const DocumentPlace& place, StudySweep& sweep)
    {
      for (const JsonValue& item : ReadList(json, place))
      {
        sweep.Values.emplace_back(ReadNumber(item, place.Item(sweep.Values.size()), { 0.0, 1.0 }));
      }
      if (sweep.Values.empty())
      {
        place.Fail("is empty: give at least one value.");
      }
    },
    [](const StudySweep& sweep) -> std::optional<JsonValue>
    {
      if (sweep.Values.empty())
      {
        return std::nullopt;
      }
      JsonValue::List list;
      for (const StudyScalar& value : sweep.Values)
      {
        list.push_back(JsonNumber(ScalarToNumber(value)));
      }
      return JsonValue{ std::move(list) };
    } };
}

FieldTable<StudySweep> SweepFields()
{
  const auto isEquidistant = [](const StudySweep& sweep) { return sweep.Values.empty(); };
  const std::string which = "a sweep without values";
  FieldTable<StudySweep> table;
  table.Fields = { ParameterField(), ValuesField(),
    NumberField("from", &StudySweep::From, { 0.0, 1.0 }, "The first value.")
      .Only(isEquidistant, which),
    NumberField("to", &StudySweep::To, { 0.0, 1.0 }, "The last value.").Only(isEquidistant, which),
    IntegerField("count", &StudySweep::Count, 1, MostCases, "How many equidistant values.")
      .Only(isEquidistant, which) };
  table.Finish = [](const DocumentPlace& place, StudySweep& sweep)
  {
    if (sweep.From > sweep.To)
    {
      place.Member("from").Fail("is " + FormatNumber(sweep.From) + ", which is more than to, " +
        FormatNumber(sweep.To) + ".");
    }
  };
  return table;
}

void CheckSweeps(const DocumentPlace& place, const Study& study)
{
  std::set<std::string> seen;
  for (std::size_t i = 0; i < study.Sweep.size(); ++i)
  {
    const std::string& parameter = study.Sweep[i].Parameter;
    if (!seen.insert(parameter).second)
    {
      place.Member("sweep")
        .Item(i)
        .Member("parameter")
        .Fail("is \"" + parameter + "\", which is swept already.");
    }
  }
}

// --- mesh ----------------------------------------------------------------------------------------

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

FieldTable<StudyMesh> MeshFields()
{
  FieldTable<StudyMesh> table;
  table.Fields = { ObjectField("max-area", &StudyMesh::MaximumArea, MaximumAreaFields(),
                     "Bound on the area of the triangles."),
    NumberField("min-angle", &StudyMesh::MinimumAngle, { 0.0, 33.0 },
      "Degrees; above 33 refinement may never end."),
    BooleanField("preserve-polygons", &StudyMesh::PreservePolygons,
      "Whether the edges of the polygons may not be split.") };
  return table;
}

// --- metrics -------------------------------------------------------------------------------------

Field<Study> MetricsField()
{
  return { "metrics", "\"all\" or list of metrics", "Which metrics are computed.",
    [](const JsonValue& json, const DocumentPlace& place, Study& study)
    {
      study.Metrics.reset();
      const auto* word = json.As<std::string>();
      if (word && *word == AllMetrics)
      {
        return;
      }
      study.Metrics = ReadTexts(json, place);
      std::set<std::string> seen;
      for (const std::string& name : *study.Metrics)
      {
        if (!FindMetric(name))
        {
          place.Fail("names \"" + name + "\", which is no metric; did you mean \"" +
            NearestWord(name, NamesOf(Metrics())) + "\"?");
        }
        if (!seen.insert(name).second)
        {
          place.Fail("names \"" + name + "\" twice.");
        }
      }
    },
    [](const Study& study) {
      return study.Metrics ? WriteTextList(*study.Metrics) : JsonValue{ std::string(AllMetrics) };
    } };
}

// --- the whole document --------------------------------------------------------------------------

FieldTable<StudyOutput> OutputFields()
{
  FieldTable<StudyOutput> table;
  Field<StudyOutput> formats = TextsField("formats", &StudyOutput::Formats,
    "The formats in which every mesh is written: " + ShowChoices(NamesOf(MeshFormats())) + ".");
  formats.Write = [](const StudyOutput& output) { return WriteTextList(output.Formats); };
  table.Fields = { std::move(formats) };
  table.Finish = [](const DocumentPlace& place, StudyOutput& output)
  {
    std::set<std::string> seen;
    const DocumentPlace where = place.Member("formats");
    for (const std::string& name : output.Formats)
    {
      ReadChoice({ name }, where, NamesOf(MeshFormats()));
      if (!seen.insert(name).second)
      {
        where.Fail("names \"" + name + "\" twice.");
      }
    }
  };
  return table;
}

Field<Study> VersionField()
{
  return { "pemesh", "the number " + std::to_string(StudyVersion), "Version of the document.",
    [](const JsonValue& json, const DocumentPlace& place, Study& study)
    {
      const double version = ReadNumber(json, place, {});
      if (version != StudyVersion)
      {
        place.Fail("is " + ShowValue(json) + ", a version of the document that this program does " +
          "not know; it reads version " + std::to_string(StudyVersion) + ".");
      }
      study.Version = StudyVersion;
    },
    [](const Study& study) { return JsonValue{ std::int64_t{ study.Version } }; }, {}, true };
}

Field<Study> NameField()
{
  Field<Study> field = TextField("name", &Study::Name,
    "Of the study and of the folder of its results; by default that of the file.");
  field.Read = [](const JsonValue& json, const DocumentPlace& place, Study& study)
  {
    study.Name = ReadText(json, place);
    CheckFileName(place, study.Name);
  };
  return field;
}

Field<Study> MeshesField()
{
  Field<Study> field = TextsField("meshes", &Study::Meshes,
    "Mesh files and patterns with * and ?, relative to the study, in place of polygons.");
  field.Read = [](const JsonValue& json, const DocumentPlace& place, Study& study)
  {
    study.Meshes = ReadTexts(json, place);
    if (study.Meshes.empty() ||
      std::find(study.Meshes.begin(), study.Meshes.end(), "") != study.Meshes.end())
    {
      place.Fail("is " + ShowValue(json) + ": name files, or a pattern such as \"folder/*.off\".");
    }
  };
  field.Write = [](const Study& study)
  { return HasMeshFiles(study) ? std::optional(WriteTexts(study.Meshes)) : std::nullopt; };
  return field;
}

} // namespace

const FieldTable<Study>& StudyFields()
{
  static const FieldTable<Study> table = []
  {
    const auto makesMeshes = [](const Study& study) { return !HasMeshFiles(study); };
    const std::string which = "a study with polygons, not with mesh files";
    FieldTable<Study> result;
    Field<Study> meshes = MeshesField();
    result.Fields = { VersionField(),
      TextField("written-by", &Study::WrittenBy, "The program that wrote the document."),
      NameField(), std::move(meshes), PolygonsField().Only(makesMeshes, which),
      ScatterField().Only(makesMeshes, which),
      ListField("sweep", &Study::Sweep, SweepFields(), "What changes from mesh to mesh.")
        .Only(makesMeshes, which),
      ObjectField("mesh", &Study::Mesh, MeshFields(), "How the domain around them is meshed.")
        .Only(makesMeshes, which),
      MetricsField(),
      ListField("solvers", &Study::Solvers, SolverFields(), "Runs of solvers on every mesh."),
      ListField("plots", &Study::Plots, PlotFields(), "The figures."),
      ObjectField("output", &Study::Output, OutputFields(), "What is written.") };
    result.Finish = [](const DocumentPlace& place, Study& study)
    {
      CheckSweeps(place, study);
      NameRuns(place, study);
      FinishPlots(place, study);
    };
    return result;
  }();
  return table;
}

} // namespace pemesh
