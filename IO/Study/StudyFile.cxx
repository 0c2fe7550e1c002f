// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyFile.h"

#include "DocumentPath.h"
#include "StudyFields.h"
#include "TextFile.h"

namespace pemesh
{

namespace
{

namespace fs = std::filesystem;

/** A study makes its meshes or reads them. */
void CheckSource(const JsonValue::Object& document, const DocumentPlace& place)
{
  const bool hasPolygons = FindMember(document, "polygons");
  const bool hasMeshes = FindMember(document, "meshes");
  if (hasPolygons && hasMeshes)
  {
    place.Fail("has both polygons and meshes: a study makes its meshes or reads them.");
  }
}

void CheckHasSource(const JsonValue::Object& document, const DocumentPlace& place)
{
  const JsonValue* mesh = FindMember(document, "mesh");
  const auto* options = mesh ? mesh->As<JsonValue::Object>() : nullptr;
  if (!FindMember(document, "polygons") && !FindMember(document, "scatter") &&
    !FindMember(document, "meshes") && !(options && FindMember(*options, "source")))
  {
    place.Fail("has neither polygons nor meshes nor mesh.source: place polygons in the domain, "
               "name mesh files, for example \"meshes\": \"folder/*.off\", or a source of meshes, "
               "for example \"mesh\": {\"source\": \"voronoi\"}.");
  }
}

JsonValue ParseSettingValue(std::string_view text, const std::string& setting)
{
  try
  {
    return ParseJson(text, setting);
  }
  catch (const std::runtime_error&)
  {
    return { std::string(text) };
  }
}

/** "metrics": "all" and lists are short for {"names": …}: written out where another key is set. */
void WriteOutMetrics(JsonValue& json, const std::string& path)
{
  auto* document = json.As<JsonValue::Object>();
  JsonValue* metrics = document ? FindMember(*document, "metrics") : nullptr;
  if (metrics && path.starts_with("metrics.") && !metrics->As<JsonValue::Object>())
  {
    *metrics = { JsonValue::Object{ { "names", *metrics } } };
  }
}

/** A path that is relative to one folder, relative to another. */
std::string MovePath(const std::string& path, const fs::path& from, const fs::path& to)
{
  if (fs::path(path).is_absolute())
  {
    return path;
  }
  const auto resolve = [](const fs::path& folder)
  { return fs::weakly_canonical(fs::absolute(folder.empty() ? "." : folder)); };
  return (resolve(from) / path).lexically_normal().lexically_relative(resolve(to)).string();
}

} // namespace

Study ParseStudy(std::string_view text, const fs::path& path)
{
  const DocumentPlace place(path.string());
  const JsonValue json = ParseJson(text, path.string());
  const auto* document = json.As<JsonValue::Object>();
  if (document)
  {
    CheckSource(*document, place);
  }
  Study study;
  study.Folder = path.parent_path();
  study.Sweep = { UndecidedSweep() };
  ReadFields(StudyFields(), json, place, study);
  // After the keys, because a mistyped one is the likelier slip.
  CheckHasSource(*document, place);
  if (study.Name.empty())
  {
    study.Name = path.stem().string();
  }
  return study;
}

Study ReadStudy(const fs::path& path)
{
  return ParseStudy(ReadTextFile(path), path);
}

std::string FormatStudy(const Study& study)
{
  return FormatJson(WriteFields(StudyFields(), study));
}

std::string ApplySetting(std::string_view text, std::string_view setting)
{
  const std::string shown(setting);
  const std::size_t equals = setting.find('=');
  if (equals == std::string_view::npos || equals == 0)
  {
    throw std::runtime_error(
      "The setting \"" + shown + "\" is not PATH=VALUE, for example mesh.min-angle=25.");
  }
  JsonValue json = ParseJson(text, "study");
  WriteOutMetrics(json, shown.substr(0, equals));
  SetAtPath(json, setting.substr(0, equals), ParseSettingValue(setting.substr(equals + 1), shown),
    "The setting \"" + shown + "\"");
  return FormatJson(json);
}

Study MoveStudy(const Study& study, const fs::path& folder)
{
  Study moved = study;
  moved.Folder = folder;
  for (std::string& pattern : moved.Meshes)
  {
    pattern = MovePath(pattern, study.Folder, folder);
  }
  if (!moved.Domain.File.empty())
  {
    moved.Domain.File = MovePath(moved.Domain.File, study.Folder, folder);
  }
  for (StudyPolygon& polygon : moved.Polygons)
  {
    polygon.File =
      polygon.File.empty() ? std::string() : MovePath(polygon.File, study.Folder, folder);
  }
  for (StudySolver& solver : moved.Solvers)
  {
    if (fs::path(solver.Solver).extension() == ".json")
    {
      solver.Solver = MovePath(solver.Solver, study.Folder, folder);
    }
  }
  const auto moveStyle = [&](StudyStyle& style)
  { style.File = style.File.empty() ? style.File : MovePath(style.File, study.Folder, folder); };
  moveStyle(moved.Style);
  for (StudyPlot& plot : moved.Plots)
  {
    moveStyle(plot.Style);
  }
  return moved;
}

std::string DescribeStudyKeys()
{
  std::string text;
  DescribeFields(StudyFields(), "", text);
  return text;
}

} // namespace pemesh
