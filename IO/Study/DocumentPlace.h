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

  DocumentPlace Member(const std::string& key) const
  {
    return this->At(this->Path.empty() ? key : this->Path + "." + key);
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
};

} // namespace pemesh

#endif
