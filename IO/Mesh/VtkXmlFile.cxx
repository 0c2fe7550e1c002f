// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "VtkXmlFile.h"

#include "MeshText.h"
#include "TextFile.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
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
#include <vtkXMLDataReader.h>
#include <vtkXMLWriter.h>

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

/** The number in the quotes after `name` in a tag of XML, 0 where there is none. */
std::size_t NumberInTag(std::string_view tag, std::string_view name)
{
  const std::size_t at = tag.find(name);
  const std::size_t quote =
    at == std::string_view::npos ? at : tag.find_first_of("\"'", at + name.size());
  if (quote == std::string_view::npos)
  {
    return 0;
  }
  std::size_t value = 0;
  const auto result = std::from_chars(tag.data() + quote + 1, tag.data() + tag.size(), value);
  return result.ec == std::errc::result_out_of_range ? std::string_view::npos : value;
}

/** Calls `use` with each tag of the file, from < on, and keeps a block of it in memory. */
template <typename Use>
void ForEachTag(const std::filesystem::path& path, const Use& use)
{
  constexpr std::size_t blockSize = 1 << 20;
  std::ifstream file(path, std::ios::binary);
  std::string text; // what is left of the blocks before, then a block
  while (file)
  {
    const std::size_t kept = text.size();
    text.resize(kept + blockSize);
    file.read(text.data() + kept, blockSize);
    text.resize(kept + static_cast<std::size_t>(file.gcount()));
    std::size_t begin = text.find('<');
    while (begin != std::string::npos)
    {
      const std::size_t end = text.find('>', begin);
      if (end == std::string::npos)
      {
        break;
      }
      if (!use(std::string_view(text).substr(begin, end - begin)))
      {
        return;
      }
      begin = text.find('<', end);
    }
    // A tag that fills a whole block is none of VTK's.
    const bool goesOn = begin != std::string::npos && text.size() - begin < blockSize;
    text.erase(0, goesOn ? begin : text.size());
  }
}

/** VTK takes the memory that the counts of a file ask for before it reads: they must be such that
 * the file could hold them, with the best that its compressors do (zlib, 1 to 1032). */
void CheckCounts(const std::filesystem::path& path, const char* kind)
{
  ReadTextFile(path, 1); // says what is wrong where there is no such file
  constexpr std::uintmax_t mostCompression = 1032;
  const std::uintmax_t most = std::filesystem::file_size(path) * mostCompression;
  std::size_t components = 1;
  std::size_t largest = 0;
  ForEachTag(path,
    [&](std::string_view tag)
    {
      components = std::max(components, NumberInTag(tag, "NumberOfComponents"));
      for (const char* name : { "NumberOfPoints", "NumberOfCells", "NumberOfPolys", "NumberOfVerts",
             "NumberOfLines", "NumberOfStrips", "NumberOfTuples" })
      {
        largest = std::max(largest, NumberInTag(tag, name));
      }
      return tag.substr(0, 13) != "<AppendedData"; // behind it are bytes, not tags
    });
  if (largest > most / components)
  {
    FailMeshFile(
      path, std::string("cannot be read as ") + kind + ": it announces more than it can hold");
  }
}

} // namespace

void ReadVtkXml(const std::filesystem::path& path, vtkXMLDataReader* reader, const char* kind)
{
  CheckCounts(path, kind);
  const std::string start = std::string("cannot be read as ") + kind + ": ";
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
    FailMeshFile(path, start + "it is damaged");
  }
  if (errors.HasMessage() || reader->GetErrorCode() != 0)
  {
    FailMeshFile(path, start + errors.GetReason());
  }
}

void WriteVtkXml(const std::filesystem::path& path, vtkXMLWriter* writer, vtkDataObject* data)
{
  WriteFileSafely(path,
    [&](const std::filesystem::path& temporary)
    {
      ErrorCatcher errors;
      errors.Watch(writer);
      errors.Watch(writer->GetExecutive());
      writer->SetFileName(temporary.c_str());
      writer->SetInputData(data);
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

void CheckOffsets(const std::filesystem::path& path, vtkCellArray* cells, const char* kind)
{
  if (!cells->Visit(AreOffsetsValid{}))
  {
    FailMeshFile(
      path, std::string("cannot be read as ") + kind + ": the offsets of its polygons are wrong");
  }
}

void MakePointsPlanar(const std::filesystem::path& path, vtkPointSet* mesh)
{
  if (!mesh->GetPoints() || !vtkDoubleArray::SafeDownCast(mesh->GetPoints()->GetData()))
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    if (mesh->GetPoints())
    {
      points->DeepCopy(mesh->GetPoints()); // keeps the type of `points`
    }
    mesh->SetPoints(points);
  }
  auto* coordinates = vtkDoubleArray::SafeDownCast(mesh->GetPoints()->GetData());
  double* point = coordinates->GetPointer(0);
  for (vtkIdType i = 0; i < coordinates->GetNumberOfTuples(); ++i, point += 3)
  {
    if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || point[2] != 0.0)
    {
      FailMeshFile(path,
        "has a vertex, " + std::to_string(i) + ", that is not a finite point of the plane z = 0");
    }
    point[2] = 0.0;
  }
}

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

void CheckOnlyPolygons(const std::filesystem::path& path, vtkPolyData* mesh)
{
  if (mesh->GetNumberOfCells() != mesh->GetNumberOfPolys())
  {
    throw std::runtime_error("Cannot write \"" + path.string() +
      "\": the mesh has cells that are not polygons (vertices, lines or strips).");
  }
}

} // namespace pemesh
