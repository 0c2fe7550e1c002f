// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The sections of the page: one entry in one table each. To add one: a function here, an entry in
 * vtkPEMReport.cxx.
 */
#ifndef pemesh_ReportSections_h
#define pemesh_ReportSections_h

#include "HtmlText.h"

namespace pemesh
{

class FigureFolder;
struct ReportContents;

struct ReportSection
{
  const char* Name; // of its anchor
  const char* Title;
  /** Empty where the results have nothing to show: the section is left out. */
  Html (*Make)(const ReportContents& contents, const FigureFolder& folder);
};

///@{
/** In FigureSections.cxx. */
Html MakeMeshes(const ReportContents& contents, const FigureFolder& folder);
Html MakeMetrics(const ReportContents& contents, const FigureFolder& folder);
Html MakePerformances(const ReportContents& contents, const FigureFolder& folder);
Html MakeFindings(const ReportContents& contents, const FigureFolder& folder);
Html MakeConvergence(const ReportContents& contents, const FigureFolder& folder);
///@}

///@{
/** In TextSections.cxx. */
Html MakeStudy(const ReportContents& contents, const FigureFolder& folder);
Html MakeFailures(const ReportContents& contents, const FigureFolder& folder);
Html MakeTable(const ReportContents& contents, const FigureFolder& folder);
Html MakeMethods(const ReportContents& contents, const FigureFolder& folder);
///@}

} // namespace pemesh

#endif
