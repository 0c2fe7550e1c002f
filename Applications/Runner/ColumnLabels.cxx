// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ColumnLabels.h"

#include "MetricRegistry.h"
#include "SolverDescription.h"
#include "Study.h"

#include <array>
#include <utility>

namespace pemesh
{

namespace
{

constexpr std::array<std::pair<const char*, const char*>, 3> Statistics{ {
  { "_min", "smallest" },
  { "_max", "largest" },
  { "_mean", "mean" },
} };

constexpr std::array<std::pair<const char*, const char*>, 6> MeshColumns{ {
  { "t", "deformation t" },
  { "Elements", "number of elements" },
  { "Vertices", "number of vertices" },
  { "MeshSize", "mesh size h" },
  { "Index", "index of the mesh" },
  { "AttainedMinimumAngle", "smallest angle attained (degrees)" },
} };

constexpr std::array<std::pair<const char*, const char*>, 3> SolverArrays{ {
  { "Solution", "solution" },
  { "GroundTruth", "ground truth" },
  { "Error", "error" },
} };

std::string WithUnit(const std::string& title, const std::string& unit)
{
  return unit.empty() || unit == "1" ? title : title + " (" + unit + ")";
}

std::string LowerFirst(std::string text)
{
  if (text.size() > 1 && text[0] >= 'A' && text[0] <= 'Z' && text[1] >= 'a' && text[1] <= 'z')
  {
    text[0] = static_cast<char>(text[0] - 'A' + 'a');
  }
  return text;
}

} // namespace

ColumnLabels::ColumnLabels()
{
  for (const auto& [name, title] : MeshColumns)
  {
    this->Titles[name] = title;
  }
  for (const Metric& metric : Metrics())
  {
    const std::string label = LowerFirst(metric.Label);
    this->Titles[metric.Name] = WithUnit(label, metric.Unit);
    for (const auto& [ending, word] : Statistics)
    {
      this->Titles[std::string(metric.Name) + ending] =
        WithUnit(std::string(word) + " " + label, metric.Unit);
    }
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
  return found == this->Titles.end() ? column : found->second;
}

} // namespace pemesh
