// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshText.h"

#include "ElementAccess.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include <vtkCellArray.h>
#include <vtkPolyData.h>

namespace pemesh
{

namespace
{

/** A word of a file as it may appear in a message: short, and printable whatever the file holds. */
std::string Quoted(std::string_view word)
{
  constexpr std::size_t longest = 30;
  std::string text = "\"";
  for (const char c : word.substr(0, longest))
  {
    text += std::isprint(static_cast<unsigned char>(c)) ? c : '?';
  }
  text += word.size() > longest ? "…\"" : "\"";
  return text;
}

} // namespace

bool LineScanner::SkipJoinedEnd()
{
  const char* next = this->Position + 1;
  if (next != this->End && *next == '\r')
  {
    ++next;
  }
  if (next == this->End || *next != '\n')
  {
    return false;
  }
  this->Position = next + 1;
  ++this->Line;
  return true;
}

void LineScanner::SkipLineEnd()
{
  if (*this->Position == '\r' && this->Position + 1 != this->End && this->Position[1] == '\n')
  {
    ++this->Position;
  }
  ++this->Position;
  ++this->Line;
}

bool LineScanner::NextLine()
{
  // What is left of the line before is skipped: formats that mind call NeedLineEnd first.
  if (this->Started)
  {
    while (this->Position != this->End && *this->Position != '\n' && *this->Position != '\r')
    {
      ++this->Position;
    }
  }
  this->Started = true;
  while (this->Position != this->End)
  {
    if (!this->AtLineEnd())
    {
      return true;
    }
    while (this->Position != this->End && *this->Position != '\n' && *this->Position != '\r')
    {
      ++this->Position;
    }
    if (this->Position != this->End)
    {
      this->SkipLineEnd();
    }
  }
  return false;
}

void LineScanner::EndLine()
{
  while (this->Position != this->End && *this->Position != '\n' && *this->Position != '\r')
  {
    ++this->Position;
  }
  if (this->Position != this->End)
  {
    this->SkipLineEnd();
  }
  this->Started = false;
}

std::string_view LineScanner::TakeBytes(std::size_t count)
{
  if (count > this->BytesLeft())
  {
    this->Fail("the file ends before the " + std::to_string(count) + " bytes announced");
  }
  const std::string_view bytes(this->Position, count);
  this->Position += count;
  return bytes;
}

void LineScanner::NeedLine(const char* what)
{
  if (!this->NextLine())
  {
    this->Fail(std::string("the file ends where ") + what + " is expected");
  }
}

std::string_view LineScanner::PeekWord()
{
  if (this->AtLineEnd())
  {
    return {};
  }
  const char* end = this->Position;
  while (end != this->End && *end != ' ' && *end != '\t' && *end != '\n' && *end != '\r')
  {
    ++end;
  }
  return { this->Position, static_cast<std::size_t>(end - this->Position) };
}

std::string_view LineScanner::Word()
{
  const std::string_view word = this->PeekWord();
  this->Position += word.size();
  return word;
}

double LineScanner::Number(const char* what)
{
  if (this->AtLineEnd())
  {
    this->FailAtWord(what);
  }
  const char* first = this->Position;
  if (*first == '+' && first + 1 != this->End && first[1] != '-') // from_chars takes no plus
  {
    ++first;
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(first, this->End, value);
  if (error != std::errc() || !this->IsWordEnd(end))
  {
    this->FailAtWord(what);
  }
  this->Position = end;
  return value;
}

double LineScanner::Coordinate()
{
  const char* const start = this->Position;
  const double value = this->Number("a coordinate");
  if (!std::isfinite(value))
  {
    this->Position = start;
    this->FailAtWord("a finite coordinate");
  }
  return value;
}

void LineScanner::SkipNumber(const char* what)
{
  this->Number(what);
}

std::int64_t LineScanner::Integer(const char* what)
{
  if (this->AtLineEnd())
  {
    this->FailAtWord(what);
  }
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(this->Position, this->End, value);
  if (error != std::errc() || !this->IsWordEnd(end))
  {
    this->FailAtWord(what);
  }
  this->Position = end;
  return value;
}

std::int64_t LineScanner::Index(const char* what)
{
  std::int64_t value = 0;
  auto [end, error] = std::from_chars(this->Position, this->End, value);
  for (int part = 0; part < 2 && error == std::errc() && end != this->End && *end == '/'; ++part)
  {
    ++end;
    const bool empty = this->IsWordEnd(end) || *end == '/';
    if (!empty)
    {
      std::int64_t ignored = 0;
      const auto next = std::from_chars(end, this->End, ignored);
      end = next.ptr;
      error = next.ec;
    }
  }
  if (error != std::errc() || !this->IsWordEnd(end))
  {
    this->FailAtWord(what);
  }
  this->Position = end;
  return value;
}

void LineScanner::ZeroCoordinate()
{
  if (!this->AtLineEnd() && *this->Position == '0' && this->IsWordEnd(this->Position + 1))
  {
    ++this->Position; // by far the most frequent
    return;
  }
  const std::string_view word = this->PeekWord();
  if (this->Coordinate() != 0.0)
  {
    this->Fail("the third coordinate is " + Quoted(word) +
      " where a planar mesh has 0; project the mesh onto the plane z = 0 first");
  }
}

void LineScanner::NeedLineEnd(const char* after)
{
  if (!this->AtLineEnd())
  {
    this->Fail(Quoted(this->PeekWord()) + " follows " + after + ", where the line should end");
  }
}

void LineScanner::FailAtWord(const char* expected)
{
  const std::string_view word = this->PeekWord();
  this->Fail(word.empty() ? std::string("the line ends where ") + expected + " is expected"
                          : Quoted(word) + " is not " + expected);
}

void LineScanner::FailAt(std::size_t line, const std::string& what) const
{
  throw std::runtime_error(
    "\"" + this->Path.string() + "\", line " + std::to_string(line) + ": " + what + ".");
}

void FailMeshFile(const std::filesystem::path& path, const std::string& what)
{
  throw std::runtime_error("\"" + path.string() + "\" " + what + ".");
}

std::string CountText(std::int64_t count, const char* one, const char* many)
{
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

std::size_t GuessTextSize(vtkPolyData* mesh)
{
  constexpr std::size_t bytesOfVertex = 48; // two coordinates of 20 characters, and what is around
  constexpr std::size_t bytesOfCorner = 8;
  const vtkCellArray* polygons = mesh->GetPolys();
  return 4096 + bytesOfVertex * static_cast<std::size_t>(mesh->GetNumberOfPoints()) +
    bytesOfCorner *
    static_cast<std::size_t>(polygons->GetNumberOfConnectivityIds() + mesh->GetNumberOfPolys());
}

void AppendVertices(TextBuffer& text, std::string_view prefix, vtkPolyData* mesh)
{
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    text.Append(prefix);
    text.AppendValue(point[0]);
    text.Append(' ');
    text.AppendValue(point[1]);
    text.Append(" 0\n");
  }
}

void AppendElements(TextBuffer& text, vtkPolyData* mesh, vtkIdType first)
{
  ElementAccess elements(mesh);
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < elements.GetNumberOfElements(); ++i)
  {
    elements.GetVertexIds(i, ids);
    text.AppendValue(ids.size());
    for (const vtkIdType id : ids)
    {
      text.Append(' ');
      text.AppendValue(id + first);
    }
    text.Append('\n');
  }
}

void CheckWritable(const std::filesystem::path& path, vtkPolyData* mesh)
{
  const std::string reason = ElementAccess::WhyUnusable(mesh);
  if (!reason.empty())
  {
    throw std::runtime_error("Cannot write \"" + path.string() + "\": " + reason + ".");
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || point[2] != 0.0)
    {
      throw std::runtime_error("Cannot write \"" + path.string() + "\": vertex " +
        std::to_string(i) + " is not a finite point of the plane z = 0.");
    }
  }
}

} // namespace pemesh
