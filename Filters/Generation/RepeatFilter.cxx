// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RepeatFilter.h"

#include "CaseStatus.h"
#include "ElementAccess.h"
#include "MeshConversion.h"

#include <vtkFieldData.h>
#include <vtkPolyData.h>

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace pemesh
{

namespace
{

std::string WhyUnusable(vtkPolyData* input, const RepeatRequest& request)
{
  const std::string unusable = ElementAccess::WhyUnusable(input);
  if (!unusable.empty() || input->GetNumberOfCells() == 0)
  {
    return "The mesh cannot be used: " + (unusable.empty() ? "it has no elements" : unusable) + ".";
  }
  const double elements = static_cast<double>(input->GetNumberOfCells()) *
    std::pow(request.CopiesEachTime, request.Times);
  return elements > static_cast<double>(request.MaximumNumberOfElements)
    ? "The repeated mesh would have more than " + std::to_string(request.MaximumNumberOfElements) +
      " elements; repeat it less often or raise the limit."
    : std::string();
}

} // namespace

void RepeatPolyData(vtkPolyData* input, const RepeatRequest& request, vtkPolyData* output)
{
  if (IsCaseFailed(input) || request.Times == 0 || request.CopiesEachTime == 1.0)
  {
    output->ShallowCopy(input);
    return;
  }
  output->GetFieldData()->PassData(input->GetFieldData());
  const std::string unusable = WhyUnusable(input, request);
  if (!unusable.empty())
  {
    SetCaseFailed(output, request.FailureStatus, unusable);
    return;
  }
  try
  {
    PolygonMesh mesh = ToPolygonMesh(input);
    std::vector<int> sources(static_cast<std::size_t>(mesh.NumberOfElements()));
    std::iota(sources.begin(), sources.end(), 0);
    RemoveUnusedPoints(mesh); // the box is that of the elements
    for (int time = 0; time < request.Times; ++time)
    {
      RepeatedMesh repeated = RepeatMesh(mesh, request.Repetition(BoxOfMesh(mesh)));
      if (!repeated.Message.empty())
      {
        SetCaseFailed(output, request.FailureStatus, repeated.Message);
        return;
      }
      for (int& source : repeated.Sources)
      {
        source = sources[source];
      }
      mesh = std::move(repeated.Mesh);
      sources = std::move(repeated.Sources);
      if (!request.Progress((time + 1.0) / request.Times))
      {
        output->Initialize();
        return;
      }
    }
    SetPolygonMesh(output, mesh);
    CopyProvenance(input, sources, output);
  }
  catch (const std::exception& error) // memory that is not there, too many points
  {
    SetCaseFailed(output, request.FailureStatus,
      std::string("The mesh could not be repeated: ") + error.what());
  }
}

} // namespace pemesh
