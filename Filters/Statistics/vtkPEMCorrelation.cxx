// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMCorrelation.h"

#include "CaseStatus.h"
#include "Correlation.h"
#include "NumberText.h"
#include "Progress.h"
#include "Significance.h"
#include "SummaryTitles.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

vtkStandardNewMacro(vtkPEMCorrelation);

namespace
{

using Names = std::vector<std::string>;

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();
constexpr const char* FamilyNote =
  "no p-values: the rows belong to one family and are not independent, so only the trend counts";

/** What a pair of columns gives. */
struct Result
{
  vtkIdType Count = 0;
  double Pearson = Undefined;
  double Spearman = Undefined;
  double Kendall = Undefined;
  double PearsonP = Undefined;
  double SpearmanP = Undefined;
  double KendallP = Undefined;
  std::string Trend = "undefined";
  std::string Note = FamilyNote;
};

struct Options
{
  bool IndependentRows;
  pemesh::PermutationOptions Permutations;
  double TrendThreshold;
};

bool IsMetric(const std::string& name)
{
  std::string base = name;
  for (const char* subset : { "_placed", "_filler", "_polygons", "_triangles" })
  {
    if (base.ends_with(subset))
    {
      base.resize(base.size() - std::string(subset).size());
      break;
    }
  }
  return base.ends_with("_min") || base.ends_with("_max") || base.ends_with("_mean") ||
    pemesh::IsStatisticOfMetric(name);
}

/** <run>_<performance>, both not empty, and no id of an extreme element. */
bool IsPerformance(const std::string& name)
{
  const std::size_t underscore = name.find('_');
  return underscore != std::string::npos && underscore > 0 && underscore + 1 < name.size() &&
    name.find("_element") == std::string::npos && !IsMetric(name) && !pemesh::IsOfSummary(name);
}

Names NumericColumns(vtkTable* table)
{
  Names names;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    if (vtkDataArray::SafeDownCast(table->GetColumn(i)) && table->GetColumnName(i))
    {
      names.emplace_back(table->GetColumnName(i));
    }
  }
  return names;
}

/** The metrics of a table, followed by its performances if asked for. */
Names DefaultColumns(vtkTable* table, bool withPerformances)
{
  Names metrics;
  Names performances;
  for (const std::string& name : NumericColumns(table))
  {
    if (IsMetric(name))
    {
      metrics.push_back(name);
    }
    else if (withPerformances && IsPerformance(name) &&
      !pemesh::IsInFieldList(table, pemesh::MeasuredList, name))
    {
      performances.push_back(name);
    }
  }
  metrics.insert(metrics.end(), performances.begin(), performances.end());
  return metrics;
}

std::vector<std::pair<std::string, std::string>> MakePairs(const Names& x, const Names& y)
{
  std::vector<std::pair<std::string, std::string>> pairs;
  std::set<std::pair<std::string, std::string>> seen;
  for (const std::string& nameX : x)
  {
    for (const std::string& nameY : y)
    {
      if (nameX != nameY && seen.insert(std::minmax(nameX, nameY)).second)
      {
        pairs.emplace_back(nameX, nameY);
      }
    }
  }
  return pairs;
}

