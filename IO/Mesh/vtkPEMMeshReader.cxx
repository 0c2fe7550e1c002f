// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMMeshReader.h"

#include "CaseStatus.h"
#include "MeshFormats.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

vtkStandardNewMacro(vtkPEMMeshReader);

vtkPEMMeshReader::vtkPEMMeshReader()
{
  this->SetNumberOfInputPorts(0);
}

void vtkPEMMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileNames: " << this->FileNames.size() << "\n";
  for (const std::string& fileName : this->FileNames)
  {
    os << indent.GetNextIndent() << fileName << "\n";
  }
}

void vtkPEMMeshReader::AddFileName(const std::string& fileName)
{
  this->FileNames.push_back(fileName);
  this->UpdateMeshNames();
}

void vtkPEMMeshReader::SetFileNames(const std::vector<std::string>& fileNames)
{
  if (this->FileNames != fileNames)
  {
    this->FileNames = fileNames;
    this->UpdateMeshNames();
  }
}

void vtkPEMMeshReader::SetFileName(const std::string& fileName)
{
  this->SetFileNames({ fileName });
}

void vtkPEMMeshReader::RemoveAllFileNames()
{
  this->SetFileNames({});
}

int vtkPEMMeshReader::GetNumberOfFileNames() const
{
  return static_cast<int>(this->FileNames.size());
}

std::string vtkPEMMeshReader::GetFileName(int index) const
{
  return index >= 0 && index < this->GetNumberOfFileNames()
    ? this->FileNames[static_cast<std::size_t>(index)]
    : std::string();
}

std::string vtkPEMMeshReader::GetMeshName(int index) const
{
  return index >= 0 && index < this->GetNumberOfFileNames()
    ? this->MeshNames[static_cast<std::size_t>(index)]
    : std::string();
}

void vtkPEMMeshReader::UpdateMeshNames()
{
  this->MeshNames.clear();
  std::set<std::string> taken;
  for (const std::string& fileName : this->FileNames)
  {
    const std::string stem = std::filesystem::path(fileName).stem().string();
    std::string name = stem;
    for (int copy = 2; !taken.insert(name).second; ++copy)
    {
      name = stem + "-" + std::to_string(copy);
    }
    this->MeshNames.push_back(name);
  }
  this->Modified();
}

int vtkPEMMeshReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* output = outputs->GetInformationObject(0);
  output->Remove(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  output->Remove(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  if (this->FileNames.empty())
  {
    vtkErrorMacro("No mesh file is given: add at least one file name.");
    return 0;
  }
  std::vector<double> times;
  for (int i = 0; i < this->GetNumberOfFileNames(); ++i)
  {
    times.push_back(i);
  }
  const double range[2] = { times.front(), times.back() };
  output->Set(
    vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
  output->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  return 1;
}

int vtkPEMMeshReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* information = outputs->GetInformationObject(0);
  vtkPolyData* output = vtkPolyData::GetData(information);
  double time = 0.0;
  if (information->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()))
  {
    time = information->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
  }
  const double last = this->GetNumberOfFileNames() - 1;
  // A time that is no number compares false and takes the first file.
  const int index = time > 0.0 ? static_cast<int>(std::min(last, std::round(time))) : 0;
  const std::string fileName = this->GetFileName(index);
  try
  {
    output->ShallowCopy(pemesh::ReadMesh(fileName));
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkNew<vtkPoints> none;
    none->SetDataTypeToDouble();
    output->SetPoints(none);
    pemesh::SetCaseFailed(output, "unreadable-mesh", error.what());
  }
  pemesh::SetFieldText(output, pemesh::MeshNameField, this->GetMeshName(index));
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), index);
  return 1;
}
