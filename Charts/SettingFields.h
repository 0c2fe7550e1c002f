// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Settings described by a table: of every member of a struct its name, what it may hold and what it
 * means. Study documents, the command line and settings panels are made from the tables, so that a
 * setting is added in one place. Defaults are those of the struct.
 */
#ifndef pemesh_SettingFields_h
#define pemesh_SettingFields_h

#include "pemeshChartsModule.h" // For export macro

#include <limits>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace pemesh
{

template <typename Owner>
struct SettingField
{
  using MemberType =
    std::variant<double Owner::*, int Owner::*, bool Owner::*, std::string Owner::*>;

  SettingField(const std::string& name, const std::string& label, const std::string& description,
    MemberType member, double least = -std::numeric_limits<double>::infinity(),
    double greatest = std::numeric_limits<double>::infinity(),
    const std::vector<std::string>& choices = {}, bool isColor = false)
    : Name(name)
    , Label(label)
    , Description(description)
    , Member(member)
    , Least(least)
    , Greatest(greatest)
    , Choices(choices)
    , IsColor(isColor)
  {
  }

  std::string Name; // kebab-case
  std::string Label;
  std::string Description;
  MemberType Member;
  double Least; // of a number
  double Greatest;
  std::vector<std::string> Choices; // of a text; empty: any
  bool IsColor;                     // a text "#rrggbb"
};

///@{
/** A value as text: "true", "0.5", "viridis"; "nan" for a number that is not set. */
PEMESHCHARTS_EXPORT std::string SettingText(double value);
PEMESHCHARTS_EXPORT std::string SettingText(int value);
PEMESHCHARTS_EXPORT std::string SettingText(bool value);
PEMESHCHARTS_EXPORT std::string SettingText(const std::string& value);
///@}

/** What a setting may be, apart from its owner. */
struct SettingLimits
{
  std::string Name;
  double Least;
  double Greatest;
  const std::vector<std::string>& Choices;
  bool IsColor;
};

///@{
/** Text to a value; throws std::runtime_error with a sentence that says what is possible. */
PEMESHCHARTS_EXPORT void ReadSetting(const SettingLimits& limits, const std::string& text, double&);
PEMESHCHARTS_EXPORT void ReadSetting(const SettingLimits& limits, const std::string& text, int&);
PEMESHCHARTS_EXPORT void ReadSetting(const SettingLimits& limits, const std::string& text, bool&);
PEMESHCHARTS_EXPORT void ReadSetting(
  const SettingLimits& limits, const std::string& text, std::string&);
///@}

/** "number from 0 to 1", "one of a, b", …: for references. */
PEMESHCHARTS_EXPORT std::string DescribeSetting(const SettingLimits& limits, int memberIndex);

/** Throws the sentence that names the setting nearest to `name`. */
[[noreturn]] PEMESHCHARTS_EXPORT void FailUnknownSetting(
  const std::string& name, const std::vector<std::string>& known);

template <typename Owner>
SettingLimits LimitsOf(const SettingField<Owner>& field)
{
  return { field.Name, field.Least, field.Greatest, field.Choices, field.IsColor };
}

template <typename Owner>
std::string DescribeSetting(const SettingField<Owner>& field)
{
  return DescribeSetting(LimitsOf(field), static_cast<int>(field.Member.index()));
}

template <typename Owner>
std::string GetSetting(const SettingField<Owner>& field, const Owner& owner)
{
  return std::visit([&](auto member) { return SettingText(owner.*member); }, field.Member);
}

/** Null for an unknown name. */
template <typename Owner>
const SettingField<Owner>* FindSetting(
  std::span<const SettingField<Owner>> fields, const std::string& name)
{
  for (const SettingField<Owner>& field : fields)
  {
    if (field.Name == name)
    {
      return &field;
    }
  }
  return nullptr;
}

/** Throws std::runtime_error with one sentence: no such setting, or not such a value. */
template <typename Owner>
void SetSetting(std::span<const SettingField<Owner>> fields, Owner& owner, const std::string& name,
  const std::string& text)
{
  const SettingField<Owner>* field = FindSetting(fields, name);
  if (!field)
  {
    std::vector<std::string> known;
    for (const SettingField<Owner>& candidate : fields)
    {
      known.push_back(candidate.Name);
    }
    FailUnknownSetting(name, known);
  }
  std::visit(
    [&](auto member) { ReadSetting(LimitsOf(*field), text, owner.*member); }, field->Member);
}

} // namespace pemesh

#endif
