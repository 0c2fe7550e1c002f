// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExtremeElements.h"

#include <vtkDataArray.h>

#include <cmath>

namespace pemesh
{

ExtremeElements FindExtremeElements(vtkDataArray* values)
{
  ExtremeElements extremes;
  double smallest = 0.0;
  double largest = 0.0;
  for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    if (!std::isfinite(value))
    {
      continue;
    }
    if (extremes.Smallest < 0 || value < smallest)
    {
      extremes.Smallest = i;
      smallest = value;
    }
    if (extremes.Largest < 0 || value > largest)
    {
      extremes.Largest = i;
      largest = value;
    }
  }
  return extremes;
}

} // namespace pemesh
