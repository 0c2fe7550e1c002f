// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The functions behind the table of formats: one pair a format, private to this module.
 */
#ifndef pemesh_FormatFunctions_h
#define pemesh_FormatFunctions_h

#include <filesystem>

#include <vtkSmartPointer.h> // For return type

class vtkPolyData;

namespace pemesh
{

vtkSmartPointer<vtkPolyData> ReadOff(const std::filesystem::path& path);
void WriteOff(const std::filesystem::path& path, vtkPolyData* mesh);

vtkSmartPointer<vtkPolyData> ReadObj(const std::filesystem::path& path);
void WriteObj(const std::filesystem::path& path, vtkPolyData* mesh);

vtkSmartPointer<vtkPolyData> ReadNode(const std::filesystem::path& path);
void WriteNode(const std::filesystem::path& path, vtkPolyData* mesh);
void WriteNodePlain(const std::filesystem::path& path, vtkPolyData* mesh);

vtkSmartPointer<vtkPolyData> ReadStl(const std::filesystem::path& path);
void WriteStl(const std::filesystem::path& path, vtkPolyData* mesh);

vtkSmartPointer<vtkPolyData> ReadVtp(const std::filesystem::path& path);
void WriteVtp(const std::filesystem::path& path, vtkPolyData* mesh);

} // namespace pemesh

#endif
