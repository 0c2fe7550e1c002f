// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMVirtualElementSolver.h"

#include "CaseStatus.h"
#include "EllipticProblem.h"
#include "Progress.h"
#include "VirtualElementMethod.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <stdexcept>

vtkStandardNewMacro(vtkPEMVirtualElementSolver);

namespace
{

using pemesh::ProblemFormulas;

// The entry of a table, or a sentence.
template <typename Entry>
const Entry& NeedEntry(std::span<const Entry> table, const char* option, const std::string& name)
{
  if (const Entry* entry = pemesh::FindByName(table, name))
  {
    return *entry;
  }
  throw std::runtime_error("The option \"" + std::string(option) + "\" is \"" + name +
    "\" and must be " + pemesh::ListNames(table) + ".");
}

struct FormulaOption
{
  const char* Name;
  std::string ProblemFormulas::*Formula;
};

constexpr FormulaOption FormulaOptions[] = { { "solution", &ProblemFormulas::Solution },
  { "diffusion", &ProblemFormulas::Diffusion }, { "diffusion-xy", &ProblemFormulas::DiffusionXY },
  { "diffusion-yy", &ProblemFormulas::DiffusionYY },
  { "advection-x", &ProblemFormulas::AdvectionX }, { "advection-y", &ProblemFormulas::AdvectionY },
  { "reaction", &ProblemFormulas::Reaction }, { "source", &ProblemFormulas::Load },
  { "dirichlet", &ProblemFormulas::Dirichlet }, { "neumann", &ProblemFormulas::Neumann },
  { "flux", &ProblemFormulas::Flux } };

vtkSmartPointer<vtkDoubleArray> MakeArray(
  const std::string& name, const std::vector<double>& values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

// Replaces the array of an earlier run; no values, no array.
void StoreArray(vtkFieldData* data, const std::string& name, const std::vector<double>& values)
{
  data->RemoveArray(name.c_str());
  if (!values.empty())
  {
    data->AddArray(MakeArray(name, values));
  }
}

std::vector<double> Difference(const std::vector<double>& a, const std::vector<double>& b)
{
  std::vector<double> result(b.size());
  std::transform(b.begin(), b.end(), a.begin(), result.begin(),
    [](double truth, double value) { return value - truth; });
  return result;
}

void StoreResult(
  const pemesh::VirtualElementResult& result, const std::string& prefix, vtkPolyData* output)
{
  StoreArray(output->GetPointData(), prefix + "Solution", result.Solution);
  StoreArray(output->GetPointData(), prefix + "GroundTruth", result.GroundTruth);
  StoreArray(
    output->GetPointData(), prefix + "Error", Difference(result.Solution, result.GroundTruth));
  for (const pemesh::VirtualElementArray& array : pemesh::VirtualElementArrays())
  {
    StoreArray(output->GetCellData(), prefix + array.Name, result.*array.Values);
  }
  for (const pemesh::VirtualElementPerformance& performance : pemesh::VirtualElementPerformances())
  {
    pemesh::SetFieldNumber(output, prefix + performance.Name, result.*performance.Value);
    if (performance.Measured)
    {
      pemesh::AddToFieldList(output, pemesh::MeasuredList, prefix + performance.Name);
    }
  }
}

} // namespace

class vtkPEMVirtualElementSolver::Internals
{
public:
  struct Option
  {
    std::string Name;
    std::string Value;
  };

  Internals()
    : Options{ { "problem", "franke" }, { "basis", pemesh::BasisRules().front().Name },
      { "stabilisation", pemesh::StabilisationRules().front().Name },
      { "p0", pemesh::ProjectionConstants().front().Name },
      { "load", pemesh::LoadProjections().front().Name },
      { "solver", pemesh::SolverKinds().front().Name } }
  {
    for (const FormulaOption& formula : FormulaOptions)
    {
      this->Options.push_back({ formula.Name, "" });
    }
  }

  Option* Find(const std::string& name)
  {
    const auto found = std::find_if(this->Options.begin(), this->Options.end(),
      [&name](const Option& option) { return option.Name == name; });
    return found == this->Options.end() ? nullptr : &*found;
  }

  const std::string& Get(const std::string& name) { return this->Find(name)->Value; }

