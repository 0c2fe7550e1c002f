// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPEMExternalSolver.h"

#include "CaseStatus.h"
#include "NumberText.h"
#include "Progress.h"
#include "SolverDescription.h"
#include "SolverRun.h"

#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

vtkStandardNewMacro(vtkPEMExternalSolver);

class vtkPEMExternalSolver::Internals
{
public:
  /** The values of the options of this run: those set, else the defaults. Throws. */
  std::map<std::string, std::string> GetOptionValues() const
  {
    std::map<std::string, std::string> values;
    std::vector<std::string> names;
    for (const pemesh::SolverOption& option : this->Description.Options)
    {
      values[option.Name] = option.Default;
      names.push_back(option.Name);
    }
    for (const auto& [name, value] : this->Options)
    {
      if (values.count(name) == 0)
      {
        const std::string nearest = pemesh::NearestWord(name, names);
        throw std::runtime_error("The solver has no option \"" + name + "\"" +
          (nearest.empty() ? "." : "; did you mean \"" + nearest + "\"?"));
      }
      values[name] = value;
    }
    for (const pemesh::SolverOption& option : this->Description.Options)
    {
      const std::string& value = values[option.Name];
      const auto number = pemesh::ParseNumber(value);
      if ((option.Type == "integer" && !pemesh::ParseInteger(value)) ||
        (option.Type == "number" && !(number && std::isfinite(*number))))
      {
        throw std::runtime_error("The solver's option \"" + option.Name + "\" is \"" + value +
          "\" and must be " + (option.Type == "integer" ? "an integer." : "a number."));
      }
    }
    return values;
  }

  pemesh::SolverDescription Description;
  std::map<std::string, std::string> Options;
};

vtkPEMExternalSolver::vtkPEMExternalSolver()
  : Implementation(std::make_unique<Internals>())
{
}

vtkPEMExternalSolver::~vtkPEMExternalSolver() = default;

void vtkPEMExternalSolver::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const pemesh::SolverDescription& description = this->Implementation->Description;
  os << indent << "Name: " << description.Name << "\n";
  os << indent << "Command:";
  for (const std::string& argument : description.Command)
  {
    os << " \"" << argument << '"';
  }
  os << "\n" << indent << "MeshFormat: " << description.MeshFormat << "\n";
  os << indent << "Folder: " << description.Folder.string() << "\n";
  os << indent << "TimeLimit: " << description.TimeLimit << "\n";
  os << indent << "Options:";
  for (const pemesh::SolverOption& option : description.Options)
  {
    os << ' ' << option.Name << '=' << this->GetOption(option.Name);
  }
  os << "\n" << indent << "Performances:";
  for (const pemesh::SolverPerformance& performance : description.Performances)
  {
    os << ' ' << performance.Name;
  }
  os << "\n" << indent << "Elements:";
  for (const pemesh::SolverElementArray& array : description.Elements)
  {
    os << ' ' << array.Name;
  }
  os << "\n" << indent << "RunName: " << this->RunName << "\n";
  os << indent << "WorkDirectory: " << this->WorkDirectory << "\n";
  os << indent << "Threads: " << this->Threads << "\n";
  os << indent << "Retries: " << this->Retries << "\n";
  os << indent << "ReuseAnswers: " << this->ReuseAnswers << "\n";
  os << indent << "MemoryBudget: " << (this->Budget ? "shared" : "none") << "\n";
  os << indent << "Queue: " << (this->Queue ? "shared" : "none") << "\n";
  os << indent << "Version: " << this->Version << "\n";
}

void vtkPEMExternalSolver::SetDescription(const pemesh::SolverDescription& description)
{
  if (!(this->Implementation->Description == description))
  {
    this->Implementation->Description = description;
    this->Modified();
  }
}

const pemesh::SolverDescription& vtkPEMExternalSolver::GetDescription() const
{
  return this->Implementation->Description;
}

