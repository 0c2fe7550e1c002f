// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MetricReference.h"

#include "MeshMetrics.h"
#include "MetricRegistry.h"
#include "ValueStatistics.h"

namespace pemesh
{

namespace
{

constexpr const char* Introduction = R"(# Reference of metrics

Made from the registry, by which a test compares it: change the tables in this folder, not this page.

E is an element with n vertices in counter-clockwise order, A its area, P its perimeter, h its
diameter (largest distance of two vertices), e_min and e_max its shortest and longest edge, r the
radius of the largest circle inside it, R that of the smallest circle around it, K its kernel (the
points that see all of it), A_K and r_K area and inscribed radius of the kernel, theta_i the interior
angles, up to 2 pi, in radians. Straight vertices count as vertices. What is undefined is NaN.
)";

const char* DescribeGood(int good)
{
  return good > 0 ? "larger is better" : (good < 0 ? "smaller is better" : "");
}

std::string Join(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

/** "; " and a text, or nothing. */
std::string Also(const std::string& text)
{
  return text.empty() ? "" : "; " + text;
}

std::string DescribeMetric(const Metric& metric)
{
  const std::string alias = metric.Alias;
  std::string text = "\n### " + std::string(metric.Name) + "\n\n" + metric.Label + ", " +
    metric.Symbol + (alias.empty() ? "" : "; also `" + alias + "`") + "\n\n$$" + metric.Tex +
    "$$\n\n" + metric.Description + "\n\nRange " + metric.Range + Also(DescribeGood(metric.Good)) +
    "; unit " + metric.Unit + Also(metric.ScaleInvariant ? "" : "changes with the scale") +
    Also(metric.RotationInvariant ? "" : "changes when turned") + ".";
  const std::string needs = Join(DescribeNeeds(metric.Needs));
  text += needs.empty() ? "" : " Needs " + needs + ".";
  return text + "\n\nReference: " + metric.Reference + ". Test: `" + MetricTest(metric) + "`.\n";
}

std::string DescribeSet(const char* title, MetricSet set)
{
  std::string text = "\n## " + std::string(title) + "\n";
  for (const Metric& metric : Metrics())
  {
    text += metric.Set == set ? DescribeMetric(metric) : "";
  }
  return text;
}

/** All jumps are alike, so they share one entry. */
std::string DescribeJumps()
{
  std::string text = R"(
### Jumps

Of a quantity q that does not change with the scale, the largest difference to a neighbour,

$$\max_{E'} |q(E) - q(E')|,$$

of a length or an area the largest ratio to a neighbour, undefined where one of the two is zero,

$$\max_{E'} \frac{\max(q(E), q(E'))}{\min(q(E), q(E'))}.$$

Smaller is better; undefined without neighbours.

| differences, range [0, inf) | ratios, range [1, inf) |
|---|---|
)";
  std::string columns[2];
  for (const Metric& metric : Metrics())
  {
    if (metric.Set == MetricSet::Jump)
    {
      std::string& column = columns[FindMetric(metric.Base)->ScaleInvariant ? 0 : 1];
      column += (column.empty() ? "`" : ", `") + std::string(metric.Name) + "`";
    }
  }
  return text + "| " + columns[0] + " | " + columns[1] + " |\n";
}

std::string Cite(const std::string& reference)
{
  return reference.empty() ? "" : " Reference: " + reference + ".";
}

std::string DescribeMesh()
{
  std::string text = "\n## Numbers of a mesh\n\nOne column of a summary each.\n\n"
                     "| name | formula | what it is | unit | good |\n|---|---|---|---|---|\n";
  for (const MeshMetric& metric : MeshMetrics())
  {
    // A bar would end the cell.
    std::string tex = metric.Tex;
    for (std::size_t at = tex.find('|'); at != std::string::npos; at = tex.find('|', at + 5))
    {
      tex.replace(at, 1, R"(\vert )");
    }
    text += "| `" + std::string(metric.Name) + "` | $" + tex + "$ | " + metric.Description +
      Cite(metric.Reference) + " | " + metric.Unit + " | " + DescribeGood(metric.Good) + " |\n";
  }
  return text;
}

template <typename Table>
std::string DescribeTable(const char* title, const Table& table)
{
  std::string text = "\n| " + std::string(title) + " | column | what it is |\n|---|---|---|\n";
  for (const auto& entry : table)
  {
    const std::string suffix = entry.Suffix;
    text += "| `" + std::string(entry.Name) + "` | " + (suffix.empty() ? "" : "`" + suffix + "`") +
      " | " + entry.Description + " |\n";
  }
  return text;
}

} // namespace

std::string DescribeMetrics()
{
  std::string text = Introduction;
  text += DescribeSet("Measures of an element", MetricSet::Measure);
  text += DescribeSet("Indicators of the literature", MetricSet::Indicator);
  text += DescribeSet("An element and its neighbours", MetricSet::Neighbourhood);
  text += DescribeJumps();
  text += DescribeSet("The stiffness matrix of an element", MetricSet::Solver);
  text += DescribeMesh();
  text += "\n## Summaries\n\nA column is named `<metric>_<statistic><group>`, for example "
          "`Area_min_placed`; of all elements the group is empty.\n";
  text += DescribeTable("statistic", Statistics());
  text += "\nQuantiles are `_q0.05` and so on, histograms `_bin1` and so on.\n";
  text += DescribeTable("group", ElementGroups());
  text += "\n## Collections\n\nWords that stand for several metrics:\n\n";
  for (const MetricCollection& collection : MetricCollections())
  {
    text += "- `" + std::string(collection.Name) + "`: " + collection.Description + "\n";
  }
  return text;
}

} // namespace pemesh
