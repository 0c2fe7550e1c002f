// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TableColumns.h"

#include "NumberText.h"

#include <stdexcept>

#include <vtkDataArray.h>
#include <vtkTable.h>

namespace pemesh
{

void CheckNumericColumns(vtkTable* table, const std::vector<std::string>& names)
{
  for (const std::string& name : names)
  {
    if (vtkDataArray::SafeDownCast(table->GetColumnByName(name.c_str())))
    {
      continue;
    }
    std::vector<std::string> known;
    for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
    {
      if (vtkDataArray::SafeDownCast(table->GetColumn(i)))
      {
        known.emplace_back(table->GetColumnName(i));
      }
    }
    throw std::runtime_error("The table has no column \"" + name +
      "\" of numbers; the nearest is \"" + NearestWord(name, known) + "\".");
  }
}

} // namespace pemesh
