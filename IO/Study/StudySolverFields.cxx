// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverDescriptionFile.h"
#include "StudyFields.h"

#include <set>

namespace pemesh
{

namespace
{

Field<StudySolver> LimitField(const SolverLimit& limit)
{
  const auto member = limit.OfRun;
  return { limit.Key, "number at least 0", limit.Doc + std::string(" By default the solver's."),
    [member](const JsonValue& json, const DocumentPlace& place, StudySolver& solver)
    { solver.*member = ReadNumber(json, place, { .Least = 0.0 }); },
    [member](const StudySolver& solver)
    { return solver.*member ? std::optional(JsonNumber(*(solver.*member))) : std::nullopt; },
    {}, {}, false, {}, {},
    [](const StudySolver&)
    {
      ValueForm form = NumberRange{ .Least = 0.0 }.FormOf(ValueForm::Number);
      form.WhenUnset = "the solver's";
      return form;
    } };
}

/** The order of a run, for its name, or "". */
std::string OrderOf(const StudySolver& solver)
{
  for (const auto& [key, value] : solver.Options)
  {
    if (key == "order")
    {
      return FormatScalar(value);
    }
  }
  return {};
}

/** The name of a file without its folder and ".json", or the name itself. */
std::string StemOf(const std::string& solver)
{
  const std::filesystem::path path(solver);
  return path.extension() == ".json" ? path.stem().string() : solver;
}

} // namespace

void CheckFileName(const DocumentPlace& place, const std::string& name)
{
  const auto isBad = [](char c)
  { return c == '/' || c == '\\' || c == ':' || (c >= 0 && c < ' '); };
  if (name.empty() || name.front() == '.' || std::any_of(name.begin(), name.end(), isBad))
  {
    place.Fail("is \"" + name +
      "\", which cannot name a file or a folder: use letters, digits, hyphens and blanks.");
  }
}

FieldTable<StudySolver> SolverFields()
{
  Field<StudySolver> name = TextField(
    "name", &StudySolver::Name, "Of the run: leads its columns, unique; by default the solver's.");
  name.Read = [](const JsonValue& json, const DocumentPlace& place, StudySolver& solver)
  {
    solver.Name = ReadText(json, place);
    CheckFileName(place, solver.Name);
  };
  FieldTable<StudySolver> table;
  table.Fields = { TextField("solver", &StudySolver::Solver,
                     "Name of a solver, or the .json file that describes one. Further keys are "
                     "the solver's own options.")
                     .Required(),
    std::move(name),
    TextField("version", &StudySolver::Version, "What the solver said of itself when it ran.") };
  for (const SolverLimit& limit : SolverLimits())
  {
    table.Fields.push_back(LimitField(limit));
  }
  table.ReadOther = [](const std::string& key, const JsonValue& json, const DocumentPlace& place,
                      StudySolver& solver)
  {
    StudyScalar value;
    if (json.As<bool>())
    {
      value = *json.As<bool>();
    }
    else if (json.As<std::int64_t>())
    {
      value = *json.As<std::int64_t>();
    }
    else if (json.As<double>())
    {
      value = *json.As<double>();
    }
    else if (json.As<std::string>())
    {
      value = *json.As<std::string>();
    }
    else
    {
      place.Fail("is " + ShowValue(json) + " where a text, a number, true or false is expected.");
    }
    solver.Options.emplace_back(key, std::move(value));
  };
  table.WriteOther = [](const StudySolver& solver, JsonValue::Object& object)
  {
    for (const auto& [key, value] : solver.Options)
    {
      object.push_back({ key, std::visit([](const auto& of) { return JsonValue{ of }; }, value) });
    }
  };
  table.Finish = [](const DocumentPlace& place, StudySolver& solver)
  {
    if (solver.Solver.empty())
    {
      place.Member("solver").Fail("is empty: name a solver, or a .json file that describes one.");
    }
  };
  return table;
}

void NameRuns(const DocumentPlace& place, Study& study)
{
  std::set<std::string> taken;
  for (std::size_t i = 0; i < study.Solvers.size(); ++i)
  {
    const std::string& name = study.Solvers[i].Name;
    if (!name.empty() && !taken.insert(name).second)
    {
      place.Member("solvers").Item(i).Member("name").Fail(
        "is \"" + name + "\", the name of another run: runs need different names.");
    }
  }
  for (StudySolver& solver : study.Solvers)
  {
    if (!solver.Name.empty())
    {
      continue;
    }
    const std::string base = StemOf(solver.Solver);
    CheckFileName(place.Member("solvers"), base);
    const std::string order = OrderOf(solver);
    std::string name = base;
    if (taken.count(name) && !order.empty())
    {
      name = base + "-k" + order;
    }
    for (int number = 2; taken.count(name); ++number)
    {
      name = base + "-" + std::to_string(number);
    }
    taken.insert(name);
    solver.Name = name;
  }
}

} // namespace pemesh