void vtkPEMExternalSolver::SetCommand(const std::vector<std::string>& command)
{
  if (this->Implementation->Description.Command != command)
  {
    this->Implementation->Description.Command = command;
    this->Modified();
  }
}

std::vector<std::string> vtkPEMExternalSolver::GetCommand() const
{
  return this->Implementation->Description.Command;
}

void vtkPEMExternalSolver::SetMeshFormat(const std::string& format)
{
  if (this->Implementation->Description.MeshFormat != format)
  {
    this->Implementation->Description.MeshFormat = format;
    this->Modified();
  }
}

std::string vtkPEMExternalSolver::GetMeshFormat() const
{
  return this->Implementation->Description.MeshFormat;
}

void vtkPEMExternalSolver::AddOption(
  const std::string& name, const std::string& type, const std::string& defaultValue)
{
  this->Implementation->Description.Options.push_back({ name, type, defaultValue, "" });
  this->Modified();
}

void vtkPEMExternalSolver::RemoveAllOptions()
{
  this->Implementation->Description.Options.clear();
  this->Modified();
}

void vtkPEMExternalSolver::AddPerformance(
  const std::string& name, bool measured, bool mayBeUndefined)
{
  this->Implementation->Description.Performances.push_back(
    { name, name, "linear", measured, mayBeUndefined });
  this->Modified();
}

void vtkPEMExternalSolver::RemoveAllPerformances()
{
  this->Implementation->Description.Performances.clear();
  this->Modified();
}

void vtkPEMExternalSolver::AddElementArray(const std::string& name)
{
  this->Implementation->Description.Elements.push_back({ name, name });
  this->Modified();
}

void vtkPEMExternalSolver::RemoveAllElementArrays()
{
  this->Implementation->Description.Elements.clear();
  this->Modified();
}

void vtkPEMExternalSolver::SetFolder(const std::string& folder)
{
  if (this->Implementation->Description.Folder != folder)
  {
    this->Implementation->Description.Folder = folder;
    this->Modified();
  }
}

std::string vtkPEMExternalSolver::GetFolder() const
{
  return this->Implementation->Description.Folder.string();
}

void vtkPEMExternalSolver::SetOption(const std::string& name, const std::string& value)
{
  const auto found = this->Implementation->Options.find(name);
  if (found == this->Implementation->Options.end() || found->second != value)
  {
    this->Implementation->Options[name] = value;
    this->Modified();
  }
}

std::string vtkPEMExternalSolver::GetOption(const std::string& name) const
{
  for (const pemesh::SolverOption& option : this->Implementation->Description.Options)
  {
    if (option.Name == name)
    {
      const auto found = this->Implementation->Options.find(name);
      return found == this->Implementation->Options.end() ? option.Default : found->second;
    }
  }
  return {};
}

void vtkPEMExternalSolver::ResetOptions()
{
  if (!this->Implementation->Options.empty())
  {
    this->Implementation->Options.clear();
    this->Modified();
  }
}

void vtkPEMExternalSolver::SetRunName(const std::string& name)
{
  if (this->RunName != name)
  {
    this->RunName = name;
    this->Modified();
  }
}

std::string vtkPEMExternalSolver::GetRunName() const
{
  return this->RunName;
}

void vtkPEMExternalSolver::SetWorkDirectory(const std::string& folder)
{
  if (this->WorkDirectory != folder)
  {
    this->WorkDirectory = folder;
    this->Modified();
  }
}

std::string vtkPEMExternalSolver::GetWorkDirectory() const
{
  return this->WorkDirectory;
}

void vtkPEMExternalSolver::SetVersion(const std::string& version)
{
  if (this->Version != version)
  {
    this->Version = version;
    this->Modified();
  }
}

std::string vtkPEMExternalSolver::GetVersion() const
{
  return this->Version;
}

