// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMConvergence.h"

#include "Convergence.h"
#include "NumberText.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <cmath>
#include <stdexcept>

vtkStandardNewMacro(vtkPEMConvergence);

namespace
{

std::vector<std::string> NumericColumns(vtkTable* table)
{
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    if (vtkDataArray::SafeDownCast(table->GetColumn(i)) && table->GetColumnName(i))
    {
      names.emplace_back(table->GetColumnName(i));
    }
  }
  return names;
}

std::vector<double> ColumnValues(vtkTable* table, const std::string& name)
{
  auto* column = vtkDataArray::SafeDownCast(table->GetColumnByName(name.c_str()));
  if (!column)
  {
    throw std::runtime_error("The table has no column \"" + name +
      "\" of numbers; the nearest is \"" + pemesh::NearestWord(name, NumericColumns(table)) +
      "\".");
  }
  std::vector<double> values(static_cast<std::size_t>(column->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = column->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return values;
}

void AddColumn(vtkTable* table, const std::string& name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> column;
  column->SetName(name.c_str());
  for (const double value : values)
  {
    column->InsertNextValue(value);
  }
  table->AddColumn(column);
}

void FillTables(const pemesh::ConvergenceTable& table, vtkTable* rows, vtkTable* fits)
{
  AddColumn(rows, table.SizeName, table.Sizes);
  vtkNew<vtkStringArray> names;
  names->SetName("Error");
  std::vector<double> orders;
  std::vector<double> deviations;
  for (const pemesh::ConvergenceColumn& column : table.Columns)
  {
    AddColumn(rows, column.Name, column.Errors);
    AddColumn(rows, column.Name + "_order", column.Orders);
    names->InsertNextValue(column.Name);
    orders.push_back(column.Order);
    deviations.push_back(column.StandardError);
  }
  fits->AddColumn(names);
  AddColumn(fits, "Order", orders);
  AddColumn(fits, "StandardError", deviations);
}

} // namespace

vtkPEMConvergence::vtkPEMConvergence()
{
  this->SetNumberOfOutputPorts(2);
}

void vtkPEMConvergence::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SizeColumn: " << this->SizeColumn << "\n";
  os << indent << "SizeIsCount: " << this->SizeIsCount << "\n";
  os << indent << "ErrorColumns:";
  for (const std::string& name : this->ErrorColumns)
  {
    os << ' ' << name;
  }
  os << "\n";
}

void vtkPEMConvergence::SetSizeColumn(const std::string& name)
{
  if (this->SizeColumn != name)
  {
    this->SizeColumn = name;
    this->Modified();
  }
}

std::string vtkPEMConvergence::GetSizeColumn() const
{
  return this->SizeColumn;
}

void vtkPEMConvergence::SetErrorColumns(const std::vector<std::string>& names)
{
  if (this->ErrorColumns != names)
  {
    this->ErrorColumns = names;
    this->Modified();
  }
}

std::vector<std::string> vtkPEMConvergence::GetErrorColumns() const
{
  return this->ErrorColumns;
}

std::string vtkPEMConvergence::FormatOutput(const std::string& format)
{
  const auto formats = pemesh::ConvergenceFormats();
  for (std::size_t i = 0; i < formats.size(); ++i)
  {
    if (format == formats[i].Name)
    {
      return i < this->Texts.size() ? this->Texts[i] : "";
    }
  }
  vtkErrorMacro("There is no format \"" << format << "\".");
  return {};
}

std::vector<std::string> vtkPEMConvergence::GetAvailableFormats()
{
  std::vector<std::string> names;
  for (const pemesh::ConvergenceFormat& format : pemesh::ConvergenceFormats())
  {
    names.emplace_back(format.Name);
  }
  return names;
}

int vtkPEMConvergence::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

int vtkPEMConvergence::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkTable* input = vtkTable::GetData(inputs[0]);
  pemesh::ConvergenceTable table;
  try
  {
    std::vector<double> sizes = ColumnValues(input, this->SizeColumn);
    for (double& size : sizes)
    {
      size = this->SizeIsCount ? 1.0 / std::sqrt(size) : size;
    }
    std::vector<pemesh::ErrorColumn> errors;
    for (const std::string& name :
      this->ErrorColumns.empty() ? NumericColumns(input) : this->ErrorColumns)
    {
      if (!this->ErrorColumns.empty() || name.find("error") != std::string::npos)
      {
        errors.push_back({ name, ColumnValues(input, name) });
      }
    }
    table = pemesh::MakeConvergenceTable(
      this->SizeIsCount ? this->SizeColumn + "^(-1/2)" : this->SizeColumn, sizes, errors);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  FillTables(table, vtkTable::GetData(outputs, 0), vtkTable::GetData(outputs, 1));
  this->Texts.clear();
  for (const pemesh::ConvergenceFormat& format : pemesh::ConvergenceFormats())
  {
    this->Texts.push_back(format.Format(table));
  }
  return 1;
}
