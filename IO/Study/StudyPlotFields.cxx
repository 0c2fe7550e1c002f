// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartKinds.h"
#include "ChartOptions.h"
#include "SettingJson.h"
#include "StudyFields.h"

#include <algorithm>
#include <functional>
#include <set>

namespace pemesh
{

namespace
{

const std::vector<std::string> FigureExtensions{ ".png", ".svg", ".pdf" };

const std::string ShowsMeshes = "the kinds mesh and overview";

bool ShowsMesh(const StudyPlot& plot)
{
  return plot.Kind == "mesh" || plot.Kind == "overview";
}

/** The entry of a chart; an overview has the axes of a scatter. Null for a mesh. */
const ChartKind* KindOf(const StudyPlot& plot)
{
  return FindChartKind(plot.Kind == "overview" ? "scatter" : plot.Kind);
}

bool HasAxes(const StudyPlot& plot)
{
  return KindOf(plot) != nullptr;
}

bool IsOfElements(const StudyPlot& plot)
{
  const ChartKind* kind = KindOf(plot);
  return kind && kind->OfElements;
}

/** "the kinds line, scatter and overview": those of the table that a function is true for. */
std::string KindsWith(const std::function<bool(const StudyPlot&)>& has)
{
  std::vector<std::string> names = ChartKindNames();
  names.insert(names.end(), { "mesh", "overview" });
  std::erase_if(names,
    [&has](const std::string& name)
    {
      StudyPlot plot;
      plot.Kind = name;
      return !has(plot);
    });
  std::string text = names.size() == 1 ? "the kind " : "the kinds ";
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  }
  return text;
}

/** True for kinds that show all columns of numbers where none is named. */
bool MayShowAll(const StudyPlot& plot)
{
  const ChartKind* kind = KindOf(plot);
  return kind && (kind->LeastY > 1 || plot.Kind == "small-multiples");
}

std::vector<std::string> AllKinds()
{
  std::vector<std::string> names = ChartKindNames();
  names.insert(names.end(), { "mesh", "overview" });
  return names;
}

Field<StudyPlot> OrdinatesField()
{
  Field<StudyPlot> field = TextsField("y", &StudyPlot::Y,
    "Columns; the name of a metric alone stands for its min, mean and max. Required but for the "
    "kinds " +
      KindsWith(MayShowAll).substr(10) + ", which take all columns of numbers.");
  const auto write = field.Write;
  field.Read = [](const JsonValue& json, const DocumentPlace& place, StudyPlot& plot)
  {
    plot.Y = ReadTexts(json, place);
    if (plot.Y.empty())
    {
      place.Fail("is empty: name at least one column.");
    }
  };
  field.Write = [write](const StudyPlot& plot) -> std::optional<JsonValue>
  { return plot.Y.empty() ? std::nullopt : write(plot); };
  field.ReadMissing = [](const DocumentPlace& place, StudyPlot& plot)
  {
    if (!MayShowAll(plot))
    {
      place.Fail("is missing (text or list of texts).");
    }
  };
  return std::move(field).Only(HasAxes, KindsWith(HasAxes));
}

/** One key for every option of a kind of chart. */
Field<StudyPlot> OptionField(const SettingField<ChartOptions>& option)
{
  const std::string name = option.Name;
  const auto has = [name](const StudyPlot& plot)
  {
    const ChartKind* kind = KindOf(plot);
    return kind && plot.Kind != "overview" && HasOption(*kind, name);
  };
  const auto ofAll = std::all_of(ChartKinds().begin(), ChartKinds().end(),
    [&name](const ChartKind& kind) { return HasOption(kind, name); });
  Field<StudyPlot> field = { name, DescribeSetting(option), option.Description,
    [option](const JsonValue& json, const DocumentPlace& place, StudyPlot& plot)
    {
      ChartOptions checked;
      plot.Options[option.Name] =
        ReadSettingJson(ChartOptionFields(), option, json, place, checked);
    },
    [option](const StudyPlot& plot) -> std::optional<JsonValue>
    {
      const auto found = plot.Options.find(option.Name);
      return found == plot.Options.end() ? std::nullopt
                                         : std::optional(SettingToJson(option, found->second));
    } };
  return std::move(field).Only(has, ofAll ? "charts" : KindsWith(has));
}

Field<StudyPlot> CasesField()
{
  Field<StudyPlot> field = { "cases", "list of integers",
    "Whose elements, numbered as case; by default the last one's. Several are told apart by the "
    "column Mesh.",
    [](const JsonValue& json, const DocumentPlace& place, StudyPlot& plot)
    {
      plot.Cases.clear();
      for (const JsonValue& item : ReadList(json, place))
      {
        const NumberRange range{ -static_cast<double>(MostCases), static_cast<double>(MostCases) };
        plot.Cases.push_back(ReadInteger(item, place.Item(plot.Cases.size()), range));
      }
    },
    [](const StudyPlot& plot) -> std::optional<JsonValue>
    {
      JsonValue::List list;
      for (const int index : plot.Cases)
      {
        list.push_back(JsonValue{ std::int64_t{ index } });
      }
      return list.empty() ? std::nullopt : std::optional(JsonValue{ std::move(list) });
    } };
  return std::move(field).Only(IsOfElements, KindsWith(IsOfElements));
}

/** Named by its file, or given key by key. */
template <typename Owner>
Field<Owner> StyleField(const std::string& description)
{
  return { "style", "text or object",
    description +
      ": the file of a style (.json, relative to the study), or keys of one, and \"from\" for the "
      "file that they differ from: see `pemesh list style`.",
    [](const JsonValue& json, const DocumentPlace& place, Owner& owner)
    {
      if (json.As<std::string>())
      {
        owner.Style.File = ReadText(json, place);
        return;
      }
      owner.Style.Settings = ReadStyleKeys(json, place, owner.Style.File);
    },
    [](const Owner& owner) -> std::optional<JsonValue>
    { return WriteStyleKeys(owner.Style.Settings, owner.Style.File); } };
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
  return std::move(field).Only([](const StudyPlot& plot)
    { return HasAxes(plot) && KindOf(plot)->UsesLog; },
    KindsWith([](const StudyPlot& plot) { return HasAxes(plot) && KindOf(plot)->UsesLog; }));
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
  name += ShowsMesh(plot)
    ? (plot.ColorBy.empty() ? "" : "-" + plot.ColorBy)
    : (plot.Y.empty() ? "" : "-" + plot.Y.front()) + (plot.X.empty() ? "" : "-vs-" + plot.X);
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
  constexpr auto usesX = [](const StudyPlot& plot) { return HasAxes(plot) && KindOf(plot)->UsesX; };
  constexpr auto usesColor = [](const StudyPlot& plot)
  { return !HasAxes(plot) || (KindOf(plot)->UsesColor && plot.Kind != "line"); };
  table.Fields = { ChoiceField("kind", &StudyPlot::Kind, AllKinds(),
                     "A chart (see `pemesh list charts`), one mesh, or all of it side by side.")
                     .Required(),
    TextField("x", &StudyPlot::X,
      "A column; of results by default the first swept parameter, or else Index.")
      .Only(usesX, KindsWith(usesX)),
    OrdinatesField(), LogarithmField(),
    TextField("color-by", &StudyPlot::ColorBy,
      "The column or the array of the mesh that gives the colours.")
      .Only(usesColor, KindsWith(usesColor)),
    ChoiceField("highlight", &StudyPlot::Highlight, { "none", "min", "max", "both" },
      "Which extreme elements of color-by are marked.")
      .Only([](const StudyPlot& plot) { return plot.Kind == "mesh"; }, "the kind mesh"),
    IntegerField("case", &StudyPlot::Case, -MostCases, MostCases,
      "Which mesh, from 0; negative numbers count from the last one, -1.")
      .Only(ShowsMesh, ShowsMeshes),
    CasesField() };
  for (const SettingField<ChartOptions>& option : ChartOptionFields())
  {
    table.Fields.push_back(OptionField(option));
  }
  table.Fields.insert(table.Fields.end(),
    { StyleField<StudyPlot>("How it looks, on top of the style of the study"),
      TextField("title", &StudyPlot::Title, "Written above it."), FileField(),
      BooleanField(
        "data", &StudyPlot::Data, "Whether the numbers behind it are written beside it, as CSV.")
        .Only(HasAxes, KindsWith(HasAxes)) });
  return table;
}

Field<Study> StudyStyleField()
{
  return StyleField<Study>("How all figures and the report look");
}

void FinishPlots(const DocumentPlace& place, Study& study)
{
  std::set<std::string> taken;
  for (std::size_t i = 0; i < study.Plots.size(); ++i)
  {
    StudyPlot& plot = study.Plots[i];
    const ChartKind* kind = KindOf(plot);
    if (kind && kind->UsesX && !kind->OfElements && plot.Kind != "correlation-matrix" &&
      plot.X.empty())
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
