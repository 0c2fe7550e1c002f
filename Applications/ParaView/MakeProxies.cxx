// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Writes the proxies that follow from the tables: a source for every family, domain and
 * tessellation, a filter for every rule of agglomeration, and those whose choices are names of
 * metrics, problems and formats. Filters.xml has the others.
 *
 *   MakeProxies FILE.xml
 *
 * What fixes the entry of the table is a property that nobody sees. It comes first, because the
 * properties of a new object are set in the order of the file.
 */
#include "ProxyWriter.h"

#include "AgglomerationRules.h"
#include "DomainShapes.h"
#include "MeshFormats.h"
#include "MetricRegistry.h"
#include "PolygonFamilies.h"
#include "Tessellations.h"
#include "TestProblems.h"
#include "TextFile.h"
#include "VirtualElementOptions.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>

namespace
{

using pemesh::ProxyWriter;

/** Another sentence where a table names a paper. */
std::string WithReference(const std::string& description, const char* reference)
{
  return *reference ? description + " " + reference : description;
}

/** As the middle of a sentence or a name: "L" stays, "Comb" becomes "comb". */
std::string LowerFirst(std::string text)
{
  if (text.size() > 1 && !(text[1] >= 'A' && text[1] <= 'Z'))
  {
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  }
  return text;
}

template <typename Table>
std::vector<std::string> NamesOf(const Table& table)
{
  std::vector<std::string> names;
  for (const auto& entry : table)
  {
    names.emplace_back(entry.Name);
  }
  return names;
}

void WriteFamilies(ProxyWriter& xml)
{
  for (const pemesh::PolygonFamily& family : pemesh::PolygonFamilies())
  {
    if (family.IsFixed())
    {
      continue;
    }
    xml.Begin(family.Name, "Polygon", "vtkPEMPolygonFamily", std::string(family.Label) + " polygon",
      WithReference(family.Description, family.Reference));
    xml.Fixed("Family", "SetFamily", family.Name);
    xml.Doubles("Center", "SetCenter", "0.5 0.5", "of the bounding box");
    xml.Number("Scale", "SetScale", 1.0, 0.0, ProxyWriter::Infinity,
      "twice the diagonal of the bounding box");
    xml.Number("Rotation", "SetRotation", 0.0, -360.0, 360.0, "counter-clockwise, degrees");
    xml.Doubles("Range", "SetRange", "0 1", "the deformations t at times 0 and 1");
    xml.Parameters(family.Parameters);
    xml.LayoutTimes();
    xml.End("PEMesh polygons");
  }
}

void WriteDomains(ProxyWriter& xml)
{
  for (const pemesh::DomainShape& shape : pemesh::DomainShapes())
  {
    xml.Begin(shape.Name, "Domain", "vtkPEMDomain", std::string(shape.Label) + " domain",
      shape.Description);
    xml.Fixed("Shape", "SetShapeByName", shape.Name);
    xml.Parameters(shape.Parameters);
    xml.End("PEMesh domains");
  }
}

void WriteTessellations(ProxyWriter& xml, bool ofDomain)
{
  for (const pemesh::Tessellation& kind : pemesh::Tessellations())
  {
    xml.Begin(kind.Name, ofDomain ? "MeshOfDomain" : "Mesh", "vtkPEMTessellation",
      std::string(kind.Label) + (ofDomain ? " in domain" : ""),
      WithReference(kind.Description, kind.Reference));
    if (ofDomain)
    {
      xml.Input("a domain: its outer loop and its holes");
    }
    xml.Fixed("Kind", "SetKindByName", kind.Name);
    xml.Parameters(kind.Parameters);
    xml.End(ofDomain ? "PEMesh" : "PEMesh meshes");
  }
}

void WriteAgglomerations(ProxyWriter& xml)
{
  for (const pemesh::AgglomerationRule& rule : pemesh::AgglomerationRules())
  {
    xml.Begin(rule.Name, "Agglomeration", "vtkPEMAgglomerate",
      "Agglomerate " + LowerFirst(rule.Label), WithReference(rule.Description, rule.Reference));
    xml.Input("a mesh of simple polygons");
    xml.Fixed("Rule", "SetRuleByName", rule.Name);
    xml.Parameters(rule.Parameters);
    if (rule.Metric != pemesh::RuleMetric::None)
    {
      std::vector<std::string> metrics = { "" };
      std::ranges::copy_if(pemesh::MetricNames(), std::back_inserter(metrics),
        [](const std::string& name) { return pemesh::FindElementMetric(name) != nullptr; });
      xml.Choice("Metric", "SetMetric", "", "", metrics, "empty: that of the rule");
    }
    xml.Integer("TargetNumberOfElements", "SetTargetNumberOfElements", 0, 0, 2147483647,
      "where to stop; 0: no such target");
    xml.Number("TargetPercentage", "SetTargetPercentage", 0.0, 0.0, 100.0,
      "where to stop, of the elements of the input; 0: no such target");
    xml.Switch("KeepPolygons", "SetKeepPolygons", true, "whether placed polygons stay");
    xml.Enumeration("StraightVertices", "SetStraightVertices", 0,
      { "Keep", "Remove the exactly straight", "Remove those straight but for rounding" },
      "what becomes of straight vertices between the same two elements");
    xml.End("PEMesh");
  }
}

void WriteMetrics(ProxyWriter& xml)
{
  std::vector<std::string> names = NamesOf(pemesh::MetricCollections());
  for (const pemesh::Metric& metric : pemesh::Metrics())
  {
    names.emplace_back(metric.Name);
  }
  xml.Begin("metrics", "", "vtkPEMMetrics", "Element metrics",
    "Measures every element of a mesh: one array a metric.");
  xml.Input("a mesh of polygons");
  xml.List("Metrics", "AddMetric", "RemoveAllMetrics", "all", names,
    "names of metrics, and words that stand for several");
  xml.End("PEMesh");
}

void WriteSolver(ProxyWriter& xml)
{
  xml.Begin("virtual-element-solver", "", "vtkPEMVirtualElementSolver", "Virtual element solver",
    "Solves -div(kappa grad u) + beta . grad u + c u = f with the virtual element method.");
  xml.Input("a mesh of polygons");
  xml.Integer("Order", "SetOrder", 1, 1, pemesh::LargestOrder, "of the method");
  const auto choice = [&xml](const char* property, const char* option,
                        const std::vector<std::string>& names, const char* what)
  { xml.Choice(property, "SetOption", option, names.front(), names, what); };
  std::vector<std::string> problems = NamesOf(pemesh::TestProblems());
  xml.Choice("Problem", "SetOption", "problem", "franke", problems, "a problem with known answer");
  choice("Basis", "basis", NamesOf(pemesh::BasisRules()), "of the polynomials on an element");
  choice("Stabilisation", "stabilisation", NamesOf(pemesh::StabilisationRules()),
    "weights of the part that is no polynomial");
  choice("ProjectionConstant", "p0", NamesOf(pemesh::ProjectionConstants()),
    "what fixes the constant of the projection at order 1");
  choice("Load", "load", NamesOf(pemesh::LoadProjections()),
    "the test functions that f is integrated against");
  choice("LinearSolver", "solver", NamesOf(pemesh::SolverKinds()), "of the linear system");
  xml.Text("Solution", "SetOption", "solution", "a formula of x and y, in place of the problem");
  xml.Text("Source", "SetOption", "source", "a formula of x and y, in place of the problem");
  xml.Switch("Details", "SetDetails", false, "also what may cost more than solving");
  xml.Text("RunName", "SetRunName", "", "leads the names of all arrays");
  xml.End("PEMesh");
}

void WriteReader(ProxyWriter& xml)
{
  std::string extensions;
  for (const pemesh::MeshFormat& format : pemesh::MeshFormats())
  {
    for (const char* extension : format.Extensions)
    {
      const std::string name = extension + 1;
      if (!format.KeepsArrays && extensions.find(name) == std::string::npos)
      {
        extensions += (extensions.empty() ? "" : " ") + name;
      }
    }
  }
  xml.ReaderAndWriter(extensions);
}

} // namespace

int main(int count, char** arguments)
{
  if (count != 2)
  {
    std::cerr << "usage: MakeProxies FILE.xml\n";
    return EXIT_FAILURE;
  }
  try
  {
    ProxyWriter xml;
    xml.BeginGroup("sources");
    WriteFamilies(xml);
    WriteDomains(xml);
    WriteTessellations(xml, false);
    xml.EndGroup();
    xml.BeginGroup("filters");
    WriteTessellations(xml, true);
    WriteAgglomerations(xml);
    WriteMetrics(xml);
    WriteSolver(xml);
    xml.EndGroup();
    WriteReader(xml);
    pemesh::WriteTextFile(arguments[1], xml.Finish());
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "MakeProxies: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
