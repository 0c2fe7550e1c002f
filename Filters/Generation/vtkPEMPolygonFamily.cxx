// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMPolygonFamily.h"

#include "PolygonFamilies.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkPEMPolygonFamily);

vtkPEMPolygonFamily::vtkPEMPolygonFamily()
{
  constexpr double middle = 0.5;
  this->AddPolygon(pemesh::PolygonFamilies().front().Name, middle, middle);
}

void vtkPEMPolygonFamily::SetFamily(const std::string& name)
{
  if (pemesh::FindPolygonFamily(name) == pemesh::FindPolygonFamily(this->GetFamily()))
  {
    return;
  }
  const int added = this->AddPolygon(name, this->GetCenterX(), this->GetCenterY());
  if (added > 0)
  {
    this->SetPolygonScale(added, this->GetScale());
    this->SetPolygonRotation(added, this->GetRotation());
    this->SetPolygonRange(added, this->GetFrom(), this->GetTo());
    this->RemovePolygon(0);
  }
}
