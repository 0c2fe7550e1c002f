// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CaseStatus.h"

#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <limits>

namespace pemesh
{

namespace
{

constexpr const char* StatusField = "Status";
constexpr const char* StatusMessageField = "StatusMessage";

vtkStringArray* FindText(vtkDataObject* data, const std::string& name)
{
  return data && data->GetFieldData()
    ? vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name.c_str()))
    : nullptr;
}

} // namespace

void SetFieldNumber(vtkDataObject* data, const std::string& name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->InsertNextValue(value);
  data->GetFieldData()->AddArray(array);
}

void SetFieldText(vtkDataObject* data, const std::string& name, const std::string& value)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name.c_str());
  array->InsertNextValue(value);
  data->GetFieldData()->AddArray(array);
}

std::string GetFieldText(vtkDataObject* data, const std::string& name)
{
  vtkStringArray* array = FindText(data, name);
  return array && array->GetNumberOfValues() > 0 ? array->GetValue(0) : std::string();
}

double GetFieldNumber(vtkDataObject* data, const std::string& name)
{
  vtkDataArray* array =
    data && data->GetFieldData() ? data->GetFieldData()->GetArray(name.c_str()) : nullptr;
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0)
                                                 : std::numeric_limits<double>::quiet_NaN();
}

void SetCaseFailed(vtkDataObject* data, const std::string& status, const std::string& message)
{
  SetFieldText(data, StatusField, status);
  SetFieldText(data, StatusMessageField, message);
}

std::string GetCaseStatus(vtkDataObject* data)
{
  const std::string status = GetFieldText(data, StatusField);
  return status.empty() ? "ok" : status;
}

std::string GetCaseStatusMessage(vtkDataObject* data)
{
  return GetFieldText(data, StatusMessageField);
}

bool IsCaseFailed(vtkDataObject* data)
{
  return GetCaseStatus(data) != "ok";
}

bool IsInFieldList(vtkDataObject* data, const std::string& list, const std::string& name)
{
  vtkStringArray* array = FindText(data, list);
  return array && array->LookupValue(name) >= 0;
}

void AddToFieldList(vtkDataObject* data, const std::string& list, const std::string& name)
{
  if (IsInFieldList(data, list, name))
  {
    return;
  }
  // A copy, because the array may be shared with the data of another filter.
  vtkNew<vtkStringArray> names;
  if (vtkStringArray* old = FindText(data, list))
  {
    names->DeepCopy(old);
  }
  names->SetName(list.c_str());
  names->InsertNextValue(name);
  data->GetFieldData()->AddArray(names);
}

} // namespace pemesh
