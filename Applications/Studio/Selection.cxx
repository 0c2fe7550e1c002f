// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Selection.h"

#include <algorithm>

namespace pemesh
{

namespace
{

bool Holds(const std::vector<vtkIdType>& sorted, vtkIdType value)
{
  return std::binary_search(sorted.begin(), sorted.end(), value);
}

std::vector<vtkIdType> With(std::vector<vtkIdType> sorted, vtkIdType value)
{
  if (value >= 0 && !Holds(sorted, value))
  {
    sorted.insert(std::upper_bound(sorted.begin(), sorted.end(), value), value);
  }
  return sorted;
}

} // namespace

std::vector<vtkIdType> Selection::GetMarkedCases() const
{
  return With(this->Cases, this->Case);
}

std::vector<vtkIdType> Selection::GetMarkedElements() const
{
  return With(this->Elements, this->Element);
}

void Selection::SetCase(int index)
{
  if (!Holds(this->Cases, index) && !this->Cases.empty())
  {
    this->Cases.clear();
    emit this->CasesMarked();
  }
  if (this->Case != index)
  {
    this->Case = index;
    this->SetElement(-1);
    emit this->CaseChanged(index);
    emit this->CasesMarked();
  }
}

void Selection::SetElement(qint64 element)
{
  if (!Holds(this->Elements, element) && !this->Elements.empty())
  {
    this->Elements.clear();
    emit this->ElementsMarked();
  }
  if (this->Element != element)
  {
    this->Element = element;
    emit this->ElementChanged(element);
    emit this->ElementsMarked();
  }
}

void Selection::MarkCases(const std::vector<vtkIdType>& cases)
{
  this->Cases = cases;
  if (!cases.empty() && !Holds(cases, this->Case))
  {
    this->SetCase(static_cast<int>(cases.front())); // says that other cases are marked
    return;
  }
  emit this->CasesMarked();
}

void Selection::MarkElements(const std::vector<vtkIdType>& elements)
{
  this->Elements = elements;
  if (!elements.empty() && !Holds(elements, this->Element))
  {
    this->SetElement(elements.front());
    return;
  }
  emit this->ElementsMarked();
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
