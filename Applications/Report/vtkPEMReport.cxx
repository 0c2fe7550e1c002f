// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMReport.h"

#include "NumberText.h"
#include "PageStyle.h"
#include "ReportContents.h"
#include "ReportFigures.h"
#include "ReportSections.h"
#include "TextFile.h"

#include <array>
#include <exception>
#include <filesystem>

#include <vtkObjectFactory.h>
#include <vtkTable.h>

vtkStandardNewMacro(vtkPEMReport);

namespace
{

using pemesh::Html;
using pemesh::HtmlElement;

constexpr std::array<pemesh::ReportSection, 9> Sections{ {
  { "study", "What was run", pemesh::MakeStudy },
  { "meshes", "Meshes", pemesh::MakeMeshes },
  { "findings", "Findings", pemesh::MakeFindings },
  { "performances", "Performances", pemesh::MakePerformances },
  { "convergence", "Convergence", pemesh::MakeConvergence },
  { "metrics", "Metrics", pemesh::MakeMetrics },
  { "failures", "Failures", pemesh::MakeFailures },
  { "table", "Results", pemesh::MakeTable },
  { "methods", "Methods and words", pemesh::MakeMethods },
} };

Html MakeHeader(const pemesh::ReportContents& contents)
{
  const vtkIdType failures = contents.Failures ? contents.Failures->GetNumberOfRows() : 0;
  Html header =
    HtmlElement("h1", contents.TheStudy.Name.empty() ? "A study" : contents.TheStudy.Name);
  const std::string meshes =
    pemesh::FormatCount(contents.Results->GetNumberOfRows(), "mesh", "meshes");
  const auto runs = static_cast<vtkIdType>(contents.TheStudy.Solvers.size());
  header += HtmlElement("p", { { "class", "lead" } },
    pemesh::HtmlText(runs == 0 ? "The geometry of " + meshes + "."
                               : "How the geometry of " + meshes + " affects " +
          pemesh::FormatCount(runs, "run of a solver", "runs of solvers") + "."));
  if (failures > 0)
  {
    header += HtmlElement("p", { { "class", "failed" } },
      pemesh::HtmlText(pemesh::FormatCount(failures, "failure", "failures") + ": ") +
        HtmlElement("a", { { "href", "#failures" } }, pemesh::HtmlText("see below")));
  }
  for (const std::string& remark : contents.Remarks)
  {
    header += HtmlElement("p", { { "class", "note" } }, pemesh::HtmlText(remark));
  }
  return header;
}

std::string MakePage(const pemesh::ReportContents& contents)
{
  const pemesh::FigureFolder folder(contents.Style);
  Html links;
  Html sections;
  for (const pemesh::ReportSection& section : Sections)
  {
    const Html content = section.Make(contents, folder);
    if (content.IsEmpty())
    {
      continue;
    }
    const std::string name = section.Name;
    links += HtmlElement(
      "li", {}, HtmlElement("a", { { "href", "#" + name } }, pemesh::HtmlText(section.Title)));
    sections += HtmlElement("section", { { "id", name }, { "aria-labelledby", name + "-title" } },
      HtmlElement("h2", { { "id", name + "-title" } }, pemesh::HtmlText(section.Title)) + content);
  }
  const Html head = HtmlElement("meta", { { "charset", "utf-8" } }) +
    HtmlElement(
      "meta", { { "name", "viewport" }, { "content", "width=device-width, initial-scale=1" } }) +
    HtmlElement("meta", { { "name", "generator" }, { "content", contents.TheStudy.WrittenBy } }) +
    HtmlElement("title", contents.TheStudy.Name + " - PEMesh") +
    pemesh::HtmlRaw("style", pemesh::PageStyle);
  const Html body = HtmlElement("header", {}, MakeHeader(contents)) +
    HtmlElement("nav", { { "aria-label", "Sections" } }, HtmlElement("ul", {}, links)) +
    HtmlElement("main", {}, sections) + pemesh::HtmlRaw("script", pemesh::PageScript);
  return "<!DOCTYPE html>\n" +
    HtmlElement(
      "html", { { "lang", "en" } }, HtmlElement("head", {}, head) + HtmlElement("body", {}, body))
      .GetText();
}

} // namespace

bool vtkPEMReport::Write()
{
  this->ErrorMessage.clear();
  this->Remarks.clear();
  try
  {
    const pemesh::ReportContents contents = pemesh::ReadReportContents(this->Folder);
    pemesh::WriteTextFile(this->GetFileName(), MakePage(contents));
    this->Remarks = contents.Remarks;
    return true;
  }
  catch (const std::exception& error)
  {
    this->ErrorMessage = error.what();
    return false;
  }
}

void vtkPEMReport::SetFolder(const std::string& folder)
{
  this->Folder = folder;
  this->Modified();
}

std::string vtkPEMReport::GetFolder() const
{
  return this->Folder;
}

void vtkPEMReport::SetFileName(const std::string& file)
{
  this->FileName = file;
  this->Modified();
}

std::string vtkPEMReport::GetFileName() const
{
  return this->FileName.empty() ? (std::filesystem::path(this->Folder) / "report.html").string()
                                : this->FileName;
}

std::string vtkPEMReport::GetErrorMessage() const
{
  return this->ErrorMessage;
}

std::vector<std::string> vtkPEMReport::GetRemarks() const
{
  return this->Remarks;
}

void vtkPEMReport::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Folder: " << this->Folder << "\n";
  os << indent << "FileName: " << this->GetFileName() << "\n";
}
