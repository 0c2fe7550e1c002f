// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Reading and writing the text formats fast: one pass over the whole file in memory with
 * std::from_chars, which knows no locale, and std::to_chars into one buffer.
 */
#ifndef pemesh_MeshText_h
#define pemesh_MeshText_h

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include <vtkType.h> // For vtkIdType

class vtkPolyData;

namespace pemesh
{

/**
 * A text seen as lines of words. Blank lines and comments (from # to the end of the line) are
 * skipped; LF, CR and CR LF all end a line.
 */
class LineScanner
{
public:
  /** With `continuation`, a backslash at the end of a line joins the next one to it (OBJ). */
  LineScanner(std::string_view text, const std::filesystem::path& path, bool continuation = false)
    : Position(text.data())
    , End(text.data() + text.size())
    , Path(path)
    , Continuation(continuation)
  {
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    if (text.substr(0, byteOrderMark.size()) == byteOrderMark)
    {
      this->Position += byteOrderMark.size();
    }
  }

  /** Goes to the next line that holds anything; false at the end of the file. */
  bool NextLine();

  /** The same, but the end of the file is an error that says what is missing. */
  void NeedLine(const char* what);

  /** Skips blanks, and answers whether nothing more is on this line. */
  bool AtLineEnd()
  {
    while (this->Position != this->End)
    {
      const char c = *this->Position;
      if (c == ' ' || c == '\t')
      {
        ++this->Position;
        continue;
      }
      if (c == '\\' && this->Continuation && this->SkipJoinedEnd())
      {
        continue;
      }
      return c == '\n' || c == '\r' || c == '#';
    }
    return true;
  }

  /** The next word of the line, empty at its end. */
  std::string_view Word();

  /** The same without moving on. */
  std::string_view PeekWord();

  /** A finite number, else an error that says what it should have been. */
  double Coordinate();

  /** A number that is read and thrown away: attributes, colours. */
  void SkipNumber(const char* what);

  /** An integer, else an error that says what it should have been. */
  std::int64_t Integer(const char* what);

  /** The first integer of a corner of OBJ, "a", "a/b", "a//c" or "a/b/c"; the others are dropped.
   */
  std::int64_t Index(const char* what);

  /** A third coordinate, which must be zero. */
  void ZeroCoordinate();

  /** An error unless nothing more is on this line. */
  void NeedLineEnd(const char* after);

  /** Goes to the next line, wherever in this one it is, and no further, blank as it may be. */
  void EndLine();

  /** Goes on to the next line that holds anything where nothing more is on this one. */
  void NeedWord(const char* what)
  {
    if (this->AtLineEnd())
    {
      this->NeedLine(what);
    }
  }

  /** The next bytes whatever they are, after EndLine(); an error where there are not as many. */
  std::string_view TakeBytes(std::size_t count);

  /** How many bytes are left: no file holds more things than bytes. */
  std::size_t BytesLeft() const { return static_cast<std::size_t>(this->End - this->Position); }

  std::size_t GetLine() const { return this->Line; }

  /** "…: what.", naming the file and the line. */
  [[noreturn]] void Fail(const std::string& what) const { this->FailAt(this->Line, what); }
  [[noreturn]] void FailAt(std::size_t line, const std::string& what) const;

private:
  /** Whether a number that ends here is a whole word. */
  bool IsWordEnd(const char* end) const
  {
    return end == this->End || *end == ' ' || *end == '\t' || *end == '\n' || *end == '\r' ||
      *end == '#';
  }

  bool SkipJoinedEnd();
  void SkipLineEnd();
  double Number(const char* what);
  [[noreturn]] void FailAtWord(const char* expected);

  const char* Position;
  const char* End;
  std::filesystem::path Path;
  std::size_t Line = 1;
  bool Continuation;
  bool Started = false;
};

/** An error about a file as a whole. */
[[noreturn]] void FailMeshFile(const std::filesystem::path& path, const std::string& what);

/** "3 vertices", "1 vertex": for messages. */
std::string CountText(std::int64_t count, const char* one, const char* many);

/** Text being written: numbers go straight into the buffer. */
class TextBuffer
{
public:
  /** Room for this many bytes more; a guess that saves copying. */
  void Reserve(std::size_t bytes)
  {
    if (this->Text.size() - this->Size < bytes)
    {
      this->Text.resize(std::max(this->Size + bytes, this->Text.size() + this->Text.size() / 2));
    }
  }

  void Append(std::string_view text)
  {
    this->Reserve(text.size());
    text.copy(this->Text.data() + this->Size, text.size());
    this->Size += text.size();
  }

  void Append(char c)
  {
    this->Reserve(1);
    this->Text[this->Size++] = c;
  }

  template <typename Value>
  void AppendValue(Value value)
  {
    constexpr std::size_t longest = 32;
    this->Reserve(longest);
    char* first = this->Text.data() + this->Size;
    this->Size +=
      static_cast<std::size_t>(std::to_chars(first, first + longest, value).ptr - first);
  }

  std::string_view GetText() const { return { this->Text.data(), this->Size }; }

private:
  std::string Text;
  std::size_t Size = 0;
};

/** The bytes that a text file of the mesh may take, roughly. */
std::size_t GuessTextSize(vtkPolyData* mesh);

/** A line for each vertex: "x y 0" behind a prefix. */
void AppendVertices(TextBuffer& text, std::string_view prefix, vtkPolyData* mesh);

/** A line for each element: the number of its vertices and the vertices, counted from `first`. */
void AppendElements(TextBuffer& text, vtkPolyData* mesh, vtkIdType first);

/** Throws unless the mesh can be written as text: polygons only, finite, planar. */
void CheckWritable(const std::filesystem::path& path, vtkPolyData* mesh);

} // namespace pemesh

#endif
