// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyFields.h"

#include "PolygonFamilies.h"

#include <map>

namespace pemesh
{

namespace
{

Field<StudyPolygon> FamilyField()
{
  return ChoiceField(
    "family", &StudyPolygon::Family, NamesOf(PolygonFamilies()), "Family of the polygon.")
    .Required();
}

Field<StudyPolygon> CenterField()
{
  return { "center", "[x, y], each between 0 and 1",
    "Where the middle of its bounding box goes in the domain, the unit square.",
    [](const JsonValue& json, const DocumentPlace& place, StudyPolygon& polygon)
    {
      const JsonValue::List& list = ReadList(json, place);
      if (list.size() != 2)
      {
        place.Fail("is " + ShowValue(json) + " where two numbers [x, y] are expected.");
      }
      for (std::size_t i = 0; i < 2; ++i)
      {
        polygon.Center[i] = ReadNumber(list[i], place.Item(i), { 0.0, 1.0 });
      }
    },
    [](const StudyPolygon& polygon)
    {
      return JsonValue{ JsonValue::List{
        JsonNumber(polygon.Center[0]), JsonNumber(polygon.Center[1]) } };
    } };
}

bool Counts(const StudyPolygon& polygon, const std::string& countName)
{
  const PolygonFamily* family = FindPolygonFamily(polygon.Family);
  return family && family->CountName && countName == family->CountName;
}

/** One key for every count name of the table of families: teeth, sides, spikes. */
std::vector<Field<StudyPolygon>> CountFields()
{
  std::map<std::string, std::string> families; // by count name
  for (const PolygonFamily& family : PolygonFamilies())
  {
    if (family.CountName)
    {
      std::string& names = families[family.CountName];
      names += (names.empty() ? "the family " : ", ") + std::string(family.Name);
    }
  }
  std::vector<Field<StudyPolygon>> fields;
  for (const auto& [countName, names] : families)
  {
    const std::string name = countName;
    Field<StudyPolygon> field = IntegerField(name, &StudyPolygon::Count, 1, MaximumPolygonCount,
      "How many it has at t = 1; by default the family's own number.");
    field.Write = [](const StudyPolygon& polygon)
    {
      return polygon.Count > 0 ? std::optional(JsonValue{ std::int64_t{ polygon.Count } })
                               : std::nullopt;
    };
    const auto applies = [name](const StudyPolygon& polygon) { return Counts(polygon, name); };
    fields.push_back(std::move(field).Only(applies, names));
  }
  return fields;
}

void FinishPolygon(const DocumentPlace& place, StudyPolygon& polygon)
{
  const PolygonFamily* family = FindPolygonFamily(polygon.Family);
  if (!family->CountName)
  {
    return;
  }
  if (polygon.Count == 0)
  {
    polygon.Count = family->DefaultCount;
  }
  if (polygon.Count < family->MinimumCount)
  {
    place.Member(family->CountName)
      .Fail("is " + std::to_string(polygon.Count) + "; the family " + polygon.Family +
        " takes at least " + std::to_string(family->MinimumCount) + ".");
  }
}

} // namespace

FieldTable<StudyPolygon> PolygonFields()
{
  FieldTable<StudyPolygon> table;
  table.Fields = { FamilyField(),
    TextField("name", &StudyPolygon::Name, "What messages call it, by default its number."),
    CenterField(),
    NumberField("scale", &StudyPolygon::Scale, { .Least = 0.0, .ExcludesLeast = true },
      "At scale 1 the diagonal of its bounding box, before rotation, is 0.5."),
    NumberField("rotation", &StudyPolygon::Rotation, {}, "Degrees, counter-clockwise.") };
  for (Field<StudyPolygon>& field : CountFields())
  {
    table.Fields.push_back(std::move(field));
  }
  table.Fields.push_back(NumberField(
    "from", &StudyPolygon::From, { 0.0, 1.0 }, "Its own deformation where the swept t is 0."));
  table.Fields.push_back(NumberField(
    "to", &StudyPolygon::To, { 0.0, 1.0 }, "Its own deformation where the swept t is 1."));
  table.Finish = FinishPolygon;
  return table;
}

} // namespace pemesh
