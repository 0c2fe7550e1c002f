// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMSeriesTable.h"

#include "Progress.h"
#include "TableRows.h"

#include <vtkCompositeDataPipeline.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>

#include <algorithm>

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkPEMSeriesTable);

//------------------------------------------------------------------------------
/**
 * CONTINUE_EXECUTING makes the pipeline ask again and again until the filter says that it is done.
 * If a step fails upstream, the filter is not called any more, cannot say so, and the pipeline of
 * VTK asks for ever. This one ends the walk and reports the failure.
 */
class vtkPEMSeriesTable::WalkPipeline : public vtkCompositeDataPipeline
{
public:
  static WalkPipeline* New() { VTK_STANDARD_NEW_BODY(WalkPipeline); }

protected:
  using vtkCompositeDataPipeline::ForwardUpstream;

  int ForwardUpstream(vtkInformation* request) override
  {
    const int result = this->vtkCompositeDataPipeline::ForwardUpstream(request);
    if (!result && request->Has(REQUEST_DATA()))
    {
      this->IsBroken = true;
      this->ContinueExecuting = 0;
      static_cast<vtkPEMSeriesTable*>(this->Algorithm)->Reset(request);
    }
    return result;
  }

  int ExecuteData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override
  {
    // The call for the first step contains the calls for all others.
    const bool isFirst = !this->ContinueExecuting;
    this->IsBroken = this->IsBroken && !isFirst;
    const int result = this->vtkCompositeDataPipeline::ExecuteData(request, input, output);
    return isFirst && this->IsBroken ? 0 : result;
  }

private:
  bool IsBroken = false;
};

//------------------------------------------------------------------------------
vtkExecutive* vtkPEMSeriesTable::CreateDefaultExecutive()
{
  return WalkPipeline::New();
}

//------------------------------------------------------------------------------
vtkPEMSeriesTable::vtkPEMSeriesTable()
  : Rows(vtkTable::New())
{
}

//------------------------------------------------------------------------------
vtkPEMSeriesTable::~vtkPEMSeriesTable()
{
  this->Rows->Delete();
}

//------------------------------------------------------------------------------
int vtkPEMSeriesTable::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
int vtkPEMSeriesTable::RequestInformation(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkInformation* inInfo = input[0]->GetInformationObject(0);
  vtkInformation* outInfo = output->GetInformationObject(0);
  this->TimeSteps.clear();
  if (inInfo->Has(Pipeline::TIME_STEPS()))
  {
    const double* steps = inInfo->Get(Pipeline::TIME_STEPS());
    this->TimeSteps.assign(steps, steps + inInfo->Length(Pipeline::TIME_STEPS()));
  }
  outInfo->Remove(Pipeline::TIME_STEPS());
  outInfo->Remove(Pipeline::TIME_RANGE());
  return 1;
}

//------------------------------------------------------------------------------
int vtkPEMSeriesTable::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  vtkInformation* inInfo = input[0]->GetInformationObject(0);
  if (this->CurrentStep < this->TimeSteps.size())
  {
    inInfo->Set(Pipeline::UPDATE_TIME_STEP(), this->TimeSteps[this->CurrentStep]);
  }
  else
  {
    inInfo->Remove(Pipeline::UPDATE_TIME_STEP());
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkPEMSeriesTable::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkTable* row = vtkTable::GetData(input[0], 0);
  vtkTable* table = vtkTable::GetData(output, 0);
  const std::size_t steps = std::max<std::size_t>(this->TimeSteps.size(), 1);
  pemesh::AppendTableRows(this->Rows, row);
  ++this->CurrentStep;
  const double fraction = static_cast<double>(this->CurrentStep) / static_cast<double>(steps);
  if (!pemesh::ReportProgress(this, fraction))
  {
    this->Reset(request);
    table->Initialize();
    return 1;
  }
  if (this->CurrentStep < steps)
  {
    request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
    return 1;
  }
  table->ShallowCopy(this->Rows);
  pemesh::NumberTableRows(table);
  this->Reset(request);
  return 1;
}

//------------------------------------------------------------------------------
void vtkPEMSeriesTable::Reset(vtkInformation* request)
{
  if (request)
  {
    request->Remove(Pipeline::CONTINUE_EXECUTING());
  }
  this->CurrentStep = 0;
  // New arrays: those of a finished walk now belong to the output.
  this->Rows->Delete();
  this->Rows = vtkTable::New();
}

//------------------------------------------------------------------------------
void vtkPEMSeriesTable::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Number of time steps: " << this->TimeSteps.size() << "\n";
  os << indent << "CurrentStep: " << this->CurrentStep << "\n";
  os << indent << "Rows gathered: " << this->Rows->GetNumberOfRows() << "\n";
}
