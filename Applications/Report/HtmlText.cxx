// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "HtmlText.h"

#include "NumberText.h"

#include <algorithm>
#include <array>

namespace pemesh
{

namespace
{

/** Length of the UTF-8 character that begins here, or 0 where there is none. */
std::size_t CharacterLength(std::string_view text)
{
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t length = lead < 0x80 ? 1
    : lead >= 0xC2 && lead < 0xE0        ? 2
    : lead >= 0xE0 && lead < 0xF0        ? 3
    : lead >= 0xF0 && lead < 0xF5        ? 4
                                         : 0;
  if (length == 0 || length > text.size())
  {
    return 0;
  }
  unsigned code = lead & (length == 1 ? 0x7FU : 0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i)
  {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xC0U) != 0x80U)
    {
      return 0;
    }
    code = code << 6 | (next & 0x3FU);
  }
  const bool isOverlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool isForbidden =
    (code >= 0xD800 && code < 0xE000) || code > 0x10FFFF || code == 0xFFFE || code == 0xFFFF;
  return isOverlong || isForbidden ? 0 : length;
}

std::string Escape(std::string_view text, bool isAttribute = false)
{
  std::string escaped;
  while (!text.empty())
  {
    const std::size_t length = CharacterLength(text);
    const char c = text.front();
    if (length == 0)
    {
      escaped += "\xEF\xBF\xBD"; // U+FFFD, the replacement character
    }
    else if (length > 1)
    {
      escaped += text.substr(0, length);
    }
    else if (c == '&' || c == '<' || c == '"' || (!isAttribute && (c == '>' || c == '\'')))
    {
      escaped += c == '&' ? "&amp;"
        : c == '<'        ? "&lt;"
        : c == '>'        ? "&gt;"
        : c == '"'        ? "&quot;"
                          : "&#39;";
    }
    else
    {
      escaped += static_cast<unsigned char>(c) < 0x20 && c != '\n' ? ' ' : c;
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return escaped;
}

constexpr std::array<const char*, 4> EmptyElements{ "br", "img", "meta", "col" };

} // namespace

Html HtmlText(std::string_view text)
{
  return Html(Escape(text));
}

Html HtmlElement(const std::string& name, const HtmlAttributes& attributes, const Html& content)
{
  std::string text = "<" + name;
  for (const auto& [key, value] : attributes)
  {
    text += " " + key + "=\"" + Escape(value, true) + "\"";
  }
  const bool isEmpty =
    std::find(EmptyElements.begin(), EmptyElements.end(), name) != EmptyElements.end();
  return Html(text + (isEmpty ? "/>" : ">" + content.GetText() + "</" + name + ">\n"));
}

Html HtmlElement(const std::string& name, std::string_view text)
{
  return HtmlElement(name, HtmlAttributes(), HtmlText(text));
}

Html HtmlRaw(const char* element, const char* text)
{
  return Html("<" + std::string(element) + ">" + text + "</" + element + ">\n");
}

Html HtmlParagraph(std::string_view text)
{
  return HtmlElement("p", text);
}

Html FormatTable(const HtmlTable& table)
{
  Html head;
  for (const std::string& title : table.Head)
  {
    head += HtmlElement("th", { { "scope", "col" } }, HtmlText(title));
  }
  Html rows;
  for (const std::vector<std::string>& row : table.Rows)
  {
    Html cells;
    for (const std::string& cell : row)
    {
      const bool isNumber = ParseNumber(cell).has_value();
      cells += HtmlElement("td",
        isNumber ? HtmlAttributes{ { "class", "number" } } : HtmlAttributes(), HtmlText(cell));
    }
    rows += HtmlElement("tr", {}, cells);
  }
  const Html content = HtmlElement("caption", table.Caption) +
    HtmlElement("thead", {}, HtmlElement("tr", {}, head)) + HtmlElement("tbody", {}, rows);
  // A wide table scrolls by itself, with the keyboard too, and not the whole page.
  return HtmlElement("div",
    { { "class", "wide" }, { "tabindex", "0" }, { "role", "region" },
      { "aria-label", table.Caption } },
    HtmlElement("table",
      table.IsSortable ? HtmlAttributes{ { "class", "sortable" } } : HtmlAttributes(), content));
}

std::string DataAddress(const std::string& mediaType, const std::string& bytes)
{
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text = "data:" + mediaType + ";base64,";
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k)
    {
      text += k <= count ? digits[group >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

std::string TextAddress(const std::string& mediaType, std::string_view bytes)
{
  constexpr const char* digits = "0123456789ABCDEF";
  std::string text = "data:" + mediaType + ";charset=utf-8,";
  const bool mayQuote = bytes.find('\'') == std::string_view::npos;
  for (const char c : bytes)
  {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' && mayQuote)
    {
      text += '\''; // which an attribute can hold, and which means the same
    }
    // What an address or an attribute cannot hold; blanks may stand.
    else if (byte < 0x20 || byte > 0x7E || std::string_view("\"#%&<").find(c) < 5)
    {
      text += { '%', digits[byte / 16], digits[byte % 16] };
    }
    else
    {
      text += c;
    }
  }
  return text;
}

} // namespace pemesh
