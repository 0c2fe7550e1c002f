// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SvgText.h"

#include "NumberText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace pemesh
{

namespace
{

using Attributes = std::vector<std::pair<std::string, std::string>>;

/** Initial values, or values without meaning for what is drawn here. */
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> Initial{ {
  { "stroke", "none" },
  { "fill-rule", "nonzero" },
  { "fill-opacity", "1" },
  { "stroke-opacity", "1" },
  { "stroke-linecap", "butt" },
  { "stroke-linejoin", "miter" },
  { "stroke-miterlimit", "10" }, // of round joins
  { "stroke-miterlimit", "4" },
} };

std::string_view Trimmed(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(" \n");
  return first == std::string_view::npos
    ? std::string_view()
    : text.substr(first, text.find_last_not_of(" \n") - first + 1);
}

/** "rgb(100%,50%,0%)" as "#ff8000"; any other text as it is. */
std::string ShortColor(std::string_view text)
{
  constexpr std::string_view head = "rgb(";
  if (!text.starts_with(head))
  {
    return std::string(text);
  }
  constexpr const char* digits = "0123456789abcdef";
  std::string color = "#";
  for (std::size_t start = head.size(); start < text.size() && color.size() < 7;)
  {
    const std::size_t end = text.find('%', start);
    const auto part = end == std::string_view::npos
      ? std::nullopt
      : ParseNumber(std::string(text.substr(start, end - start)));
    if (!part)
    {
      return std::string(text);
    }
    const long byte = std::clamp(std::lround(*part * 2.55), 0L, 255L);
    color += digits[byte / 16];
    color += digits[byte % 16];
    start = end + 2; // after "%," or "%)"
  }
  return color.size() == 7 ? color : std::string(text);
}

/** Writes a path in whole steps of a grid, relative to the last point: short, and without drift. */
class PathWriter
{
public:
  explicit PathWriter(double unit)
    : Unit(unit)
  {
  }

  void Point(char command, double x, double y)
  {
    const long long next[2] = { std::llround(x * this->Unit), std::llround(y * this->Unit) };
    const bool isMove = command == 'M';
    this->Command(isMove ? 'M' : command);
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Number(isMove ? next[axis] : next[axis] - this->Pen[axis]);
      this->Last[axis] = next[axis];
      this->Start[axis] = isMove ? next[axis] : this->Start[axis];
    }
  }

  /** What follows is relative to the last point, which a curve has only at its end. */
  void Arrive() { std::copy_n(this->Last, 2, this->Pen); }

  void Close()
  {
    this->Text += 'Z';
    this->Current = 'Z';
    std::copy_n(this->Start, 2, this->Pen);
  }

  std::string Text;

private:
  void Command(char command)
  {
    if (command != this->Current || command == 'M')
    {
      this->Text += command;
      this->AfterNumber = false;
    }
    this->Current = command;
  }

  void Number(long long steps)
  {
    std::string digits = FormatNumber(static_cast<double>(steps) / this->Unit);
    if (const std::size_t zero = digits.find("0."); zero == 0 || (zero == 1 && digits[0] == '-'))
    {
      digits.erase(zero, 1);
    }
    this->Text += this->AfterNumber && digits.front() != '-' ? " " : "";
    this->Text += digits;
    this->AfterNumber = true;
  }

  double Unit; // steps in a unit of coordinates
  char Current = 0;
  bool AfterNumber = false;
  long long Pen[2] = { 0, 0 };
  long long Last[2] = { 0, 0 };
  long long Start[2] = { 0, 0 };
};

std::vector<std::string_view> SplitWords(std::string_view text)
{
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(' '); at != std::string_view::npos;)
  {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    words.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(' ', end);
  }
  return words;
}

/** A path of Cairo (commands M, L, C and Z with absolute coordinates); others as they are. */
std::string ShortPath(std::string_view path, double unit)
{
  std::vector<std::string_view> words = SplitWords(path);
  // Cairo ends closed paths by moving to where they began.
  if (words.size() > 3 && words[words.size() - 3] == "M" && words[words.size() - 4] == "Z")
  {
    words.resize(words.size() - 3);
  }
  PathWriter writer(unit);
  for (std::size_t at = 0; at < words.size();)
  {
    const std::string_view command = words[at++];
    const std::size_t points = command == "M" || command == "L" ? 1 : command == "C" ? 3 : 0;
    if (command != "Z" && points == 0)
    {
      return std::string(path);
    }
    if (command == "Z")
    {
      writer.Close();
      continue;
    }
    for (std::size_t i = 0; i < points; ++i, at += 2)
    {
      const auto x = at + 1 < words.size() ? ParseNumber(words[at]) : std::nullopt;
      const auto y = at + 1 < words.size() ? ParseNumber(words[at + 1]) : std::nullopt;
      if (!x || !y)
      {
        return std::string(path);
      }
      writer.Point(command == "M" ? 'M' : command == "L" ? 'l' : 'c', *x, *y);
    }
    writer.Arrive();
  }
  return writer.Text;
}

