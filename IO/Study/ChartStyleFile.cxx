// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartStyleFile.h"

#include "ChartStyle.h"
#include "SettingJson.h"
#include "Study.h"
#include "TextFile.h"

#include <vector>

namespace pemesh
{

namespace
{

constexpr const char* From = "from"; // the key that names another style

} // namespace

std::string ScalarText(const JsonValue& json, const DocumentPlace& place)
{
  if (json.As<std::string>())
  {
    return *json.As<std::string>();
  }
  if (!json.IsNumber() && !json.As<bool>())
  {
    place.Fail("is " + ShowValue(json) + " where a text, a number, true or false is expected.");
  }
  return FormatJsonCompact(json);
}

void FailSetting(const DocumentPlace& place, const std::string& message)
{
  // "The setting NAME is …": the place has the name already.
  const std::size_t start = message.find(" is ");
  place.Fail(start == std::string::npos ? message : message.substr(start + 1));
}

std::map<std::string, std::string> ReadStyleKeys(
  const JsonValue& json, const DocumentPlace& place, std::string& file)
{
  const auto* object = json.As<JsonValue::Object>();
  if (!object)
  {
    place.Fail("is " + ShowValue(json) + " where the name of a file or an object is expected.");
  }
  std::vector<std::string> known{ From };
  for (const SettingField<ChartStyle>& field : ChartStyleFields())
  {
    known.push_back(field.Name);
  }
  std::map<std::string, std::string> keys;
  for (const JsonMember& member : *object)
  {
    const DocumentPlace at = place.Member(member.Key);
    const auto* field = FindSetting(ChartStyleFields(), member.Key);
    if (member.Key == From)
    {
      file = ReadText(member.Value, at);
    }
    else if (!field)
    {
      at.Fail("is not a key; did you mean " + NearestWord(member.Key, known) + "?");
    }
    else
    {
      ChartStyle tried;
      keys[member.Key] = ReadSettingJson(ChartStyleFields(), *field, member.Value, at, tried);
    }
  }
  return keys;
}

std::optional<JsonValue> WriteStyleKeys(
  const std::map<std::string, std::string>& keys, const std::string& file)
{
  if (keys.empty())
  {
    return file.empty() ? std::nullopt : std::optional(JsonValue{ file });
  }
  JsonValue::Object object;
  if (!file.empty())
  {
    object.push_back({ From, JsonValue{ file } });
  }
  for (const SettingField<ChartStyle>& field : ChartStyleFields())
  {
    const auto found = keys.find(field.Name);
    if (found != keys.end())
    {
      object.push_back({ field.Name, SettingToJson(field, found->second) });
    }
  }
  return JsonValue{ std::move(object) };
}

namespace
{

using Settings = std::map<std::string, std::string>;

Settings ReadSettings(const std::filesystem::path& path)
{
  const DocumentPlace place(path.string());
  std::string from;
  Settings settings = ReadStyleKeys(ParseJson(ReadTextFile(path), path.string()), place, from);
  if (!from.empty())
  {
    place.Member(From).Fail("is for the styles of studies and plots: a file holds a whole style.");
  }
  return settings;
}

void Apply(const Settings& settings, ChartStyle& style)
{
  for (const auto& [name, value] : settings)
  {
    SetSetting(ChartStyleFields(), style, name, value);
  }
}

} // namespace

ChartStyle MakeChartStyle(
  const std::filesystem::path& folder, const std::vector<StudyStyle>& styles)
{
  ChartStyle style;
  for (const StudyStyle& each : styles)
  {
    if (!each.File.empty())
    {
      Apply(ReadSettings(folder / each.File), style);
    }
    Apply(each.Settings, style);
  }
  return style;
}

ChartStyle ReadChartStyleFile(const std::filesystem::path& path)
{
  ChartStyle style;
  Apply(ReadSettings(path), style);
  return style;
}

void WriteChartStyleFile(const std::filesystem::path& path, const ChartStyle& style)
{
  const ChartStyle standard;
  std::map<std::string, std::string> keys;
  for (const SettingField<ChartStyle>& field : ChartStyleFields())
  {
    if (GetSetting(field, style) != GetSetting(field, standard))
    {
      keys[field.Name] = GetSetting(field, style);
    }
  }
  const auto json = WriteStyleKeys(keys, "");
  WriteTextFile(path, FormatJson(json ? *json : JsonValue{ JsonValue::Object() }));
}

} // namespace pemesh
