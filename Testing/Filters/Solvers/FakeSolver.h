// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The filter set up to run Testing/Support/solvers/fake-solver.sh, and what must hold after it.
 */
#ifndef pemesh_FakeSolver_h
#define pemesh_FakeSolver_h

#include "CaseStatus.h"
#include "ErrorLog.h"
#include "SolverDescription.h"
#include "TestMeshes.h"
#include "vtkPEMExternalSolver.h"

#include <chrono>
#include <cmath>
#include <sstream>
#include <thread>

#include <vtkDoubleArray.h>
#include <vtkPointData.h>

#include <gmock/gmock.h>

namespace pemesh
{

inline const std::filesystem::path FakeSolverFolder =
  std::filesystem::path(PEMESH_SOURCE_DIR) / "Testing" / "Support" / "solvers";

inline SolverDescription FakeSolver(const std::string& mode)
{
  SolverDescription description;
  description.Name = "fake";
  description.Command = { "./fake-solver.sh", "{mode}", "{mesh}", "{output}", "{stem}" };
  description.Folder = FakeSolverFolder;
  description.Options = { { "mode", "string", mode, "" }, { "order", "integer", "1", "" },
    { "tolerance", "number", "1e-10", "" } };
  description.Performances = { { "condition-number", "Condition number", "log", false,
                                 mode == "elements" },
    { "solve-seconds", "Seconds", "linear", true } };
  return description;
}

inline vtkSmartPointer<vtkPolyData> NamedHouse(const std::string& name = "house")
{
  auto mesh = MakeHouse();
  SetFieldText(mesh, MeshNameField, name);
  return mesh;
}

inline vtkSmartPointer<vtkPEMExternalSolver> MakeSolver(const std::string& mode)
{
  auto solver = vtkSmartPointer<vtkPEMExternalSolver>::New();
  solver->SetDescription(FakeSolver(mode));
  solver->SetInputData(NamedHouse());
  solver->SetRunName("run");
  solver->SetWorkDirectory(TestFolder().string());
  return solver;
}

inline std::vector<double> PointValues(vtkPolyData* mesh, const char* name)
{
  auto* array = vtkDoubleArray::SafeDownCast(mesh->GetPointData()->GetArray(name));
  return array ? std::vector<double>(array->Begin(), array->End()) : std::vector<double>();
}

inline bool IsGone(pid_t process)
{
  for (int i = 0; i < 100; ++i)
  {
    const std::string state = ReadBytes("/proc/" + std::to_string(process) + "/stat");
    if (state.empty() || state.find(") Z ") != std::string::npos)
    {
      return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

inline void ExpectAllGone(const std::filesystem::path& pids, int expected)
{
  std::istringstream stream(ReadBytes(pids));
  int count = 0;
  for (pid_t pid = 0; stream >> pid; ++count)
  {
    EXPECT_TRUE(IsGone(pid)) << pid;
  }
  EXPECT_EQ(count, expected);
}

/** Everything that must hold after a run that was not ok, whatever the reason. */
inline void ExpectTold(
  vtkPEMExternalSolver* solver, const std::string& status, const std::string& message)
{
  EXPECT_EQ(solver->GetExecutive()->Update(), 1);
  vtkPolyData* output = solver->GetOutput();
  EXPECT_EQ(GetFieldText(output, "run_Status"), status);
  EXPECT_THAT(GetFieldText(output, "run_StatusMessage"), testing::HasSubstr(message));
  EXPECT_THAT(GetFieldText(output, "run_StatusMessage"), testing::EndsWith("."));
  EXPECT_EQ(GetFieldText(output, "run_StatusMessage").find('\n'), std::string::npos);
  EXPECT_TRUE(output->GetFieldData()->HasArray("run_condition-number"));
  EXPECT_TRUE(output->GetFieldData()->HasArray("run_solve-seconds"));
  EXPECT_TRUE(IsInFieldList(output, MeasuredList, "run_solve-seconds"));
}

/** The same for a run of which nothing is kept. */
inline void ExpectFailed(
  vtkPEMExternalSolver* solver, const std::string& status, const std::string& message)
{
  ExpectTold(solver, status, message);
  vtkPolyData* output = solver->GetOutput();
  EXPECT_TRUE(std::isnan(GetFieldNumber(output, "run_condition-number")));
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 0);
}

} // namespace pemesh

#endif
