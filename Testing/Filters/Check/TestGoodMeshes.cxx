// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Meshes that are right: no check finds an error in them.
 */
#include "MeshFormats.h"
#include "PolygonFamilies.h"
#include "vtkPEMDomainMesher.h"
#include "vtkPEMMeshCheck.h"
#include "vtkPEMPolygonLayout.h"

#include <gtest/gtest.h>

#include <filesystem>

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

namespace fs = std::filesystem;

namespace
{

void ExpectNoErrors(vtkPEMMeshCheck* check)
{
  check->Update();
  EXPECT_EQ(check->GetNumberOfErrors(), 0);
  vtkTable* table = vtkTable::SafeDownCast(check->GetOutputDataObject(2));
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    EXPECT_EQ(table->GetValueByName(row, "Severity").ToString(), "warning")
      << table->GetValueByName(row, "Message").ToString();
  }
}

} // namespace

TEST(GoodMeshes, RealFiles)
{
  int files = 0;
  for (const char* folder : { PEMESH_TEST_DATA "/Meshes", PEMESH_SOURCE_DIR "/Data/Meshes" })
  {
    for (const auto& entry : fs::recursive_directory_iterator(folder))
    {
      if (!pemesh::FindMeshFormatOfFile(entry.path()))
      {
        continue;
      }
      SCOPED_TRACE(entry.path());
      vtkNew<vtkPEMMeshCheck> check;
      check->SetInputData(pemesh::ReadMesh(entry.path(), pemesh::ElementOrientation::AsStored));
      ExpectNoErrors(check);
      EXPECT_EQ(check->GetNumberOfComponents(), 1);
      EXPECT_EQ(check->GetNumberOfHoles(), 0);
      ++files;
    }
  }
  EXPECT_GE(files, 36);
}

TEST(GoodMeshes, EveryFamilyWithSplitAndPreservedEdges)
{
  for (const pemesh::PolygonFamily& family : pemesh::PolygonFamilies())
  {
    for (const double t : { 0.1, 0.5, 0.95 })
    {
      SCOPED_TRACE(family.Name);
      vtkNew<vtkPEMPolygonLayout> layout;
      layout->SetPolygonRotation(layout->AddPolygon(family.Name, 0.5, 0.5), 15.0);
      vtkNew<vtkPEMDomainMesher> mesher;
      mesher->SetInputConnection(layout->GetOutputPort());
      mesher->SetPreservePolygons(t < 0.3);
      mesher->UpdateTimeStep(t);
      vtkNew<vtkPEMMeshCheck> check;
      check->SetInputData(mesher->GetOutput());
      ExpectNoErrors(check);
    }
  }
}
