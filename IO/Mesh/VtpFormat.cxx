// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * VTP, VTK's XML format for vtkPolyData, with all arrays. Written as binary data in place, not
 * compressed: the same bytes for the same mesh. Appended data would be read and written faster, but
 * ParaView 5.11 cannot read them any more since libexpat defers parsing (its 2.6.0, and Debian 12's
 * 2.5.0-1+deb12u2; CVE-2023-52425).
 */
#include "FormatFunctions.h"

#include "ElementAccess.h"
#include "MeshText.h"
#include "TextFile.h"

#include <cmath>
#include <stdexcept>

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

namespace pemesh
{

namespace
{

/** Collects the first error of a VTK object instead of printing it. */
class ErrorCatcher
{
public:
  ErrorCatcher()
  {
    this->Command->SetClientData(&this->Message);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long event, void* client, void* text)
      {
        auto& message = *static_cast<std::string*>(client);
        if (event == vtkCommand::ErrorEvent && message.empty())
        {
          message = text ? static_cast<const char*>(text) : "unknown error";
        }
      });
  }

  void Watch(vtkObject* object)
  {
    object->AddObserver(vtkCommand::ErrorEvent, this->Command);
    object->AddObserver(vtkCommand::WarningEvent, this->Command); // kept quiet
  }

  vtkCallbackCommand* GetCommand() { return this->Command; }

  bool HasMessage() const { return !this->Message.empty(); }

  /** The last line that says anything, without VTK's file, address and full stop. */
  std::string GetReason() const
  {
    std::string text = this->Message;
    const std::size_t end = text.find_last_not_of(" \t\r\n.");
    text.resize(end == std::string::npos ? 0 : end + 1);
    const std::size_t line = text.find_last_of('\n');
    text.erase(0, line == std::string::npos ? 0 : line + 1);
    const std::size_t address = text.find("): ");
    text.erase(0, address == std::string::npos ? 0 : address + 3);
    return text.empty() ? "unknown error" : text;
  }

private:
  std::string Message;
  vtkNew<vtkCallbackCommand> Command;
};

struct AreOffsetsValid
{
  template <typename CellState>
  bool operator()(CellState& state) const
  {
    const auto* offsets = state.GetOffsets();
    const vtkIdType count = offsets->GetNumberOfValues();
    if (count == 0 || offsets->GetValue(0) != 0)
    {
      return count == 0;
    }
    for (vtkIdType i = 1; i < count; ++i)
    {
      if (offsets->GetValue(i) < offsets->GetValue(i - 1))
      {
        return false;
      }
    }
    return offsets->GetValue(count - 1) <= state.GetConnectivity()->GetNumberOfValues();
  }
};

/** The same values without the array's information: VTK keeps ranges there, once they were asked
 * for, and would write them, so that the bytes of a file would depend on who looked before. */
vtkSmartPointer<vtkAbstractArray> WithoutInformation(vtkAbstractArray* array)
{
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers)
  {
    return array; // texts have no ranges
  }
  auto copy = vtkSmartPointer<vtkDataArray>::Take(numbers->NewInstance());
  copy->ShallowCopy(numbers);
  if (copy->HasInformation())
  {
    copy->GetInformation()->Clear();
  }
  return copy;
}

void CopyArraysWithoutInformation(vtkFieldData* from, vtkFieldData* to)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    to->AddArray(WithoutInformation(from->GetAbstractArray(i)));
  }
}

