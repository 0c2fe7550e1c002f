// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Where the polygons of a study lie, before anything is meshed.
 */
#ifndef pemesh_StudyOutlines_h
#define pemesh_StudyOutlines_h

#include "Point2.h"
#include "pemeshRunnerModule.h" // For export macro

#include <string>
#include <vector>

namespace pemesh
{

struct Study;

struct StudyOutlines
{
  struct Polygon
  {
    std::vector<Point2> Points;
    int Family = 0; ///< position in PolygonFamilies()
    std::string Name;
  };

  std::vector<std::vector<Point2>> Domain; ///< the outer loop, then the holes
  std::vector<Polygon> Polygons;           ///< those of the document, then the scattered ones
  std::string Fault;                       ///< one sentence if this cannot be meshed, else empty
};

/** At the deformation t. Nothing is thrown: Fault says what is wrong. */
PEMESHRUNNER_EXPORT StudyOutlines MakeStudyOutlines(const Study& study, double t);

} // namespace pemesh

#endif
