// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DocumentPath.h"
#include "PolygonFamilies.h"
#include "StudyFields.h"
#include "StudySweeps.h"

#include <cmath>
#include <limits>
#include <set>

namespace pemesh
{

namespace
{

constexpr double NotGiven = std::numeric_limits<double>::quiet_NaN();

/** The parts of a document that a case depends on. */
const std::vector<std::string> SweptParts{ "domain", "polygons", "scatter", "mesh", "solvers" };

/** Columns that every table of results has. */
const std::set<std::string> TakenNames{ "Index", "Mesh", "Elements", "Vertices", "MeshSize",
  "Status" };

bool IsDeformation(const StudySweep& sweep)
{
  return sweep.Parameter == DeformationParameter;
}

Field<StudySweep> ParameterField()
{
  Field<StudySweep> field = TextField("parameter", &StudySweep::Parameter,
    "What is swept: t, the deformation of the polygons, or the path of any number, text or truth "
    "value in domain, polygons, scatter, mesh or solvers, as in \"mesh.min-angle\", "
    "\"solvers[0].order\" or, for every polygon, \"polygons[*].scale\".");
  field.Read = [](const JsonValue& json, const DocumentPlace& place, StudySweep& sweep)
  {
    sweep.Parameter = ReadText(json, place);
    if (IsDeformation(sweep))
    {
      return;
    }
    const std::string first = SplitDocumentPath(sweep.Parameter).front();
    if (std::find(SweptParts.begin(), SweptParts.end(), first) == SweptParts.end())
    {
      place.Fail("is \"" + sweep.Parameter + "\", which cannot be swept; sweep t, or a value by " +
        "its path, such as \"mesh.min-angle\" (it begins with " + ShowChoices(SweptParts) + ").");
    }
    sweep.From = NotGiven;
    sweep.To = NotGiven;
  };
  return field;
}

StudyScalar ReadScalar(const JsonValue& json, const DocumentPlace& place)
{
  if (json.As<bool>())
  {
    return *json.As<bool>();
  }
  if (json.As<std::string>())
  {
    return *json.As<std::string>();
  }
  return ReadNumber(json, place, {});
}

Field<StudySweep> ValuesField()
{
  return { "values", "list of numbers, texts or truth values",
    "The values themselves, in place of from, to and count.",
    [](const JsonValue& json, const DocumentPlace& place, StudySweep& sweep)
    {
      for (const JsonValue& item : ReadList(json, place))
      {
        const DocumentPlace where = place.Item(sweep.Values.size());
        sweep.Values.push_back(
          IsDeformation(sweep) ? ReadNumber(item, where, { 0.0, 1.0 }) : ReadScalar(item, where));
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
        const auto* number = std::get_if<double>(&value);
        list.push_back(number ? JsonNumber(*number)
                              : std::visit([](const auto& of) { return JsonValue{ of }; }, value));
      }
      return JsonValue{ std::move(list) };
    } };
}

void CheckRange(const DocumentPlace& place, StudySweep& sweep)
{
  const NumberRange range = IsDeformation(sweep) ? NumberRange{ 0.0, 1.0 } : NumberRange{};
  for (const auto& [key, value] : { std::pair("from", sweep.From), std::pair("to", sweep.To) })
  {
    if (std::isnan(value))
    {
      place.Member(key).Fail("is missing (number): give from and to, or values.");
    }
    ReadNumber(JsonNumber(value), place.Member(key), range);
  }
  if (IsDeformation(sweep) && sweep.From > sweep.To)
  {
    place.Member("from").Fail("is " + FormatNumber(sweep.From) + ", which is more than to, " +
      FormatNumber(sweep.To) + ".");
  }
  if (sweep.Spacing == "geometric" && !(sweep.From * sweep.To > 0.0))
  {
    place.Member("spacing").Fail(
      "is \"geometric\", which needs from and to of one sign and not zero.");
  }
}

/** The last key of the path, or all of it where another column has that name. */
std::string NameOfSweep(const StudySweep& sweep, const std::set<std::string>& taken)
{
  const std::string last = SplitDocumentPath(sweep.Parameter).back();
  return taken.count(last) || TakenNames.count(last) ? sweep.Parameter : last;
}

void NameSweeps(const DocumentPlace& place, Study& study)
{
  std::set<std::string> names;
  std::set<std::string> parameters;
  for (std::size_t i = 0; i < study.Sweep.size(); ++i)
  {
    StudySweep& sweep = study.Sweep[i];
    const DocumentPlace where = place.Member("sweep").Item(i);
    if (!parameters.insert(sweep.Parameter).second)
    {
      where.Member("parameter").Fail("is \"" + sweep.Parameter + "\", which is swept already.");
    }
    if (IsDeformation(sweep) && HasMeshFiles(study))
    {
      where.Member("parameter")
        .Fail("is \"t\", the deformation of polygons; mesh files have none.");
    }
    sweep.Name = sweep.Name.empty() ? NameOfSweep(sweep, names) : sweep.Name;
    if (TakenNames.count(sweep.Name) || !names.insert(sweep.Name).second)
    {
      where.Member("name").Fail(
        "is \"" + sweep.Name + "\", the name of another column of the results.");
    }
  }
}

} // namespace

StudySweep UndecidedSweep()
{
  StudySweep sweep;
  sweep.Parameter.clear();
  return sweep;
}

FieldTable<StudySweep> SweepFields()
{
  const auto isEquidistant = [](const StudySweep& sweep) { return sweep.Values.empty(); };
  const std::string which = "a sweep without values";
  FieldTable<StudySweep> table;
  table.Fields = { ParameterField(),
    TextField("name", &StudySweep::Name,
      "Of its column in the results; by default the last key of its path."),
    ValuesField(),
    NumberField("from", &StudySweep::From, {}, "The first value; by default only of t.")
      .Only(isEquidistant, which),
    NumberField("to", &StudySweep::To, {}, "The last value; by default only of t.")
      .Only(isEquidistant, which),
    IntegerField("count", &StudySweep::Count, 1, MostCases, "How many values.")
      .Only(isEquidistant, which),
    ChoiceField("spacing", &StudySweep::Spacing, { "linear", "geometric" },
      "Whether neighbouring values have equal differences or equal ratios.")
      .Only(isEquidistant, which),
    BooleanField("zip", &StudySweep::Zip,
      "Whether it advances together with the sweep before it, value by value, instead of running "
      "through all its values for each value of that.") };
  table.Finish = [isEquidistant](const DocumentPlace& place, StudySweep& sweep)
  {
    if (isEquidistant(sweep))
    {
      CheckRange(place, sweep);
    }
    else
    {
      sweep.From = StudySweep().From; // not used, but no NaN: studies are compared
      sweep.To = StudySweep().To;
    }
  };
  return table;
}

void FinishSweeps(const DocumentPlace& place, Study& study)
{
  if (study.Sweep == std::vector{ UndecidedSweep() })
  {
    const auto changes = [](const StudyPolygon& polygon)
    { return polygon.From != polygon.To && !FindPolygonFamily(polygon.Family)->IsFixed(); };
    const bool any = std::any_of(study.Polygons.begin(), study.Polygons.end(), changes) ||
      (study.Scatter && study.Scatter->From != study.Scatter->To);
    study.Sweep.resize(any ? 1 : 0);
    std::fill(study.Sweep.begin(), study.Sweep.end(), StudySweep());
  }
  NameSweeps(place, study);
  double cases = 1.0;
  std::size_t length = 0; // of the sweep before
  for (std::size_t i = 0; i < study.Sweep.size(); ++i)
  {
    const StudySweep& sweep = study.Sweep[i];
    const DocumentPlace where = place.Member("sweep").Item(i);
    const std::size_t count =
      sweep.Values.empty() ? static_cast<std::size_t>(sweep.Count) : sweep.Values.size();
    if (sweep.Zip && (i == 0 || count != length))
    {
      where.Member("zip").Fail(i == 0 ? "is true, but there is no sweep before it to advance with."
                                      : "is true, but it has " + std::to_string(count) +
            " values and the sweep before it " + std::to_string(length) + ".");
    }
    cases *= sweep.Zip ? 1.0 : static_cast<double>(count);
    length = count;
  }
  if (cases > MostCases)
  {
    place.Member("sweep").Fail("makes " + FormatNumber(cases) + " meshes, more than " +
      std::to_string(MostCases) + "; sweep fewer values.");
  }
}

} // namespace pemesh
