// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Where workers take the cases of a study and bring what becomes of them. The process that has the
 * journal has the board itself (StudyExecution.h); in other processes one stands for it that passes
 * everything on (RankBoard.h). Workers see no difference.
 */
#ifndef pemesh_CaseBoard_h
#define pemesh_CaseBoard_h

#include <optional>
#include <string>

#include <vtkSmartPointer.h> // For the row and the mesh

class vtkPolyData;
class vtkTable;

namespace pemesh
{

/** A case that is done. */
struct CaseAnswer
{
  int Index = 0;
  /** Of what it is done: StudyCaseKey.h. */
  std::string Key;
  vtkSmartPointer<vtkTable> Row;
  vtkSmartPointer<vtkPolyData> Mesh;
  /** Why the files of the mesh could not be written; empty: they are there. */
  std::string NotWritten;
};

/** All functions may be called from any thread. */
class CaseBoard
{
public:
  virtual ~CaseBoard() = default;

  /** The index of a case that nobody has; none where no case is left or the run has been stopped.
   */
  virtual std::optional<int> Take() = 0;

  /** Takes the case as an earlier run has left it; false where it must be done. */
  virtual bool Reuse(int index, const std::string& key) = 0;

  virtual void Bring(const CaseAnswer& answer) = 0;

  /** Ends the run: what the sentence says is wrong for every case. */
  virtual void Refuse(const std::string& sentence) = 0;

  /** A worker takes no more cases. */
  virtual void Leave() = 0;
};

} // namespace pemesh

#endif
