// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The rows of a study on disk, appended as the cases are done: the memory that they take does not
 * grow with their number, and a study that was killed goes on from them.
 *
 * A record is one line of fields separated by tabs (tabs, line ends and backslashes in a field are
 * escaped), whose last field is a sum over the others: a line cut off by a kill, a full disk or a
 * power cut is told from a whole one, and everything from there on is dropped.
 *
 *   columns NUMBER KIND:NAME…      the columns of the rows that name it; kinds in RowText.cxx
 *   row KEY NUMBER VALUE…          a case that is done; KEY says of what (StudyCaseKey.h), "" = of
 *                                  nothing that a later run may rely on
 */
#ifndef pemesh_StudyJournal_h
#define pemesh_StudyJournal_h

#include "FileDescriptor.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include <vtkSmartPointer.h> // For the rows

class vtkTable;

namespace pemesh
{

class StudyJournal
{
public:
  /**
   * Opens the journal, for this process alone, and keeps its old rows only if asked. Throws
   * std::runtime_error with a sentence; every function does.
   */
  StudyJournal(const std::filesystem::path& path, bool keepsRows, std::size_t cases);
  ~StudyJournal();
  StudyJournal(const StudyJournal&) = delete;
  StudyJournal& operator=(const StudyJournal&) = delete;

  ///@{
  /** May be called from any thread. */
  /** The first row of the table, which is that of a case. */
  void Append(int index, const std::string& key, vtkTable* row);
  /** Makes an old row that of a case; false if there is none with the key. */
  bool Adopt(int index, const std::string& key);
  bool Has(int index) const;
  /** The row of a case that has one. */
  vtkSmartPointer<vtkTable> Read(int index) const;
  ///@}

  /**
   * Throws where the journal is not under its name any more: the folder was removed, or its disk
   * has vanished and what is written now would go to another one.
   */
  void CheckPlace() const;

  /** Brings all rows to the disk: a power cut takes only those that came after. */
  void Flush();

private:
  /** Where a line is. */
  struct Place
  {
    std::uint64_t Offset = 0;
    std::uint64_t Length = 0;
  };

  void Load();
  void TakeLine(const std::vector<std::string>& fields, const Place& place);
  Place WriteLine(std::string line);
  std::string ReadLine(const Place& place) const;
  std::string ColumnsOf(vtkTable* row);

  std::filesystem::path Path;
  FileDescriptor File;
  std::uint64_t End = 0;
  std::vector<Place> Rows;                                 // of the cases; of length 0 if not done
  std::unordered_map<std::string, Place> Old;              // rows of an earlier run by their keys
  std::map<std::string, std::string> ColumnNumbers;        // by the columns
  std::map<std::string, std::vector<std::string>> Columns; // by their number
  mutable std::mutex Mutex;
};

} // namespace pemesh

#endif
