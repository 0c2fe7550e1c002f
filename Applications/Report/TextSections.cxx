// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ReportSections.h"

#include "ColumnRoles.h"
#include "NumberText.h"
#include "ReportContents.h"

#include <algorithm>
#include <array>
#include <charconv>

#include <vtkDataArray.h>
#include <vtkTable.h>

namespace pemesh
{

namespace
{

constexpr std::size_t MostRows = 500; // of the table of results; results.csv has all

using Row = std::vector<std::string>;

std::string JoinTexts(const std::vector<std::string>& texts, const char* between)
{
  std::string joined;
  for (const std::string& text : texts)
  {
    joined += (joined.empty() ? "" : between) + text;
  }
  return joined;
}

std::string Range(const StudySweep& sweep)
{
  std::vector<std::string> values;
  for (const StudyScalar& value : sweep.Values)
  {
    values.push_back(FormatScalar(value));
  }
  return values.empty() ? FormatNumber(sweep.From) + " to " + FormatNumber(sweep.To) + ", " +
      std::to_string(sweep.Count) + " values"
                        : JoinTexts(values, ", ");
}

std::string PolygonsOf(const Study& study)
{
  std::vector<std::string> names;
  for (const StudyPolygon& polygon : study.Polygons)
  {
    names.push_back(polygon.Family);
  }
  if (study.Scatter)
  {
    names.push_back(std::to_string(study.Scatter->Count) + " scattered");
  }
  return names.empty() ? "none" : JoinTexts(names, ", ");
}

void AddMeshRows(const Study& study, std::vector<Row>& rows)
{
  if (HasMeshFiles(study))
  {
    rows.push_back({ "Mesh files", JoinTexts(study.Meshes, ", ") });
    return;
  }
  rows.push_back({ "Domain", study.Domain.Shape });
  rows.push_back({ "Polygons", PolygonsOf(study) });
  rows.push_back({ "Source of the meshes", study.Mesh.Source });
  if (study.Mesh.Agglomeration.Rule != "none")
  {
    rows.push_back({ "Elements merged by", study.Mesh.Agglomeration.Rule });
  }
  if (study.Mesh.Target.Quantity != "none")
  {
    rows.push_back({ "Held fixed",
      study.Mesh.Target.Quantity + " at " + std::to_string(study.Mesh.Target.Value) });
  }
}

/** Every seed of the document by its path: what makes the study come out the same again. */
void AddSeedRows(const Study& study, std::vector<Row>& rows)
{
  for (std::size_t i = 0; i < study.Polygons.size(); ++i)
  {
    for (const auto& [name, value] : study.Polygons[i].Parameters)
    {
      if (name == "seed")
      {
        rows.push_back({ "Seed of polygons[" + std::to_string(i) + "]", FormatNumber(value) });
      }
    }
  }
  if (study.Scatter)
  {
    rows.push_back({ "Seed of scatter", FormatNumber(study.Scatter->Seed) });
  }
  for (const auto& [name, value] : study.Mesh.Parameters)
  {
    if (name == "seed")
    {
      rows.push_back({ "Seed of mesh", FormatNumber(value) });
    }
  }
  for (const auto& [name, value] : study.Mesh.Agglomeration.Parameters)
  {
    if (name == "seed")
    {
      rows.push_back({ "Seed of mesh.agglomerate", FormatNumber(value) });
    }
  }
  rows.push_back({ "Seed of statistics", std::to_string(study.Statistics.Seed) });
}

std::string DescribeRun(const StudySolver& run)
{
  std::string text = run.Solver;
  for (const auto& [key, value] : run.Options)
  {
    const std::string shown = FormatScalar(value);
    text += shown.empty() ? "" : ", " + key + " " + shown; // a formula that was not given
  }
  return text + (run.Version.empty() ? "" : " (" + run.Version + ")");
}

/** The columns that a reader looks at first: what the mesh is, its size, what the solvers said. */
std::vector<std::string> MainColumns(const ReportContents& contents)
{
  std::vector<std::string> wanted{ "Index", "Mesh" };
  for (const StudySweep& sweep : contents.TheStudy.Sweep)
  {
    wanted.push_back(sweep.Name);
  }
  wanted.insert(wanted.end(), { "Elements", "Vertices", "MeshSize" });
  const std::vector<std::string> performances = contents.Performances();
  wanted.insert(wanted.end(), performances.begin(), performances.end());
  wanted.emplace_back("Status");
  std::erase_if(wanted,
    [&](const std::string& name) { return !contents.Results->GetColumnByName(name.c_str()); });
  return wanted;
}

/** Six significant digits are enough to read; results.csv has all. */
std::string Shortened(const std::string& text)
{
  const auto value = ParseNumber(text);
  if (!value || text.size() < 10)
  {
    return text;
  }
  char digits[32];
  const auto end =
    std::to_chars(digits, digits + sizeof digits, *value, std::chars_format::general, 6);
  return { digits, end.ptr };
}

struct Method
{
  const char* Word;
  const char* Meaning;
  const char* Reference;
};

constexpr std::array<Method, 10> Methods{ {
  { "Pearson", "strength of a linear relation, from -1 to 1", "K. Pearson, 1895" },
  { "Spearman", "Pearson's coefficient of the ranks: strength of a monotone relation",
    "C. Spearman, Am. J. Psychol. 15 (1904) 72-101" },
  { "Kendall", "tau-b: pairs of meshes that agree in order less those that do not",
    "M. G. Kendall, Rank Correlation Methods, 4th ed., 1970" },
  { "distance correlation",
    "strength of any relation, from 0 to 1; above 0 also for a few "
    "unrelated rows",
    "G. J. Székely, M. L. Rizzo, N. K. Bakirov, Ann. Stat. 35 (2007) 2769-2794" },
  { "given", "partial: what is left when the columns given are held fixed",
    "M. G. Kendall, A. Stuart, The Advanced Theory of Statistics, vol. 2, ch. 27" },
  { "strong, moderate, weak",
    "the coefficient reaches 0.7, reaches 0.4, or neither; the slope or "
    "exponent is told apart, because it depends on units",
    "" },
  { "straight line, power law, exponential",
    "the form with the least squared residuals if its R² reaches 0.9 (without \"close to\": 0.99)",
    "G. E. P. Box, D. R. Cox, J. R. Stat. Soc. B 26 (1964) 211-252" },
  { "p",
    "how often families that change places as a whole give a coefficient as large; none along "
    "a single family, whose meshes are no sample",
    "A. M. Winkler et al., NeuroImage 123 (2015) 253-268" },
  { "Holm, Benjamini-Hochberg",
    "p corrected for the number of pairs: no false one but for a chance "
    "of p; at most a share p of false ones",
    "S. Holm, Scand. J. Stat. 6 (1979) 65-70; Y. Benjamini, Y. Hochberg, J. R. Stat. Soc. B 57 "
    "(1995) 289-300" },
  { "jointly",
    "ridge regression of all metrics, standardised; the penalty is the one that predicts "
    "families left out best",
    "A. E. Hoerl, R. W. Kennard, Technometrics 12 (1970) 55-67" },
} };

} // namespace

Html MakeStudy(const ReportContents& contents, const FigureFolder&)
{
  const Study& study = contents.TheStudy;
  HtmlTable table{ "The study", { "What", "Value" }, {}, false };
  table.Rows.push_back({ "Made by", study.WrittenBy.empty() ? "unknown" : study.WrittenBy });
  AddMeshRows(study, table.Rows);
  for (const StudySweep& sweep : study.Sweep)
  {
    table.Rows.push_back({ "Swept: " + sweep.Name, Range(sweep) });
  }
  for (const StudySolver& run : study.Solvers)
  {
    table.Rows.push_back({ "Solver run " + run.Name, DescribeRun(run) });
  }
  AddSeedRows(study, table.Rows);
  return FormatTable(table) +
    HtmlElement("details", {},
      HtmlElement("summary", "The whole document, with every default") +
        HtmlElement("pre", contents.Document));
}

Html MakeFailures(const ReportContents& contents, const FigureFolder&)
{
  if (!contents.Failures || contents.Failures->GetNumberOfRows() == 0)
  {
    return HtmlParagraph("Nothing failed.");
  }
  HtmlTable table{ "What failed, mesh by mesh", {}, {}, true };
  std::vector<std::vector<std::string>> columns;
  for (vtkIdType i = 0; i < contents.Failures->GetNumberOfColumns(); ++i)
  {
    table.Head.emplace_back(contents.Failures->GetColumnName(i));
    columns.push_back(ColumnTexts(contents.Failures, table.Head.back()));
  }
  for (vtkIdType row = 0; row < contents.Failures->GetNumberOfRows(); ++row)
  {
    Row cells;
    for (const auto& column : columns)
    {
      cells.push_back(column[static_cast<std::size_t>(row)]);
    }
    table.Rows.push_back(std::move(cells));
  }
  return FormatTable(table);
}

Html MakeTable(const ReportContents& contents, const FigureFolder&)
{
  const std::vector<std::string> names = MainColumns(contents);
  std::vector<std::vector<std::string>> columns;
  for (const std::string& name : names)
  {
    columns.push_back(ColumnTexts(contents.Results, name));
  }
  const auto count = static_cast<std::size_t>(contents.Results->GetNumberOfRows());
  HtmlTable table{ "One row a mesh; results.csv has all columns and digits", names, {}, true };
  for (std::size_t row = 0; row < std::min(count, MostRows); ++row)
  {
    Row cells;
    for (const auto& column : columns)
    {
      cells.push_back(Shortened(column[row]));
    }
    table.Rows.push_back(std::move(cells));
  }
  Html section = FormatTable(table);
  if (count > MostRows)
  {
    section +=
      HtmlParagraph("The other " + std::to_string(count - MostRows) + " rows are in results.csv.");
  }
  return section;
}

Html MakeMethods(const ReportContents&, const FigureFolder&)
{
  HtmlTable table{ "The words of the findings", { "Word", "Meaning", "Reference" }, {}, false };
  for (const Method& method : Methods)
  {
    table.Rows.push_back({ method.Word, method.Meaning, method.Reference });
  }
  return FormatTable(table) +
    HtmlParagraph(
      "A correlation is not a cause: quantities that change together along a family may "
      "both follow a third one, such as the mesh size.");
}

} // namespace pemesh
