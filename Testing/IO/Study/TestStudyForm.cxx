// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "DocumentPath.h"
#include "Study.h"
#include "StudyFile.h"
#include "StudyForm.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

using namespace pemesh;

namespace
{

const FormField* Find(const std::vector<FormField>& form, const std::string& path)
{
  const auto found = std::find_if(
    form.begin(), form.end(), [&](const FormField& field) { return field.Path == path; });
  return found == form.end() ? nullptr : &*found;
}

Study Parse(const std::string& text)
{
  return ParseStudy(text, "study.json");
}

constexpr const char* OneStar =
  R"({"pemesh": 1, "polygons": [{"family": "star", "spikes": 7, "scale": 0.5}]})";

} // namespace

TEST(StudyForm, OffersTheKeysThatApplyWithTheirRangesAndValues)
{
  const std::vector<FormField> form = DescribeStudyForm(Parse(OneStar), "polygons[0]");
  const FormField* spikes = Find(form, "polygons[0].spikes");
  ASSERT_TRUE(spikes);
  EXPECT_EQ(spikes->Form.Kind, ValueForm::Integer);
  EXPECT_EQ(spikes->Form.Least, 3.0);
  EXPECT_EQ(spikes->Value->ToNumber(), 7.0);
  EXPECT_FALSE(spikes->Doc.empty());
  EXPECT_FALSE(Find(form, "polygons[0].teeth")) << "a key of another family";
  EXPECT_FALSE(Find(form, "polygons[0].file"));
  EXPECT_EQ(Find(form, "polygons[0].center")->Form.Kind, ValueForm::Pair);
  EXPECT_EQ(Find(form, "polygons[0].family")->Form.Kind, ValueForm::Choice);
  EXPECT_EQ(Find(form, "polygons[0].scale")->Value->ToNumber(), 0.5);
  EXPECT_TRUE(Find(form, "polygons[0].scale")->Form.ExcludesLeast);
}

TEST(StudyForm, HasTheKeysOfObjectsWithin)
{
  const std::vector<FormField> form = DescribeStudyForm(Parse(OneStar), "mesh");
  const FormField* rule = Find(form, "mesh.agglomerate.rule");
  ASSERT_TRUE(rule);
  EXPECT_THAT(rule->Form.Choices, testing::Contains("metis"));
  EXPECT_EQ(*rule->Value->As<std::string>(), "none");
  EXPECT_EQ(Find(form, "mesh.preserve-polygons")->Form.Kind, ValueForm::Truth);
  EXPECT_EQ(Find(form, "mesh.min-angle")->Form.Greatest, 33.0);
}

TEST(StudyForm, WhatTheStudyDoesNotHaveHasNoForm)
{
  for (const char* path : { "polygons[1]", "polygons", "scatter", "nonsense", "solvers[0]" })
  {
    EXPECT_TRUE(DescribeStudyForm(Parse(OneStar), path).empty()) << path;
  }
}

TEST(StudyForm, EveryChoiceOfEveryFormMakesAStudy)
{
  const JsonValue document = ParseJson(OneStar, "study");
  const JsonValue empty = ParseJson(R"({"pemesh": 1, "polygons": []})", "study");
  const Study study = Parse(OneStar);
  for (const char* part : { "domain", "mesh", "polygons[0]", "sweep[0]" })
  {
    for (const FormField& field : DescribeStudyForm(study, part))
    {
      for (const std::string& choice : field.Form.Choices)
      {
        if (choice == "file" || choice == "files" || choice == "points" ||
          field.Path.starts_with("sweep"))
        {
          continue; // these need more than a choice
        }
        // Tessellations go with no polygons.
        const JsonValue chosen =
          ChooseInDocument(field.Path == "mesh.source" ? empty : document, field.Path, choice);
        EXPECT_NO_THROW(Parse(FormatJson(chosen))) << field.Path << " = " << choice;
        EXPECT_EQ(*FindAtPath(chosen, field.Path)->As<std::string>(), choice);
      }
    }
  }
}

TEST(StudyForm, KeysOfTheChoiceBeforeAreTakenOut)
{
  const JsonValue comb =
    ChooseInDocument(ParseJson(OneStar, "study"), "polygons[0].family", "comb");
  EXPECT_FALSE(HasPath(comb, "polygons[0].spikes"));
  EXPECT_TRUE(HasPath(comb, "polygons[0].scale"));
  JsonValue constant = ChooseInDocument(comb, "mesh.max-area.rule", "constant");
  EXPECT_TRUE(HasPath(constant, "mesh.max-area.value")) << "a number that is required";
  constant = ChooseInDocument(constant, "mesh.max-area.rule", "none");
  EXPECT_FALSE(HasPath(constant, "mesh.max-area.value"));
}

TEST(DocumentPath, ValuesAreFoundAndTakenOut)
{
  JsonValue document = ParseJson(R"({"a": {"b": [1, 2, 3]}, "c": 4})", "text");
  EXPECT_EQ(FindAtPath(document, "a.b[1]")->ToNumber(), 2.0);
  EXPECT_FALSE(FindAtPath(document, "a.b[3]"));
  EXPECT_FALSE(FindAtPath(document, "a.x"));
  RemoveAtPath(document, "a.b[0]");
  RemoveAtPath(document, "c");
  RemoveAtPath(document, "nothing.here");
  EXPECT_EQ(FormatJsonCompact(document), R"({"a": {"b": [2, 3]}})");
}
