// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "JsonValue.h"

#include "DocumentPlace.h"
#include "NumberText.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pemesh
{

namespace
{

/** Builds a JsonValue from the events of the parser. */
class Builder : public nlohmann::json_sax<nlohmann::json>
{
public:
  Builder(std::string_view text, const std::string& source)
    : Text(text)
    , Source(source)
  {
  }

  JsonValue Root;

  bool null() override { return this->Put({ nullptr }); }
  bool boolean(bool value) override { return this->Put({ value }); }
  bool number_integer(std::int64_t value) override { return this->Put({ value }); }
  bool number_unsigned(std::uint64_t value) override
  {
    const auto asSigned = static_cast<std::int64_t>(value);
    return asSigned >= 0 ? this->Put({ asSigned }) : this->Put({ static_cast<double>(value) });
  }
  bool number_float(double value, const std::string&) override { return this->Put({ value }); }
  bool string(std::string& value) override { return this->Put({ std::move(value) }); }
  bool binary(nlohmann::json::binary_t&) override { return false; }
  bool start_object(std::size_t) override { return this->Open({ JsonValue::Object() }); }
  bool start_array(std::size_t) override { return this->Open({ JsonValue::List() }); }
  bool end_object() override { return this->Close(); }
  bool end_array() override { return this->Close(); }

  bool key(std::string& name) override
  {
    auto& object = std::get<JsonValue::Object>(this->Levels.back()->Data);
    if (FindMember(object, name))
    {
      this->Place().Member(name).Fail("is given twice.");
    }
    object.push_back({ name, {} });
    return true;
  }

  bool parse_error(
    std::size_t position, const std::string&, const nlohmann::detail::exception& error) override
  {
    // The parser counts the bytes read, that of the error included.
    const std::string_view before = this->Text.substr(0, position > 0 ? position - 1 : 0);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t lastBreak = before.rfind('\n');
    const std::size_t column =
      before.size() - (lastBreak == std::string_view::npos ? 0 : lastBreak + 1) + 1;
    throw std::runtime_error("\"" + this->Source + "\", line " + std::to_string(line) +
      ", column " + std::to_string(column) + ": " + Reason(error.what()) + ".");
  }

private:
  static constexpr std::size_t DeepestLevel = 64;

  /** What the parser says, without its own numbers and counts. */
  static std::string Reason(std::string message)
  {
    for (const char* lead : { "syntax error while ", "number overflow" })
    {
      const std::size_t start = message.find(lead);
      if (start != std::string::npos)
      {
        return message.substr(start);
      }
    }
    return message;
  }

  /** Of the innermost open object. */
  DocumentPlace Place() const
  {
    DocumentPlace place(this->Source);
    for (std::size_t i = 0; i + 1 < this->Levels.size(); ++i)
    {
      const auto* list = this->Levels[i]->As<JsonValue::List>();
      place = list ? place.Item(list->size() - 1)
                   : place.Member(std::get<JsonValue::Object>(this->Levels[i]->Data).back().Key);
    }
    return place;
  }

  /** Where the next value goes: the root, a new item, or the member whose key was just read. */
  JsonValue* NextValue()
  {
    if (this->Levels.empty())
    {
      return &this->Root;
    }
    if (auto* list = this->Levels.back()->As<JsonValue::List>())
    {
      return &list->emplace_back();
    }
    return &std::get<JsonValue::Object>(this->Levels.back()->Data).back().Value;
  }

  bool Put(JsonValue value)
  {
    *this->NextValue() = std::move(value);
    return true;
  }

  bool Open(JsonValue value)
  {
    if (this->Levels.size() == DeepestLevel)
    {
      throw std::runtime_error("\"" + this->Source + "\" has lists or objects more than " +
        std::to_string(DeepestLevel) + " levels deep.");
    }
    JsonValue* place = this->NextValue();
    *place = std::move(value);
    // Stays valid: only the innermost open list or object grows.
    this->Levels.push_back(place);
    return true;
  }

  bool Close()
  {
    this->Levels.pop_back();
    return true;
  }

  std::string_view Text;
  const std::string& Source;
  std::vector<JsonValue*> Levels;
};

constexpr std::size_t LongestLine = 100;

std::string Quote(const std::string& text)
{
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string FormatDouble(double value)
{
  if (!std::isfinite(value))
  {
    throw std::runtime_error("JSON has no text for the number " + FormatNumber(value) + ".");
  }
  const std::string text = FormatNumber(value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

/** `indent` is that of the line on which the value begins. */
void AppendJson(std::string& text, const JsonValue& value, std::size_t indent, bool isCompact);

/** The members of a list or an object, each written by `append(i)`. */
template <typename Append>
void AppendBlock(std::string& text, const char* brackets, std::size_t count, std::size_t indent,
  bool isCompact, Append append)
{
  text += brackets[0];
  for (std::size_t i = 0; i < count; ++i)
  {
    text += i > 0 ? (isCompact ? ", " : ",") : "";
    if (!isCompact)
    {
      text += '\n';
      text.append(indent + 2, ' ');
    }
    append(i);
  }
  if (!isCompact)
  {
    text += '\n';
    text.append(indent, ' ');
  }
  text += brackets[1];
}

void AppendJson(std::string& text, const JsonValue& value, std::size_t indent, bool isCompact)
{
  if (const auto* list = value.As<JsonValue::List>())
  {
    isCompact = isCompact || indent + FormatJsonCompact(value).size() <= LongestLine;
    AppendBlock(text, "[]", list->size(), indent, isCompact,
      [&](std::size_t i) { AppendJson(text, (*list)[i], indent + 2, isCompact); });
  }
  else if (const auto* object = value.As<JsonValue::Object>())
  {
    // The document itself always takes several lines.
    isCompact =
      isCompact || (indent > 0 && indent + FormatJsonCompact(value).size() <= LongestLine);
    AppendBlock(text, "{}", object->size(), indent, isCompact,
      [&](std::size_t i)
      {
        text += Quote((*object)[i].Key) + ": ";
        AppendJson(text, (*object)[i].Value, indent + 2, isCompact);
      });
  }
  else if (const auto* words = value.As<std::string>())
  {
    text += Quote(*words);
  }
  else if (const auto* number = value.As<double>())
  {
    text += FormatDouble(*number);
  }
  else if (const auto* integer = value.As<std::int64_t>())
  {
    AppendNumber(text, static_cast<long long>(*integer));
  }
  else
  {
    const bool* truth = value.As<bool>();
    text += !truth ? "null" : *truth ? "true" : "false";
  }
}

} // namespace

const JsonValue* FindMember(const JsonValue::Object& object, std::string_view key)
{
  const auto found = std::find_if(
    object.begin(), object.end(), [&](const JsonMember& member) { return member.Key == key; });
  return found == object.end() ? nullptr : &found->Value;
}

JsonValue* FindMember(JsonValue::Object& object, std::string_view key)
{
  return const_cast<JsonValue*>(FindMember(std::as_const(object), key));
}

JsonValue JsonNumber(double value)
{
  constexpr double largest = 0x1p53; // up to which doubles hold every integer
  if (std::fabs(value) <= largest && value == std::trunc(value))
  {
    return { static_cast<std::int64_t>(value) };
  }
  return { value };
}

JsonValue ParseJson(std::string_view text, const std::string& source)
{
  Builder builder(text, source);
  nlohmann::json::sax_parse(text, &builder);
  return std::move(builder.Root);
}

std::string FormatJson(const JsonValue& value)
{
  std::string text;
  AppendJson(text, value, 0, false);
  return text + "\n";
}

std::string FormatJsonCompact(const JsonValue& value)
{
  std::string text;
  AppendJson(text, value, 0, true);
  return text;
}

} // namespace pemesh
