// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyFields.h"

#include "MeshFormats.h"

#include <set>

namespace pemesh
{

namespace
{

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
  Field<Study> field{ "pemesh", "the number " + std::to_string(StudyVersion),
    "Version of the document.",
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
    [](const Study& study) { return JsonValue{ std::int64_t{ study.Version } }; } };
  return std::move(field).Required();
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
    study.Mesh.Source = "files";
  };
  field.Write = [](const Study& study)
  { return HasMeshFiles(study) ? std::optional(WriteTexts(study.Meshes)) : std::nullopt; };
  return field;
}

void CheckSource(const DocumentPlace& place, const Study& study)
{
  const bool placesPolygons = !study.Polygons.empty() || study.Scatter;
  if (placesPolygons && !IsTriangulated(study.Mesh))
  {
    place.Member("mesh").Member("source").Fail("is \"" + study.Mesh.Source +
      "\", which takes no polygons; leave them out, or use the source triangulation.");
  }
}

} // namespace

const FieldTable<Study>& StudyFields()
{
  static const FieldTable<Study> table = []
  {
    const auto makesMeshes = [](const Study& study) { return !HasMeshFiles(study); };
    const std::string which = "a study that makes its meshes, not of mesh files";
    FieldTable<Study> result;
    Field<Study> meshes = MeshesField();
    result.Fields = { VersionField(),
      TextField("written-by", &Study::WrittenBy, "The program that wrote the document."),
      NameField(), std::move(meshes),
      ObjectField("domain", &Study::Domain, DomainFields(), "The region that is meshed.")
        .Only(makesMeshes, which),
      PolygonsField().Only(makesMeshes, which), ScatterField().Only(makesMeshes, which),
      ListField("sweep", &Study::Sweep, SweepFields(), "What changes from mesh to mesh."),
      ObjectField("mesh", &Study::Mesh, MeshFields(), "How the meshes are made."), MetricsField(),
      ListField("solvers", &Study::Solvers, SolverFields(), "Runs of solvers on every mesh."),
      ObjectField(
        "statistics", &Study::Statistics, StatisticsFields(), "How the results are correlated."),
      StudyStyleField(), ListField("plots", &Study::Plots, PlotFields(), "The figures."),
      ObjectField("output", &Study::Output, OutputFields(), "What is written.") };
    result.Finish = [](const DocumentPlace& place, Study& study)
    {
      CheckSource(place, study);
      FinishSweeps(place, study);
      NameRuns(place, study);
      FinishPlots(place, study);
    };
    return result;
  }();
  return table;
}

} // namespace pemesh
