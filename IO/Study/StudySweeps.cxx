// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudySweeps.h"

#include "AgglomerationRules.h"
#include "DocumentPath.h"
#include "DomainShapes.h"
#include "ParameterFields.h"
#include "PolygonFamilies.h"
#include "StudyFields.h"
#include "Tessellations.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pemesh
{

namespace
{

double EquidistantValue(const StudySweep& sweep, int i)
{
  if (i > 0 && i + 1 == sweep.Count)
  {
    return sweep.To; // exactly
  }
  const double steps = std::max(sweep.Count - 1, 1);
  if (sweep.Spacing == "geometric")
  {
    return sweep.From * std::pow(sweep.To / sweep.From, i / steps);
  }
  // As vtkPEMPolygonLayout does it, so that both give the same bits.
  return sweep.From + i * (sweep.To - sweep.From) / steps;
}

JsonValue ToJson(const StudyScalar& scalar)
{
  const auto* number = std::get_if<double>(&scalar);
  return number ? JsonNumber(*number)
                : std::visit([](const auto& value) { return JsonValue{ value }; }, scalar);
}

/** Sweeps that advance together. */
struct SweepGroup
{
  std::vector<const StudySweep*> Sweeps;
  std::vector<std::vector<StudyScalar>> Values; // a sweep each
};

std::vector<SweepGroup> GroupSweeps(const Study& study)
{
  std::vector<SweepGroup> groups;
  for (const StudySweep& sweep : study.Sweep)
  {
    if (!sweep.Zip || groups.empty())
    {
      groups.emplace_back();
    }
    groups.back().Sweeps.push_back(&sweep);
    groups.back().Values.push_back(SweepValues(sweep));
  }
  return groups;
}

/** So that an entry that is swept gets its own defaults and not those of the one in the document.
 */
void DropAllDefaults(Study& study)
{
  DropDefaults(
    ParametersOf(EntriesOf(DomainShapes()), study.Domain.Shape), study.Domain.Parameters);
  DropDefaults(ParametersOf(EntriesOf(Tessellations()), study.Mesh.Source), study.Mesh.Parameters);
  StudyAgglomeration& agglomeration = study.Mesh.Agglomeration;
  DropDefaults(
    ParametersOf(EntriesOf(AgglomerationRules()), agglomeration.Rule), agglomeration.Parameters);
  for (StudyPolygon& polygon : study.Polygons)
  {
    DropDefaults(ParametersOf(EntriesOf(PolygonFamilies()), polygon.Family), polygon.Parameters);
  }
}

/** A swept key that does not apply would change nothing, unsaid. */
void CheckValuesCount(
  const Study& study, const std::vector<SweptValue>& values, const std::string& source)
{
  const JsonValue document = WriteFields(StudyFields(), study);
  for (const SweptValue& value : values)
  {
    if (value.Parameter != DeformationParameter && !HasPath(document, value.Parameter))
    {
      throw std::runtime_error(
        "The " + source + " would change nothing: " + value.Parameter + " does not apply there.");
    }
  }
}

} // namespace

std::vector<StudyScalar> SweepValues(const StudySweep& sweep)
{
  if (!sweep.Values.empty())
  {
    return sweep.Values;
  }
  std::vector<StudyScalar> values;
  for (int i = 0; i < sweep.Count; ++i)
  {
    values.emplace_back(EquidistantValue(sweep, i));
  }
  return values;
}

std::vector<std::vector<SweptValue>> SweepCases(const Study& study)
{
  std::vector<std::vector<SweptValue>> cases(1);
  for (const SweepGroup& group : GroupSweeps(study))
  {
    std::vector<std::vector<SweptValue>> next;
    next.reserve(cases.size() * group.Values.front().size());
    for (const std::vector<SweptValue>& before : cases)
    {
      for (std::size_t i = 0; i < group.Values.front().size(); ++i)
      {
        next.push_back(before);
        for (std::size_t j = 0; j < group.Sweeps.size(); ++j)
        {
          const StudySweep& sweep = *group.Sweeps[j];
          next.back().push_back({ sweep.Parameter, sweep.Name, group.Values[j].at(i) });
        }
      }
    }
    cases = std::move(next);
  }
  return cases;
}

double DeformationOf(const std::vector<SweptValue>& values)
{
  const auto found = std::find_if(values.begin(), values.end(),
    [](const SweptValue& value) { return value.Parameter == DeformationParameter; });
  return found == values.end() ? 0.0 : ScalarToNumber(found->Value);
}

Study MakeStudyOfCase(const Study& study, const std::vector<SweptValue>& values)
{
  Study plain = study;
  plain.Sweep.clear();
  plain.Plots.clear();
  const bool isPlain = std::all_of(values.begin(), values.end(),
    [](const SweptValue& value) { return value.Parameter == DeformationParameter; });
  if (isPlain)
  {
    return plain;
  }
  DropAllDefaults(plain);
  JsonValue document = WriteFields(StudyFields(), plain);
  std::string source = "sweep";
  for (const SweptValue& value : values)
  {
    if (value.Parameter != DeformationParameter)
    {
      source += (source == "sweep" ? " of " : " and of ") + value.Parameter + " at " +
        FormatScalar(value.Value);
      SetAtPath(document, value.Parameter, ToJson(value.Value), "The " + source);
    }
  }
  // A swept choice, say of the source, leaves behind keys that belong to another one.
  DocumentPlace place(source);
  place.SetForgiving(true);
  Study result;
  result.Folder = study.Folder;
  ReadFields(StudyFields(), document, place, result);
  CheckValuesCount(result, values, source);
  return result;
}

} // namespace pemesh
