// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMTableWriter
 * @brief   Writes a table to a CSV file, whole or not at all.
 *
 * Input port 0: vtkTable of columns of numbers or texts. Numbers are written so that every bit
 *   survives, undefined ones as "nan"; texts are quoted where needed.
 * Write() returns 1, or 0 after an error that names the file and the reason.
 *
 * @sa vtkPEMTableReader
 */
#ifndef vtkPEMTableWriter_h
#define vtkPEMTableWriter_h

#include "pemeshIOTableModule.h" // For export macro
#include "vtkWriter.h"

#include <string> // For the file name

class PEMESHIOTABLE_EXPORT vtkPEMTableWriter : public vtkWriter
{
public:
  static vtkPEMTableWriter* New();
  vtkTypeMacro(vtkPEMTableWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Where to write; missing folders are made. Default empty, which is an error. */
  void SetFileName(const std::string& fileName);
  std::string GetFileName() const;
  ///@}

protected:
  vtkPEMTableWriter();
  ~vtkPEMTableWriter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkPEMTableWriter(const vtkPEMTableWriter&) = delete;
  void operator=(const vtkPEMTableWriter&) = delete;

  std::string FileName;
};

#endif
