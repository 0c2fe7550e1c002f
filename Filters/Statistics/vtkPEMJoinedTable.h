// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMJoinedTable
 * @brief   A table of meshes with a user's own performances, joined by the names of the meshes.
 *
 * Input port 0 : vtkTable, one row a mesh, with a column `Mesh`.
 * Input port 1 : vtkTable of performances with a column `Mesh` (and `Study`, where several studies
 *   have meshes of one name).
 * Output port 0: the first with the other columns of the second; NaN for meshes that the second
 *   lacks. Its numeric columns are in the list `Performances` of the field data.
 *
 * Errors: no column `Mesh`, a mesh that the first table has not, a mesh named twice, a column that
 *   is there already, nothing to join.
 * @sa vtkPEMPooledTable PooledTable.h
 */
#ifndef vtkPEMJoinedTable_h
#define vtkPEMJoinedTable_h

#include "pemeshFiltersStatisticsModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <string> // For the name

class PEMESHFILTERSSTATISTICS_EXPORT vtkPEMJoinedTable : public vtkTableAlgorithm
{
public:
  static vtkPEMJoinedTable* New();
  vtkTypeMacro(vtkPEMJoinedTable, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** What errors call the second table, as the name of its file. Default "The second table". */
  void SetSourceName(const std::string& name);
  std::string GetSourceName() const;
  ///@}

protected:
  vtkPEMJoinedTable();
  ~vtkPEMJoinedTable() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkPEMJoinedTable(const vtkPEMJoinedTable&) = delete;
  void operator=(const vtkPEMJoinedTable&) = delete;

  std::string SourceName = "The second table";
};

#endif
