// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ElementTableModel.h"
#include "StudioSupport.h"

#include <gtest/gtest.h>

#include <QPersistentModelIndex>

#include <cmath>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

using namespace pemesh;
using studio_test::WaitFor;

namespace
{

/** Triangles side by side with these areas. */
MeshPicturePointer MakeTriangles(const std::vector<double>& areas)
{
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkDoubleArray> values;
  values->SetName("Area");
  for (const double area : areas)
  {
    const auto x = static_cast<double>(values->GetNumberOfValues());
    const vtkIdType corners[3] = { points->InsertNextPoint(x, 0.0, 0.0),
      points->InsertNextPoint(x + 1.0, 0.0, 0.0), points->InsertNextPoint(x, 1.0, 0.0) };
    triangles->InsertNextCell(3, corners);
    values->InsertNextValue(area);
  }
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  mesh->GetCellData()->AddArray(values);
  return std::make_shared<const MeshPicture>(mesh);
}

std::vector<qint64> Elements(const ElementTableModel& model)
{
  std::vector<qint64> elements;
  for (int row = 0; row < model.rowCount(); ++row)
  {
    elements.push_back(model.GetElement(row));
    EXPECT_EQ(model.FindRow(elements.back()), row);
  }
  return elements;
}

class ElementTable : public testing::Test
{
protected:
  ElementTable()
  {
    this->Model.SetPicture(MakeTriangles({ 3.0, std::nan(""), 1.0, 2.0, 1.0 }));
    QObject::connect(
      &this->Model, &ElementTableModel::Sorted, &this->Model, [this] { ++this->Sorted; });
  }

  void Sort(Qt::SortOrder order)
  {
    const int before = this->Sorted;
    this->Model.sort(this->Model.FindColumn("Area"), order);
    ASSERT_TRUE(WaitFor([&] { return this->Sorted > before; }));
  }

  ElementTableModel Model;
  int Sorted = 0;
};

} // namespace

TEST_F(ElementTable, IsSortedStablyWithUndefinedValuesLast)
{
  EXPECT_EQ(Elements(this->Model), (std::vector<qint64>{ 0, 1, 2, 3, 4 }));
  this->Sort(Qt::AscendingOrder);
  EXPECT_EQ(Elements(this->Model), (std::vector<qint64>{ 2, 4, 3, 0, 1 }));
  this->Sort(Qt::DescendingOrder);
  EXPECT_EQ(Elements(this->Model), (std::vector<qint64>{ 0, 3, 2, 4, 1 }));
}

TEST_F(ElementTable, WhatIsCurrentStaysWithItsElement)
{
  const QPersistentModelIndex kept(this->Model.index(3, 1));
  for (const Qt::SortOrder order : { Qt::AscendingOrder, Qt::DescendingOrder })
  {
    this->Sort(order);
    EXPECT_EQ(this->Model.GetElement(kept.row()), 3);
    EXPECT_EQ(kept.column(), 1);
  }
}

TEST_F(ElementTable, MarkedElementsStandOutWhateverTheOrder)
{
  this->Model.SetMarked({ 0, 4 });
  this->Sort(Qt::DescendingOrder);
  for (int row = 0; row < this->Model.rowCount(); ++row)
  {
    const qint64 element = this->Model.GetElement(row);
    EXPECT_EQ(
      this->Model.index(row, 0).data(Qt::BackgroundRole).isValid(), element == 0 || element == 4)
      << row;
  }
}
