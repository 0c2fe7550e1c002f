// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * MAT files of MATLAB and Octave with a mesh in the variables by which codes of the field know it:
 *
 *   vertices, elements, boundary  Sutton, The virtual element method in 50 lines of MATLAB, Numer.
 *                                 Algorithms 75 (2017) 1141-1159
 *   node, elem                    Chen, iFEM (2009), triangles as a matrix; Yu, mVEM (2021), cells
 *   Node, Element                 Talischi et al., PolyMesher, SMO 45 (2012) 309-328
 *
 * Elements are a cell array of vectors, or a matrix with a row for each, filled up with NaN; both
 * count vertices from 1. Other variables are skipped.
 */
#include "FormatFunctions.h"

#include "BoundaryVertices.h"
#include "ElementAccess.h"
#include "MatFileCheck.h"
#include "MeshBuilder.h"
#include "MeshText.h"
#include "TextFile.h"

#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include <vtkPolyData.h>

#include <matio.h>

namespace pemesh
{

namespace
{

struct MatNames
{
  const char* Vertices;
  const char* Elements;
};

constexpr std::array KnownNames{ MatNames{ "vertices", "elements" }, MatNames{ "node", "elem" },
  MatNames{ "Node", "Element" } };

struct FileCloser
{
  void operator()(mat_t* file) const { Mat_Close(file); }
};
struct VariableFreer
{
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using MatFile = std::unique_ptr<mat_t, FileCloser>;
using MatVariable = std::unique_ptr<matvar_t, VariableFreer>;

/** The values of a real matrix, column by column; false where it is none. */
template <typename Value>
void AppendValues(const matvar_t& matrix, std::vector<double>& values)
{
  const auto* first = static_cast<const Value*>(matrix.data);
  values.assign(first, first + matrix.nbytes / sizeof(Value));
}

struct NumberClass
{
  matio_classes Class;
  std::size_t Size;
  void (*Append)(const matvar_t& matrix, std::vector<double>& values);
};

constexpr std::array NumberClasses{ NumberClass{ MAT_C_DOUBLE, 8, AppendValues<double> },
  NumberClass{ MAT_C_SINGLE, 4, AppendValues<float> },
  NumberClass{ MAT_C_INT8, 1, AppendValues<std::int8_t> },
  NumberClass{ MAT_C_UINT8, 1, AppendValues<std::uint8_t> },
  NumberClass{ MAT_C_INT16, 2, AppendValues<std::int16_t> },
  NumberClass{ MAT_C_UINT16, 2, AppendValues<std::uint16_t> },
  NumberClass{ MAT_C_INT32, 4, AppendValues<std::int32_t> },
  NumberClass{ MAT_C_UINT32, 4, AppendValues<std::uint32_t> },
  NumberClass{ MAT_C_INT64, 8, AppendValues<std::int64_t> },
  NumberClass{ MAT_C_UINT64, 8, AppendValues<std::uint64_t> } };

class MatReader
{
public:
  explicit MatReader(const std::filesystem::path& path)
    : Path(path)
  {
  }

  vtkSmartPointer<vtkPolyData> Read()
  {
    CheckMatFile(this->Path);
    const MatFile file(Mat_Open(this->Path.c_str(), MAT_ACC_RDONLY));
    if (!file)
    {
      FailMeshFile(this->Path, "cannot be opened as a MAT file");
    }
    for (const MatNames& names : KnownNames)
    {
      const MatVariable vertices(Mat_VarRead(file.get(), names.Vertices));
      const MatVariable elements(Mat_VarRead(file.get(), names.Elements));
      if (vertices && elements)
      {
        this->ReadVertices(*vertices);
        this->ReadElements(*elements);
        return this->Mesh.Take();
      }
    }
    FailMeshFile(this->Path,
      "holds no mesh: the variables vertices and elements, node and elem, or Node and Element");
  }

private:
  [[noreturn]] void Fail(const matvar_t& variable, const std::string& what) const
  {
    FailMeshFile(
      this->Path, "has the variable " + std::string(variable.name ? variable.name : "") + what);
  }

  /** Whether the variable is a real matrix; its values, column by column. */
  static bool ReadMatrix(const matvar_t* matrix, std::vector<double>& values)
  {
    values.clear();
    if (!matrix || matrix->rank != 2 || matrix->isComplex)
    {
      return false;
    }
    const std::size_t count = matrix->dims[0] * matrix->dims[1];
    for (const NumberClass& numbers : NumberClasses)
    {
      if (matrix->class_type == numbers.Class)
      {
        const bool isWhole = matrix->data && matrix->nbytes == count * numbers.Size;
        if (isWhole)
        {
          numbers.Append(*matrix, values);
        }
        return isWhole || count == 0;
      }
    }
    return false;
  }

  void ReadVertices(const matvar_t& variable)
  {
    std::vector<double> values;
    if (!ReadMatrix(&variable, values) || variable.dims[1] < 2 || variable.dims[1] > 3)
    {
      this->Fail(variable, ", which is no real matrix with two columns");
    }
    const std::size_t rows = variable.dims[0];
    this->Mesh.ReserveVertices(rows);
    for (std::size_t i = 0; i < rows; ++i)
    {
      const double x = values[i];
      const double y = values[rows + i];
      const double z = variable.dims[1] == 3 ? values[2 * rows + i] : 0.0;
      if (!std::isfinite(x) || !std::isfinite(y) || z != 0.0)
      {
        this->Fail(variable,
          ", whose row " + std::to_string(i + 1) + " is no finite point of the plane z = 0");
      }
      this->Mesh.AddVertex(x, y);
    }
  }

