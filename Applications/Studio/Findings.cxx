// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Findings.h"

#include "ColumnLabels.h"
#include "ColumnRoles.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>

#include <vtkTable.h>
#include <vtkVariant.h>

namespace pemesh
{

namespace
{

/** "Condition number: higher where smallest area is lower (Spearman -0.98, 20 meshes)" */
std::string SentenceOf(const std::string& x, const std::string& y, double rho, int meshes)
{
  std::array<char, 96> numbers{};
  std::snprintf(numbers.data(), numbers.size(), " (Spearman %+.2f, %d meshes)", rho, meshes);
  std::string sentence =
    y + ": higher where " + x + (rho > 0.0 ? " is higher" : " is lower") + numbers.data();
  sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
  return sentence;
}

} // namespace

std::vector<Finding> RankFindings(vtkTable* correlation, const ColumnLabels& labels)
{
  std::vector<Finding> findings;
  for (vtkIdType row = 0; correlation && row < correlation->GetNumberOfRows(); ++row)
  {
    const double rho = correlation->GetValueByName(row, "Spearman").ToDouble();
    if (std::isnan(rho))
    {
      continue;
    }
    Finding finding;
    finding.X = correlation->GetValueByName(row, "X").ToString();
    finding.Y = correlation->GetValueByName(row, "Y").ToString();
    finding.Strength = std::abs(rho);
    finding.Sentence = SentenceOf(labels.Title(finding.X), labels.Title(finding.Y), rho,
      correlation->GetValueByName(row, "N").ToInt());
    findings.push_back(finding);
  }
  std::stable_sort(findings.begin(), findings.end(),
    [](const Finding& a, const Finding& b)
    {
      const bool aSolver = !IsMetricColumn(a.Y);
      const bool bSolver = !IsMetricColumn(b.Y);
      return aSolver != bSolver ? aSolver : a.Strength > b.Strength;
    });
  return findings;
}

} // namespace pemesh
