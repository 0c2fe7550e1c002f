// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A JSON value that keeps the order of its members, and text from and to it.
 */
#ifndef pemesh_JsonValue_h
#define pemesh_JsonValue_h

#include "pemeshIOStudyModule.h" // For export macro

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace pemesh
{

struct JsonMember;

struct JsonValue
{
  using List = std::vector<JsonValue>;
  using Object = std::vector<JsonMember>;

  std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, List, Object> Data;

  template <typename Type>
  const Type* As() const
  {
    return std::get_if<Type>(&this->Data);
  }
  template <typename Type>
  Type* As()
  {
    return std::get_if<Type>(&this->Data);
  }

  bool IsNumber() const { return this->As<std::int64_t>() || this->As<double>(); }

  /** Of a number. */
  double ToNumber() const
  {
    const auto* integer = this->As<std::int64_t>();
    return integer ? static_cast<double>(*integer) : std::get<double>(this->Data);
  }
};

struct JsonMember
{
  std::string Key;
  JsonValue Value;
};

/** The value of a member, or null. */
PEMESHIOSTUDY_EXPORT const JsonValue* FindMember(
  const JsonValue::Object& object, std::string_view key);
PEMESHIOSTUDY_EXPORT JsonValue* FindMember(JsonValue::Object& object, std::string_view key);

/** A double without a fraction is written as an integer: 20, not 20.0. */
PEMESHIOSTUDY_EXPORT JsonValue JsonNumber(double value);

/**
 * Strict JSON. Throws std::runtime_error with one sentence that names `source` and the line and
 * column of a syntax error, or the path of a key given twice. At most 64 levels deep.
 */
PEMESHIOSTUDY_EXPORT JsonValue ParseJson(std::string_view text, const std::string& source);

/** Two blanks a level; a list of plain values and an object that fits stay on one line. */
PEMESHIOSTUDY_EXPORT std::string FormatJson(const JsonValue& value);

/** Everything on one line, for messages. */
PEMESHIOSTUDY_EXPORT std::string FormatJsonCompact(const JsonValue& value);

} // namespace pemesh

#endif
