// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Elements chosen by the value of a metric or of another cell array, and how one writes that.
 */
#ifndef pemesh_ElementSelection_h
#define pemesh_ElementSelection_h

#include "pemeshFiltersMetricsModule.h" // For export macro

#include <limits>
#include <string>

namespace pemesh
{

struct ElementSelection
{
  std::string Array;     ///< a metric or another cell array; empty for no selection
  bool HasRange = false; ///< else elements where the array is not zero
  double Minimum = -std::numeric_limits<double>::infinity();
  double Maximum = std::numeric_limits<double>::infinity();

  /** Never true for NaN. */
  bool Contains(double value) const
  {
    return this->HasRange ? value >= this->Minimum && value <= this->Maximum
                          : value < 0.0 || value > 0.0;
  }
};

/** What ElementSelections are written like, for help and messages. */
inline constexpr const char* ElementSelectionForm = "METRIC:FROM:TO";

/**
 * Reads "MinAngle:0.1:0.5", both ends included and either left out where there is no bound, or the
 * name of a cell array alone. Returns an empty selection and puts a sentence into `fault` if the
 * text is neither.
 */
PEMESHFILTERSMETRICS_EXPORT ElementSelection ParseElementSelection(
  const std::string& text, std::string& fault);

/** One sentence for an array that a mesh does not have and that is no metric either. */
PEMESHFILTERSMETRICS_EXPORT std::string DescribeMissingSelection(const std::string& array);

} // namespace pemesh

#endif
