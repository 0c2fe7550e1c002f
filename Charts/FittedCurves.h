// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Fitted curves as marks of a chart. Private to this module.
 */
#ifndef pemesh_FittedCurves_h
#define pemesh_FittedCurves_h

#include "ChartPlot.h"

namespace pemesh
{

struct ChartOptions;
struct CurveFit;

/**
 * Adds to every series of rows its fitted curve, with the band of its mean, and says in the notes
 * where there is none.
 */
void AddFits(const ChartOptions& options, ChartPlot& plot, std::vector<std::string>& notes);

/** "y = 2.1 x^−1.9" with readable numbers. */
std::string DescribeFit(const CurveFit& fit);

} // namespace pemesh

#endif
