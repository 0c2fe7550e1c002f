// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMStudySource.h"

#include "SolverDescription.h"
#include "Study.h"
#include "StudyCases.h"
#include "StudyFile.h"
#include "StudyPipeline.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkPEMStudySource);

namespace
{

/** What is left of a study where nothing is solved. */
pemesh::Study WithoutSolvers(pemesh::Study study)
{
  study.Solvers.clear();
  std::vector<pemesh::StudySweep> kept;
  bool zip = false; // of the first one that is left of those that advance together
  for (pemesh::StudySweep& sweep : study.Sweep)
  {
    zip = zip && sweep.Zip;
    if (sweep.Parameter.rfind("solvers", 0) != 0)
    {
      sweep.Zip = zip;
      zip = true;
      kept.push_back(std::move(sweep));
    }
  }
  study.Sweep = std::move(kept);
  return study;
}

} // namespace

class vtkPEMStudySource::Cases
{
public:
  explicit Cases(const std::string& path)
    : Study(WithoutSolvers(pemesh::ReadStudy(path)))
    , List(pemesh::MakeStudyCases(this->Study))
    , Pipeline(this->Study, {}, {}, this->Stop)
  {
    const bool isFamily = this->Study.Sweep.size() == 1 &&
      this->Study.Sweep[0].Parameter == pemesh::DeformationParameter;
    for (const pemesh::StudyCase& studyCase : this->List)
    {
      this->Times.push_back(isFamily ? studyCase.Time : static_cast<double>(studyCase.Index));
    }
    if (!std::is_sorted(this->Times.begin(), this->Times.end()))
    {
      for (std::size_t i = 0; i < this->Times.size(); ++i)
      {
        this->Times[i] = static_cast<double>(i);
      }
    }
  }

  vtkPolyData* MakeMesh(double time)
  {
    const auto nearest = std::min_element(this->Times.begin(), this->Times.end(),
      [time](double a, double b) { return std::abs(a - time) < std::abs(b - time); });
    this->Pipeline.Execute(this->List[nearest - this->Times.begin()]);
    return this->Pipeline.GetMesh();
  }

  pemesh::Study Study;
  std::vector<pemesh::StudyCase> List;
  std::vector<double> Times;
  std::atomic<bool> Stop = false;
  pemesh::StudyPipeline Pipeline;
};

vtkPEMStudySource::vtkPEMStudySource()
{
  this->SetNumberOfInputPorts(0);
}

vtkPEMStudySource::~vtkPEMStudySource() = default;

void vtkPEMStudySource::SetFileName(const std::string& path)
{
  this->FileName = path;
  this->Contents.reset();
  this->Modified();
}

template <typename Function>
int vtkPEMStudySource::Try(const Function& function)
{
  if (this->FileName.empty())
  {
    vtkErrorMacro(<< "There is no study; set the file name.");
    return 0;
  }
  try
  {
    if (!this->Contents)
    {
      this->Contents = std::make_unique<Cases>(this->FileName);
    }
    function();
    return 1;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
}

int vtkPEMStudySource::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputs), vtkInformationVector* outputs)
{
  return this->Try(
    [this, outputs]
    {
      using Pipeline = vtkStreamingDemandDrivenPipeline;
      const std::vector<double>& times = this->Contents->Times;
      const double range[2] = { times.front(), times.back() };
      vtkInformation* information = outputs->GetInformationObject(0);
      information->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
      information->Set(Pipeline::TIME_RANGE(), range, 2);
    });
}

int vtkPEMStudySource::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputs), vtkInformationVector* outputs)
{
  return this->Try(
    [this, outputs]
    {
      using Pipeline = vtkStreamingDemandDrivenPipeline;
      vtkInformation* information = outputs->GetInformationObject(0);
      const double time = information->Has(Pipeline::UPDATE_TIME_STEP())
        ? information->Get(Pipeline::UPDATE_TIME_STEP())
        : this->Contents->Times.front();
      vtkPolyData* output = vtkPolyData::GetData(information);
      output->ShallowCopy(this->Contents->MakeMesh(time));
      output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    });
}

void vtkPEMStudySource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
}
