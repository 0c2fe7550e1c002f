// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Documents described by tables of fields.
 *
 * A table says of every key of an object what it is called, what it may hold, what it means and
 * which member of a struct it is kept in. From the table alone come reading with all its messages,
 * writing, and the reference text: to add a key is to add an entry. Defaults are those of the
 * struct.
 */
#ifndef pemesh_DocumentFields_h
#define pemesh_DocumentFields_h

#include "DocumentValues.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pemesh
{

/** One key of an object that is kept in an Owner. */
template <typename Owner>
struct Field
{
  std::string Key;
  std::string Type; // for the reference: "number", "list of text", …
  std::string Doc;
  std::function<void(const JsonValue&, const DocumentPlace&, Owner&)> Read;
  std::function<std::optional<JsonValue>(const Owner&)> Write; // nothing: leave the key out
  std::function<void(std::string& text, const std::string& path)> DescribeParts = {};
  // What to do where the key is left out, if its parts need more than the initial values.
  std::function<void(const DocumentPlace&, Owner&)> ReadMissing = {};
  bool IsRequired = false;
  // A key may depend on the value of one that stands before it in the table.
  std::function<bool(const Owner&)> Applies = {};
  std::string AppliesTo = {}; // "the rule constant"
  // What a form offers for it; by default any text.
  std::function<ValueForm(const Owner&)> Form = {};
  std::function<void(const Owner&, const std::string& path, std::vector<FormField>&)>
    FormParts = {};

  Field Required() &&
  {
    this->IsRequired = true;
    return std::move(*this);
  }

  Field Only(std::function<bool(const Owner&)> applies, const std::string& appliesTo) &&
  {
    this->Applies = std::move(applies);
    this->AppliesTo = appliesTo;
    return std::move(*this);
  }

  bool IsFor(const Owner& owner) const { return !this->Applies || this->Applies(owner); }
};

/** All keys of an object. */
template <typename Owner>
struct FieldTable
{
  std::vector<Field<Owner>> Fields;
  /** Checks that need several keys, and defaults that depend on them. */
  std::function<void(const DocumentPlace&, Owner&)> Finish = {};
  /** Takes keys that are in no field, if set. */
  std::function<void(const std::string& key, const JsonValue&, const DocumentPlace&, Owner&)>
    ReadOther = {};
  std::function<void(const Owner&, JsonValue::Object&)> WriteOther = {};
};

///@{
/** What the tables are read, written and explained with. */
template <typename Owner>
void ReadFields(
  const FieldTable<Owner>& table, const JsonValue& json, const DocumentPlace& place, Owner& owner);
template <typename Owner>
JsonValue WriteFields(const FieldTable<Owner>& table, const Owner& owner);
template <typename Owner>
void DescribeFields(const FieldTable<Owner>& table, const std::string& path, std::string& text);
template <typename Owner>
void AppendForm(const FieldTable<Owner>& table, const Owner& owner, const std::string& path,
  std::vector<FormField>& form);
///@}

///@{
/** Entries of a table, one function a type. */
template <typename Owner>
Field<Owner> NumberField(
  const std::string& key, double Owner::*member, const NumberRange& range, const std::string& doc)
{
  const std::string bounds = range.Describe();
  return { key, "number" + (bounds.empty() ? "" : " " + bounds), doc,
    [=](const JsonValue& json, const DocumentPlace& place, Owner& owner)
    { owner.*member = ReadNumber(json, place, range); },
    [=](const Owner& owner) { return JsonNumber(owner.*member); }, {}, {}, false, {}, {},
    [=](const Owner&) { return range.FormOf(ValueForm::Number); } };
}

template <typename Owner>
Field<Owner> IntegerField(
  const std::string& key, int Owner::*member, int least, int greatest, const std::string& doc)
{
  const NumberRange range{ static_cast<double>(least), static_cast<double>(greatest) };
  return { key, "integer " + range.Describe(), doc,
    [=](const JsonValue& json, const DocumentPlace& place, Owner& owner)
    { owner.*member = ReadInteger(json, place, range); },
    [=](const Owner& owner) { return JsonValue{ std::int64_t{ owner.*member } }; }, {}, {}, false,
    {}, {}, [=](const Owner&) { return range.FormOf(ValueForm::Integer); } };
}

/** An integer that may be larger than an int, such as a seed. */
template <typename Owner>
Field<Owner> WholeField(
  const std::string& key, double Owner::*member, const NumberRange& range, const std::string& doc)
{
  return { key, "integer " + range.Describe(), doc,
    [=](const JsonValue& json, const DocumentPlace& place, Owner& owner)
    { owner.*member = ReadWhole(json, place, range); },
    [=](const Owner& owner) { return JsonNumber(owner.*member); }, {}, {}, false, {}, {},
    [=](const Owner&) { return range.FormOf(ValueForm::Integer); } };
}

template <typename Owner>
Field<Owner> BooleanField(const std::string& key, bool Owner::*member, const std::string& doc)
{
  return { key, "true or false", doc,
    [=](const JsonValue& json, const DocumentPlace& place, Owner& owner)
    {
      if (!json.As<bool>())
      {
        place.Fail("is " + ShowValue(json) + " where true or false is expected.");
      }
      owner.*member = *json.As<bool>();
    },
    [=](const Owner& owner) { return JsonValue{ owner.*member }; }, {}, {}, false, {}, {},
    [](const Owner&) { return ValueForm{ ValueForm::Truth }; } };
}

/** The key is left out where the text is empty. */
template <typename Owner>
Field<Owner> TextField(const std::string& key, std::string Owner::*member, const std::string& doc)
{
  return { key, "text", doc,
    [=](const JsonValue& json, const DocumentPlace& place, Owner& owner)
    { owner.*member = ReadText(json, place); },
    [=](const Owner& owner) -> std::optional<JsonValue> {
      return (owner.*member).empty() ? std::nullopt : std::optional(JsonValue{ owner.*member });
    } };
}

/** The key is left out where the text is empty, which is not a choice. */
template <typename Owner>
Field<Owner> ChoiceField(const std::string& key, std::string Owner::*member,
  const std::vector<std::string>& choices, const std::string& doc)
{
  Field<Owner> field = TextField(key, member, doc);
  field.Type = "one of " + ShowChoices(choices);
  field.Read = [=](const JsonValue& json, const DocumentPlace& place, Owner& owner)
  { owner.*member = ReadChoice(json, place, choices); };
  field.Form = [=](const Owner&)
  {
    ValueForm form{ ValueForm::Choice };
    form.Choices = choices;
    return form;
  };
  return field;
}

/** A text or a list of texts. */
template <typename Owner>
Field<Owner> TextsField(
  const std::string& key, std::vector<std::string> Owner::*member, const std::string& doc)
{
  return { key, "text or list of texts", doc,
    [=](const JsonValue& json, const DocumentPlace& place, Owner& owner)
    { owner.*member = ReadTexts(json, place); },
    [=](const Owner& owner) { return WriteTexts(owner.*member); }, {}, {}, false, {}, {},
    [](const Owner&) { return ValueForm{ ValueForm::Texts }; } };
}

template <typename Owner, typename Part>
Field<Owner> ObjectField(const std::string& key, Part Owner::*member, const FieldTable<Part>& parts,
  const std::string& doc)
{
  return { key, "object", doc,
    [=](const JsonValue& json, const DocumentPlace& place, Owner& owner)
    { ReadFields(parts, json, place, owner.*member); },
    [=](const Owner& owner) { return WriteFields(parts, owner.*member); },
    [=](std::string& text, const std::string& path) { DescribeFields(parts, path, text); },
    [=](const DocumentPlace& place, Owner& owner)
    { ReadFields(parts, JsonValue{ JsonValue::Object() }, place, owner.*member); },
    false, {}, {}, {},
    [=](const Owner& owner, const std::string& path, std::vector<FormField>& form)
    { AppendForm(parts, owner.*member, path, form); } };
}

template <typename Owner, typename Item>
Field<Owner> ListField(const std::string& key, std::vector<Item> Owner::*member,
  const FieldTable<Item>& parts, const std::string& doc)
{
  return { key, "list of objects", doc,
    [=](const JsonValue& json, const DocumentPlace& place, Owner& owner)
    {
      (owner.*member).clear();
      for (const JsonValue& item : ReadList(json, place))
      {
        Item& next = (owner.*member).emplace_back();
        ReadFields(parts, item, place.Item((owner.*member).size() - 1), next);
      }
    },
    [=](const Owner& owner)
    {
      JsonValue::List list;
      for (const Item& item : owner.*member)
      {
        list.push_back(WriteFields(parts, item));
      }
      return JsonValue{ std::move(list) };
    },
    [=](std::string& text, const std::string& path) { DescribeFields(parts, path + "[]", text); } };
}
///@}

template <typename Owner>
void CheckKeys(
  const FieldTable<Owner>& table, const JsonValue::Object& object, const DocumentPlace& place)
{
  std::vector<std::string> known;
  for (const Field<Owner>& field : table.Fields)
  {
    known.push_back(field.Key);
  }
  for (const JsonMember& member : object)
  {
    const bool isKnown = std::find(known.begin(), known.end(), member.Key) != known.end();
    if (!isKnown && !table.ReadOther)
    {
      place.Member(member.Key)
        .Fail("is not a key; did you mean " + NearestWord(member.Key, known) + "?");
    }
  }
}

template <typename Owner>
void ReadFields(
  const FieldTable<Owner>& table, const JsonValue& json, const DocumentPlace& place, Owner& owner)
{
  const auto* object = json.As<JsonValue::Object>();
  if (!object)
  {
    place.Fail("is " + ShowValue(json) + " where an object {…} is expected.");
  }
  CheckKeys(table, *object, place);
  for (const Field<Owner>& field : table.Fields)
  {
    const JsonValue* value = FindMember(*object, field.Key);
    if (value && !field.IsFor(owner))
    {
      if (place.IsForgiving())
      {
        continue;
      }
      place.Member(field.Key).Fail("does not apply here: it is a key of " + field.AppliesTo + ".");
    }
    if (value)
    {
      field.Read(*value, place.Member(field.Key), owner);
    }
    else if (field.IsRequired && field.IsFor(owner))
    {
      place.Member(field.Key).Fail("is missing (" + field.Type + ").");
    }
    else if (field.ReadMissing && field.IsFor(owner))
    {
      field.ReadMissing(place.Member(field.Key), owner);
    }
  }
  for (const JsonMember& member : *object)
  {
    const auto isMember = [&](const Field<Owner>& field) { return field.Key == member.Key; };
    if (table.ReadOther && std::none_of(table.Fields.begin(), table.Fields.end(), isMember))
    {
      table.ReadOther(member.Key, member.Value, place.Member(member.Key), owner);
    }
  }
  if (table.Finish)
  {
    table.Finish(place, owner);
  }
}

template <typename Owner>
JsonValue WriteFields(const FieldTable<Owner>& table, const Owner& owner)
{
  JsonValue::Object object;
  for (const Field<Owner>& field : table.Fields)
  {
    std::optional<JsonValue> value;
    if (field.IsFor(owner))
    {
      value = field.Write(owner);
    }
    if (value)
    {
      object.push_back({ field.Key, std::move(*value) });
    }
  }
  if (table.WriteOther)
  {
    table.WriteOther(owner, object);
  }
  return { std::move(object) };
}

template <typename Owner>
void AppendForm(const FieldTable<Owner>& table, const Owner& owner, const std::string& path,
  std::vector<FormField>& form)
{
  for (const Field<Owner>& field : table.Fields)
  {
    if (!field.IsFor(owner))
    {
      continue;
    }
    const std::string full = path + "." + field.Key;
    if (field.FormParts)
    {
      field.FormParts(owner, full, form);
      continue;
    }
    form.push_back({ full, field.Key, field.Type, field.Doc,
      field.Form ? field.Form(owner) : ValueForm{}, field.Write(owner), field.IsRequired });
  }
}

/** What the key holds where it is left out, if that is one plain value. */
template <typename Owner>
std::optional<JsonValue> DefaultOf(const Field<Owner>& field)
{
  return field.DescribeParts ? std::nullopt : field.Write(Owner());
}

template <typename Owner>
void DescribeFields(const FieldTable<Owner>& table, const std::string& path, std::string& text)
{
  for (const Field<Owner>& field : table.Fields)
  {
    const std::string full = path.empty() ? field.Key : path + "." + field.Key;
    text += full + ": " + field.Type;
    if (field.IsRequired)
    {
      text += ", required";
    }
    else if (const auto initial = DefaultOf(field))
    {
      text += ", default " + FormatJsonCompact(*initial);
    }
    text += ". " + field.Doc;
    text += field.AppliesTo.empty() ? "\n" : " Only of " + field.AppliesTo + ".\n";
    if (field.DescribeParts)
    {
      field.DescribeParts(text, full);
    }
  }
}

} // namespace pemesh

#endif
