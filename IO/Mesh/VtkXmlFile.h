// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What VTK's XML formats of meshes have in common: errors of readers and writers as exceptions,
 * checks of what a reader has taken as it was, and files with the same bytes for the same mesh.
 */
#ifndef pemesh_VtkXmlFile_h
#define pemesh_VtkXmlFile_h

#include <filesystem>

#include <vtkDataArray.h>     // For the keys of ranges
#include <vtkInformation.h>   // For their removal
#include <vtkObjectFactory.h> // For New
#include <vtkSmartPointer.h>  // For return type

class vtkCellArray;
class vtkDataObject;
class vtkPointSet;
class vtkPolyData;
class vtkXMLDataReader;
class vtkXMLWriter;

namespace pemesh
{

/**
 * A writer of VTK that leaves out the ranges that it computes of its own accord: they are infinite
 * where the squares of values are, and then VTK's readers refuse the whole file.
 */
template <typename Writer>
class WriterWithoutRanges : public Writer
{
public:
  static WriterWithoutRanges* New() { VTK_STANDARD_NEW_BODY(WriterWithoutRanges); }

protected:
  /**
   * On a full disk VTK frees these arrays whether or not it has made them, which it has only for
   * appended data, and crashes.
   */
  void DeletePositionArrays() override
  {
    if (this->GetDataMode() == Writer::Appended)
    {
      this->Writer::DeletePositionArrays();
    }
  }

  /** Between the header of an array, which computes its range, and its information. */
  void WriteInlineData(vtkAbstractArray* array, vtkIndent indent) override
  {
    this->Writer::WriteInlineData(array, indent);
    if (array->HasInformation())
    {
      array->GetInformation()->Remove(vtkDataArray::L2_NORM_RANGE());
      array->GetInformation()->Remove(vtkDataArray::L2_NORM_FINITE_RANGE());
    }
  }
};

/** Reads the file, or throws; `kind` is the name of the format in messages, "VTP". */
void ReadVtkXml(const std::filesystem::path& path, vtkXMLDataReader* reader, const char* kind);

/**
 * Writes binary data in place, not compressed. Appended data would be read and written faster, but
 * ParaView 5.11 cannot read them any more since libexpat defers parsing (its 2.6.0, and Debian 12's
 * 2.5.0-1+deb12u2; CVE-2023-52425).
 */
void WriteVtkXml(const std::filesystem::path& path, vtkXMLWriter* writer, vtkDataObject* data);

/** Throws unless the offsets rise and end within the connectivity. */
void CheckOffsets(const std::filesystem::path& path, vtkCellArray* cells, const char* kind);

/** Points in double precision, finite and planar; z is set to zero where it was -0. */
void MakePointsPlanar(const std::filesystem::path& path, vtkPointSet* mesh);

/** A shallow copy that holds nothing but the mesh and its arrays: no time, no ranges. */
vtkSmartPointer<vtkPolyData> BareCopy(vtkPolyData* mesh);

/** Throws where the mesh has vertices, lines or strips. */
void CheckOnlyPolygons(const std::filesystem::path& path, vtkPolyData* mesh);

} // namespace pemesh

#endif
