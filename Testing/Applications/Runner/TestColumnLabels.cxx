// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ColumnLabels.h"
#include "MeshMetrics.h"
#include "MetricRegistry.h"
#include "ValueStatistics.h"

#include <gtest/gtest.h>

using pemesh::ColumnLabels;

TEST(ColumnLabels, SayWhatAColumnHoldsAndInWhichUnit)
{
  const ColumnLabels labels;
  EXPECT_EQ(labels.Title("t"), "deformation t");
  EXPECT_NE(labels.Title("MinAngle_min").find("(rad)"), std::string::npos);
  EXPECT_EQ(labels.Title("MinAngle_min").find("smallest "), 0U);
  EXPECT_EQ(labels.Title("EdgeRatio_mean").find("(1)"), std::string::npos) << "no unit for ratios";
  EXPECT_EQ(labels.Title("somebody-elses-column"), "somebody-elses-column");
}

TEST(ColumnLabels, ReadEveryKindOfColumnFromTheTables)
{
  const ColumnLabels labels;
  const std::vector<std::pair<std::string, std::string>> titles = {
    { "MinAngle", "minimum angle MA (rad)" },
    { "MinAngle_min", "smallest minimum angle MA (rad)" },
    { "MinAngle_max_placed", "largest minimum angle MA, placed polygons (rad)" },
    { "MinAngle_deviation", "standard deviation of minimum angle MA (rad)" },
    { "Area_area_mean", "area-weighted mean area AR (length^2)" },
    { "Area_area_mean_filler", "area-weighted mean area AR, around placed polygons (length^2)" },
    { "MinAngle_undefined_triangles", "elements with undefined minimum angle MA, triangles" },
    { "MinAngle_min_element", "element of the smallest minimum angle MA" },
    { "MinAngle_q0.05", "0.05-quantile of minimum angle MA (rad)" },
    { "Diameter_q0.95_polygons", "0.95-quantile of diameter h, polygons (length)" },
    { "CircleRatio_bin3_selected", "elements in bin 3 of circle ratio CR, selected elements" },
    { "AreaJump_max", "largest jump of area J(AR)" },
    { "MeshRho", "mesh quality rho" },
    { "MeshSize", "mesh size h (length)" },
    { "Elements", "number of elements" },
    { "TotalArea", "total area (length^2)" },
  };
  for (const auto& [column, title] : titles)
  {
    EXPECT_EQ(labels.Title(column), title);
  }
  for (const char* other : { "MinAngle_", "MinAngle_median", "MinAngle_qx", "MinAngle_bin",
         "MinAngle_mean_element", "MinAngle_min_squares", "pemesh-vem_dofs", "_min", "" })
  {
    EXPECT_EQ(labels.Title(other), other) << "is its own title";
  }
}

TEST(ColumnLabels, EveryColumnOfASummaryHasOne)
{
  const ColumnLabels labels;
  for (const pemesh::Metric& metric : pemesh::Metrics())
  {
    EXPECT_NE(labels.Title(metric.Name), metric.Name);
    for (const pemesh::Statistic& statistic : pemesh::Statistics())
    {
      for (const pemesh::ElementGroup& group : pemesh::ElementGroups())
      {
        const std::string column = std::string(metric.Name) + "_" + statistic.Suffix + group.Suffix;
        EXPECT_NE(labels.Title(column), column);
      }
    }
  }
  for (const std::string& name : pemesh::MeshMetricNames())
  {
    EXPECT_NE(labels.Title(name), name);
  }
}
