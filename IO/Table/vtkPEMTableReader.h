// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMTableReader
 * @brief   Reads a table from a CSV file with a heading, such as a results.csv.
 *
 * Output port 0: vtkTable. Columns of whole numbers are vtkIdTypeArray, of numbers vtkDoubleArray,
 *   an empty field NaN; others vtkStringArray, and so are digits with a leading zero and columns
 *   that are empty from top to bottom.
 * Errors: a file that cannot be read, a record of another length than the heading, a quote that is
 *   not closed, a repeated name; in a sentence that names the file and the line.
 *
 * @sa vtkPEMTableWriter
 */
#ifndef vtkPEMTableReader_h
#define vtkPEMTableReader_h

#include "pemeshIOTableModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <string> // For the file name

class PEMESHIOTABLE_EXPORT vtkPEMTableReader : public vtkTableAlgorithm
{
public:
  static vtkPEMTableReader* New();
  vtkTypeMacro(vtkPEMTableReader, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file to read. Default empty, which is an error. */
  void SetFileName(const std::string& fileName);
  std::string GetFileName() const;
  ///@}

protected:
  vtkPEMTableReader();
  ~vtkPEMTableReader() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkPEMTableReader(const vtkPEMTableReader&) = delete;
  void operator=(const vtkPEMTableReader&) = delete;

  std::string FileName;
};

#endif
