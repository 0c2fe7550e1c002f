// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What the sweeps of a study make of it: one study a case.
 */
#ifndef pemesh_StudySweeps_h
#define pemesh_StudySweeps_h

#include "Study.h"
#include "pemeshIOStudyModule.h" // For export macro

#include <string>
#include <vector>

namespace pemesh
{

/** The sweep over the deformation; all others are named by the path of a value. */
inline constexpr const char* DeformationParameter = "t";

/** The values that a parameter takes, in order. */
PEMESHIOSTUDY_EXPORT std::vector<StudyScalar> SweepValues(const StudySweep& sweep);

/** The value of one swept parameter in one case. */
struct SweptValue
{
  std::string Parameter; ///< t or a path
  std::string Name;      ///< of its column
  StudyScalar Value;
  bool operator==(const SweptValue&) const = default;
};

/**
 * The values of all cases, in order: the last sweep runs fastest, sweeps that are zipped advance
 * together. One case without values if nothing is swept.
 */
PEMESHIOSTUDY_EXPORT std::vector<std::vector<SweptValue>> SweepCases(const Study& study);

/** The deformation among the values of a case, 0 if it is not swept. */
PEMESHIOSTUDY_EXPORT double DeformationOf(const std::vector<SweptValue>& values);

/**
 * The study of one case: with the values set, and without sweeps and plots. Throws
 * std::runtime_error with one sentence that names the sweep, if a path names nothing or a value is
 * not allowed there.
 */
PEMESHIOSTUDY_EXPORT Study MakeStudyOfCase(
  const Study& study, const std::vector<SweptValue>& values);

} // namespace pemesh

#endif
