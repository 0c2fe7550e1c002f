// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Parameter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pemesh
{

namespace
{

using ::testing::HasSubstr;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr Parameter Table[] = {
  { "cells", "how many", 100, 1, Infinity, true },
  { "distortion", "share of the side", 0.25, 0, 0.5 },
};

TEST(Parameter, ValuesAreAtFirstTheDefaults)
{
  const ParameterValues values(Table);
  EXPECT_EQ(values.GetInteger("cells"), 100);
  EXPECT_EQ(values.Get("distortion"), 0.25);
  EXPECT_TRUE(std::isnan(values.Get("seed")));
}

TEST(Parameter, OnlyValuesInRangeAreTaken)
{
  ParameterValues values(Table);
  EXPECT_EQ(values.Set("distortion", 0.5), "");
  EXPECT_EQ(values.Set("cells", 1), "");
  EXPECT_EQ(values.Get("distortion"), 0.5);
  EXPECT_EQ(values.Set("distortion", 0.6), "distortion is 0.6; it must be between 0 and 0.5.");
  EXPECT_EQ(values.Set("cells", 2.5), "cells is 2.5; it must be an integer at least 1.");
  EXPECT_NE(values.Set("cells", std::nan("")), "");
  EXPECT_THAT(values.Set("cell", 3), HasSubstr("did you mean \"cells\""));
  EXPECT_EQ(values.Get("distortion"), 0.5);
  EXPECT_EQ(values.Get("cells"), 1);
  EXPECT_EQ(ParameterValues().Set("cells", 1), "There is no parameter \"cells\" here.");
}

TEST(Parameter, ValuesOfTheSameTableCompare)
{
  ParameterValues a(Table);
  const ParameterValues b(Table);
  EXPECT_TRUE(a == b);
  a.Set("cells", 7);
  EXPECT_FALSE(a == b);
}

} // namespace

} // namespace pemesh
