// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DocumentPath.h"

#include "DocumentFields.h"

#include <algorithm>
#include <span>
#include <stdexcept>

namespace pemesh
{

namespace
{

constexpr const char* EveryItem = "*";

struct PathSetter
{
  const JsonValue& Value;
  const std::string& Shown;

  void SetItems(
    JsonValue::List& list, const std::string& key, std::span<const std::string> rest) const
  {
    if (key == EveryItem)
    {
      for (JsonValue& item : list)
      {
        this->Set(item, rest);
      }
      return;
    }
    const std::optional<long long> index = ParseInteger(key);
    if (!index || *index < 0 || static_cast<std::size_t>(*index) >= list.size())
    {
      throw std::runtime_error(this->Shown + " names item \"" + key + "\" of a list of " +
        std::to_string(list.size()) + ": items count from 0.");
    }
    this->Set(list[static_cast<std::size_t>(*index)], rest);
  }

  void Set(JsonValue& target, std::span<const std::string> keys) const
  {
    if (keys.empty())
    {
      target = this->Value;
      return;
    }
    const std::string& key = keys.front();
    if (auto* list = target.As<JsonValue::List>())
    {
      this->SetItems(*list, key, keys.subspan(1));
      return;
    }
    auto* object = target.As<JsonValue::Object>();
    if (!object)
    {
      throw std::runtime_error(this->Shown + " looks for \"" + key + "\" in " + ShowValue(target) +
        ", which has no members.");
    }
    JsonValue* member = FindMember(*object, key);
    this->Set(
      member ? *member : object->emplace_back(JsonMember{ key, { JsonValue::Object() } }).Value,
      keys.subspan(1));
  }
};

bool HasKeys(const JsonValue& value, std::span<const std::string> keys)
{
  if (keys.empty())
  {
    return true;
  }
  if (const auto* list = value.As<JsonValue::List>())
  {
    const std::optional<long long> index = ParseInteger(keys.front());
    const auto has = [&](const JsonValue& item) { return HasKeys(item, keys.subspan(1)); };
    return keys.front() == EveryItem
      ? std::all_of(list->begin(), list->end(), has)
      : index && *index >= 0 && static_cast<std::size_t>(*index) < list->size() &&
        has((*list)[static_cast<std::size_t>(*index)]);
  }
  const auto* object = value.As<JsonValue::Object>();
  const JsonValue* member = object ? FindMember(*object, keys.front()) : nullptr;
  return member && HasKeys(*member, keys.subspan(1));
}

const JsonValue* FindKeys(const JsonValue& value, std::span<const std::string> keys)
{
  if (keys.empty())
  {
    return &value;
  }
  if (const auto* list = value.As<JsonValue::List>())
  {
    const std::optional<long long> index = ParseInteger(keys.front());
    return index && *index >= 0 && static_cast<std::size_t>(*index) < list->size()
      ? FindKeys((*list)[static_cast<std::size_t>(*index)], keys.subspan(1))
      : nullptr;
  }
  const auto* object = value.As<JsonValue::Object>();
  const JsonValue* member = object ? FindMember(*object, keys.front()) : nullptr;
  return member ? FindKeys(*member, keys.subspan(1)) : nullptr;
}

} // namespace

std::vector<std::string> SplitDocumentPath(std::string_view path)
{
  std::vector<std::string> keys(1);
  for (const char c : path)
  {
    if (c == '.' || c == '[')
    {
      keys.emplace_back();
    }
    else if (c != ']')
    {
      keys.back() += c;
    }
  }
  return keys;
}

void SetAtPath(
  JsonValue& document, std::string_view path, const JsonValue& value, const std::string& shown)
{
  const std::vector<std::string> keys = SplitDocumentPath(path);
  constexpr std::size_t deepest = 32;
  if (keys.size() > deepest || std::find(keys.begin(), keys.end(), "") != keys.end())
  {
    throw std::runtime_error(shown +
      " has no proper path: write it like mesh.min-angle, polygons[0].scale or "
      "polygons[*].scale.");
  }
  PathSetter{ value, shown }.Set(document, keys);
}

bool HasPath(const JsonValue& document, std::string_view path)
{
  return HasKeys(document, SplitDocumentPath(path));
}

const JsonValue* FindAtPath(const JsonValue& document, std::string_view path)
{
  return FindKeys(document, SplitDocumentPath(path));
}

void RemoveAtPath(JsonValue& document, std::string_view path)
{
  const std::vector<std::string> keys = SplitDocumentPath(path);
  auto* owner = const_cast<JsonValue*>(
    FindKeys(document, std::span<const std::string>(keys).first(keys.size() - 1)));
  if (auto* list = owner ? owner->As<JsonValue::List>() : nullptr)
  {
    const std::optional<long long> index = ParseInteger(keys.back());
    if (index && *index >= 0 && static_cast<std::size_t>(*index) < list->size())
    {
      list->erase(list->begin() + *index);
    }
  }
  else if (auto* object = owner ? owner->As<JsonValue::Object>() : nullptr)
  {
    std::erase_if(*object, [&](const JsonMember& member) { return member.Key == keys.back(); });
  }
}

} // namespace pemesh
