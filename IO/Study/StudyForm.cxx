// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyForm.h"

#include "DocumentPath.h"
#include "StudyFields.h"

namespace pemesh
{

namespace
{

/** The fields of the item that a path names in a list of the study. */
template <typename Item>
void AppendItem(const FieldTable<Item>& table, const std::vector<Item>& items,
  const std::string& path, std::vector<FormField>& form)
{
  const std::vector<std::string> keys = SplitDocumentPath(path);
  const std::optional<long long> index = keys.size() == 2 ? ParseInteger(keys[1]) : std::nullopt;
  if (index && *index >= 0 && static_cast<std::size_t>(*index) < items.size())
  {
    AppendForm(table, items[static_cast<std::size_t>(*index)], path, form);
  }
}

struct FormPart
{
  const char* Key;
  void (*Append)(const Study& study, const std::string& path, std::vector<FormField>& form);
};

const FormPart Parts[] = {
  { "domain",
    [](const Study& study, const std::string& path, std::vector<FormField>& form)
    { AppendForm(DomainFields(), study.Domain, path, form); } },
  { "mesh",
    [](const Study& study, const std::string& path, std::vector<FormField>& form)
    { AppendForm(MeshFields(), study.Mesh, path, form); } },
  { "scatter",
    [](const Study& study, const std::string& path, std::vector<FormField>& form)
    {
      if (study.Scatter)
      {
        AppendForm(ScatterFields(), *study.Scatter, path, form);
      }
    } },
  { "polygons",
    [](const Study& study, const std::string& path, std::vector<FormField>& form)
    { AppendItem(PolygonFields(), study.Polygons, path, form); } },
  { "sweep",
    [](const Study& study, const std::string& path, std::vector<FormField>& form)
    { AppendItem(SweepFields(), study.Sweep, path, form); } },
  { "solvers",
    [](const Study& study, const std::string& path, std::vector<FormField>& form)
    { AppendItem(SolverFields(), study.Solvers, path, form); } },
};

/** What keys that a choice requires begin with. */
constexpr std::pair<const char*, double> FirstValues[] = {
  { "mesh.max-area.value", 0.01 },
  { "mesh.target.value", 1000.0 },
};

std::string OwnerOf(const std::string& path)
{
  return path.substr(0, path.rfind('.'));
}

/** Takes keys that do not apply out of one object. */
void DropMisplaced(JsonValue& document, const std::string& owner, const Study& study)
{
  std::vector<FormField> form = DescribeStudyForm(study, owner.substr(0, owner.find('.')));
  const auto* object = FindAtPath(document, owner)->As<JsonValue::Object>();
  std::vector<std::string> misplaced;
  for (const JsonMember& member : *object)
  {
    const std::string path = owner + "." + member.Key;
    const auto isPart = [&path](const FormField& field)
    { return field.Path == path || field.Path.starts_with(path + "."); };
    if (std::none_of(form.begin(), form.end(), isPart))
    {
      misplaced.push_back(path);
    }
  }
  for (const std::string& path : misplaced)
  {
    RemoveAtPath(document, path);
  }
}

} // namespace

JsonValue ChooseInDocument(
  const JsonValue& document, const std::string& path, const std::string& choice)
{
  JsonValue chosen = document;
  SetAtPath(chosen, path, { choice }, path);
  for (const auto& [key, value] : FirstValues)
  {
    if (OwnerOf(key) == OwnerOf(path) && !HasPath(chosen, key))
    {
      SetAtPath(chosen, key, JsonNumber(value), path);
    }
  }
  DocumentPlace place("study");
  place.SetForgiving(true);
  Study study;
  study.Sweep = { UndecidedSweep() };
  ReadFields(StudyFields(), chosen, place, study);
  DropMisplaced(chosen, OwnerOf(path), study);
  return chosen;
}

std::vector<FormField> DescribeStudyForm(const Study& study, const std::string& path)
{
  std::vector<FormField> form;
  const std::string first = SplitDocumentPath(path).front();
  for (const FormPart& part : Parts)
  {
    if (first == part.Key)
    {
      part.Append(study, path, form);
    }
  }
  return form;
}

} // namespace pemesh
