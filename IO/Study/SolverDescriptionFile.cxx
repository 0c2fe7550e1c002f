// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverDescriptionFile.h"

#include "MeshFormats.h"
#include "SolverCommand.h"
#include "StudyFields.h"
#include "TextFile.h"

#include <set>

namespace pemesh
{

namespace
{

namespace fs = std::filesystem;

/** Placeholders of a command that every solver has. */
const std::vector<std::string> CommonPlaceholders{ "mesh", "node", "ele", "output", "stem", "list",
  "threads", "folder" };

/** Keys of a run in a study, which no option can be called. */
std::vector<std::string> RunKeys()
{
  std::vector<std::string> keys{ "solver", "name", "version" };
  for (const SolverLimit& limit : SolverLimits())
  {
    keys.emplace_back(limit.Key);
  }
  return keys;
}

// --- options -------------------------------------------------------------------------------------

/** A value of an option as text, checked against its type; `json` is of a description or a study.
 */
std::string ReadOptionValue(
  const JsonValue& json, const DocumentPlace& place, const std::string& type)
{
  if (type == "integer")
  {
    ReadInteger(json, place, { .Least = -1e9, .Greatest = 1e9 });
    return FormatJsonCompact(JsonNumber(json.ToNumber()));
  }
  return type == "number" ? FormatNumber(ReadNumber(json, place, {})) : ReadText(json, place);
}

/** The text of a value as what it is. */
StudyScalar ScalarOfType(const std::string& text, const std::string& type)
{
  if (type == "integer")
  {
    return std::int64_t{ ParseInteger(text).value_or(0) };
  }
  return type == "number" ? StudyScalar(ParseNumber(text).value_or(0.0)) : StudyScalar(text);
}

JsonValue JsonOfScalar(const StudyScalar& value)
{
  return std::visit([](const auto& of) { return JsonValue{ of }; }, value);
}

void CheckChoice(const std::string& value, const SolverOption& option, const DocumentPlace& place)
{
  const std::vector<std::string>& choices = option.Choices;
  if (!choices.empty() && std::find(choices.begin(), choices.end(), value) == choices.end())
  {
    place.Fail("is \"" + value + "\"; did you mean \"" + NearestWord(value, choices) +
      "\"? (one of " + ShowChoices(choices) + ")");
  }
}

Field<SolverOption> DefaultField()
{
  return { "default", "a value of the type", "Without one, a run must give a number.",
    [](const JsonValue& json, const DocumentPlace& place, SolverOption& option)
    { option.Default = ReadOptionValue(json, place, option.Type); },
    [](const SolverOption& option)
    {
      return option.Default.empty()
        ? std::nullopt
        : std::optional(JsonOfScalar(ScalarOfType(option.Default, option.Type)));
    } };
}

Field<SolverOption> ChoicesField()
{
  Field<SolverOption> field =
    TextsField("choices", &SolverOption::Choices, "The values of a string, if it has few.")
      .Only([](const SolverOption& option) { return option.Type == "string"; }, "the type string");
  field.Write = [](const SolverOption& option)
  { return option.Choices.empty() ? std::nullopt : std::optional(WriteTextList(option.Choices)); };
  return field;
}

FieldTable<SolverOption> OptionFields()
{
  FieldTable<SolverOption> table;
  table.Fields = {
    TextField("name", &SolverOption::Name, "The placeholder in the command.").Required(),
    ChoiceField(
      "type", &SolverOption::Type, { "string", "integer", "number" }, "What a value may be."),
    DefaultField(), ChoicesField(),
    TextField("description", &SolverOption::Description, "One sentence for the user.")
  };
  table.Finish = [](const DocumentPlace& place, SolverOption& option)
  {
    for (const std::vector<std::string>& reserved : { CommonPlaceholders, RunKeys() })
    {
      if (std::find(reserved.begin(), reserved.end(), option.Name) != reserved.end())
      {
        place.Member("name").Fail(
          "is \"" + option.Name + "\", which has a meaning already: call the option otherwise.");
      }
    }
    CheckChoice(option.Default, option, place.Member("default"));
  };
  return table;
}

// --- the description -----------------------------------------------------------------------------

FieldTable<SolverPerformance> PerformanceFields()
{
  FieldTable<SolverPerformance> table;
  table.Fields = { TextField(
                     "name", &SolverPerformance::Name, "The solver writes it to <mesh>-<name>.txt.")
                     .Required(),
    TextField("label", &SolverPerformance::Label, "What people read, with the unit."),
    ChoiceField("scale", &SolverPerformance::Scale, { "linear", "log" }, "How charts show it."),
    BooleanField("measured", &SolverPerformance::Measured,
      "Whether it depends on the machine (seconds, bytes)."),
    BooleanField("may-be-undefined", &SolverPerformance::MayBeUndefined,
      "Whether nan is an answer: otherwise it is a fault of the run.") };
  table.Finish = [](const DocumentPlace& place, SolverPerformance& performance)
  { CheckFileName(place.Member("name"), performance.Name); };
  return table;
}

FieldTable<SolverElementArray> ElementArrayFields()
{
  FieldTable<SolverElementArray> table;
  table.Fields = { TextField("name", &SolverElementArray::Name,
                     "The solver may write it to <mesh>-<name>.txt, one number an element.")
                     .Required(),
    TextField("label", &SolverElementArray::Label, "What people read, with the unit.") };
  table.Finish = [](const DocumentPlace& place, SolverElementArray& array)
  { CheckFileName(place.Member("name"), array.Name); };
  return table;
}

/** Formats whose vertices a solver can answer for. */
std::vector<std::string> SolverMeshFormats()
{
  std::vector<std::string> names;
  for (const MeshFormat& format : MeshFormats())
  {
    if (format.KeepsVertices)
    {
      names.emplace_back(format.Name);
    }
  }
  return names;
}

/** "{order}" names the placeholder order; "{{" and "}}" are braces. */
void CheckPlaceholders(
  const std::string& argument, const DocumentPlace& place, const std::vector<std::string>& known)
{
  for (std::size_t i = 0; i < argument.size(); ++i)
  {
    const char c = argument[i];
    if (c != '{' && c != '}')
    {
      continue;
    }
    if (i + 1 < argument.size() && argument[i + 1] == c)
    {
      ++i;
      continue;
    }
    const std::size_t end = c == '{' ? argument.find('}', i) : std::string::npos;
    if (end == std::string::npos)
    {
      place.Fail("is \"" + argument +
        "\", with a brace that is not paired: write {{ or }} for "
        "a brace that is no placeholder.");
    }
    const std::string name = argument.substr(i + 1, end - i - 1);
    if (std::find(known.begin(), known.end(), name) == known.end())
    {
      place.Fail("uses the placeholder {" + name + "}, which is no option; did you mean {" +
        NearestWord(name, known) + "}?");
    }
    i = end;
  }
}

template <typename Entry>
void CheckUnique(const std::vector<Entry>& entries, const DocumentPlace& place)
{
  std::set<std::string> seen;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    if (!seen.insert(entries[i].Name).second)
    {
      place.Item(i).Member("name").Fail("is \"" + entries[i].Name + "\", which is taken.");
    }
  }
}

/** A solver is told of one mesh or of a list, not of both. */
void CheckList(const DocumentPlace& place, const SolverDescription& description)
{
  if (!TakesList(description))
  {
    if (description.MeshesPerCall > 1)
    {
      place.Member("meshes-per-call")
        .Fail("is more than 1, but the command has no {list}: name in it the file that lists the "
              "meshes.");
    }
    return;
  }
  for (const std::string& argument : description.Command)
  {
    for (const char* placeholder : { "{mesh}", "{node}", "{ele}", "{output}", "{stem}" })
    {
      if (argument.find(placeholder) != std::string::npos)
      {
        place.Member("command").Fail("has both {list} and " + std::string(placeholder) +
          ": a solver that takes a list finds the meshes in it, and leaves its files beside each.");
      }
    }
  }
}

void FinishDescription(const DocumentPlace& place, SolverDescription& description)
{
  CheckFileName(place.Member("name"), description.Name);
  CheckUnique(description.Options, place.Member("options"));
  CheckUnique(description.Performances, place.Member("performances"));
  CheckUnique(description.Elements, place.Member("elements"));
  std::vector<std::string> known = CommonPlaceholders;
  for (const SolverOption& option : description.Options)
  {
    known.push_back(option.Name);
  }
  const DocumentPlace command = place.Member("command");
  if (description.Command.empty() || description.Command.front().empty())
  {
    command.Fail("is empty: name the program and its arguments.");
  }
  for (std::size_t i = 0; i < description.Command.size(); ++i)
  {
    CheckPlaceholders(description.Command[i], command.Item(i), known);
  }
  CheckList(place, description);
}

Field<SolverDescription> ArgumentsField(
  const char* key, std::vector<std::string> SolverDescription::*member, const char* doc)
{
  Field<SolverDescription> field = TextsField(key, member, doc);
  field.Type = "list of texts";
  field.Read = [member](
                 const JsonValue& json, const DocumentPlace& place, SolverDescription& description)
  {
    if (json.As<std::string>())
    {
      place.Fail("is one text where a list of arguments is expected, the program first: no shell "
                 "splits it.");
    }
    description.*member = ReadTexts(json, place);
  };
  field.Write = [member](const SolverDescription& description)
  { return WriteTextList(description.*member); };
  return field;
}

const FieldTable<SolverDescription>& DescriptionFields()
{
  static const FieldTable<SolverDescription> table = []
  {
    FieldTable<SolverDescription> result;
    result.Fields = {
      TextField("name", &SolverDescription::Name, "What studies call the solver.").Required(),
      TextField("label", &SolverDescription::Label, "What people read."),
      ArgumentsField("command", &SolverDescription::Command,
        "The argument list, with placeholders {mesh}, {output}, {stem}, options, …")
        .Required(),
      IntegerField("meshes-per-call", &SolverDescription::MeshesPerCall, 1, 1000000,
        "How many meshes it solves in a call at the most, if its command has {list}."),
      ChoiceField("mesh-format", &SolverDescription::MeshFormat, SolverMeshFormats(),
        "The format in which it reads meshes."),
      ListField("options", &SolverDescription::Options, OptionFields(), "What a run can choose."),
      ListField("performances", &SolverDescription::Performances, PerformanceFields(),
        "The numbers it writes for each mesh."),
      ListField("elements", &SolverDescription::Elements, ElementArrayFields(),
        "The arrays it may write, one number an element."),
      ArgumentsField("version-command", &SolverDescription::VersionCommand,
        "The argument list that makes it print its version.")
    };
    for (const SolverLimit& limit : SolverLimits())
    {
      result.Fields.push_back(
        NumberField(limit.Key, limit.OfDescription, { .Least = 0.0 }, limit.Doc));
    }
    result.Finish = FinishDescription;
    return result;
  }();
  return table;
}

// --- runs of a study -----------------------------------------------------------------------------

/** The options of a run in the order of the description, the defaults filled in. */
void CompleteOptions(
  StudySolver& run, const SolverDescription& description, const DocumentPlace& place)
{
  std::vector<std::string> known = NamesOf(description.Options);
  const std::vector<std::string> runKeys = RunKeys();
  known.insert(known.end(), runKeys.begin(), runKeys.end());
  for (const auto& [key, value] : run.Options)
  {
    if (std::find(known.begin(), known.end(), key) == known.end())
    {
      place.Member(key).Fail("is not an option of the solver " + description.Name +
        "; did you mean " + NearestWord(key, known) + "?");
    }
  }
  std::vector<std::pair<std::string, StudyScalar>> options;
  for (const SolverOption& option : description.Options)
  {
    const auto given = std::find_if(run.Options.begin(), run.Options.end(),
      [&](const auto& entry) { return entry.first == option.Name; });
    std::string text = option.Default;
    if (given != run.Options.end())
    {
      text = ReadOptionValue(JsonOfScalar(given->second), place.Member(option.Name), option.Type);
      CheckChoice(text, option, place.Member(option.Name));
    }
    else if (text.empty() && option.Type != "string")
    {
      place.Member(option.Name)
        .Fail("is missing: the solver " + description.Name + " has no default for it.");
    }
    options.emplace_back(option.Name, ScalarOfType(text, option.Type));
  }
  run.Options = std::move(options);
}

} // namespace

