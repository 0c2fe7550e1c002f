// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshBuilder.h"

#include <cmath>
#include <limits>
#include <vector>

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>

namespace pemesh
{

namespace
{

/** A sum of doubles without rounding: nonoverlapping components, smallest first. */
class ExactSum
{
public:
  /** Shewchuk's Grow-Expansion, dropping zeros. */
  void Add(double value)
  {
    std::size_t kept = 0;
    double sum = value;
    for (std::size_t i = 0; i < this->Components.size(); ++i)
    {
      const double a = this->Components[i];
      const double total = sum + a;
      const double virtualA = total - sum;
      const double error = (sum - (total - virtualA)) + (a - virtualA);
      sum = total;
      if (error != 0.0)
      {
        this->Components[kept++] = error;
      }
    }
    this->Components.resize(kept);
    if (sum != 0.0)
    {
      this->Components.push_back(sum);
    }
  }

  void AddProduct(double a, double b)
  {
    const double product = a * b;
    this->Add(product);
    this->Add(std::fma(a, b, -product));
  }

  int Sign() const
  {
    const double largest = this->Components.empty() ? 0.0 : this->Components.back();
    return (largest > 0.0) - (largest < 0.0); // 0 for NaN, after an overflow
  }

private:
  std::vector<double> Components;
};

int ExactAreaSign(const double* coordinates, const std::int64_t* corners, std::size_t count)
{
  ExactSum area;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double* p = coordinates + 3 * corners[i];
    const double* q = coordinates + 3 * corners[i + 1 == count ? 0 : i + 1];
    area.AddProduct(p[0], q[1]);
    area.AddProduct(-q[0], p[1]);
  }
  return area.Sign();
}

template <typename Array, typename Value>
vtkSmartPointer<Array> TakeArray(GrowingArray<Value>& values, int components)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(components);
  const auto size = static_cast<vtkIdType>(values.GetSize());
  using ArrayValue = typename Array::ValueType;
  static_assert(sizeof(ArrayValue) == sizeof(Value));
  array->SetArray(
    reinterpret_cast<ArrayValue*>(values.Release()), size, 0, Array::VTK_DATA_ARRAY_FREE);
  return array;
}

} // namespace

int AreaSign(const double* coordinates, const std::int64_t* corners, std::size_t count)
{
  const double* origin = coordinates + 3 * corners[0];
  double area = 0.0;
  double magnitude = 0.0;
  for (std::size_t i = 1; i + 1 < count; ++i)
  {
    const double* p = coordinates + 3 * corners[i];
    const double* q = coordinates + 3 * corners[i + 1];
    const double left = (p[0] - origin[0]) * (q[1] - origin[1]);
    const double right = (q[0] - origin[0]) * (p[1] - origin[1]);
    area += left - right;
    magnitude += std::abs(left) + std::abs(right);
  }
  // Each product has a relative error of at most 3 eps (two differences, one product), the sum
  // adds at most one eps a term: a bound twice as large as that is safe.
  const double bound =
    2.0 * (static_cast<double>(count) + 3.0) * std::numeric_limits<double>::epsilon() * magnitude;
  if (area > bound || area < -bound)
  {
    return area > 0.0 ? 1 : -1;
  }
  return ExactAreaSign(coordinates, corners, count);
}

void ReverseClockwiseElements(vtkPolyData* mesh)
{
  if (mesh->GetNumberOfCells() == 0)
  {
    return; // of a case that failed
  }
  auto* points = vtkDoubleArray::SafeDownCast(mesh->GetPoints()->GetData());
  const double* coordinates = points->GetPointer(0);
  vtkCellArray* polygons = mesh->GetPolys();
  polygons->ConvertTo64BitStorage();
  const vtkTypeInt64* offsets = polygons->GetOffsetsArray64()->GetPointer(0);
  static_assert(sizeof(vtkTypeInt64) == sizeof(std::int64_t));
  auto* connectivity =
    reinterpret_cast<std::int64_t*>(polygons->GetConnectivityArray64()->GetPointer(0));
  for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
  {
    std::int64_t* first = connectivity + offsets[i];
    std::int64_t* last = connectivity + offsets[i + 1];
    if (AreaSign(coordinates, first, static_cast<std::size_t>(last - first)) < 0)
    {
      std::reverse(first + 1, last);
    }
  }
}

bool MeshBuilder::LooksSecondOrder()
{
  const std::int64_t* corners = this->Connectivity.GetData() + this->Connectivity.GetSize() - 6;
  const auto isMiddle = [&](int middle, int a, int b)
  {
    const double* m = this->Coordinates.GetData() + 3 * corners[middle];
    const double* p = this->Coordinates.GetData() + 3 * corners[a];
    const double* q = this->Coordinates.GetData() + 3 * corners[b];
    const double miss = std::abs(p[0] + q[0] - 2.0 * m[0]) + std::abs(p[1] + q[1] - 2.0 * m[1]);
    return miss <= 1e-9 * (std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]));
  };
  return isMiddle(3, 1, 2) && isMiddle(4, 2, 0) && isMiddle(5, 0, 1); // Triangle's order
}

vtkSmartPointer<vtkPolyData> MeshBuilder::Take()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetData(TakeArray<vtkDoubleArray>(this->Coordinates, 3));
  vtkNew<vtkCellArray> polygons;
  auto offsets = TakeArray<vtkTypeInt64Array>(this->Offsets, 1);
  auto connectivity = TakeArray<vtkTypeInt64Array>(this->Connectivity, 1);
  polygons->SetData(offsets, connectivity);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polygons);
  return mesh;
}

} // namespace pemesh
