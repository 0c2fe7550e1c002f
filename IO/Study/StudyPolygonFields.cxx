// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ParameterFields.h"
#include "StudyFields.h"

#include "PolygonFamilies.h"
#include "PolygonPlacement.h"
#include "PolygonTable.h"

namespace pemesh
{

namespace
{

constexpr double MostScattered = 100000;
constexpr double MostSeeds = 0x1p53 - 1;

// --- polygons ------------------------------------------------------------------------------------

Field<StudyPolygon> FamilyField()
{
  return ChoiceField(
    "family", &StudyPolygon::Family, NamesOf(PolygonFamilies()), "Family of the polygon.")
    .Required();
}

Field<StudyPolygon> FileField()
{
  Field<StudyPolygon> field = TextField("file", &StudyPolygon::File,
    "File whose first polygon it is, relative to the study: OFF, OBJ, STL, NODE/ELE, VTP, or "
    "points "
    "as csv, txt or xy.");
  field.Read = [](const JsonValue& json, const DocumentPlace& place, StudyPolygon& polygon)
  {
    polygon.File = ReadText(json, place);
    if (polygon.File.empty())
    {
      place.Fail("is empty: name a file.");
    }
  };
  return std::move(field).Required().Only([](const StudyPolygon& polygon)
    { return polygon.Family == FileFamilyName; },
    "the family file");
}

std::array<double, 2> ReadPair(
  const JsonValue& json, const DocumentPlace& place, const NumberRange& range)
{
  const JsonValue::List& list = ReadList(json, place);
  if (list.size() != 2)
  {
    place.Fail("is " + ShowValue(json) + " where two numbers [x, y] are expected.");
  }
  return { ReadNumber(list[0], place.Item(0), range), ReadNumber(list[1], place.Item(1), range) };
}

JsonValue WritePair(const std::array<double, 2>& pair)
{
  return { JsonValue::List{ JsonNumber(pair[0]), JsonNumber(pair[1]) } };
}

/** Stands before center and scale, which by default are those of the points. */
void ReadPoints(const JsonValue& json, const DocumentPlace& place, StudyPolygon& polygon)
{
  std::vector<Point2> points;
  for (const JsonValue& item : ReadList(json, place))
  {
    polygon.Points.push_back(ReadPair(item, place.Item(polygon.Points.size()), {}));
    points.push_back({ polygon.Points.back()[0], polygon.Points.back()[1] });
  }
  if (points.size() < 3)
  {
    place.Fail("has " + std::to_string(points.size()) + " points; a polygon needs three.");
  }
  const PolygonPlace own = PlaceOf(points);
  if (!(own.Scale > 0.0) || !std::isfinite(own.Scale))
  {
    place.Fail("are too near or too far from each other.");
  }
  polygon.Center = { own.Center.x, own.Center.y };
  polygon.Scale = own.Scale;
}

Field<StudyPolygon> PointsField()
{
  Field<StudyPolygon> field{ "points", "list of [x, y]",
    "Its vertices in order. Unless center, scale or rotation say otherwise, they are where it "
    "lies.",
    ReadPoints,
    [](const StudyPolygon& polygon) -> std::optional<JsonValue>
    {
      JsonValue::List list;
      for (const std::array<double, 2>& point : polygon.Points)
      {
        list.push_back(WritePair(point));
      }
      return list.empty() ? std::nullopt : std::optional(JsonValue{ std::move(list) });
    } };
  return std::move(field).Required().Only([](const StudyPolygon& polygon)
    { return polygon.Family == PointsFamilyName; },
    "the family points");
}

Field<StudyPolygon> CenterField()
{
  return { "center", "[x, y]", "Where the middle of its bounding box goes.",
    [](const JsonValue& json, const DocumentPlace& place, StudyPolygon& polygon)
    { polygon.Center = ReadPair(json, place, {}); },
    [](const StudyPolygon& polygon) { return WritePair(polygon.Center); }, {}, {}, false, {}, {},
    [](const StudyPolygon&) { return ValueForm{ ValueForm::Pair }; } };
}

// --- scatter -------------------------------------------------------------------------------------

std::vector<std::string> ScatteredFamilies()
{
  std::vector<std::string> names;
  for (const PolygonFamily& family : PolygonFamilies())
  {
    if (!family.IsFixed())
    {
      names.emplace_back(family.Name);
    }
  }
  return names;
}

Field<StudyScatter> FamiliesField()
{
  Field<StudyScatter> field = TextsField("families", &StudyScatter::Families,
    "Their families, by default all of " + ShowChoices(ScatteredFamilies()) + ".");
  field.Read = [](const JsonValue& json, const DocumentPlace& place, StudyScatter& scatter)
  {
    scatter.Families = ReadTexts(json, place);
    for (const std::string& name : scatter.Families)
    {
      ReadChoice({ name }, place, ScatteredFamilies());
    }
  };
  field.Write = [](const StudyScatter& scatter) { return WriteTextList(scatter.Families); };
  return field;
}

} // namespace

FieldTable<StudyScatter> ScatterFields()
{
  const NumberRange positive{ .Least = 0.0, .ExcludesLeast = true };
  FieldTable<StudyScatter> table;
  table.Fields = { IntegerField("count", &StudyScatter::Count, 1, static_cast<int>(MostScattered),
                     "How many polygons."),
    WholeField("seed", &StudyScatter::Seed, { 0.0, MostSeeds }, "Another number, other polygons."),
    FamiliesField(),
    ChoiceField("order", &StudyScatter::Order, { "cycle", "random" },
      "Whether the families follow one another or are drawn."),
    NumberField("smallest-scale", &StudyScatter::SmallestScale, positive,
      "Scales are drawn between this and largest-scale."),
    NumberField("largest-scale", &StudyScatter::LargestScale, positive, "Not below the smallest."),
    NumberField("largest-rotation", &StudyScatter::LargestRotation, {},
      "Degrees; rotations are drawn from 0 to here."),
    NumberField("gap", &StudyScatter::Gap, { .Least = 0.0 },
      "Least distance between polygons, and to the border, at every t."),
    NumberField("from", &StudyScatter::From, { 0.0, 1.0 }, "Their deformation where t is 0."),
    NumberField("to", &StudyScatter::To, { 0.0, 1.0 }, "Their deformation where t is 1.") };
  table.Finish = [](const DocumentPlace& place, StudyScatter& scatter)
  {
    if (scatter.SmallestScale > scatter.LargestScale)
    {
      place.Member("smallest-scale")
        .Fail("is " + FormatNumber(scatter.SmallestScale) + ", which is more than largest-scale, " +
          FormatNumber(scatter.LargestScale) + ".");
    }
  };
  return table;
}

const FieldTable<StudyPolygon>& PolygonFields()
{
  static const FieldTable<StudyPolygon> fields = []
  {
    FieldTable<StudyPolygon> table;
    const auto deforms = [](const StudyPolygon& polygon)
    {
      const PolygonFamily* family = FindPolygonFamily(polygon.Family);
      return family && !family->IsFixed();
    };
    const std::string which = "families that depend on t";
    table.Fields = { FamilyField(), FileField(),
      TextField("name", &StudyPolygon::Name, "What messages call it, by default its number."),
      PointsField(), CenterField(),
      NumberField("scale", &StudyPolygon::Scale, { .Least = 0.0, .ExcludesLeast = true },
        "At scale 1 the diagonal of its bounding box, before rotation, is 0.5."),
      NumberField("rotation", &StudyPolygon::Rotation, {}, "Degrees, counter-clockwise."),
      NumberField(
        "from", &StudyPolygon::From, { 0.0, 1.0 }, "Its own deformation where the swept t is 0.")
        .Only(deforms, which),
      NumberField(
        "to", &StudyPolygon::To, { 0.0, 1.0 }, "Its own deformation where the swept t is 1.")
        .Only(deforms, which) };
    const std::vector<ParameterizedEntry> families = EntriesOf(PolygonFamilies());
    AppendFields(table,
      ParameterFields<StudyPolygon>(
        families, { &StudyPolygon::Family, &StudyPolygon::Parameters }, "the family"));
    table.Finish = [families](const DocumentPlace&, StudyPolygon& polygon)
    { CompleteParameters(ParametersOf(families, polygon.Family), polygon.Parameters); };
    return table;
  }();
  return fields;
}

Field<Study> PolygonsField()
{
  Field<Study> field = ListField("polygons", &Study::Polygons, PolygonFields(),
    "The placed polygons, or the name of a table of polygons (CSV), relative to the study.");
  field.Type = "list of objects or text";
  field.Read = [readList = field.Read](
                 const JsonValue& json, const DocumentPlace& place, Study& study)
  {
    const auto* file = json.As<std::string>();
    if (!file)
    {
      readList(json, place, study);
      return;
    }
    try
    {
      study.Polygons = ReadPolygonTable(study.Folder / *file);
    }
    catch (const std::exception& error)
    {
      place.Fail(std::string("names a table that cannot be read: ") + error.what());
    }
    const std::filesystem::path folder = std::filesystem::path(*file).parent_path();
    for (StudyPolygon& polygon : study.Polygons)
    {
      if (!polygon.File.empty())
      {
        polygon.File = (folder / polygon.File).lexically_normal().string();
      }
    }
  };
  return field;
}

Field<Study> ScatterField()
{
  const FieldTable<StudyScatter> parts = ScatterFields();
  return { "scatter", "object", "Polygons at random places that never meet, after the placed ones.",
    [parts](const JsonValue& json, const DocumentPlace& place, Study& study)
    { ReadFields(parts, json, place, study.Scatter.emplace()); },
    [parts](const Study& study)
    { return study.Scatter ? std::optional(WriteFields(parts, *study.Scatter)) : std::nullopt; },
    [parts](std::string& text, const std::string& path) { DescribeFields(parts, path, text); } };
}

} // namespace pemesh
