// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMPooledTable
 * @brief   The results of several studies in one table.
 *
 * Input port 0 : any number of vtkTable, one row a mesh each.
 * Output port 0: vtkTable, the rows of all inputs in their order under the union of their columns,
 *   undefined where an input lacks one, and first the column `Study` with the name of the study of
 *   each row; vtkPEMCorrelation takes its values as families. A single input is passed on as it is,
 *   and an input that has the column already keeps it. Two studies of one name become "name" and
 *   "name-2". Lists and texts of the field data (performances, measured columns) are joined.
 *
 * @sa vtkPEMJoinedTable vtkPEMCorrelation PooledTable.h
 */
#ifndef vtkPEMPooledTable_h
#define vtkPEMPooledTable_h

#include "pemeshFiltersStatisticsModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <string> // For names
#include <vector> // For names

class PEMESHFILTERSSTATISTICS_EXPORT vtkPEMPooledTable : public vtkTableAlgorithm
{
public:
  static vtkPEMPooledTable* New();
  vtkTypeMacro(vtkPEMPooledTable, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Names of the studies, one an input. Default none: "study-1", "study-2", … */
  void SetStudyNames(const std::vector<std::string>& names);
  std::vector<std::string> GetStudyNames() const;
  void AddStudyName(const std::string& name);
  void RemoveAllStudyNames();
  ///@}

protected:
  vtkPEMPooledTable() = default;
  ~vtkPEMPooledTable() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkPEMPooledTable(const vtkPEMPooledTable&) = delete;
  void operator=(const vtkPEMPooledTable&) = delete;

  std::vector<std::string> StudyNames;
};

#endif
