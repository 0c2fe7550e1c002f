// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMMeshWriter
 * @brief   Writes a polygonal mesh in the format that the extension of the file names.
 *
 * Input port 0: vtkPolyData of polygons. Only VTP and VTU keep its arrays and take a mesh without
 *   polygons (of a case that failed). STL and MSH write larger polygons as triangles.
 * NODE/ELE writes both files, whichever of the two is named.
 * Write() returns 1, or 0 after an error that names the file and the reason.
 *
 * @sa vtkPEMMeshReader
 */
#ifndef vtkPEMMeshWriter_h
#define vtkPEMMeshWriter_h

#include "pemeshIOMeshModule.h" // For export macro
#include "vtkWriter.h"

#include <string> // For the file name

class PEMESHIOMESH_EXPORT vtkPEMMeshWriter : public vtkWriter
{
public:
  static vtkPEMMeshWriter* New();
  vtkTypeMacro(vtkPEMMeshWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Where to write; missing folders are made. Default empty, which is an error. */
  void SetFileName(const std::string& fileName);
  std::string GetFileName() const;
  ///@}

protected:
  vtkPEMMeshWriter();
  ~vtkPEMMeshWriter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkPEMMeshWriter(const vtkPEMMeshWriter&) = delete;
  void operator=(const vtkPEMMeshWriter&) = delete;

  std::string FileName;
};

#endif
