// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ColumnLabels.h"

#include "SolverDescription.h"
#include "Study.h"
#include "SummaryTitles.h"

#include <array>
#include <utility>

namespace pemesh
{

namespace
{

/** What no table of the metrics has. */
constexpr std::array<std::pair<const char*, const char*>, 3> OtherColumns{ {
  { "t", "deformation t" },
  { "Index", "index of the mesh" },
  { "AttainedMinimumAngle", "smallest angle attained (degrees)" },
} };

constexpr std::array<std::pair<const char*, const char*>, 3> SolverArrays{ {
  { "Solution", "solution" },
  { "GroundTruth", "ground truth" },
  { "Error", "error" },
} };

} // namespace

ColumnLabels::ColumnLabels()
{
  for (const auto& [name, title] : OtherColumns)
  {
    this->Titles[name] = title;
  }
}

ColumnLabels::ColumnLabels(const Study& study, const std::vector<SolverDescription>& solvers)
  : ColumnLabels()
{
  const bool several = study.Solvers.size() > 1;
  for (std::size_t i = 0; i < study.Solvers.size(); ++i)
  {
    const std::string& run = study.Solvers[i].Name;
    const std::string ending = several ? ", " + run : std::string();
    for (const SolverPerformance& performance : solvers[i].Performances)
    {
      const std::string& label = performance.Label;
      this->Titles[run + "_" + performance.Name] =
        (label.empty() ? performance.Name : LowerFirst(label)) + ending;
    }
    for (const auto& [name, title] : SolverArrays)
    {
      this->Titles[run + "_" + name] = title + ending;
    }
  }
}

std::string ColumnLabels::Title(const std::string& column) const
{
  const auto found = this->Titles.find(column);
  if (found != this->Titles.end())
  {
    return found->second;
  }
  const std::string title = TitleOfSummaryColumn(column);
  return title.empty() ? column : title;
}

} // namespace pemesh
