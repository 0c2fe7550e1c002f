// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ProxyWriter.h"

#include "NumberText.h"
#include "XmlText.h"

#include <cctype>
#include <cmath>

namespace pemesh
{

namespace
{

/** "max-diameter" as MaxDiameter. */
std::string CamelCase(const std::string& name)
{
  std::string result;
  bool first = true;
  for (const char c : name)
  {
    if (c == '-')
    {
      first = true;
      continue;
    }
    result += first ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    first = false;
  }
  return result;
}

std::string Attribute(const std::string& name, const std::string& value)
{
  return " " + name + "=\"" + EscapeXml(value) + "\"";
}

std::string Range(const char* domain, const std::string& least, const std::string& greatest)
{
  std::string text = std::string("<") + domain + " name=\"range\"";
  text += least.empty() ? "" : Attribute("min", least);
  text += greatest.empty() ? "" : Attribute("max", greatest);
  return text + "/>";
}

std::string ChoiceDomain(const std::vector<std::string>& choices)
{
  std::string text = "<StringListDomain name=\"choices\">";
  for (const std::string& choice : choices)
  {
    text += "<String" + Attribute("value", choice) + "/>";
  }
  return text + "</StringListDomain>";
}

std::string Bound(double value)
{
  return std::isfinite(value) ? FormatNumber(value) : "";
}

std::string Option(const std::string& option)
{
  return option.empty() ? "" : Attribute("initial_string", option);
}

/** A sentence of a phrase. */
std::string Sentence(std::string phrase)
{
  if (!phrase.empty())
  {
    phrase[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(phrase[0])));
    phrase += phrase.back() == '.' ? "" : ".";
  }
  return phrase;
}

} // namespace

void ProxyWriter::BeginGroup(const std::string& name)
{
  this->Xml += "  <ProxyGroup" + Attribute("name", name) + ">\n";
}

void ProxyWriter::EndGroup()
{
  this->Xml += "  </ProxyGroup>\n";
}

void ProxyWriter::Begin(const std::string& name, const std::string& suffix,
  const std::string& className, const std::string& label, const std::string& description)
{
  this->Xml += "    <SourceProxy" + Attribute("name", "PEMesh" + CamelCase(name) + suffix) +
    Attribute("class", className) + Attribute("label", label) + ">\n      <Documentation" +
    Attribute("short_help", label) + ">" + EscapeXml(description) + "</Documentation>\n";
}

void ProxyWriter::End(const std::string& menu)
{
  this->Xml +=
    "      <Hints><ShowInMenu" + Attribute("category", menu) + "/></Hints>\n    </SourceProxy>\n";
}

void ProxyWriter::Property(const std::string& kind, const std::string& name,
  const std::string& command, const std::string& more, const std::string& description,
  const std::string& domains)
{
  this->Xml += "      <" + kind + Attribute("name", name) + Attribute("command", command) + more +
    ">\n        " + (domains.empty() ? "" : domains + "\n        ") + "<Documentation>" +
    EscapeXml(Sentence(description)) + "</Documentation>\n      </" + kind + ">\n";
}

void ProxyWriter::Input(const std::string& description)
{
  this->Property("InputProperty", "Input", "SetInputConnection", "", description,
    "<ProxyGroupDomain name=\"groups\"><Group name=\"sources\"/><Group name=\"filters\"/>"
    "</ProxyGroupDomain>"
    "<DataTypeDomain name=\"input_type\"><DataType value=\"vtkPolyData\"/></DataTypeDomain>");
}

void ProxyWriter::Fixed(
  const std::string& name, const std::string& command, const std::string& value)
{
  this->Property("StringVectorProperty", name, command,
    Attribute("number_of_elements", "1") + Attribute("default_values", value) +
      Attribute("panel_visibility", "never"),
    "which entry of the table this is", "");
}

void ProxyWriter::Parameters(std::span<const Parameter> parameters)
{
  for (const Parameter& parameter : parameters)
  {
    // Doubles, also where only integers may be used: a seed goes up to 2^53.
    this->Property("DoubleVectorProperty", CamelCase(parameter.Name), "SetParameter",
      Option(parameter.Name) + Attribute("number_of_elements", "1") +
        Attribute("default_values", FormatNumber(parameter.Default)),
      parameter.Description,
      Range("DoubleRangeDomain", Bound(parameter.Least), Bound(parameter.Greatest)));
  }
}

void ProxyWriter::Doubles(const std::string& name, const std::string& command,
  const std::string& defaults, const std::string& description)
{
  this->Property("DoubleVectorProperty", name, command,
    Attribute("number_of_elements", "2") + Attribute("default_values", defaults), description,
    "<DoubleRangeDomain name=\"range\"/>");
}

void ProxyWriter::Number(const std::string& name, const std::string& command, double value,
  double least, double greatest, const std::string& description)
{
  this->Property("DoubleVectorProperty", name, command,
    Attribute("number_of_elements", "1") + Attribute("default_values", FormatNumber(value)),
    description, Range("DoubleRangeDomain", Bound(least), Bound(greatest)));
}

