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

std::string GeneratedMeshName(int index, int count, double t)
{
  const std::size_t width = std::max<std::size_t>(3, std::to_string(count - 1).size());
  std::string name = std::to_string(index);
  name.insert(0, width - std::min(width, name.size()), '0');
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), t, std::chars_format::fixed, 6);
  return name + "_" + std::string(buffer, end.ptr);
}

namespace
{

std::vector<StudyCase> CasesOfFiles(const Study& study)
{
  vtkNew<vtkPEMMeshReader> reader; // names the meshes, without reading them
  for (const std::filesystem::path& path : FindStudyMeshes(study))
  {
    reader->AddFileName(path.string());
  }
  std::vector<StudyCase> cases;
  for (int index = 0; index < reader->GetNumberOfFileNames(); ++index)
  {
    cases.push_back({ index, reader->GetMeshName(index), static_cast<double>(index), {} });
  }
  return cases;
}

std::vector<StudyCase> CasesOfTimes(const Study& study)
{
  const std::vector<double> times = StudyTimes(study);
  const int count = static_cast<int>(times.size());
  std::vector<StudyCase> cases;
  cases.reserve(times.size());
  for (int index = 0; index < count; ++index)
  {
    const double t = times[static_cast<std::size_t>(index)];
    cases.push_back({ index, GeneratedMeshName(index, count, t), t, { { "t", t } } });
  }
  return cases;
}

} // namespace

std::vector<StudyCase> MakeStudyCases(const Study& study)
{
  std::vector<StudyCase> cases = HasMeshFiles(study) ? CasesOfFiles(study) : CasesOfTimes(study);
  if (cases.empty())
  {
    throw std::runtime_error("The study \"" + study.Name + "\" has no mesh.");
  }
  return cases;
}

} // namespace pemesh