void vtkPEMExternalSolver::SetTimeLimit(double seconds)
{
  const double limit = std::isfinite(seconds) && seconds > 0.0 ? seconds : 0.0;
  if (this->Implementation->Description.TimeLimit != limit)
  {
    this->Implementation->Description.TimeLimit = limit;
    this->Modified();
  }
}

double vtkPEMExternalSolver::GetTimeLimit() const
{
  return this->Implementation->Description.TimeLimit;
}

std::string vtkPEMExternalSolver::GetStatusName() const
{
  return this->RunName.empty() ? "SolverStatus" : this->RunName + "_Status";
}

std::string vtkPEMExternalSolver::GetStatusMessageName() const
{
  return this->GetStatusName() + "Message";
}

int vtkPEMExternalSolver::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(input);

  pemesh::SolverRun run;
  run.Description = this->Implementation->Description;
  run.WorkDirectory = this->WorkDirectory;
  run.Threads = this->Threads;
  run.Retries = this->Retries;
  run.Budget = this->Budget;
  run.Queue = this->Queue;
  run.ReusesAnswer = this->ReuseAnswers;
  run.Version = this->Version;
  try
  {
    run.Options = this->Implementation->GetOptionValues();
    pemesh::CheckSolverRun(run);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  // Progress never ends by itself where there is no time limit: it nears 1 with the time constant.
  constexpr double timeConstant = 10.0;
  run.GoOn = [this](double seconds)
  {
    const double limit = this->GetTimeLimit();
    const double fraction =
      limit > 0.0 ? std::min(1.0, seconds / limit) : 1.0 - std::exp(-seconds / timeConstant);
    return pemesh::ReportProgress(this, 0.98 * fraction);
  };
  const pemesh::SolverOutcome outcome = pemesh::RunSolver(run, input);
  this->StoreOutcome(outcome, output);
  return 1;
}

void vtkPEMExternalSolver::StoreOutcome(const pemesh::SolverOutcome& outcome, vtkPolyData* output)
{
  const std::string prefix = this->RunName.empty() ? "" : this->RunName + '_';
  const auto store = [&](vtkFieldData* data, const std::string& name, vtkDoubleArray* values)
  {
    const std::string fullName = prefix + name;
    data->RemoveArray(fullName.c_str()); // of an earlier run
    if (values)
    {
      values->SetName(fullName.c_str());
      data->AddArray(values);
    }
  };
  const auto storeArray = [&](const char* name, vtkDoubleArray* values)
  { store(output->GetPointData(), name, values); };
  const pemesh::SolverAnswer& answer = outcome.Answer;
  vtkSmartPointer<vtkDoubleArray> error;
  if (answer.Solution && answer.GroundTruth)
  {
    error = vtkSmartPointer<vtkDoubleArray>::New();
    error->SetNumberOfTuples(answer.Solution->GetNumberOfTuples());
    for (vtkIdType i = 0; i < error->GetNumberOfTuples(); ++i)
    {
      error->SetValue(i, answer.Solution->GetValue(i) - answer.GroundTruth->GetValue(i));
    }
  }
  storeArray("Solution", answer.Solution);
  storeArray("GroundTruth", answer.GroundTruth);
  storeArray("Error", error);

  const auto& arrays = this->Implementation->Description.Elements;
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    store(output->GetCellData(), arrays[i].Name,
      i < answer.Elements.size() ? answer.Elements[i] : nullptr);
  }

  const auto& performances = this->Implementation->Description.Performances;
  for (std::size_t i = 0; i < performances.size(); ++i)
  {
    const std::string name = prefix + performances[i].Name;
    pemesh::SetFieldNumber(output, name,
      i < answer.Performances.size() ? answer.Performances[i]
                                     : std::numeric_limits<double>::quiet_NaN());
    if (performances[i].Measured)
    {
      pemesh::AddToFieldList(output, pemesh::MeasuredList, name);
    }
  }
  pemesh::SetFieldText(output, this->GetStatusName(), outcome.Status);
  pemesh::SetFieldText(output, this->GetStatusMessageName(), outcome.Message);
}
