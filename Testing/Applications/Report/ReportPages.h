// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Pages to look at: of a folder made by hand, and of a small study.
 */
#ifndef pemesh_ReportPages_h
#define pemesh_ReportPages_h

#include "ProgramRun.h"
#include "vtkPEMReport.h"
#include "vtkPEMRunner.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include <vtkNew.h>

namespace pages
{

/** The page of a folder, or the sentence that says why there is none. */
inline std::string Page(const std::filesystem::path& folder)
{
  vtkNew<vtkPEMReport> report;
  report->SetFolder(folder.string());
  return report->Write() ? pemesh::FileText(folder / "report.html") : report->GetErrorMessage();
}

/** Six meshes of a comb and their areas, in a folder. */
inline std::filesystem::path RunSmallStudy(const std::string& name)
{
  const std::filesystem::path folder = pemesh::TestFolder(name);
  vtkNew<vtkPEMRunner> runner;
  runner->SetStudyText(R"({"pemesh": 1, "name": "small", "polygons": [{"family": "zeta"}],
      "metrics": ["Area", "MinAngle"],
      "sweep": [{"parameter": "t", "from": 0, "to": 0.8, "count": 6}]})",
    folder.string());
  runner->SetOutputDirectory((folder / "out").string());
  EXPECT_TRUE(runner->Run()) << testing::PrintToString(runner->GetMessages());
  return folder / "out";
}

} // namespace pages

#endif