/** Of a tag "<path … />"; nothing if it has another form. */
std::optional<Attributes> ReadAttributes(std::string_view tag)
{
  Attributes attributes;
  constexpr std::string_view head = "<path";
  for (std::size_t at = tag.find_first_not_of(" \n", head.size()); tag[at] != '/';
       at = tag.find_first_not_of(" \n", at))
  {
    const std::size_t equals = tag.find("=\"", at);
    const std::size_t end = equals == std::string_view::npos ? equals : tag.find('"', equals + 2);
    if (end == std::string_view::npos || end + 1 >= tag.size())
    {
      return std::nullopt;
    }
    attributes.emplace_back(tag.substr(at, equals - at), tag.substr(equals + 2, end - equals - 2));
    at = end + 1;
  }
  return attributes;
}

/** The properties of a style as attributes. */
void AppendStyle(std::string_view style, Attributes& attributes)
{
  while (!style.empty())
  {
    const std::size_t end = std::min(style.find(';'), style.size());
    const std::size_t colon = std::min(style.find(':'), end);
    const std::string_view name = Trimmed(style.substr(0, colon));
    const std::string_view value =
      Trimmed(style.substr(std::min(colon + 1, end), end - std::min(colon + 1, end)));
    style.remove_prefix(std::min(end + 1, style.size()));
    if (!name.empty() &&
      std::find(Initial.begin(), Initial.end(), std::pair(name, value)) == Initial.end())
    {
      attributes.emplace_back(name, ShortColor(value));
    }
  }
}

/** Writes tags; strokes that are alike but for colour and width share a group. */
class SvgWriter
{
public:
  void Path(std::string_view tag)
  {
    const std::optional<Attributes> read = ReadAttributes(tag);
    if (!read)
    {
      this->Other(tag);
      return;
    }
    std::string transform;
    std::string path;
    Attributes attributes;
    bool isStyled = false;
    for (const auto& [name, value] : *read)
    {
      if (name == "style")
      {
        isStyled = true;
        AppendStyle(value, attributes);
      }
      else if (name == "d")
      {
        path = value;
      }
      else if (name == "transform")
      {
        transform = value;
      }
      else
      {
        attributes.emplace_back(name, value);
      }
    }
    // Strokes in one transformation share all but their colour and width.
    const bool isShared = isStyled && !transform.empty();
    std::string shared = isShared ? " transform=\"" + transform + "\"" : std::string();
    std::string own = isShared || transform.empty() ? "" : " transform=\"" + transform + "\"";
    for (const auto& [name, value] : attributes)
    {
      const bool isOwn =
        name == "stroke" || name == "stroke-width" || (name == "fill" && value != "none");
      (isShared && !isOwn ? shared : own) += " " + name + "=\"" + value + "\"";
    }
    this->Group(shared);
    this->Text += "<path" + own;
    // Transformed coordinates are in units far below a point.
    this->Text += " d=\"" + ShortPath(path, transform.empty() ? 1000.0 : 100.0) + "\"/>";
  }

  void Other(std::string_view text)
  {
    this->Group("");
    this->Text += text;
  }

  /** Blanks between tags. */
  void Space(std::string_view text) { this->Text += text.find('\n') < text.size() ? "\n" : ""; }

  std::string Text;

private:
  void Group(const std::string& attributes)
  {
    if (attributes == this->Open)
    {
      return;
    }
    this->Text += this->Open.empty() ? "" : "</g>\n";
    this->Text += attributes.empty() ? "" : "<g" + attributes + ">\n";
    this->Open = attributes;
  }

  std::string Open; // the attributes of the group that is open
};

} // namespace

std::string RenumberIds(std::string_view svg)
{
  constexpr std::string_view openings[] = { " id=\"", "href=\"#", "url(#" };
  std::map<std::string, std::string, std::less<>> names;
  std::string result;
  std::size_t position = 0;
  while (position < svg.size())
  {
    std::size_t start = std::string_view::npos;
    for (const std::string_view opening : openings)
    {
      const std::size_t found = svg.find(opening, position);
      start = std::min(start, found == std::string_view::npos ? found : found + opening.size());
    }
    if (start == std::string_view::npos)
    {
      break;
    }
    const std::size_t end = std::min(svg.find_first_of("\")", start), svg.size());
    const std::string name(svg.substr(start, end - start));
    const auto known = names.emplace(name, "i" + std::to_string(names.size())).first;
    result += svg.substr(position, start - position);
    result += known->second;
    position = end;
  }
  result += svg.substr(position);
  return result;
}

std::string CompactSvg(std::string_view svg)
{
  SvgWriter writer;
  while (!svg.empty())
  {
    const bool isTag = svg.front() == '<';
    const std::size_t close = svg.find(isTag ? '>' : '<');
    const std::size_t length =
      close == std::string_view::npos ? svg.size() : close + (isTag ? 1 : 0);
    const std::string_view part = svg.substr(0, length);
    svg.remove_prefix(length);
    if (part.starts_with("<path ") && part.ends_with("/>"))
    {
      writer.Path(part);
    }
    else if (part.starts_with("<image "))
    {
      // Cells stay cells: browsers smooth images otherwise.
      writer.Other("<image style=\"image-rendering:pixelated\" ");
      writer.Other(part.substr(std::string_view("<image ").size()));
    }
    else if (!isTag && Trimmed(part).empty())
    {
      writer.Space(part);
    }
    else
    {
      writer.Other(part);
    }
  }
  return writer.Text;
}

} // namespace pemesh
