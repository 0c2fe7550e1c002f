// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ColumnLabels.h"

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
