// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChartKinds.h"

#include "ChartBuilders.h"

#include <algorithm>

namespace pemesh
{

std::span<const ChartKind> ChartKinds()
{
  static const std::vector<ChartKind> kinds = {
    { "line", "Lines", "Columns over another one, joined in the order of the rows.",
      "x (default: the row), any number of y", true, true, true, 1, 0.7, true, { "group-by" },
      MakeLineChart },
    { "scatter", "Scatter",
      "Columns against another one, coloured by a third; a density above ten thousand points.",
      "x, any number of y, color-by", true, true, true, 1, 0.7, false,
      { "group-by", "fit", "confidence", "density-above" }, MakeScatterChart },
    { "small-multiples", "Small multiples", "A small line chart for every column, over one x.",
      "x (default: the row), any number of y", true, false, true, 1, 0.75, true, {},
      MakeSmallMultiples },
  };
  return kinds;
}

const ChartKind* FindChartKind(const std::string& name)
{
  const auto kinds = ChartKinds();
  const auto found = std::find_if(
    kinds.begin(), kinds.end(), [&name](const ChartKind& kind) { return name == kind.Name; });
  return found == kinds.end() ? nullptr : &*found;
}

std::vector<std::string> ChartKindNames()
{
  std::vector<std::string> names;
  for (const ChartKind& kind : ChartKinds())
  {
    names.emplace_back(kind.Name);
  }
  return names;
}

bool HasOption(const ChartKind& kind, const std::string& option)
{
  return std::find(kind.Options.begin(), kind.Options.end(), option) != kind.Options.end();
}

} // namespace pemesh
