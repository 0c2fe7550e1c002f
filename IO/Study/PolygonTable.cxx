// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonTable.h"

#include "CsvRecords.h"
#include "PolygonFamilies.h"
#include "StudyFields.h"
#include "TextFile.h"

#include <numbers>
#include <set>

namespace pemesh
{

namespace
{

constexpr const char* CenterColumns[] = { "center_x", "center_y" };
constexpr std::string_view Blanks = " \t";

/** The keys of texts, which are never numbers. */
bool IsTextColumn(std::string_view column)
{
  return column == "family" || column == "name" || column == "file";
}

/** All columns that a table may have, in the order in which they are written. */
std::vector<std::string> KnownColumns()
{
  std::vector<std::string> columns;
  for (const Field<StudyPolygon>& field : PolygonFields().Fields)
  {
    if (field.Key == "center")
    {
      columns.insert(columns.end(), std::begin(CenterColumns), std::end(CenterColumns));
    }
    else
    {
      columns.push_back(field.Key);
    }
  }
  return columns;
}

JsonValue ParseField(const std::string& text, const DocumentPlace& place)
{
  const std::optional<double> number = ParseNumber(text);
  if (!number || !std::isfinite(*number))
  {
    place.Fail("is \"" + text + "\" where a number is expected.");
  }
  return JsonNumber(*number);
}

std::vector<std::string> SplitWords(std::string_view text)
{
  std::vector<std::string> words;
  for (std::size_t at = text.find_first_not_of(Blanks); at != std::string_view::npos;)
  {
    const std::size_t end = std::min(text.find_first_of(Blanks, at), text.size());
    words.emplace_back(text.substr(at, end - at));
    at = text.find_first_not_of(Blanks, end);
  }
  return words;
}

/** "x y; x y; x y" as a list of pairs. */
JsonValue ParsePoints(std::string_view text, const DocumentPlace& place)
{
  JsonValue::List points;
  while (!text.empty())
  {
    const std::size_t end = std::min(text.find(';'), text.size());
    JsonValue::List pair;
    for (const std::string& word : SplitWords(text.substr(0, end)))
    {
      pair.push_back(ParseField(word, place.Item(points.size())));
    }
    points.push_back({ std::move(pair) });
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return { std::move(points) };
}

// --- the form with a header
// ------------------------------------------------------------------------

void CheckHeader(const std::vector<std::string>& header, const CsvRecordReader& reader)
{
  const std::vector<std::string> known = KnownColumns();
  std::set<std::string> seen;
  for (const std::string& column : header)
  {
    if (std::find(known.begin(), known.end(), column) == known.end())
    {
      reader.Fail(
        "has the column \"" + column + "\"; did you mean " + NearestWord(column, known) + "?");
    }
    if (!seen.insert(column).second)
    {
      reader.Fail("names the column \"" + column + "\" twice");
    }
  }
  if (seen.count("center_x") != seen.count("center_y"))
  {
    reader.Fail("has one of the columns center_x and center_y without the other");
  }
}

/** The record as the object of a study document; the halves of the centre come together. */
JsonValue::Object ObjectOf(const std::vector<std::string>& header,
  const std::vector<std::string>& fields, const DocumentPlace& place)
{
  JsonValue::Object object;
  JsonValue::List center;
  for (std::size_t i = 0; i < header.size(); ++i)
  {
    const DocumentPlace here = place.Member(header[i]);
    if (fields[i].empty())
    {
      continue;
    }
    if (header[i] == CenterColumns[0] || header[i] == CenterColumns[1])
    {
      const bool isFirst = header[i] == CenterColumns[0];
      center.insert(isFirst ? center.begin() : center.end(), ParseField(fields[i], here));
    }
    else if (header[i] == "points")
    {
      object.push_back({ header[i], ParsePoints(fields[i], here) });
    }
    else
    {
      object.push_back({ header[i],
        IsTextColumn(header[i]) ? JsonValue{ fields[i] } : ParseField(fields[i], here) });
    }
  }
  if (center.size() == 1)
  {
    place.Member("center_x").Fail("or center_y is empty: a center needs both.");
  }
  if (!center.empty())
  {
    object.push_back({ "center", { std::move(center) } });
  }
  return object;
}

std::vector<StudyPolygon> ParseWithHeader(std::string_view text, const std::string& source)
{
  CsvRecordReader reader(text, source);
  std::vector<std::string> header;
  reader.Next(header);
  CheckHeader(header, reader);
  std::vector<StudyPolygon> polygons;
  std::vector<std::string> fields;
  while (reader.Next(fields))
  {
    if (fields.size() != header.size())
    {
      reader.Fail("has " + std::to_string(fields.size()) + " fields where the header has " +
        std::to_string(header.size()));
    }
    const DocumentPlace place = DocumentPlace::Record(source, reader.GetLine());
    ReadFields(
      PolygonFields(), { ObjectOf(header, fields, place) }, place, polygons.emplace_back());
  }
  return polygons;
}

// --- the predecessor's form
// ------------------------------------------------------------------------

/** One line: class file|NONE centre_x centre_y rotation scale. */
StudyPolygon ParseOldLine(const std::vector<std::string>& words, const DocumentPlace& place)
{
  constexpr std::size_t Fewest = 6;
  if (words.size() < Fewest)
  {
    place.Fail("has " + std::to_string(words.size()) +
      " words where a header, or class, file or NONE, centre x, centre y, rotation and scale are "
      "expected.");
  }
  const std::size_t numbers = words.size() - 4; // a path may hold blanks
  std::string file = words[1];
  for (std::size_t i = 2; i < numbers; ++i)
  {
    file += " " + words[i];
  }
  const auto number = [&](std::size_t i, const char* column)
  { return ParseField(words[numbers + i], place.Member(column)); };
  const bool isFile = words[0] == "Random";
  const PolygonFamily* family = FindPolygonFamily(isFile ? FileFamilyName : words[0]);
  if (!family || (family->IsFixed() && !isFile) || (isFile && file == "NONE"))
  {
    place.Member("class").Fail("is " + words[0] +
      (isFile ? " without a file."
              : ", which is none of the classes Comb, Convexity, Isotropy, Maze, N-Sided, Star, "
                "U-Like, Zeta and Random."));
  }
  JsonValue::Object object = { { "family", { std::string(family->Name) } },
    { "center", { JsonValue::List{ number(0, "centre_x"), number(1, "centre_y") } } },
    { "rotation", JsonNumber(number(2, "rotation").ToNumber() * 180.0 / std::numbers::pi) },
    { "scale", number(3, "scale") } };
  if (isFile)
  {
    object.push_back({ "file", { file } });
  }
  StudyPolygon polygon;
  ReadFields(PolygonFields(), { std::move(object) }, place, polygon);
  return polygon;
}

std::vector<StudyPolygon> ParseOldForm(std::string_view text, const std::string& source)
{
  std::vector<StudyPolygon> polygons;
  for (std::size_t line = 1; !text.empty(); ++line)
  {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view content = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!content.empty() && content.back() == '\r')
    {
      content.remove_suffix(1);
    }
    const std::vector<std::string> words = SplitWords(content);
    if (!words.empty())
    {
      polygons.push_back(ParseOldLine(words, DocumentPlace::Record(source, line)));
    }
  }
  return polygons;
}

/** Whether the first record names the column `family`. */
bool HasHeader(std::string_view text, const std::string& source)
{
  CsvRecordReader reader(text, source);
  std::vector<std::string> fields;
  return reader.Next(fields) && std::find(fields.begin(), fields.end(), "family") != fields.end();
}

// --- writing
// ---------------------------------------------------------------------------------------

std::string FieldText(const JsonValue& value)
{
  if (const auto* text = value.As<std::string>())
  {
    return *text;
  }
  const auto* points = value.As<JsonValue::List>();
  if (!points)
  {
    return FormatNumber(value.ToNumber());
  }
  std::string text;
  for (const JsonValue& point : *points)
  {
    const JsonValue::List& pair = *point.As<JsonValue::List>();
    text += (text.empty() ? "" : "; ") + FormatNumber(pair[0].ToNumber()) + " " +
      FormatNumber(pair[1].ToNumber());
  }
  return text;
}

/** The fields of a polygon by their columns; those that it has not are left out. */
std::vector<std::pair<std::string, std::string>> FieldsOf(const StudyPolygon& polygon)
{
  std::vector<std::pair<std::string, std::string>> fields;
  const JsonValue json = WriteFields(PolygonFields(), polygon);
  for (const JsonMember& member : *json.As<JsonValue::Object>())
  {
    if (member.Key == "center")
    {
      const JsonValue::List& center = *member.Value.As<JsonValue::List>();
      fields.emplace_back(CenterColumns[0], FieldText(center[0]));
      fields.emplace_back(CenterColumns[1], FieldText(center[1]));
    }
    else
    {
      fields.emplace_back(member.Key, FieldText(member.Value));
    }
  }
  return fields;
}

} // namespace

std::vector<StudyPolygon> ParsePolygonTable(std::string_view text, const std::string& source)
{
  return HasHeader(text, source) ? ParseWithHeader(text, source) : ParseOldForm(text, source);
}

std::vector<StudyPolygon> ReadPolygonTable(const std::filesystem::path& path)
{
  return ParsePolygonTable(ReadTextFile(path), path.string());
}

std::string FormatPolygonTable(const std::vector<StudyPolygon>& polygons)
{
  std::vector<std::vector<std::pair<std::string, std::string>>> rows;
  std::set<std::string> used = { "family", "file", "name", "center_x", "center_y", "scale",
    "rotation", "from", "to" };
  for (const StudyPolygon& polygon : polygons)
  {
    rows.push_back(FieldsOf(polygon));
    for (const auto& [column, field] : rows.back())
    {
      used.insert(column);
    }
  }
  std::string text;
  std::vector<std::string> columns = KnownColumns();
  std::erase_if(columns, [&](const std::string& column) { return used.count(column) == 0; });
  for (const std::string& column : columns)
  {
    text += (text.empty() ? "" : ",") + column;
  }
  text += "\n";
  for (const auto& row : rows)
  {
    for (std::size_t i = 0; i < columns.size(); ++i)
    {
      text += i > 0 ? "," : "";
      const auto field = std::find_if(
        row.begin(), row.end(), [&](const auto& entry) { return entry.first == columns[i]; });
      AppendCsvField(text, field == row.end() ? "" : field->second);
    }
    text += "\n";
  }
  return text;
}

void WritePolygonTable(const std::filesystem::path& path, const std::vector<StudyPolygon>& polygons)
{
  WriteTextFile(path, FormatPolygonTable(polygons));
}

} // namespace pemesh
