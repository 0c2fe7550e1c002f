// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Where in a document a value stands, for messages.
 */
#ifndef pemesh_DocumentPlace_h
#define pemesh_DocumentPlace_h

#include <stdexcept>
#include <string>

namespace pemesh
{

class DocumentPlace
{
public:
  explicit DocumentPlace(const std::string& source)
    : Source(source)
  {
  }

  /** A record of a table, whose members are columns: "line 3, column scale". */
  static DocumentPlace Record(const std::string& source, std::size_t line)
  {
    DocumentPlace place(source);
    place.Path = "line " + std::to_string(line);
    place.Separator = ", column ";
    return place;
  }

  DocumentPlace Member(const std::string& key) const
  {
    return this->At(this->Path.empty() ? key : this->Path + this->Separator + key);
  }

  DocumentPlace Item(std::size_t index) const
  {
    return this->At(this->Path + "[" + std::to_string(index) + "]");
  }

  ///@{
  /** Whether keys that do not apply where they stand are passed over instead of refused. */
  void SetForgiving(bool forgiving) { this->Forgiving = forgiving; }
  bool IsForgiving() const { return this->Forgiving; }
  ///@}

  /** "\"study.json\": mesh.min-angle " + what; `what` ends the sentence. */
  [[noreturn]] void Fail(const std::string& what) const
  {
    throw std::runtime_error("\"" + this->Source +
      "\": " + (this->Path.empty() ? "the document" : this->Path) + " " + what);
  }

private:
  DocumentPlace At(const std::string& path) const
  {
    DocumentPlace place = *this;
    place.Path = path;
    return place;
  }

  std::string Source;
  std::string Path;
  bool Forgiving = false;
  const char* Separator = "."; // between the path and the key of a member
};

} // namespace pemesh

#endif