/** A shallow copy that holds nothing but the mesh: no time, no ranges. */
vtkSmartPointer<vtkPolyData> BareCopy(vtkPolyData* mesh)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  if (mesh->GetPoints())
  {
    auto coordinates = WithoutInformation(mesh->GetPoints()->GetData());
    points->SetData(vtkDataArray::SafeDownCast(coordinates));
  }
  copy->SetPoints(points);
  vtkNew<vtkCellArray> polygons;
  const auto offsets = WithoutInformation(mesh->GetPolys()->GetOffsetsArray());
  const auto connectivity = WithoutInformation(mesh->GetPolys()->GetConnectivityArray());
  polygons->SetData(vtkDataArray::SafeDownCast(offsets), vtkDataArray::SafeDownCast(connectivity));
  copy->SetPolys(polygons);
  CopyArraysWithoutInformation(mesh->GetPointData(), copy->GetPointData());
  CopyArraysWithoutInformation(mesh->GetCellData(), copy->GetCellData());
  CopyArraysWithoutInformation(mesh->GetFieldData(), copy->GetFieldData());
  return copy;
}

/** Points in double precision, finite and planar; z is set to zero where it was -0. */
void MakePointsPlanar(const std::filesystem::path& path, vtkPolyData* mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  if (mesh->GetPoints())
  {
    points->DeepCopy(mesh->GetPoints()); // keeps the type of `points`
  }
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double point[3];
    points->GetPoint(i, point);
    if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || point[2] != 0.0)
    {
      FailMeshFile(path,
        "has a vertex, " + std::to_string(i) + ", that is not a finite point of the plane z = 0");
    }
    points->SetPoint(i, point[0], point[1], 0.0);
  }
  mesh->SetPoints(points);
}

} // namespace

vtkSmartPointer<vtkPolyData> ReadVtp(const std::filesystem::path& path)
{
  ReadTextFile(path, 1); // for its message where the file is missing or a folder
  vtkNew<vtkXMLPolyDataReader> reader;
  ErrorCatcher errors;
  errors.Watch(reader);
  errors.Watch(reader->GetExecutive());
  reader->SetReaderErrorObserver(errors.GetCommand());
  reader->SetParserErrorObserver(errors.GetCommand());
  reader->SetFileName(path.c_str());
  try
  {
    reader->Update();
  }
  catch (const std::exception&) // such as bad_alloc, after a size that makes no sense
  {
    FailMeshFile(path, "cannot be read as VTP: it is damaged");
  }
  if (errors.HasMessage() || reader->GetErrorCode() != 0)
  {
    FailMeshFile(path, "cannot be read as VTP: " + errors.GetReason());
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->ShallowCopy(reader->GetOutput());
  if (!mesh->GetPolys()->Visit(AreOffsetsValid{}))
  {
    FailMeshFile(path, "cannot be read as VTP: the offsets of its polygons are wrong");
  }
  MakePointsPlanar(path, mesh);
  if (mesh->GetNumberOfCells() == 0 && mesh->GetNumberOfPoints() == 0)
  {
    return mesh; // of a case that failed
  }
  const std::string reason = ElementAccess::WhyUnusable(mesh);
  if (!reason.empty())
  {
    FailMeshFile(path, "cannot be used: " + reason);
  }
  return mesh;
}

void WriteVtp(const std::filesystem::path& path, vtkPolyData* mesh)
{
  if (mesh->GetNumberOfCells() != mesh->GetNumberOfPolys())
  {
    throw std::runtime_error("Cannot write \"" + path.string() +
      "\": the mesh has cells that are not polygons (vertices, lines or strips).");
  }
  const auto bare = BareCopy(mesh);
  WriteFileSafely(path,
    [&](const std::filesystem::path& temporary)
    {
      vtkNew<vtkXMLPolyDataWriter> writer;
      ErrorCatcher errors;
      errors.Watch(writer);
      errors.Watch(writer->GetExecutive());
      writer->SetFileName(temporary.c_str());
      writer->SetInputData(bare);
      writer->SetDataModeToBinary();
      writer->SetCompressorTypeToNone();
      writer->SetHeaderTypeToUInt64();
      writer->SetByteOrderToLittleEndian();
      if (!writer->Write() || errors.HasMessage() || writer->GetErrorCode() != 0)
      {
        throw std::runtime_error(
          "Cannot write \"" + path.string() + "\": " + errors.GetReason() + ".");
      }
    });
}

} // namespace pemesh
