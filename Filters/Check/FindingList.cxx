// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "FindingList.h"

#include <algorithm>

namespace pemesh
{

FindingList::FindingList(MeshReport& report, int elements, int mostExamples)
  : Report(report)
  , MostExamples(mostExamples)
{
  report.Counts.assign(MeshChecks().size(), 0);
  report.Faults.assign(static_cast<std::size_t>(elements), 0);
  report.FaultBits.assign(static_cast<std::size_t>(elements), 0);
}

void FindingList::StartCheck(std::size_t index)
{
  this->Check = index;
}

bool FindingList::Count(std::span<const int> elements)
{
  for (const int element : elements)
  {
    ++this->Report.Faults[static_cast<std::size_t>(element)];
    this->Report.FaultBits[static_cast<std::size_t>(element)] |= std::uint32_t{ 1 } << this->Check;
  }
  return ++this->Report.Counts[this->Check] <= this->MostExamples;
}

void FindingList::Keep(std::span<const int> elements, std::span<const int> vertices,
  const Point2& place, std::string message)
{
  MeshFinding finding = { &MeshChecks()[this->Check], { elements.begin(), elements.end() },
    { vertices.begin(), vertices.end() }, place, std::move(message) };
  std::sort(finding.Elements.begin(), finding.Elements.end());
  this->Report.Findings.push_back(std::move(finding));
}

} // namespace pemesh
