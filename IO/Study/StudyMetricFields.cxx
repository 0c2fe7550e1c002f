// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementSelection.h"
#include "MetricSelection.h"
#include "StudyFields.h"
#include "ValueStatistics.h"

#include <set>

namespace pemesh
{

namespace
{

constexpr const char* NamesKey = "names";
constexpr const char* SelectedGroup = "selected";

/** Texts that are names of a table, each once. */
std::vector<std::string> ReadNames(
  const JsonValue& json, const DocumentPlace& place, const NameChoices& choices)
{
  const std::vector<std::string> names = ReadTexts(json, place);
  std::set<std::string> seen;
  for (const std::string& name : names)
  {
    if (!choices.Has(name))
    {
      place.Fail("names \"" + name + "\", which is no " + choices.What + "; did you mean \"" +
        choices.Nearest(name) + "\"?");
    }
    if (!seen.insert(name).second)
    {
      place.Fail("names \"" + name + "\" twice.");
    }
  }
  return names;
}

using NameList = std::vector<std::string> StudyMetrics::*;

Field<StudyMetrics> NamesField(
  const std::string& key, NameList member, const NameChoices& choices, const std::string& doc)
{
  Field<StudyMetrics> field = TextsField(key, member, doc);
  field.Read = [=](const JsonValue& json, const DocumentPlace& place, StudyMetrics& metrics)
  { metrics.*member = ReadNames(json, place, choices); };
  field.Write = [=](const StudyMetrics& metrics) { return WriteTextList(metrics.*member); };
  return field;
}

Field<StudyMetrics> QuantilesField()
{
  return { "quantiles", "number between 0 and 1 or list of such",
    "Quantiles of each metric, as fractions: 0.5 is the median.",
    [](const JsonValue& json, const DocumentPlace& place, StudyMetrics& metrics)
    {
      const NumberRange range{ 0.0, 1.0 };
      metrics.Quantiles.clear();
      if (json.IsNumber())
      {
        metrics.Quantiles.push_back(ReadNumber(json, place, range));
        return;
      }
      for (const JsonValue& item : ReadList(json, place))
      {
        const DocumentPlace where = place.Item(metrics.Quantiles.size());
        metrics.Quantiles.push_back(ReadNumber(item, where, range));
      }
    },
    [](const StudyMetrics& metrics)
    {
      JsonValue::List list;
      for (const double fraction : metrics.Quantiles)
      {
        list.push_back(JsonNumber(fraction));
      }
      return JsonValue{ std::move(list) };
    } };
}

Field<StudyMetrics> SelectionField()
{
  Field<StudyMetrics> field = TextField("selection", &StudyMetrics::Selection,
    std::string("The elements of the group selected: ") + ElementSelectionForm +
      ", both ends included and either left out, or a cell array that is not zero there.");
  field.Read = [](const JsonValue& json, const DocumentPlace& place, StudyMetrics& metrics)
  {
    metrics.Selection = ReadText(json, place);
    std::string fault;
    const ElementSelection selection = ParseElementSelection(metrics.Selection, fault);
    if (selection.Array.empty())
    {
      place.Fail(
        "is wrong. " + (fault.empty() ? "It is empty: write it like MinAngle:0.1:0.5." : fault));
    }
  };
  return std::move(field).Required().Only([](const StudyMetrics& metrics)
    { return std::ranges::count(metrics.Groups, SelectedGroup) > 0; },
    std::string("groups with ") + SelectedGroup);
}

const FieldTable<StudyMetrics>& MetricFields()
{
  static const FieldTable<StudyMetrics> fields = []
  {
    FieldTable<StudyMetrics> table;
    table.Fields = { NamesField(NamesKey, &StudyMetrics::Names, MetricChoices(),
                       "Metrics by name, and words that stand for several: all, neighbourhood, "
                       "jumps, solver."),
      NamesField("mesh", &StudyMetrics::Mesh, MeshMetricChoices(),
        "Numbers of whole meshes, of " + ShowChoices(MeshMetricChoices().Known) +
          "; usual are those that cost next to nothing or are made of a metric chosen."),
      NamesField("statistics", &StudyMetrics::Statistics, StatisticChoices(),
        "What is told of each metric, of " + ShowChoices(StatisticChoices().Known) + "."),
      NamesField("groups", &StudyMetrics::Groups, ElementGroupChoices(),
        "Over which elements, of " + ShowChoices(ElementGroupChoices().Known) + "."),
      QuantilesField(),
      IntegerField("histogram", &StudyMetrics::HistogramBins, 0, MostHistogramBins,
        "Bins of a histogram of each metric; 0: none."),
      SelectionField() };
    return table;
  }();
  return fields;
}

} // namespace

Field<Study> MetricsField()
{
  Field<Study> field = ObjectField("metrics", &Study::Metrics, MetricFields(),
    "What is measured, and what the results tell of it. A text or a list stands for its names.");
  field.Type = "object, text or list of texts";
  field.Read = [readParts = field.Read](
                 const JsonValue& json, const DocumentPlace& place, Study& study)
  {
    if (json.As<JsonValue::Object>())
    {
      readParts(json, place, study);
      return;
    }
    study.Metrics = StudyMetrics();
    study.Metrics.Names = ReadNames(json, place, MetricChoices());
  };
  return field;
}

} // namespace pemesh