  pemesh::EllipticProblem MakeProblem()
  {
    ProblemFormulas formulas;
    for (const FormulaOption& formula : FormulaOptions)
    {
      formulas.*formula.Formula = this->Get(formula.Name);
    }
    const bool own = !formulas.Solution.empty() || !formulas.Load.empty();
    const auto& problem = NeedEntry(pemesh::TestProblems(), "problem", this->Get("problem"));
    return pemesh::EllipticProblem(formulas, own ? nullptr : &problem);
  }

  pemesh::VirtualElementOptions MakeOptions()
  {
    pemesh::VirtualElementOptions options;
    options.Basis = &NeedEntry(pemesh::BasisRules(), "basis", this->Get("basis"));
    options.Stabilisation =
      &NeedEntry(pemesh::StabilisationRules(), "stabilisation", this->Get("stabilisation"));
    options.Constant = NeedEntry(pemesh::ProjectionConstants(), "p0", this->Get("p0")).Choice;
    options.Load = NeedEntry(pemesh::LoadProjections(), "load", this->Get("load")).Choice;
    options.Solver = NeedEntry(pemesh::SolverKinds(), "solver", this->Get("solver")).Choice;
    return options;
  }

  std::vector<Option> Options;
};

vtkPEMVirtualElementSolver::vtkPEMVirtualElementSolver()
  : Implementation(std::make_unique<Internals>())
{
}

vtkPEMVirtualElementSolver::~vtkPEMVirtualElementSolver() = default;

void vtkPEMVirtualElementSolver::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Order: " << this->Order << "\n";
  os << indent << "Details: " << this->Details << "\n";
  os << indent << "RunName: " << this->RunName << "\n";
  os << indent << "Options:";
  for (const Internals::Option& option : this->Implementation->Options)
  {
    os << ' ' << option.Name << "=\"" << option.Value << '"';
  }
  os << "\n";
}

void vtkPEMVirtualElementSolver::SetOption(const std::string& name, const std::string& value)
{
  Internals::Option* option = this->Implementation->Find(name);
  if (!option)
  {
    vtkErrorMacro("There is no option \"" << name << "\".");
  }
  else if (option->Value != value)
  {
    option->Value = value;
    this->Modified();
  }
}

std::string vtkPEMVirtualElementSolver::GetOption(const std::string& name) const
{
  const Internals::Option* option = this->Implementation->Find(name);
  return option ? option->Value : "";
}

std::vector<std::string> vtkPEMVirtualElementSolver::GetOptionNames()
{
  std::vector<std::string> names;
  for (const Internals::Option& option : Internals().Options)
  {
    names.push_back(option.Name);
  }
  return names;
}

std::vector<std::string> vtkPEMVirtualElementSolver::GetProblemNames()
{
  std::vector<std::string> names;
  for (const pemesh::TestProblem& problem : pemesh::TestProblems())
  {
    names.emplace_back(problem.Name);
  }
  return names;
}

void vtkPEMVirtualElementSolver::SetRunName(const std::string& name)
{
  if (this->RunName != name)
  {
    this->RunName = name;
    this->Modified();
  }
}

std::string vtkPEMVirtualElementSolver::GetRunName() const
{
  return this->RunName;
}

int vtkPEMVirtualElementSolver::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(input);
  const std::string prefix = this->RunName.empty() ? "" : this->RunName + '_';
  const std::string statusName = this->RunName.empty() ? "SolverStatus" : this->RunName + "_Status";
  const auto finish =
    [&](const char* status, const std::string& message, const pemesh::VirtualElementResult& result)
  {
    StoreResult(result, prefix, output);
    pemesh::SetFieldText(output, statusName, status);
    pemesh::SetFieldText(output, statusName + "Message", message);
    return 1;
  };
  pemesh::VirtualElementResult result = pemesh::UndefinedVirtualElementResult();
  try
  {
    pemesh::VirtualElementOptions options = this->Implementation->MakeOptions();
    options.Order = this->Order;
    options.Details = this->Details;
    const pemesh::EllipticProblem problem = this->Implementation->MakeProblem();
    if (pemesh::IsCaseFailed(input))
    {
      return finish("no-mesh", "There is no mesh to solve on.", result);
    }
    try
    {
      result = pemesh::SolveElliptic(input, problem, options,
        [this](double fraction) { return pemesh::ReportProgress(this, fraction); });
    }
    catch (const pemesh::SolveAborted&)
    {
      return finish("cancelled", "The run was cancelled.", result);
    }
    catch (const std::exception& error)
    {
      return finish("not-solved", error.what(), result);
    }
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return finish("ok", "", result);
}
