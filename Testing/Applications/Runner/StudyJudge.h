// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What must hold of the mesh of a case, whatever its study asks for.
 */
#ifndef pemesh_StudyJudge_h
#define pemesh_StudyJudge_h

#include "Study.h"

#include <string>

class vtkPolyData;

/**
 * Empty, or what is wrong with the mesh of a case at the deformation `t`: exactly, its elements,
 * that they cover the domain once, the placed polygons with their areas, the target, and what
 * vtkPEMMeshCheck finds.
 *
 * Of tiled and mirrored domains that are not rectangles only the area is compared. Vertices on
 * slanted lines are rounded, which moves them by half a unit in the last place a coordinate, once
 * in the mesh and once in every repetition: the area may be off by that times the length of the
 * border.
 */
std::string WhyBad(vtkPolyData* mesh, const pemesh::Study& studyOfCase, double t);

/** Empty, or why this is not how a case may be refused: a known status, a sentence that names the
 * culprit. */
std::string WhyBadRefusal(const std::string& status, const std::string& sentence);

#endif
