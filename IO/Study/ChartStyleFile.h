// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Styles of charts as JSON files: an object of the settings that differ from the default, such as
 * {"palette": "muted", "font-size": 9}. Unknown keys and impossible values are errors that name the
 * file, the key and the nearest one.
 */
#ifndef pemesh_ChartStyleFile_h
#define pemesh_ChartStyleFile_h

#include "pemeshIOStudyModule.h" // For export macro

#include <filesystem>
#include <vector>

namespace pemesh
{

struct ChartStyle;
struct StudyStyle;

/** Throws std::runtime_error with one sentence. */
PEMESHIOSTUDY_EXPORT ChartStyle ReadChartStyleFile(const std::filesystem::path& path);

/** Writes what differs from the default; throws std::runtime_error. */
PEMESHIOSTUDY_EXPORT void WriteChartStyleFile(
  const std::filesystem::path& path, const ChartStyle& style);

/**
 * Styles on top of each other, on that of the defaults: of each the file, if it names one
 * (relative to `folder`), then its settings. Of a plot: that of its study, then its own.
 */
PEMESHIOSTUDY_EXPORT ChartStyle MakeChartStyle(
  const std::filesystem::path& folder, const std::vector<StudyStyle>& styles);

} // namespace pemesh

#endif
