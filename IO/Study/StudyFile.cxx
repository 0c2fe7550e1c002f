// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyFile.h"

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
  if (!FindMember(document, "polygons") && !FindMember(document, "scatter") &&
    !FindMember(document, "meshes"))
  {
    place.Fail("has neither polygons nor meshes: place polygons in the domain, or name mesh "
               "files, for example \"meshes\": \"folder/*.off\".");
  }
}

/** "mesh.min-angle", "polygons[0].scale" and "polygons.0.scale" as a list of keys. */
std::vector<std::string> SplitPath(std::string_view path)
{
  std::vector<std::string> keys(1);
  for (const char c : path)
  {
    if (c == '.' || c == '[')
    {
      keys.emplace_back();
    }
    else if (c != ']')
    {
      keys.back() += c;
    }
  }
  return keys;
}

/** The value behind one more key, made if it is a member that is missing. */
JsonValue& Descend(JsonValue& value, const std::string& key, const std::string& setting)
{
  if (auto* list = value.As<JsonValue::List>())
  {
    const std::optional<long long> index = ParseInteger(key);
    if (!index || *index < 0 || static_cast<std::size_t>(*index) >= list->size())
    {
      throw std::runtime_error("The setting \"" + setting + "\" names item \"" + key +
        "\" of a list of " + std::to_string(list->size()) + ": items count from 0.");
    }
    return (*list)[static_cast<std::size_t>(*index)];
  }
  auto* object = value.As<JsonValue::Object>();
  if (!object)
  {
    throw std::runtime_error("The setting \"" + setting + "\" looks for \"" + key + "\" in " +
      ShowValue(value) + ", which has no members.");
  }
  if (JsonValue* member = FindMember(*object, key))
  {
    return *member;
  }
  return object->emplace_back(JsonMember{ key, { JsonValue::Object() } }).Value;
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
  study.Sweep = { StudySweep() };
  if (document && FindMember(*document, "meshes"))
  {
    study.Sweep.clear();
  }
  ReadFields(StudyFields(), json, place, study);
  // After the keys, because a mistyped one is the likelier slip.
  CheckHasSource(*document, place);
  if (study.Name.empty())
  {
    study.Name = path.stem().string();
  }
  if (study.Polygons.empty() && !study.Scatter && !HasMeshFiles(study) &&
    !FindMember(*document, "sweep"))
  {
    study.Sweep.front().To = 0.0; // nothing deforms
    study.Sweep.front().Count = 1;
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
  const std::vector<std::string> keys = SplitPath(setting.substr(0, equals));
  constexpr std::size_t deepest = 32;
  if (keys.size() > deepest || std::find(keys.begin(), keys.end(), "") != keys.end())
  {
    throw std::runtime_error("The setting \"" + shown +
      "\" has no proper path before the equals sign: write it like mesh.min-angle=25 or "
      "polygons[0].scale=0.5.");
  }
  JsonValue json = ParseJson(text, "study");
  JsonValue* value = &json;
  for (const std::string& key : keys)
  {
    value = &Descend(*value, key, shown);
  }
  *value = ParseSettingValue(setting.substr(equals + 1), shown);
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
  return moved;
}

std::string DescribeStudyKeys()
{
  std::string text;
  DescribeFields(StudyFields(), "", text);
  return text;
}

} // namespace pemesh
