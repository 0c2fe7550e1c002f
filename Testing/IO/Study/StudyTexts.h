// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Documents for tests.
 */
#ifndef pemesh_StudyTexts_h
#define pemesh_StudyTexts_h

#include "StudySweeps.h"

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

/** The values of t of all cases. */
inline std::vector<double> TimesOf(const pemesh::Study& study)
{
  std::vector<double> times;
  for (const std::vector<pemesh::SweptValue>& values : pemesh::SweepCases(study))
  {
    for (const pemesh::SweptValue& value : values)
    {
      if (value.Parameter == "t")
      {
        times.push_back(pemesh::ScalarToNumber(value.Value));
      }
    }
  }
  return times;
}

/** Every key that a study which makes its meshes can have. */
inline const char* FullStudy = R"({
  "pemesh": 1, "written-by": "PEMesh 0.1.0", "name": "comb and star",
  "polygons": [
    {"family": "comb", "name": "left", "center": [0.3, 0.25], "scale": 0.8, "rotation": 15.5,
     "teeth": 7, "from": 0.1, "to": 0.95},
    {"family": "star", "center": [0.7, 0.7], "spikes": 9},
    {"family": "zeta", "center": [0.3, 0.7]}],
  "scatter": {"count": 3, "seed": 5, "families": ["maze"], "order": "cycle",
              "smallest-scale": 0.05, "largest-scale": 0.1, "largest-rotation": 90, "gap": 0.02,
              "from": 0.1, "to": 0.9},
  "sweep": [{"parameter": "t", "from": 0.25, "to": 0.75, "count": 3}],
  "mesh": {"max-area": {"rule": "constant", "value": 0.01}, "min-angle": 25.5,
           "preserve-polygons": true},
  "metrics": ["MinAngle", "Area"],
  "solvers": [
    {"solver": "pemesh-vem", "name": "plain", "order": 1, "problem": "franke", "time-limit": 60,
     "version": "0.1.0"},
    {"solver": "other.json", "tolerance": 1e-10, "exact": true, "share": 2.0}],
  "plots": [
    {"kind": "line", "x": "t", "y": ["MinAngle", "Area_mean"], "log": "xy", "title": "Lines"},
    {"kind": "scatter", "x": "Area_min", "y": "plain_dofs", "color-by": "t", "file": "s.svg"},
    {"kind": "mesh", "color-by": "MinAngle", "highlight": "both", "case": 0},
    {"kind": "overview", "x": "Area_min", "y": "plain_dofs", "case": -2}],
  "output": {"formats": ["vtp", "off"]}
})";

/** The message of the std::runtime_error that a call throws; "nothing thrown" if it does not. */
inline std::string Complaint(const std::function<void()>& call)
{
  try
  {
    call();
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "nothing thrown";
}

#endif
