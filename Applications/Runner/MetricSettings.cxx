// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MetricSettings.h"

#include "Study.h"
#include "vtkPEMMetricSummary.h"
#include "vtkPEMMetrics.h"

namespace pemesh
{

void ConfigureMetrics(
  const StudyMetrics& settings, vtkPEMMetrics* metrics, vtkPEMMetricSummary* summary)
{
  metrics->SetMetrics(settings.Names);
  summary->SetMetrics(settings.Names);
  summary->SetMeshMetrics(settings.Mesh);
  summary->SetStatistics(settings.Statistics);
  summary->SetGroups(settings.Groups);
  summary->SetQuantiles(settings.Quantiles);
  summary->SetHistogramBins(settings.HistogramBins);
  summary->SetSelection(settings.Selection);
}

} // namespace pemesh
