// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * HTML as a type of its own: a text becomes HTML only by HtmlText(), which escapes it, so that
 * nothing a user wrote can be taken for markup. What comes out is well-formed XML too.
 */
#ifndef pemesh_HtmlText_h
#define pemesh_HtmlText_h

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pemesh
{

class Html
{
public:
  Html() = default;

  const std::string& GetText() const { return this->Text; }
  bool IsEmpty() const { return this->Text.empty(); }

  Html& operator+=(const Html& other)
  {
    this->Text += other.Text;
    return *this;
  }
  friend Html operator+(Html a, const Html& b) { return a += b; }

private:
  explicit Html(std::string text)
    : Text(std::move(text))
  {
  }
  friend Html HtmlText(std::string_view text);
  friend Html HtmlElement(
    const std::string&, const std::vector<std::pair<std::string, std::string>>&, const Html&);
  friend Html HtmlRaw(const char* element, const char* text);

  std::string Text;
};

/** The text with markup escaped, control characters as blanks, bytes that are no UTF-8 as U+FFFD.
 */
Html HtmlText(std::string_view text);

using HtmlAttributes = std::vector<std::pair<std::string, std::string>>;

/** `<name attributes>content</name>`; elements that HTML knows as empty are closed at once. */
Html HtmlElement(
  const std::string& name, const HtmlAttributes& attributes = {}, const Html& content = {});

/** The same with a text alone in it. */
Html HtmlElement(const std::string& name, std::string_view text);

/** A style or script of the program's own; `text` must hold neither < nor &. */
Html HtmlRaw(const char* element, const char* text);

/** A list of paragraphs, one a line of text. */
Html HtmlParagraph(std::string_view text);

/** A table with a caption; rows of cells, those that are numbers right-aligned. */
struct HtmlTable
{
  std::string Caption;
  std::vector<std::string> Head;
  std::vector<std::vector<std::string>> Rows;
  bool IsSortable = false;
};
Html FormatTable(const HtmlTable& table);

/** The bytes of a file as an address that holds them (RFC 2397). */
std::string DataAddress(const std::string& mediaType, const std::string& bytes);

/** The same of an XML text, which takes less; quotation marks become apostrophes. */
std::string TextAddress(const std::string& mediaType, std::string_view text);

} // namespace pemesh

#endif
