// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Compiled as C++17, for the header vtkSMPTools.h of VTK 9.1 is not valid C++20.
 */
#include "vtkPEMMetrics.h"

#include "MetricMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include <vtkSMPTools.h>

using namespace pemesh::test;

namespace
{

/** Stars of five to twelve vertices, none like the other. */
std::vector<Coordinates> Stars(int count)
{
  std::vector<Coordinates> stars;
  for (int i = 0; i < count; ++i)
  {
    Coordinates star;
    const int size = 5 + i % 8;
    for (int k = 0; k < size; ++k)
    {
      const double angle = 2.0 * 3.141592653589793 * k / size;
      const double radius = 1.0 + 0.6 * std::sin(17.0 * i + 5.0 * k * k);
      star.push_back({ radius * std::cos(angle) + i, radius * std::sin(angle) });
    }
    stars.push_back(star);
  }
  return stars;
}

vtkSmartPointer<vtkPolyData> Measure(vtkPolyData* mesh, int threads)
{
  vtkNew<vtkPEMMetrics> filter;
  filter->SetInputData(mesh);
  vtkSMPTools::LocalScope(
    vtkSMPTools::Config(threads, "STDThread", false), [&filter]() { filter->Update(); });
  return filter->GetOutput();
}

} // namespace

TEST(vtkPEMMetrics, TheSameBitsWithAnyNumberOfThreads)
{
  const auto mesh = MakeMesh(Stars(4000));
  const auto one = Measure(mesh, 1);
  for (const int threads : { 2, 3 })
  {
    const auto many = Measure(mesh, threads);
    ASSERT_EQ(one->GetCellData()->GetNumberOfArrays(), many->GetCellData()->GetNumberOfArrays());
    for (int i = 0; i < one->GetCellData()->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* a = one->GetCellData()->GetArray(i);
      vtkDataArray* b = many->GetCellData()->GetArray(i);
      ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues());
      EXPECT_EQ(std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
                  sizeof(double) * static_cast<std::size_t>(a->GetNumberOfValues())),
        0)
        << a->GetName() << ' ' << threads;
    }
  }
}