std::vector<double> ColumnValues(vtkTable* table, const std::string& name)
{
  auto* column = vtkDataArray::SafeDownCast(table->GetColumnByName(name.c_str()));
  std::vector<double> values(static_cast<std::size_t>(column->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = column->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return values;
}

std::string TrendOf(const pemesh::KendallCounts& counts, double tau, double threshold)
{
  const bool isUp = counts.Concordant() > 0 && (counts.Discordant == 0 || tau >= threshold);
  const bool isDown = counts.Discordant > 0 && (counts.Concordant() == 0 || tau <= -threshold);
  // Both only for a threshold of zero.
  return isUp == isDown ? "mixed" : isUp ? "increasing" : "decreasing";
}

void AddPValues(const std::vector<double>& x, const std::vector<double>& y,
  const pemesh::PermutationOptions& options, Result& result)
{
  const pemesh::PValue pearson = pemesh::PearsonPValue(x, y);
  const pemesh::PValue spearman = pemesh::SpearmanPValue(x, y, options);
  const pemesh::PValue kendall = pemesh::KendallPValue(x, y, options);
  result.PearsonP = pearson.Value;
  result.SpearmanP = spearman.Value;
  result.KendallP = kendall.Value;
  result.Note = "p-values two-sided, for independent rows, not adjusted for the number of pairs";
  if (spearman.Method != pemesh::PValueMethod::Undefined)
  {
    result.Note += std::string("; Pearson: normal samples; Spearman: ") +
      pemesh::PValueMethodName(spearman.Method) +
      "; Kendall: " + pemesh::PValueMethodName(kendall.Method);
  }
}

Result Correlate(
  const std::vector<double>& allX, const std::vector<double>& allY, const Options& options)
{
  std::vector<double> x;
  std::vector<double> y;
  pemesh::RemoveMissing(allX, allY, x, y);
  Result result;
  result.Count = static_cast<vtkIdType>(x.size());
  result.Pearson = pemesh::PearsonCorrelation(x, y);
  result.Spearman = pemesh::SpearmanCorrelation(x, y);
  const pemesh::KendallCounts counts = pemesh::CountKendallPairs(x, y);
  result.Kendall = pemesh::KendallTauB(counts);
  if (x.size() >= 3)
  {
    result.Trend = pemesh::IsConstant(x) || pemesh::IsConstant(y)
      ? "constant"
      : TrendOf(counts, result.Kendall, options.TrendThreshold);
  }
  if (options.IndependentRows)
  {
    AddPValues(x, y, options.Permutations, result);
  }
  return result;
}

template <typename Array, typename Value>
void AddColumn(vtkTable* table, const char* name, const std::vector<Result>& results, Value value)
{
  vtkNew<Array> column;
  column->SetName(name);
  column->SetNumberOfValues(static_cast<vtkIdType>(results.size()));
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    column->SetValue(static_cast<vtkIdType>(i), value(i));
  }
  table->AddColumn(column);
}

void FillTable(vtkTable* table, const std::vector<std::pair<std::string, std::string>>& pairs,
  const std::vector<Result>& all)
{
  using Text = vtkStringArray;
  using Number = vtkDoubleArray;
  AddColumn<Text>(table, "X", all, [&](std::size_t i) { return pairs[i].first; });
  AddColumn<Text>(table, "Y", all, [&](std::size_t i) { return pairs[i].second; });
  AddColumn<vtkIdTypeArray>(table, "N", all, [&](std::size_t i) { return all[i].Count; });
  AddColumn<Number>(table, "Pearson", all, [&](std::size_t i) { return all[i].Pearson; });
  AddColumn<Number>(table, "Spearman", all, [&](std::size_t i) { return all[i].Spearman; });
  AddColumn<Number>(table, "Kendall", all, [&](std::size_t i) { return all[i].Kendall; });
  AddColumn<Number>(table, "PearsonP", all, [&](std::size_t i) { return all[i].PearsonP; });
  AddColumn<Number>(table, "SpearmanP", all, [&](std::size_t i) { return all[i].SpearmanP; });
  AddColumn<Number>(table, "KendallP", all, [&](std::size_t i) { return all[i].KendallP; });
  AddColumn<Text>(table, "Trend", all, [&](std::size_t i) { return all[i].Trend; });
  AddColumn<Text>(table, "Note", all, [&](std::size_t i) { return all[i].Note; });
}

} // namespace

