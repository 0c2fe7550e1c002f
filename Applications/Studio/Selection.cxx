// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Selection.h"

namespace pemesh
{

void Selection::SetCase(int index)
{
  if (this->Case != index)
  {
    this->Case = index;
    this->SetElement(-1);
    emit this->CaseChanged(index);
  }
}

void Selection::SetElement(qint64 element)
{
  if (this->Element != element)
  {
    this->Element = element;
    emit this->ElementChanged(element);
  }
}

void Selection::SetMetric(const QString& metric)
{
  if (this->Metric != metric)
  {
    this->Metric = metric;
    emit this->MetricChanged(metric);
  }
}

} // namespace pemesh
