// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MetricReference.h"
#include "MetricRegistry.h"
#include "TestFolder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

TEST(MetricReference, ThePageIsThatOfTheRegistry)
{
  const std::string page = pemesh::DescribeMetrics();
  std::ifstream file(PEMESH_SOURCE_DIR "/Filters/Metrics/METRICS.md");
  const std::string stored{ std::istreambuf_iterator<char>(file), {} };
  const std::filesystem::path made = pemesh::TestPath("METRICS.md");
  std::ofstream(made) << page;
  EXPECT_TRUE(page == stored) << "put " << made << " in the place of Filters/Metrics/METRICS.md";
}

TEST(MetricReference, NamesEveryMetric)
{
  const std::string page = pemesh::DescribeMetrics();
  for (const pemesh::Metric& metric : pemesh::Metrics())
  {
    const std::string name = metric.Name;
    EXPECT_TRUE(page.find("### " + name + "\n") != std::string::npos ||
      page.find("`" + name + "`") != std::string::npos)
      << name;
  }
}
