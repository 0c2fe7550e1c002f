// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "NumberText.h"

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

using namespace pemesh;

TEST(NumberText, IsTheShortestThatRoundTrips)
{
  EXPECT_EQ(FormatNumber(0.1), "0.1");
  EXPECT_EQ(FormatNumber(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(FormatNumber(1.0), "1");
  EXPECT_EQ(FormatNumber(-0.0), "-0");
  EXPECT_EQ(FormatNumber(1e100), "1e+100");
  EXPECT_EQ(FormatNumber(5e-324), "5e-324");
  EXPECT_EQ(FormatNumber(1.7976931348623157e308), "1.7976931348623157e+308");
  EXPECT_EQ(FormatNumber(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(FormatNumber(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(FormatNumber(std::nan("")), "nan");
  EXPECT_EQ(FormatNumber(-std::nan("")), "nan");
}

TEST(NumberText, EveryBitOfEveryNumberSurvives)
{
  std::mt19937_64 engine(1);
  for (int i = 0; i < 100000; ++i)
  {
    const double value = std::bit_cast<double>(engine());
    if (!std::isnan(value))
    {
      const auto again = ParseNumber(FormatNumber(value));
      ASSERT_TRUE(again.has_value());
      ASSERT_EQ(std::bit_cast<std::uint64_t>(*again), std::bit_cast<std::uint64_t>(value));
    }
  }
}

TEST(NumberText, DoesNotDependOnTheLocale)
{
  // Whichever of these is installed has a decimal comma.
  for (const char* locale : { "", "de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "it_IT.UTF-8" })
  {
    std::setlocale(LC_ALL, locale);
    const std::string text = FormatNumber(1234567.5);
    const auto point = ParseNumber("1234567.5");
    const auto comma = ParseNumber("1234567,5");
    std::setlocale(LC_ALL, "C");
    EXPECT_EQ(text, "1234567.5");
    EXPECT_EQ(point, 1234567.5);
    EXPECT_FALSE(comma);
  }
}

TEST(NumberText, ParsesWholeTextsOnly)
{
  EXPECT_EQ(ParseNumber(" 2.5\t\r\n"), 2.5);
  EXPECT_EQ(ParseNumber("+2.5"), 2.5);
  EXPECT_EQ(ParseNumber(".5"), 0.5);
  EXPECT_EQ(ParseNumber("5."), 5.0);
  EXPECT_EQ(ParseNumber("1E3"), 1000.0);
  EXPECT_EQ(ParseNumber("inf"), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(ParseNumber("nan").value()));
  for (const char* text : { "", " ", "x", "1x", "1 2", "0x10", "1e", "--1", "+-1", "1e999", "+" })
  {
    EXPECT_FALSE(ParseNumber(text)) << text;
  }
  EXPECT_EQ(ParseInteger(" 42 "), 42);
  EXPECT_EQ(ParseInteger("-9223372036854775808"), std::numeric_limits<long long>::min());
  for (const char* text : { "", "1.0", "9223372036854775808", "1e3", "0x1", "one" })
  {
    EXPECT_FALSE(ParseInteger(text)) << text;
  }
}

TEST(NumberText, TextsMayEndWithoutAZeroByte)
{
  const std::string digits = "123456";
  EXPECT_EQ(ParseInteger(std::string_view(digits).substr(1, 3)), 234);
  EXPECT_EQ(ParseNumber(std::string_view(digits).substr(0, 2)), 12.0);
}

TEST(NumberText, FindsTheNearestWord)
{
  EXPECT_EQ(EditDistance("", "abc"), 3);
  EXPECT_EQ(EditDistance("kitten", "sitting"), 3);
  EXPECT_EQ(EditDistance("order", "order"), 0);
  const std::vector<std::string> words{ "comb", "convexity", "star" };
  EXPECT_EQ(NearestWord("convex", words), "convexity");
  EXPECT_EQ(NearestWord("str", words), "star");
  EXPECT_EQ(NearestWord("x", std::vector<std::string>()), "");
}

TEST(NumberText, CountsInWords)
{
  EXPECT_EQ(pemesh::FormatCount(0, "mesh", "meshes"), "0 meshes");
  EXPECT_EQ(pemesh::FormatCount(1, "mesh", "meshes"), "1 mesh");
  EXPECT_EQ(pemesh::FormatCount(5000000000, "mesh", "meshes"), "5000000000 meshes");
}
