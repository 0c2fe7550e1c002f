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

vtkSmartPointer<vtkPolyData> ReadVtu(const std::filesystem::path& path);
void WriteVtu(const std::filesystem::path& path, vtkPolyData* mesh);

vtkSmartPointer<vtkPolyData> ReadVtkLegacy(const std::filesystem::path& path);
void WriteVtkLegacy(const std::filesystem::path& path, vtkPolyData* mesh);

vtkSmartPointer<vtkPolyData> ReadPly(const std::filesystem::path& path);
void WritePly(const std::filesystem::path& path, vtkPolyData* mesh);

vtkSmartPointer<vtkPolyData> ReadGmsh(const std::filesystem::path& path);
void WriteGmsh(const std::filesystem::path& path, vtkPolyData* mesh);

vtkSmartPointer<vtkPolyData> ReadMat(const std::filesystem::path& path);
void WriteMat(const std::filesystem::path& path, vtkPolyData* mesh);
void WriteMatNodeElem(const std::filesystem::path& path, vtkPolyData* mesh);

} // namespace pemesh

#endif
