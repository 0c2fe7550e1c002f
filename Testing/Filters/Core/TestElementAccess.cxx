// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementAccess.h"

#include "TestMeshes.h"

#include <atomic>
#include <thread>

#include <vtkFloatArray.h>

using namespace pemesh;

TEST(ElementAccess, GivesVerticesInTheOrderStored)
{
  const auto mesh = MakeHouse();
  ElementAccess elements(mesh);
  ASSERT_EQ(elements.GetNumberOfElements(), 3);
  std::vector<Point2> vertices{ { 9, 9 } };
  elements.GetVertices(0, vertices);
  EXPECT_EQ(vertices, (std::vector<Point2>{ { 0, 0 }, { 0.5, 0 }, { 0.5, 1 }, { 0, 1 } }));
  std::vector<vtkIdType> ids;
  elements.GetVertexIds(2, ids);
  EXPECT_EQ(ids, (std::vector<vtkIdType>{ 4, 5, 2 }));
  elements.GetVertices(2, vertices);
  EXPECT_EQ(vertices.size(), 3U);
}

TEST(ElementAccess, TakesPointsOfAnyTypeAndCellsOfAnyWidth)
{
  const auto mesh = MakeHouse();
  vtkNew<vtkPoints> floats;
  floats->SetDataTypeToFloat();
  floats->DeepCopy(mesh->GetPoints());
  mesh->SetPoints(floats);
  mesh->GetPolys()->ConvertTo32BitStorage();
  ElementAccess elements(mesh);
  std::vector<Point2> vertices;
  elements.GetVertices(1, vertices);
  EXPECT_EQ(vertices, (std::vector<Point2>{ { 0.5, 0 }, { 1, 0 }, { 0.5, 1 } }));
}

TEST(ElementAccess, ServesManyThreads)
{
  constexpr int n = 30;
  const auto mesh = MakeJitteredGrid(n, 1);
  const TestPolygons expected = PolygonsOf(mesh);
  std::atomic<int> wrong{ 0 };
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
  {
    threads.emplace_back(
      [&]
      {
        ElementAccess elements(mesh);
        std::vector<vtkIdType> ids;
        for (std::size_t i = 0; i < expected.size(); ++i)
        {
          elements.GetVertexIds(static_cast<vtkIdType>(i), ids);
          wrong += ids == expected[i] ? 0 : 1;
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(wrong, 0);
}

TEST(ElementAccess, SaysWhyAMeshIsUnusable)
{
  EXPECT_EQ(ElementAccess::WhyUnusable(MakeHouse()), "");
  EXPECT_EQ(ElementAccess::WhyUnusable(nullptr), "the mesh has no polygons");
  EXPECT_EQ(
    ElementAccess::WhyUnusable(vtkSmartPointer<vtkPolyData>::New()), "the mesh has no polygons");
  const std::vector<Point2> triangle{ { 0, 0 }, { 1, 0 }, { 0, 1 } };
  EXPECT_EQ(ElementAccess::WhyUnusable(MakeTestMesh(triangle, { { 0, 1, 2 }, { 0, 1 } })),
    "element 1 has fewer than three vertices");
  EXPECT_EQ(ElementAccess::WhyUnusable(MakeTestMesh(triangle, { { 0, 1, 3 } })),
    "element 0 uses vertex 3, and the mesh has 3 vertices");
  EXPECT_EQ(ElementAccess::WhyUnusable(MakeTestMesh(triangle, { { 0, 1, -1 } })),
    "element 0 uses vertex -1, and the mesh has 3 vertices");
  const auto lines = MakeHouse();
  lines->SetLines(MakeTestMesh(triangle, { { 0, 1 } })->GetPolys());
  EXPECT_NE(ElementAccess::WhyUnusable(lines).find("not polygons"), std::string::npos);
}
