// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A mesh with all its arrays as text that holds every bit, for another process.
 */
#ifndef pemesh_MeshText_h
#define pemesh_MeshText_h

#include <string>

#include <vtkSmartPointer.h> // For return types

class vtkPolyData;

namespace pemesh
{

std::string TextOfMesh(vtkPolyData* mesh);

/** Throws std::runtime_error where the text is no mesh. */
vtkSmartPointer<vtkPolyData> MeshOfText(const std::string& text);

} // namespace pemesh

#endif