void ProxyWriter::Integer(const std::string& name, const std::string& command, std::int64_t value,
  std::int64_t least, std::int64_t greatest, const std::string& description)
{
  this->Property("IntVectorProperty", name, command,
    Attribute("number_of_elements", "1") + Attribute("default_values", std::to_string(value)),
    description, Range("IntRangeDomain", std::to_string(least), std::to_string(greatest)));
}

void ProxyWriter::Switch(
  const std::string& name, const std::string& command, bool value, const std::string& description)
{
  this->Property("IntVectorProperty", name, command,
    Attribute("number_of_elements", "1") + Attribute("default_values", value ? "1" : "0"),
    description, "<BooleanDomain name=\"bool\"/>");
}

void ProxyWriter::Enumeration(const std::string& name, const std::string& command, int value,
  const std::vector<std::string>& labels, const std::string& description)
{
  std::string domain = "<EnumerationDomain name=\"enum\">";
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    domain +=
      "<Entry" + Attribute("value", std::to_string(i)) + Attribute("text", labels[i]) + "/>";
  }
  this->Property("IntVectorProperty", name, command,
    Attribute("number_of_elements", "1") + Attribute("default_values", std::to_string(value)),
    description, domain + "</EnumerationDomain>");
}

void ProxyWriter::Text(const std::string& name, const std::string& command,
  const std::string& option, const std::string& description)
{
  this->Property("StringVectorProperty", name, command,
    Option(option) + Attribute("number_of_elements", "1") + Attribute("default_values", ""),
    description, "");
}

void ProxyWriter::Choice(const std::string& name, const std::string& command,
  const std::string& option, const std::string& value, const std::vector<std::string>& choices,
  const std::string& description)
{
  this->Property("StringVectorProperty", name, command,
    Option(option) + Attribute("number_of_elements", "1") + Attribute("default_values", value),
    description, ChoiceDomain(choices));
}

void ProxyWriter::List(const std::string& name, const std::string& command,
  const std::string& clear, const std::string& value, const std::vector<std::string>& choices,
  const std::string& description)
{
  this->Property("StringVectorProperty", name, command,
    Attribute("clean_command", clear) + Attribute("repeat_command", "1") +
      Attribute("number_of_elements_per_command", "1") + Attribute("number_of_elements", "1") +
      Attribute("default_values", value),
    description, ChoiceDomain(choices));
}

void ProxyWriter::LayoutTimes()
{
  constexpr double last = 0.9;
  constexpr int count = 20;
  constexpr int most = 1000000;
  this->Number("FirstTime", "SetFirstTime", 0.0, 0.0, 1.0, "the first time step");
  this->Number("LastTime", "SetLastTime", last, 0.0, 1.0, "the last time step");
  this->Integer("NumberOfTimes", "SetNumberOfTimes", count, 1, most, "time steps between them");
  this->Xml += "      <DoubleVectorProperty name=\"TimestepValues\" repeatable=\"1\" "
               "information_only=\"1\">\n"
               "        <TimeStepsInformationHelper/>\n"
               "      </DoubleVectorProperty>\n";
}

void ProxyWriter::ReaderAndWriter(const std::string& extensions)
{
  const std::string factory =
    Attribute("extensions", extensions) + Attribute("file_description", "PEMesh polygonal meshes");
  this->Xml +=
    "  <ProxyGroup name=\"sources\">\n"
    "    <SourceProxy name=\"PEMeshReader\" class=\"vtkPEMMeshReader\" label=\"PEMesh reader\">\n"
    "      <Documentation short_help=\"Polygonal meshes\">Reads meshes of polygons; several files "
    "are time steps.</Documentation>\n"
    "      <StringVectorProperty name=\"FileNames\" command=\"AddFileName\" "
    "clean_command=\"RemoveAllFileNames\" repeat_command=\"1\" number_of_elements=\"0\" "
    "number_of_elements_per_command=\"1\" panel_visibility=\"never\">\n"
    "        <FileListDomain name=\"files\"/>\n"
    "        <Documentation>The files, in the order of time.</Documentation>\n"
    "      </StringVectorProperty>\n"
    "      <DoubleVectorProperty name=\"TimestepValues\" repeatable=\"1\" "
    "information_only=\"1\">\n"
    "        <TimeStepsInformationHelper/>\n"
    "      </DoubleVectorProperty>\n"
    "      <Hints><ReaderFactory" +
    factory +
    "/></Hints>\n"
    "    </SourceProxy>\n"
    "  </ProxyGroup>\n"
    "  <ProxyGroup name=\"writers\">\n"
    "    <WriterProxy name=\"PEMeshWriter\" class=\"vtkPEMMeshWriter\" label=\"PEMesh writer\">\n"
    "      <Documentation short_help=\"Polygonal meshes\">Writes a mesh of polygons in the format "
    "that the extension names.</Documentation>\n";
  this->Input("a mesh of polygons");
  this->Text("FileName", "SetFileName", "", "where to write");
  this->Xml += "      <Hints><WriterFactory" + factory +
    "/></Hints>\n"
    "    </WriterProxy>\n"
    "  </ProxyGroup>\n";
}

std::string ProxyWriter::Finish()
{
  return this->Xml + "</ServerManagerConfiguration>\n";
}

} // namespace pemesh