const std::vector<SolverLimit>& SolverLimits()
{
  static const std::vector<SolverLimit> limits{ { "time-limit", "Seconds for a mesh, 0 for any.",
                                                  &SolverDescription::TimeLimit,
                                                  &StudySolver::TimeLimit },
    { "cpu-limit", "Seconds of processors for a mesh, 0 for any.",
      &SolverDescription::ProcessorLimit, &StudySolver::ProcessorLimit },
    { "memory-limit", "MiB of memory of all its processes together, 0 for any.",
      &SolverDescription::MemoryLimit, &StudySolver::MemoryLimit },
    { "disk-limit", "MiB that it may write for a mesh, 0 for any.", &SolverDescription::DiskLimit,
      &StudySolver::DiskLimit } };
  return limits;
}

SolverDescription ParseSolverDescription(std::string_view text, const fs::path& path)
{
  SolverDescription description;
  const DocumentPlace place(path.string());
  ReadFields(DescriptionFields(), ParseJson(text, path.string()), place, description);
  if (description.Label.empty())
  {
    description.Label = description.Name;
  }
  for (SolverPerformance& performance : description.Performances)
  {
    performance.Label = performance.Label.empty() ? performance.Name : performance.Label;
  }
  for (SolverElementArray& array : description.Elements)
  {
    array.Label = array.Label.empty() ? array.Name : array.Label;
  }
  description.Folder = path.parent_path();
  return description;
}

SolverDescription ReadSolverDescription(const fs::path& path)
{
  return ParseSolverDescription(ReadTextFile(path), path);
}

std::string FormatSolverDescription(const SolverDescription& description)
{
  return FormatJson(WriteFields(DescriptionFields(), description));
}

std::vector<SolverDescription> FindStudySolvers(Study& study, const std::vector<fs::path>& folders)
{
  std::vector<SolverDescription> descriptions;
  for (StudySolver& run : study.Solvers)
  {
    const DocumentPlace place =
      DocumentPlace(study.Name).Member("solvers").Item(descriptions.size());
    SolverDescription description = FindSolver(run.Solver, study.Folder, folders);
    CompleteOptions(run, description, place);
    for (const SolverLimit& limit : SolverLimits())
    {
      run.*limit.OfRun = (run.*limit.OfRun).value_or(description.*limit.OfDescription);
    }
    descriptions.push_back(std::move(description));
  }
  return descriptions;
}

} // namespace pemesh
