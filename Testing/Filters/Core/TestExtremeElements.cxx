// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExtremeElements.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>

namespace
{

pemesh::ExtremeElements Find(std::initializer_list<double> values)
{
  vtkNew<vtkDoubleArray> array;
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  return pemesh::FindExtremeElements(array);
}

constexpr double Nan = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

} // namespace

TEST(ExtremeElements, AreTheSmallestAndTheLargest)
{
  const auto found = Find({ 2.0, -1.0, 7.0, 3.0 });
  EXPECT_EQ(found.Smallest, 1);
  EXPECT_EQ(found.Largest, 2);
}

TEST(ExtremeElements, OfEqualOnesTheFirst)
{
  const auto found = Find({ 2.0, 1.0, 2.0, 1.0 });
  EXPECT_EQ(found.Smallest, 1);
  EXPECT_EQ(found.Largest, 0);
}

TEST(ExtremeElements, WhatIsNotFiniteIsLeftOut)
{
  const auto found = Find({ Nan, Infinity, 4.0, -Infinity, 5.0, Nan });
  EXPECT_EQ(found.Smallest, 2);
  EXPECT_EQ(found.Largest, 4);
}

TEST(ExtremeElements, ThereAreNoneOfNothing)
{
  for (const auto& found :
    { Find({}), Find({ Nan, Infinity }), pemesh::FindExtremeElements(nullptr) })
  {
    EXPECT_EQ(found.Smallest, -1);
    EXPECT_EQ(found.Largest, -1);
  }
}

TEST(ExtremeElements, OfSeveralComponentsTheFirstCounts)
{
  vtkNew<vtkFloatArray> array;
  array->SetNumberOfComponents(2);
  for (const float first : { 1.0F, 0.0F, 3.0F })
  {
    const float tuple[] = { first, -10.0F * first };
    array->InsertNextTypedTuple(tuple);
  }
  const auto found = pemesh::FindExtremeElements(array);
  EXPECT_EQ(found.Smallest, 1);
  EXPECT_EQ(found.Largest, 2);
}
