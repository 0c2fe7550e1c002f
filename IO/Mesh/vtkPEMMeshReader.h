// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMMeshReader
 * @brief   Reads one mesh file or a series of them, one at a time.
 *
 * Output port 0: vtkPolyData, polygons, points in double precision, counter-clockwise (elements
 *   that are clockwise in the file are reversed), vertices in the order of the file. Field text
 *   "Mesh" is the file's stem, made unique where several files share it (Maze0, Maze0-2).
 * Formats: by extension, see MeshFormats.h and the table of README.md.
 * Time: the index of the file: TIME_STEPS are 0, 1, …, n-1; another time takes the nearest file;
 *   without a time asked for, the first file.
 * Failure of a case: a file that cannot be read gives an empty mesh with `Status`
 *   "unreadable-mesh" and a message that names the file and the line.
 * Wrong configuration: no file name.
 *
 * @sa vtkPEMMeshWriter
 */
#ifndef vtkPEMMeshReader_h
#define vtkPEMMeshReader_h

#include "pemeshIOMeshModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For file names
#include <vector> // For file names

class PEMESHIOMESH_EXPORT vtkPEMMeshReader : public vtkPolyDataAlgorithm
{
public:
  static vtkPEMMeshReader* New();
  vtkTypeMacro(vtkPEMMeshReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The files, in the order of time. Default none. */
  void AddFileName(const std::string& fileName);
  void SetFileNames(const std::vector<std::string>& fileNames);
  void RemoveAllFileNames();
  int GetNumberOfFileNames() const;
  /** Empty where there is no such file. */
  std::string GetFileName(int index) const;
  ///@}

  /** Makes this the only file. */
  void SetFileName(const std::string& fileName);

  /** The unique name that the mesh of a file gets, or empty where there is no such file. */
  std::string GetMeshName(int index) const;

protected:
  vtkPEMMeshReader();
  ~vtkPEMMeshReader() override = default;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPEMMeshReader(const vtkPEMMeshReader&) = delete;
  void operator=(const vtkPEMMeshReader&) = delete;

  void UpdateMeshNames();

  std::vector<std::string> FileNames;
  std::vector<std::string> MeshNames;
};

#endif
