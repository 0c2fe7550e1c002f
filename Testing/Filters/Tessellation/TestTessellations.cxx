// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SampleDomains.h"
#include "TessellationInvariants.h"
#include "Tessellations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>
#include <set>

namespace pemesh
{

namespace
{

using ::testing::HasSubstr;

/** A value of the range: one of its ends or, at random, in between; of counts, a small one. */
double DrawValue(const Parameter& parameter, std::mt19937_64& engine)
{
  const double fraction = static_cast<double>(engine() >> 11) * 0x1p-53;
  const bool isCount =
    parameter.IsInteger && parameter.Greatest >= 1e6 && std::string_view(parameter.Name) != "seed";
  const double greatest = isCount ? parameter.Least + 12.0 : parameter.Greatest;
  switch (engine() % 6)
  {
    case 0:
      return parameter.Least;
    case 1:
      return greatest;
    case 2:
      return parameter.Default <= greatest ? parameter.Default : greatest;
    default:
      const double value = parameter.Least + fraction * (greatest - parameter.Least);
      return parameter.IsInteger ? std::floor(value) : value;
  }
}

std::string Describe(const Tessellation& kind, const ParameterValues& values)
{
  std::string text = kind.Name;
  for (const Parameter& parameter : values.GetParameters())
  {
    text += std::string(", ") + parameter.Name + " " + std::to_string(values.Get(parameter.Name));
  }
  return text;
}

bool AreSameToTheBit(const PolygonMesh& a, const PolygonMesh& b)
{
  return a.Offsets == b.Offsets && a.Vertices == b.Vertices && a.Points.size() == b.Points.size() &&
    std::memcmp(a.Points.data(), b.Points.data(), a.Points.size() * sizeof(Point2)) == 0;
}

TEST(Tessellations, TheTableIsWellFormed)
{
  std::set<std::string> names;
  for (const Tessellation& kind : Tessellations())
  {
    EXPECT_TRUE(names.insert(kind.Name).second) << kind.Name;
    EXPECT_EQ(&Tessellations()[FindTessellation(kind.Name)], &kind);
    EXPECT_THAT(kind.Reference, HasSubstr("doi:10.")) << kind.Name;
    for (const Parameter& parameter : kind.Parameters)
    {
      EXPECT_EQ(parameter.WhyInvalid(parameter.Default), "") << kind.Name;
    }
  }
  EXPECT_EQ(FindTessellation("vornoi"), -1);
}

/** New entries of the table are tested as they come. */
TEST(Tessellations, EveryDrawMakesAMeshOfEveryDomain)
{
  const char* seed = std::getenv("PEMESH_DRAW_SEED");
  std::mt19937_64 engine(seed ? std::strtoull(seed, nullptr, 10) : 20);
  int made = 0;
  for (const Tessellation& kind : Tessellations())
  {
    for (const SampleDomain& domain : SampleDomains())
    {
      TessellationInput input;
      input.Values = ParameterValues(kind.Parameters);
      input.Region = domain.Region;
      input.MaximumElements = 400;
      for (const Parameter& parameter : kind.Parameters)
      {
        ASSERT_EQ(input.Values.Set(parameter.Name, DrawValue(parameter, engine)), "");
      }
      SCOPED_TRACE(Describe(kind, input.Values) + " in " + domain.Name);
      const TessellationResult result = MakeTessellation(kind, input);
      if (result.Status == TessellationStatus::TooManyElements)
      {
        continue;
      }
      ASSERT_EQ(result.Status, TessellationStatus::Done) << result.Message;
      ASSERT_EQ(WhyNotAMeshOf(domain.Region, result.Mesh), "");
      ++made;
    }
  }
  EXPECT_GT(made, 100);
}

TEST(Tessellations, TheEndsOfEveryRangeMakeAMesh)
{
  for (const Tessellation& kind : Tessellations())
  {
    for (const Parameter& varied : kind.Parameters)
    {
      for (const double end : { varied.Least, varied.Greatest })
      {
        TessellationInput input;
        input.Values = ParameterValues(kind.Parameters);
        input.MaximumElements = 4000;
        if (varied.Greatest >= 1e6 && end == varied.Greatest &&
          std::string_view(varied.Name) == "iterations")
        {
          continue; // an afternoon
        }
        ASSERT_EQ(input.Values.Set(varied.Name, end), "");
        SCOPED_TRACE(Describe(kind, input.Values));
        const TessellationResult result = MakeTessellation(kind, input);
        ASSERT_NE(result.Status, TessellationStatus::Failed) << result.Message;
        if (result.Status == TessellationStatus::Done)
        {
          EXPECT_EQ(WhyNotAMeshOf(input.Region, result.Mesh), "");
        }
      }
    }
  }
}

TEST(Tessellations, TheSameInputGivesTheSameBits)
{
  for (const Tessellation& kind : Tessellations())
  {
    TessellationInput input;
    input.Values = ParameterValues(kind.Parameters);
    input.Region = SampleDomains()[9].Region; // the sieve
    const TessellationResult first = MakeTessellation(kind, input);
    const std::vector<char> otherAddresses(12345);
    const TessellationResult second = MakeTessellation(kind, input);
    EXPECT_TRUE(AreSameToTheBit(first.Mesh, second.Mesh)) << kind.Name;
  }
}

TEST(Tessellations, AnotherSeedGivesAnotherMesh)
{
  for (const Tessellation& kind : Tessellations())
  {
    if (!FindParameter(kind.Parameters, "seed"))
    {
      continue;
    }
    TessellationInput input;
    input.Values = ParameterValues(kind.Parameters);
    const TessellationResult first = MakeTessellation(kind, input);
    input.Values.Set("seed", 2);
    EXPECT_FALSE(AreSameToTheBit(first.Mesh, MakeTessellation(kind, input).Mesh)) << kind.Name;
  }
}

TEST(Tessellations, TooManyElementsAreRefusedBeforeTheyAreMade)
{
  for (const Tessellation& kind : Tessellations())
  {
    TessellationInput input;
    input.Values = ParameterValues(kind.Parameters);
    input.MaximumElements = 1e5;
    const char* count = FindParameter(kind.Parameters, "cells") ? "cells" : "squares";
    input.Values.Set(count, 1e6);
    const TessellationResult result = MakeTessellation(kind, input);
    EXPECT_EQ(result.Status, TessellationStatus::TooManyElements) << kind.Name;
    EXPECT_THAT(result.Message, HasSubstr("the limit is 100000")) << kind.Name;
  }
}

TEST(Tessellations, WorkStopsWhenProgressSaysSo)
{
  TessellationInput input;
  const Tessellation& kind = Tessellations()[FindTessellation("centroidal-voronoi")];
  input.Values = ParameterValues(kind.Parameters);
  input.Values.Set("iterations", 1e6);
  double last = 0.0;
  int calls = 0;
  input.Progress = [&](double done)
  {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1.0);
    last = done;
    return ++calls < 100;
  };
  EXPECT_EQ(MakeTessellation(kind, input).Status, TessellationStatus::Stopped);
  EXPECT_EQ(calls, 100);
}

TEST(Tessellations, WhatDoublesCannotHoldIsRefused)
{
  TessellationInput input;
  const Tessellation& kind = Tessellations()[FindTessellation("voronoi")];
  input.Values = ParameterValues(kind.Parameters);
  input.Region = RectangleDomain(1e12, 1e12, 1e12 + 1.0, 1e12 + 1.0);
  const TessellationResult result = MakeTessellation(kind, input);
  EXPECT_EQ(result.Status, TessellationStatus::Failed);
  EXPECT_THAT(result.Message, HasSubstr("\"voronoi\""));
  EXPECT_THAT(result.Message, HasSubstr("origin"));
}

} // namespace

} // namespace pemesh
