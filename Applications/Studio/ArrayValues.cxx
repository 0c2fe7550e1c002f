// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ArrayValues.h"

#include <algorithm>
#include <cmath>

#include <vtkDataArray.h>

namespace pemesh
{

double ValueOf(vtkDataArray* values, vtkIdType tuple)
{
  return values->GetComponent(tuple, 0);
}

bool ExtendRange(vtkDataArray* values, double range[2])
{
  for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
  {
    const double value = ValueOf(values, i);
    if (std::isfinite(value))
    {
      range[0] = std::min(range[0], value);
      range[1] = std::max(range[1], value);
    }
  }
  return range[0] <= range[1];
}

} // namespace pemesh
