// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Single values of a document: read with a sentence about whatever is wrong, written, shown.
 */
#ifndef pemesh_DocumentValues_h
#define pemesh_DocumentValues_h

#include "DocumentPlace.h"
#include "JsonValue.h"
#include "NumberText.h"
#include "StudyForm.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace pemesh
{

/** An interval of numbers. */
struct NumberRange
{
  double Least = -std::numeric_limits<double>::infinity();
  double Greatest = std::numeric_limits<double>::infinity();
  bool ExcludesLeast = false;

  /** "between 0 and 34", "greater than 0", … */
  std::string Describe() const
  {
    const bool hasGreatest = std::isfinite(this->Greatest);
    if (!std::isfinite(this->Least))
    {
      return hasGreatest ? "at most " + Show(this->Greatest) : "";
    }
    if (!hasGreatest)
    {
      return (this->ExcludesLeast ? "greater than " : "at least ") + Show(this->Least);
    }
    return "between " + Show(this->Least) + " and " + Show(this->Greatest);
  }

  ValueForm FormOf(ValueForm::KindType kind) const
  {
    return { kind, this->Least, this->Greatest, this->ExcludesLeast };
  }

  /** 10000000 rather than 1e+07. */
  static std::string Show(double value) { return FormatJsonCompact(JsonNumber(value)); }

  bool Has(double value) const
  {
    return std::isfinite(value) && value <= this->Greatest &&
      (this->ExcludesLeast ? value > this->Least : value >= this->Least);
  }
};

/** Shortened, for messages. */
inline std::string ShowValue(const JsonValue& json)
{
  std::size_t most = 40;
  const std::string text = FormatJsonCompact(json);
  if (text.size() <= most)
  {
    return text;
  }
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0U) == 0x80U)
  {
    --most; // not in the middle of a character
  }
  return text.substr(0, most) + "…";
}

/** Separated by commas. */
inline std::string ShowChoices(const std::vector<std::string>& choices)
{
  std::string text;
  for (const std::string& choice : choices)
  {
    text += (text.empty() ? "" : ", ") + choice;
  }
  return text;
}

///@{
/** One value of a given type; whatever else it is, is told. */
inline double ReadNumber(
  const JsonValue& json, const DocumentPlace& place, const NumberRange& range)
{
  if (!json.IsNumber())
  {
    place.Fail("is " + ShowValue(json) + " where a number is expected.");
  }
  if (!range.Has(json.ToNumber()))
  {
    place.Fail("is " + ShowValue(json) + "; it must be " + range.Describe() + ".");
  }
  return json.ToNumber();
}

/** An integer of any size that a double holds. */
inline double ReadWhole(const JsonValue& json, const DocumentPlace& place, const NumberRange& range)
{
  const double number = json.IsNumber() ? json.ToNumber() : 0.5;
  if (number != std::trunc(number))
  {
    place.Fail("is " + ShowValue(json) + " where an integer is expected.");
  }
  return ReadNumber(json, place, range);
}

inline int ReadInteger(const JsonValue& json, const DocumentPlace& place, const NumberRange& range)
{
  return static_cast<int>(ReadWhole(json, place, range));
}

inline std::string ReadText(const JsonValue& json, const DocumentPlace& place)
{
  const auto* text = json.As<std::string>();
  if (!text)
  {
    place.Fail("is " + ShowValue(json) + " where a text is expected.");
  }
  return *text;
}

inline std::string ReadChoice(
  const JsonValue& json, const DocumentPlace& place, const std::vector<std::string>& choices)
{
  const std::string text = ReadText(json, place);
  for (const std::string& choice : choices)
  {
    if (choice == text)
    {
      return text;
    }
  }
  place.Fail("is \"" + text + "\"; did you mean \"" + NearestWord(text, choices) + "\"? (one of " +
    ShowChoices(choices) + ")");
}

inline const JsonValue::List& ReadList(const JsonValue& json, const DocumentPlace& place)
{
  const auto* list = json.As<JsonValue::List>();
  if (!list)
  {
    place.Fail("is " + ShowValue(json) + " where a list is expected.");
  }
  return *list;
}

/** A list of texts; one text alone stands for a list of one. */
inline std::vector<std::string> ReadTexts(const JsonValue& json, const DocumentPlace& place)
{
  if (json.As<std::string>())
  {
    return { *json.As<std::string>() };
  }
  std::vector<std::string> texts;
  for (const JsonValue& item : ReadList(json, place))
  {
    texts.push_back(ReadText(item, place.Item(texts.size())));
  }
  return texts;
}
///@}

inline JsonValue WriteTextList(const std::vector<std::string>& texts)
{
  JsonValue::List list;
  for (const std::string& text : texts)
  {
    list.push_back({ text });
  }
  return { std::move(list) };
}

/** One text alone for a list of one. */
inline JsonValue WriteTexts(const std::vector<std::string>& texts)
{
  return texts.size() == 1 ? JsonValue{ texts.front() } : WriteTextList(texts);
}

} // namespace pemesh

#endif