  void ReadElements(const matvar_t& variable)
  {
    std::vector<double> values;
    if (variable.class_type == MAT_C_CELL)
    {
      auto* const* cells = static_cast<matvar_t* const*>(variable.data);
      const std::size_t count = cells ? variable.nbytes / sizeof(matvar_t*) : 0;
      for (std::size_t i = 0; i < count; ++i)
      {
        const bool isVector =
          ReadMatrix(cells[i], values) && (cells[i]->dims[0] == 1 || cells[i]->dims[1] == 1);
        if (!isVector)
        {
          this->Fail(
            variable, ", whose cell " + std::to_string(i + 1) + " is no vector of numbers");
        }
        this->AddElement(variable, i, values);
      }
    }
    else if (ReadMatrix(&variable, values))
    {
      std::vector<double> row;
      for (std::size_t i = 0; i < variable.dims[0]; ++i)
      {
        row.clear();
        for (std::size_t j = 0; j < variable.dims[1]; ++j)
        {
          row.push_back(values[j * variable.dims[0] + i]);
        }
        while (!row.empty() && std::isnan(row.back()))
        {
          row.pop_back();
        }
        this->AddElement(variable, i, row);
      }
    }
    if (this->Mesh.GetNumberOfElements() == 0)
    {
      this->Fail(
        variable, ", which holds no elements: neither a cell array of vectors nor a matrix");
    }
  }

  void AddElement(const matvar_t& variable, std::size_t element, const std::vector<double>& corners)
  {
    const std::string start = ", whose element " + std::to_string(element + 1);
    if (corners.size() < 3)
    {
      this->Fail(variable, start + " has fewer than three vertices");
    }
    const auto vertices = static_cast<double>(this->Mesh.GetNumberOfVertices());
    for (const double corner : corners)
    {
      if (!(corner >= 1.0 && corner <= vertices) || corner != std::floor(corner))
      {
        this->Fail(variable,
          start + " uses a vertex that is none of 1 to " +
            std::to_string(this->Mesh.GetNumberOfVertices()));
      }
      this->Mesh.AddCorner(static_cast<std::int64_t>(corner) - 1);
    }
    this->Mesh.EndElement();
  }

  const std::filesystem::path& Path;
  MeshBuilder Mesh;
};

/** A copy of the values as a real matrix, given column by column. */
matvar_t* MakeMatrix(const char* name, std::vector<double> values, std::size_t columns)
{
  std::size_t dimensions[2] = { values.size() / columns, columns };
  return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dimensions, values.data(), 0);
}

matvar_t* MakeVertices(const char* name, vtkPolyData* mesh)
{
  const auto count = static_cast<std::size_t>(mesh->GetNumberOfPoints());
  std::vector<double> values(2 * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    double point[3];
    mesh->GetPoint(static_cast<vtkIdType>(i), point);
    values[i] = point[0];
    values[count + i] = point[1];
  }
  return MakeMatrix(name, std::move(values), 2);
}

/** A column of cells, each a row of vertices. */
matvar_t* MakeElements(const char* name, vtkPolyData* mesh)
{
  ElementAccess elements(mesh);
  std::vector<matvar_t*> cells;
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < elements.GetNumberOfElements(); ++i)
  {
    elements.GetVertexIds(i, ids);
    std::vector<double> corners;
    for (const vtkIdType id : ids)
    {
      corners.push_back(static_cast<double>(id + 1));
    }
    const std::size_t columns = corners.size();
    cells.push_back(MakeMatrix(nullptr, std::move(corners), columns));
  }
  std::size_t dimensions[2] = { cells.size(), 1 };
  return Mat_VarCreate(name, MAT_C_CELL, MAT_T_CELL, 2, dimensions, cells.data(), 0);
}

matvar_t* MakeBoundary(vtkPolyData* mesh)
{
  const std::vector<char> markers = MarkBoundaryVertices(mesh);
  std::vector<double> vertices;
  for (std::size_t i = 0; i < markers.size(); ++i)
  {
    if (markers[i])
    {
      vertices.push_back(static_cast<double>(i + 1));
    }
  }
  return MakeMatrix("boundary", std::move(vertices), 1);
}

void WriteVariables(const std::filesystem::path& path, const std::vector<MatVariable>& variables)
{
  WriteFileSafely(path,
    [&](const std::filesystem::path& temporary)
    {
      // The text of the head would have the date.
      const MatFile file(
        Mat_CreateVer(temporary.c_str(), "MATLAB 5.0 MAT-file, PEMesh", MAT_FT_MAT5));
      bool isGood = file != nullptr;
      for (const MatVariable& variable : variables)
      {
        isGood =
          isGood && variable && Mat_VarWrite(file.get(), variable.get(), MAT_COMPRESSION_NONE) == 0;
      }
      if (!isGood)
      {
        throw std::runtime_error("Cannot write \"" + path.string() + "\": matio refuses.");
      }
    });
}

} // namespace

vtkSmartPointer<vtkPolyData> ReadMat(const std::filesystem::path& path)
{
  return MatReader(path).Read();
}

void WriteMat(const std::filesystem::path& path, vtkPolyData* mesh)
{
  CheckWritable(path, mesh);
  std::vector<MatVariable> variables;
  variables.emplace_back(MakeVertices("vertices", mesh));
  variables.emplace_back(MakeElements("elements", mesh));
  variables.emplace_back(MakeBoundary(mesh));
  WriteVariables(path, variables);
}

void WriteMatNodeElem(const std::filesystem::path& path, vtkPolyData* mesh)
{
  CheckWritable(path, mesh);
  std::vector<MatVariable> variables;
  variables.emplace_back(MakeVertices("node", mesh));
  variables.emplace_back(MakeElements("elem", mesh));
  WriteVariables(path, variables);
}

} // namespace pemesh
