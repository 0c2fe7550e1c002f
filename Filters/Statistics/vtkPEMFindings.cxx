// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMFindings.h"

#include "CaseStatus.h"
#include "ColumnRoles.h"
#include "RankedMetrics.h"
#include "RelationWords.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

vtkStandardNewMacro(vtkPEMFindings);

namespace
{

using pemesh::RankedMetric;

constexpr std::array<const char*, 14> NeededColumns{ "X", "Y", "N", "Families", "Coefficient",
  "Tested", "P", "PHolm", "PBenjaminiHochberg", "Low", "High", "FormFit", "DistanceCorrelation",
  "Words" };
constexpr std::array<const char*, 6> CopiedNumbers{ "Tested", "P", "PHolm", "PBenjaminiHochberg",
  "Low", "High" };

/** A performance and its metrics. */
struct Ranking
{
  std::string Performance;
  std::vector<RankedMetric> Metrics;
  std::string Joint;
};

double NumberAt(vtkTable* table, const char* column, vtkIdType row)
{
  return table->GetValueByName(row, column).ToDouble();
}

std::string TextAt(vtkTable* table, const char* column, vtkIdType row)
{
  return table->GetValueByName(row, column).ToString();
}

/** The performances in the order of the list, each with the metrics paired with it. */
std::vector<Ranking> GatherRankings(vtkTable* pairs)
{
  std::vector<Ranking> rankings;
  auto* names =
    vtkStringArray::SafeDownCast(pairs->GetFieldData()->GetAbstractArray(pemesh::PerformancesList));
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
  {
    rankings.push_back({ names->GetValue(i), {}, {} });
  }
  for (vtkIdType row = 0; row < pairs->GetNumberOfRows(); ++row)
  {
    const std::string performance = TextAt(pairs, "Y", row);
    const auto found = std::find_if(rankings.begin(), rankings.end(),
      [&](const Ranking& ranking) { return ranking.Performance == performance; });
    if (found == rankings.end())
    {
      continue;
    }
    RankedMetric metric;
    metric.Name = TextAt(pairs, "X", row);
    metric.Pair = row;
    metric.Tested = NumberAt(pairs, "Tested", row);
    metric.Fit = NumberAt(pairs, "FormFit", row);
    metric.Distance = NumberAt(pairs, "DistanceCorrelation", row);
    metric.Words = TextAt(pairs, "Words", row);
    found->Metrics.push_back(std::move(metric));
  }
  std::erase_if(rankings, [](const Ranking& ranking) { return ranking.Metrics.empty(); });
  return rankings;
}

pemesh::RowFamilies FamiliesOf(vtkTable* pairs, vtkTable* series)
{
  const std::string rows = pemesh::GetFieldText(pairs, "Rows");
  const auto count = static_cast<std::size_t>(series->GetNumberOfRows());
  if (rows == "independent")
  {
    return pemesh::SingleRows(count);
  }
  const std::string column = pemesh::GetFieldText(pairs, "FamilyColumn");
  return rows == "families" && series->GetColumnByName(column.c_str())
    ? pemesh::GroupRows(pemesh::ColumnTexts(series, column))
    : pemesh::GroupRows(std::vector<std::string>(count));
}

void Rank(Ranking& ranking, vtkTable* series, const pemesh::RowFamilies& families)
{
  pemesh::RankMetrics(ranking.Metrics);
  std::vector<std::vector<double>> values;
  for (const RankedMetric& metric : ranking.Metrics)
  {
    values.push_back(pemesh::ColumnNumbers(series, metric.Name));
  }
  ranking.Joint = pemesh::RankJointly(
    ranking.Metrics, values, pemesh::ColumnNumbers(series, ranking.Performance), families);
}

/** "MinAngle_min: strong negative (-0.98), …; p 0.001, corrected 0.04 (Holm)." */
std::string SentenceOf(const RankedMetric& metric, vtkTable* pairs)
{
  std::string text = metric.Name + ": " + metric.Words;
  if (metric.Rank == 0)
  {
    return text + ".";
  }
  text +=
    "; " + TextAt(pairs, "Coefficient", metric.Pair) + " " + pemesh::RoundedNumber(metric.Tested);
  const double low = NumberAt(pairs, "Low", metric.Pair);
  if (!std::isnan(low))
  {
    text += " [" + pemesh::RoundedNumber(low) + ", " +
      pemesh::RoundedNumber(NumberAt(pairs, "High", metric.Pair)) + "]";
  }
  const double p = NumberAt(pairs, "P", metric.Pair);
  if (!std::isnan(p))
  {
    text += ", p " + pemesh::RoundedNumber(p) + " (Holm " +
      pemesh::RoundedNumber(NumberAt(pairs, "PHolm", metric.Pair)) + ", Benjamini-Hochberg " +
      pemesh::RoundedNumber(NumberAt(pairs, "PBenjaminiHochberg", metric.Pair)) + ")";
  }
  return text + ".";
}

/** What is to be known before the list is read. */
std::string Heading(const Ranking& ranking, vtkTable* pairs)
{
  const vtkIdType first = ranking.Metrics.front().Pair;
  const auto rows = pairs->GetValueByName(first, "N").ToLongLong();
  const auto families = pairs->GetValueByName(first, "Families").ToLongLong();
  std::string text =
    ranking.Performance + " (" + std::to_string(rows) + (rows == 1 ? " row" : " rows");
  text += pemesh::GetFieldText(pairs, "Rows") == "families"
    ? " of " + std::to_string(families) + " families"
    : std::string();
  return text + ")";
}

void AppendRanking(std::string& text, const Ranking& ranking, vtkTable* pairs, std::size_t most)
{
  const auto defined = static_cast<std::size_t>(std::count_if(ranking.Metrics.begin(),
    ranking.Metrics.end(), [](const RankedMetric& metric) { return metric.Rank > 0; }));
  text += Heading(ranking, pairs) + "\n";
  for (const RankedMetric& metric : ranking.Metrics)
  {
    if (metric.Rank == 0 || metric.Rank > static_cast<int>(most))
    {
      break;
    }
    text += "  " + std::to_string(metric.Rank) + ". " + SentenceOf(metric, pairs) + "\n";
  }
  if (defined > most)
  {
    text += "  ... and " + std::to_string(defined - most) + " more.\n";
  }
  if (const std::size_t ties = pemesh::CountTiesAtTop(ranking.Metrics); ties > 1)
  {
    text += "  The first " + std::to_string(ties) +
      " are equally strong: these rows do not tell them apart.\n";
  }
  if (defined < ranking.Metrics.size())
  {
    const RankedMetric& left = ranking.Metrics[defined];
    text += "  Without a coefficient: " + std::to_string(ranking.Metrics.size() - defined) +
      ", as " + SentenceOf(left, pairs) + "\n";
  }
  text += "  " + ranking.Joint + "\n";
}

std::string TextOf(const std::vector<Ranking>& rankings, vtkTable* pairs, int most)
{
  if (rankings.empty())
  {
    return "No performance and metric to compare: the table holds no column of the form "
           "<run>_<performance>, or no metric; name columns of numbers.\n";
  }
  std::string text;
  for (const Ranking& ranking : rankings)
  {
    AppendRanking(text, ranking, pairs, static_cast<std::size_t>(most));
    text += "\n";
  }
  return text + "Note: " + pemesh::GetFieldText(pairs, "Note") + ".\n";
}

template <typename Array>
Array* NewColumn(vtkTable* table, const char* name)
{
  vtkNew<Array> column;
  column->SetName(name);
  table->AddColumn(column);
  return column;
}

void FillTable(vtkTable* table, const std::vector<Ranking>& rankings, vtkTable* pairs)
{
  auto* performances = NewColumn<vtkStringArray>(table, "Performance");
  auto* metrics = NewColumn<vtkStringArray>(table, "Metric");
  auto* ranks = NewColumn<vtkIdTypeArray>(table, "Rank");
  auto* counts = NewColumn<vtkIdTypeArray>(table, "N");
  auto* coefficients = NewColumn<vtkStringArray>(table, "Coefficient");
  std::array<vtkDoubleArray*, CopiedNumbers.size()> copied{};
  for (std::size_t i = 0; i < copied.size(); ++i)
  {
    copied[i] = NewColumn<vtkDoubleArray>(table, CopiedNumbers[i]);
  }
  auto* words = NewColumn<vtkStringArray>(table, "Words");
  auto* jointRanks = NewColumn<vtkIdTypeArray>(table, "JointRank");
  auto* jointWeights = NewColumn<vtkDoubleArray>(table, "JointWeight");
  auto* sentences = NewColumn<vtkStringArray>(table, "Sentence");
  auto* joint = NewColumn<vtkStringArray>(table, "Joint");
  for (const Ranking& ranking : rankings)
  {
    std::string jointly = ranking.Joint; // in the first row of the performance, as it is of all
    for (const RankedMetric& metric : ranking.Metrics)
    {
      performances->InsertNextValue(ranking.Performance);
      metrics->InsertNextValue(metric.Name);
      ranks->InsertNextValue(metric.Rank);
      counts->InsertNextValue(pairs->GetValueByName(metric.Pair, "N").ToLongLong());
      coefficients->InsertNextValue(TextAt(pairs, "Coefficient", metric.Pair));
      for (std::size_t i = 0; i < copied.size(); ++i)
      {
        copied[i]->InsertNextValue(NumberAt(pairs, CopiedNumbers[i], metric.Pair));
      }
      words->InsertNextValue(metric.Words);
      jointRanks->InsertNextValue(metric.JointRank);
      jointWeights->InsertNextValue(metric.JointWeight);
      sentences->InsertNextValue(SentenceOf(metric, pairs));
      joint->InsertNextValue(std::exchange(jointly, std::string()));
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
vtkPEMFindings::vtkPEMFindings()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
int vtkPEMFindings::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
int vtkPEMFindings::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkTable* pairs = vtkTable::GetData(input[0], 0);
  vtkTable* series = vtkTable::GetData(input[1], 0);
  for (const char* name : NeededColumns)
  {
    if (!pairs->GetColumnByName(name))
    {
      vtkErrorMacro(<< "The first input has no column \"" << name
                    << "\": connect the output of vtkPEMCorrelation.");
      return 0;
    }
  }
  const pemesh::RowFamilies families = FamiliesOf(pairs, series);
  std::vector<Ranking> rankings = GatherRankings(pairs);
  for (Ranking& ranking : rankings)
  {
    std::vector<std::string> columns{ ranking.Performance };
    for (const RankedMetric& metric : ranking.Metrics)
    {
      columns.push_back(metric.Name);
    }
    if (const std::string reason = pemesh::WhyNotNumeric(series, columns); !reason.empty())
    {
      vtkErrorMacro(<< reason << " Connect the table that was correlated.");
      return 0;
    }
    Rank(ranking, series, families);
  }
  FillTable(vtkTable::GetData(output, 0), rankings, pairs);
  this->Text = TextOf(rankings, pairs, this->NumberOfSentences);
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkPEMFindings::GetText() const
{
  return this->Text;
}

//------------------------------------------------------------------------------
void vtkPEMFindings::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSentences: " << this->NumberOfSentences << "\n";
}
