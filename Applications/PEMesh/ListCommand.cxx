// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * list: prints the tables that everything else is driven by.
 */
#include "AgglomerationRules.h"
#include "AreaRules.h"
#include "ChartKinds.h"
#include "ChartOptions.h"
#include "ChartStyle.h"
#include "Commands.h"
#include "DomainShapes.h"
#include "MeshChecks.h"
#include "MeshFormats.h"
#include "MeshMetrics.h"
#include "MetricRegistry.h"
#include "NumberText.h"
#include "PolygonFamilies.h"
#include "SolverDescription.h"
#include "SolverDescriptionFile.h"
#include "Terminal.h"
#include "Tessellations.h"
#include "TestProblems.h"
#include "ValueStatistics.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>

namespace pemesh
{

namespace
{

using Json = nlohmann::ordered_json;

Json ParametersAsJson(std::span<const Parameter> parameters)
{
  Json list = Json::array();
  for (const Parameter& parameter : parameters)
  {
    Json entry = { { "name", parameter.Name }, { "description", parameter.Description },
      { "default", parameter.Default }, { "least", parameter.Least } };
    if (std::isfinite(parameter.Greatest)) // JSON has no infinity
    {
      entry["greatest"] = parameter.Greatest;
    }
    entry["integer"] = parameter.IsInteger;
    list.push_back(entry);
  }
  return list;
}

Json FamiliesAsJson()
{
  Json list = Json::array();
  for (const PolygonFamily& family : PolygonFamilies())
  {
    Json entry = { { "name", family.Name }, { "label", family.Label },
      { "description", family.Description }, { "stepped", family.Stepped },
      { "reference", family.Reference } };
    entry["parameters"] = ParametersAsJson(family.Parameters);
    list.push_back(entry);
  }
  return list;
}

/** The words of --only that a metric is part of. */
Json CollectionsOf(const Metric& metric)
{
  Json names = Json::array();
  for (const MetricCollection& collection : MetricCollections())
  {
    if (collection.Contains(metric))
    {
      names.push_back(collection.Name);
    }
  }
  return names;
}

const char* WordForGood(int good)
{
  return good > 0 ? "up" : good < 0 ? "down" : "none";
}

Json MetricsAsJson()
{
  Json list = Json::array();
  for (const Metric& metric : Metrics())
  {
    const char* good = WordForGood(metric.Good);
    list.push_back(
      { { "name", metric.Name }, { "symbol", metric.Symbol }, { "label", metric.Label },
        { "formula", metric.Formula }, { "tex", metric.Tex }, { "description", metric.Description },
        { "range", metric.Range }, { "good", good }, { "scale-invariant", metric.ScaleInvariant },
        { "rotation-invariant", metric.RotationInvariant }, { "unit", metric.Unit },
        { "reference", metric.Reference }, { "needs", DescribeNeeds(metric.Needs) },
        { "alias", metric.Alias }, { "collections", CollectionsOf(metric) },
        { "test", MetricTest(metric) } });
  }
  return list;
}

Json MeshMetricsAsJson()
{
  Json list = Json::array();
  for (const MeshMetric& metric : MeshMetrics())
  {
    list.push_back({ { "name", metric.Name }, { "label", metric.Label },
      { "formula", metric.Formula }, { "tex", metric.Tex }, { "description", metric.Description },
      { "good", WordForGood(metric.Good) }, { "unit", metric.Unit },
      { "reference", metric.Reference }, { "base", metric.Base } });
  }
  return list;
}

/** Of a table of what columns of a summary are made of. */
template <typename Table>
Json SuffixesAsJson(const Table& table)
{
  Json list = Json::array();
  for (const auto& entry : table)
  {
    list.push_back(
      { { "name", entry.Name }, { "suffix", entry.Suffix }, { "description", entry.Description } });
  }
  return list;
}

Json StatisticsAsJson()
{
  return SuffixesAsJson(Statistics());
}

Json GroupsAsJson()
{
  return SuffixesAsJson(ElementGroups());
}

Json SolversAsJson()
{
  Json list = Json::array();
  for (const FoundSolver& found : ListSolvers())
  {
    if (!found.Error.empty())
    {
      Complain(found.Error);
      continue;
    }
    Json performances = Json::array();
    for (const SolverPerformance& performance : found.Description.Performances)
    {
      performances.push_back(performance.Name);
    }
    list.push_back({ { "name", found.Description.Name }, { "label", found.Description.Label },
      { "file", found.File.string() }, { "performances", performances } });
  }
  return list;
}

Json ProblemsAsJson()
{
  Json list = Json::array();
  for (const TestProblem& problem : TestProblems())
  {
    list.push_back(
      { { "name", problem.Name }, { "label", problem.Label }, { "formula", problem.Formula } });
  }
  return list;
}

/** Of a table whose entries have parameters. */
template <typename Table>
Json EntriesAsJson(const Table& table)
{
  Json list = Json::array();
  for (const auto& entry : table)
  {
    list.push_back({ { "name", entry.Name }, { "label", entry.Label },
      { "description", entry.Description }, { "parameters", ParametersAsJson(entry.Parameters) } });
  }
  return list;
}

Json DomainsAsJson()
{
  return EntriesAsJson(DomainShapes());
}

Json SourcesAsJson()
{
  Json list = Json::array();
  list.push_back({ { "name", "triangulation" }, { "label", "Triangulation" },
    { "description", "Triangles around placed polygons; see the keys of mesh in a study." },
    { "parameters", Json::array() } });
  for (const Json& entry : EntriesAsJson(Tessellations()))
  {
    list.push_back(entry);
  }
  return list;
}

/** Those for the area of triangles and those for the merging of elements. */
Json RulesAsJson()
{
  Json list = Json::array();
  for (const AreaRule& rule : AreaRules())
  {
    list.push_back({ { "of", "max-area" }, { "name", rule.Name }, { "label", rule.Label },
      { "description", rule.Formula } });
  }
  for (Json& entry : EntriesAsJson(AgglomerationRules()))
  {
    Json rule = { { "of", "agglomerate" } };
    rule.update(entry);
    list.push_back(rule);
  }
  return list;
}

Json ChecksAsJson()
{
  Json list = Json::array();
  for (const MeshCheck& check : MeshChecks())
  {
    list.push_back({ { "name", check.Name }, { "label", check.Label },
      { "severity", check.Severity == CheckSeverity::Error ? "error" : "warning" },
      { "repairable", check.IsRepairable }, { "description", check.Description } });
  }
  return list;
}

Json ChartsAsJson()
{
  Json list = Json::array();
  for (const ChartKind& kind : ChartKinds())
  {
    list.push_back({ { "name", kind.Name }, { "label", kind.Label }, { "columns", kind.Columns },
      { "description", kind.Description }, { "options", kind.Options } });
  }
  return list;
}

/** Of a table of settings. */
template <typename Owner>
Json SettingsAsJson(std::span<const SettingField<Owner>> fields)
{
  Json list = Json::array();
  for (const SettingField<Owner>& field : fields)
  {
    list.push_back(
      { { "name", field.Name }, { "label", field.Label }, { "type", DescribeSetting(field) },
        { "default", GetSetting(field, Owner()) }, { "description", field.Description } });
  }
  return list;
}

Json StyleAsJson()
{
  return SettingsAsJson(ChartStyleFields());
}

Json PlotOptionsAsJson()
{
  return SettingsAsJson(ChartOptionFields());
}

Json FormatsAsJson()
{
  Json list = Json::array();
  for (const MeshFormat& format : MeshFormats())
  {
    std::string files;
    for (const char* extension : format.Extensions)
    {
      files += (files.empty() ? "" : " ") + std::string(extension);
    }
    const int most = format.MostCorners;
    list.push_back({ { "name", format.Name }, { "label", format.Label }, { "files", files },
      { "elements", most == 0 ? "any" : "up to " + std::to_string(most) + " vertices" },
      { "keeps-vertices", format.KeepsVertices }, { "keeps-arrays", format.KeepsArrays },
      { "description", format.Description }, { "reference", format.Reference } });
  }
  return list;
}

/** A table for people: a line an entry, the keys of `columns` side by side. */
void PrintTable(const Json& list, const std::vector<std::string>& columns)
{
  std::map<std::string, std::size_t> widths;
  for (const Json& entry : list)
  {
    for (const std::string& column : columns)
    {
      widths[column] = std::max(widths[column], entry[column].get<std::string>().size());
    }
  }
  for (const Json& entry : list)
  {
    std::string line;
    for (const std::string& column : columns)
    {
      std::string field = entry[column].get<std::string>();
      field.resize(widths[column] + 2, ' ');
      line += field;
    }
    line.erase(line.find_last_not_of(' ') + 1);
    std::cout << line << "\n";
  }
}

/** The entry of that name; throws a sentence with the nearest one. */
Json FindEntry(const Json& list, const std::string& what, const std::string& name)
{
  std::vector<std::string> names;
  for (const Json& entry : list)
  {
    names.push_back(entry["name"].get<std::string>());
    if (names.back() == name)
    {
      return Json::array({ entry });
    }
  }
  throw std::runtime_error("There is no \"" + name + "\" among the " + what +
    "; the nearest is \"" + NearestWord(name, names) + "\".");
}

/** All of one entry, a line a key. */
void PrintEntry(const Json& entry)
{
  for (const auto& [key, value] : entry.items())
  {
    if (!value.empty() && value != "")
    {
      std::cout << key << ": " << (value.is_string() ? value.get<std::string>() : value.dump())
                << "\n";
    }
  }
}

struct Listing
{
  const char* Name;
  Json (*Make)();
  std::vector<std::string> Columns;
};

const std::vector<Listing>& Listings()
{
  static const std::vector<Listing> listings = {
    { "families", FamiliesAsJson, { "name", "description" } },
    { "metrics", MetricsAsJson, { "name", "symbol", "range", "good", "unit", "formula" } },
    { "mesh-metrics", MeshMetricsAsJson, { "name", "good", "unit", "description" } },
    { "statistics", StatisticsAsJson, { "name", "suffix", "description" } },
    { "groups", GroupsAsJson, { "name", "suffix", "description" } },
    { "solvers", SolversAsJson, { "name", "label" } },
    { "problems", ProblemsAsJson, { "name", "formula" } },
    { "domains", DomainsAsJson, { "name", "description" } },
    { "sources", SourcesAsJson, { "name", "description" } },
    { "rules", RulesAsJson, { "of", "name", "description" } },
    { "charts", ChartsAsJson, { "name", "columns", "description" } },
    { "chart-options", PlotOptionsAsJson, { "name", "type", "default", "description" } },
    { "style", StyleAsJson, { "name", "type", "default", "description" } },
    { "formats", FormatsAsJson, { "name", "files", "elements", "label" } },
    { "checks", ChecksAsJson, { "name", "severity", "description" } },
  };
  return listings;
}

} // namespace

void AddListCommand(CLI::App& program, int& exitCode)
{
  struct Arguments
  {
    std::string What;
    std::string Name;
    bool AsJson = false;
  };
  auto arguments = std::make_shared<Arguments>();
  std::vector<std::string> names;
  for (const Listing& listing : Listings())
  {
    names.emplace_back(listing.Name);
  }
  CLI::App* command = program.add_subcommand("list",
    "List polygon families, domains, sources of meshes, rules, metrics, checks, solvers, test "
    "problems, kinds of charts, mesh formats, settings of their style and more");
  command->add_option("WHAT", arguments->What, "What to list")
    ->required()
    ->check(CLI::IsMember(names));
  command->add_option("NAME", arguments->Name, "One of them: prints all that is known of it");
  command->add_flag("--json", arguments->AsJson, "As JSON, with everything that is known");
  command->callback(
    [arguments, &exitCode]
    {
      for (const Listing& listing : Listings())
      {
        if (arguments->What == listing.Name)
        {
          const Json all = listing.Make();
          const bool isOne = !arguments->Name.empty();
          const Json list = isOne ? FindEntry(all, arguments->What, arguments->Name) : all;
          if (arguments->AsJson)
          {
            std::cout << list.dump(2) << "\n";
          }
          else
          {
            isOne ? PrintEntry(list.front()) : PrintTable(list, listing.Columns);
          }
        }
      }
      exitCode = AllDone;
    });
}

} // namespace pemesh
