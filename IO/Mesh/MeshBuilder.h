// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Collects vertices and elements from a file and hands them to VTK without a copy.
 */
#ifndef pemesh_MeshBuilder_h
#define pemesh_MeshBuilder_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

#include <vtkSmartPointer.h> // For return type

class vtkPolyData;

namespace pemesh
{

/** A growing array in memory of malloc, which VTK arrays can take over. */
template <typename Value>
class GrowingArray
{
public:
  GrowingArray() = default;
  GrowingArray(const GrowingArray&) = delete;
  GrowingArray& operator=(const GrowingArray&) = delete;
  ~GrowingArray() { std::free(this->Data); }

  void Reserve(std::size_t capacity)
  {
    if (capacity > this->Capacity)
    {
      this->Resize(capacity);
    }
  }

  void Append(Value value)
  {
    if (this->Size == this->Capacity)
    {
      this->Resize(std::max<std::size_t>(64, this->Capacity + this->Capacity / 2));
    }
    this->Data[this->Size++] = value;
  }

  std::size_t GetSize() const { return this->Size; }
  Value* GetData() { return this->Data; }
  Value& operator[](std::size_t i) { return this->Data[i]; }

  /** Gives the memory away, cut to size; to be freed with free(). */
  Value* Release()
  {
    this->Resize(std::max<std::size_t>(1, this->Size));
    Value* data = this->Data;
    this->Data = nullptr;
    this->Size = this->Capacity = 0;
    return data;
  }

private:
  void Resize(std::size_t capacity)
  {
    auto* data = static_cast<Value*>(std::realloc(this->Data, capacity * sizeof(Value)));
    if (!data)
    {
      throw std::bad_alloc();
    }
    this->Data = data;
    this->Capacity = capacity;
  }

  Value* Data = nullptr;
  std::size_t Size = 0;
  std::size_t Capacity = 0;
};

class MeshBuilder
{
public:
  MeshBuilder() { this->Offsets.Append(0); }

  /** Hints; a caller must have bounded them by the size of the file. */
  void ReserveVertices(std::size_t count) { this->Coordinates.Reserve(3 * count); }
  void ReserveElements(std::size_t count, std::size_t connectivity)
  {
    this->Offsets.Reserve(count + 1);
    this->Connectivity.Reserve(connectivity);
  }

  void AddVertex(double x, double y)
  {
    this->Coordinates.Append(x);
    this->Coordinates.Append(y);
    this->Coordinates.Append(0.0);
  }

  ///@{
  /** An element is its vertices, one by one, then the end. */
  void AddCorner(std::int64_t vertex) { this->Connectivity.Append(vertex); }
  void EndElement()
  {
    this->Offsets.Append(static_cast<std::int64_t>(this->Connectivity.GetSize()));
  }
  ///@}

  std::int64_t GetNumberOfVertices() const
  {
    return static_cast<std::int64_t>(this->Coordinates.GetSize() / 3);
  }
  std::int64_t GetNumberOfElements() const
  {
    return static_cast<std::int64_t>(this->Offsets.GetSize()) - 1;
  }

  /** Whether the last element, of six vertices, is a triangle and the middles of its sides. */
  bool LooksSecondOrder();

  /** The mesh, its elements as they were given. */
  vtkSmartPointer<vtkPolyData> Take();

private:
  GrowingArray<double> Coordinates;
  GrowingArray<std::int64_t> Offsets;
  GrowingArray<std::int64_t> Connectivity;
};

/** Reverses the elements that are clockwise; the others, and the first vertices, stay. Points must
 * be doubles, all vertex numbers in range. */
void ReverseClockwiseElements(vtkPolyData* mesh);

/**
 * The sign of the area of a polygon given by vertex numbers into x, y, z triples: exact (Shewchuk,
 * Adaptive Precision Floating-Point Arithmetic, Discrete Comput. Geom. 18 (1997) 305-363), but
 * where coordinates are so large or small that products overflow or underflow.
 */
int AreaSign(const double* coordinates, const std::int64_t* corners, std::size_t count);

} // namespace pemesh

#endif
