// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The tables of which the registry is made, and the papers they share.
 */
#ifndef pemesh_MetricTables_h
#define pemesh_MetricTables_h

#include "MetricRegistry.h"

namespace pemesh
{

///@{
/** One table a file, named after it. */
std::span<const Metric> ElementMetricTable();
std::span<const Metric> IndicatorMetricTable();
std::span<const Metric> NeighbourMetricTable();
std::span<const Metric> SolverMetricTable();
///@}

/** The entry `<Name>Jump` of a metric of an element. */
Metric MakeJumpMetric(const Metric& metric);

inline constexpr const char* Attene2021 =
  "M. Attene et al., Benchmarking the geometrical robustness of a Virtual Element Poisson solver, "
  "Math. Comput. Simul. 190 (2021) 1392-1414, doi 10.1016/j.matcom.2021.07.018";
inline constexpr const char* Sorgente2022 =
  "T. Sorgente, S. Biasotti, G. Manzini, M. Spagnuolo, The role of mesh quality and mesh quality "
  "indicators in the virtual element method, Adv. Comput. Math. 48 (2022) 3, "
  "doi 10.1007/s10444-021-09913-3";

} // namespace pemesh

#endif
