// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The metrics of a study, and those of a command that measures files: one meaning for both.
 */
#ifndef pemesh_MetricSettings_h
#define pemesh_MetricSettings_h

#include "pemeshRunnerModule.h" // For export macro

class vtkPEMMetrics;
class vtkPEMMetricSummary;

namespace pemesh
{

struct StudyMetrics;

/** Sets both filters to what is asked for. A setting that is wrong is an error of the filter. */
PEMESHRUNNER_EXPORT void ConfigureMetrics(
  const StudyMetrics& settings, vtkPEMMetrics* metrics, vtkPEMMetricSummary* summary);

} // namespace pemesh

#endif
