// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The polygons of a study in a layout.
 */
#ifndef pemesh_StudyLayout_h
#define pemesh_StudyLayout_h

#include "pemeshRunnerModule.h" // For export macro

class vtkPEMPolygonLayout;

namespace pemesh
{

struct Study;

/**
 * Makes the polygons of the layout those of the study: the placed ones, then the scattered ones,
 * for which the input of the layout is the domain, so connect it before. A layout that has them
 * already is not modified, whatever it was configured by; files are read again. Throws
 * std::runtime_error with one sentence where a file cannot be read or scattered polygons do not
 * fit; the layout is left as it was then.
 */
PEMESHRUNNER_EXPORT void ConfigureLayout(const Study& study, vtkPEMPolygonLayout* layout);

} // namespace pemesh

#endif