//------------------------------------------------------------------------------
int vtkPEMCorrelation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkPEMCorrelation::WhyUnusable(vtkTable* table, const Names& names)
{
  const Names known = NumericColumns(table);
  for (const std::string& name : names)
  {
    if (std::find(known.begin(), known.end(), name) != known.end())
    {
      continue;
    }
    if (table->GetColumnByName(name.c_str()))
    {
      return "The column \"" + name + "\" holds text: name columns that hold numbers.";
    }
    const std::string nearest = pemesh::NearestWord(name, known);
    return "The table has no column \"" + name + "\"" +
      (nearest.empty() ? std::string(".") : "; did you mean \"" + nearest + "\"?");
  }
  return {};
}

//------------------------------------------------------------------------------
int vtkPEMCorrelation::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkTable* table = vtkTable::GetData(input[0], 0);
  vtkTable* results = vtkTable::GetData(output, 0);
  for (const Names* names : { &this->XColumns, &this->YColumns })
  {
    const std::string reason = WhyUnusable(table, *names);
    if (!reason.empty())
    {
      vtkErrorMacro(<< reason);
      return 0;
    }
  }
  const Names x = this->XColumns.empty() ? DefaultColumns(table, false) : this->XColumns;
  const Names y = this->YColumns.empty() ? DefaultColumns(table, true) : this->YColumns;
  const auto pairs = MakePairs(x, y);
  std::map<std::string, std::vector<double>> values;
  for (const auto& [nameX, nameY] : pairs)
  {
    for (const std::string& name : { nameX, nameY })
    {
      if (!values.count(name))
      {
        values.emplace(name, ColumnValues(table, name));
      }
    }
  }
  const Options options{ this->IndependentRows,
    { this->Permutations, static_cast<std::uint64_t>(this->Seed) }, this->TrendThreshold };
  std::vector<Result> all;
  all.reserve(pairs.size());
  const std::size_t portion = std::max<std::size_t>(pairs.size() / 50, 1);
  for (const auto& [nameX, nameY] : pairs)
  {
    all.push_back(Correlate(values.at(nameX), values.at(nameY), options));
    const double fraction = static_cast<double>(all.size()) / static_cast<double>(pairs.size());
    if (all.size() % portion == 0 && !pemesh::ReportProgress(this, fraction))
    {
      results->Initialize();
      return 1;
    }
  }
  FillTable(results, pairs, all);
  return 1;
}

//------------------------------------------------------------------------------
void vtkPEMCorrelation::SetXColumns(const Names& names)
{
  if (this->XColumns != names)
  {
    this->XColumns = names;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
Names vtkPEMCorrelation::GetXColumns() const
{
  return this->XColumns;
}

//------------------------------------------------------------------------------
void vtkPEMCorrelation::AddXColumn(const std::string& name)
{
  this->XColumns.push_back(name);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPEMCorrelation::RemoveAllXColumns()
{
  this->SetXColumns({});
}

//------------------------------------------------------------------------------
void vtkPEMCorrelation::SetYColumns(const Names& names)
{
  if (this->YColumns != names)
  {
    this->YColumns = names;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
Names vtkPEMCorrelation::GetYColumns() const
{
  return this->YColumns;
}

//------------------------------------------------------------------------------
void vtkPEMCorrelation::AddYColumn(const std::string& name)
{
  this->YColumns.push_back(name);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPEMCorrelation::RemoveAllYColumns()
{
  this->SetYColumns({});
}

//------------------------------------------------------------------------------
void vtkPEMCorrelation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto printNames = [&](const char* label, const Names& names)
  {
    os << indent << label << ":";
    for (const std::string& name : names)
    {
      os << " " << name;
    }
    os << (names.empty() ? " (default)\n" : "\n");
  };
  printNames("XColumns", this->XColumns);
  printNames("YColumns", this->YColumns);
  os << indent << "IndependentRows: " << (this->IndependentRows ? "On\n" : "Off\n");
  os << indent << "Permutations: " << this->Permutations << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "TrendThreshold: " << this->TrendThreshold << "\n";
}
