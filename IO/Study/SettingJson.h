// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Settings of tables (SettingFields.h) from and to JSON.
 */
#ifndef pemesh_SettingJson_h
#define pemesh_SettingJson_h

#include "DocumentFields.h"
#include "SettingFields.h"

#include <map>
#include <optional>
#include <string>

namespace pemesh
{

/** A number, a text, true or false as the text that SetSetting takes. */
std::string ScalarText(const JsonValue& json, const DocumentPlace& place);

/** Fails at `place` with what a setting says of a value that is not possible. */
[[noreturn]] void FailSetting(const DocumentPlace& place, const std::string& message);

/** Numbers as numbers, true and false as such. */
template <typename Owner>
JsonValue SettingToJson(const SettingField<Owner>& field, const std::string& text)
{
  const std::size_t kind = field.Member.index();
  if (kind == 2)
  {
    return JsonValue{ text == "true" };
  }
  const auto number = kind < 2 ? ParseNumber(text) : std::nullopt;
  return number ? JsonNumber(*number) : JsonValue{ text };
}

/** Checks a value, and returns it as text; `owner` is where it is tried. */
template <typename Owner>
std::string ReadSettingJson(std::span<const SettingField<Owner>> fields,
  const SettingField<Owner>& field, const JsonValue& json, const DocumentPlace& place, Owner& owner)
{
  const std::string text = ScalarText(json, place);
  try
  {
    SetSetting(fields, owner, field.Name, text);
  }
  catch (const std::exception& error)
  {
    FailSetting(place, error.what());
  }
  return GetSetting(field, owner);
}

///@{
/** The keys of a style; `file` takes the key "from", another style that they differ from. */
std::map<std::string, std::string> ReadStyleKeys(
  const JsonValue& json, const DocumentPlace& place, std::string& file);
std::optional<JsonValue> WriteStyleKeys(
  const std::map<std::string, std::string>& keys, const std::string& file);
///@}

} // namespace pemesh

#endif
