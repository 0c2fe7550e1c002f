// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMPanel.h"

#include <algorithm>
#include <cmath>

void vtkPEMPanel::SetTitle(const std::string& title)
{
  if (this->Title != title)
  {
    this->Title = title;
    this->Modified();
  }
}

std::string vtkPEMPanel::GetTitle() const
{
  return this->Title;
}

void vtkPEMPanel::SetRectangle(double x, double y, double width, double height)
{
  const double rectangle[4] = { x, y, width, height };
  if (!std::equal(rectangle, rectangle + 4, this->Rectangle))
  {
    std::copy_n(rectangle, 4, this->Rectangle);
    this->Modified();
  }
}

void vtkPEMPanel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Title: " << this->Title << "\n";
  os << indent << "Rectangle: " << this->Rectangle[0] << " " << this->Rectangle[1] << " "
     << this->Rectangle[2] << " " << this->Rectangle[3] << "\n";
  os << indent << "FontSize: " << this->FontSize << "\n";
}
