// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMCorrelation.h"

#include "CaseStatus.h"
#include "CoefficientKinds.h"
#include "ColumnRoles.h"
#include "NumberText.h"
#include "PairCorrelation.h"
#include "Progress.h"
#include "RelationWords.h"

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
using NamePairs = std::vector<std::pair<std::string, std::string>>;

NamePairs MakePairs(const Names& x, const Names& y)
{
  NamePairs pairs;
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

/** Values that differ by rounding errors alone are one value, whose order would mean nothing. */
std::vector<double> WithoutRounding(std::vector<double> column)
{
  constexpr double rounding = 1e-12; // of the largest value
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  for (const double value : column)
  {
    least = std::fmin(least, value); // not NaN
    greatest = std::fmax(greatest, value);
  }
  const double size = std::max(std::fabs(least), std::fabs(greatest));
  if (std::isfinite(size) && greatest / 2 - least / 2 <= rounding * (size / 2))
  {
    std::replace_if(
      column.begin(), column.end(), [](double value) { return !std::isnan(value); }, greatest);
  }
  return column;
}

/** The columns that take part, each once. */
pemesh::PairsOfColumns GatherColumns(vtkTable* table, const NamePairs& pairs, const Names& given)
{
  pemesh::PairsOfColumns gathered;
  std::map<std::string, std::size_t> known;
  const auto indexOf = [&](const std::string& name)
  {
    const auto [place, isNew] = known.emplace(name, gathered.Columns.size());
    if (isNew)
    {
      gathered.Columns.push_back(WithoutRounding(pemesh::ColumnNumbers(table, name)));
    }
    return place->second;
  };
  for (const auto& [x, y] : pairs)
  {
    const std::size_t first = indexOf(x);
    gathered.Pairs.emplace_back(first, indexOf(y));
  }
  for (const std::string& name : given)
  {
    gathered.Given.push_back(indexOf(name));
  }
  return gathered;
}

const char* NameOf(pemesh::RowsAre rows)
{
  return rows == pemesh::RowsAre::Independent ? "independent"
    : rows == pemesh::RowsAre::Families       ? "families"
                                              : "one-family";
}

std::string JoinNames(const Names& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

template <typename Array, typename Value>
void AddColumn(vtkTable* table, const char* name,
  const std::vector<pemesh::PairCorrelation>& results, Value value)
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

void FillTable(vtkTable* table, const NamePairs& pairs, const std::string& coefficient,
  const std::vector<pemesh::PairCorrelation>& all)
{
  using Text = vtkStringArray;
  using Number = vtkDoubleArray;
  using Count = vtkIdTypeArray;
  const auto number = [&](const char* name, auto value)
  { AddColumn<Number>(table, name, all, [&](std::size_t i) { return value(all[i]); }); };
  using Result = const pemesh::PairCorrelation&;
  AddColumn<Text>(table, "X", all, [&](std::size_t i) { return pairs[i].first; });
  AddColumn<Text>(table, "Y", all, [&](std::size_t i) { return pairs[i].second; });
  AddColumn<Count>(
    table, "N", all, [&](std::size_t i) { return static_cast<vtkIdType>(all[i].Count); });
  AddColumn<Count>(
    table, "Families", all, [&](std::size_t i) { return static_cast<vtkIdType>(all[i].Families); });
  number("Pearson", [](Result r) { return r.Pearson; });
  number("Spearman", [](Result r) { return r.Spearman; });
  number("Kendall", [](Result r) { return r.Kendall; });
  number("DistanceCorrelation", [](Result r) { return r.Distance; });
  number("Partial", [](Result r) { return r.Partial; });
  AddColumn<Text>(table, "Coefficient", all, [&](std::size_t) { return coefficient; });
  number("Tested", [](Result r) { return r.Tested; });
  number("P", [](Result r) { return r.P; });
  number("PHolm", [](Result r) { return r.PHolm; });
  number("PBenjaminiHochberg", [](Result r) { return r.PBenjaminiHochberg; });
  number("Low", [](Result r) { return r.Bounds.Low; });
  number("High", [](Result r) { return r.Bounds.High; });
  AddColumn<Text>(table, "Trend", all, [&](std::size_t i) { return all[i].Trend; });
  AddColumn<Text>(table, "Direction", all,
    [&](std::size_t i) { return pemesh::DirectionWord(all[i].Direction); });
  AddColumn<Text>(
    table, "Strength", all, [&](std::size_t i) { return pemesh::StrengthWord(all[i].Tested); });
  AddColumn<Text>(table, "Form", all, [&](std::size_t i) { return all[i].Form.Name; });
  number("FormParameter", [](Result r) { return r.Form.Parameter; });
  number("FormFit", [](Result r) { return r.Form.Fit; });
  AddColumn<Text>(table, "Words", all, [&](std::size_t i) { return all[i].Words; });
}

} // namespace

//------------------------------------------------------------------------------
int vtkPEMCorrelation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkPEMCorrelation::WhyUnusable(vtkTable* table) const
{
  for (const Names* names : { &this->XColumns, &this->YColumns, &this->GivenColumns })
  {
    if (std::string reason = pemesh::WhyNotNumeric(table, *names); !reason.empty())
    {
      return reason;
    }
  }
  if (!this->FamilyColumn.empty())
  {
    if (std::string reason = pemesh::WhyNoColumn(table, this->FamilyColumn); !reason.empty())
    {
      return reason;
    }
  }
  const pemesh::CoefficientKind* kind = pemesh::FindCoefficientKind(this->Coefficient);
  if (!kind)
  {
    Names known;
    for (const pemesh::CoefficientKind& other : pemesh::CoefficientKinds())
    {
      known.emplace_back(other.Name);
    }
    return "There is no coefficient \"" + this->Coefficient + "\": choose one of " +
      JoinNames(known) + ".";
  }
  return {};
}

//------------------------------------------------------------------------------
int vtkPEMCorrelation::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkTable* table = vtkTable::GetData(input[0], 0);
  vtkTable* results = vtkTable::GetData(output, 0);
  if (const std::string reason = this->WhyUnusable(table); !reason.empty())
  {
    vtkErrorMacro(<< reason);
    return 0;
  }
  const Names x = this->XColumns.empty() ? pemesh::MetricColumns(table) : this->XColumns;
  Names y = this->YColumns;
  Names responses = this->YColumns;
  if (y.empty())
  {
    y = pemesh::MetricColumns(table);
    responses = pemesh::PerformanceColumns(table);
    y.insert(y.end(), responses.begin(), responses.end());
  }
  else
  {
    std::erase_if(responses,
      [&](const std::string& name) { return std::find(x.begin(), x.end(), name) != x.end(); });
  }
  const NamePairs pairs = MakePairs(x, y);
  const std::string familyColumn = this->FamilyColumnOf(table);
  const pemesh::PairOptions options = this->MakeOptions(table, familyColumn);
  const pemesh::PairsOfColumns columns = GatherColumns(table, pairs, this->GivenColumns);
  const std::vector<pemesh::PairCorrelation> all = pemesh::CorrelatePairs(
    columns, options, [this](double done) { return pemesh::ReportProgress(this, done); });
  if (all.size() < pairs.size())
  {
    results->Initialize();
    return 1;
  }
  const std::string given = JoinNames(this->GivenColumns);
  FillTable(
    results, pairs, options.Kind->Label + (given.empty() ? std::string() : " given " + given), all);
  for (const std::string& name : responses)
  {
    pemesh::AddToFieldList(results, pemesh::PerformancesList, name);
  }
  pemesh::SetFieldText(results, "Rows", NameOf(options.Rows));
  pemesh::SetFieldText(results, "FamilyColumn", familyColumn);
  pemesh::SetFieldText(results, "Note", pemesh::DescribeTests(columns, options));
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkPEMCorrelation::FamilyColumnOf(vtkTable* table) const
{
  const bool pooled = table->GetColumnByName(pemesh::StudyColumn) != nullptr;
  return this->FamilyColumn.empty() && pooled ? pemesh::StudyColumn : this->FamilyColumn;
}

//------------------------------------------------------------------------------
pemesh::PairOptions vtkPEMCorrelation::MakeOptions(
  vtkTable* table, const std::string& familyColumn) const
{
  pemesh::PairOptions options;
  options.Kind = pemesh::FindCoefficientKind(this->Coefficient);
  options.Permutations = this->Permutations;
  options.Bootstrap = this->Bootstrap;
  options.Level = this->ConfidenceLevel;
  options.Seed = static_cast<std::uint64_t>(this->Seed);
  options.TrendThreshold = this->TrendThreshold;
  if (this->IndependentRows)
  {
    options.Rows = pemesh::RowsAre::Independent;
  }
  else if (!familyColumn.empty())
  {
    options.Families = pemesh::GroupRows(pemesh::ColumnTexts(table, familyColumn));
    options.Rows =
      options.Families.size() > 1 ? pemesh::RowsAre::Families : pemesh::RowsAre::OneFamily;
  }
  return options;
}

//------------------------------------------------------------------------------
void vtkPEMCorrelation::SetNames(Names& member, const Names& names)
{
  if (member != names)
  {
    member = names;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPEMCorrelation::SetXColumns(const Names& names)
{
  this->SetNames(this->XColumns, names);
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
  this->SetNames(this->YColumns, names);
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
void vtkPEMCorrelation::SetGivenColumns(const Names& names)
{
  this->SetNames(this->GivenColumns, names);
}

//------------------------------------------------------------------------------
Names vtkPEMCorrelation::GetGivenColumns() const
{
  return this->GivenColumns;
}

//------------------------------------------------------------------------------
void vtkPEMCorrelation::AddGivenColumn(const std::string& name)
{
  this->GivenColumns.push_back(name);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPEMCorrelation::RemoveAllGivenColumns()
{
  this->SetGivenColumns({});
}

//------------------------------------------------------------------------------
void vtkPEMCorrelation::SetCoefficient(const std::string& name)
{
  if (this->Coefficient != name)
  {
    this->Coefficient = name;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkPEMCorrelation::GetCoefficient() const
{
  return this->Coefficient;
}

//------------------------------------------------------------------------------
void vtkPEMCorrelation::SetFamilyColumn(const std::string& name)
{
  if (this->FamilyColumn != name)
  {
    this->FamilyColumn = name;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkPEMCorrelation::GetFamilyColumn() const
{
  return this->FamilyColumn;
}

//------------------------------------------------------------------------------
void vtkPEMCorrelation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto printNames = [&](const char* label, const Names& names)
  { os << indent << label << ": " << (names.empty() ? "(default)" : JoinNames(names)) << "\n"; };
  printNames("XColumns", this->XColumns);
  printNames("YColumns", this->YColumns);
  printNames("GivenColumns", this->GivenColumns);
  os << indent << "Coefficient: " << this->Coefficient << "\n";
  os << indent << "FamilyColumn: " << this->FamilyColumn << "\n";
  os << indent << "IndependentRows: " << (this->IndependentRows ? "On\n" : "Off\n");
  os << indent << "Permutations: " << this->Permutations << "\n";
  os << indent << "Bootstrap: " << this->Bootstrap << "\n";
  os << indent << "ConfidenceLevel: " << this->ConfidenceLevel << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "TrendThreshold: " << this->TrendThreshold << "\n";
}
