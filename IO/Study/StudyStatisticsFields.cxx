// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyFields.h"

#include "CoefficientKinds.h"

namespace pemesh
{

FieldTable<StudyStatistics> StatisticsFields()
{
  FieldTable<StudyStatistics> table;
  table.Fields = { ChoiceField("coefficient", &StudyStatistics::Coefficient,
                     NamesOf(CoefficientKinds()),
                     "What ranks, words, p-values and intervals go by."),
    TextsField("given", &StudyStatistics::Given,
      "Columns of the results that are held fixed, as MeshSize: coefficients are partial."),
    TextField("family", &StudyStatistics::Family,
      "The column that tells families of meshes apart, as a swept polygons[0].family; by default "
      "all meshes are one family, which has neither p-values nor intervals."),
    BooleanField("independent", &StudyStatistics::IndependentRows,
      "Whether the meshes come from no family, each independent of the others."),
    IntegerField("permutations", &StudyStatistics::Permutations, 1, 10'000'000,
      "Arrangements of whole families drawn for p-values, where not all can be walked."),
    IntegerField("bootstrap", &StudyStatistics::Bootstrap, 0, 10'000'000,
      "Samples of whole families drawn for confidence intervals; 0: no intervals."),
    NumberField(
      "level", &StudyStatistics::Level, { 0.5, 0.9999 }, "Confidence level of the intervals."),
    IntegerField(
      "seed", &StudyStatistics::Seed, 0, 2'147'483'647, "Of the arrangements and the samples.") };
  return table;
}

} // namespace pemesh
