// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Messages between processes over MPI, by VTK's controller. A library of its own that `pemesh`
 * loads where mpiexec has started it: nothing else of PEMesh needs MPI.
 */
#ifndef pemesh_MPIChannel_h
#define pemesh_MPIChannel_h

#include "RankChannel.h"

#include <map>

#include <vtkNew.h> // For the controller

class vtkMPIController;

namespace pemesh
{

class MPIChannel : public RankChannel
{
public:
  /** Starts MPI, and hides from programs started later that this one runs under it. */
  MPIChannel();

  /** Ends MPI when the first process does; the others wait for that asleep. */
  ~MPIChannel() override;

  int GetRank() const override;
  int GetSize() const override;
  void Send(int rank, const std::string& text) override;
  std::optional<RankMessage> Receive() override;

private:
  vtkNew<vtkMPIController> Controller;
  std::map<int, std::string> Parts; // of messages that have not come to their end
};

} // namespace pemesh

/** Of the caller; null never. */
extern "C" pemesh::RankChannel* PEMeshOpenRankChannel();

#endif
