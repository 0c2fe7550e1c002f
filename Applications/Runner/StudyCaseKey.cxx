// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyCaseKey.h"

#include "ContentDigest.h"
#include "NumberText.h"
#include "SolverCommand.h"
#include "SolverDescription.h"
#include "Study.h"
#include "StudyCases.h"
#include "StudyFile.h"

namespace pemesh
{

std::string StudyCaseKey(const Study& study, const std::vector<SolverDescription>& solvers,
  const std::vector<std::filesystem::path>& meshFiles, const StudyCase& studyCase)
{
  Study ofCase = MakeStudyOfCase(study, studyCase.Values);
  ofCase.Name.clear();
  ofCase.Meshes.clear(); // of all files, only that of the case counts
  ContentDigest digest;
  digest.Add(FormatStudy(ofCase));
  digest.Add(studyCase.Name);
  digest.Add(FormatNumber(studyCase.Time));
  for (const SweptValue& swept : studyCase.Values)
  {
    digest.Add(swept.Name);
    digest.Add(FormatScalar(swept.Value));
  }
  if (const auto file = static_cast<std::size_t>(studyCase.Time); HasMeshFiles(study))
  {
    digest.AddFile(meshFiles.at(file));
  }
  if (!ofCase.Domain.File.empty())
  {
    digest.AddFile(study.Folder / ofCase.Domain.File);
  }
  for (const StudyPolygon& polygon : ofCase.Polygons)
  {
    if (!polygon.File.empty())
    {
      digest.AddFile(study.Folder / polygon.File);
    }
  }
  for (const SolverDescription& solver : solvers)
  {
    digest.Add(SolverFingerprint(solver));
  }
  return digest.Finish();
}

} // namespace pemesh
