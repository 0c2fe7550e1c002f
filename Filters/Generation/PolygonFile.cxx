// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PolygonFile.h"

#include "ElementAccess.h"
#include "MeshFormats.h"
#include "NumberText.h"
#include "PolygonMeasures.h"
#include "TextFile.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace pemesh
{

namespace
{

constexpr std::string_view Blanks = " \t\r\v\f";
constexpr std::array<std::string_view, 3> TableExtensions = { ".csv", ".txt", ".xy" };

char LowerCase(char c)
{
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::string_view Trim(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(Blanks);
  return first == std::string_view::npos
    ? std::string_view()
    : text.substr(first, text.find_last_not_of(Blanks) - first + 1);
}

/** The fields of a line: between semicolons if it has any, else between commas, else blanks. */
std::vector<std::string_view> SplitLine(std::string_view line)
{
  const char separator = line.find(';') != std::string_view::npos ? ';' : ',';
  const bool isSeparated = line.find(separator) != std::string_view::npos;
  std::vector<std::string_view> fields;
  while (true)
  {
    const std::size_t end = isSeparated ? line.find(separator) : line.find_first_of(Blanks);
    fields.push_back(Trim(line.substr(0, end)));
    if (end == std::string_view::npos)
    {
      return fields;
    }
    line = isSeparated ? line.substr(end + 1) : Trim(line.substr(end));
  }
}

bool IsHeader(const std::vector<std::string_view>& fields)
{
  const auto isWord = [](std::string_view field, char word)
  {
    if (field.size() == 3 && field.front() == '"' && field.back() == '"')
    {
      field = field.substr(1, 1);
    }
    return field.size() == 1 && LowerCase(field.front()) == word;
  };
  return fields.size() == 2 && isWord(fields[0], 'x') && isWord(fields[1], 'y');
}

void TurnCounterClockwise(std::vector<Point2>& polygon)
{
  if (PolygonOrientation(polygon) < 0)
  {
    std::reverse(polygon.begin() + 1, polygon.end());
  }
}

/** Takes the lines of a table of points one by one. */
class PointTable
{
public:
  explicit PointTable(const std::string& source)
    : Source(source)
  {
  }

  void TakeLine(std::string_view line)
  {
    ++this->Line;
    const std::string_view content = Trim(line.substr(0, line.find('#')));
    if (!content.empty())
    {
      this->TakePoint(content);
    }
    else if (Trim(line).empty()) // a line of comment alone ends nothing
    {
      this->EndPolygon();
    }
  }

  std::vector<std::vector<Point2>> Finish()
  {
    this->EndPolygon();
    if (this->Polygons.empty())
    {
      throw std::runtime_error(
        "\"" + this->Source + "\" holds no polygon: write one vertex a line, x,y.");
    }
    return std::move(this->Polygons);
  }

private:
  [[noreturn]] void Fail(std::size_t line, const std::string& what) const
  {
    throw std::runtime_error(
      "\"" + this->Source + "\", line " + std::to_string(line) + ": " + what + ".");
  }

  double ParseCoordinate(std::string_view field) const
  {
    const std::optional<double> number = ParseNumber(field);
    if (!number || !std::isfinite(*number))
    {
      const bool isDecimalComma = field.find(',') != std::string_view::npos;
      this->Fail(this->Line,
        "\"" + std::string(field) + "\" is not a finite number" +
          (isDecimalComma ? "; write decimals with a point" : ""));
    }
    return *number;
  }

  void TakePoint(std::string_view content)
  {
    const std::vector<std::string_view> fields = SplitLine(content);
    const bool isFirst = !this->HasContent;
    this->HasContent = true;
    if (isFirst && IsHeader(fields))
    {
      return;
    }
    if (fields.size() != 2)
    {
      this->Fail(this->Line,
        std::to_string(fields.size()) + (fields.size() == 1 ? " value" : " values") +
          " where x and y are expected, with a comma, a semicolon or a blank between");
    }
    if (this->Polygon.empty())
    {
      this->FirstLine = this->Line;
    }
    this->Polygon.push_back({ this->ParseCoordinate(fields[0]), this->ParseCoordinate(fields[1]) });
  }

  void EndPolygon()
  {
    if (this->Polygon.empty())
    {
      return;
    }
    if (this->Polygon.size() > 1 && this->Polygon.front() == this->Polygon.back())
    {
      this->Polygon.pop_back();
    }
    if (this->Polygon.size() < 3)
    {
      this->Fail(this->FirstLine, "the polygon that begins here has fewer than three vertices");
    }
    TurnCounterClockwise(this->Polygon);
    this->Polygons.push_back(std::move(this->Polygon));
    this->Polygon.clear();
  }

  const std::string& Source;
  std::vector<std::vector<Point2>> Polygons;
  std::vector<Point2> Polygon;
  std::size_t Line = 0;
  std::size_t FirstLine = 0; ///< of the polygon that is being read
  bool HasContent = false;
};

std::vector<std::vector<Point2>> ElementsOf(const std::filesystem::path& path)
{
  const vtkSmartPointer<vtkPolyData> mesh = ReadMesh(path);
  ElementAccess access(mesh);
  std::vector<std::vector<Point2>> polygons(static_cast<std::size_t>(access.GetNumberOfElements()));
  if (polygons.empty())
  {
    throw std::runtime_error("\"" + path.string() + "\" holds no polygon.");
  }
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    access.GetVertices(static_cast<vtkIdType>(i), polygons[i]);
    if (polygons[i].size() < 3)
    {
      throw std::runtime_error("\"" + path.string() + "\": polygon " + std::to_string(i + 1) +
        " has fewer than three vertices.");
    }
    TurnCounterClockwise(polygons[i]);
  }
  return polygons;
}

} // namespace

std::vector<std::vector<Point2>> ParsePolygonPoints(
  std::string_view text, const std::string& source)
{
  constexpr std::string_view ByteOrderMark = "\xEF\xBB\xBF";
  if (text.substr(0, ByteOrderMark.size()) == ByteOrderMark)
  {
    text.remove_prefix(ByteOrderMark.size());
  }
  PointTable table(source);
  while (!text.empty())
  {
    const std::size_t end = text.find('\n');
    table.TakeLine(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return table.Finish();
}

std::vector<std::vector<Point2>> ReadPolygonFile(const std::filesystem::path& path)
{
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), LowerCase);
  const bool isTable =
    std::find(TableExtensions.begin(), TableExtensions.end(), extension) != TableExtensions.end();
  if (isTable)
  {
    return ParsePolygonPoints(ReadTextFile(path), path.string());
  }
  if (!FindMeshFormatOfFile(path))
  {
    throw std::runtime_error("\"" + path.string() +
      "\" has no extension of a file of polygons; known are .csv .txt .xy for points, and " +
      ListMeshExtensions() + " for meshes.");
  }
  return ElementsOf(path);
}

} // namespace pemesh
