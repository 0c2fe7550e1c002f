// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyFields.h"

#include <set>

namespace pemesh
{

namespace
{

const std::vector<std::string> FigureExtensions{ ".png", ".svg", ".pdf" };

bool ShowsMesh(const StudyPlot& plot)
{
  return plot.Kind == "mesh" || plot.Kind == "overview";
}

bool HasAxes(const StudyPlot& plot)
{
  return plot.Kind != "mesh";
}

Field<StudyPlot> OrdinatesField()
{
  Field<StudyPlot> field = TextsField("y", &StudyPlot::Y,
    "Columns of the results; the name of a metric alone stands for its min, mean and max.");
  field.Read = [](const JsonValue& json, const DocumentPlace& place, StudyPlot& plot)
  {
    plot.Y = ReadTexts(json, place);
    if (plot.Y.empty())
    {
      place.Fail("is empty: name at least one column.");
    }
  };
  return std::move(field).Required().Only(HasAxes, "the kinds line, scatter and overview");
}

Field<StudyPlot> LogarithmField()
{
  Field<StudyPlot> field =
    ChoiceField("log", &StudyPlot::Log, { "none", "x", "y", "xy" }, "Which axes are logarithmic.");
  const auto read = field.Read;
  field.Read = [read](const JsonValue& json, const DocumentPlace& place, StudyPlot& plot)
  {
    read(json, place, plot);
    plot.Log = plot.Log == "none" ? "" : plot.Log;
  };
  field.Write = [](const StudyPlot& plot)
  { return JsonValue{ plot.Log.empty() ? std::string("none") : plot.Log }; };
  return std::move(field).Only(HasAxes, "the kinds line, scatter and overview");
}

Field<StudyPlot> FileField()
{
  Field<StudyPlot> field = TextField("file", &StudyPlot::File,
    "Name of the figure; its extension png (the default), svg or pdf is its format.");
  field.Read = [](const JsonValue& json, const DocumentPlace& place, StudyPlot& plot)
  {
    plot.File = ReadText(json, place);
    CheckFileName(place, plot.File);
    const std::string extension = std::filesystem::path(plot.File).extension().string();
    if (std::find(FigureExtensions.begin(), FigureExtensions.end(), extension) ==
      FigureExtensions.end())
    {
      plot.File += FigureExtensions.front();
    }
  };
  return field;
}

/** "line-MinAngle_min-vs-t" with nothing in it that a file name cannot hold. */
std::string DefaultFigureName(const StudyPlot& plot)
{
  std::string name = plot.Kind;
  name += ShowsMesh(plot) ? (plot.ColorBy.empty() ? "" : "-" + plot.ColorBy)
                          : "-" + plot.Y.front() + "-vs-" + plot.X;
  for (char& c : name)
  {
    const bool isPlain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
      (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
    c = isPlain ? c : '-';
  }
  return name;
}

} // namespace

FieldTable<StudyPlot> PlotFields()
{
  FieldTable<StudyPlot> table;
  table.Fields = { ChoiceField("kind", &StudyPlot::Kind, { "line", "scatter", "mesh", "overview" },
                     "Line and scatter charts of the results, one mesh, or all of it side by side.")
                     .Required(),
    TextField("x", &StudyPlot::X,
      "A column of the results; by default the first swept parameter, or else Index.")
      .Only(HasAxes, "the kinds line, scatter and overview"),
    OrdinatesField(), LogarithmField(),
    TextField("color-by", &StudyPlot::ColorBy,
      "The column or the array of the mesh that gives the colours.")
      .Only([](const StudyPlot& plot) { return plot.Kind != "line"; },
        "the kinds scatter, mesh and overview"),
    ChoiceField("highlight", &StudyPlot::Highlight, { "none", "min", "max", "both" },
      "Which extreme elements of color-by are marked.")
      .Only([](const StudyPlot& plot) { return plot.Kind == "mesh"; }, "the kind mesh"),
    IntegerField("case", &StudyPlot::Case, -MostCases, MostCases,
      "Which mesh, from 0; negative numbers count from the last one, -1.")
      .Only(ShowsMesh, "the kinds mesh and overview"),
    TextField("title", &StudyPlot::Title, "Written above it."), FileField() };
  return table;
}

void FinishPlots(const DocumentPlace& place, Study& study)
{
  std::set<std::string> taken;
  for (std::size_t i = 0; i < study.Plots.size(); ++i)
  {
    StudyPlot& plot = study.Plots[i];
    if (HasAxes(plot) && plot.X.empty())
    {
      plot.X = study.Sweep.empty() ? "Index" : study.Sweep.front().Name;
    }
    if (!plot.File.empty() && !taken.insert(plot.File).second)
    {
      place.Member("plots").Item(i).Member("file").Fail(
        "is \"" + plot.File + "\", the file of another plot.");
    }
  }
  for (StudyPlot& plot : study.Plots)
  {
    const std::string base = DefaultFigureName(plot);
    for (int number = 1; plot.File.empty(); ++number)
    {
      const std::string suffix = number > 1 ? "-" + std::to_string(number) : "";
      const std::string file = base + suffix + FigureExtensions.front();
      plot.File = taken.insert(file).second ? file : "";
    }
  }
}

} // namespace pemesh
