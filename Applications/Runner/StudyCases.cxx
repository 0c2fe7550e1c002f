// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyCases.h"

#include "Study.h"
#include "vtkPEMMeshReader.h"

#include <vtkNew.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <stdexcept>

namespace pemesh
{

namespace
{

std::string NumberName(int index, int count)
{
  const std::size_t width = std::max<std::size_t>(3, std::to_string(count - 1).size());
  std::string name = std::to_string(index);
  return name.insert(0, width - std::min(width, name.size()), '0');
}

std::vector<StudyCase> CasesOfFiles(const Study& study)
{
  vtkNew<vtkPEMMeshReader> reader; // names the meshes, without reading them
  for (const std::filesystem::path& path : FindStudyMeshes(study))
  {
    reader->AddFileName(path.string());
  }
  const std::vector<std::vector<SweptValue>> sweeps = SweepCases(study);
  const int count = static_cast<int>(sweeps.size());
  std::vector<StudyCase> cases;
  for (int file = 0; file < reader->GetNumberOfFileNames(); ++file)
  {
    for (int i = 0; i < count; ++i)
    {
      const std::string suffix = study.Sweep.empty() ? "" : "_" + NumberName(i, count);
      cases.push_back({ static_cast<int>(cases.size()), reader->GetMeshName(file) + suffix,
        static_cast<double>(file), sweeps[static_cast<std::size_t>(i)] });
    }
  }
  return cases;
}

std::vector<StudyCase> CasesOfSweeps(const Study& study)
{
  const std::vector<std::vector<SweptValue>> sweeps = SweepCases(study);
  const int count = static_cast<int>(sweeps.size());
  std::vector<StudyCase> cases;
  cases.reserve(sweeps.size());
  for (const std::vector<SweptValue>& values : sweeps)
  {
    const int index = static_cast<int>(cases.size());
    cases.push_back(
      { index, GeneratedMeshName(index, count, values), DeformationOf(values), values });
  }
  return cases;
}

} // namespace

std::string GeneratedMeshName(int index, int count, const std::vector<SweptValue>& values)
{
  std::string name = NumberName(index, count);
  for (const SweptValue& value : values)
  {
    if (value.Parameter == DeformationParameter)
    {
      char buffer[32];
      const auto end = std::to_chars(
        buffer, buffer + sizeof(buffer), ScalarToNumber(value.Value), std::chars_format::fixed, 6);
      name += "_" + std::string(buffer, end.ptr);
    }
  }
  return name;
}

std::vector<StudyCase> MakeStudyCases(const Study& study)
{
  std::vector<StudyCase> cases = HasMeshFiles(study) ? CasesOfFiles(study) : CasesOfSweeps(study);
  if (cases.empty())
  {
    throw std::runtime_error("The study \"" + study.Name + "\" has no mesh.");
  }
  for (const std::vector<SweptValue>& values : SweepCases(study))
  {
    MakeStudyOfCase(study, values); // throws
  }
  return cases;
}

} // namespace pemesh
