// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Keys for an entry of a table of filters and for the parameters it is tuned by (Parameter.h): the
 * table alone says which there are, so that a new entry needs no edit here.
 */
#ifndef pemesh_ParameterFields_h
#define pemesh_ParameterFields_h

#include "DocumentFields.h"
#include "Parameter.h"
#include "Study.h"

#include <cctype>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace pemesh
{

/** The entries of a table: the name of each and its parameters. */
struct ParameterizedEntry
{
  std::string Name;
  std::span<const Parameter> Parameters;
};

/** Where an Owner keeps the name of its entry and the values. */
template <typename Owner>
struct EntryPlace
{
  std::string Owner::*Name;
  StudyParameters Owner::*Parameters;
};

/** The parameters of the entry of that name. */
inline std::span<const Parameter> ParametersOf(
  const std::vector<ParameterizedEntry>& entries, const std::string& name)
{
  for (const ParameterizedEntry& entry : entries)
  {
    if (entry.Name == name)
    {
      return entry.Parameters;
    }
  }
  return {};
}

/** Gives every parameter of the entry that is not set its default, in the order of the table. */
inline void CompleteParameters(std::span<const Parameter> parameters, StudyParameters& values)
{
  StudyParameters complete;
  for (const Parameter& parameter : parameters)
  {
    const auto given = std::find_if(values.begin(), values.end(),
      [&](const auto& value) { return value.first == parameter.Name; });
    complete.emplace_back(
      parameter.Name, given == values.end() ? parameter.Default : given->second);
  }
  values = std::move(complete);
}

/** Takes out the values that are the defaults of the entry. */
inline void DropDefaults(std::span<const Parameter> parameters, StudyParameters& values)
{
  std::erase_if(values,
    [&](const auto& value)
    {
      const Parameter* parameter = FindParameter(parameters, value.first);
      return parameter && parameter->Default == value.second;
    });
}

/** "integer at least 1, default 40" */
inline std::string DescribeParameter(const Parameter& parameter)
{
  const std::string range = NumberRange{ parameter.Least, parameter.Greatest }.Describe();
  return (parameter.IsInteger ? "integer" : "number") + (range.empty() ? "" : " " + range) +
    ", default " + NumberRange::Show(parameter.Default);
}

template <typename Owner>
Field<Owner> ParameterField(const std::string& key, const std::vector<ParameterizedEntry>& entries,
  const EntryPlace<Owner>& where, const std::string& whose)
{
  std::map<std::string, std::string> ownersOf; // what the key is: the entries where it is that
  std::string names;
  for (const ParameterizedEntry& entry : entries)
  {
    if (const Parameter* parameter = FindParameter(entry.Parameters, key))
    {
      std::string& owners =
        ownersOf[DescribeParameter(*parameter) + ". " + std::string(parameter->Description)];
      owners += (owners.empty() ? "" : ", ") + entry.Name;
      names += (names.empty() ? "" : ", ") + entry.Name;
    }
  }
  std::string type;
  std::string doc;
  for (const auto& [what, owners] : ownersOf)
  {
    const std::size_t dot = what.find(". ");
    type += (type.empty() ? "" : "; ") + what.substr(0, dot) +
      (ownersOf.size() > 1 ? " (" + owners + ")" : "");
    std::string sentence = what.substr(dot + 2) + ".";
    sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
    doc += doc.find(sentence) == std::string::npos ? (doc.empty() ? "" : " ") + sentence : "";
  }
  Field<Owner> field{ key, type, doc,
    [=](const JsonValue& json, const DocumentPlace& place, Owner& owner)
    {
      const Parameter* parameter = FindParameter(ParametersOf(entries, owner.*where.Name), key);
      const NumberRange range{ parameter->Least, parameter->Greatest };
      const auto read = parameter->IsInteger ? ReadWhole : ReadNumber;
      (owner.*where.Parameters).emplace_back(key, read(json, place, range));
    },
    [=](const Owner& owner) -> std::optional<JsonValue>
    {
      for (const auto& [name, value] : owner.*where.Parameters)
      {
        if (name == key)
        {
          return JsonNumber(value);
        }
      }
      return std::nullopt;
    } };
  field.Form = [=](const Owner& owner)
  {
    const Parameter* parameter = FindParameter(ParametersOf(entries, owner.*where.Name), key);
    return NumberRange{ parameter->Least, parameter->Greatest }.FormOf(
      parameter->IsInteger ? ValueForm::Integer : ValueForm::Number);
  };
  return std::move(field).Only([=](const Owner& owner)
    { return FindParameter(ParametersOf(entries, owner.*where.Name), key) != nullptr; },
    whose + " " + names);
}

/** One key for every parameter that an entry has; `whose` as in "the source". */
template <typename Owner>
std::vector<Field<Owner>> ParameterFields(const std::vector<ParameterizedEntry>& entries,
  const EntryPlace<Owner>& where, const std::string& whose)
{
  std::vector<std::string> keys;
  for (const ParameterizedEntry& entry : entries)
  {
    for (const Parameter& parameter : entry.Parameters)
    {
      if (std::find(keys.begin(), keys.end(), parameter.Name) == keys.end())
      {
        keys.emplace_back(parameter.Name);
      }
    }
  }
  std::vector<Field<Owner>> fields;
  for (const std::string& key : keys)
  {
    fields.push_back(ParameterField(key, entries, where, whose));
  }
  return fields;
}

/** All entries of a table of filters. */
template <typename Table>
std::vector<ParameterizedEntry> EntriesOf(const Table& table)
{
  std::vector<ParameterizedEntry> entries;
  for (const auto& entry : table)
  {
    entries.push_back({ entry.Name, entry.Parameters });
  }
  return entries;
}

/** Puts fields behind those of a table. */
template <typename Owner>
void AppendFields(FieldTable<Owner>& table, std::vector<Field<Owner>> fields)
{
  for (Field<Owner>& field : fields)
  {
    table.Fields.push_back(std::move(field));
  }
}

} // namespace pemesh

#endif
